import { expect, it } from "vitest";
import {
  Planner,
  init,
  planners,
  scenario,
  type Scenario,
  stopWaitGo,
  trajectory,
  type LayerName,
  type PlannerId,
  type Pose,
} from "parkade";
import { Lane } from "../../www/src/planning/planner-queue";
import type { WorkerLike } from "../../www/src/planning/pool";
import { WorkerPool } from "../../www/src/planning/pool";
import type { Reply, Request, Waiting } from "../../www/src/planning/protocol";

type Planned = Extract<Reply, { kind: "planned" }>;

interface Scope {
  onmessage: ((event: { data: Request }) => void) | null;
  postMessage(reply: Reply): void;
}
const scope: Scope = { onmessage: null, postMessage: () => {} };
(globalThis as unknown as { self: Scope }).self = scope;
await init();
import { driveOf } from "../../www/src/planning/drive-of";
const { serve } = await import("../../www/src/planning/plan-worker");
serve({ Planner, init: () => init(), planners, driveOf } as unknown as Parameters<typeof serve>[0]);

/** A lane with the worker's own script on this thread, and what that is asked. */
function setup(planner: PlannerId) {
  const asked: Request[] = [];
  const worker: WorkerLike = {
    onmessage: null,
    onerror: null,
    terminate() {},
    postMessage(request) {
      asked.push(request);
      scope.onmessage?.({ data: structuredClone(request) });
    },
  };
  scope.postMessage = (reply) => worker.onmessage?.({ data: reply } as MessageEvent<Reply>);
  const progress: [id: number, expansions: number][] = [];
  let told: (reply: Planned | { failed: string }) => void = () => {};
  const lane = new Lane(planner, {}, null as unknown as WebAssembly.Module, new WorkerPool(() => worker, 1), {
    progressed: (id, expansions) => progress.push([id, expansions]),
    planned: (reply) => told(reply),
    failed: ({ message }) => told({ failed: message }),
    restarted: () => told({ failed: "restarted" }),
  });
  let id = 0;
  const plan = (
    scene: Scenario,
    layers: LayerName[],
    every = 1,
    waiting: Waiting | null = "predictive",
  ): Promise<Planned | { failed: string }> =>
    new Promise((done) => {
      told = done;
      lane.plan({ id: ++id, scene, layers, every, trace: true, waiting });
    });
  return { asked, lane, plan, progress };
}

const extra = (planner: PlannerId): LayerName[] =>
  planner.startsWith("risk-field") ? ["risk"] : planner === "cost-map" ? ["cost"] : [];

const moved = (scene: Scenario, x: number, y: number): Scenario => {
  const goal = scene.goal as Pose;
  return {
    ...scene,
    start: { ...scene.start, x: scene.start.x + x / 2 },
    goal: { ...goal, x: goal.x - x, y: goal.y - y },
  };
};

it.each(planners().map(({ id }) => id))(
  "answers %s between other ends, without the scene, as a planner of the scene with them",
  async (planner) => {
    const { asked, plan } = setup(planner);
    const first = scenario(
      planner === "cost-map" ? "road-narrow" : planner.startsWith("hybrid") ? "perpendicular" : "random-60",
    );
    const own: Scenario = {
      ...first,
      goal: "slot" in first.goal ? { ...first.start, x: first.start.x + 6 } : first.goal,
    };
    const names: LayerName[] = ["safety", "clearance", ...extra(planner)];
    await plan(own, names);
    // The last ones are off the map.
    for (const [x, y] of [
      [1, 0.5],
      [2, -1],
      [1e4, 0],
      [0, 0],
    ] as const) {
      const scene = moved(own, x, y);
      const reply = await plan(scene, names);
      expect(asked.at(-1)).toMatchObject({
        kind: "plan",
        scene: null,
        ends: { start: scene.start, goal: scene.goal },
        layers: extra(planner),
      });
      if ("failed" in reply) throw new Error(reply.failed);
      const anew = new Planner(planner, scene),
        found = anew.plan({ trace: true });
      expect(reply.plan).toEqual(found);
      for (const name of names) expect(reply.layers[name], name).toEqual(anew.layer(name));
      expect(reply.drive).toEqual(
        found.outcome === "found" && found.check.drivable
          ? (scene.moving?.length ? stopWaitGo : trajectory)(scene, found)
          : null,
      );
      anew.free();
    }
  },
);

it("sends the scene again after every change but that of its ends, and when the worker has changed hands", async () => {
  const { asked, lane, plan } = setup("risk-field");
  const scene = scenario("random-60");
  const whole = (): boolean => {
    const last = asked.at(-1)!;
    return last.kind === "plan" && last.scene !== null;
  };
  await plan(scene, []);
  expect(whole()).toBe(true);
  await plan(moved(scene, 1, 0), []);
  expect(whole()).toBe(false);
  for (const changed of [
    { ...scene, obstacles: [...scene.obstacles!] },
    { ...scene, map: { ...scene.map } },
    { ...scene, planners: {} },
    { ...scene, vehicle: "sedan" as const },
  ]) {
    await plan(changed, []);
    expect(whole()).toBe(true);
  }
  expect(await plan({ ...scene, planners: { "risk-field": { w1: -1 } } }, [])).toMatchObject({
    failed: expect.stringContaining("w1"),
  });
  await plan({ ...scene }, []);
  expect(whole()).toBe(true);
  await plan({ ...scene }, []);
  expect(whole()).toBe(false);
  lane.stop();
  await plan({ ...scene }, []);
  expect(whole()).toBe(true);
});

it("keeps a slot as goal, and reads the map anew where the goal is or was one", async () => {
  const { asked, plan } = setup("hybrid");
  const scene = scenario("reverse-in");
  if (!("slot" in scene.goal)) throw new Error("This test needs a slot as goal.");
  const start = { ...scene.start, x: scene.start.x - 0.5 },
    pose = { ...scene.start, x: scene.start.x - 2 };
  await plan(scene, []);
  const reply = await plan({ ...scene, start }, []);
  expect(asked.at(-1)).toMatchObject({ scene: null, ends: { start } });
  if ("failed" in reply) throw new Error(reply.failed);
  expect(reply.plan.hash).toBe(new Planner("hybrid", { ...scene, start }).plan().hash);
  for (const goal of [pose, scene.goal, { ...scene.goal }]) {
    await plan({ ...scene, goal }, []);
    expect(asked.at(-1)).toMatchObject({ scene: { goal } });
  }
});

it("brings a sample of the field where that is enough", async () => {
  const { plan } = setup("risk-field");
  const scene = scenario("random-60");
  await plan(scene, []);
  const reply = await plan(moved(scene, 1, 1), ["risk", "clearance"], 4);
  if ("failed" in reply) throw new Error(reply.failed);
  const { risk, clearance } = reply.layers;
  expect([risk?.every, risk?.width, risk?.data.length, clearance?.every, clearance?.width]).toEqual([
    4,
    15,
    15 * 15 * 2,
    1,
    60,
  ]);
});

it("tells how far a plan is while it runs, but not when it only times it", async () => {
  const { lane, plan, progress } = setup("hybrid");
  const reply = await plan({ ...scenario("par-8.0"), planners: { hybrid: { maxExpansions: 1500 } } }, []);
  if ("failed" in reply) throw new Error(reply.failed);
  expect(reply.plan.stats.expanded).toBeGreaterThan(512);
  const { expanded } = reply.plan.stats;
  const told = [...Array.from({ length: Math.floor(expanded / 256) }, (_, k) => 256 * (k + 1)), expanded].map(
    (count) => [1, count],
  );
  expect(progress).toEqual(told);
  expect(await lane.time(1, 0)).toHaveLength(1);
  expect(progress).toEqual(told);
});

it("shows the plan where its drive fails", async () => {
  const { plan } = setup("hybrid");
  serve({
    Planner,
    planners,
    init: () => init(),
    driveOf: () => {
      throw Object.assign(new Error("must be driven within 100000 s"), { code: "config", path: "path" });
    },
  } as unknown as Parameters<typeof serve>[0]);
  const reply = await plan(scenario("P0"), []);
  serve({ Planner, init: () => init(), planners, driveOf } as unknown as Parameters<typeof serve>[0]);
  expect(reply).toMatchObject({ kind: "planned", drive: null, undriven: true, plan: { outcome: "found" } });
});

/** How far poses of one path are from the other path, at most, metres. */
function strays(one: Float64Array, other: Float64Array): number {
  let most = 0;
  for (let i = 0; i < one.length; i += 3) {
    let least = Infinity;
    for (let j = 0; j < other.length; j += 3)
      least = Math.min(least, Math.hypot(one[i]! - other[j]!, one[i + 1]! - other[j + 1]!));
    most = Math.max(most, least);
  }
  return most;
}

/** Paths that leap to another way whose length differs by less than 3 %, of those of a drag. */
async function idleFlips(
  steps: readonly Scenario[],
  waiting: Waiting | null,
): Promise<{ idle: number; found: number }> {
  const { plan } = setup("hybrid");
  let idle = 0,
    found = 0,
    last: Planned["plan"] | null = null;
  for (const scene of steps) {
    const reply = await plan(scene, [], 1, waiting);
    if ("failed" in reply) throw new Error(reply.failed);
    const before: Planned["plan"] | null = last;
    last = reply.plan.outcome === "found" ? reply.plan : null;
    found += last ? 1 : 0;
    if (
      before &&
      last &&
      strays(last.path, before.path) > 1 &&
      Math.abs(last.metrics.length / before.metrics.length - 1) < 0.03
    )
      idle++;
  }
  return { idle, found };
}

/** An island in the way, and a post that stands out of its far side. */
const island = (y: number): Scenario => ({
  version: 1,
  map: { origin: [0, 0], width: 72, height: 52, resolution: 0.5 },
  vehicle: "sedan",
  obstacles: [
    { type: "rectangle", center: [18, 12.9], size: [5, 6] },
    { type: "rectangle", center: [18, y], size: [1, 1] },
  ],
  start: { x: 5, y: 13, heading: 0 },
  goal: { x: 29, y: 13, heading: 0 },
});

it("goes on from the last path while an obstacle is dragged, and only then", async () => {
  const isBeyond = (y: number): boolean => {
    const planner = new Planner("hybrid", island(y)),
      { path } = planner.plan();
    planner.free();
    return path[3 * Math.floor(path.length / 6) + 1]! > 12.9;
  };
  // Where both ways around are about as good: from there the one becomes a little longer, and a little shorter.
  let [low, high] = [14, 18];
  expect([isBeyond(low), isBeyond(high)]).toEqual([true, false]);
  for (let i = 0; i < 12; i++) {
    const middle = (low + high) / 2;
    if (isBeyond(middle)) low = middle;
    else high = middle;
  }
  const steps = Array.from({ length: 60 }, (_, i) => island(low + 0.2 * Math.cos(i * 0.42)));
  expect((await idleFlips(steps, null)).idle).toBe(0);
  expect((await idleFlips(steps, "predictive")).idle).toBeGreaterThan(0);
});
