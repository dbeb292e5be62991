/** Somebody else's trajectory: its path, its car on the common clock, and where that touches something first. */
import { drawCar, drivingStyle } from "../car";
import { inMetres, pixels, type Frame } from "../frame";
import { atTime, clockOf } from "../playback-time";
import { drawHatchedPose } from "./collisions";
import { metreLine } from "./metre-line";

const CASING_PX = 4,
  WIDTH_PX = 1.75,
  DASH_PX = [2, 3];

export function drawGuest(frame: Frame): void {
  const { ctx, state, tokens, resolved } = frame,
    { guest, layers, playback } = state;
  if (!guest) return;
  const contact = guest.verdict.firstContact;
  if (layers.path) {
    const line = metreLine(guest.drive.path);
    ctx.save();
    inMetres(frame);
    ctx.strokeStyle = tokens.colour.floor;
    ctx.lineWidth = pixels(frame, CASING_PX);
    ctx.stroke(line);
    ctx.strokeStyle = tokens.colour.t1;
    ctx.lineWidth = pixels(frame, WIDTH_PX);
    ctx.setLineDash(DASH_PX.map((px) => pixels(frame, px)));
    ctx.stroke(line);
    ctx.restore();
    if (contact) drawHatchedPose(frame, contact.pose);
  }
  const car = layers.car && playback.base === "drive" ? atTime(guest.drive, clockOf(state)) : null;
  if (car) drawCar(frame, car.pose, resolved.vehicle, car.steering, drivingStyle(frame, tokens.colour.t2));
}
