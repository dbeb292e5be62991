import { css, html, LitElement, type PropertyValues } from "lit";
import type { App } from "../element/app";
import { initialState, type Scene } from "../store";
import { SceneCanvas } from "../view/scene-canvas";
import { fit, fitMap } from "../view/camera";

/** A small picture of a scene without any planner's answer. */
export class Thumbnail extends LitElement {
  static override properties = { app: { attribute: false }, scene: { attribute: false }, whole: { type: Boolean } };
  static override styles = css`
    :host { display: block; position: relative; overflow: hidden; background: var(--parkade-out); }
    canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
  `;
  declare app: App;
  declare scene: Scene;
  declare whole: boolean;
  private drawer: SceneCanvas | null = null;

  protected override render(): unknown {
    return html`<canvas aria-hidden="true"></canvas>`;
  }

  protected override updated(_changed: PropertyValues): void {
    requestAnimationFrame(() => this.draw());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.drawer?.dispose();
    this.drawer = null;
  }

  private draw(): void {
    const canvas = this.renderRoot.querySelector("canvas");
    if (!canvas || !this.isConnected || canvas.clientWidth === 0) return;
    this.drawer ??= new SceneCanvas(canvas);
    const base = initialState();
    const { scene } = this;
    const { clientWidth: width, clientHeight: height } = canvas;
    const geometry = this.app.catalog!.geometry(scene);
    // Cars are lost in the picture of a whole lot; in one of a wide map they are not the point.
    const camera = this.whole ? fitMap(scene, width, height) : fit(scene, geometry, width, height);
    this.drawer.draw({ ...base, scene, geometry, camera, planners: [], tool: "hand" }, [], this.app.tokens(), null);
  }
}

customElements.define("parkade-thumbnail", Thumbnail);
