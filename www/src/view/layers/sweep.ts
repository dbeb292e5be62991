/** The swept area: one outline, however often the car passes. */
import { GHOST, inMetres, pixels, type Frame, type Shown } from "../frame";
import { vast } from "../lazy-large-maps";
import { sweptArea } from "../swept";
import { plannerStyle } from "../tokens";

/** Numbers of a path beyond which its outline is not worth its time. */
const LONG = 3 * 3000;
const FILL = 0.15,
  EDGE = 0.75,
  EDGE_PX = 0.8;

/** Only of paths the car can drive: elsewhere the hits are what matters. */
export function drawSweep(frame: Frame, shown: Shown): void {
  const { plan, planner } = shown;
  if (!plan?.check.drivable || plan.path.length < 6) return;
  const { ctx } = frame;
  if (plan.path.length > LONG && vast()?.drawLongSweep(frame, shown)) return;
  const area = sweptArea(plan, frame.resolved.vehicle),
    { colour } = plannerStyle(frame.tokens, planner);
  const strength = shown.ghost ? GHOST : 1;
  ctx.save();
  inMetres(frame);
  ctx.globalAlpha = FILL * strength;
  ctx.fillStyle = colour;
  ctx.fill(area.fill);
  ctx.globalAlpha = EDGE * strength;
  ctx.strokeStyle = colour;
  ctx.lineWidth = pixels(frame, EDGE_PX);
  ctx.lineCap = "round";
  ctx.stroke(area.edge);
  ctx.restore();
}
