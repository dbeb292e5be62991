/** The module and its planners. */

import type { PlannerId, PlannerSettings } from "../settings.js";
import type { Explanation, Found, HybridPlan, Layer, LayerName, PlanOf, Prefer } from "./plan.js";
import type { Goal, Scenario } from "./scene.js";
import type { Expansions, PoseTrace, SearchTrace, Trace } from "./trace.js";

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
   * `prefer` other settings are asked for ways as well, and the answer is the path that costs least by these, with no
   * less margin. `onImproved` is given the ordinary plan, and each better one as soon as it is found; what it throws
   * counts as in `onProgress`. All are bounded by counted work, a few times that of an ordinary plan of a tight slot,
   * and the same everywhere.
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
