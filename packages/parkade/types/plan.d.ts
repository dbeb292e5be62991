/** A plan: outcome, path, counts, figures and rasters, by family of planners. */

import type { GridPlannerId, HybridPlannerId, PlannerId, RoadPlannerId } from "../settings.js";
import type { Check, Hit, RoadFigures } from "./check.js";
import type { TakenGoal } from "./scene.js";
import type { ArcTrace, CellTrace, Trace } from "./trace.js";

export type Outcome =
  | "found" | "no-path" | "budget-spent" | "start-blocked" | "goal-blocked" | "start-outside" | "goal-outside";

/** A finer word for the outcome. */
export type Detail =
  | "unreachable" | "too-narrow" | "no-room" | "boxed-in" | "incomplete" | "suboptimal" | "verification-failed"
  | "smoothing-fell-back" | "less-margin";

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
   * The margin planned with, metres. The path keeps it to 3 mm. It is less than asked where start or goal have less or
   * only less leads there, 2 mm at least where they have that.
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
