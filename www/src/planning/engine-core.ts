/**
 * The first picture's planners and their worker in one file: the page and every worker load the same script. It must
 * import nothing that the page imports too, or workers would load the page.
 */
import { Planner, init, planners } from "parkade/core";
import { serve } from "./plan-worker";

export { failureOf } from "./failure";
export { init, packRuns, planners, scenario, sceneGeometry, scenarios, unpackRuns } from "parkade/core";

/** The address for `new Worker`. */
export const script = import.meta.url;

if (typeof document === "undefined") serve({ Planner, init, planners } as unknown as Parameters<typeof serve>[0]);
