import type { WorkerPool as SharedPool } from "parkade/worker/pool";
import type { Reply, Request } from "./protocol";

export { KEPT_MS, mostWorkers, WorkerPool, type Holder } from "parkade/worker/pool";

/** The part of a Worker that a lane needs; tests substitute their own. */
export interface WorkerLike {
  onmessage: ((event: MessageEvent<Reply>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  postMessage(request: Request): void;
  terminate(): void;
}

/** The workers of all playgrounds of a page that plan with one module. */
export type PlanWorkers = SharedPool<WorkerLike>;
