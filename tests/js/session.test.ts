import { init, Planner, scenario, type Pose } from "parkade";
import * as core from "parkade/core";
import { beforeAll, describe, expect, it } from "vitest";

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
    expect(() => planner.plan({ gaol: start } as object)).toThrow(/there are trace, start, goal/);
  });

  it("searches alone, with the plan's raw path", () => {
    const scene = scenario("trap-60");
    for (const id of ["four", "eight", "forty-eight", "sixteen-bidirectional", "jump-point", "any-angle"] as const) {
      const planner = new Planner(id, scene);
      const route = planner.search(scene.start, goalOf("trap-60"));
      const plan = planner.plan();
      expect([route.outcome, route.costMicro, route.expanded, route.generated]).toEqual(
        [plan.outcome, plan.stats.costMicro, plan.stats.expanded, plan.stats.generated]);
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
