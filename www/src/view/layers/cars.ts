/** The start and goal cars and the ones that drive. */
import type { Pose } from "parkade";
import { drawCar, drivingStyle, goalStyle, startStyle } from "../car";
import { drivenAt } from "../playback-time";
import { inPixels, toScreen, type Frame, type Shown } from "../frame";
import { plannerStyle } from "../tokens";
import { drawHatchedPose } from "./collisions";

export function drawStartAndGoal(frame: Frame): void {
  const {
    resolved: { start, goal, vehicle },
  } = frame;
  if ((vehicle.rearToFront + vehicle.rearToBack) * frame.view.camera.scale < SPECK) {
    drawSpot(frame, goal, [3.5, 2.5]);
    drawSpot(frame, start, []);
    return;
  }
  drawPoseCar(frame, "goal", goal);
  drawPoseCar(frame, "start", start);
  if (isBlocked(frame, "start")) drawHatchedPose(frame, start);
  if (isBlocked(frame, "goal")) drawHatchedPose(frame, goal);
}

/** Cars shorter than this (px) are rings. */
const SPECK = 8;

function drawSpot(frame: Frame, pose: Pose, dash: number[]): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  inPixels(frame);
  ctx.beginPath();
  ctx.arc(...toScreen(frame, [pose.x, pose.y]), 6, 0, 2 * Math.PI);
  ctx.fillStyle = colour.floor;
  ctx.fill();
  ctx.setLineDash(dash);
  ctx.strokeStyle = colour.t1;
  ctx.lineWidth = 2;
  ctx.stroke();
  ctx.setLineDash([]);
}

/** The start car (outline) or the goal car (dashed outline). */
export function drawPoseCar(frame: Frame, which: "start" | "goal", pose: Pose): void {
  drawCar(frame, pose, frame.resolved.vehicle, 0, which === "start" ? startStyle(frame) : goalStyle(frame));
}

function isBlocked({ shown }: Frame, which: "start" | "goal"): boolean {
  return shown.some(({ result }) => result?.status !== "planning" && result?.plan?.outcome === `${which}-blocked`);
}

/** The car on its way. */
export function drawDrivingCar(frame: Frame, shown: Shown, alpha: number): void {
  const { playback } = frame.state;
  if (!shown.plan || playback.base !== "drive") return;
  const { vehicle } = frame.resolved;
  const driven = drivenAt(frame.state, shown.plan, shown.result, vehicle.wheelbase);
  if (!driven) return;
  const { ctx } = frame;
  ctx.save();
  ctx.globalAlpha = alpha;
  drawCar(
    frame,
    driven.pose,
    vehicle,
    driven.steering,
    drivingStyle(frame, plannerStyle(frame.tokens, shown.planner).colour),
  );
  ctx.restore();
}
