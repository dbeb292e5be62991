/** Places at which a planned car hits something. */
import type { Plan } from "parkade";
import { footprint } from "../../scene/vehicle";
import { pickHits, poseAt } from "../drive";
import { inMetres, inPixels, polygonPath, pixels, toScreen, type Frame, type Shown } from "../frame";
import { hatchPattern } from "../hatch";
import { fade, plannerStyle } from "../tokens";

export function drawCollisions(frame: Frame, { plan, ghost }: Shown): void {
  if (!plan || ghost) return;
  for (const index of pickHits(plan.check.hitPoses)) drawHatchedPose(frame, poseAt(plan, index));
}

/** A body outline hatched in the colour of errors. */
export function drawHatchedPose(frame: Frame, pose: { x: number; y: number; heading: number }): void {
  const {
    ctx,
    tokens: { colour },
    resolved,
  } = frame;
  const body = polygonPath(footprint(pose, resolved.vehicle));
  ctx.save();
  inMetres(frame);
  ctx.save();
  ctx.clip(body);
  inPixels(frame);
  ctx.fillStyle = fade(colour.err, 0.1);
  ctx.fillRect(0, 0, frame.view.width, frame.view.height);
  ctx.fillStyle = hatchPattern(frame, fade(colour.err, 0.8), 6, 1.2);
  ctx.fillRect(0, 0, frame.view.width, frame.view.height);
  ctx.restore();
  ctx.strokeStyle = colour.err;
  ctx.lineWidth = pixels(frame, 1);
  ctx.lineJoin = "round";
  ctx.stroke(body);
  ctx.restore();
}

/** With several paths on one canvas: a ring with a cross where the first hit is. */
export function drawFirstHit(frame: Frame, { plan, planner, ghost }: Shown): void {
  const hit = firstHit(plan);
  if (!hit || ghost) return;
  const { ctx, tokens } = frame;
  const [x, y] = toScreen(frame, hit);
  inPixels(frame);
  ctx.beginPath();
  ctx.arc(x, y, 8, 0, 2 * Math.PI);
  ctx.fillStyle = tokens.colour.floor;
  ctx.fill();
  ctx.lineWidth = 2;
  ctx.lineCap = "round";
  ctx.strokeStyle = plannerStyle(tokens, planner).colour;
  ctx.stroke();
  ctx.beginPath();
  ctx.moveTo(x - 3.2, y - 3.2);
  ctx.lineTo(x + 3.2, y + 3.2);
  ctx.moveTo(x - 3.2, y + 3.2);
  ctx.lineTo(x + 3.2, y - 3.2);
  ctx.stroke();
  ctx.lineCap = "butt";
}

function firstHit(plan: Plan | null): [number, number] | null {
  const at = plan?.check.hitPoses[0];
  if (!plan || at === undefined) return null;
  return [plan.path[3 * at]!, plan.path[3 * at + 1]!];
}
