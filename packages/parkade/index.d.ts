/** Vehicle path planners. SI units, radians; x east, y north, headings counter-clockwise from east. */

import type { GridPlannerId, HybridPlannerId, PlannerId, PlannerSettings, RoadPlannerId } from "./settings.js";
export type * from "./settings.js";

export type Outcome =
  | "found" | "no-path" | "budget-spent" | "start-blocked" | "goal-blocked" | "start-outside" | "goal-outside";

/** A finer word for the outcome. */
export type Detail =
  | "unreachable" | "too-narrow" | "no-room" | "boxed-in" | "incomplete" | "suboptimal" | "verification-failed"
  | "smoothing-fell-back" | "less-margin";

export interface Pose { x: number; y: number; heading: number }

/** Lower left corner of cell (0, 0) is at `origin`; `resolution` is the side of a cell in metres. */
export interface MapFrame {
  origin: [number, number];
  width: number;
  height: number;
  resolution: number;
  /** Outline of the drivable floor; the map's rectangle where absent. Its edges are walls. */
  boundary?: [number, number][];
}

export type Obstacle =
  /** Brushed cells: runs of [x, y, count], eastward, in cells. */
  | { type: "cells"; id?: string; runs: [number, number, number][] }
  /** A wall along a polyline; thickness 0 is a mathematical line. */
  | { type: "wall"; id?: string; points: [number, number][]; thickness?: number }
  | { type: "polygon"; id?: string; points: [number, number][] }
  /** size = [along heading, across]. */
  | { type: "rectangle"; id?: string; center: [number, number]; size: [number, number]; heading?: number }
  | { type: "car"; id?: string; pose: Pose; vehicle?: VehicleSpec }
  | Road;

/**
 * A road along a line with rounded corners. Its kerbs block; its ends are open, and so are its sides where other roads
 * meet it. Traffic keeps to the right: `cost-map` to the lanes in the direction from start to goal.
 */
export interface Road {
  type: "road";
  id?: string;
  /** Corners of its middle line, metres. */
  points: [number, number][];
  /** Of the middle line at corners, metres; default 20, smaller where ways are short. */
  radius?: number;
  /** Along the line, against it; default [1, 1], at most 8 each. */
  lanes?: [number, number];
  /** Metres; default 3.5. */
  laneWidth?: number;
  /** Speed limit, m/s. */
  speed?: number;
  /** True if its sides are kerbs; default true. */
  kerbs?: boolean;
}

/** (x, y): middle of the open side; heading: from the aisle into the slot, at right angles to the aisle. */
export interface Slot {
  id?: string;
  kind: "perpendicular" | "parallel" | "angled";
  x: number;
  y: number;
  heading: number;
  /** Clear width across the car's axis (for `parallel`: the depth from the aisle). */
  width: number;
  /** Clear length along the car's axis. */
  length: number;
  /** `angled` only: angle between aisle and car axis, in (0, π/2); default π/4. */
  angle?: number;
  /** `angled` only: to which side of `heading` the car's axis leans; default "left". */
  lean?: "left" | "right";
  occupied?: boolean;
}

/**
 * A box that follows a line at constant speed, its length along its motion. It stands at the first point before its
 * start and at the last one after its arrival. Planners leave it out; `stopWaitGo` waits for it.
 */
export interface MovingObstacle {
  id?: string;
  /** The way of the box's centre. */
  points: [number, number][];
  /** Length along the motion, width across it. */
  size: [number, number];
  /** Metres per second. */
  speed: number;
  /** When it starts to move, seconds; default 0. */
  start?: number;
}

/** A lane's middle, from its beginning in the direction of travel: straight lines and arcs, one after the other. */
export interface Lane {
  id?: string;
  start: Pose;
  /** Curvature in 1/m, positive to the left; default 0. */
  pieces: { length: number; curvature?: number }[];
  width: number;
}

/** An area, a simple polygon, in which nobody may drive faster; m/s. */
export interface SpeedLimit { points: [number, number][]; speed: number }

export interface Vehicle {
  wheelbase: number;
  width: number;
  /** Rear axle to front bumper. */
  rearToFront: number;
  /** Rear axle to rear bumper. */
  rearToBack: number;
  maxSteer: number;
  maxSteerRate?: number;
}

/** "ship": 72 m × 16 m, turns in 144 m; not in `parkade/core`. */
export type VehicleSpec = "paper" | "sedan" | "ship" | Vehicle;

export type Goal = Pose | { slot: string; entry: "reverse-in" | "head-in" };

/**
 * Several goals, of which a plan takes the one that is the cheapest to reach and names it in `goal`. Not in
 * `parkade/core`.
 *
 * - Slots by their ids, or every free one. Occupied slots are left out.
 * - Poses, 1 to 1000. Those at which the car overlaps something are left out.
 * - A region: a simple polygon that shall hold the whole car, and where its nose shall point, ± 15°; anywhere without
 *   `heading`.
 *
 * The `hybrid` planners search from all goals at once; the other planners go to one goal after another.
 */
export type GoalSet =
  | { slots: "free" | string[]; entry: "either" | "reverse-in" | "head-in" }
  | Pose[]
  | { region: [number, number][]; heading?: number };

/** The goal of a `GoalSet` that a path leads to. */
export interface TakenGoal {
  /** Of the pose in the list, or of the slot in the scene's `slots`; 0 in a region. */
  index: number;
  /** The slot's id, if it has one. */
  slot?: string;
  entry?: "reverse-in" | "head-in";
  pose: Pose;
}

/** Runs of brushed cells: x of the first, y, number of cells eastward. */
export type Run = [number, number, number];

/** Cells that cost more to cross: their length times `weight`, 1 to 10. Where areas overlap the heaviest counts. */
export interface CostArea {
  id?: string;
  runs: Run[];
  weight: number;
}

export interface Scenario<AnyGoal extends Goal | GoalSet = Goal | GoalSet> {
  version: 1;
  name?: string;
  map: MapFrame;
  obstacles?: Obstacle[];
  slots?: Slot[];
  /**
   * `jump-point`, `any-angle`, `greedy`, `rrt` and `genetic`, for which all free cells cost the same, refuse scenes
   * with weights above 1.
   */
  costs?: CostArea[];
  /** Left out by planners; `parkade/core` does not even check it. */
  moving?: MovingObstacle[];
  /** For planners that keep to lanes; `parkade/core` leaves lanes and limits out. */
  lanes?: Lane[];
  speedLimits?: SpeedLimit[];
  vehicle?: VehicleSpec;
  start: Pose;
  goal: AnyGoal;
  /** Settings per planner id, laid over that planner's defaults. */
  planners?: Partial<PlannerSettings>;
}

/** Counts of every search. */
export interface SearchStats {
  expanded: number;
  generated: number;
  pushes: number;
  /** Largest size of the open list. */
  openPeak: number;
  /**
   * Bytes of the arrays that the planner held: what it kept of each node, its open list at its largest, and the rasters
   * that it searched; not the scene. No part of the hash.
   */
  memoryBytes: number;
}

export interface GridStats extends SearchStats {
  /** Second expansions (risk-field). */
  deferred?: number;
  losCalls?: number;
  /** Exact integer cost in millionths of a cell, weights included. */
  costMicro?: number;
  /** Jump points: cells looked at along jumps. */
  cellsScanned?: number;
  /** From both ends with `stop: "nba"`: cells that bounds excluded. */
  rejected?: number;
  /** With `minPassage` or `trapMouth`: cells closed as too narrow, as pockets, and given back to connect the ends. */
  narrow?: number;
  pocket?: number;
  restored?: number;
}

export interface HybridStats extends SearchStats {
  /** The same number as `expanded`, by the name of its specification. */
  expansions?: number;
  collisionChecks?: number;
  /** Level of the portfolio that gave the path, or was tried last. */
  level?: number;
}

export type Stats = GridStats | HybridStats | SearchStats;

/** Of any path. */
export interface PathMetrics {
  /** Length of `path`, metres. */
  length: number;
  directionChanges: number;
  /** Largest |curvature| of `path`, 1/m; null where it has corners. */
  maxCurvature: number | null;
  /** The car's limit, 1/m. */
  curvatureLimit: number;
  /** Of the car's body along `path`, metres. */
  minClearance: number;
  meanClearance: number;
  /**
   * Present if the scene has `costs`: the length, each part times the weight under the rear axle (`cost-map`: the car's
   * middle), metres.
   */
  weightedLength?: number;
}

/** Of a path over cells, besides; absent where there is none. */
export interface GridMetrics extends PathMetrics {
  /** Lengths in cells: as searched, after greedy pruning, along the shortest way over its cells, smoothed. */
  lengthRaw?: number;
  lengthPruned?: number;
  lengthDp?: number;
  lengthSmoothed?: number;
  turns?: number;
  turnAngleDeg?: number;
  turnsPruned?: number;
  turnAngleDegPruned?: number;
  /**
   * Of the path as answered: from the centres of its cells to blocked cells' centres, at most 5 cells; the mean over
   * samples every quarter of a cell.
   */
  minClearanceCells?: number;
  meanClearanceCells?: number;
  sharpCorners?: number;
  arcs?: number;
  /** Smallest arc radius, cells. */
  minRadius?: number | null;
}

/** Of hybrid A*'s path, besides; absent where there is none. */
export interface HybridMetrics extends PathMetrics {
  /** Cost of the path by the planner's settings, in metres of driving ahead. */
  cost?: number;
  /**
   * Metres that no path of this car from start to goal can be shorter than: the shortest Reeds–Shepp curve, obstacles
   * aside. Of several goals to the nearest by that measure.
   */
  rsBound?: number;
  /** By how much the path is longer than `rsBound`, percent of it: no path can save more. 0 proves it the shortest. */
  gapPercent?: number;
  /**
   * The margin planned with, metres: less than asked where start or goal have less, 2 mm where more keeps the car in.
   */
  margin?: number;
  /** The parking paper's rounding. */
  paperLength?: number;
  paperNodes?: number;
  paperTime?: number;
  /**
   * Where paths are chosen among: `duration` of the trajectory that `optimise` makes of this one by default, seconds.
   */
  driveTime?: number;
}

/** Of `cost-map`'s path, besides; absent where there is none. */
export interface RoadMetrics extends PathMetrics, Partial<RoadFigures> {
  cost?: number;
  /** Turning points of cells and of chords, ends included. */
  turnsRaw?: number;
  turnsPruned?: number;
  /** How far the ends were moved to have room, metres. */
  startMoved?: number;
  goalMoved?: number;
  /** Room that was asked for around the car, metres, and what the path keeps of it, 5 m at the ends left out. */
  margin?: number;
  marginKept?: number;
  /** True if it is proven that no path on the map keeps the whole margin. */
  marginExcluded?: boolean;
  /** Bytes of the arrays that planning holds. */
  bytes?: number;
}

export type Metrics = GridMetrics | HybridMetrics | RoadMetrics;

/** The independent checker's verdict on `path`: exact footprint against exact obstacles. */
export interface Check {
  /** "ok": this car can drive it and arrives as asked. */
  verdict: "ok" | "arrives-turned" | "too-tight" | "collides" | "none";
  /** True if this car can drive it: no hit, no turn tighter than its limit, starts along its heading. */
  drivable: boolean;
  /** Poses of `path` at which the body overlaps something. */
  hits: number;
  /** Their indices into `path`. */
  hitPoses: Uint32Array;
  /**
   * The first obstacle hit: its id or kind ("border", "wall", "polygon", …), its index in `obstacles` (or -1) and the
   * pose.
   */
  firstHit: Hit | null;
  /** Corners and arcs that turn tighter than the car can. */
  tightTurns: number;
  /** Steps in which the body moves sideways; a path that begins elsewhere than at the start counts as one. */
  slips: number;
  /** Tightest radius, metres; 0 at a corner, null for a straight path. */
  tightestRadius: number | null;
  /** The limit, metres. */
  minTurningRadius: number;
  /** Radians, between the car's start heading and the path's first heading. */
  startHeadingError: number;
  goalHeadingError: number;
  /** Metres between the last pose and the goal. */
  goalDistance: number;
  /** The pose with the least clearance, unless the body overlaps an obstacle. Not in `parkade/core`. */
  narrowest?: Narrowest;
}

/** The check of a path alone. */
export interface PathCheck extends Check {
  /** Per pose: metres from the body to the nearest obstacle. */
  clearances: Float64Array;
}

/** The narrowest place of a path. */
export interface Narrowest {
  /** Index into `path`. */
  pose: number;
  /** The body's point and the obstacle's, metres. */
  body: [number, number];
  point: [number, number];
  /** Its id or kind ("border", "wall", "polygon", …) and its index in `obstacles` (or -1). */
  obstacle: string;
  index: number;
}

/** Cell indices (y * width + x) in order of expansion. */
export interface CellTrace { kind: "cells"; cells: Uint32Array; dropped: number }

/**
 * Hybrid search tree: x, y, heading at its beginning, curvature, signed length (negative: reverse) of each arc as
 * driven, in order of expansion; at most 20 000. Of the last search, where several levels were tried.
 */
export interface ArcTrace { kind: "arcs"; arcs: Float64Array; dropped: number; failedExpansions: FailedExpansions }

export type Trace = CellTrace | ArcTrace;

/**
 * Every event of a search over cells: what `trace: "full"` asks for. A node is a cell. Of
 * `cost-map` the last search of the plan, in metres.
 */
export interface SearchTrace extends SearchEvents {
  kind: "search";
  /** Columns and rows of the map: node `y * width + x`. */
  width: number;
  height: number;
}

/**
 * The same of hybrid A*'s last search from one end: a node is a cell of position, heading and gear. 44 bytes more a
 * move.
 */
export interface PoseTrace extends SearchEvents {
  kind: "poses";
  /** The root's pose; from both ends those of the start's tree and the goal's. A node's number is its side's own. */
  roots: Pose[];
  /** True if the only tree grows from the goal, against the direction of driving. */
  fromGoal: boolean;
  /** Per move: x, y, heading of the pose that it leads to, or stops at where something is in its way. */
  poses: Float64Array;
  /** Per move: curvature and signed length of its arc up to there, as the tree grows. */
  arcs: Float64Array;
  /**
   * Per move: index in the scene's `obstacles` of what is in its way, -1 for the border and parked cars of slots, -2
   * for nothing.
   */
  obstacles: Int32Array;
  /** The ordinary trace of the same search. */
  tree: ArcTrace;
}

/**
 * Events of a search in columns. A step is an entry taken from the open list; its moves follow one another in the
 * columns named `target…`. 33 bytes a step and 21 bytes a move.
 */
export interface SearchEvents {
  /**
   * Per step: 0 expanded, 1 its deferred moves tried, 2 excluded by a bound, 3 the goal, 4 where two sides meet, 5
   * expanded, and a path completed that a cheaper one may replace; of `rrt` 6 a cell drawn, whose nearest in the tree
   * the node is; of `genetic` 7 a candidate, f its fitness; 16 more of the side from the goal.
   */
  kinds: Uint8Array;
  /** Per step: its node, cost from the root, estimate, priority. */
  nodes: Uint32Array;
  g: Float64Array;
  h: Float64Array;
  f: Float64Array;
  /** Per step: number of its first move; and the number of all moves. */
  first: Uint32Array;
  /** Per move: its target, the cost there along it, the estimate there (0 where it was not taken). */
  targets: Uint32Array;
  targetG: Float64Array;
  targetH: Float64Array;
  /**
   * Per move: 0 kept, 1 improved, 2 dearer than known, 3 closed, 4 blocked, 5 cuts a corner, 6 held back, 7 the node
   * itself waits for its deferred moves, 8 left out by the search's rule, 9 the cell that `rrt` drew or the end of a
   * free leg of a candidate of `genetic`; 16 more where it leads from the node's parent.
   */
  fates: Uint8Array;
  /**
   * True if the open list is ordered by f, then the oldest entry first; else by f, then by h, then the newest entry
   * first.
   */
  oldestFirst: boolean;
  /**
   * Costs of a cell or metre: a million where the planner reckons in whole micro-cells, 1 for `any-angle`, `cost-map`
   * and hybrid A*.
   */
  unit: number;
  /** By how much f of a node that waits exceeds g + h. */
  penalty: number;
  /** True if steps beyond `traceLimit` are missing. */
  cut: boolean;
  /**
   * As in the plan's `stats`, of the steps that are there; of the whole search for `any-angle`, `cost-map` and hybrid
   * A*.
   */
  counters: { expanded: number; generated: number; pushes: number; openPeak: number };
}

/** Analytic expansions that hit something: of each expanded node the cheapest that was tried; at most 4000. */
export interface FailedExpansions {
  /** Each: index of its first arc in `arcs`; the next one's is its end. */
  first: Uint32Array;
  /** Up to where they hit, x, y, heading, curvature, signed length of each arc, as driven. */
  arcs: Float64Array;
  /** Each: x, y, heading of the car where it hits. */
  hits: Float64Array;
  /** Each: index in the scene's `obstacles`, or -1 for the border and parked cars of slots. */
  obstacles: Int32Array;
  /** Each: how many nodes were expanded before the one that tried it. */
  expansions: Uint32Array;
  /** Those beyond the cap. */
  dropped: number;
}

/**
 * The obstacle in the way of a pose: its id or kind ("border", "wall", "polygon", …) and its index in `obstacles` (or
 * -1).
 */
export interface Hit { obstacle: string; index: number; pose: Pose }

/** The place that blocks the way, for drawing; metres. */
export type Obstruction =
  /** The car overlaps something where it starts or shall arrive. */
  | { kind: "contact"; end: "start" | "goal"; hit: Hit }
  /** The narrowest place of the widest way, and the car's width. */
  | { kind: "gap"; x: number; y: number; width: number; needed: number }
  /**
   * No way joins start and goal: the smaller of the regions around them, where the centre of a disc as wide as the car
   * can be. Squares of side `cell` in runs: lower left corner, number of squares eastward.
   */
  | { kind: "enclosed"; end: "start" | "goal"; cell: number; runs: [number, number, number][] }
  /** The car can hardly move: how far it gets straight and at full lock, ahead and back, and what stops it there. */
  | { kind: "boxed-in"; end: "start" | "goal"; stops: Hit[] }
  /** Of what was searched, the place with the least estimate to go; the car's heading, of planners that have one. */
  | { kind: "nearest"; x: number; y: number; heading: number | null };

/** The part that plans of every family share. */
export interface AnyPlan {
  planner: PlannerId;
  outcome: Outcome;
  detail: Detail | null;
  /** For people, when there is no path: what is in the way, where the search stopped. */
  reason: string | null;
  /** The place that blocks the way, if there is no path and the place is known. */
  obstruction: Obstruction | null;
  /** Present if there is a path and the scene has a set of goals: the goal that the path leads to. */
  goal?: TakenGoal;
  /** x, y, heading, … at most 0.1 m apart (grid paths beyond 5 km: 50 000 poses). */
  path: Float64Array;
  /** Per pose: +1 forward, −1 reverse. */
  directions: Int8Array;
  /** Per pose: signed curvature of the path ahead, 1/m; NaN at a corner. */
  curvatures: Float64Array;
  /** Per pose: distance from the body to the nearest obstacle, metres; 0 where it overlaps. */
  clearances: Float64Array;
  /** The planner's unprocessed path, x, y, …: cell centres, or the ends of the arcs. */
  rawPath: Float64Array;
  stats: Stats;
  metrics: Metrics;
  check: Check;
  trace: Trace | null;
  /**
   * Two hashes with a hyphen between them, the same in every browser and in Node: 16 hex digits of planner, outcome,
   * verdict and path, 16 of figures and counters. Time, trace, member and alternatives are no part of it.
   */
  hash: string;
}

/** A grid path after each post-processing step; the steps begin with `rawPath`; x, y in metres. */
export interface Stages {
  /** Corners that remain after pruning. */
  pruned: [number, number][];
  /** The shortest way over the same cells. */
  shortest: [number, number][];
  /** The circles that round corners: each touches the segment before in `from` and the one after in `to`. */
  arcs: {
    corner: [number, number];
    from: [number, number];
    to: [number, number];
    center: [number, number];
    radius: number;
  }[];
  /** Corners that no arc rounds. */
  sharp: [number, number][];
}

export interface GridPlan extends AnyPlan {
  planner: GridPlannerId;
  stats: GridStats;
  metrics: GridMetrics;
  trace: CellTrace | null;
  /** With `trace`, where a path is found; not of `parkade/core`. */
  stages?: Stages;
}

export interface HybridPlan extends AnyPlan {
  planner: HybridPlannerId;
  stats: HybridStats;
  metrics: HybridMetrics;
  trace: ArcTrace | null;
  /** Not in `parkade/core`: which search of its portfolio answered; absent where nothing was searched. */
  member?: Member;
  /**
   * Where `alternatives` were asked for: the paths of which none is better in everything than another, this one among
   * them, the shortest first. "Everything" is length, gear changes, clearance and `metrics.driveTime`.
   */
  alternatives?: HybridPlan[];
}

export interface RoadPlan extends AnyPlan {
  planner: RoadPlannerId;
  stats: SearchStats;
  metrics: RoadMetrics;
  trace: CellTrace | null;
}

/** A planner's answer; `planner` tells the families apart. */
export type Plan = GridPlan | HybridPlan | RoadPlan;

/** The answer of one planner. */
export type PlanOf<Id extends PlannerId> = Id extends GridPlannerId
  ? GridPlan
  : Id extends HybridPlannerId ? HybridPlan : RoadPlan;

/**
 * The search that found the path or, where there is none, that went through everything with the least margin, or was
 * tried last.
 */
export interface Member {
  /** Of the portfolio, 0 to 5. */
  level: number;
  /** True if its tree grew from the goal, else from the start; false of a search from both ends. */
  fromGoal: boolean;
  /** Side of a position cell, metres. */
  xyResolution: number;
  /** Width of a heading bin, radians. */
  headingResolution: number;
  /** Kept free around the body, metres. */
  margin: number;
}

/** The preference by which hybrid's path is chosen. */
export type Prefer = "shortest" | "fewest-changes" | "widest" | "fastest";

/** The result of `Planner.search`. */
export interface Found {
  outcome: Outcome;
  /** Cell centres x, y, … from start to goal, metres; every cell, or the turning points of "any-angle". */
  path: Float64Array;
  /** Millionths of a cell. */
  costMicro: number;
  expanded: number;
  generated: number;
}

export type LayerName = "occupancy" | "safety" | "redundant" | "clearance" | "risk" | "potential" | "cost";

export interface Layer {
  width: number;
  height: number;
  /**
   * Cells of the map from one value to the next, in both directions; the value is that of the middle (floor(every / 2))
   * cell.
   */
  every: number;
  /**
   * Row-major from the south-western cell. occupancy: 0 free, 1 blocked. safety: 0 free, 1 obstacle, 2 necessary safety
   * space (half the car's width). redundant: the same for this grid planner's own settings, and 3 where `minPassage` or
   * `trapMouth` close free cells between start and goal. clearance: metres from the cell's centre to the nearest
   * blocked cell's square. risk: force east, force north per cell. potential: U, the goal's and the obstacles'
   * (equations 4 and 6 of the risk-field paper). cost: what a metre costs beyond its length (with `costs: "paper"`,
   * what the cell costs); Infinity where the car has no room.
   */
  data: Uint8Array | Float32Array;
}

/** The risk-field planner's step at one cell, in the terms of its paper's tables 1 and 2. Forces: east, north. */
export interface Explanation {
  /** Column, row. */
  cell: [number, number];
  /** "oblique": table 1; "straight": table 2. */
  mode: "oblique" | "straight";
  attraction: [number, number];
  repulsion: [number, number];
  /** F, their sum. */
  force: [number, number];
  /** Of the goal (equation 4) and of the obstacles (equation 6). */
  potentials: [goal: number, obstacles: number];
  /** k = F_y / F_x; null where F_x is 0. */
  slope: number | null;
  region: "1" | "2" | "3" | "4" | "5" | "6" | "7" | "8" | "A" | "B" | "C" | "D";
  /** Central direction, counter-clockwise from the east: 0 to 7. */
  center: number;
  /** Cells in the order in which they are tried; those of the other five directions, held back, last. */
  candidates: {
    cell: [number, number];
    direction: "E" | "NE" | "N" | "NW" | "W" | "SW" | "S" | "SE";
    role: "primary" | "extension" | "held-back";
    /** True if it is free and the way to it is. */
    free: boolean;
  }[];
  /** Estimate of the way to the goal, millionths of a cell; then with the distance weight. */
  estimate: number;
  weighted: number;
}

export interface ParameterInfo {
  name: string;
  type: "number" | "integer" | "boolean" | "choice";
  /** "m", "rad", "cells", "1", … */
  unit: string;
  min?: number;
  max?: number;
  step?: number;
  choices?: string[];
  default: number | boolean | string | null;
  /** True if people reach for it first. */
  basic: boolean;
  title: { en: string; zh: string };
  doc: { en: string; zh: string };
}

export interface PlannerInfo {
  id: PlannerId;
  /** Its search space: cells; poses of a car, which can drive the path; a road's cost map. */
  family: "grid" | "hybrid" | "road";
  /** True if a risk field leads it: `layer("risk")` and `explain`. */
  hasRiskField: boolean;
  /** True if it plans in scenes with `costs`. */
  takesCosts: boolean;
  title: { en: string; zh: string };
  paper: string;
  parameters: ParameterInfo[];
}

export interface ScenarioInfo {
  id: string;
  group: "parking" | "grid" | "tight" | "paper" | "moving" | "road" | "figures";
  title: { en: string; zh: string };
  /** The question the scene asks. */
  question: { en: string; zh: string };
}

/** A vehicle with nothing left open, and the radius (m) in which it turns. */
export type SceneVehicle = Required<Vehicle> & { minTurningRadius: number };

/** A scene resolved to plain geometry, metres. */
export interface SceneGeometry {
  start: Pose;
  /** Of a set of goals the first, whether or not the car has room there; the start where there is none. */
  goal: Pose;
  /** A set of goals: every slot's poses, the list, or a sample of the region. Not in scenes with one goal. */
  goals?: TakenGoal[];
  vehicle: SceneVehicle;
  boundary: [number, number][];
  /** Outlines of each slot's four corners: near left, near right, far right, far left, seen from the aisle. */
  slots: [number, number][][];
  /** Cars standing in occupied slots. */
  parkedCars: { slot: number; pose: Pose; vehicle: SceneVehicle }[];
}

export type ErrorCode =
  | "bad-config" | "bad-scenario" | "bad-vehicle" | "bad-input" | "bad-import" | "unknown-planner" | "unknown-scenario"
  | "freed" | "not-initialised" | "internal";

export class ParkadeError extends Error {
  readonly code: ErrorCode;
  /** The field, such as "obstacles[2].points[0]"; empty for the whole. */
  readonly path: string;
  /** For translations: the rule with `{}` in the place of each value; absent where the message is all there is. */
  readonly template?: string;
  /** The values in the places of `template`. */
  readonly values?: readonly string[];
}

/**
 * Loads the wasm module, once. `wasm`: its bytes, a module or where it is, instead of the file beside this one
 * (`parkade/inline`: its bytes or a module). Once a module is loaded, or loads, another `wasm` is refused, but for
 * compiled modules, which every worker gets its own copy of: they are passed over.
 */
export function init(options?: { wasm?: BufferSource | WebAssembly.Module | URL | string }): Promise<void>;
export function version(): string;
export function planners(): PlannerInfo[];
export function defaultConfig<Id extends PlannerId>(planner: Id): Required<PlannerSettings[Id]>;
export function scenarios(): ScenarioInfo[];
export function scenario(id: string): Scenario<Goal>;
/** Checks a scene and resolves it to geometry. Throws ParkadeError. */
export function sceneGeometry(scene: Scenario): SceneGeometry;
/** Re-checks any path (x, y, heading, …) against a scene. `directions` defaults to forward throughout. */
export function checkPath(scene: Scenario, path: Float64Array | number[], directions?: Int8Array | number[]): PathCheck;

/**
 * Brushed cells as text, about two characters a run, for links, files and messages. A scene's `runs` may be such a text
 * wherever a scene is read; scenes that the package makes have them as numbers.
 */
export function packRuns(runs: readonly Run[]): string;
/** The runs that `packRuns` made a text of. */
export function unpackRuns(text: string): Run[];

/** `parkade` only, not `parkade/core`: what `importScene` is asked. */
export interface ImportOptions {
  /** Side of a cell, metres, of maps that do not say; default 1. */
  resolution?: number;
  /** Which of the queries gives the scene's start and goal; default 0. */
  query?: number;
  /** Treatment of cells that are neither free nor occupied; default "blocked". */
  unknown?: "blocked" | "free";
  /** Default: a cart 0.8 cells wide for maps of cells, "paper" for maps in metres. */
  vehicle?: VehicleSpec;
}

/** A question that comes with a map. */
export interface ImportedQuery {
  /** Its group of about equal length. */
  bucket: number;
  /** Centre of the cell; the heading points to the goal. */
  start: Pose;
  goal: Pose;
  /** Length of the shortest eight-connected path that touches no corner of a blocked cell, metres. */
  length: number;
}

export interface Imported {
  format: "movingai" | "ros-map" | "tpcap" | "lots" | "scene";
  /** The first of `scenes`. */
  scene: Scenario;
  scenes: Scenario[];
  queries: ImportedQuery[];
  /** Remarks about how the file was read. */
  notes: string[];
}

/**
 * Detects the format from the file name: MovingAI `.map` with or without its `.scen`, ROS `.yaml` with its `.pgm`,
 * TPCAP `.csv`, lots and scenes as `.json`. Throws ParkadeError "bad-import" with `path` "file:line". `parkade` only,
 * not `parkade/core`.
 */
export function importScene(
  files: Record<string, string | Uint8Array | ArrayBuffer>, options?: ImportOptions,
): Imported;

/** What a grid of cells does not say. */
export interface OccupancyOptions extends Omit<Partial<Scenario>, "version" | "map" | "costs"> {
  start: Pose;
  goal: Goal | GoalSet;
  /** Side of a cell, metres. */
  resolution: number;
  /** Lower left corner of the map, metres; default [0, 0]. */
  origin?: [number, number];
  /**
   * "bottom-up" (default): the first row is the southernmost one, as in ROS. "top-down": the northernmost one, as in
   * pictures.
   */
  rows?: "bottom-up" | "top-down";
  /** Cells of at least this value are blocked; default 1. Negative values, and what is no number, are unknown. */
  occupied?: number;
  /** Treatment of unknown cells; default "blocked". */
  unknown?: "blocked" | "free";
  /**
   * What a metre costs in each cell, in metres: whole numbers from 1 to 10, in the order of the cells. For planners
   * with `takesCosts`.
   */
  costs?: ArrayLike<number>;
}

/**
 * A scene of a grid: one value per cell, row by row from west to east, `width` cells a row. Other fields of a scene
 * (`vehicle`, `slots`, …) may be given with the options; `obstacles` come on top of the grid. Throws ParkadeError
 * "bad-input". `parkade` only, not `parkade/core`.
 */
export function fromOccupancy(cells: ArrayLike<number | boolean>, width: number, options: OccupancyOptions): Scenario;

/** The part of ROS's nav_msgs/OccupancyGrid that a scene is made of. */
export interface OccupancyGrid {
  info: {
    resolution: number;
    width: number;
    height: number;
    origin: {
      position: { x: number; y: number; z?: number };
      orientation?: { x?: number; y?: number; z?: number; w?: number };
    };
  };
  /** Chance of being occupied in percent, -1 for unknown. */
  data: ArrayLike<number>;
}

/**
 * A scene of a ROS map message, in the map's frame. `occupied` is 65 by default. A map that is rotated is refused.
 * `parkade` only, not `parkade/core`.
 */
export function fromOccupancyGrid(
  message: OccupancyGrid,
  options: Omit<OccupancyOptions, "resolution" | "origin">,
): Scenario;

/** A seeded map; the same arguments give the same map everywhere. */
export type Family =
  | {
      family: "random";
      /** Cells a side, 5 to 4096. */
      size: number;
      seed: number;
      /** Share of blocked cells, thousandths; default 150. */
      densityPermille?: number;
      /** Sides of the blocks, cells; default 1 to 3. */
      blockMin?: number;
      blockMax?: number;
    }
  | { family: "regular" | "trap"; size: number; seed: number };

/** Draws a map of a family, one metre a cell, from corner to corner. `parkade` only, not `parkade/core`. */
export function generateScenario(family: Family): Scenario<Goal>;

/**
 * A row of tables 3 and 4 of Hu et al. 2024; printed values of four neighbours, eight neighbours, the improved planner.
 */
export interface PaperRow {
  id: string;
  table: number;
  size: number;
  nodes: [number, number, number];
  lengths: [number, number, number];
  /** No path between the printed end points is shorter, cells. */
  straight: number;
}

/** Over many maps. */
export interface Spread { median: number; p95: number; worst: number }

export interface PaperTable {
  row: Omit<PaperRow, "straight">;
  straight: number;
  maps: number;
  lines: {
    planner: string;
    printedNodes: number | null;
    printedLength: number | null;
    /** The printed length is below the straight line. */
    impossible: boolean;
    /** The column whose median is nearest to the printed length; null where none is printed, or one that cannot be. */
    closest: "lengthRaw" | "lengthPruned" | "lengthDp" | "lengthSmoothed" | null;
    /** In the order of the columns. */
    figures: Spread[];
  }[];
  ratios: { figure: string; planner: string; overFigure: string; over: string; printed: number | null; ours: Spread }[];
}

/**
 * A claim of a paper and what we find. `figures`: ratios, percentages, metres or counts by name; of several rows the
 * smallest and the largest, null where none is measured.
 */
export interface PaperClaim {
  id:
    | "H1" | "H2" | "H3" | "Y1" | "Y2" | "Y3" | "Y4" | "Y5" | "Y6" | "K1" | "K2" | "K3" | "K4" | "K5"
    | "R1" | "R2" | "R3" | "R4" | "R5";
  figures: Record<string, number | [low: number, high: number] | null>;
  holds: "yes" | "no" | "partly" | "unknown";
}

/** Rows, planners and columns that `paperGrid` measures. `parkade` only, not `parkade/core`, as the next two. */
export function paperGridRows(): { rows: PaperRow[]; planners: string[]; columns: string[] };
/**
 * Measures a row of the risk-field paper on the maps of seeds `from` to `to`, both included: per map a number for each
 * planner and column. Slices may be measured anywhere, and joined in any order.
 */
export function paperGrid(slice: { row: string; from: number; to: number }): Float64Array;
/** The papers' values beside ours, from all figures of each row; claims are judged when all rows are there. */
export function paperGridSummary(measured: Record<string, Float64Array>): {
  tables: PaperTable[];
  claims: PaperClaim[];
};

/** A scene of the road manuscript; printed values of plain and improved A*. */
export interface RoadRow {
  id: string;
  /** The scene; with `ship` ten times as large, for the manuscript's ship, and in no menu. */
  scene: string;
  ship: boolean;
  /** Metres, seconds, MB; collisions of 1000. */
  printed: Record<"length" | "turns" | "safety" | "time" | "memory" | "collisions", [plain: number, improved: number]>;
}

export interface RoadTable {
  row: RoadRow;
  /** Of the map. */
  cells: number;
  /** Plain A* first. */
  lines: {
    id: "plain" | "inverse" | "exponential" | "literal" | "paper" | "paper-exponential";
    verdict: Check["verdict"];
    /** No curve was good enough. */
    fellBack: boolean;
    metrics: Required<Pick<RoadMetrics,
      | "cost" | "turnsRaw" | "turnsPruned" | "startMoved" | "goalMoved" | "bytes" | "middleLength"
      | "bodyClearanceMin" | "bodyClearanceMean" | "sideClearanceMin" | "sideClearanceMean" | "curvatureVariation"
      | "middleCurvature" | "laneDeviationMax" | "laneDeviationMean"
      | "laneLeftShare" | "margin" | "marginKept" | "marginExcluded" | "bodyClearanceMeanCapped">>;
    risk: { trials: number; hits: number; discHits: number };
    milliseconds: number;
  }[];
  /** Promises of the second line; none for ships. */
  promises: {
    figure:
      | "length" | "turns" | "curvatureVariation" | "curvature" | "clearanceMean" | "clearanceLeast" | "hits"
      | "laneDeviation" | "laneLeft" | "bytesPerCell";
    atLeast: boolean;
    bound: number;
    found: number;
    plain: number;
    kept: boolean;
  }[];
}

/** Rows that `paperRoad` measures. `parkade` only, not `parkade/core`, as the next one. */
export function paperRoadRows(): RoadRow[];
/**
 * Plans a scene of the road manuscript in several ways, the fastest of some rounds (1) for the time, with the risk of
 * each.
 */
export function paperRoad(options: { row: string; rounds?: number }): RoadTable;

/** A cell of the parking paper's tables: seconds of driving at 2 m/s, gear changes, nodes 0.1 m apart, metres. */
export interface ParkingFigures { time: number; changes: number; nodes: number; length: number }

/** A row of tables 2 to 11 of the parking paper. */
export interface ParkingRow {
  /** Of the scene. */
  id: string;
  /** First and last table. */
  tables: [number, number];
  /** Along the aisle, else across it. */
  parallel: boolean;
  traditional: ParkingFigures;
  improved: ParkingFigures;
  /** Bounds that "hybrid" must meet: metres, gear changes. */
  reach: [number, number];
  /** Error of the printed row; may be empty. */
  note: string;
}

export interface ParkingTable {
  row: ParkingRow;
  /** Length of the shortest path without obstacles, metres. */
  bound: number;
  /** True if the printed lengths, traditional and improved, are below that. */
  impossible: [boolean, boolean];
  /**
   * "hybrid-forward" (traditional), "hybrid" (improved), "hybrid-bidirectional", "hybrid-classic", in the paper's
   * rounding.
   */
  lines: (ParkingFigures & {
    planner: PlannerId;
    verdict: Check["verdict"];
    /** Metres, not rounded. */
    exact: number;
    clearance: number;
    expanded: number;
    /** Of the whole plan with its check, the fastest round. */
    milliseconds: number;
  })[];
  kept: boolean;
  /** Driving time that the improved column saves, percent: printed, ours. */
  saved: [number, number];
}

/** Rows that `paperParking` measures. `parkade` only, not `parkade/core`, as the next one. */
export function paperParkingRows(): ParkingRow[];
/** Plans a row of the parking paper with its planners; the fastest of some rounds (1) counts for the time. */
export function paperParking(options: { row: string; rounds?: number }): ParkingTable;

/** Percent of driving time saved on four rows of the parking paper. */
export interface ParkingSaved {
  /** By the abstract, and by the printed rows. */
  said: number;
  printed: number;
  /** "hybrid" against "hybrid-forward" and against "hybrid-classic". */
  overForward: number;
  overClassic: number;
}

/**
 * Claims of the parking paper and of the road manuscript, judged on their tables, which must be all there; none where
 * they are not. No verdict rests on a time. `saved`: of rows P1 to P4 and L1 to L4. `parkade` only, not `parkade/core`,
 * as the next two.
 */
export function paperVerdicts(tables: { parking?: ParkingTable[]; road?: RoadTable[] }): {
  parking: PaperClaim[];
  road: PaperClaim[];
  saved: [ParkingSaved, ParkingSaved] | null;
};

/**
 * The seeds of a row's maps, `from` to `to`, on which the risk field taken literally (`fallback: "none"`) finds no
 * path.
 */
export function paperIncomplete(slice: { row: string; from: number; to: number }): number[];

/** Volumes around the car held against its exact body (figures 4 and 5 of the parking paper). */
export interface VolumeComparison {
  scene: string;
  poses: number;
  /** Lines that each volume is tested against. */
  lines: number;
  /** Poses at which the exact body hits something. */
  collisions: number;
  volumes: {
    volume: "aabb" | "obb" | "ball";
    /** Poses at which it meets a line. */
    hits: number;
    /** Of those, poses at which the body is free. */
    falseAlarms: number;
    /** Poses at which the body is wholly behind a line, which the volume does not meet. */
    missed: number;
    /** Mean area over the body's. */
    area: number;
    /** Microseconds of a pose, the fastest round. */
    micros: number;
  }[];
}

/** Compares them on "P0", "park-fig13" or "reverse-in", on poses at random (10 000, seed 1, one round). */
export function paperVolumes(options: {
  scene: string;
  poses?: number;
  seed?: number;
  rounds?: number;
}): VolumeComparison;

/**
 * Some of a search's expansions in their order, as in a trace: cells, or arcs (x, y, heading, curvature, signed
 * length). `search` counts the searches of a plan from 0: hybrid's may be several, of which the last is the trace's.
 */
export type Expansions =
  | { kind: "cells"; search: number; cells: Uint32Array }
  | { kind: "arcs"; search: number; arcs: Float64Array };

export class Planner<Id extends PlannerId = PlannerId> {
  /** Checks scene and settings and prepares the map, once. Throws ParkadeError. */
  constructor(planner: Id, scene: Scenario, config?: PlannerSettings[Id]);
  /**
   * `start` and `goal` take the place of the scene's in this plan, and in `layer`, `explain` and `anyAngleLength` until
   * the next one; a second plan on the same map prepares nothing anew. `goal` is one pose or slot, no set of them.
   * `parkade/core` takes poses only, no slots.
   *
   * `onProgress` is called while the search goes on: each 16 384 cells, or each 256 poses of a car, with the expansions
   * so far; and once when it has ended, with the plan's `stats.expanded`, before the path is followed, checked and
   * measured. What it throws ends the search and is thrown by `plan`; the planner can be used again. It cannot use the
   * planner that calls it.
   *
   * `trace: "full"`, not in `parkade/core`, records the search with every move that it considered and what became of it
   * ({@link SearchTrace}, {@link PoseTrace}), at most `traceLimit` steps, 1 to 1 000 000, by default 100 000. Plans
   * without it are as fast as ever.
   *
   * Hybrid only, and not in `parkade/core`: `prefer` looks for a better path than the ordinary one by that measure,
   * gear changes first for "fewest-changes"; `alternatives` looks for all that are worth choosing from. Without
   * `prefer` the answer is then the path that costs least with no less margin. `onImproved` is given the ordinary plan,
   * and each better one as soon as it is found; what it throws counts as in `onProgress`. All are bounded by counted
   * work, a few times that of an ordinary plan of a tight slot, and the same everywhere.
   *
   * `stickiness`, 0 to 1, hybrid only, for what is dragged: this planner's last path, led to the new ends and around
   * what is in its way, stays unless another one costs less by more than that share and is longer or shorter by more
   * than it, or keeps a margin that the last one does not. With `prefer`, and without `alternatives` and `onImproved`,
   * it is that measure by which the other one must be better, and nothing more is searched for. Without `stickiness` a
   * plan does not depend on the one before.
   *
   * `onExpanded` is given what is expanded while it is searched, a thousand cells or 64 arcs at a time, for drawings of
   * one's own; the plan then has its trace. Not in `parkade/core`.
   */
  plan(options: {
    trace: "full";
    traceLimit?: number;
    start?: Goal;
    goal?: Goal;
    onProgress?: (expansions: number) => void;
    onExpanded?: (events: Expansions) => void;
  }): Omit<PlanOf<Id>, "trace"> & { trace: Trace | SearchTrace | PoseTrace | null };
  plan(options?: {
    trace?: boolean;
    start?: Goal;
    goal?: Goal;
    prefer?: Prefer;
    alternatives?: boolean;
    stickiness?: number;
    onProgress?: (expansions: number) => void;
    onImproved?: (plan: PlanOf<Id>) => void;
    onExpanded?: (events: Expansions) => void;
  }): PlanOf<Id>;
  /**
   * Takes over a path for `stickiness`: the last one of a planner of the scene as it was before an edit, or a plan's,
   * say one of the `alternatives`. Nothing is taken over by other planners than hybrid, nor from a planner where the
   * floor's outline is another. Not in `parkade/core`.
   */
  continueFrom(before: Planner | HybridPlan): void;
  /**
   * The search of a grid planner alone, between two points: its cells, neither followed by a car nor checked nor
   * measured. What `plan` does besides grows with the path and often takes longer. Not in `parkade/core`.
   */
  search(start: { x: number; y: number }, goal: { x: number; y: number }): Found;
  /**
   * Grid planners: length in metres of the shortest path in any direction over cell centres, from the start's to the
   * goal's; null where there is none. Slow on large maps. Not in `parkade/core`.
   */
  anyAngleLength(): number | null;
  /**
   * Blocks runs of cells [x, y, count] in this planner's own map, or takes the brush away from them; what other
   * obstacles block stays blocked. Costs what the runs touch, not the size of the map. Not in `parkade/core`.
   */
  brush(runs: [number, number, number][], blocked: boolean): void;
  /**
   * A raster of this planner's map, between the ends of the last plan. `every`, of `risk` only: a value for each square
   * of so many cells in each direction, without those that the map's border cuts through; default 1.
   */
  layer(name: LayerName, options?: { every?: number }): Layer;
  /**
   * Explains the risk field at the cell of a point (metres); null off the map and in blocked cells. Throws for planners
   * without a risk field. `parkade` only, not `parkade/core`.
   */
  explain(at: { x: number; y: number }): Explanation | null;
  free(): void;
  [Symbol.dispose](): void;
}

/** A path to drive: a plan, or its columns alone. */
export interface DrivenPath {
  /** x, y, heading, … */
  path: Float64Array | number[];
  /** Gear (±1) of the way on from each pose; forward where absent. */
  directions?: Int8Array | number[];
  /** Curvature of the way on from each pose, 1/m, NaN or null at a corner; from the poses where absent. */
  curvatures?: Float64Array | (number | null)[];
}

/** Limits of a trajectory. */
export interface Limits {
  /**
   * "limited" (default): from rest to rest within all limits. "constant": `speed` throughout, as in the parking paper.
   */
  profile?: "limited" | "constant";
  /** m/s; default 2. The scene's `speedLimits` hold as well. */
  speed?: number;
  /** m/s²; default 1. */
  acceleration?: number;
  /** m/s²; default 1.5. */
  deceleration?: number;
  /** v²·|κ|, m/s²; default 1.5. */
  lateralAcceleration?: number;
  /** m/s³; none where absent. */
  jerk?: number | null;
  /** Speed at the beginning, m/s; default 0. */
  startSpeed?: number;
  /** Speed at the end, m/s; default 0. */
  goalSpeed?: number;
  /**
   * Where the curvature steps, which the wheel cannot. "preview" (default): the speed is kept and the wheel begins to
   * turn before the step. "slow": 0.5 m/s near steps, and everywhere slow enough for the wheel.
   */
  steps?: "preview" | "slow";
  /** True if the wheel turns at standstill at the start and at gear changes; default true. */
  dwell?: boolean;
  /** Most time between two rows, seconds; default 0.05. */
  dt?: number;
}

/** Columns with one item per moment; times increase strictly. */
export interface Drive {
  /** Seconds. */
  t: Float64Array;
  /** x, y, heading, … per moment. */
  path: Float64Array;
  /** Distance driven, metres. */
  stations: Float64Array;
  /** m/s, negative in reverse. */
  speeds: Float64Array;
  /** Of `speeds` from here on, m/s². */
  accelerations: Float64Array;
  /** Angle of the middle front wheel, radians, positive to the left. */
  steering: Float64Array;
  /** The same in every browser and in Node. */
  hash: string;
}

export interface Trajectory extends Drive {
  /** Seconds. */
  duration: number;
  /** Metres. */
  length: number;
  /** Seconds at standstill to turn the wheel. */
  dwell: number;
  maxLateralAcceleration: number;
}

/** Limits and options of `optimise`. */
export interface OptimiseOptions extends MotionLimits {
  /** Metres kept from obstacles where the plan keeps as much; default 0.05. */
  margin?: number;
}

/**
 * A trajectory that a car can follow to the centimetre: at rest with a straight wheel at both ends, speed and steering
 * angle linear between rows, which are at most 0.05 s apart; headings do not jump by 2π.
 */
export interface OptimisedTrajectory extends Trajectory {
  /** From each row on, rad/s. */
  steeringRates: Float64Array;
  /**
   * The stage that made it: the optimised path, or the plan's own path, where the wheel turns on the way at each step
   * of the curvature, or at a standstill.
   */
  stage: "optimised" | "continuous-curvature" | "stop-and-steer";
  /** The referee's verdict. */
  check: Judgement;
}

/** How closely a simulated car followed. */
export interface Tracking {
  t: Float64Array;
  /** Poses of the simulated car: x, y, heading, … */
  path: Float64Array;
  /** Metres to the left of the path. */
  lateral: Float64Array;
  /** Radians. */
  steering: Float64Array;
  /** Metres. */
  maxLateral: number;
  /** Radians. */
  maxHeading: number;
  /** Metres and radians between the last pose and the path's. */
  endDistance: number;
  endHeading: number;
  /** The first obstacle that the body overlapped. */
  hit: Check["firstHit"];
  /** At most 0.10 m to the side, 0.10 m and 0.05 rad off at the end, no hit. */
  passes: boolean;
  hash: string;
}

export interface WaitOptions {
  /**
   * "predictive" (default): stops before a hit to come, where it is safe to stand. "reactive", the parking paper's:
   * stops while an obstacle is on the way ahead or, with a trajectory, while a moving one is nearer to it than the car
   * needs to brake. It can be in a box's way, and `contact` tells so.
   */
  rule?: "predictive" | "reactive";
  /** How far ahead "reactive" looks: to the end (default), or a stopping distance. */
  scope?: "remaining" | "window";
  /** Along a plan, m/s; default 2. A trajectory has its own speeds. */
  speed?: number;
  /** For a plan's window, m/s²; default 1.5. Along a trajectory the car brakes as hard as that does itself. */
  deceleration?: number;
  /** Metres kept when it decides to stop, default 0.3, and when it decides to go on, default 0.5. */
  margin?: number;
  releaseMargin?: number;
  /** Seconds after which the drive is given up; default 600. */
  maxTime?: number;
  /** Seconds between two decisions; default 0.05. */
  dt?: number;
}

/** A drive among a scene's moving obstacles, checked by outlines. */
export interface Encounter extends Drive {
  /** "unavoidable": there was no place to stand safely. "blocked": an obstacle stays on the path for ever. */
  ending: "arrived" | "unavoidable" | "hit" | "blocked" | "out-of-time";
  /** Per moment: metres from the body to the nearest box; Infinity where there is none. */
  clearances: Float64Array;
  /**
   * Per moment: seconds until the body would touch a moving box if both kept their velocity; Infinity where they never
   * would.
   */
  timesToCollision: Float64Array;
  /** Per moment, per moving obstacle: x, y, heading of the box. */
  boxes: Float64Array;
  waits: { pose: Pose; station: number; from: number; to: number }[];
  /** The first overlap: whose, its index in `moving`, when, where the car was and whether it stood. */
  contact: { obstacle: string; index: number; t: number; pose: Pose; standing: boolean } | null;
  /** Seconds, with and without waiting. */
  duration: number;
  freeDuration: number;
}

/** Limits of a car in motion; the steering angle's limit is the car's own. */
export interface MotionLimits {
  /** m/s in either gear; default 2.5. */
  speed?: number;
  /** m/s²; default 1. */
  acceleration?: number;
  /** m/s²; default 1. */
  deceleration?: number;
  /** rad/s; default 0.5, and never more than the car's own `maxSteerRate`. */
  steeringRate?: number;
  /** v²·|κ|, m/s²; none where absent. */
  lateralAcceleration?: number | null;
}

/**
 * What the referee takes. With `t` (seconds, increasing from 0) a trajectory; without, a path, which is given times run
 * by run and driven by a simulated car.
 */
export interface JudgedTrajectory {
  /** x, y, heading, … */
  path: Float64Array | number[];
  t?: Float64Array | number[];
  /** m/s, negative in reverse; from the poses where absent. */
  speeds?: Float64Array | number[];
  /** Radians, positive to the left; from the poses where absent. */
  steering?: Float64Array | number[];
  /** Of a path without times: gear (±1) of the way on from each pose; from the poses where absent. */
  directions?: Int8Array | number[];
}

/** The referee's verdict on a trajectory, by the protocol of the public benchmarks. */
export interface Judgement {
  /** Attained, no touching frame, all between frames certified, limits kept. */
  passes: boolean;
  /**
   * It begins at the scene's start, ends at rest within 1 cm in x and in y and 1° of the goal, and its poses are those
   * of a car with these speeds and steering angles, to 1 cm and 0.5°.
   */
  attained: boolean;
  /** Speed, acceleration, steering angle and steering rate, to 0.1 %. */
  keepsLimits: boolean;
  /** Moments at which the whole body was held against the obstacles: every millisecond, every row and the end. */
  frames: number;
  /** Those at which it overlaps something, and moments between two of them where an overlap was found. */
  touchingFrames: number;
  /** Stretches between two frames that are neither certified as free nor known to touch. */
  uncertified: number;
  firstContact: { obstacle: string; index: number; pose: Pose; t: number } | null;
  /** The least clearance that was measured, metres. */
  minClearance: number;
  /** Seconds. */
  duration: number;
  /** Metres driven. */
  length: number;
  /** ∫ a² + v²·ω² dt. */
  effort: number;
  /** ∫ φ² dt. */
  steeringEffort: number;
  /** Sign changes of the speed beyond 0.01 m/s. */
  gearChanges: number;
  /** 10 · effort + 10 · steeringEffort + 5 · gearChanges. */
  smoothness: number;
  /** smoothness + 100 · duration. */
  tpcapCost: number;
  /** m/s, m/s², m/s², rad, rad/s, m/s². */
  maxSpeed: number;
  maxAcceleration: number;
  maxDeceleration: number;
  maxSteering: number;
  maxSteeringRate: number;
  maxLateralAcceleration: number;
  /** Of the first pose from the scene's start: metres, radians. */
  startError: { distance: number; heading: number };
  /** Of the last pose from the goal: metres, radians. */
  endError: { x: number; y: number; heading: number };
  /** m/s. */
  endSpeed: number;
  /** Of the poses from a replay of speeds and steering angles, at most: metres, radians. */
  modelError: { distance: number; heading: number };
}

/** Of a path on a road, along the line of the car's middle. */
export interface RoadFigures {
  /** Metres of that line. */
  middleLength: number;
  /**
   * Of the body, pointing along that line, 5 m at the ends left out; below zero where it overlaps. The capped mean
   * counts at most 1.2 m.
   */
  bodyClearanceMin: number;
  bodyClearanceMean: number;
  bodyClearanceMeanCapped: number;
  /** Of the middle, less half the width. */
  sideClearanceMin: number;
  sideClearanceMean: number;
  /** Sum of the changes of the middle's curvature from metre to metre, and its largest, 1/m. */
  curvatureVariation: number;
  middleCurvature: number;
  /** Metres from the nearest lane's middle; null without lanes. */
  laneDeviationMax: number | null;
  laneDeviationMean: number | null;
  /** Share of the way, 0 to 1, on which the middle is to the left of all lanes. */
  laneLeftShare: number | null;
}

/** A vehicle of the library, from the standards and everyday traffic; metres and radians. */
export interface LibraryVehicle {
  id: string;
  title: { en: string; zh: string };
  wheelbase: number;
  /** Front axle to front bumper, rear axle to rear bumper. */
  frontOverhang: number;
  rearOverhang: number;
  /** Without mirrors. */
  width: number;
  /** Null where the source does not state it. */
  widthWithMirrors: number | null;
  maxSteer: number;
  /**
   * Radii of the circles of the outer front wheel and of the outer front corner at full lock, as the source states
   * them.
   */
  kerbRadius: number | null;
  wallRadius: number | null;
  /** Fields that the source leaves open and that were chosen here. */
  assumed: string[];
  source: string;
  /** The same as dimensions of a scene's vehicle, without mirrors. */
  vehicle: Vehicle;
}

/** Where vehicles come in and leave. */
export interface Entrance {
  id: string;
  /** Of the scene's car; other vehicles stand with their tail in the same place. */
  pose: Pose;
  /** Where they leave; where absent, at the entrance with the nose at the other end. */
  exit?: Pose;
}

export interface AuditOptions {
  /** Ids of the library, profiles, or dimensions with an id of one's own; default: the scene's car. */
  vehicles?: (string | { id: string; vehicle: VehicleSpec })[];
  /** Default: head-in and reverse-in. */
  entries?: ("head-in" | "reverse-in")[];
  /** Occupied bays are left out ("as-is", the default), or each is asked as if it were free. */
  whatIf?: "as-is" | "each-free";
  /** Default: the scene's start, with the id "start". */
  entrances?: Entrance[];
  /** Ids or indices of slots; default: all. Parts give exactly the rows of the whole. */
  bays?: (string | number)[];
  /** True (default) if ways out are asked as well. */
  out?: boolean;
  /** Settings of `hybrid`, laid over the scene's. */
  settings?: Partial<PlannerSettings["hybrid"]>;
}

/** A way in or out, or why there is none. */
export interface AuditWay {
  /** True if there is a path that the independent validator accepts. */
  reachable: boolean;
  /** As a plan's; `budget-spent` where nothing is proven. */
  outcome: Outcome;
  detail: Detail | null;
  /** For people, where there is no path. */
  reason: string | null;
  /** The place that blocks the way, or the obstacle's point nearest to the body on it. */
  place: [number, number] | null;
  /** What stands there, by name. */
  blocker: string | null;
  /** Gear changes and one; 0 without a path. */
  moves: number;
  length: number;
  /** Seconds. */
  driveTime: number | null;
  /** Least distance from the body to anything along the way. */
  clearance: number;
  /** The plan's hash: for ways in that of `hybrid` between the same poses, for ways out that of `hybrid-forward`. */
  hash: string;
  /** x, y, heading, … half a metre apart along the way, and its last pose. */
  swept: Float64Array;
}

/** The answer for one bay, vehicle, entrance and entry. */
export interface AuditRow extends AuditWay {
  /** The slot's id, or `#` and its number from 1; `index` is its place in the scene's slots. */
  bay: string;
  index: number;
  vehicle: string;
  entrance: string;
  entry: "head-in" | "reverse-in";
  /** How far the parked body sticks out of the bay; 0 where it fits. */
  overhang: number;
  /** Null where `out` is false. */
  out: AuditWay | null;
}

/**
 * Asks of each bay whether each vehicle can drive in from each entrance, and out again: rows bay by bay, and for each
 * bay by vehicle, entrance and entry, in the order of the options. `onRow` is given each row at once; where it answers
 * false, the audit ends with the rows so far. `parkade` only, not `parkade/core`.
 */
export function audit(
  scene: Scenario, options?: AuditOptions & { onRow?: (row: AuditRow) => boolean | void },
): AuditRow[];
/**
 * An audit in parts, of which several run at once, such as in workers: the same rows as `audit`'s, in the same order,
 * for any number of them. `run` audits one part; at most `workers` (default 2) parts of `bays` bays (default 4) are
 * under way. `signal` ends it: it rejects with the signal's reason, and gives `run` the signal, too. `parkade` only,
 * not `parkade/core`.
 */
export function auditInParts(
  scene: Scenario,
  options: AuditOptions,
  run: (scene: Scenario, options: AuditOptions, signal?: AbortSignal) => AuditRow[] | Promise<AuditRow[]>,
  how?: {
    workers?: number;
    bays?: number;
    signal?: AbortSignal;
    /** After each part: bays so far, all bays, and the part's rows. */
    onProgress?: (progress: { done: number; total: number; rows: AuditRow[] }) => void;
  },
): Promise<AuditRow[]>;
/**
 * Of an audit's rows those that an edit can touch: their swept body comes near what was added or removed, their bay
 * changed, or they were out of reach and something was removed; all, where more than obstacles and slots changed. The
 * other rows stay true, but an audit of the edited scene may find other paths. `options`: the audit's. `parkade` only,
 * not `parkade/core`.
 */
export function affectedRows(before: Scenario, after: Scenario, rows: AuditRow[], options?: AuditOptions): AuditRow[];

/** How a lot is drawn; what is absent is the preset's or, without one, drawn by the seed. Metres and radians. */
export interface LotOptions {
  /** Id of one of `lotPresets`. */
  preset?: string;
  /** Default 1, or the preset's. */
  seed?: number;
  /** Rows of bays, two of which share an aisle: 1 to 40; bays in each: 1 to 100. */
  rows?: number;
  bays?: number;
  /** Between aisle and bay: 0.5 to π/2. */
  angle?: number;
  bayWidth?: number;
  bayLength?: number;
  /** Width of the aisles. */
  aisle?: number;
  /** Bays from one column to the next; 0 for none. */
  columns?: number;
  /** Share of occupied bays, 0 to 1. */
  occupancy?: number;
  /** 1 or 2. */
  entrances?: number;
  /** Width of a ramp that joins the first aisle at a right angle; 0 for none. */
  ramp?: number;
}

/** Draws a parking lot: the same for the same options. `parkade` only, not `parkade/core`. */
export function generateLot(options?: LotOptions): { scene: Scenario<Goal>; entrances: Pose[] };
/** Lots with a name. `parkade` only, not `parkade/core`. */
export function lotPresets(): { id: string; title: { en: string; zh: string }; bays: number }[];
/** The library of vehicles. `parkade` only, not `parkade/core`. */
export function vehicles(): LibraryVehicle[];

/** One way to drive from a pose to another with circles of one radius and straight lines, obstacles left out. */
export interface ReedsSheppCurve {
  /** Its arcs in order: L left, S straight, R right, each with + ahead or - in reverse, as in "L+S+R-". */
  word: string;
  /** Metres, reverse included. */
  length: number;
  directionChanges: number;
  /**
   * Per arc: x, y, heading at its beginning, curvature (1/m, positive to the left), signed length (negative: reverse).
   */
  arcs: [x: number, y: number, heading: number, curvature: number, length: number][];
}

/**
 * The Reeds–Shepp words between two poses for a turning radius in metres, the shortest first. Words that turn farther
 * than a shortest curve ever does are left out. `parkade` only, not `parkade/core`.
 */
export function reedsShepp(from: Pose, to: Pose, radius: number): ReedsSheppCurve[];

/** Figures of any path on a scene's road. `parkade` only, not `parkade/core`. */
export function roadFigures(scene: Scenario, plan: { path: Float64Array | number[] }): RoadFigures;
/**
 * How often a path ends in a collision when the car is beside it by chance: in each trial by 0.10 m throughout and 0.12
 * m along the way (standard deviations). Trials `from` to `from + trials` of a seed; slices add up. Defaults: 1000
 * trials from 0, seed 20260101. `discHits`: the same for a disc of the car's width. `parkade` only, not `parkade/core`.
 */
export function collisionRisk(
  scene: Scenario, plan: { path: Float64Array | number[] }, options?: { trials?: number; from?: number; seed?: number },
): { trials: number; hits: number; discHits: number };
/**
 * The band that the car's middle stays in during those drives: for each metre of the path, 5 m at the ends left out,
 * the points farthest to the left and to the right, x, y, x, y, …, metres. `parkade` only, not `parkade/core`.
 */
export function driveEnvelope(
  scene: Scenario, plan: { path: Float64Array | number[] }, options?: { trials?: number; from?: number; seed?: number },
): Float64Array;
/** How `toSVG` draws. */
export interface PictureOptions {
  /** Pixels, 16 to 8192; default 720 × 420. */
  width?: number;
  height?: number;
  /** "auto" (default) follows the reader's system. */
  theme?: "auto" | "light" | "dark";
  /** For screen readers; the scene's name where absent. */
  title?: string;
  /**
   * Where they are given, the picture is a playground of this size with these attributes, to the pixel where its map
   * is: a poster. Others are drawn by the playground's own `toSVG`.
   */
  layout?: "single" | "overlay";
  controls?: "none" | "minimal";
  /** The visible area; by default start, goal and the cars' way. */
  camera?: Camera | null;
  /** Rasters of the plan that leads (hybrid's, or else the last): `safety` and `risk` are drawn. */
  layers?: Partial<Record<LayerName, Layer>>;
  /** Planned paths, by planner, of which trajectories took the place: x, y, heading; drawn as thin lines. */
  planned?: Readonly<Record<string, ArrayLike<number>>>;
  /** CSS colours and the font in place of the page's, by the names of its `--parkade-…` properties without that. */
  colours?: Readonly<Record<string, string>>;
}

/** The world's point in the middle of a picture (m), and pixels of a metre. */
export interface Camera {
  x: number;
  y: number;
  scale: number;
}

/**
 * A picture of a scene and its plans, drawn as the page draws it first, to the pixel; the scene itself is in the
 * picture's `metadata`. Plans with a trace show their search. `parkade` only, not `parkade/core`.
 */
export function toSVG(scene: Scenario, plans?: Plan | readonly Plan[], options?: PictureOptions): string;
/** A path with what is measured along it: a plan, or the path of a drive and its check. */
export interface MeasuredPath extends DrivenPath {
  /** Per pose; NaN or null at a corner. */
  curvatures: Float64Array | (number | null)[];
  directions: Int8Array | number[];
  clearances: Float64Array | (number | null)[];
}

/**
 * A path's poses as CSV: s,x,y,theta,kappa,clearance,v,direction,t in metres, radians, 1/m, m/s, ±1 and seconds.
 * Corners have no kappa; v and t are those of `drive`, which is by default the plan's `trajectory`, and absent where
 * this car cannot drive. `parkade` only, not `parkade/core`.
 */
export function toCSV(scene: Scenario, plan: Plan | MeasuredPath, drive?: Drive | null): string;
/** Gives a path times. Throws ParkadeError for paths that this car cannot drive. `parkade` only, not `parkade/core`. */
export function trajectory(scene: Scenario, plan: DrivenPath, limits?: Limits): Trajectory;
/**
 * Makes a trajectory of a plan that passes its check, from its first pose to its last: the path may change its shape,
 * and gear changes their places. `parkade` only, not `parkade/core`.
 */
export function optimise(scene: Scenario, plan: DrivenPath, options?: OptimiseOptions): OptimisedTrajectory;
/** A drive as CSV, as `judge` reads it: t,x,y,theta,v,phi,a,omega. `parkade` only, not `parkade/core`. */
export function toTrajectoryCSV(drive: Drive | OptimisedTrajectory): string;
/**
 * Lets a simulated car follow a path, or an optimised trajectory at its own speeds. `parkade` only, not `parkade/core`.
 */
export function track(
  scene: Scenario, plan: DrivenPath, options?: Limits & { controller?: "feedback" | "pure-pursuit" | "stanley" },
): Tracking;
/**
 * Judges a trajectory or a path: columns, or CSV with a header (`t,x,y,theta[,v,phi[,a,omega]]` or `x,y,theta[,gear]`;
 * seconds, metres, radians). Throws ParkadeError, with `path` the line and column of CSV. `parkade` only, not
 * `parkade/core`.
 */
export function judge(scene: Scenario, trajectory: JudgedTrajectory | string, limits?: MotionLimits): Judgement;
/**
 * Waits for the scene's moving obstacles along a path, at constant speed as in the parking paper, or along an optimised
 * trajectory, within its limits. `parkade` only, not `parkade/core`.
 */
export function stopWaitGo(scene: Scenario, plan: DrivenPath | OptimisedTrajectory, options?: WaitOptions): Encounter;
