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

/** Milliseconds after which a worker answers: the next frame is a later one. */
const ANSWER_MS = 20;

/** Answers with times as long as those of a worker that compiles for its first three plans. */
class ColdWorker implements WorkerLike {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  onerror = null;
  static plan = 0;
  private plans = 0;

  constructor(private readonly log: string[]) {}

  terminate(): void {}

  postMessage(request: Request): void {
    if (request.kind === "start") this.plans = 0;
    else setTimeout(() => this.onmessage?.({ data: this.reply(request) } as MessageEvent<Reply>), ANSWER_MS);
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

const started: Planning[] = [];

/** Leaves nothing to the frames of other tests. */
function end(): void {
  for (const planning of started.splice(0)) planning.stop();
  vi.runAllTimers();
  vi.useRealTimers();
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
  started.push(planning);
  return { store, planning, log, shown };
}

/** Has the time pass until every planner has answered and been timed, and no longer. */
async function settle(planning: Planning): Promise<void> {
  let isSettled = false;
  void planning.whenSettled().then(() => (isSettled = true));
  while (!isSettled) await vi.advanceTimersByTimeAsync(1);
}

const moved = (scene: Scene, x: number): Scene => ({ ...scene, start: { ...scene.start, x } });

describe("times of plans", () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    end();
  });

  it("are shown when the code is warm, never of a first plan, and before the planners count as settled", async () => {
    const { store, planning, log, shown } = setup(["four", "hybrid"]);
    await settle(planning);
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
    await settle(planning);
    expect(planners.map((planner) => store.state.results[planner]?.time)).toEqual(planners.map(() => WARM));
  });

  it("stay on screen while a warm planner answers for an edit, and begin anew with another scene", async () => {
    const { store, planning, shown } = setup(["four"]);
    await settle(planning);
    shown.length = 0;
    for (let x = 1; x < 5; x++) {
      store.edit(moved(store.state.scene, x), { transient: x < 4 });
      await settle(planning);
    }
    expect(shown.length).toBeGreaterThan(4);
    for (const time of shown) expect(time).toEqual(WARM);
    shown.length = 0;
    store.edit(moved(store.state.scene, 9), { label: "open" });
    await settle(planning);
    expect(shown).toContain(null);
    expect(store.state.results.four!.time).toEqual(WARM);
  });

  it("wait for the end of a drag that begins before there is one", async () => {
    const { store, planning, shown } = setup(["four"]);
    for (let x = 1; x < 9; x++) {
      store.edit(moved(store.state.scene, x), { transient: true });
      await settle(planning);
    }
    expect(new Set(shown)).toEqual(new Set([null]));
    store.edit(moved(store.state.scene, 9));
    await settle(planning);
    expect(store.state.results.four!.time).toEqual(WARM);
  });

  it("are taken later where the page goes out of sight", async () => {
    const { store, planning } = setup(["four", "hybrid"]);
    store.subscribe(({ results }) => {
      if (results.four?.time && !results.hybrid?.time) planning.suspend();
    });
    await settle(planning);
    expect(store.state.results.hybrid!.time).toBeNull();
    planning.resume();
    await settle(planning);
    expect(store.state.results.hybrid!.time).toEqual(WARM);
  });
});

describe("notifications of answers", () => {
  const PLANNERS: PlannerId[] = ["four", "eight", "risk-field", "hybrid"];
  /** Milliseconds of a frame. */
  const FRAME_MS = 16;

  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    end();
  });

  it("are one for all planners that answer within a frame, in every frame of a drag", async () => {
    const { store, planning } = setup(PLANNERS);
    await settle(planning);
    const frames: (() => void)[] = [];
    vi.stubGlobal("requestAnimationFrame", (run: () => void) => frames.push(run));
    let told = 0,
      answers = 0;
    store.subscribe(({ results }, previous) => {
      told++;
      answers += PLANNERS.filter((one) => results[one]?.plan !== previous.results[one]?.plan).length;
    });
    for (let x = 1; x <= 20; x++) {
      told = 0;
      store.edit(moved(store.state.scene, x), { transient: true });
      // The pointer's own; what is gathered is told with it.
      expect(told, `move ${x}`).toBe(1);
      await vi.advanceTimersByTimeAsync(FRAME_MS);
      expect(told, `move ${x}`).toBe(1);
      for (const run of frames.splice(0)) run();
      expect(told, `frame ${x}`).toBeLessThanOrEqual(2);
    }
    vi.unstubAllGlobals();
    store.edit(moved(store.state.scene, 21));
    await settle(planning);
    expect(answers).toBeGreaterThan(40);
    expect(PLANNERS.map((one) => store.state.results[one]!.status)).toEqual(PLANNERS.map(() => "done"));
  });

  it("have all come when the planners count as settled", async () => {
    const { store, planning } = setup(PLANNERS);
    let known: unknown = null;
    store.subscribe(({ results }) => (known = results));
    await settle(planning);
    expect(known).toBe(store.state.results);
  });
});
