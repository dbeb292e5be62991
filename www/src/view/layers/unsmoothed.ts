/** The planned path under the trajectory that took its place. */
import { plannedOf } from "../../store/results";
import { inMetres, pixels, type Frame } from "../frame";
import { plannerStyle } from "../tokens";
import { metreLine } from "./metre-line";

const WIDTH_PX = 1.25,
  STRENGTH = 0.7;

export function drawUnsmoothed(frame: Frame): void {
  const { ctx, shown } = frame;
  for (const { result, plan, planner, ghost, planned } of shown) {
    const path = planned ?? plannedOf(plan, result);
    if (ghost || !path) continue;
    ctx.save();
    inMetres(frame);
    ctx.globalAlpha = STRENGTH;
    ctx.strokeStyle = plannerStyle(frame.tokens, planner).colour;
    ctx.lineWidth = pixels(frame, WIDTH_PX);
    ctx.stroke(metreLine(path));
    ctx.restore();
  }
}
