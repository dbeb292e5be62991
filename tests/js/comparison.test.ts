import { beforeAll, describe, expect, it } from "vitest";
import { collisionRisk, driveEnvelope, init, Planner, roadFigures, scenario, type RoadPlan } from "parkade";
import { bandPicture } from "../../www/src/picture/band";
import { smallMultiples } from "../../www/src/picture/small-multiples";
import {
  changes,
  COMPARED,
  compare,
  envelope,
  judged,
  PRINTED_CHANGES,
  SEEDS,
  sweep,
  SWEPT,
  type Compared,
  type Engine,
  type Swept,
} from "../../www/src/planning/comparison";
import { chartsOf, claimOf, foundOf } from "../../www/src/texts/comparison";

const ENGINE: Engine = { Planner, scenario, collisionRisk, driveEnvelope };
/** Different each time, as a loaded machine's. */
let clock = 0;

beforeAll(() => init());

const compared = (scene: string, planner: string, length: number | null, expanded: number): Compared => ({
  scene,
  planner: planner as Compared["planner"],
  asked: SEEDS,
  found: length === null ? 0 : SEEDS,
  collide: 0,
  length: length === null ? null : [length, length, length + (planner === "genetic" ? 1 : 0)],
  turning: null,
  clearance: null,
  hits: null,
  expanded: [expanded, expanded, expanded],
});
const all = (rrt: number | null): Compared[] =>
  ["a", "b"].flatMap((scene) => [
    compared(scene, "cost-map", 100, 50),
    compared(scene, "dijkstra", 99, 80),
    compared(scene, "rrt", scene === "a" ? rrt : 120, 10),
    compared(scene, "genetic", 101, 20_000),
  ]);

describe("the comparison with other algorithms", () => {
  it("gives a random planner all seeds, and the others one answer", () => {
    const tree = compare(ENGINE, "fig8-60", "rrt"),
      star = compare(ENGINE, "fig8-60", "eight");
    expect([tree.asked, star.asked, star.found]).toEqual([SEEDS, 1, 1]);
    expect(tree.length![2]).toBeGreaterThan(tree.length![1]);
    // The same safety space: the scene's, which it has for eight neighbours.
    const dijkstra = compare(ENGINE, "fig8-60", "dijkstra");
    expect(dijkstra.length![0]).toBeCloseTo(star.length![0], 9);
    expect(dijkstra.expanded[0]).toBeGreaterThan(star.expanded[0]);
  });

  it("says how a path turns and what hits it as the package does", () => {
    const ours = compare(ENGINE, "road-narrow", "cost-map"),
      planner = new Planner("cost-map", scenario("road-narrow")),
      plan = planner.plan();
    planner.free();
    expect(ours.length![0]).toBe(plan.metrics.length);
    expect(ours.clearance![0]).toBe(plan.metrics.minClearance);
    expect(ours.hits).toBe(collisionRisk(scenario("road-narrow"), plan).hits);
    expect(ours.turning![0]).toBeGreaterThan(90);
    expect(ours.collide).toBe(0);
  });
});

it("claims depend on no clock", () => {
  expect(judged(all(120)).map(({ id, holds }) => [id, holds])).toEqual([
    ["RRT", "yes"],
    ["Dijkstra", "yes"],
    ["genetic", "yes"],
  ]);
  // No path at all is worse than any; a shorter one is not.
  expect(judged(all(null))[0]).toMatchObject({ holds: "yes", found: { least: 0 } });
  expect(judged(all(90))[0]).toMatchObject({ holds: "partly", found: { longer: 1, scenes: 2 } });
  const slow = all(120).map((one) => ({ ...one, milliseconds: (clock += 17) }));
  expect(judged(slow)).toEqual(judged(all(120)));
  for (const claim of judged(all(90))) {
    for (const words of [claimOf("en", claim), foundOf("en", claim)]) expect(words).not.toMatch(/[{}]/);
    expect(foundOf("zh", claim)).toMatch(/[\u4e00-\u9fff]/);
  }
});

describe("sensitivity", () => {
  it("has the default among the values of every setting, where it is the default's plan", () => {
    const planner = new Planner("cost-map", scenario("road-narrow")),
      plan = planner.plan() as RoadPlan;
    planner.free();
    for (const swept of ["alpha", "margin", "resolution"] as const) {
      const samples = sweep(ENGINE, "road-narrow", swept);
      expect(samples.map(({ value }) => value)).toEqual(SWEPT[swept].values);
      const same = samples.filter(({ figures }) => figures.length === plan.metrics.middleLength);
      expect(same.length, swept).toBeGreaterThan(0);
      expect(same[0]!.figures.lane).toBe(roadFigures(scenario("road-narrow"), plan).laneDeviationMean);
    }
  });

  it("knows the direction of the strongest settings", () => {
    const lanes = sweep(ENGINE, "road-curve", "alpha").map(({ figures }) => figures.lane);
    expect(lanes.at(-1)!).toBeLessThan(lanes[0]!);
    const cells = sweep(ENGINE, "road-narrow", "resolution").map(({ figures }) => figures.expanded);
    expect(cells[0]!).toBeGreaterThan(2 * cells[1]!);
    expect(cells[1]!).toBeGreaterThan(cells[2]!);
  });

  it("gives changes in percent of the middle value, and none where a path is missing", () => {
    const figures = (bending: number) => ({ length: 1, clearance: 1, lane: 1, bending, expanded: 1 });
    const samples = [
      { value: 0.6, verdict: "ok" as const, figures: figures(3) },
      { value: 0.8, verdict: "ok" as const, figures: figures(2) },
      { value: 1, verdict: "ok" as const, figures: figures(1) },
    ];
    const threshold = PRINTED_CHANGES.find(({ swept }) => swept === "threshold")!;
    expect(changes(samples, threshold)).toEqual([50, -50]);
    expect(changes(samples.slice(1), threshold)).toBeNull();
    expect(changes([...samples.slice(0, 2), { ...samples[2]!, figures: figures(Number.NaN) }], threshold)).toBeNull();
  });

  it("is drawn as a chart for each setting and figure, with a line for each scene", () => {
    const sweeps = (Object.keys(SWEPT) as Swept[]).flatMap((swept) =>
      ["one", "two"].map((scene, i) => ({
        swept,
        scene,
        samples: SWEPT[swept].values.map((value) => ({
          value,
          verdict: "ok" as const,
          figures: { length: value + i, clearance: i, lane: Number.NaN, bending: value * i, expanded: 1000 * value },
        })),
      })),
    );
    const svg = smallMultiples(chartsOf("en", sweeps), "all");
    const settings = Object.keys(SWEPT).length;
    // Four of five figures have numbers: two lines each.
    expect(svg.match(/<polyline/g)!.length).toBe(settings * 4 * 2);
    expect(svg.match(/>–</g)!.length).toBe(settings);
    expect(svg).not.toContain("NaN");
  });
});

describe("the band of 1000 drives", () => {
  it("holds the path, is at most a metre to each side, and grows with the drives", () => {
    const scene = scenario("road-narrow"),
      band = envelope(ENGINE, "road-narrow");
    expect(band.length % 4).toBe(0);
    expect(band.length / 4).toBeGreaterThan(450);
    const widths = (points: Float64Array): number[] =>
      Array.from({ length: points.length / 4 }, (_, i) =>
        Math.hypot(points[4 * i]! - points[4 * i + 2]!, points[4 * i + 1]! - points[4 * i + 3]!),
      );
    for (const width of widths(band)) {
      expect(width).toBeGreaterThan(0.5);
      expect(width).toBeLessThanOrEqual(2.0001);
    }
    const planner = new Planner("cost-map", scene),
      plan = planner.plan();
    planner.free();
    const few = widths(driveEnvelope(scene, plan, { trials: 20 }));
    expect(few.every((width, i) => width <= widths(band)[i]! + 1e-9)).toBe(true);
    expect(bandPicture(scene, band, "road-narrow", 10).match(/<polygon/g)!.length).toBe(4);
  });
});

it("compares planners that there are, on scenes that there are", () => {
  for (const { scenes, planners } of Object.values(COMPARED)) {
    expect(planners.length).toBe(6);
    for (const scene of scenes) expect(() => scenario(scene)).not.toThrow();
  }
});
