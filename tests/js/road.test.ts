import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import { ParkadeError, Planner, collisionRisk, init, planners, roadFigures, scenario, trajectory } from "parkade";

beforeAll(() => init());

const PLAIN = { costs: "steps", pruning: "none", smoothing: "none" };

function planned(id: string, settings = {}) {
  const planner = new Planner("cost-map", scenario(id), settings);
  const plan = planner.plan();
  planner.free();
  return plan;
}

describe("the planner of roads", () => {
  test("plans as it does natively", () => {
    const held = readFileSync(new URL("../road/plans.rs", import.meta.url), "utf8")
      .match(/let expected = \[([^\]]*)\]/)![1]!
      .match(/[0-9a-f]{16}-[0-9a-f]{16}/g);
    const hashes = ["road-straight", "road-curve", "road-crossing", "road-narrow"].map((id) => planned(id).hash);
    expect(hashes).toEqual(held);
  });

  test("says what its path is worth", () => {
    const { check, metrics } = planned("road-narrow");
    expect(check.verdict).toBe("ok");
    expect(metrics.turnsPruned).toBe(11);
    expect(metrics.bodyClearanceMin).toBeGreaterThan(0.5);
    expect(metrics.laneDeviationMax).toBeGreaterThan(0);
    expect(planned("perpendicular").metrics.laneDeviationMax).toBeNull();
  });

  test("draws its costs", () => {
    const planner = new Planner("cost-map", scenario("road-narrow"));
    const { width, height, data } = planner.layer("cost");
    expect(data.length).toBe(width * height);
    // In the middle of a lane nothing is dearer than a metre is.
    expect(Math.min(...data)).toBe(0);
    expect(data.some((cost) => cost > 0 && cost < Infinity)).toBe(true);
    expect(Math.max(...data)).toBe(Infinity);
    planner.free();
  });

  test("names its settings in two languages", () => {
    const { family, parameters } = planners().find(({ id }) => id === "cost-map")!;
    expect(family).toBe("road");
    for (const { title, doc, unit } of parameters) expect([title.en, title.zh, doc.en, doc.zh, unit]).not.toContain("");
    expect(() => new Planner("cost-map", scenario("road-narrow"), { laneWeight: 9 })).toThrow(
      "laneWeight: must be between 0 and 3, got 9",
    );
  });
});

describe("any path on a road", () => {
  test("has figures and a risk, in slices", () => {
    const scene = scenario("road-narrow");
    const plan = planned("road-narrow", PLAIN);
    expect(roadFigures(scene, plan)).toMatchObject({
      bodyClearanceMin: plan.metrics.bodyClearanceMin,
      curvatureVariation: plan.metrics.curvatureVariation,
    });
    const whole = collisionRisk(scene, plan);
    expect(whole.hits).toBeGreaterThan(700);
    const slices = [
      [0, 400],
      [400, 600],
    ].map(([from, trials]) => collisionRisk(scene, { path: [...plan.path] }, { from: from!, trials: trials! }));
    expect(slices.reduce((sum, slice) => sum + slice.hits, 0)).toBe(whole.hits);
    expect(collisionRisk(scene, planned("road-narrow"), { seed: 7 }).hits).toBeLessThan(10);
  });

  test("is refused by name where it is none", () => {
    const scene = scenario("road-narrow");
    const failure = (run: () => unknown) => {
      try {
        run();
      } catch (error) {
        expect(error).toBeInstanceOf(ParkadeError);
        return [(error as ParkadeError).code, (error as ParkadeError).path];
      }
      throw new Error("nothing was thrown");
    };
    expect(failure(() => roadFigures(scene, { path: [] }))).toEqual(["bad-input", "plan.path"]);
    expect(failure(() => collisionRisk(scene, { path: [0, 0] }))).toEqual(["bad-input", "plan.path"]);
    expect(failure(() => collisionRisk(scene, null as never))).toEqual(["bad-input", "plan"]);
    expect(failure(() => collisionRisk(scene, { path: [0, 0, 0] }, { trials: 0 }))).toEqual(["bad-input", "trials"]);
  });

  test("keeps to speed limits", () => {
    const scene = scenario("road-crossing");
    const plan = planned("road-crossing");
    const limits = { speed: 10, acceleration: 1.5, deceleration: 2, lateralAcceleration: 2, dwell: false };
    const free = trajectory({ ...scene, speedLimits: [] }, plan, limits);
    expect(trajectory(scene, plan, limits).duration).toBeGreaterThan(free.duration + 0.5);
    expect(free.maxLateralAcceleration).toBeLessThan(2.0001);
  });
});
