/** Trajectories in the place of paths: when they are asked for, what is shown of them, and what becomes of a choice. */
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Drive, Plan, PlannerInfo } from "parkade";
import { decodeView, encodeView } from "../../www/src/app/view-link";
import { follow } from "../../www/src/planning/improver";
import { chooseSmooth, followSmooth } from "../../www/src/planning/smoother";
import { played } from "../../www/src/store/results";
import { inNextFrame } from "../../www/src/store/animation-frame";
import { createStore, emptyResult, type PanelResult, type Scene, type Store } from "../../www/src/store";
import { introduce } from "../../www/src/styles/planner-style";
import { keepPlace } from "../../www/src/view/keep-place";
import { drivenAt } from "../../www/src/view/playback-time";

class FakeWorker {
  static all: FakeWorker[] = [];
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onerror = null;
  asked: { id: number; name: string; input: { path: Float64Array } }[] = [];
  isTerminated = false;

  constructor() {
    FakeWorker.all.push(this);
  }
  postMessage(request: FakeWorker["asked"][number]): void {
    this.asked.push(request);
  }
  terminate(): void {
    this.isTerminated = true;
  }
  answer(reply: object): Promise<void> {
    this.onmessage!({ data: { kind: "call", id: this.asked.at(-1)!.id, ...reply } });
    return settle();
  }
}

const settle = (): Promise<void> => new Promise((done) => setTimeout(done));
const kept = new Map<string, string>();
let isPage = true;

beforeEach(() => {
  FakeWorker.all = [];
  kept.clear();
  isPage = true;
  vi.stubGlobal("Worker", FakeWorker);
  vi.stubGlobal("document", { hidden: false, querySelector: () => (isPage ? {} : null) });
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  });
});
afterEach(async () => {
  // Nothing is left to a frame after its test.
  await new Promise<void>((done) => inNextFrame(done));
  vi.unstubAllGlobals();
});

/** Ten straight metres in as many seconds, at a steady pace or at twice the pace from half on. */
function driveIn(seconds: number, middle = 5): Drive {
  const t = Float64Array.of(0, seconds / 2, seconds),
    stations = Float64Array.of(0, middle, 10),
    none = new Float64Array(3);
  const path = [...stations].flatMap((x) => [x, 0, 0]);
  return { t, path: Float64Array.from(path), stations, speeds: none, accelerations: none, steering: none, hash: "" };
}

const plan = (hash: string): Plan =>
  ({
    outcome: "found",
    hash,
    path: Float64Array.of(0, 0, 0, 5, 0, 0, 10, 0, 0),
    directions: Int8Array.of(1, 1, 1),
    curvatures: new Float64Array(3),
    clearances: new Float64Array(3),
    check: { drivable: true },
    metrics: { length: 10 },
  }) as unknown as Plan;

const answered = (hash: string): PanelResult => ({
  ...emptyResult,
  plan: plan(hash),
  drive: driveIn(10),
  status: "done",
});

const line = {
  path: Float64Array.of(0, 0, 0, 10, 0, 0),
  directions: Int8Array.of(1, 1),
  curvatures: new Float64Array(2),
  clearances: new Float64Array(2),
};
const verdict = { length: 10.5, gearChanges: 0, minClearance: 0.25, endError: { x: 0, y: 0, heading: 0.001 } },
  trajectory = { ...driveIn(6), stage: "optimised", check: verdict };

function open(hash = "one"): Store {
  const store = createStore({ planners: ["hybrid"], complete: true, results: { hybrid: answered(hash) } });
  followSmooth({ store, planning: {}, complete: () => Promise.resolve({ api: { packRuns: () => "" } } as never) });
  return store;
}

const worker = (): FakeWorker => FakeWorker.all.at(-1)!;

describe("a trajectory", () => {
  it("takes the place of a path that rests, and goes with the switch", async () => {
    const store = open();
    await settle();
    expect(worker().asked.map(({ name }) => name)).toEqual(["smooth"]);
    const before = store.state.results["hybrid"]!;
    expect(played(before)).toBe(before);
    await worker().answer({ answer: { trajectory, drive: trajectory, line } });
    const { plan: of, smoothed } = store.state.results["hybrid"]!;
    expect(smoothed).toMatchObject({ of, drive: trajectory, failure: null });
    expect(played(store.state.results["hybrid"])!.plan).toMatchObject({
      hash: "one",
      path: line.path,
      metrics: { length: 10.5, directionChanges: 0, minClearance: 0.25, maxCurvature: 0 },
      check: { drivable: true, goalHeadingError: 0.001 },
    });
    chooseSmooth(store, false);
    expect(played(store.state.results["hybrid"])!.plan).toBe(of);
    chooseSmooth(store, true);
    expect(store.state.results["hybrid"]!.smoothed).toBe(smoothed);
    expect(FakeWorker.all.flatMap(({ asked }) => asked)).toHaveLength(1);
    // No step of undo.
    expect(store.state.canUndo).toBe(false);
  });

  it("is not asked for during a drag, and gives the processor to one that begins", async () => {
    const store = open();
    await settle();
    const scene: Scene = { ...store.state.scene, start: { x: 5, y: 5, heading: 0 } };
    store.edit(scene, { transient: true });
    expect(worker().isTerminated).toBe(true);
    store.set({ results: { hybrid: answered("two") } });
    await settle();
    expect(FakeWorker.all).toHaveLength(1);
    store.edit(scene);
    await settle();
    expect(FakeWorker.all).toHaveLength(2);
    await worker().answer({ answer: { trajectory, drive: trajectory, line } });
    expect(played(store.state.results["hybrid"])!.drive).toBe(trajectory);
  });

  it("waits while bays are asked, as better paths do", async () => {
    const bays = { rows: new Map(), stale: new Set<number>(), done: 3, of: 4, lit: null, opened: false },
      asked = { ...bays, vehicle: { id: "own", vehicle: "sedan" as const }, entry: "either" as const },
      store = open();
    await settle();
    introduce([{ id: "hybrid", family: "hybrid" } as PlannerInfo]);
    store.set({ bays: asked, prefer: { hybrid: "shortest" }, results: { hybrid: answered("two") } });
    follow({ store, planning: {}, complete: () => Promise.resolve({ api: { packRuns: () => "" } } as never) });
    await worker().answer({ answer: { trajectory, drive: trajectory, line } });
    const calls = (): string[] => FakeWorker.all.flatMap(({ asked }) => asked.map(({ name }) => name));
    await settle();
    expect(calls()).toEqual(["smooth"]);
    store.set({ bays: { ...asked, done: 4 } });
    await vi.waitFor(() => expect(calls().sort()).toEqual(["improve", "smooth", "smooth"]));
    // A new question to the bays takes the processor back.
    store.set({ bays: asked });
    expect(FakeWorker.all.some(({ asked, isTerminated }) => asked[0]!.name === "improve" && isTerminated)).toBe(true);
  });

  it("that was not found leaves the path, with the reason; another path is tried again", async () => {
    const store = open();
    await settle();
    await worker().answer({ error: { code: "bad-input", path: "", message: "too narrow" } });
    const result = store.state.results["hybrid"]!;
    expect(result.smoothed).toMatchObject({ failure: { code: "bad-input", message: "too narrow" }, trajectory: null });
    expect(played(result)).toMatchObject({ plan: result.plan, drive: result.drive });
    store.set({ results: { hybrid: answered("two") } });
    await settle();
    expect(worker().asked).toHaveLength(2);
  });

  it("is tried once where no worker can be had", async () => {
    let tries = 0;
    vi.stubGlobal(
      "Worker",
      class {
        constructor() {
          tries++;
          throw new Error("workers are forbidden");
        }
      },
    );
    const store = open();
    await settle();
    await settle();
    expect(store.state.results["hybrid"]!.smoothed).toMatchObject({ failure: { message: "workers are forbidden" } });
    expect(tries).toBe(1);
  });

  it("of a plan that is not shown any more is not shown either", async () => {
    const store = open();
    await settle();
    const late = answered("two");
    store.set({ results: { hybrid: late } });
    await worker().answer({ answer: { trajectory, drive: trajectory, line } });
    expect(played(store.state.results["hybrid"])!.plan).toBe(late.plan);
  });

  it("is no business of roads, and of playgrounds that nobody has touched", async () => {
    const road = createStore({ planners: ["hybrid"], complete: true, results: { hybrid: answered("one") } });
    road.set({ scene: { ...road.state.scene, lanes: [{}] } as unknown as Scene });
    followSmooth({ store: road, planning: {}, complete: () => Promise.reject(new Error("asked")) });
    isPage = false;
    const store = open();
    await settle();
    expect(FakeWorker.all).toEqual([]);
    store.set({ hover: { x: 1, y: 1 } });
    await settle();
    expect(FakeWorker.all).toHaveLength(1);
  });
});

describe("the choice", () => {
  it("is remembered by the page, and a link's goes before it", () => {
    const store = open();
    expect(store.state.smooth).toBe(true);
    chooseSmooth(store, false);
    expect(kept.get("parkade.smooth")).toBe("off");
    expect(open().state.smooth).toBe(false);
    const linked = createStore({ smooth: true });
    followSmooth({ store: linked, planning: null, complete: () => Promise.reject(new Error("asked")) });
    expect(linked.state.smooth).toBe(true);
    isPage = false;
    expect(open().state.smooth).toBe(true);
  });

  it("is part of a view; views from before there was one have it on", () => {
    const { state } = createStore();
    const known = { planners: state.planners.map((id) => ({ id })) as never, map: state.scene.map };
    for (const smooth of [true, false])
      expect(decodeView(encodeView({ ...state, smooth }), known, state.playback)).toMatchObject({
        smooth,
        layers: state.layers,
      });
    expect(decodeView("0~hybrid~four.hybrid~ld~0~5000", known, state.playback).smooth).toBe(true);
  });
});

describe("the car on its way", () => {
  it("stays where it is when its path gets other times", () => {
    const store = createStore({ planners: ["hybrid"], results: { hybrid: { ...answered("one"), drive: null } } });
    keepPlace(store);
    const along = (): number => {
      const { state } = store,
        result = state.results["hybrid"]!;
      return drivenAt(state, played(result)!.plan!, result, 1)!.along;
    };
    store.set({ playback: { ...store.state.playback, fraction: 0.25, playing: true } });
    expect(along()).toBeCloseTo(2.5, 6);
    const timed = { ...store.state.results["hybrid"]!, drive: driveIn(10, 2) };
    store.set({ results: { hybrid: timed } });
    expect(along()).toBeCloseTo(2.5, 6);
    expect(store.state.playback.fraction).toBeGreaterThan(0.5);
    const { plan: of } = timed;
    store.set({
      results: {
        hybrid: {
          ...timed,
          smoothed: { of: of!, plan: { ...of!, ...line } as Plan, drive: trajectory, trajectory: null, failure: null },
        },
      },
    });
    expect(along()).toBeCloseTo(2.5, 6);
    // A playhead at rest stays.
    const { fraction: rest } = store.state.playback;
    store.set({ playback: { ...store.state.playback, playing: false } });
    store.set({ results: { hybrid: timed } });
    expect(store.state.playback.fraction).toBe(rest);
    // One that has arrived or not begun stays there, too.
    for (const fraction of [0, 1]) {
      store.set({ playback: { ...store.state.playback, fraction, playing: true } });
      store.set({ results: { hybrid: { ...timed } } });
      expect(store.state.playback.fraction).toBe(fraction);
    }
  });
});
