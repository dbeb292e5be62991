/** The layers that the first picture does without, and what is told of the cell under the pointer. */
import "../panels/choices";
import "../panels/failure-line";
export { encounterOf } from "../panels/encounter";
export { whyOf } from "../panels/failure-words";
export { legendOf, readoutOf, weightsOf } from "../panels/readout";
export { showScale } from "../panels/scale-bar";
export { costRange, drawCost } from "./layers/cost";
export { drawCosts } from "./layers/costs";
export { drawDifference } from "./layers/difference";
export { drawDraft } from "./layers/draft";
export { drawFailure } from "./layers/failure";
export { drawExplained } from "./layers/explained";
export { drawOthers, drawPreview } from "./layers/ghosts";
export { drawLaneStrip } from "./layers/lane-strip";
export { drawLanes } from "./layers/lanes";
export { drawContact, drawMoving } from "./layers/moving";
export { drawObstruction } from "./layers/obstruction";
export { TreeLayer } from "./layers/tree";
