import { beforeAll, describe, expect, it } from "vitest";
import { Planner, init, optimise, scenario, type HybridPlan, type Plan, type Prefer } from "parkade";
import { cheapest, choicesOf } from "../../www/src/planning/choices-of";
import { chosenOf, isProven } from "../../www/src/planning/chosen";
import { core } from "./core";

beforeAll(async () => {
  await Promise.all([init(), core.init()]);
});

const hybrid = (id: string) => new Planner("hybrid", scenario(id));

describe("a choice of hybrid's paths", () => {
  it("is made by what is preferred, and the alternatives come with it where they are asked for", () => {
    const planner = hybrid("L2"),
      ordinary = planner.plan();
    expect([ordinary.alternatives, ordinary.metrics.driveTime, ordinary.metrics.directionChanges]).toEqual([
      undefined,
      undefined,
      1,
    ]);
    const fewest = planner.plan({ prefer: "fewest-changes" });
    expect([fewest.metrics.directionChanges, fewest.alternatives, fewest.check.verdict]).toEqual([0, undefined, "ok"]);
    expect(fewest.metrics.driveTime).toBe(optimise(scenario("L2"), fewest).duration);
    const { alternatives = [], hash } = planner.plan({ prefer: "fewest-changes", alternatives: true });
    expect(alternatives.map((one) => one.metrics.length)).toEqual(
      alternatives.map((one) => one.metrics.length).sort((a, b) => a - b),
    );
    expect(alternatives.map((one) => one.planner)).toEqual(alternatives.map(() => "hybrid"));
    expect(alternatives.filter((one) => one.metrics.directionChanges === 0).map((one) => one.path)).toEqual([
      fewest.path,
    ]);
    expect(planner.plan({ prefer: "fewest-changes", alternatives: true }).hash).toBe(hash);
    expect(planner.plan().hash).toBe(ordinary.hash);
    planner.free();
  });

  it("tells each better plan, ends where that throws, and the planner plans on", () => {
    const planner = hybrid("par-7.2"),
      ordinary = planner.plan(),
      told: Plan[] = [];
    const last = planner.plan({ prefer: "fewest-changes", onImproved: (plan) => told.push(plan) });
    expect(told[0]?.path).toEqual(ordinary.path);
    expect(told.at(-1)?.path).toEqual(last.path);
    expect(told.map((plan) => plan.metrics.directionChanges)).toEqual(
      told.map((plan) => plan.metrics.directionChanges).sort((a, b) => b - a),
    );
    const enough = new RangeError("enough");
    expect(() =>
      planner.plan({
        onImproved: () => {
          throw enough;
        },
      }),
    ).toThrow(enough);
    expect(() => planner.plan({ onImproved: () => planner.plan() })).toThrow(
      expect.objectContaining({ code: "bad-input", message: expect.stringContaining("onImproved") }),
    );
    expect(planner.plan().hash).toBe(ordinary.hash);
    planner.free();
  });

  it("is refused with the field's name where it makes no sense", () => {
    const planner = hybrid("L2"),
      eight = new Planner("eight", scenario("L2"));
    const refusal = (path: string): unknown =>
      expect.objectContaining({ name: "ParkadeError", code: "bad-input", path });
    expect(() => planner.plan({ prefer: "cheapest" as Prefer })).toThrow(
      expect.objectContaining({
        path: "prefer",
        message: expect.stringContaining("shortest or fewest-changes or widest or fastest"),
      }),
    );
    expect(() => planner.plan({ alternatives: 1 as never })).toThrow(refusal("alternatives"));
    expect(() => planner.plan({ onImproved: "log" as never })).toThrow(refusal("onImproved"));
    expect(() => eight.plan({ prefer: "shortest" })).toThrow(refusal("prefer"));
    expect(() => eight.plan({ onImproved: () => undefined })).toThrow(refusal("onImproved"));
    expect(eight.plan({ alternatives: false }).outcome).toBe("found");
    const small = new core.Planner("hybrid", scenario("L2"));
    expect(() => small.plan({ prefer: "shortest" })).toThrow(refusal("prefer"));
    for (const one of [planner, eight, small]) one.free();
  });
});

describe("the search that answered", () => {
  it("is told with the path, and with the proof that there is none", () => {
    const planner = hybrid("perpendicular");
    expect(planner.plan().member).toEqual({
      level: 0,
      fromGoal: true,
      xyResolution: 0.5,
      headingResolution: Math.PI / 36,
      margin: 0.1,
    });
    planner.free();
    // A right-angled corner between walls, too narrow for a car to turn in.
    const corner = new Planner("hybrid", {
      version: 1,
      map: {
        origin: [0, 0],
        width: 32,
        height: 32,
        resolution: 0.5,
        boundary: [
          [0, 0],
          [16, 0],
          [16, 16],
          [12.8, 16],
          [12.8, 3.2],
          [0, 3.2],
        ],
      },
      vehicle: "sedan",
      start: { x: 2, y: 1.6, heading: 0 },
      goal: { x: 14.4, y: 11, heading: Math.PI / 2 },
    });
    const { outcome, reason, member } = corner.plan();
    expect(outcome).toBe("no-path");
    expect(member).toMatchObject({ margin: 0.002 });
    const { xyResolution, headingResolution } = member!;
    const [cell, angle] = [Math.round(xyResolution * 100), Number(((headingResolution * 180) / Math.PI).toFixed(1))];
    expect(cell).toBeLessThanOrEqual(15);
    expect(reason).toContain(
      `No way through for this car at ${cell} cm and ${angle}° with 2 mm of margin, with any number of gear ` +
        `changes. The search came to (`,
    );
    corner.free();
    const small = new core.Planner("hybrid", scenario("perpendicular"));
    expect(small.plan().member).toBeUndefined();
    small.free();
  });
});

describe("the chips", () => {
  const plan = (length: number, directionChanges: number, minClearance: number, driveTime: number): HybridPlan =>
    ({ metrics: { length, directionChanges, minClearance, driveTime } }) as HybridPlan;

  it("stand for the best by each measure and the ordinary path, the shortest first, once each", () => {
    const ordinary = plan(22, 2, 0.1, 20),
      longer = plan(26, 0, 0.12, 18),
      wider = plan(23, 2, 0.42, 21);
    const choices = choicesOf(ordinary, [plan(22.05, 2, 0.12, 20), wider, longer]);
    expect(choices.map(({ plan: { metrics }, by, isOrdinary }) => [metrics.length, by, isOrdinary])).toEqual([
      [22, ["shortest"], true],
      [23, ["widest"], false],
      [26, ["fewest-changes", "fastest"], false],
    ]);
    expect(choicesOf(ordinary, [ordinary])).toHaveLength(1);
  });

  it("are led by the path that costs least with no less margin than the first", () => {
    const of = (cost: number, margin: number): HybridPlan => ({ metrics: { cost, margin } }) as HybridPlan;
    const first = of(20, 0.1),
      close = of(18, 0.05),
      best = of(19, 0.1);
    expect(cheapest(first, [first, close, best])).toBe(best);
    expect(cheapest(first, [close])).toBe(first);
    const choices = choicesOf(plan(22, 2, 0.1, 20), [plan(26, 0, 0.12, 18)]);
    expect(chosenOf(choices, undefined)?.isOrdinary).toBe(true);
    expect(chosenOf(choices, "fewest-changes")?.plan.metrics.directionChanges).toBe(0);
    expect(chosenOf([], "widest")).toBeUndefined();
  });

  it("say what is proven only where no path can be better", () => {
    const of = (length: number, cost: number, directionChanges: number): HybridPlan =>
      ({ metrics: { length, cost, directionChanges, rsBound: 20 } }) as HybridPlan;
    const said = (one: HybridPlan): boolean[] =>
      ([undefined, "shortest", "fewest-changes", "widest", "fastest"] as const).map((prefer) => isProven(one, prefer));
    expect(said(of(20, 20, 0))).toEqual([true, true, true, false, false]);
    expect(said(of(20, 21, 1))).toEqual([false, true, false, false, false]);
    expect(said(of(20.1, 20.1, 0))).toEqual([false, false, false, false, false]);
  });

  it("are four at most", () => {
    const choices = choicesOf(plan(30, 3, 0.1, 30), [
      plan(20, 3, 0.1, 30),
      plan(40, 0, 0.1, 40),
      plan(41, 3, 0.9, 40),
      plan(42, 2, 0.3, 12),
    ]);
    expect(choices.map(({ plan: { metrics } }) => metrics.length)).toEqual([20, 30, 40, 41]);
  });
});
