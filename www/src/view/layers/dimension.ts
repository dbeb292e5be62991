/** A length on the map, with its figure. */
import type { Point } from "../../scene/geometry";
import { inPixels, toScreen, type Frame } from "../frame";
import { drawPill, PILL_HEIGHT, pillWidth } from "../text";

/** A line with ticks across its ends, and its length beside it. */
export function drawDimension(frame: Frame, a: Point, b: Point, text: string, ink = frame.tokens.colour.err): void {
  const {
    ctx,
    tokens: { colour },
    view,
  } = frame;
  const from = toScreen(frame, a),
    to = toScreen(frame, b);
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1,
    across: Point = [(from[1] - to[1]) / length, (to[0] - from[0]) / length];
  inPixels(frame);
  ctx.beginPath();
  ctx.moveTo(from[0], from[1]);
  ctx.lineTo(to[0], to[1]);
  for (const [x, y] of [from, to]) {
    ctx.moveTo(x - 5 * across[0], y - 5 * across[1]);
    ctx.lineTo(x + 5 * across[0], y + 5 * across[1]);
  }
  for (const [style, width] of [
    [colour.floor, 5],
    [ink, 2],
  ] as const) {
    ctx.strokeStyle = style;
    ctx.lineWidth = width;
    ctx.stroke();
  }
  if ([from, to].every(([x, y]) => x < 0 || y < 0 || x > view.width || y > view.height)) return;
  const wide = pillWidth(frame, text),
    right = across[0] > 0 || Math.abs(across[0]) < 0.3;
  const x = (from[0] + to[0]) / 2 + (right ? 14 : -14 - wide),
    y = (from[1] + to[1]) / 2 + (Math.abs(across[0]) < 0.3 ? 14 : -PILL_HEIGHT / 2);
  drawPill(
    frame,
    text,
    Math.min(Math.max(4, x), view.width - wide - 4),
    Math.min(Math.max(34, y), view.height - PILL_HEIGHT - 4),
  );
}
