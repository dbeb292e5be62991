import { generateScenario, init, Planner, scenario, type PlannerId, type Pose, type Scenario } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";
import { core } from "./core";

beforeAll(() => Promise.all([init(), core.init()]));

const goalOf = (id: string): Pose => scenario(id).goal as Pose;

describe("a planner used again", () => {
  it("plans between other poses and refuses what is none", () => {
    const scene = scenario("random-60");
    const planner = new Planner("eight", scene);
    const own = planner.plan().hash;
    const start = { x: goalOf("random-60").x, y: goalOf("random-60").y, heading: 0 };
    const back = planner.plan({ start, goal: scene.start });
    expect(back.hash).toBe(new Planner("eight", { ...scene, start, goal: scene.start }).plan().hash);
    expect(planner.plan().hash).toBe(own);
    expect(() => planner.plan({ start: { x: 0, y: 0 } as Pose })).toThrow(/start\.heading: missing field/);
    expect(() => planner.plan({ goal: { x: 0, y: Number.NaN, heading: 0 } })).toThrow(/goal\.y/);
    expect(() => planner.plan({ gaol: start } as object)).toThrow(
      /there are trace, traceLimit, start, goal, onProgress/,
    );
  });

  it("searches alone, with the plan's raw path", () => {
    const scene = scenario("trap-60");
    for (const id of ["four", "eight", "forty-eight", "sixteen-bidirectional", "jump-point", "any-angle"] as const) {
      const planner = new Planner(id, scene);
      const route = planner.search(scene.start, goalOf("trap-60"));
      const plan = planner.plan();
      expect([route.outcome, route.costMicro, route.expanded, route.generated]).toEqual([
        plan.outcome,
        plan.stats.costMicro,
        plan.stats.expanded,
        plan.stats.generated,
      ]);
      expect(route.path).toEqual(plan.rawPath);
      expect(planner.search({ x: -9, y: 0 }, scene.start).outcome).toBe("start-outside");
      expect(() => planner.search({ x: 0, y: Number.NaN }, scene.start)).toThrow(/start\.y/);
      expect(() => planner.search(scene.start, undefined as never)).toThrow(/goal\.x/);
    }
    expect(() => new Planner("hybrid", scene).search(scene.start, scene.start)).toThrow(/has no bare search/);
    expect(() => new core.Planner("eight", scene).search(scene.start, scene.start)).toThrow(/not in parkade\/core/);
  });

  it("takes a brush and gives it back", () => {
    const scene = scenario("random-60");
    const planner = new Planner("eight", scene);
    const before = planner.plan().hash;
    const clear = Array.from(planner.layer("occupancy").data).indexOf(0, 60 * 30);
    const [x, y] = [clear % 60, Math.floor(clear / 60)];
    planner.brush([[x, y, 1]], true);
    expect(planner.layer("occupancy").data[clear]).toBe(1);
    planner.brush([[x, y, 1]], false);
    expect(planner.plan().hash).toBe(before);
    expect(() => planner.brush([[59, 0, 2]], true)).toThrow(/runs\[0\]/);
    expect(() => planner.brush([[0.5, 0, 2]], true)).toThrow(/runs\[0\]/);
    expect(() => planner.brush([[0, 0]] as never, true)).toThrow(/runs/);
    expect(() => planner.brush([[0, 0, 1]], 1 as never)).toThrow(/blocked/);
  });

  it("closes redundant space as asked and says how much", () => {
    const planner = new Planner("eight", scenario("trap-60"), { minPassage: 2, trapMouth: 5 });
    const { narrow = 0, pocket = 0, restored = 0 } = planner.plan().stats;
    const closed = Array.from(planner.layer("redundant").data).filter((v) => v === 3).length;
    expect(closed).toBe(narrow + pocket - restored);
  });
});

/** Long searches: no way through noise, and a tight slot. */
function slow(): Map<PlannerId, Scenario> {
  const noise = generateScenario({ family: "random", size: 400, seed: 7, densityPermille: 250, blockMax: 1 });
  const wall: Scenario = {
    ...noise,
    obstacles: [...noise.obstacles!, { type: "cells", runs: Array.from({ length: 400 }, (_, y) => [300, y, 1]) }],
  };
  const tight: Scenario = { ...scenario("par-8.0"), planners: { hybrid: { maxExpansions: 1500 } } };
  return new Map([
    ["eight", wall],
    ["risk-field", wall],
    ["hybrid", tight],
  ]);
}

describe.each([
  ["parkade", { Planner }],
  ["parkade/core", core],
])("a plan's progress, in %s", (_, api) => {
  it("is told at fixed counts and at the search's end, of a plan that stays the same", () => {
    for (const [id, scene] of slow()) {
      const every = id === "hybrid" ? 256 : 16_384,
        planner = new api.Planner(id, scene),
        told: number[] = [];
      const plan = planner.plan({ onProgress: (expansions) => told.push(expansions) });
      expect(told.length).toBeGreaterThan(2);
      const { expanded } = plan.stats;
      expect(told).toEqual([
        ...Array.from({ length: Math.floor(expanded / every) }, (_, k) => every * (k + 1)),
        expanded,
      ]);
      expect(planner.plan({ onProgress: undefined }).hash).toBe(plan.hash);
      planner.free();
    }
  });

  it("ends where its function throws: the same error comes out, and the planner plans on", () => {
    for (const [id, scene] of slow()) {
      const planner = new api.Planner(id, scene),
        own = planner.plan().hash,
        error = new RangeError("enough");
      for (const thrown of [error, undefined]) {
        let times = 0;
        const caught = ((): unknown => {
          try {
            return planner.plan({
              onProgress: () => {
                times++;
                throw thrown;
              },
            });
          } catch (reason) {
            return { reason };
          }
        })();
        expect(times).toBe(1);
        expect(caught).toEqual({ reason: thrown });
        expect(planner.plan().hash).toBe(own);
      }
      planner.free();
    }
  });

  it("cannot use its own planner, but others", () => {
    const tight = slow().get("hybrid")!,
      planner = new api.Planner("hybrid", tight),
      own = planner.plan().hash;
    const other = new api.Planner("eight", scenario("perpendicular")),
      outcomes = new Set<string>();
    for (const use of [() => planner.plan(), () => planner.layer("occupancy"), () => planner.free()]) {
      expect(() => planner.plan({ onProgress: use })).toThrow(
        expect.objectContaining({
          name: "ParkadeError",
          code: "bad-input",
          message: expect.stringContaining("is planning"),
        }),
      );
    }
    const plan = planner.plan({ onProgress: () => outcomes.add(other.plan().outcome) });
    expect([plan.hash, [...outcomes]]).toEqual([own, ["found"]]);
    for (const wrong of [null, 1, "log", {}]) {
      expect(() => planner.plan({ onProgress: wrong as never })).toThrow(
        expect.objectContaining({ code: "bad-input", path: "onProgress" }),
      );
    }
  });
});
