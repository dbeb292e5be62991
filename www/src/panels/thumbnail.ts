import { css, html, LitElement, type PropertyValues } from "lit";
import type { App } from "../app/app";
import type { Plan } from "parkade";
import { presetLayers } from "../store/layer-sets";
import { emptyResult, initialState, type Camera, type Scene } from "../store";
import { SceneCanvas } from "../view/scene-canvas";
import { fit, fitMap } from "../view/camera";

/** A small picture of a scene, with a planner's answer where there is one. */
export class Thumbnail extends LitElement {
  static override properties = {
    app: { attribute: false },
    scene: { attribute: false },
    plan: { attribute: false },
    whole: { type: Boolean },
    camera: { attribute: false },
  };
  static override styles = css`
    :host { display: block; position: relative; overflow: hidden; background: var(--parkade-out); }
    canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
  `;
  declare app: App;
  declare scene: Scene;
  declare plan: Plan | null | undefined;
  declare whole: boolean;
  /** The visible area; undefined fits start, goal and paths. */
  declare camera: Camera | undefined;
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
    const { plan } = this,
      shown = plan ? [plan.planner] : [],
      swept = plan?.check.drivable ? [plan] : [];
    const camera =
      this.camera ?? (this.whole ? fitMap(scene, width, height) : fit(scene, geometry, width, height, swept));
    const results = plan
      ? {
          [plan.planner]: {
            ...emptyResult,
            plan,
            lastGood: plan.outcome === "found" ? plan : null,
            status: "done" as const,
          },
        }
      : {};
    const layers = { ...presetLayers("clean"), sweep: true, grid: false, car: !this.whole };
    this.drawer.draw(
      {
        ...base,
        lang: this.app.store.state.lang,
        scene,
        geometry,
        camera,
        planners: shown,
        results,
        layers,
        focus: plan?.planner ?? base.focus,
        tool: "hand",
      },
      shown,
      this.app.tokens(),
      null,
    );
  }
}

customElements.define("parkade-thumbnail", Thumbnail);
