import type { Timing } from "../store/results";
import type { PlannerId } from "parkade";
import { translate } from "../i18n/index";
import { drivesCar, hasField, plannerName } from "../styles/planner-style";
import { isOneGoal } from "../scene/model";
import { limitsOn } from "../scene/speed-limits";
import { forPlanners, isUnpacked, withoutCells } from "../scene/large-scene";
import { emptyResult, isCheckingBays, type PanelResult, type Scene, type State, type Store } from "../store";
import { Lane, type Job } from "./planner-queue";
import { extentFor, type Engine } from "./engine-loader";
import { failureText, forceEvery, isTraced, layersOf, offLattice, sameMap, withOld, withoutPath } from "./answers";
import { medians } from "./medians";
import type { Failure, Reply } from "./protocol";

const SAMPLES = 9;
/** Silent repeats behind the first time that is shown of a scene: compilers and caches slow what comes before. */
const WARM_UP = 3;
/** After so long the warm-up of a planner ends with the repeat that runs. */
const WARM_UP_MS = 400;
const SLICE_MS = 40;
/** A plan longer than this is not repeated again and again just to time it, one longer than the second not once. */
const TOO_LONG_MS = 400,
  FAR_TOO_LONG_MS = 3000;
const QUIET_MS = 350;
const HOLD_MS = 12;

/** Keeps `results` and `geometry` of the store in step with its scene. Answers of a frame are told together. */
export class Planning {
  private readonly lanes = new Map<PlannerId, Lane>();
  private unsubscribe: (() => void) | null = null;
  private job = 0;
  /** The store's count of opened scenes at the last plan, and the first job of the present scene. */
  private opened = 0;
  private firstJob = 0;
  /** The first job of the present map: answers to earlier ones tell of cells that are elsewhere now. */
  private mapJob = 0;
  /** Milliseconds after which a plan is given up; null: never. */
  budget: number | null = null;
  private readonly held = new Map<PlannerId, Job>();
  /** Shown, but not in the module that is loaded so far. */
  private readonly absent = new Set<PlannerId>();
  private release: ReturnType<typeof setTimeout> | undefined;
  /** The error of the present scene. */
  private refused: Failure | null = null;
  private quiet: ReturnType<typeof setTimeout> | undefined;
  /** The present measurement; another one, or none, ends it. */
  private measuring: object | null = null;
  private isWarmingUp = false;
  /** Those who wait for all answers and their times. */
  private readonly settling: (() => void)[] = [];

  constructor(
    private readonly store: Store,
    private engine: Engine,
    /** Loads the complete module and has it used here. */
    private readonly complete: () => Promise<Engine>,
  ) {}

  /** Planners run on this module from now on: at once, unseen where answers stay; when at work, with the next plan. */
  use(engine: Engine): void {
    if (engine === this.engine) return;
    this.engine = engine;
    const waited = this.absent.size > 0;
    if (waited || (!this.isBusy() && !this.store.state.transient)) this.replan(this.store.state.scene, !waited);
  }

  start(): void {
    this.unsubscribe ??= this.store.derive((state, previous) => {
      if (state.scene !== previous.scene || state.planners !== previous.planners || state.waiting !== previous.waiting)
        this.replan(previous.scene);
      else if (previous.transient && !state.transient)
        this.replan(state.scene); // A drag leaves its slower layers behind.
      else if (
        (["redundant", "cost", "risk", "tree"] as const).some((name) => state.layers[name] && !previous.layers[name])
      )
        this.replan(state.scene);
      if (state.hover !== previous.hover) void this.explain(state);
    });
    this.replan(null);
  }

  stop(): void {
    this.unsubscribe?.();
    this.unsubscribe = null;
    this.endMeasurement();
    clearTimeout(this.release);
    this.release = undefined;
    this.held.clear();
    for (const lane of this.lanes.values()) lane.stop();
    this.lanes.clear();
  }

  /** Plans the present scene again. */
  again(): void {
    this.replan(this.store.state.scene);
  }

  /** Gives up what runs; planners keep their last answers. */
  cancel(): void {
    clearTimeout(this.release);
    this.release = undefined;
    this.held.clear();
    this.absent.clear();
    for (const lane of this.lanes.values()) if (lane.busy) lane.stop();
    const { results } = this.store.state;
    this.store.set({
      results: Object.fromEntries(
        Object.entries(results).map(([planner, result]) => [
          planner,
          result.status === "planning" ? { ...result, status: "idle" as const } : result,
        ]),
      ),
    });
    this.afterResult();
  }

  /** Out of sight nothing is timed, and workers are there for others. */
  suspend(): void {
    this.endMeasurement();
    for (const lane of this.lanes.values()) if (!lane.busy) lane.stop();
  }

  /** In sight again: what has no time gets one. */
  resume(): void {
    this.afterResult();
  }

  /** Resolves when every planner has answered for the present scene, and been timed. */
  whenSettled(): Promise<void> {
    return new Promise((done) => (this.isBusy() || this.isWarmingUp ? this.settling.push(done) : done()));
  }

  /** Times planners again, one after another; their `results` then hold that many samples. */
  async measure(
    runs: number,
    planners: readonly PlannerId[] = this.store.state.planners,
    limit = Infinity,
  ): Promise<void> {
    this.endMeasurement();
    const measurement = (this.measuring = {});
    for (const planner of planners) {
      const samples: Timing[] = [],
        end = performance.now() + limit;
      while (
        samples.length < runs &&
        measurement === this.measuring &&
        (samples.length === 0 || performance.now() < end)
      ) {
        const more = await this.lanes.get(planner)?.time(runs - samples.length, SLICE_MS);
        if (!more || more.length === 0) break;
        samples.push(...more);
      }
      if (samples.length > 0 && measurement === this.measuring)
        this.update(planner, { samples, time: medians(samples) });
    }
  }

  private endMeasurement(): void {
    clearTimeout(this.quiet);
    this.measuring = null;
  }

  /** The cell under the pointer in the terms of the risk field's paper, wherever its arrows are shown. */
  private async explain({ hover, layers, planners, transient }: State): Promise<void> {
    const planner = planners.find(hasField),
      lane = planner && this.lanes.get(planner);
    const wanted =
      hover && layers.risk && !transient && lane && lane.module === this.engine.module && this.store.state.complete;
    const explained = wanted ? await lane.explain(hover.x, hover.y).catch(() => null) : null;
    if (explained !== this.store.state.explained && this.store.state.hover === hover) this.store.gather({ explained });
  }

  private isBusy(): boolean {
    return this.held.size + this.absent.size > 0 || [...this.lanes.values()].some((lane) => lane.busy);
  }

  private replan(previous: Scene | null, unseen = false): void {
    this.endMeasurement();
    const { state } = this.store;
    this.job++;
    this.absent.clear();
    const opens = this.opened !== state.opened;
    if (opens) [this.opened, this.firstJob] = [state.opened, this.job];
    const isOtherMap = previous !== null && !sameMap(previous, state.scene);
    if (isOtherMap) this.mapJob = this.job;
    const before = opens
      ? {}
      : isOtherMap
        ? Object.fromEntries(Object.entries(state.results).map(([id, result]) => [id, offLattice(result)]))
        : state.results;
    if (!this.resolve(state, before)) return;
    // A stroke over a huge map is planned when it ends.
    if (state.transient && isUnpacked(state.scene)) return;
    const results: Record<string, PanelResult> = {};
    for (const planner of state.planners) {
      const old = before[planner] ?? emptyResult;
      results[planner] = unseen && old.status === "done" ? old : { ...old, status: "planning", error: null };
    }
    this.store.set({ results, progress: {} });
    for (const [planner, lane] of this.lanes) {
      if (state.planners.includes(planner)) continue;
      lane.stop();
      this.lanes.delete(planner);
    }
    const scene = forPlanners(state.scene, this.engine.api.packRuns);
    const present = state.planners.filter(
      (planner) => this.engine.extent === "complete" || extentFor([planner]) === "core",
    );
    this.planWhenLoaded(state.planners.filter((planner) => !present.includes(planner)));
    for (const planner of present) {
      const waiting = state.transient ? null : state.waiting;
      const job = {
        id: this.job,
        scene,
        layers: layersOf(planner, state),
        every: forceEvery(state),
        trace: isTraced(planner, state),
        waiting,
        limits: limitsOn(scene),
        prefer: state.prefer[planner],
        shown: state.results[planner]?.chosen,
        budget: this.budget,
      };
      if (state.transient && drivesCar(planner)) this.hold(planner, job);
      else {
        this.held.delete(planner);
        this.laneOf(planner).plan(job);
      }
    }
  }

  private planWhenLoaded(absent: readonly PlannerId[]): void {
    for (const planner of absent) this.absent.add(planner);
    if (absent.length === 0) return;
    this.complete().catch((error: unknown) => {
      const failed = [...this.absent];
      this.absent.clear();
      const failure = this.engine.api.failureOf(error);
      this.store.set({
        message: { tone: "err", text: translate(this.store.state.lang, "error.load", { reason: failure.message }) },
      });
      for (const planner of failed) this.failed(planner, failure, false);
    });
  }

  /** During a drag the grid planners, who answer within the frame, have the processors to themselves for a moment. */
  private hold(planner: PlannerId, job: Job): void {
    this.held.set(planner, job);
    this.release ??= setTimeout(() => {
      this.release = undefined;
      const held = [...this.held];
      this.held.clear();
      for (const [id, newest] of held) if (this.store.state.planners.includes(id)) this.laneOf(id).plan(newest);
    }, HOLD_MS);
  }

  /** Checks the scene and fills `geometry`; says in words what is wrong with it. */
  private resolve(state: State, before: State["results"]): boolean {
    try {
      const geometry = this.engine.api.sceneGeometry(withoutCells(state.scene));
      const wasBad = this.refused !== null || Object.values(state.results).some((result) => result.status === "error");
      this.refused = null;
      this.store.set({ geometry, ...(wasBad ? { message: null } : {}) });
      return true;
    } catch (error) {
      const failure = this.engine.api.failureOf(error);
      this.refused = failure;
      const results = Object.fromEntries(
        state.planners.map((planner) => [
          planner,
          { ...(before[planner] ?? emptyResult), status: "error" as const, error: failure },
        ]),
      );
      const key = failure.path ? "error.sceneAt" : "error.scene";
      const text = translate(state.lang, key, { path: failure.path, reason: withoutPath(failure) });
      this.store.set({ results, message: { tone: "err", text, code: failure.code } });
      return false;
    }
  }

  /** The first module knows no sets of goals: what it has at hand is given up for one. */
  private laneOf(planner: PlannerId): Lane {
    let lane = this.lanes.get(planner);
    if (lane && lane.module !== this.engine.module && (!lane.busy || !isOneGoal(this.store.state.scene.goal))) {
      lane.stop();
      lane = undefined;
    }
    if (!lane) {
      lane = new Lane(planner, this, this.engine.module, this.engine.pool, {
        progressed: (id, expansions) => this.progressed(planner, id, expansions),
        planned: (reply, newerWaits) => this.planned(planner, reply, newerWaits),
        failed: (error, newerWaits) => this.failed(planner, error, newerWaits),
        restarted: () => this.sayRestarted(planner),
      });
      this.lanes.set(planner, lane);
    }
    return lane;
  }

  /** Only of plans of the present scene that are waited for. */
  private progressed(planner: PlannerId, id: number, expansions: number): void {
    const { progress, results } = this.store.state;
    if (id === this.job && results[planner]?.status === "planning")
      this.store.gather({ progress: { ...progress, [planner]: expansions } });
  }

  private planned(planner: PlannerId, reply: Extract<Reply, { kind: "planned" }>, newerWaits: boolean): void {
    // It belongs to a scene that is no longer open.
    if (reply.id < this.firstJob) return;
    const { plan, layers, drive, time } = reply;
    const old = this.store.state.results[planner] ?? emptyResult;
    const same = old.status === "done" && old.plan?.hash === plan.hash;
    const isTimed = time.total > FAR_TOO_LONG_MS || (reply.warm && old.time !== null);
    const result: PanelResult = {
      ...old,
      plan: same ? old.plan : plan,
      chosen: null,
      // The first module has no drives.
      drive: (same && old.drive) || drive,
      lastGood: plan.outcome === "found" ? plan : old.lastGood,
      layers: withOld(layers, old.layers, this.store.state.transient),
      // The answer may be to a scene before one that no planner can take.
      status: this.refused ? "error" : newerWaits ? "planning" : "done",
      error: this.refused,
      ...(same && old.time ? {} : { time: isTimed ? time : null, samples: isTimed ? [time] : [] }),
    };
    this.update(planner, reply.id < this.mapJob ? offLattice(result) : result);
    if (reply.undriven && !newerWaits) {
      const { lang } = this.store.state;
      this.store.gather({
        message: { tone: "warn", text: translate(lang, "error.drive", { planner: plannerName(lang, planner) }) },
      });
    }
    if (!newerWaits) this.afterResult();
  }

  private failed(planner: PlannerId, error: Failure, newerWaits: boolean): void {
    this.update(planner, { status: newerWaits ? "planning" : "error", error });
    if (newerWaits) return;
    if (error.code !== "internal") {
      const text = failureText(this.store.state.lang, planner, error);
      this.store.gather({ message: { tone: "err", text, code: error.code } });
    }
    this.afterResult();
  }

  private update(planner: PlannerId, patch: Partial<PanelResult>): void {
    const { results } = this.store.state;
    this.store.gather({ results: { ...results, [planner]: { ...(results[planner] ?? emptyResult), ...patch } } });
  }

  private sayRestarted(planner: PlannerId): void {
    const { lang } = this.store.state;
    const text = translate(lang, "panel.restarted", { planner: plannerName(lang, planner) });
    this.store.gather({ message: { tone: "warn", text } });
  }

  private afterResult(): void {
    if (this.isBusy()) return;
    void this.explain(this.store.state);
    void this.warmUp();
  }

  /** Times what has no time yet, before anything moves. */
  private async warmUp(): Promise<void> {
    const { results, planners, transient } = this.store.state;
    const untimed = transient
      ? []
      : planners.filter((planner) => results[planner]?.status === "done" && !results[planner].time);
    this.isWarmingUp = true;
    if (untimed.length > 0) await this.measure(WARM_UP, untimed, WARM_UP_MS);
    if (this.isBusy()) return;
    this.isWarmingUp = false;
    for (const done of this.settling.splice(0)) {
      this.store.tell();
      done();
    }
    this.whenQuiet();
  }

  /** Plans are timed again only when nobody waits for one. */
  private whenQuiet(): void {
    clearTimeout(this.quiet);
    const { results, planners, transient } = this.store.state;
    const heavy = planners.some((planner) => (results[planner]?.time?.total ?? 0) > TOO_LONG_MS);
    if (transient || heavy || this.isBusy()) return;
    this.quiet = setTimeout(() => {
      // Others would share the processor, and the times would show it.
      if (this.store.state.playback.playing || isCheckingBays(this.store.state)) this.whenQuiet();
      else void this.measure(SAMPLES);
    }, QUIET_MS);
  }
}
