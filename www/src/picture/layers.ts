/** The layers that pictures need beside those of the first picture: at hand at once. Maps are drawn cell by cell. */
import { drawCost } from "../view/layers/cost-raster";
import { drawCosts } from "../view/layers/painted-costs";
import { drawFailure } from "../view/layers/failure";
import { drawLaneStrip } from "../view/layers/lane-strip";
import { drawLanes } from "../view/layers/lanes";
import { drawContact, drawMoving } from "../view/layers/moving";
import { drawObstruction } from "../view/layers/obstruction";
import { drawUnsmoothed } from "../view/layers/unsmoothed";
import { laterLayers, type LaterLayers } from "../view/lazy-layers";

const held: Partial<LaterLayers> = {
  drawContact,
  drawCost,
  drawCosts,
  drawFailure,
  drawLanes,
  drawLaneStrip,
  drawMoving,
  drawObstruction,
  drawUnsmoothed,
};

laterLayers.hold(held as LaterLayers);
