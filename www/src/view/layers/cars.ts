/** The start and goal cars and the ones that drive. */
import type { Pose } from "parkade";
import { drawCar, drivingStyle, goalStyle, startStyle } from "../car";
import { poseAtFraction, steerAngle } from "../drive";
import type { Frame, Shown } from "../frame";
import { plannerStyle } from "../tokens";
import { drawHatchedPose } from "./collisions";

export function drawStartAndGoal(frame: Frame): void {
  const { resolved: { start, goal } } = frame;
  drawPoseCar(frame, "goal", goal);
  drawPoseCar(frame, "start", start);
  if (isBlocked(frame, "start")) drawHatchedPose(frame, start);
  if (isBlocked(frame, "goal")) drawHatchedPose(frame, goal);
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
  const pose = poseAtFraction(shown.plan, playback.fraction);
  if (!pose) return;
  const { vehicle } = frame.resolved;
  const { ctx } = frame;
  ctx.save();
  ctx.globalAlpha = alpha;
  drawCar(frame, pose, vehicle, steerAngle(pose.curvature, vehicle.wheelbase), drivingStyle(frame, plannerStyle(frame.tokens, shown.planner).colour));
  ctx.restore();
}
