import { beforeAll, describe, expect, it } from "vitest";
import { init, paperParkingRows, Planner, scenario, type Plan, type PlannerId } from "parkade";
import { CASES, PRINTED } from "../../www/src/panels/cases";

const solved = new Map<string, Plan>();

function answer(planner: PlannerId, scene: string): Plan {
  const key = `${planner} ${scene}`;
  if (!solved.has(key)) {
    const one = new Planner(planner, scenario(scene));
    solved.set(key, one.plan());
    one.free();
  }
  return solved.get(key)!;
}

const expanded = (planner: PlannerId, scene: string): number => answer(planner, scene).stats.expanded;
const metres = (planner: PlannerId, scene: string): number => answer(planner, scene).metrics.length;

/** What the questions take for granted. */
const CLAIMS: Record<string, () => boolean> = {
  "four worst": () => metres("four", "parallel") > 1.2 * metres("eight", "parallel"),
  "eight worst": () => expanded("eight", "P0") > 1000 && !answer("eight", "P0").check.drivable,
  "sixteen best": () => 10 * expanded("sixteen", "L4") < expanded("eight", "L4"),
  "sixteen worst": () => expanded("sixteen", "reverse-in") > 500,
  "twenty-four best": () => expanded("twenty-four", "L4") < 50 && Math.abs(metres("twenty-four", "L4") - 19) < 0.5,
  "twenty-four worst": () => expanded("twenty-four", "regular-60") > 0.9 * expanded("sixteen", "regular-60"),
  "forty-eight best": () => metres("forty-eight", "L4") < metres("twenty-four", "L4") && metres("forty-eight", "L4") > 0.99 * metres("twenty-four", "L4"),
  "sixteen-bidirectional best": () => 2 * expanded("sixteen-bidirectional", "reverse-in") < expanded("sixteen", "reverse-in"),
  "jump-point best": () => expanded("jump-point", "L4") === 2 && Math.abs(metres("jump-point", "L4") - 20) < 0.5,
  "jump-point worst": () => expanded("jump-point", "regular-60") > 50,
  "any-angle best": () => metres("any-angle", "P3") < 1.005 * Math.hypot(18, 13),
  "risk-field best": () => 20 * expanded("risk-field", "P4") < expanded("eight", "P4"),
  "risk-field worst": () => answer("risk-field", "narrow-gap").outcome === "no-path",
  "risk-field-plus best": () => expanded("risk-field-plus", "P4") === 1,
  "risk-field-plus worst": () => expanded("risk-field-plus", "trap-60") > expanded("risk-field", "trap-60"),
  "hybrid worst": () => answer("hybrid", "par-7.2").metrics.directionChanges > 5,
  "hybrid-forward best": () => expanded("hybrid-forward", "L3") === 1,
  "hybrid-forward worst": () => expanded("hybrid-forward", "perp-nose-3.2") > 10_000,
  "hybrid-bidirectional best": () => expanded("hybrid-bidirectional", "perp-nose-3.2") < 50 && expanded("hybrid-forward", "perp-nose-3.2") > 10_000,
  "hybrid-bidirectional worst": () => expanded("hybrid-bidirectional", "par-7.2") > expanded("hybrid", "par-7.2"),
  "hybrid-classic best": () => expanded("hybrid-classic", "L3") === 1,
  "hybrid-classic worst": () => answer("hybrid-classic", "regular-60").outcome === "no-path",
  "cost-map best": () => answer("cost-map", "road-crossing").check.verdict === "ok",
  "cost-map worst": () => !answer("cost-map", "reverse-in").check.drivable,
};

beforeAll(() => init());

describe("best and worst cases", () => {
  for (const [planner, { best, worst }] of CASES) {
    it(`${planner} does what its captions say`, () => {
      for (const [which, claim] of Object.entries(CLAIMS)) {
        if (which.split(" ")[0] === planner) expect(claim(), which).toBe(true);
      }
      const { verdict } = answer(planner, best.scene).check;
      expect(verdict !== "none" && (verdict !== "collides" || /does the car fit/.test(best.question[0])), `${best.scene}: ${verdict}`).toBe(true);
      expect(worst.scene).not.toBe(best.scene);
    }, 60_000);
  }

  it("claims are made of planners that have cases", () => {
    expect(Object.keys(CLAIMS).filter((key) => !CASES.some(([planner]) => planner === key.split(" ")[0]))).toEqual([]);
  });
});

it("a paper row's caption has the printed numbers, each its own", () => {
  expect(PRINTED).toEqual(Object.fromEntries(paperParkingRows().map(({ id, traditional, improved }) => [id, [traditional.length, traditional.changes, improved.length, improved.changes]])));
});
