/** The floor inside its border, the ground outside, the metre grid. */
import { screenToWorld } from "../camera";
import { inMetres, inPixels, pixels, polygonPath, toScreen, type Frame } from "../frame";
import { newPath } from "../surface";

export function drawFloor(frame: Frame): void {
  const { ctx, view, tokens: { colour }, resolved } = frame;
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
  const step = view.camera.scale > 40 ? 1 : view.camera.scale > 4 ? 5 : view.camera.scale > 0.8 ? 25 : 250;
  const [left, top] = screenToWorld(view, 0, 0), [right, bottom] = screenToWorld(view, view.width, view.height);
  inPixels(frame);
  ctx.beginPath();
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    const at = Math.round(toScreen(frame, [x, 0])[0]) + 0.5;
    ctx.moveTo(at, 0);
    ctx.lineTo(at, view.height);
  }
  for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
    const at = Math.round(toScreen(frame, [0, y])[1]) + 0.5;
    ctx.moveTo(0, at);
    ctx.lineTo(view.width, at);
  }
  ctx.strokeStyle = frame.tokens.colour.gridl;
  ctx.lineWidth = 1;
  ctx.stroke();
}

/** The border is a wall. It lies outside the floor, whose edge is where a car touches. */
export function drawBorder(frame: Frame): void {
  const { ctx, resolved, tokens: { colour } } = frame;
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
