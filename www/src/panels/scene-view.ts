import type { PlannerId } from "parkade";
import { css, html, LitElement, type PropertyValues } from "lit";
import type { App } from "../app/app";
import type { PanelResult, State } from "../store";
import { inNextFrame } from "../store/animation-frame";
import type { View } from "../view/camera";
import type { PoseRequest } from "../view/pose-label";
import { SceneCanvas } from "../view/scene-canvas";
import { laterTexts } from "./lazy-texts";

/** Parts of the state that never show on a canvas. */
const UNSEEN: readonly (keyof State)[] = ["message", "live", "canUndo", "canRedo", "progress"];
/** State that a drag changes; the camera rests. */
const DRAGGED: readonly (keyof State)[] = ["scene", "geometry", "results", "hover", "draft", "explained", "reason"];
/** How long (ms) a map may stand still while another is dragged on. */
const FOLLOW_WITHIN = 50;

const isAnswer = (now: PanelResult | undefined, before: PanelResult | undefined): boolean =>
  now?.plan !== before?.plan || now?.error !== before?.error;

/** One canvas of the scene with one planner's answer, or several over another; every tool works on it. */
export class SceneView extends LitElement {
  static override properties = {
    app: { attribute: false },
    planners: { attribute: false, hasChanged: (now: unknown, before: unknown) => String(now) !== String(before) },
    label: { type: String },
  };
  static override styles = css`
    :host {
      display: block; position: relative; min-width: 0; min-height: 0; overflow: hidden; background: var(--parkade-out);
      contain: strict;
    }
    canvas {
      position: absolute; inset: 0; width: 100%; height: 100%; display: block; touch-action: none; outline: none;
      user-select: none; -webkit-user-select: none;
    }
    .scale {
      position: absolute; left: var(--scale-inset, 12px); inset-block: var(--scale-block, auto 9px);
      display: var(--parkade-scale, flex); align-items: end; gap: 6px; pointer-events: none;
      font: 12px/12px inherit; font-family: inherit; color: var(--parkade-t3);
    }
    .scale::before {
      content: ""; width: var(--length); height: 5px; border: solid var(--parkade-t1); border-width: 0 1px 1px;
      box-sizing: border-box;
    }
    .scale[hidden] { display: none; }
    .pose {
      position: absolute; width: 178px; height: 22px; padding: 0 7px; font: 500 12px/20px inherit; font-family: inherit;
      font-variant-numeric: tabular-nums; color: var(--parkade-t1); background: var(--parkade-panel);
      border: 1.5px solid var(--parkade-accent); border-radius: calc(5px * var(--parkade-radius)); outline: none;
    }
    .pose[aria-invalid="true"] { border-color: var(--parkade-err); }
    canvas:focus-visible { outline: 2px solid var(--parkade-accent); outline-offset: -2px; }
  `;
  declare app: App;
  declare planners: PlannerId[];
  declare label: string;
  private scene: SceneCanvas | null = null;
  private detach: (() => void)[] = [];
  private late: ReturnType<typeof setTimeout> | undefined;

  /** Camera and size last drawn with. */
  get view(): View | null {
    return this.scene?.view ?? null;
  }

  /** The picture drawn anew at `ratio` pixels for each of the page's. */
  snapshot(ratio: number): HTMLCanvasElement | null {
    return this.scene?.snapshot(ratio) ?? null;
  }

  /** The drawn canvas. */
  get canvas(): HTMLCanvasElement | null {
    return this.renderRoot.querySelector("canvas");
  }

  protected override render(): unknown {
    return html`<canvas part="canvas" tabindex="0" role="application" aria-label=${this.label}
      @parkade-pose=${this.enterPose}></canvas><span class="scale" hidden></span>`;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.hasUpdated) this.begin();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.end();
  }

  protected override firstUpdated(): void {
    this.begin();
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has("planners")) this.schedule();
  }

  private begin(): void {
    const canvas = this.canvas;
    if (!canvas || this.scene) return;
    this.scene = new SceneCanvas(canvas);
    const { store, controller } = this.app;
    this.detach = [controller.attach(canvas), store.subscribe((state, previous) => this.follow(state, previous))];
    this.schedule();
  }

  /**
   * A drag redraws the map under the pointer at once, the others together with their planners' answers: painting each
   * map twice a step would keep those answers waiting.
   */
  private follow(state: State, previous: State): void {
    const keys = Object.keys(state) as (keyof State)[];
    const isWalked = [state, previous].some(({ searchSteps }) =>
      this.planners.some((one) => one === searchSteps?.planner),
    );
    const changed = keys.filter(
      (key) => state[key] !== previous[key] && !UNSEEN.includes(key) && (isWalked || key !== "searchSteps"),
    );
    if (changed.length === 0) return;
    const isDrag =
      state.transient &&
      !state.layers.ghosts &&
      state.playback.base !== "search" &&
      changed.every((key) => DRAGGED.includes(key));
    const answered = this.planners.some((planner) => isAnswer(state.results[planner], previous.results[planner]));
    if (!isDrag || answered) this.schedule();
    else if (changed.length === 1 && changed[0] === "results") return;
    else this.trail();
  }

  private trail(): void {
    if (this.app.controller.isAt(this.canvas)) this.schedule();
    else this.late ??= setTimeout(this.schedule, FOLLOW_WITHIN);
  }

  private end(): void {
    clearTimeout(this.late);
    this.late = undefined;
    for (const stop of this.detach) stop();
    this.detach = [];
    this.scene?.dispose();
    this.scene = null;
  }

  private readonly enterPose = async ({ detail }: CustomEvent<PoseRequest>): Promise<void> => {
    const { openPoseEntry } = await import("./pose-entry");
    if (this.shadowRoot) openPoseEntry(this.app, this.shadowRoot, detail);
  };

  private readonly schedule = (): void => {
    inNextFrame(this.paint);
  };

  private readonly paint = (): void => {
    clearTimeout(this.late);
    this.late = undefined;
    const { state } = this.app.store;
    this.scene?.draw(state, this.planners, this.app.tokens(), state.draft);
    if (this.view) laterTexts()?.showScale(this.renderRoot, this.view, state.lang);
  };
}

customElements.define("parkade-scene-view", SceneView);
