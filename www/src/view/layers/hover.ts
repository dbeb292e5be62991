/** The shared crosshair; out of the way while something is dragged. */
import { inPixels, toScreen, type Frame } from "../frame";
import { fade } from "../tokens";

export function drawHover(frame: Frame): void {
  const { hover, transient } = frame.state;
  if (!hover || transient) return;
  const { ctx, view, tokens: { colour } } = frame;
  const [sx, sy] = toScreen(frame, [hover.x, hover.y]);
  const x = Math.round(sx) + 0.5, y = Math.round(sy) + 0.5;
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
}
