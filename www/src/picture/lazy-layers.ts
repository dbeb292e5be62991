/** The pieces of the drawing that pictures need, at hand at once. */
import { drawCost } from "../view/layers/cost-raster";
import { drawCosts } from "../view/layers/painted-costs";
import { drawFailure } from "../view/layers/failure";
import { drawLaneStrip } from "../view/layers/lane-strip";
import { drawLanes } from "../view/layers/lanes";
import { drawContact, drawMoving } from "../view/layers/moving";
import { drawObstruction } from "../view/layers/obstruction";

const held = { drawContact, drawCost, drawCosts, drawFailure, drawLanes, drawLaneStrip, drawMoving, drawObstruction };

export const extras = (): typeof held => held;
/** Files draw every cell and pose. */
export const vast = (): null => null;
