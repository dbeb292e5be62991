/** Site plans for programs: the same conversion as the page's. */
export { readSitePlan } from "./read-site-plan";
export { SitePlanError } from "./site-plan";
export { sceneFromSitePlan, suggestedRole, suggestedUnit } from "./site-plan-scene";
