import type { Timing } from "../../www/src/store/results";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Plan, PlannerId } from "parkade";
import type { WorkerLike } from "../../www/src/planning/pool";
import type { Engine } from "../../www/src/planning/engine-loader";
import { Planning } from "../../www/src/planning/planning";
import { WorkerPool } from "../../www/src/planning/pool";
import type { Reply, Request } from "../../www/src/planning/protocol";
import { createStore, type Scene } from "../../www/src/store";

const COLD: Timing = { search: 40, total: 45 };
const WARM: Timing = { search: 0.4, total: 1.5 };

/** Answers at once, as slowly as a worker that compiles does for its first three plans. */
class ColdWorker implements WorkerLike {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  onerror = null;
  static plan = 0;
  private plans = 0;

  constructor(private readonly log: string[]) {}

  terminate(): void {}

  postMessage(request: Request): void {
    if (request.kind === "start") this.plans = 0;
    else queueMicrotask(() => this.onmessage?.({ data: this.reply(request) } as MessageEvent<Reply>));
  }

  private reply(request: Exclude<Request, { kind: "start" }>): Reply {
    const { id, kind } = request;
    this.log.push(kind);
    if (kind === "explain") return { kind: "explained", id, explanation: null };
    if (kind === "time") {
      this.plans += request.runs;
      return { kind: "timed", id, samples: Array.from({ length: request.runs }, () => WARM) };
    }
    const warm = this.plans++ >= 3;
    const plan = { outcome: "found", hash: String(ColdWorker.plan++) } as Plan;
    return { kind: "planned", id, plan, layers: {}, drive: null, undriven: false, time: warm ? WARM : COLD, warm };
  }
}

function setup(planners: PlannerId[], workers = 8) {
  const log: string[] = [],
    shown: (Timing | null)[] = [];
  const store = createStore({ planners });
  const pool = new WorkerPool(() => new ColdWorker(log), workers);
  const api = {
    packRuns: () => "",
    sceneGeometry: () => null,
    failureOf: (error: unknown) => {
      throw error;
    },
  };
  const engine = { extent: "complete", api, module: {}, pool, script: "" } as unknown as Engine;
  store.subscribe(({ results }) =>
    shown.push(...Object.values(results).flatMap(({ plan, time }) => (plan ? [time] : []))),
  );
  const planning = new Planning(store, engine, () => Promise.resolve(engine));
  planning.start();
  return { store, planning, log, shown };
}

const moved = (scene: Scene, x: number): Scene => ({ ...scene, start: { ...scene.start, x } });

describe("times of plans", () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it("are shown when the code is warm, never of a first plan, and before the planners count as settled", async () => {
    const { store, planning, log, shown } = setup(["four", "hybrid"]);
    await planning.whenSettled();
    expect(log).toEqual(["plan", "plan", "time", "time"]);
    expect(Object.values(store.state.results).map(({ time, samples }) => [time, samples.length])).toEqual([
      [WARM, 3],
      [WARM, 3],
    ]);
    expect(shown).toContain(null);
    expect(shown).not.toContain(COLD);
  });

  it("are there for more planners than workers", async () => {
    const planners: PlannerId[] = ["four", "eight", "sixteen", "hybrid"];
    const { store, planning } = setup(planners, 2);
    await planning.whenSettled();
    expect(planners.map((planner) => store.state.results[planner]?.time)).toEqual(planners.map(() => WARM));
  });

  it("stay on screen while a warm planner answers for an edit, and begin anew with another scene", async () => {
    const { store, planning, shown } = setup(["four"]);
    await planning.whenSettled();
    shown.length = 0;
    for (let x = 1; x < 5; x++) {
      store.edit(moved(store.state.scene, x), { transient: x < 4 });
      await planning.whenSettled();
    }
    expect(shown.length).toBeGreaterThan(4);
    for (const time of shown) expect(time).toEqual(WARM);
    shown.length = 0;
    store.edit(moved(store.state.scene, 9), { label: "open" });
    await planning.whenSettled();
    expect(shown).toContain(null);
    expect(store.state.results.four!.time).toEqual(WARM);
  });

  it("wait for the end of a drag that begins before there is one", async () => {
    const { store, planning, shown } = setup(["four"]);
    for (let x = 1; x < 9; x++) {
      store.edit(moved(store.state.scene, x), { transient: true });
      await planning.whenSettled();
    }
    expect(new Set(shown)).toEqual(new Set([null]));
    store.edit(moved(store.state.scene, 9));
    await planning.whenSettled();
    expect(store.state.results.four!.time).toEqual(WARM);
  });

  it("are taken later where the page goes out of sight", async () => {
    const { store, planning } = setup(["four", "hybrid"]);
    store.subscribe(({ results }) => {
      if (results.four?.time && !results.hybrid?.time) planning.suspend();
    });
    await planning.whenSettled();
    expect(store.state.results.hybrid!.time).toBeNull();
    planning.resume();
    await planning.whenSettled();
    expect(store.state.results.hybrid!.time).toEqual(WARM);
  });
});
