/** The layers that the first picture does without. */
export { drawBayNumbers, drawBays } from "./bays";
export { drawCost } from "./cost-raster";
export { drawDifference } from "./difference";
export { drawDraft } from "./draft";
export { drawExplained } from "./explained";
export { drawFailure } from "./failure";
export { drawOthers, drawPreview } from "./ghosts";
export { drawGoals } from "./goals";
export { drawGuest } from "./guest";
export { drawLaneStrip } from "./lane-strip";
export { drawLanes } from "./lanes";
export { drawContact, drawMoving } from "./moving";
export { drawObstruction } from "./obstruction";
export { drawCosts } from "./painted-costs";
export { drawSelection } from "./selection";
export { TreeLayer } from "./tree";
export { drawUnsmoothed } from "./unsmoothed";
