/** Positions of the grips of start and goal, for drawing and for hitting. */
import type { Pose, Vehicle } from "parkade";
import { fromPose, type Point } from "../scene/geometry";

/** Metres from the nose to the middle of the round grip. */
export const STALK = 1.2;

export const gripOf = (pose: Pose, vehicle: Vehicle): Point => fromPose(pose, vehicle.rearToFront + STALK, 0);
export const noseOf = (pose: Pose, vehicle: Vehicle): Point => fromPose(pose, vehicle.rearToFront, 0);
