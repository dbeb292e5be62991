import { beforeAll, expect, test } from "vitest";
import { Planner, init, judge, scenario, trajectory } from "parkade";

beforeAll(() => init());

const straight = "t,x,y,theta,v,phi\n0,4,3,0,0,0\n2.5,7.125,3,0,2.5,0\n4,10.875,3,0,2.5,0\n6.5,14,3,0,0,0\n";

test("ten straight metres take 6.5 s, as CSV, as columns and as a path", () => {
  const scene = scenario("perpendicular");
  const columns = {
    t: [0, 2.5, 4, 6.5],
    path: [4, 3, 0, 7.125, 3, 0, 10.875, 3, 0, 14, 3, 0],
    speeds: [0, 2.5, 2.5, 0],
    steering: [0, 0, 0, 0],
  };
  const verdicts = [judge(scene, straight), judge(scene, columns), judge(scene, { path: [4, 3, 0, 14, 3, 0] })];
  for (const { duration, effort, steeringEffort, gearChanges, smoothness, tpcapCost } of verdicts) {
    for (const [got, wanted] of [
      [duration, 6.5],
      [effort, 5],
      [steeringEffort, 0],
      [gearChanges, 0],
      [smoothness, 50],
      [tpcapCost, 700],
    ] as const) {
      expect(Math.abs(got - wanted)).toBeLessThan(1e-5);
    }
  }
  expect(verdicts[0]).toEqual(verdicts[1]);
});

test("a plan's preview is judged: its poses are not those of its wheel", () => {
  const scene = scenario("perpendicular"),
    plan = new Planner("hybrid", scene).plan();
  const found = judge(scene, trajectory(scene, plan));
  expect(found.attained).toBe(false);
  expect(found.modelError.distance).toBeGreaterThan(0.02);
  expect(found.touchingFrames).toBe(0);
  expect(judge(scene, plan).frames).toBeGreaterThan(10_000);
});

test("what is wrong is named", () => {
  const scene = scenario("perpendicular");
  const message = (run: () => unknown) => {
    try {
      run();
    } catch (error) {
      return (error as Error).message;
    }
    return "nothing";
  };
  expect(message(() => judge(scene, straight.replace("7.125", "seven")))).toBe(
    '3:5: x must be a finite number, got "seven"',
  );
  expect(message(() => judge(scene, straight, { speed: 0 }))).toBe("speed: must be between 0.1 and 100, got 0");
  expect(message(() => judge(scene, { path: [0, 0, 0, 1, 0, 0], t: [0] }))).toBe("t: must be one per pose (2), got 1");
  expect(message(() => judge(scene, { path: [0, 0, 0, 1, 0] }))).toBe(
    "trajectory.path: must be x, y, heading for each pose, got 5 numbers",
  );
  // @ts-expect-error: no trajectory
  expect(message(() => judge(scene, 7))).toContain("trajectory");
});
