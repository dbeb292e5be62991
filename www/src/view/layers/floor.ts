/** The floor inside its border, the ground outside, the metre grid. */
import { screenToWorld } from "../camera";
import { inMetres, inPixels, pixels, polygonPath, toScreen, type Frame } from "../frame";
import { newPath } from "../surface";

export function drawFloor(frame: Frame): void {
  const {
    ctx,
    view,
    tokens: { colour },
    resolved,
  } = frame;
  inPixels(frame);
  ctx.fillStyle = colour.out;
  ctx.fillRect(0, 0, view.width, view.height);
  inMetres(frame);
  const floor = polygonPath(resolved.boundary);
  ctx.fillStyle = colour.floor;
  ctx.fill(floor);
  if (!frame.state.layers.grid) return;
  ctx.save();
  ctx.clip(floor);
  drawGrid(frame);
  ctx.restore();
}

function drawGrid(frame: Frame): void {
  const { ctx, view } = frame;
  const { scale } = view.camera,
    step =
      scale > 40 ? 1 : scale > 4 ? 5 : scale > 0.8 ? 25 : 250 * 10 ** Math.max(0, Math.ceil(-Math.log10(scale / 0.08)));
  const [left, top] = screenToWorld(view, 0, 0),
    [right, bottom] = screenToWorld(view, view.width, view.height);
  inPixels(frame);
  ctx.beginPath();
  for (const x of multiples(step, left, right)) {
    const at = Math.round(toScreen(frame, [x, 0])[0]) + 0.5;
    ctx.moveTo(at, 0);
    ctx.lineTo(at, view.height);
  }
  for (const y of multiples(step, bottom, top)) {
    const at = Math.round(toScreen(frame, [0, y])[1]) + 0.5;
    ctx.moveTo(0, at);
    ctx.lineTo(view.width, at);
  }
  ctx.strokeStyle = frame.tokens.colour.gridl;
  ctx.lineWidth = 1;
  ctx.stroke();
}

/** More lines than these are a grey area. */
const MOST_LINES = 2000;

/** Counted, because far from the origin a step may be lost in rounding. */
function multiples(step: number, from: number, to: number): number[] {
  const first = Math.ceil(from / step),
    count = Math.min(MOST_LINES, Math.floor(to / step) - first + 1);
  return Array.from({ length: Math.max(count, 0) }, (_, i) => (first + i) * step);
}

/** The border is a wall. It lies outside the floor, whose edge is where a car touches. */
export function drawBorder(frame: Frame): void {
  const {
    ctx,
    resolved,
    tokens: { colour },
  } = frame;
  inMetres(frame);
  const floor = polygonPath(resolved.boundary);
  ctx.save();
  const outside = newPath();
  outside.rect(-1e5, -1e5, 2e5, 2e5);
  outside.addPath(floor);
  ctx.clip(outside, "evenodd");
  ctx.strokeStyle = colour["obs-edge"];
  ctx.lineWidth = pixels(frame, 6);
  ctx.lineJoin = "miter";
  ctx.stroke(floor);
  ctx.restore();
}
