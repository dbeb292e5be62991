import { sceneGeometry } from "parkade";
import { css, html, LitElement, type PropertyValues } from "lit";
import type { App } from "../element/app";
import { initialState, type Scene } from "../store";
import { SceneCanvas } from "../view/scene-canvas";
import { fitMap } from "../view/camera";

/** A small picture of a scene without any planner's answer. */
export class Thumbnail extends LitElement {
  static override properties = { app: { attribute: false }, scene: { attribute: false } };
  static override styles = css`
    :host { display: block; position: relative; overflow: hidden; background: var(--parkade-out); }
    canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
  `;
  declare app: App;
  declare scene: Scene;
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
    const camera = fitMap(this.scene, canvas.clientWidth, canvas.clientHeight);
    this.drawer.draw({ ...base, scene: this.scene, geometry: sceneGeometry(this.scene), camera, planners: [] }, [], this.app.tokens(), null);
  }
}

customElements.define("parkade-thumbnail", Thumbnail);
