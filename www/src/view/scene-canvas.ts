/** Draws the scene and the planners' answers on one canvas. */
import type { Plan, PlannerId } from "parkade";
import type { State } from "../store";
import { played } from "../store/results";
import type { Draft } from "../store/draft";
import { cameraFor, type View } from "./camera";
import { waiting } from "./piece";
import { makeFrame, type Shown } from "./frame";
import { SceneLayers } from "./scene-layers";
import { context2d } from "./surface";
import type { Tokens } from "./tokens";

/** An answer older than this while its planner works is drawn as a ghost. */
const STALE_AFTER = 100;

interface Drawing {
  state: State;
  planners: PlannerId[];
  tokens: Tokens;
  draft: Draft | null;
}

export class SceneCanvas {
  private readonly ctx: CanvasRenderingContext2D;
  private readonly layers = new SceneLayers();
  private readonly observer: ResizeObserver;
  private last: Drawing | null = null;
  /**
   * The observer's first word, which comes before the first frame is shown, gives the size: asking for it lays the page
   * out twice.
   */
  private width = 0;
  private height = 0;
  /** Since when each planner has shown the same answer while at work. */
  private readonly since = new Map<PlannerId, { plan: Plan | null; at: number }>();
  private staleTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.ctx = context2d(canvas);
    this.observer = new ResizeObserver(() => this.resized());
    this.observer.observe(canvas);
    waiting.add(this.redraw);
  }

  /** The camera and size last drawn with. */
  get view(): View | null {
    return this.last && this.width > 0 ? this.viewOf(this.last.state) : null;
  }

  draw(state: State, planners: PlannerId[], tokens: Tokens, overlayDraft: Draft | null): void {
    this.last = { state, planners, tokens, draft: overlayDraft };
    if (this.width === 0 || this.height === 0) return;
    const ratio = globalThis.devicePixelRatio || 1;
    this.fitBacking(ratio);
    const shown = planners.map((planner) => this.shownOf(state, planner));
    this.layers.draw(
      makeFrame({ ctx: this.ctx, view: this.viewOf(state), ratio, state, tokens, shown, draft: overlayDraft }),
    );
  }

  snapshot(ratio: number): HTMLCanvasElement | null {
    const { last } = this,
      canvas = document.createElement("canvas"),
      ctx = canvas.getContext("2d");
    if (!last || !ctx) return null;
    canvas.width = Math.round(this.width * ratio);
    canvas.height = Math.round(this.height * ratio);
    const shown = last.planners.map((planner) => this.shownOf(last.state, planner));
    new SceneLayers().draw(
      makeFrame({
        ctx,
        view: this.viewOf(last.state),
        ratio,
        state: last.state,
        tokens: last.tokens,
        shown,
        draft: null,
      }),
    );
    return canvas;
  }

  dispose(): void {
    this.observer.disconnect();
    waiting.delete(this.redraw);
    clearTimeout(this.staleTimer);
    this.last = null;
  }

  private viewOf(state: State): View {
    return { camera: cameraFor(state, this.width, this.height), width: this.width, height: this.height };
  }

  private readonly redraw = (): void => {
    if (this.last) this.draw(this.last.state, this.last.planners, this.last.tokens, this.last.draft);
  };

  private resized(): void {
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    this.redraw();
  }

  private fitBacking(ratio: number): void {
    const width = Math.round(this.width * ratio),
      height = Math.round(this.height * ratio);
    if (this.canvas.width === width && this.canvas.height === height) return;
    this.canvas.width = width;
    this.canvas.height = height;
  }

  private shownOf(state: State, planner: PlannerId): Shown {
    const result = state.results[planner] ?? null;
    const found = result?.plan?.outcome === "found";
    const plan = found ? played(result)!.plan : (result?.lastGood ?? null);
    return {
      planner,
      plan,
      result,
      ghost: plan !== null && (!found || this.isStale(planner, plan, result?.status === "planning")),
    };
  }

  /** Answers come many times a second during a drag; fading each would flicker. */
  private isStale(planner: PlannerId, plan: Plan | null, working: boolean): boolean {
    const now = performance.now();
    const known = this.since.get(planner);
    if (!working || !known || known.plan !== plan) {
      this.since.set(planner, { plan, at: now });
      if (!working) return false;
    }
    const age = now - (this.since.get(planner)?.at ?? now);
    if (age >= STALE_AFTER) return true;
    clearTimeout(this.staleTimer);
    this.staleTimer = setTimeout(() => this.redraw(), STALE_AFTER - age + 1);
    return false;
  }
}
