import type { Timing } from "../store/results";
import type { Explanation, LayerName, PlannerId } from "parkade";
import { isGoalPose } from "../scene/model";
import type { Scenario } from "parkade";
import type { Holder, PlanWorkers, WorkerLike } from "./pool";
import type { Ends, Failure, Layers, PlanRequest, Reply } from "./protocol";

/** A plan of a whole scene; `budget`: milliseconds after which it is given up. */
export interface Job extends Omit<PlanRequest, "kind" | "scene" | "ends"> {
  scene: Scenario;
  budget?: number | null;
}

export interface LaneEvents {
  progressed(id: number, expansions: number): void;
  planned(reply: Extract<Reply, { kind: "planned" }>, newerWaits: boolean): void;
  failed(error: Failure, newerWaits: boolean): void;
  restarted(): void;
}

/** A newer scene waits this long, then the running plan is given up. */
export const GIVE_UP_AFTER_MS = 1000;
/** … or as many times longer than the plan before: a new worker reads a huge map all over again. */
const GIVE_UP_AFTER_TIMES = 3;

/** One planner of one playground: at most one plan running and one waiting, the newest wins. */
export class Lane implements Holder {
  private worker: WorkerLike | null = null;
  /** What the worker has a planner for, and what it has brought of it that does not depend on start and goal. */
  private held: Scenario | null = null;
  /** The last plan request. */
  private last: Scenario | null = null;
  private fixed: Layers = {};
  private running: Job | null = null;
  private waiting: Job | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private limit: ReturnType<typeof setTimeout> | undefined;
  /** When the running plan was sent, and how long the one before took, milliseconds. */
  private since = 0;
  private took = 0;
  private timing: { id: number; done: (samples: Timing[]) => void } | null = null;
  /** Of what is asked besides plans; below zero, as plans count from one. */
  private questionId = 0;
  /** The plan whose worker died last. */
  private tried: number | null = null;
  private asking: { id: number; done: (explanation: Explanation | null) => void } | null = null;

  constructor(
    private readonly planner: PlannerId,
    readonly of: object,
    readonly module: WebAssembly.Module,
    private readonly pool: PlanWorkers,
    private readonly events: LaneEvents,
  ) {}

  get busy(): boolean {
    return this.running !== null;
  }

  plan(job: Job): void {
    if (!this.running) return this.send(job);
    this.waiting = job;
    this.timer ??= setTimeout(() => this.giveUp(), Math.max(GIVE_UP_AFTER_MS, GIVE_UP_AFTER_TIMES * this.took));
  }

  /** Times of silent plans of the last scene; fewer than `runs` when the budget, milliseconds, is spent. */
  time(runs: number, budget: number): Promise<Timing[]> {
    const { last } = this;
    if (this.running || !last) return Promise.resolve([]);
    this.endTiming([]);
    return new Promise((done) => {
      this.timing = { id: --this.questionId, done };
      const ask = { kind: "time", id: this.questionId, runs, budget } as const;
      this.withWorker((worker) => worker.postMessage({ ...ask, ...this.scenePart(last) }));
    });
  }

  /** What the risk field of the last scene does at a point; null where a newer question overtakes this one. */
  explain(x: number, y: number): Promise<Explanation | null> {
    this.asking?.done(null);
    this.asking = null;
    const { worker } = this;
    if (this.running || !worker) return Promise.resolve(null);
    return new Promise((done) => {
      this.asking = { id: --this.questionId, done };
      worker.postMessage({ kind: "explain", id: this.questionId, x, y });
    });
  }

  /** Ends what runs; the worker itself lives on where nothing runs. */
  stop(): void {
    clearTimeout(this.timer);
    clearTimeout(this.limit);
    this.timer = undefined;
    const wasBusy = this.running !== null;
    this.running = this.waiting = null;
    this.revoked();
    if (wasBusy) this.pool.drop(this);
    else this.pool.release(this);
  }

  revoked(): void {
    if (this.worker) this.worker.onmessage = this.worker.onerror = null;
    this.worker = this.held = null;
    this.endTiming([]);
    this.asking?.done(null);
    this.asking = null;
  }

  private endTiming(samples: Timing[]): void {
    this.timing?.done(samples);
    this.timing = null;
  }

  private send(job: Job): void {
    this.running = job;
    if (!this.worker) this.endTiming([]);
    this.withWorker(() => this.post());
  }

  private withWorker(use: (worker: WorkerLike) => void): void {
    if (this.worker) use(this.worker);
    else
      this.pool.lease(this, (worker) => {
        this.begin(worker);
        use(worker);
      });
  }

  private post(): void {
    const job = this.running;
    if (!job || !this.worker) return;
    const { scene, layers, budget, ...rest } = job;
    this.last = scene;
    const part = this.scenePart(scene);
    if (part.scene) this.fixed = {};
    this.worker.postMessage({ kind: "plan", ...rest, ...part, layers: layers.filter((name) => !this.fixed[name]) });
    this.since = performance.now();
    clearTimeout(this.limit);
    if (budget) this.limit = setTimeout(() => this.interrupt(budget), budget);
  }

  private begin(worker: WorkerLike): void {
    this.worker = worker;
    worker.onmessage = ({ data }) => this.receive(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.died(event.message || "the worker stopped");
    };
    worker.postMessage({ kind: "start", module: this.module, planner: this.planner });
  }

  /** The part of a scene that the worker does not have yet. */
  private scenePart(scene: Scenario): { scene: Scenario | null; ends: Ends } {
    const isKnown = this.held !== null && differInEnds(this.held, scene);
    this.held = scene;
    return { scene: isKnown ? null : scene, ends: endsOf(scene) };
  }

  private receive(reply: Reply): void {
    if (reply.kind === "timed" || reply.id === this.timing?.id) return this.timed(reply);
    if (reply.kind === "explained") {
      if (this.asking?.id === reply.id) this.asking.done(reply.explanation);
      return;
    }
    if (reply.id !== this.running?.id) return;
    if (reply.kind === "progress") return this.events.progressed(reply.id, reply.expansions);
    if (reply.kind === "failed" && reply.error.code === "internal") return this.died(reply.error.message);
    this.took = performance.now() - this.since;
    const next = this.finish();
    if (reply.kind === "planned") this.events.planned(this.withFixed(reply), next !== null);
    else {
      // Settings that are refused leave no planner behind.
      this.held = null;
      this.events.failed(reply.error, next !== null);
    }
    if (next) this.send(next);
    else if (!this.running) this.pool.rested(this);
  }

  private timed(reply: Reply): void {
    if (reply.id !== this.timing?.id) return;
    if (reply.kind === "failed" && reply.error.code === "internal") return this.died(reply.error.message);
    this.endTiming(reply.kind === "timed" ? reply.samples : []);
    if (!this.running) this.pool.rested(this);
  }

  private withFixed(reply: Extract<Reply, { kind: "planned" }>): Extract<Reply, { kind: "planned" }> {
    for (const name of FIXED) {
      const layer = reply.layers[name];
      if (layer) this.fixed[name] = layer;
    }
    return { ...reply, layers: { ...this.fixed, ...reply.layers } };
  }

  /**
   * A trap leaves the module's memory in an unknown state: the worker is thrown away with it. Its plan is tried once
   * more, as what filled the memory may have come before it.
   */
  private died(message: string): void {
    const lost = this.running,
      next = this.renew();
    const again = next ?? (lost?.id === this.tried ? null : lost);
    this.tried = lost?.id ?? null;
    this.events.restarted();
    if (again) this.send(again);
    else if (lost) this.events.failed({ code: "internal", path: "", message }, false);
  }

  private giveUp(): void {
    const next = this.renew();
    if (next) this.send(next);
  }

  private interrupt(budget: number): void {
    const next = this.renew();
    this.events.failed({ code: "interrupted", path: "", message: String(budget) }, next !== null);
    if (next) this.send(next);
  }

  /** Throws the worker away; returns the plan that waited. */
  private renew(): Job | null {
    const next = this.finish();
    this.revoked();
    this.pool.drop(this);
    return next;
  }

  private finish(): Job | null {
    clearTimeout(this.timer);
    clearTimeout(this.limit);
    this.timer = undefined;
    const next = this.waiting;
    this.running = this.waiting = null;
    return next;
  }
}

/** Layers that a planner's map has wherever start and goal are. */
const FIXED: readonly LayerName[] = ["safety", "clearance"];

const endsOf = ({ start, goal }: Scenario): Ends => (isGoalPose(goal) ? { start, goal } : { start });

/**
 * True if nothing else differs, so that a planner of one scene can answer for the other; a slot as goal is emptied for
 * it, a set of goals resolved.
 */
function differInEnds(a: Scenario, b: Scenario): boolean {
  const isSame = (key: keyof Scenario): boolean =>
    a[key] === b[key] || key === "start" || (key === "goal" && isGoalPose(a.goal) && isGoalPose(b.goal));
  return (Object.keys({ ...a, ...b }) as (keyof Scenario)[]).every(isSame);
}
