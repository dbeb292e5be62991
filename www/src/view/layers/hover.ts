/** The shared crosshair; out of the way while something is dragged. */
import { nearestPose, poseAt } from "../drive";
import { inPixels, leading, toScreen, type Frame } from "../frame";
import { fade, plannerStyle } from "../tokens";

export function drawHover(frame: Frame): void {
  const { hover, transient } = frame.state;
  if (!hover || transient) return;
  const {
    ctx,
    view,
    tokens: { colour },
  } = frame;
  const [sx, sy] = toScreen(frame, [hover.x, hover.y]);
  const x = Math.round(sx) + 0.5,
    y = Math.round(sy) + 0.5;
  inPixels(frame);
  ctx.setLineDash([2, 3]);
  ctx.lineWidth = 1;
  ctx.strokeStyle = fade(colour.t1, 0.45);
  ctx.beginPath();
  ctx.moveTo(x, 0);
  ctx.lineTo(x, view.height);
  ctx.moveTo(0, y);
  ctx.lineTo(view.width, y);
  ctx.stroke();
  ctx.setLineDash([]);
  drawMark(frame, hover);
}

/** A ring on the focused path where the pointer, here or on a chart, is near it. */
function drawMark(frame: Frame, hover: { x: number; y: number }): void {
  const one = leading(frame),
    near = one?.plan ? nearestPose(one.plan, hover.x, hover.y) : null;
  if (!one?.plan || near === null) return;
  const { ctx, tokens } = frame,
    { x, y } = poseAt(one.plan, near);
  ctx.beginPath();
  ctx.arc(...toScreen(frame, [x, y]), 5.5, 0, 2 * Math.PI);
  ctx.fillStyle = tokens.colour.floor;
  ctx.fill();
  ctx.lineWidth = 2.5;
  ctx.strokeStyle = plannerStyle(tokens, one.planner).colour;
  ctx.stroke();
}
