import type { Plan, PlannerId, RoadPlan, Scenario } from "parkade";
import { lastIn, nth } from "../scene/nth";

/** The functions that are called; the page's worker and the documentation have them from different builds. */
export interface Engine {
  Planner: new (
    planner: PlannerId,
    scene: Scenario,
    settings?: Record<string, unknown>,
  ) => { plan(options: { trace: boolean }): Plan; free(): void };
  scenario(id: string): Scenario;
  collisionRisk(scene: Scenario, plan: { path: Float64Array }): { hits: number };
  driveEnvelope(scene: Scenario, plan: { path: Float64Array }): Float64Array;
}

/** Scenes and, in each, the planners that are compared; ours comes first. */
export const COMPARED = {
  grid: {
    scenes: ["fig8-60", "fig9-60"],
    planners: ["risk-field", "eight", "dijkstra", "greedy", "rrt", "genetic"],
  },
  road: {
    scenes: ["road-straight", "road-curve", "road-crossing", "road-narrow"],
    planners: ["cost-map", "eight", "dijkstra", "greedy", "rrt", "genetic"],
  },
} as const satisfies Record<string, { scenes: readonly string[]; planners: readonly PlannerId[] }>;

/** Planners that are asked with several seeds. */
const SEEDED: readonly PlannerId[] = ["rrt", "genetic"];
export const SEEDS = 5;

/** A planner in a scene: of each figure the median over its paths, then the least and the largest. */
export interface Compared {
  scene: string;
  planner: PlannerId;
  /** Answers, and those with a path. */
  asked: number;
  found: number;
  /** Paths whose body overlaps an obstacle. */
  collide: number;
  /** Metres. */
  length: Span | null;
  /** Degrees turned, all corners together. */
  turning: Span | null;
  /** Metres between the body and the nearest obstacle where it is least. */
  clearance: Span | null;
  /** Of 1,000 simulated drives with random offsets, those that collide; of the first path. */
  hits: number | null;
  expanded: Span;
}
export type Span = readonly [median: number, least: number, most: number];

/** Grid planners keep half the car's width, or what the scene has for eight neighbours: the same for all. */
const SAFETY: Record<string, unknown> = { inflation: "width" };
/** The planner for roads has a margin of its own. */
const [FOR_ROADS] = COMPARED.road.planners;
const settingsOf = ({ planners }: Scenario, planner: PlannerId): Record<string, unknown> =>
  planner === FOR_ROADS ? {} : { ...SAFETY, ...(planners?.[planner] ?? planners?.eight) };

export function compare(engine: Engine, id: string, planner: PlannerId): Compared {
  const scene = engine.scenario(id),
    seeds = SEEDED.includes(planner) ? Array.from({ length: SEEDS }, (_, i) => i + 1) : [0];
  const plans = seeds.map((seed) =>
    planned(engine, planner, scene, {
      ...settingsOf(scene, planner),
      ...(seed > 0 && { seed }),
    }),
  );
  const paths = plans.filter(({ outcome }) => outcome === "found");
  const over = (of: (plan: Plan) => number): Span | null => (paths.length === 0 ? null : span(paths.map(of)));
  return {
    scene: id,
    planner,
    asked: plans.length,
    found: paths.length,
    collide: paths.filter(({ check }) => check.verdict === "collides").length,
    length: over(({ metrics }) => metrics.length),
    turning: over(turned),
    clearance: over(({ metrics }) => metrics.minClearance),
    hits: paths.length === 0 ? null : engine.collisionRisk(scene, { path: nth(paths, 0).path }).hits,
    expanded: span(plans.map(({ stats }) => stats.expanded)),
  };
}

/** Degrees that the heading turns along a path. */
function turned({ path }: Plan): number {
  let sum = 0;
  for (let i = 5; i < path.length; i += 3) {
    const turn = nth(path, i) - nth(path, i - 3);
    sum += Math.abs(turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));
  }
  return (sum * 180) / Math.PI;
}

function span(values: readonly number[]): Span {
  const sorted = [...values].sort((a, b) => a - b),
    middle = sorted.length >> 1;
  const median = sorted.length % 2 === 1 ? nth(sorted, middle) : (nth(sorted, middle - 1) + nth(sorted, middle)) / 2;
  return [median, nth(sorted, 0), lastIn(sorted)];
}

/** The band of 1000 drives along the cost map's path. */
export function envelope(engine: Engine, id: string): Float64Array {
  const scene = engine.scenario(id);
  return engine.driveEnvelope(scene, planned(engine, FOR_ROADS, scene, {}));
}

function planned(engine: Engine, planner: PlannerId, scene: Scenario, settings: Record<string, unknown>): Plan {
  const made = new engine.Planner(planner, scene, settings);
  try {
    return made.plan({ trace: false });
  } finally {
    made.free();
  }
}

/** Settings of the cost map and the values that each is given; one at a time, the others at their defaults. */
export const SWEPT = {
  alpha: { setting: "laneWeight", values: [0, 0.15, 0.3, 0.6, 1.2, 2.4] },
  beta: { setting: "kerbWeight", values: [0, 0.25, 0.5, 1, 2] },
  factor: { setting: "factor", values: [0.4, 0.64, 0.8, 0.96, 1.6] },
  epsilon: { setting: "epsilon", values: [0.05, 0.1, 0.2, 0.4, 0.8] },
  decay: { setting: "decay", values: [0.75, 1.2, 1.5, 1.8, 3], base: "exponential" },
  margin: { setting: "margin", values: [0, 0.2, 0.4, 0.8, 1.2] },
  threshold: { setting: "pruneShare", values: [0.6, 0.8, 1] },
  resolution: { setting: "", values: [0.5, 1, 1.5] },
} as const satisfies Record<string, { setting: string; values: readonly number[]; base?: string }>;
export type Swept = keyof typeof SWEPT;
export const SWEPT_SCENES = ["road-curve", "road-crossing", "road-narrow"] as const;

/** A path of the cost map at one value of a setting. */
export interface Sample {
  value: number;
  /** The independent check's. */
  verdict: Plan["check"]["verdict"];
  figures: Record<(typeof MEASURED)[number], number>;
}
/** Metres but for the change of curvature, 1/m, and the cells expanded. */
export const MEASURED = ["length", "clearance", "lane", "bending", "expanded"] as const;

/** Plans a scene at every value of a setting. */
export function sweep(engine: Engine, id: string, swept: Swept): Sample[] {
  const scene = engine.scenario(id),
    one: { setting: string; values: readonly number[]; base?: string } = SWEPT[swept];
  return one.values.map((value) => {
    const plan = planned(engine, FOR_ROADS, swept === "resolution" ? finer(scene, value) : scene, {
      ...(one.base && { base: one.base }),
      ...(one.setting && { [one.setting]: value }),
    }) as RoadPlan;
    const { metrics, stats, check } = plan;
    return {
      value,
      verdict: check.verdict,
      figures: {
        length: metrics.middleLength ?? Number.NaN,
        clearance: metrics.bodyClearanceMin ?? Number.NaN,
        lane: metrics.laneDeviationMean ?? Number.NaN,
        bending: metrics.curvatureVariation ?? Number.NaN,
        expanded: stats.expanded,
      },
    };
  });
}

/** The same scene on cells that are `factor` times as large. */
function finer(scene: Scenario, factor: number): Scenario {
  const { map } = scene,
    cells = (count: number): number => Math.ceil(count / factor);
  return {
    ...scene,
    map: { ...map, resolution: map.resolution * factor, width: cells(map.width), height: cells(map.height) },
  };
}

/** How far a figure leaves its value at the default over two values beside it, percent: the manuscript's measure. */
export const PRINTED_CHANGES = [
  { swept: "factor", values: [0.64, 0.8, 0.96], printed: [20, 15], figure: "clearance" },
  { swept: "resolution", values: [0.5, 1, 1.5], printed: [50, 30], figure: "expanded" },
  { swept: "threshold", values: [0.6, 0.8, 1], printed: [25, 20], figure: "bending" },
] as const satisfies readonly {
  swept: Swept;
  values: readonly [number, number, number];
  printed: readonly [number, number];
  figure: (typeof MEASURED)[number];
}[];

/**
 * Percent of the middle one of three values by which the one below and the one above change a figure; null without a
 * path.
 */
export function changes(
  samples: readonly Sample[],
  { values, figure }: (typeof PRINTED_CHANGES)[number],
): [number, number] | null {
  const [below, middle, above] = values.map((value) => samples.find((one) => one.value === value)?.figures[figure]);
  if (below === undefined || middle === undefined || above === undefined) return null;
  const change = (to: number): number => (100 * (to - middle)) / middle;
  const both: [number, number] = [change(below), change(above)];
  return both.every(Number.isFinite) ? both : null;
}

/** A claim of section 4.4.2 and what is found; the verdicts depend on counts and lengths, on no clock. */
export interface ComparedClaim {
  id: "RRT" | "Dijkstra" | "genetic";
  holds: "yes" | "partly" | "no";
  found: Record<string, number>;
}

/** Judges the manuscript's comparison on all scenes. */
export function judged(all: readonly Compared[]): ComparedClaim[] {
  const scenes = [...new Set(all.map(({ scene }) => scene))];
  const of = (scene: string, planner: PlannerId): Compared =>
    all.find((one) => one.scene === scene && one.planner === planner)!;
  const ours = (scene: string): Compared => all.find((one) => one.scene === scene)!;
  const count = (holds: (scene: string) => boolean): number => scenes.filter(holds).length;
  const verdict = (...parts: number[]): ComparedClaim["holds"] =>
    parts.every((part) => part === scenes.length) ? "yes" : parts.every((part) => part === 0) ? "no" : "partly";
  /** True if ours has a path and the other has none, or a longer one. */
  const better = (scene: string, planner: PlannerId): boolean => {
    const [mine, other] = [ours(scene).length, of(scene, planner).length];
    return mine !== null && (other === null || other[0] > mine[0]);
  };
  const rrt = count((scene) => better(scene, "rrt")),
    least = Math.min(...scenes.map((scene) => of(scene, "rrt").found)),
    fewer = count((scene) => ours(scene).expanded[0] < of(scene, "dijkstra").expanded[0]),
    alike = count((scene) => {
      const [a, b] = [ours(scene).length, of(scene, "dijkstra").length];
      return a !== null && b !== null && a[0] <= 1.03 * b[0];
    });
  const varied = count((scene) => {
    const { length, found, asked } = of(scene, "genetic");
    return found < asked || (length !== null && length[2] > length[1]);
  });
  return [
    { id: "RRT", holds: verdict(rrt), found: { longer: rrt, scenes: scenes.length, least, seeds: SEEDS } },
    { id: "Dijkstra", holds: verdict(fewer, alike), found: { fewer, alike, scenes: scenes.length } },
    { id: "genetic", holds: verdict(varied), found: { varied, scenes: scenes.length, seeds: SEEDS } },
  ];
}
