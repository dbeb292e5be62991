import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import { Planner, init, judge, optimise, scenario, stopWaitGo, toTrajectoryCSV, track } from "parkade";

beforeAll(() => init());

const hashes = JSON.parse(readFileSync(new URL("../data/trajectory-hashes.json", import.meta.url), "utf8")) as Record<
  string,
  string
>;

const planned = (id: string) => {
  const scene = scenario(id),
    planner = new Planner("hybrid", scene),
    plan = planner.plan();
  planner.free();
  return { scene, plan };
};

test.each(Object.keys(hashes))("the trajectory of %s has the native hash, and passes", (id) => {
  const { scene, plan } = planned(id),
    made = optimise(scene, plan);
  expect(made.hash).toBe(hashes[id]);
  expect(made.check).toMatchObject({ passes: true, touchingFrames: 0, uncertified: 0 });
  expect(made.duration).toBe(made.t.at(-1));
  expect(made.stations.at(-1)).toBeCloseTo(made.length, 6);
});

test("its CSV is judged as it is, and a car follows it to the centimetre", () => {
  const { scene, plan } = planned("L2"),
    made = optimise(scene, plan, { margin: 0.1 });
  const csv = toTrajectoryCSV(made),
    verdict = judge(scene, csv);
  expect(csv.split("\n")[0]).toBe("t,x,y,theta,v,phi,a,omega");
  expect(verdict).toMatchObject({ passes: true, duration: made.duration, gearChanges: made.check.gearChanges });
  expect(verdict.effort).toBeCloseTo(made.check.effort, 9);
  const followed = track(scene, made);
  expect(followed.maxLateral).toBeLessThan(0.01);
  expect(followed.passes).toBe(true);
});

test("a plan between other ends is optimised between them, and a path that hits something is refused", () => {
  const scene = scenario("perpendicular"),
    planner = new Planner("hybrid", scene);
  const plan = planner.plan({ start: { x: 0, y: 9, heading: Math.PI } });
  expect(optimise(scene, plan).check.passes).toBe(true);
  expect(() => optimise(scene, { path: [4, 3, 0, 40, 3, 0] })).toThrow(/plan\.path: must pass its check/);
  // @ts-expect-error: no such option
  expect(() => optimise(scene, plan, { speeed: 2 })).toThrow(/speeed: no such setting/);
  planner.free();
});

test("the fastest of some paths is the one whose trajectory is the fastest, and driveTime is its duration", () => {
  const scene = scenario("par-7.2"),
    planner = new Planner("hybrid", scene);
  const plan = planner.plan({ prefer: "fastest", alternatives: true });
  planner.free();
  expect(plan.metrics.driveTime).toBe(optimise(scene, plan).duration);
  const times = plan.alternatives!.map((one) => one.metrics.driveTime!);
  expect(times.length).toBeGreaterThan(1);
  expect(Math.min(...times)).toBe(plan.metrics.driveTime);
});

test("a trajectory waits for a box within its own limits, and its seconds are those of its speeds", () => {
  const { scene, plan } = planned("fig16-conflict"),
    made = optimise(scene, plan),
    met = stopWaitGo(scene, made);
  expect(met).toMatchObject({ ending: "arrived", contact: null, freeDuration: made.duration });
  expect(met.waits.length).toBe(1);
  let driven = 0;
  for (let i = 1; i < met.t.length; i++)
    driven += ((Math.abs(met.speeds[i]!) + Math.abs(met.speeds[i - 1]!)) / 2) * (met.t[i]! - met.t[i - 1]!);
  expect(driven).toBeCloseTo(made.length, 6);
  expect(met.t.at(-1)).toBe(met.duration);
  const verdict = judge(scene, { path: met.path, t: met.t, speeds: met.speeds, steering: met.steering });
  expect(verdict).toMatchObject({ attained: true, keepsLimits: true, touchingFrames: 0, duration: met.duration });
  // Along the plan itself it drives as in the paper, at 2 m/s throughout.
  expect(Math.max(...stopWaitGo(scene, plan).speeds)).toBe(2);
  expect(() => stopWaitGo(scene, { ...made, speeds: made.speeds.slice(1) })).toThrow(/plan\./);
});
