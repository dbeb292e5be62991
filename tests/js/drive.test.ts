import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, it, test } from "vitest";
import { type Plan, Planner, init, scenario, stopWaitGo, toCSV, toTrajectoryCSV, track, trajectory } from "parkade";
import { failure } from "./refused";

interface Row {
  path: number[];
  directions: number[];
  curvatures: number[];
  limited: string;
  jerk: string;
  slow: string;
  paper: string;
  tracked: string;
}

interface Vectors {
  rows: Record<string, Row>;
  scenes: Record<string, Record<"predictive" | "reactive", { ending: string; hash: string }>>;
}

const file = new URL("../data/drive-vectors.json", import.meta.url);
const { rows, scenes } = JSON.parse(readFileSync(file, "utf8")) as Vectors;
const untyped = (value: unknown) => value as never;

beforeAll(() => init());

function planned(id: string): Plan {
  using planner = new Planner("hybrid", scenario(id));
  return planner.plan();
}

describe("driving has the native bytes", () => {
  it.each(Object.keys(rows))("on row %s", (id) => {
    const row = rows[id]!,
      scene = scenario(id);
    expect(trajectory(scene, row).hash).toBe(row.limited);
    expect(trajectory(scene, row, { jerk: 2 }).hash).toBe(row.jerk);
    expect(trajectory(scene, row, { steps: "slow" }).hash).toBe(row.slow);
    expect(trajectory(scene, row, { profile: "constant", dwell: false }).hash).toBe(row.paper);
    expect(track(scene, row).hash).toBe(row.tracked);
  });

  it.each(Object.keys(scenes))("in scene %s", (id) => {
    for (const rule of ["predictive", "reactive"] as const) {
      const { ending, hash } = stopWaitGo(scenario(id), rows["L0"]!, { rule });
      expect({ ending, hash }).toEqual(scenes[id]![rule]);
    }
  });
});

test("a plan becomes a trajectory from rest to rest", () => {
  const plan = planned("P2");
  const driven = trajectory(scenario("P2"), plan, { speed: 1.5, dt: 0.1 });
  const last = driven.t.length - 1;
  expect(driven.path.length).toBe(3 * driven.t.length);
  expect([driven.t[0], driven.t[last], driven.speeds[0], driven.speeds[last]]).toEqual([0, driven.duration, 0, 0]);
  expect(driven.length).toBeCloseTo(plan.metrics.length, 6);
  expect(driven.path.slice(-3)).toEqual(plan.path.slice(-3));
  expect(Math.min(...driven.speeds)).toBeCloseTo(-1.5, 6);
  expect(driven.t.every((t, i) => i === 0 || (t > driven.t[i - 1]! && t <= driven.t[i - 1]! + 0.1 + 1e-9))).toBe(true);
  expect(driven.dwell).toBeGreaterThan(2);
});

test("a path's CSV has the exact speeds and times of a drive between its rows", () => {
  const scene = scenario("perpendicular"),
    along = Array.from({ length: 11 }, (_, x) => x);
  const straight = {
    path: along.flatMap((x) => [4 + x, 3, 0]),
    directions: along.map(() => 1),
    curvatures: along.map(() => 0),
    clearances: along.map(() => 1),
  };
  // Half a metre a second squared up to 2 m/s after 4 m, as much down from there.
  const drive = trajectory(scene, straight, { acceleration: 0.5, deceleration: 0.5, dt: 1 });
  const rows = toCSV(scene, straight, drive).trim().split("\n").slice(1);
  const cells = rows.map((row) => row.split(",").map(Number));
  for (const [x, v, t] of [
    [0, 0, 0],
    [1, 1, 2],
    [4, 2, 4],
    [5, 2, 4.5],
    [9, 1, 7],
    [10, 0, 9],
  ] as const) {
    expect(cells[x]![6]).toBeCloseTo(v, 5);
    expect(cells[x]![8]).toBeCloseTo(t, 5);
  }
  expect(toCSV(scene, straight, null).split("\n")[2]).toBe("1.0000,5,3,0,0,1,,1,");
  // A plan has its own.
  const plan = planned("P3");
  expect(toCSV(scenario("P3"), plan)).toBe(toCSV(scenario("P3"), plan, trajectory(scenario("P3"), plan)));
  expect(toTrajectoryCSV(drive).split("\n")[1]).toBe("0,4,3,0,0,0,0.5,0");
  expect(failure(() => toCSV(scene, straight, untyped({ t: [0] }))).path).toBe("drive.stations");
});

test("a simulated car follows", () => {
  const plan = planned("P3"),
    scene = scenario("P3");
  const feedback = track(scene, plan, { profile: "constant", speed: 1 });
  expect(feedback.passes).toBe(true);
  expect(feedback.maxLateral).toBeLessThan(0.05);
  expect(feedback.lateral.length).toBe(feedback.t.length);
  expect(track(scene, plan, { controller: "stanley" }).hash).not.toBe(feedback.hash);
  expect(track(scenario("P2"), planned("P2"), { profile: "constant", dwell: false }).passes).toBe(false);
});

test("a car waits for what crosses its way", () => {
  const scene = scenario("fig16-conflict"),
    plan = planned("fig16-conflict");
  const safe = stopWaitGo(scene, plan);
  expect([safe.ending, safe.waits.length, safe.contact]).toEqual(["arrived", 1, null]);
  expect(Math.min(...safe.clearances)).toBeGreaterThan(0.2);
  expect(safe.boxes.length).toBe(3 * safe.t.length);
  // Nobody touches anything, so nobody is ever at the moment of touch; at first the box nears the car's way.
  expect(safe.timesToCollision.length).toBe(safe.t.length);
  expect(Math.min(...safe.timesToCollision)).toBeGreaterThan(0);
  expect(Math.min(...safe.timesToCollision)).toBeLessThan(Infinity);
  expect(safe.duration).toBeGreaterThan(safe.freeDuration + 5);
  const paper = stopWaitGo(scene, plan, { rule: "reactive" });
  expect(paper.ending).toBe("hit");
  expect(paper.contact).toMatchObject({ obstacle: "box", index: 0 });
  expect(paper.timesToCollision[paper.t.findIndex((t) => t >= paper.contact!.t)]).toBe(0);
  const { moving: _, ...still } = scene;
  const free = stopWaitGo(still, plan);
  expect([free.ending, free.waits, free.clearances[0], free.boxes.length]).toEqual(["arrived", [], Infinity, 0]);
  expect(free.timesToCollision.every((time) => time === Infinity)).toBe(true);
});

test("mistakes are named", () => {
  const scene = scenario("P3"),
    plan = planned("P3");
  expect(failure(() => trajectory(scene, untyped(null)))).toEqual({ code: "bad-input", path: "plan" });
  expect(failure(() => trajectory(scene, untyped({})))).toEqual({ code: "bad-input", path: "plan.path" });
  expect(failure(() => trajectory(scene, { path: [] })).path).toBe("plan.path");
  expect(failure(() => trajectory(scene, { path: [1, 2] })).path).toBe("plan.path");
  expect(failure(() => trajectory(scene, { path: [0, 0, 0, 1, 0, 1] })).path).toBe("plan.path[0]");
  expect(failure(() => trajectory(scene, { ...plan, directions: [1] })).path).toBe("plan.directions");
  expect(failure(() => trajectory(scene, { ...plan, curvatures: [0] })).path).toBe("plan.curvatures");
  expect(failure(() => trajectory(scene, plan, { speed: -1 }))).toEqual({ code: "bad-config", path: "speed" });
  expect(failure(() => track(scene, plan, { controller: untyped("mpc") })).path).toBe("controller");
  expect(failure(() => stopWaitGo(scene, plan, untyped({ haste: 1 }))).path).toBe("haste");
  expect(failure(() => stopWaitGo({ ...scene, moving: [untyped({})] }, plan))).toEqual({
    code: "bad-scenario",
    path: "moving[0].points",
  });
  using planner = new Planner("eight", scene);
  expect(failure(() => trajectory(scene, planner.plan())).code).toBe("bad-input");
});
