/** The same as `engine.ts` with every planner and format; its workers also do what takes long beside planning. */
import { Planner, init, planners } from "parkade";
import { driveOf } from "./drive-of";
import { serveJobs } from "./job-worker";
import { serve } from "./plan-worker";

export { failureOf } from "./failure";
export { init, packRuns, planners, scenario, sceneGeometry, scenarios, unpackRuns, vehicles } from "parkade";

/** The address for `new Worker`. */
export const script = import.meta.url;

if (typeof document === "undefined") {
  serve({ Planner, init, planners, driveOf });
  serveJobs();
}
