/** Breakpoints of the search debugger on the map: cells, and points with the radius in which a pose counts. */
import { inMetres, pixels, type Frame } from "../frame";

interface Breakpoints {
  cells: ReadonlySet<number>;
  points: readonly { x: number; y: number }[];
}

export function drawBreakpoints(frame: Frame, { cells, points }: Breakpoints, radius: number): void {
  if (cells.size + points.length === 0) return;
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const { origin, resolution, width } = frame.state.scene.map;
  inMetres(frame);
  ctx.save();
  ctx.strokeStyle = colour.err;
  ctx.lineWidth = pixels(frame, 2);
  for (const node of cells) {
    const x = origin[0] + (node % width) * resolution,
      y = origin[1] + Math.floor(node / width) * resolution;
    ctx.strokeRect(x, y, resolution, resolution);
  }
  for (const { x, y } of points) {
    ctx.beginPath();
    ctx.arc(x, y, radius, 0, 2 * Math.PI);
    ctx.stroke();
  }
  ctx.restore();
}
