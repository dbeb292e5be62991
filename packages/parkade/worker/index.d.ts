import type {
  DrivenPath, Expansions, Goal, Layer, LayerName, OptimiseOptions, OptimisedTrajectory, PlannerId, PlannerSettings,
  PlanOf, Prefer, Scenario,
} from "../index.js";

export { ParkadeError } from "../index.js";
export { transferables } from "./transfer.js";

/** As of `Planner.plan`, and what a worker adds. */
export interface WorkerPlanOptions<Id extends PlannerId = PlannerId> {
  /** Ends the search; the promise rejects at once with the signal's reason. */
  signal?: AbortSignal;
  trace?: boolean;
  start?: Goal;
  goal?: Goal;
  prefer?: Prefer;
  alternatives?: boolean;
  stickiness?: number;
  /** Rasters to bring along, between the ends of this plan. */
  layers?: readonly LayerName[];
  /** What it throws ends the search and rejects the promise. */
  onProgress?: (expansions: number) => void;
  onImproved?: (plan: PlanOf<Id>) => void;
  /** Expansions while the search runs, for drawings of one's own; their arrays are moved. */
  onExpanded?: (events: Expansions) => void;
}

/** A planner in a worker. Its jobs run one after the other; those of several planners run side by side. */
export interface WorkerPlanner<Id extends PlannerId = PlannerId> {
  /** The plan that `Planner.plan` makes, with the same hash; its arrays are moved, not copied. */
  plan(options?: WorkerPlanOptions<Id> & { layers?: undefined }): Promise<PlanOf<Id>>;
  plan(options: WorkerPlanOptions<Id>): Promise<PlanOf<Id> & { layers: Partial<Record<LayerName, Layer>> }>;
  /** `optimise` of the package, beside the page: it takes 30 ms and more. */
  optimise(plan: DrivenPath, options?: OptimiseOptions & { signal?: AbortSignal }): Promise<OptimisedTrajectory>;
  /**
   * Another scene, and other settings where they are given, for what is asked from now on. A scene that is refused
   * changes nothing.
   */
  update(scene: Scenario, settings?: PlannerSettings[Id]): Promise<void>;
  /** Ends what runs, rejects what waits with code "freed", and gives the worker back. Again, it does nothing. */
  free(): void;
  [Symbol.dispose](): void;
}

/**
 * Prepares a planner in a worker of the common pool: as many workers as processors in Node.js, 6 to 8 in browsers. They
 * are started when they are needed, and end when none has been used for a minute. Rejects with ParkadeError where scene
 * or settings are refused. The scene is copied: later changes of the object change nothing.
 */
export function createPlanner<Id extends PlannerId>(
  planner: Id, scene: Scenario, settings?: PlannerSettings[Id],
): Promise<WorkerPlanner<Id>>;

/** What `createPool` needs of a worker; browsers' workers have it. */
export interface WorkerLike {
  onmessage: ((event: MessageEvent) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  postMessage(message: unknown): void;
  terminate(): void;
}

export interface PoolOptions {
  /** Workers at the same time, 1 to 256. */
  size?: number;
  /** Bytes, module or address of `parkade_bg.wasm`, where it is not beside the package's script. */
  wasm?: BufferSource | WebAssembly.Module | URL | string;
  /** Starts a worker whose script imports `parkade/worker/script`, for bundlers that do not find the package's own. */
  spawn?: () => WorkerLike;
}

export interface Pool {
  createPlanner: typeof createPlanner;
  /** Frees its planners and ends its workers. */
  close(): void;
}

/** Workers of one's own, beside the common pool. */
export function createPool(options?: PoolOptions): Pool;

/**
 * Of many calls that overtake each other, as while something is dragged, runs one at a time and keeps the newest: a
 * call that a newer one overtakes resolves to undefined. A run that takes longer than `giveUpAfter` (1000 ms) while a
 * newer one waits is aborted by the signal that it is given.
 */
export function latest<Args extends unknown[], Result>(
  run: (signal: AbortSignal, ...args: Args) => Promise<Result>, options?: { giveUpAfter?: number },
): (...args: Args) => Promise<Result | undefined>;
