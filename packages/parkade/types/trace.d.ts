/** Searches as they went: what was expanded, and every event with its reason. */

import type { Pose } from "./scene.js";

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
 * Some of a search's expansions in their order, as in a trace: cells, or arcs (x, y, heading, curvature, signed
 * length). `search` counts the searches of a plan from 0: hybrid's may be several, of which the last is the trace's.
 */
export type Expansions =
  | { kind: "cells"; search: number; cells: Uint32Array }
  | { kind: "arcs"; search: number; arcs: Float64Array };
