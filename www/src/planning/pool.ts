import type { WorkerPool as SharedPool } from "parkade/worker/pool";
import type { WorkerLike } from "./planner-queue";

export { KEPT_MS, mostWorkers, WorkerPool, type Holder } from "parkade/worker/pool";

/** The workers of all playgrounds of a page that plan with one module. */
export type PlanWorkers = SharedPool<WorkerLike>;
