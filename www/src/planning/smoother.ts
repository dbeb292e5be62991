/** Trajectories that a car can follow: made of the shown paths while a scene rests, and shown in their place. */
import type { Judgement, Plan, PlannerId } from "parkade";
import { forPlanners } from "../scene/large-scene";
import { hasRoad } from "../scene/speed-limits";
import { recall, remember } from "../store/preferences";
import type { Smoothed } from "../store/results";
import { isCheckingBays, type PanelResult, type State, type Store } from "../store";
import type { Engine } from "./engine-loader";
import { isPage } from "./improver";
import { CallError } from "./calls";
import { Helper } from "./job-client";
import type { Line } from "./trajectories";
import { messageOf } from "../i18n/said";
import { fieldsOf } from "../scene/records";

/** Longer paths stay as they are planned, metres: an optimisation grows with the length. */
const LONGEST = 150;
/** A worker without work is given back after so long. */
const IDLE_MS = 10_000;
const WATCHED = [
  "scene",
  "transient",
  "results",
  "planners",
  "hidden",
  "focus",
  "complete",
  "smooth",
  "canUndo",
  "hover",
  "playback",
  "bays",
] as const;

interface App {
  readonly store: Store;
  readonly planning: object | null;
  complete(): Promise<Engine>;
}

/** Has trajectories follow the shown paths; by the last visit's choice, where a link has not chosen. */
export function followSmooth(app: App): void {
  const { store } = app;
  if (store.state.smooth === null) store.set({ smooth: !isPage() || recall("smooth") !== "off" });
  new Smoother(app).start();
}

/** Turns trajectories on or off; the full page remembers it. */
export function chooseSmooth(store: Store, smooth: boolean): void {
  store.set({ smooth });
  if (isPage()) remember("smooth", smooth ? "on" : "off");
}

/** True if paths of this scene become trajectories: on roads cars drive by other rules. */
export const canSmooth = ({ scene }: Pick<State, "scene">): boolean => !hasRoad(scene);

/** True if a path is not worth the time of an optimisation. */
export const isTooLong = ({ metrics }: Plan): boolean => metrics.length > LONGEST;

class Smoother {
  private readonly known = new WeakMap<Plan, Smoothed>();
  private helper: Helper | null = null;
  private asked: PlannerId | null = null;
  /** True if a drag has ended what was asked. */
  private isDropped = false;
  private idle: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly app: App) {}

  private get state(): State {
    return this.app.store.state;
  }

  start(): void {
    this.app.store.derive((state, previous) => {
      // A drag has the processors to itself.
      if (state.transient && this.asked) {
        this.isDropped = true;
        this.stop();
      }
      if (WATCHED.some((key) => state[key] !== previous[key])) this.follow();
    });
    this.follow();
  }

  /** Shows what is known of the shown plans, and asks for the next. */
  private follow(): void {
    const { results, smooth } = this.state,
      next: Record<string, PanelResult> = {};
    for (const [planner, result] of Object.entries(results)) {
      const smoothed = (smooth && result.plan && this.known.get(result.plan)) || null;
      if (smoothed !== (result.smoothed ?? null)) next[planner] = { ...result, smoothed };
    }
    if (Object.keys(next).length > 0) this.app.store.gather({ results: { ...results, ...next } });
    const planner = this.asked ? undefined : this.next();
    if (planner) void this.ask(planner);
  }

  /** A planner whose drive can be better; the one in front first. */
  private next(): PlannerId | undefined {
    const { state } = this;
    if (
      !this.app.planning ||
      !state.complete ||
      !state.smooth ||
      state.transient ||
      document.hidden ||
      isCheckingBays(state) ||
      !canSmooth(state)
    )
      return undefined;
    // One of many playgrounds of a document that nobody has touched asks for no more.
    const isAlive = state.canUndo || state.hover !== null || state.playback.playing || isPage();
    return !isAlive
      ? undefined
      : [state.focus, ...state.planners].find((planner) => {
          const result = state.results[planner],
            plan = result?.plan;
          return (
            state.planners.includes(planner) &&
            !state.hidden.has(planner) &&
            result?.status === "done" &&
            result.drive &&
            plan?.outcome === "found" &&
            !isTooLong(plan) &&
            !this.known.has(plan)
          );
        });
  }

  private async ask(planner: PlannerId): Promise<void> {
    const { scene, results, waiting } = this.state,
      { plan, drive } = results[planner]!;
    this.asked = planner;
    this.isDropped = false;
    clearTimeout(this.idle);
    const plain = { of: plan!, plan: plan!, drive, trajectory: null };
    try {
      const engine = await this.app.complete();
      if (this.isDropped) throw new Error("A drag has begun.");
      const helper = (this.helper ??= new Helper(engine));
      const { path, directions, curvatures } = plan!,
        margin = marginOf(plan!);
      const input = { scene: forPlanners(scene, engine.api.packRuns), waiting, margin, path, directions, curvatures };
      const { trajectory, drive: driven, line } = await helper.call("smooth", input);
      this.known.set(plan!, {
        ...plain,
        plan: along(plan!, line, trajectory.check),
        drive: driven,
        trajectory,
        failure: null,
      });
    } catch (error) {
      // A drag says nothing of the plan.
      if (!this.isDropped)
        this.known.set(plan!, { ...plain, failure: { ...fieldsOf(error), message: messageOf(error) } });
      // A trap leaves the module's memory in an unknown state.
      if (error instanceof CallError && error.code === "internal") this.stop();
    }
    this.asked = null;
    this.idle = setTimeout(() => this.stop(), IDLE_MS);
    this.follow();
  }

  private stop(): void {
    this.helper?.stop();
    this.helper = null;
  }
}

/** The margin that the plan's own planner was asked for and kept: its drive keeps it, too. */
export const marginOf = ({ metrics }: Plan): number | undefined => ("margin" in metrics ? metrics.margin : undefined);

/** A plan with the trajectory's path in the place of its own, and with that path's figures by the referee. */
export function along(plan: Plan, line: Line, { length, gearChanges, minClearance, endError }: Judgement): Plan {
  const maxCurvature = line.curvatures.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return {
    ...plan,
    ...line,
    metrics: { ...plan.metrics, length, directionChanges: gearChanges, minClearance, maxCurvature },
    check: { ...plan.check, goalHeadingError: endError.heading },
  };
}
