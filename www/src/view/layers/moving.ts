/** Moving obstacles where they are now, their ways, and where one runs into the car. */
import { rectangleCorners } from "../../scene/shapes";
import { played } from "../../store/results";
import { boxAt, clockOf, isEncounter } from "../playback-time";
import { inMetres, linePath, pixels, polygonPath, toScreen, type Frame, type Shown } from "../frame";
import { fade } from "../tokens";
import { drawHatchedPose } from "./collisions";
import { drawEncounter } from "./encounter";

export function drawMoving(frame: Frame): void {
  const {
    ctx,
    state,
    tokens: { colour },
  } = frame;
  const clock = clockOf(state);
  for (const one of state.scene.moving ?? []) {
    const { x, y, heading } = boxAt(one, clock);
    const box = polygonPath(rectangleCorners({ center: [x, y], size: one.size, heading }));
    inMetres(frame);
    ctx.strokeStyle = fade(colour.warn, 0.8);
    ctx.lineWidth = pixels(frame, 1.25);
    ctx.setLineDash([pixels(frame, 6), pixels(frame, 4)]);
    ctx.stroke(linePath(one.points));
    ctx.setLineDash([]);
    ctx.fillStyle = colour["warn-soft"];
    ctx.fill(box);
    ctx.strokeStyle = colour.warn;
    ctx.lineWidth = pixels(frame, 1.75);
    ctx.stroke(box);
    drawTip(frame, [x, y], heading, one.size[0]);
  }
}

/** Which way it goes. */
function drawTip(frame: Frame, at: [number, number], heading: number, length: number): void {
  const {
    ctx,
    tokens: { colour },
    view,
  } = frame;
  const [x, y] = toScreen(frame, at),
    reach = (length / 2) * view.camera.scale * 0.6;
  if (reach < 3) return;
  const dx = Math.cos(heading),
    dy = -Math.sin(heading),
    ratio = frame.ratio;
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  ctx.fillStyle = colour.warn;
  ctx.beginPath();
  ctx.moveTo(x + dx * reach, y + dy * reach);
  ctx.lineTo(x - dy * reach * 0.6, y + dx * reach * 0.6);
  ctx.lineTo(x + dy * reach * 0.6, y - dx * reach * 0.6);
  ctx.fill();
}

/** The moments of a wait, and where the car was run into, from that moment on. */
export function drawContact(frame: Frame, { result, plan }: Shown): void {
  const now = played(result),
    drive = now?.plan === plan ? now?.drive : null;
  if (!isEncounter(drive)) return;
  drawEncounter(frame, drive);
  if (drive.contact && clockOf(frame.state) >= drive.contact.t) drawHatchedPose(frame, drive.contact.pose);
}
