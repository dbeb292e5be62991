import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Plan } from "parkade";
import { Lane, GIVE_UP_AFTER_MS } from "../../www/src/planning/planner-queue";
import type { WorkerLike } from "../../www/src/planning/pool";
import { WorkerPool } from "../../www/src/planning/pool";
import type { Reply, Request } from "../../www/src/planning/protocol";
import type { Scenario } from "../../www/src/scene/scenario";

class FakeWorker implements WorkerLike {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly asked: Request[] = [];
  terminated = false;

  postMessage(request: Request): void {
    this.asked.push(request);
  }

  terminate(): void {
    this.terminated = true;
  }

  answer(id: number): void {
    this.onmessage?.({
      data: {
        kind: "planned",
        id,
        plan: {} as Plan,
        layers: {},
        drive: null,
        undriven: false,
        time: { search: 1, total: 2 },
        warm: false,
      },
    } as MessageEvent<Reply>);
  }

  tell(id: number, expansions: number): void {
    this.onmessage?.({ data: { kind: "progress", id, expansions } } as MessageEvent<Reply>);
  }

  /** Answers the last question for times. */
  times(): void {
    this.onmessage?.({
      data: {
        kind: "timed",
        id: this.asked.at(-1)!.kind === "time" ? this.lastId : 0,
        samples: [{ search: 1, total: 2 }],
      },
    } as MessageEvent<Reply>);
  }

  failTiming(): void {
    this.onmessage?.({
      data: { kind: "failed", id: this.lastId, error: { code: "internal", path: "", message: "boom" } },
    } as MessageEvent<Reply>);
  }

  private get lastId(): number {
    const last = this.asked.at(-1)!;
    return "id" in last ? last.id : 0;
  }

  get plans(): number[] {
    return this.asked.flatMap((request) => (request.kind === "plan" ? [request.id] : []));
  }
}

const pose = { x: 0, y: 0, heading: 0 };
const scene = { start: pose, goal: pose } as Scenario;

function setup() {
  const workers: FakeWorker[] = [];
  const heard: string[] = [];
  const pool = new WorkerPool(() => {
    const worker = new FakeWorker();
    workers.push(worker);
    return worker;
  }, 2);
  const lane = new Lane("four", {}, {} as WebAssembly.Module, pool, {
    progressed: (id, expansions) => heard.push(`${id} at ${expansions}`),
    planned: (reply, waits) => heard.push(`planned ${reply.id}${waits ? ", newer waits" : ""}`),
    failed: (error) => heard.push(`failed ${error.code}`),
    restarted: () => heard.push("restarted"),
  });
  const plan = (id: number) => lane.plan({ id, scene, layers: [], every: 1, trace: true, waiting: null });
  return { workers, heard, lane, plan };
}

describe("a planner's lane", () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it("runs one plan at a time and then only the newest that waits", () => {
    const { workers, heard, plan } = setup();
    for (const id of [1, 2, 3, 4]) plan(id);
    expect(workers[0]!.plans).toEqual([1]);
    workers[0]!.answer(1);
    expect(workers[0]!.plans).toEqual([1, 4]);
    workers[0]!.answer(4);
    expect(heard).toEqual(["planned 1, newer waits", "planned 4"]);
  });

  it("gives up a long plan when a newer scene has waited", () => {
    const { workers, heard, plan } = setup();
    plan(1);
    plan(2);
    vi.advanceTimersByTime(GIVE_UP_AFTER_MS + 1);
    expect(workers[0]!.terminated).toBe(true);
    expect(workers[1]!.plans).toEqual([2]);
    workers[0]!.answer(1);
    workers[1]!.answer(2);
    expect(heard).toEqual(["planned 2"]);
  });

  it("passes on how far the running plan is, and nothing of one that is over or given up", () => {
    const { workers, heard, plan } = setup();
    plan(1);
    workers[0]!.tell(1, 256);
    workers[0]!.answer(1);
    workers[0]!.tell(1, 512);
    plan(2);
    workers[0]!.tell(1, 768);
    workers[0]!.tell(2, 256);
    plan(3);
    vi.advanceTimersByTime(GIVE_UP_AFTER_MS + 1);
    workers[0]!.tell(2, 512);
    workers[1]!.tell(3, 256);
    expect(heard).toEqual(["1 at 256", "planned 1", "2 at 256", "3 at 256"]);
  });

  it("lets a long plan run while nothing newer waits", () => {
    const { workers, plan } = setup();
    plan(1);
    vi.advanceTimersByTime(60 * GIVE_UP_AFTER_MS);
    expect(workers[0]!.terminated).toBe(false);
  });

  it("starts a dead worker again, says so, and tries its plan once more", () => {
    const { workers, heard, plan } = setup();
    plan(1);
    workers[0]!.onerror?.({ message: "boom", preventDefault() {} } as ErrorEvent);
    expect(heard).toEqual(["restarted"]);
    expect(workers[1]!.plans).toEqual([1]);
    workers[1]!.answer(1);
    expect(heard).toEqual(["restarted", "planned 1"]);
  });

  it("sends all of the scene to a new worker and only its ends to one that has it", () => {
    const { workers, plan } = setup();
    const scenes = (worker: number): unknown[] =>
      workers[worker]!.asked.flatMap((request) => (request.kind === "plan" ? [request.scene] : []));
    plan(1);
    workers[0]!.answer(1);
    plan(2);
    expect(scenes(0)).toEqual([scene, null]);
    workers[0]!.onerror?.({ message: "boom", preventDefault() {} } as ErrorEvent);
    expect(scenes(1)).toEqual([scene]);
    workers[1]!.answer(2);
    plan(3);
    expect(scenes(1)).toEqual([scene, null]);
    plan(4);
    vi.advanceTimersByTime(GIVE_UP_AFTER_MS + 1);
    expect(scenes(2)).toEqual([scene]);
  });

  it("keeps the answer of a worker that dies at rest", () => {
    const { workers, heard, plan } = setup();
    plan(1);
    workers[0]!.answer(1);
    workers[0]!.onerror?.({ message: "boom", preventDefault() {} } as ErrorEvent);
    expect(heard).toEqual(["planned 1", "restarted"]);
    plan(2);
    expect(workers[1]!.plans).toEqual([2]);
  });

  it("gives a plan up that its second worker dies of, and takes the next", () => {
    const { workers, heard, plan } = setup();
    const die = (worker: number): void =>
      workers[worker]!.onerror?.({ message: "boom", preventDefault() {} } as ErrorEvent);
    plan(1);
    die(0);
    die(1);
    expect(heard).toEqual(["restarted", "restarted", "failed internal"]);
    expect(workers).toHaveLength(2);
    plan(2);
    die(2);
    expect(workers[3]!.plans).toEqual([2]);
  });

  it("times nothing while it plans", async () => {
    const { workers, lane, plan } = setup();
    expect(await lane.time(9, 10)).toEqual([]);
    plan(1);
    expect(await lane.time(9, 10)).toEqual([]);
    workers[0]!.answer(1);
    const samples = lane.time(2, 10);
    expect(workers[0]!.asked.at(-1)).toMatchObject({ kind: "time", scene: null });
    workers[0]!.times();
    expect(await samples).toEqual([{ search: 1, total: 2 }]);
  });

  it("times the last scene with another worker where its own was given away", async () => {
    const { workers, lane, plan } = setup();
    plan(1);
    workers[0]!.answer(1);
    lane.revoked();
    const samples = lane.time(2, 10);
    expect(workers[1]!.asked).toMatchObject([{ kind: "start" }, { kind: "time", scene }]);
    workers[1]!.times();
    expect(await samples).toHaveLength(1);
    plan(2);
    expect(workers[1]!.asked.at(-1)).toMatchObject({ kind: "plan", scene: null });
  });

  it("starts anew where timing kills the worker, and says that no time came", async () => {
    const { workers, heard, lane, plan } = setup();
    plan(1);
    workers[0]!.answer(1);
    const samples = lane.time(2, 10);
    workers[0]!.failTiming();
    expect(await samples).toEqual([]);
    expect(heard).toEqual(["planned 1", "restarted"]);
    plan(2);
    expect(workers[1]!.plans).toEqual([2]);
  });
});
