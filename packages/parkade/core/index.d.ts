/** The small module: five planners and what a first picture needs. What is not said here is as in `parkade`. */

import type * as complete from "../index.js";
import type { GridPlannerId, HybridPlannerId, PlannerId, PlannerSettings } from "./settings.js";

export { ParkadeError, init, packRuns, scenarios, unpackRuns, version } from "../index.js";
export type {
  ArcTrace, CellTrace, Check, CostArea, Detail, ErrorCode, FailedExpansions, Goal, GridMetrics, GridStats, Hit,
  HybridMetrics, HybridStats, Lane, Layer, MapFrame, Metrics, MovingObstacle, Obstacle, Obstruction, Outcome,
  ParameterInfo, PathMetrics, Pose, Road, Run, ScenarioInfo, SceneVehicle, SearchStats, Slot, SpeedLimit,
  Stats, Trace, Vehicle,
} from "../index.js";
export type * from "./settings.js";

export type VehicleSpec = Exclude<complete.VehicleSpec, "ship">;

/** One goal; planners leave moving obstacles, lanes and speed limits out, unchecked. */
export interface Scenario extends Omit<complete.Scenario<complete.Goal>, "vehicle" | "planners"> {
  vehicle?: VehicleSpec;
  planners?: Partial<PlannerSettings>;
}

export type PlannerInfo = complete.PlannerInfo & { id: PlannerId; family: "grid" | "hybrid" };

export type SceneGeometry = Omit<complete.SceneGeometry, "goals">;

export type GridPlan = complete.GridPlan & { planner: GridPlannerId };
export type HybridPlan = Omit<complete.HybridPlan, "member" | "alternatives"> & { planner: HybridPlannerId };
export type Plan = GridPlan | HybridPlan;
export type PlanOf<Id extends PlannerId> = Id extends GridPlannerId ? GridPlan : HybridPlan;

export type LayerName = Exclude<complete.LayerName, "redundant" | "cost">;

export function planners(): PlannerInfo[];
export function defaultConfig<Id extends PlannerId>(planner: Id): Required<PlannerSettings[Id]>;
export function scenario(id: string): Scenario;
/** Checks a scene and resolves it to geometry. Throws ParkadeError. */
export function sceneGeometry(scene: Scenario): SceneGeometry;
/** Re-checks any path (x, y, heading, …) against a scene. `directions` defaults to forward throughout. */
export function checkPath(
  scene: Scenario, path: Float64Array | number[], directions?: Int8Array | number[],
): complete.Check;

export class Planner<Id extends PlannerId = PlannerId> {
  /** Checks scene and settings and prepares the map, once. Throws ParkadeError. */
  constructor(planner: Id, scene: Scenario, config?: PlannerSettings[Id]);
  /** `start` and `goal` take the place of the scene's in this plan, and in `layer` until the next one. */
  plan(options?: {
    trace?: boolean;
    start?: complete.Pose;
    goal?: complete.Pose;
    onProgress?: (expansions: number) => void;
  }): PlanOf<Id>;
  /** A raster of this planner's map, between the ends of the last plan. */
  layer(name: LayerName, options?: { every?: number }): complete.Layer;
  free(): void;
  [Symbol.dispose](): void;
}
