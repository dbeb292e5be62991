/** The layers that the first picture does without, and what is told of the cell under the pointer. */
import type { App } from "../app/app";
import { follow as followStore } from "../app/follow";
import { taskIn } from "../app/task-link";
import "./choices";
import "./failure-line";
import "./smooth-switch";
export { encounterOf } from "../texts/encounter";
export { whyOf } from "../texts/failure";
export { legendOf, readoutOf, weightsOf } from "../texts/readout";
export { showScale } from "../texts/scale-bar";
export { drawBayNumbers, drawBays } from "../view/layers/bays";
export { costRange, drawCost } from "../view/layers/cost-raster";
export { drawCosts } from "../view/layers/painted-costs";
export { drawDifference } from "../view/layers/difference";
export { drawDraft } from "../view/layers/draft";
export { drawFailure } from "../view/layers/failure";
export { drawExplained } from "../view/layers/explained";
export { gearMarks } from "./gear-marks";
export { spokenOf } from "./spoken";
export { drawGoals } from "../view/layers/goals";
export { drawOthers, drawPreview } from "../view/layers/ghosts";
export { drawLaneStrip } from "../view/layers/lane-strip";
export { drawLanes } from "../view/layers/lanes";
export { drawContact, drawMoving } from "../view/layers/moving";
export { drawGuest } from "../view/layers/guest";
export { drawObstruction } from "../view/layers/obstruction";
export { drawUnsmoothed } from "../view/layers/unsmoothed";
export { TreeLayer } from "../view/layers/tree";

/** Follows the store, and shows the task of the page's address. */
export function follow(app: App): void {
  followStore(app);
  const task = taskIn(location.hash);
  if (task) void app.fetchPart(async () => (await import("./task")).showTask(app, task));
}
