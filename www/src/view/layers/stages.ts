/** Stages of a grid planner's path: the cells, the corners that pruning keeps, the circles that round them. */
import type { Stages } from "parkade";
import { inMetres, inPixels, linePath, pixels, toScreen, type Frame } from "../frame";
import type { Point } from "../../scene/geometry";
import { newPath } from "../surface";
import { fade } from "../tokens";
import { nth } from "../../scene/nth";

const CELL_PX = 1.6,
  CORNER_PX = 3.5,
  TOUCH_PX = 2.5;

export function drawStages(frame: Frame, raw: Float64Array, { pruned, arcs, sharp }: Stages): void {
  const {
      ctx,
      tokens: { colour, planner },
    } = frame,
    green = nth(planner, 2);
  const cells: Point[] = Array.from({ length: raw.length / 2 }, (_, i) => [nth(raw, 2 * i), nth(raw, 2 * i + 1)]);
  ctx.save();
  inMetres(frame);
  ctx.lineWidth = pixels(frame, 1);
  ctx.strokeStyle = colour.t3;
  ctx.stroke(linePath(cells));
  ctx.lineWidth = pixels(frame, 1.5);
  ctx.strokeStyle = colour.t1;
  ctx.setLineDash([pixels(frame, 6), pixels(frame, 4)]);
  ctx.stroke(linePath(pruned));
  ctx.setLineDash([pixels(frame, 2), pixels(frame, 3)]);
  ctx.lineWidth = pixels(frame, 1);
  ctx.strokeStyle = fade(green, 0.75);
  const circles = newPath(),
    rounded = newPath();
  for (const {
    center: [x, y],
    from,
    to,
    radius,
  } of arcs) {
    circles.moveTo(x + radius, y);
    circles.arc(x, y, radius, 0, 2 * Math.PI);
    const start = Math.atan2(from[1] - y, from[0] - x),
      end = Math.atan2(to[1] - y, to[0] - x);
    const turn = Math.atan2(Math.sin(end - start), Math.cos(end - start));
    rounded.moveTo(...from);
    rounded.arc(x, y, radius, start, start + turn, turn < 0);
  }
  ctx.stroke(circles);
  ctx.setLineDash([]);
  ctx.lineWidth = pixels(frame, 3);
  ctx.strokeStyle = green;
  ctx.stroke(rounded);
  inPixels(frame);
  dots(frame, cells, CELL_PX, colour.t3, null);
  dots(
    frame,
    arcs.flatMap(({ from, to }) => [from, to]),
    TOUCH_PX,
    green,
    colour.floor,
  );
  dots(frame, pruned, CORNER_PX, colour.floor, colour.t1);
  dots(frame, sharp, CORNER_PX, colour.err, colour.floor);
  ctx.restore();
}

function dots(frame: Frame, points: readonly Point[], radius: number, fill: string, edge: string | null): void {
  const { ctx } = frame;
  ctx.beginPath();
  for (const point of points) {
    const [x, y] = toScreen(frame, point);
    ctx.moveTo(x + radius, y);
    ctx.arc(x, y, radius, 0, 2 * Math.PI);
  }
  ctx.fillStyle = fill;
  ctx.fill();
  if (!edge) return;
  ctx.strokeStyle = edge;
  ctx.lineWidth = 1.25;
  ctx.stroke();
}
