/** The planners' ids and settings: written by `cargo xtask build` from the planners' registry. */

export type GridPlannerId = "four" | "eight" | "risk-field";
export type HybridPlannerId = "hybrid" | "hybrid-forward";

export type PlannerId = GridPlannerId | HybridPlannerId;

/** Settings of every grid planner. */
export interface GridSettings {
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
  /** Keeps the path this far from obstacles: nothing, half the car's width, half its diagonal. Default: "none". */
  inflation?: "none" | "width" | "half-diagonal";
  /** Added to the safety space. Usual range: 0 to 2 m. Default: 0. */
  margin?: number;
  /** Removes spare cells; rounds corners. */
  post?: "none" | "prune" | "prune-dp" | "smooth";
  /** Dynamic shrinks an arc until it is free; the paper tries once. Default: "dynamic". */
  smoothMode?: "dynamic" | "paper";
  /** Arcs tighter than this stay corners; "vehicle" is the car's own limit. Usual range: 0 to 40 cells. Default: 1. */
  minRadius?: number | "vehicle";
  /** Stops after this many. Usual range: 1 to 100000000. Default: 20000000. */
  maxExpansions?: number;
  /** Nothing else in this module. */
  minPassage?: 1;
  /** Nothing else in this module. */
  trapMouth?: 1;
}

export interface FourSettings extends GridSettings {
  /** The paper's baseline uses Manhattan. Default: "manhattan". */
  heuristic?: "manhattan" | "euclid" | "octile";
  /** Faster far from the goal, but not optimal. Default: "none". */
  weight?: "none" | "distance";
}

export interface EightSettings extends GridSettings {
  /** Octile is exact on an empty map, so it expands less. Default: "euclid". */
  heuristic?: "euclid" | "octile";
  /** Faster far from the goal, but not optimal. Default: "none". */
  weight?: "none" | "distance";
}

export interface RiskFieldSettings extends GridSettings {
  /** Of the longer axis distance to the goal. Usual range: 0.5 to 4. Default: 2. */
  w1?: number;
  /** Of the shorter one. Usual range: 0.5 to 4. Default: 1. */
  w2?: number;
  /** How strongly goal distance speeds up the search; paper: 1. Usual range: 0 to 4. Default: 1. */
  wbar?: number;
  /** Corrected removes the printed formula's jump. Default: "corrected". */
  heuristic?: "corrected" | "printed" | "octile";
  /** Attraction gain. Usual range: 0.1 to 10. Default: 1. */
  k1?: number;
  /** Obstacles farther away do not repel. Usual range: 1 to 10 cells. Default: 3. */
  rho0?: number;
  /** Repulsion gain; empty: half of k1 times the distance. Usual range: 0 to 1000 cells. Default: null. */
  k2?: number | null;
  /** Linear grows with the distance (the paper). Default: "linear". */
  attraction?: "linear" | "conic";
  /** The nearest, or all within reach. Default: "nearest-mean". */
  obstacleSet?: "nearest-mean" | "nearest-first" | "sum";
  /** How far diagonal moves may be stretched. Usual range: 0 to 16 cells. Default: 1. */
  extLen?: number;
  /** Drops extensions that lead away from the goal. Default: false. */
  goalSide?: boolean;
  /** When the other five directions are tried; none: as in the paper, may get stuck. Default: "penalty". */
  fallback?: "penalty" | "lexicographic" | "stuck-only" | "none";
  /** Cost added to deferred moves. Usual range: 0 to 40 cells. Default: 4. */
  penalty?: number;
  /** Finishes as soon as the goal is in sight. Default: false. */
  goalShot?: boolean;
}

/** Settings of every hybrid planner. */
export interface HybridSettings {
  /** Kept free around the whole car. Usual range: 0 to 0.5 m. Default: 0.1. */
  margin?: number;
  /** Gear changes allowed in the final curve. Usual range: 0 to 5. Default: 3. */
  maxDirectionChanges?: number;
  /** Short steps fit tight slots but take longer. Usual range: 0.1 to 4 m. Default: null. */
  motionPrimitiveLength?: number | null;
  /** Closer headings count as one state. Usual range: 0.01 to 0.35 rad. Default: null. */
  headingResolution?: number | null;
  /** Extra metres accepted to avoid one gear change. Usual range: 0 to 10 m. Default: 1. */
  directionChangeCost?: number;
  /** Leaving a slot is easier than finding it. */
  searchFrom?: "goal" | "start";
  /**
   * Practical avoids long reversing and many gear changes; comfort and classic replace the costs below. Default:
   * "practical".
   */
  profile?: "practical" | "shortest" | "comfort" | "classic";
  /** Cost of a metre in reverse. Usual range: 1 to 5. Default: 1. */
  reverseCost?: number;
  /** Closer positions count as one state. Usual range: 0.05 to 2 m. Default: null. */
  xyResolution?: number | null;
  /** Per side, besides straight. Usual range: 1 to 10. Default: null. */
  steerSamples?: number | null;
  /** Max: the larger of the free-space curve and the way around obstacles. Default: "max". */
  heuristic?: "max" | "reeds-shepp" | "euclid";
  /** Above 1: faster, not always cheapest. Usual range: 0.5 to 5. Default: null. */
  heuristicWeight?: number | null;
  /** Cost of turning. Usual range: 0 to 5. Default: 0. */
  steerCost?: number;
  /** Cost of turning the wheel. Usual range: 0 to 5 m. Default: 0. */
  steerChangeCost?: number;
  /** Cost of driving close to obstacles. Usual range: 0 to 10. Default: 0. */
  obstacleCost?: number;
  /** Distance where that cost begins. Usual range: 0.1 to 3 m. Default: 0.5. */
  obstacleDistance?: number;
  /** Shortens the finished path with curves. Default: true. */
  shortcut?: boolean;
  /** Stops at the first path found (the paper). Default: false. */
  firstShot?: boolean;
  /** Tries finer steps if coarse ones fail. Default: true. */
  ladder?: boolean;
  /** 5 and 6: very tight spaces, many gear changes. Usual range: 0 to 6. Default: 6. */
  finestLevel?: number;
  /** Stops after this many. Usual range: 1 to 10000000. Default: null. */
  maxExpansions?: number | null;
}

/** The settings of each planner, all of them optional. */
export interface PlannerSettings {
  four: FourSettings;
  eight: EightSettings;
  "risk-field": RiskFieldSettings;
  hybrid: HybridSettings;
  "hybrid-forward": HybridSettings;
}
