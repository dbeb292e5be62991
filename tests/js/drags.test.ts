/**
 * The page's first scene under the hand: the worker's session answers a drag's steps, and no path leaps to a way about
 * as long.
 */
import { beforeAll, expect, it } from "vitest";
import { Planner, init, planners, scenario, type Plan, type Pose } from "parkade";
import { driveOf } from "../../www/src/planning/drive-of";
import type { PlanRequest, Reply, Request } from "../../www/src/planning/protocol";
import type { Scenario } from "../../www/src/scene/scenario";
import { quantile } from "../quantile.mjs";

interface Scope {
  onmessage: ((event: { data: Request }) => void) | null;
  postMessage(reply: Reply): void;
}
const scope: Scope = { onmessage: null, postMessage: () => {} };
(globalThis as unknown as { self: Scope }).self = scope;

beforeAll(async () => {
  await init();
  const { serve } = await import("../../www/src/planning/plan-worker");
  serve({ Planner, init: () => init(), planners, driveOf } as unknown as Parameters<typeof serve>[0]);
});

const STEPS = 200;
/**
 * A leap: some place of one path is farther than this from the other, metres, and their lengths differ by less than the
 * share.
 */
const ASTRAY = 1,
  ALIKE = 0.03;
const SEEDS = (process.env["DRAGS"] ?? "1 2").split(" ").map(Number);

/** Numbers from 0 to 1, the same everywhere. */
function numbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let z = Math.imul(state ^ (state >>> 16), 0x85ebca6b);
    z = Math.imul(z ^ (z >>> 13), 0xc2b2ae35);
    return ((z ^ (z >>> 16)) >>> 0) / 2 ** 32;
  };
}

interface Shift {
  x: number;
  y: number;
  turned: number;
}

/** A hand that wanders within so many metres of where it took hold, up to 25 cm a step, and turns a little. */
function wander(seed: number, reach: number): Shift[] {
  const next = numbers(seed),
    between = (low: number, high: number): number => low + (high - low) * next();
  let heading = between(0, 2 * Math.PI),
    at: Shift = { x: 0, y: 0, turned: 0 };
  return Array.from({ length: STEPS }, () => {
    heading += between(-0.5, 0.5);
    const length = between(0.02, 0.25),
      to = { x: at.x + length * Math.cos(heading), y: at.y + length * Math.sin(heading) };
    if (Math.hypot(to.x, to.y) > reach) heading += 2;
    else at = { ...at, ...to };
    return (at = { ...at, turned: at.turned + between(-0.02, 0.02) });
  });
}

/** Out of the bay into the aisle, along it and back. */
const loop = (): Shift[] =>
  Array.from({ length: STEPS }, (_, i) => {
    const turn = (2 * Math.PI * (i + 1)) / STEPS;
    return { x: 3 * Math.sin(turn), y: 2.5 * (1 - Math.cos(turn)), turned: 0 };
  });

const moved = (pose: Pose, { x, y, turned }: Shift): Pose => ({
  x: pose.x + x,
  y: pose.y + y,
  heading: pose.heading + turned,
});

/** The scene with an obstacle elsewhere. */
function withMoved(scene: Scenario, index: number, { x, y }: Shift): Scenario {
  type Movable = { center?: number[]; pose?: Pose; points?: number[][] };
  const obstacles = structuredClone(scene.obstacles!),
    one = obstacles[index]! as Movable,
    shifted = ([px, py]: number[]): number[] => [px! + x, py! + y];
  if (one.center) one.center = shifted(one.center);
  else if (one.pose) one.pose = { ...one.pose, x: one.pose.x + x, y: one.pose.y + y };
  else one.points = one.points!.map(shifted);
  return { ...scene, obstacles };
}

/** How far either path strays from the other, metres. */
function strays({ path: a }: Plan, { path: b }: Plan): number {
  const far = (from: Float64Array, to: Float64Array): number => {
    let most = 0;
    for (let i = 0; i < from.length; i += 3) {
      let least = Infinity;
      for (let j = 0; j < to.length; j += 3)
        least = Math.min(least, Math.hypot(from[i]! - to[j]!, from[i + 1]! - to[j + 1]!));
      most = Math.max(most, least);
    }
    return most;
  };
  return Math.max(far(a, b), far(b, a));
}

/** What the page's worker answers to the steps of a drag, each asked as the page asks it. */
async function dragged(scene: Scenario, steps: readonly { scene: Scenario | null; ends: PlanRequest["ends"] }[]) {
  const plans: Plan[] = [],
    millis: number[] = [];
  const ask = (request: Omit<PlanRequest, "kind" | "id" | "layers" | "every" | "trace">): Promise<Plan> =>
    new Promise((resolve, reject) => {
      scope.postMessage = (reply) => {
        if (reply.kind === "planned") resolve(reply.plan);
        else if (reply.kind === "failed") reject(new Error(reply.error.message));
      };
      scope.onmessage!({
        data: structuredClone({ kind: "plan", id: 1, layers: [], every: 1, trace: true, ...request } as PlanRequest),
      });
    });
  scope.onmessage!({ data: { kind: "start", planner: "hybrid", module: null as unknown as WebAssembly.Module } });
  await ask({ scene, ends: { start: scene.start }, waiting: "predictive" });
  for (const step of steps) {
    const before = process.cpuUsage();
    plans.push(await ask({ ...step, waiting: null }));
    const { user, system } = process.cpuUsage(before);
    millis.push((user + system) / 1000);
  }
  return { plans, millis };
}

/** The pairs of answers between which the path leaps, in words. */
function leaps(name: string, plans: readonly Plan[]): string[] {
  return plans.flatMap((plan, i) => {
    const before = plans[i - 1];
    if (plan.outcome !== "found" || before?.outcome !== "found") return [];
    const [from, to] = [before, plan].map(({ metrics: { length, directionChanges } }) => ({
      length,
      directionChanges,
    }));
    if (Math.abs(to!.length / from!.length - 1) >= ALIKE || strays(before, plan) <= ASTRAY) return [];
    return [`${name}, step ${i}: ${JSON.stringify(from)} to ${JSON.stringify(to)}`];
  });
}

it("goal, start and obstacles are dragged by 200 steps, and no path leaps to one about as long", async () => {
  const scene = scenario("perpendicular") as Scenario,
    { start } = scene,
    planner = new Planner("hybrid", scene),
    path = planner.plan().path,
    goal = { x: path.at(-3)!, y: path.at(-2)!, heading: path.at(-1)! };
  planner.free();
  const ofGoal = (shifts: Shift[]) =>
    shifts.map((shift) => ({ scene: null, ends: { start, goal: moved(goal, shift) } }));
  const drags = [
    ["goal along the aisle", ofGoal(loop())] as const,
    ...SEEDS.flatMap((seed) => [
      [`goal in its bay, seed ${seed}`, ofGoal(wander(seed, 0.3))] as const,
      [`goal, seed ${seed}`, ofGoal(wander(seed + 100, 3))] as const,
      [
        `start, seed ${seed}`,
        wander(seed + 200, 2).map((shift) => ({ scene: null, ends: { start: moved(start, shift), goal } })),
      ] as const,
      ...scene.obstacles!.map(
        (_, index) =>
          [
            `obstacle ${index}, seed ${seed}`,
            wander(seed + 300 + index, 2).map((shift) => ({
              scene: withMoved(scene, index, shift),
              ends: { start, goal },
            })),
          ] as const,
      ),
    ]),
  ];
  const found: string[] = [],
    times: number[] = [];
  let count = 0;
  for (const [name, steps] of drags) {
    const { plans, millis } = await dragged(scene, steps);
    expect(plans).toHaveLength(STEPS);
    for (const plan of plans) if (plan.outcome === "found") expect(plan.check.drivable, name).toBe(true);
    count += plans.filter(({ outcome }) => outcome === "found").length;
    found.push(...leaps(name, plans));
    times.push(...millis);
  }
  console.log(
    `${count} paths of ${drags.length} drags; CPU a step ` +
      `p50 ${quantile(times, 0.5).toFixed(1)}, p95 ${quantile(times, 0.95).toFixed(
        1,
      )}, max ${quantile(times, 1).toFixed(1)} ms`,
  );
  expect(count).toBeGreaterThan((STEPS * drags.length) / 2);
  expect(found).toEqual([]);
}, 600_000);
