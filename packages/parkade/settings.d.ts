/** The planners' ids and settings: written by `cargo xtask build` from the planners' registry. */

export type GridPlannerId =
  | "four"
  | "eight"
  | "sixteen"
  | "twenty-four"
  | "forty-eight"
  | "sixteen-bidirectional"
  | "jump-point"
  | "any-angle"
  | "risk-field"
  | "risk-field-plus"
  | "dijkstra"
  | "greedy"
  | "rrt"
  | "genetic";
export type HybridPlannerId = "hybrid" | "hybrid-forward" | "hybrid-bidirectional" | "hybrid-classic";
export type RoadPlannerId = "cost-map";

export type PlannerId = GridPlannerId | HybridPlannerId | RoadPlannerId;

/** Settings of every grid planner. */
export interface GridSettings {
  /** Keeps the path this far from obstacles: nothing, half the car's width, half its diagonal. Default: "none". */
  inflation?: "none" | "width" | "half-diagonal";
  /** Added to the safety space. Usual range: 0 to 2 m. Default: 0. */
  margin?: number;
  /**
   * Closes passages narrower than this many cells; 1 closes none. Start and goal stay connected. Usual range: 1 to 8
   * cells. Default: 1.
   */
  minPassage?: number;
  /**
   * Closes dead ends into which no square of this many cells fits; 1 closes none. Usual range: 1 to 16 cells. Default:
   * 1.
   */
  trapMouth?: number;
  /** Removes spare cells; rounds corners. */
  post?: "none" | "prune" | "prune-dp" | "smooth";
  /** Dynamic shrinks an arc until it is free; the paper tries once. Default: "dynamic". */
  smoothMode?: "dynamic" | "paper";
  /** Arcs tighter than this stay corners; "vehicle" is the car's own limit. Usual range: 0 to 40 cells. Default: 1. */
  minRadius?: number | "vehicle";
  /** Stops after this many. Usual range: 1 to 100000000. */
  maxExpansions?: number;
}

export interface FourSettings extends GridSettings {
  /** The paper's baseline uses Manhattan. Default: "manhattan". */
  heuristic?: "manhattan" | "euclid" | "octile" | "chebyshev";
  /** Faster far from the goal, but not optimal. Default: "none". */
  weight?: "none" | "distance";
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

export interface EightSettings extends GridSettings {
  /** Octile is exact on an empty map, so it expands less. Default: "euclid". */
  heuristic?: "euclid" | "octile" | "chebyshev";
  /** Faster far from the goal, but not optimal. Default: "none". */
  weight?: "none" | "distance";
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

export interface SixteenSettings extends GridSettings {
  /** The gauge is exact on an empty map for these moves. Default: "gauge". */
  heuristic?: "euclid" | "gauge" | "chebyshev";
  /** Faster far from the goal, but not optimal. Default: "none". */
  weight?: "none" | "distance";
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

export interface SixteenBidirectionalSettings extends GridSettings {
  /** Cells reachable in one step. */
  neighbours?: "four" | "eight" | "sixteen" | "twenty-four" | "forty-eight";
  /**
   * First: where the two meet; best: the best connection until then; nba: the cheapest path; naive: both take up the
   * same cell (the paper), which can fail. Default: "first".
   */
  stop?: "first" | "best" | "nba" | "naive";
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

export interface JumpPointSettings extends GridSettings {
  /** Expands only cells where an obstacle forces a turn: the same cost from fewer expansions. Default: true. */
  prune?: boolean;
}

export interface AnyAngleSettings extends GridSettings {
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

export interface RiskFieldSettings extends GridSettings {
  /** Of the longer axis distance to the goal. Usual range: 0.5 to 4. Default: 2. */
  w1?: number;
  /** Of the shorter one. Usual range: 0.5 to 4. Default: 1. */
  w2?: number;
  /** How strongly goal distance speeds up the search; paper: 1. Usual range: 0 to 4. */
  wbar?: number;
  /** Corrected removes the printed formula's jump. */
  heuristic?: "corrected" | "printed" | "octile";
  /** Attraction gain. Usual range: 0.1 to 10. Default: 1. */
  k1?: number;
  /** Obstacles farther away do not repel. Usual range: 1 to 10 cells. Default: 3. */
  rho0?: number;
  /** Repulsion gain; empty: half of k1 times the distance. Usual range: 0 to 1000 cells. */
  k2?: number | null;
  /** Linear grows with the distance (the paper). */
  attraction?: "linear" | "conic";
  /** The nearest, or all within reach. Default: "nearest-mean". */
  obstacleSet?: "nearest-mean" | "nearest-first" | "sum";
  /** How far diagonal moves may be stretched. Usual range: 0 to 16 cells. */
  extLen?: number;
  /** Drops extensions that lead away from the goal. */
  goalSide?: boolean;
  /** When the other five directions are tried; none: as in the paper, may get stuck. Default: "penalty". */
  fallback?: "penalty" | "lexicographic" | "stuck-only" | "none";
  /** Cost added to deferred moves. Usual range: 0 to 40 cells. Default: 4. */
  penalty?: number;
  /** Finishes as soon as the goal is in sight. */
  goalShot?: boolean;
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

export interface DijkstraSettings extends GridSettings {
  /** Cells reachable in one step. */
  neighbours?: "four" | "eight" | "sixteen" | "twenty-four" | "forty-eight";
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

export interface RrtSettings extends GridSettings {
  /** The same seed gives the same path. Usual range: 1 to 100. Default: 1. */
  seed?: number;
  /** Longest leg of the tree. Usual range: 1 to 30 cells. Default: 5. */
  step?: number;
  /** Share of the expansions that aim at the goal. Usual range: 0 to 1. Default: 0.1. */
  goalBias?: number;
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

export interface GeneticSettings extends GridSettings {
  /** The same seed gives the same path. Usual range: 1 to 100. Default: 1. */
  seed?: number;
  /** Candidates of a generation. Usual range: 10 to 200. Default: 50. */
  population?: number;
  /** Probability that a child is changed. Usual range: 0 to 1. Default: 0.6. */
  mutation?: number;
  /** Strict: a path may not touch a blocked cell. Default: "strict". */
  corner?: "strict" | "no-squeeze" | "free";
}

/** Settings of every hybrid planner. */
export interface HybridSettings {
  /** Kept free around the whole car. Usual range: 0 to 0.5 m. Default: 0.1. */
  margin?: number;
  /** Gear changes allowed in the final curve. Usual range: 0 to 5. Default: 3. */
  maxDirectionChanges?: number;
  /** Short steps fit tight slots but take longer. Usual range: 0.1 to 4 m. */
  motionPrimitiveLength?: number | null;
  /** Closer headings count as one state. Usual range: 0.01 to 0.35 rad. */
  headingResolution?: number | null;
  /** Extra metres accepted to avoid one gear change. Usual range: 0 to 10 m. Default: 1. */
  directionChangeCost?: number;
  /** Leaving a slot is easier than finding it. */
  searchFrom?: "goal" | "start" | "both";
  /** Practical avoids long reversing and many gear changes; comfort and classic replace the costs below. */
  profile?: "practical" | "shortest" | "comfort" | "classic";
  /** Cost of a metre in reverse. Usual range: 1 to 5. Default: 1. */
  reverseCost?: number;
  /** Closer positions count as one state. Usual range: 0.05 to 2 m. */
  xyResolution?: number | null;
  /** Per side, besides straight. Usual range: 1 to 10. */
  steerSamples?: number | null;
  /** Max: the larger of the free-space curve and the way around obstacles. Default: "max". */
  heuristic?: "max" | "reeds-shepp" | "euclid";
  /** Above 1: faster, not always cheapest. Usual range: 0.5 to 5. */
  heuristicWeight?: number | null;
  /** Cost of turning. Usual range: 0 to 5. Default: 0. */
  steerCost?: number;
  /** Cost of turning the wheel. Usual range: 0 to 5 m. Default: 0. */
  steerChangeCost?: number;
  /** Cost of driving close to obstacles. Usual range: 0 to 10. Default: 0. */
  obstacleCost?: number;
  /** Distance where that cost begins. Usual range: 0.1 to 3 m. Default: 0.5. */
  obstacleDistance?: number;
  /** Shortens the finished path with curves. */
  shortcut?: boolean;
  /** Stops at the first path found (the paper). */
  firstShot?: boolean;
  /** Tries finer steps if coarse ones fail. */
  ladder?: boolean;
  /** 5 and 6: very tight spaces, many gear changes. Usual range: 0 to 6. Default: 6. */
  finestLevel?: number;
  /** Stops after this many. Usual range: 1 to 10000000. Default: null. */
  maxExpansions?: number | null;
}

/** Settings of "cost-map". */
export interface RoadSettings {
  /**
   * Metre: base, lane, kerb and speed costs per metre; paper: base cost once per cell; steps: plain A*. Default:
   * "metre".
   */
  costs?: "metre" | "paper" | "steps";
  /** Falls with clearance: K/(d+ε) or A·exp(−B·d). Default: "inverse". */
  base?: "inverse" | "exponential";
  /** Inverse base cost; larger keeps farther away. Usual range: 0.2 to 3 m. Default: 0.8. */
  factor?: number;
  /** Inverse base cost; smaller is steeper at contact. Usual range: 0.05 to 1 m. Default: 0.2. */
  epsilon?: number;
  /** Exponential base cost at contact. Usual range: 1 to 10. Default: 4. */
  amplitude?: number;
  /** Decay of the exponential base cost. Usual range: 0.5 to 4 1/m. Default: 1.5. */
  decay?: number;
  /** Weight of the distance from the lane centre. Usual range: 0 to 3. Default: 0.3. */
  laneWeight?: number;
  /** Weight of the last metre to the kerb. Usual range: 0 to 3. Default: 0.5. */
  kerbWeight?: number;
  /** Weight of time lost to limits and bends. Usual range: 0 to 3. Default: 0.5. */
  speedWeight?: number;
  /**
   * Kept free around the car; where no path has that much room, the plan says how much it keeps. Usual range: 0 to 20
   * m. Default: 0.8.
   */
  margin?: number;
  /** Auto: chords keep most of the clearance; los: line of sight only (the paper). Default: "auto". */
  pruning?: "auto" | "los" | "none";
  /** Share of the cells' clearance a chord keeps. Usual range: 0.5 to 1. Default: 0.8. */
  pruneShare?: number;
  /** Beside the car; chords need no more. Usual range: 0 to 1.5 m. Default: 0.8. */
  pruneCap?: number;
  /** Spline keeps clearance and steering limit; paper: within a metre of the chords. Default: "spline". */
  smoothing?: "spline" | "paper" | "none";
  /** RMS distance of the curve from the chords. Usual range: 0.02 to 1 m. Default: 0.12. */
  residual?: number;
  /** The curve keeps the start and goal headings. Default: false. */
  headings?: boolean;
  /** Least number of tests; long paths: two a metre. Usual range: 50 to 200. Default: 100. */
  smoothPoints?: number;
  /** It cancels: 500 to 8000 give the same path. Usual range: 50 to 10000 m. Default: 5000. */
  paperFactor?: number;
  /** Of the paper's inverse cost. Usual range: 0.5 to 2 m. Default: 1. */
  paperEpsilon?: number;
  /** Of the paper's exponential cost. Usual range: 50 to 10000. Default: 5000. */
  paperAmplitude?: number;
  /** Of the paper's exponential cost. Usual range: 0.01 to 0.1 1/m. Default: 0.05. */
  paperDecay?: number;
  /** Stops after this many. Usual range: 1 to 100000000. Default: 20000000. */
  maxExpansions?: number;
}

/** The settings of each planner, all of them optional. */
export interface PlannerSettings {
  four: FourSettings;
  eight: EightSettings;
  sixteen: SixteenSettings;
  "twenty-four": SixteenSettings;
  "forty-eight": SixteenSettings;
  "sixteen-bidirectional": SixteenBidirectionalSettings;
  "jump-point": JumpPointSettings;
  "any-angle": AnyAngleSettings;
  "risk-field": RiskFieldSettings;
  "risk-field-plus": RiskFieldSettings;
  hybrid: HybridSettings;
  "hybrid-forward": HybridSettings;
  "hybrid-bidirectional": HybridSettings;
  "hybrid-classic": HybridSettings;
  "cost-map": RoadSettings;
  dijkstra: DijkstraSettings;
  greedy: DijkstraSettings;
  rrt: RrtSettings;
  genetic: GeneticSettings;
}
