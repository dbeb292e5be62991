/** Position of the grip that turns a selected rectangle or parked car. */
import { fromPose, type Point } from "../scene/geometry";
import type { Shape } from "../scene/shapes";
import { vehicleOf } from "../scene/vehicle";
import type { View } from "./camera";
import { gripOf, noseOf } from "./pose-handle";

const REACH_PX = 26;

/** Ends of the stalk in metres; null for shapes without a heading. */
export function turnGripOf(shape: Shape, view: View): { from: Point; to: Point } | null {
  if (shape.type === "car") {
    const vehicle = vehicleOf(shape.vehicle);
    return { from: noseOf(shape.pose, vehicle), to: gripOf(shape.pose, vehicle) };
  }
  if (shape.type !== "rectangle") return null;
  const pose = { x: shape.center[0], y: shape.center[1], heading: shape.heading ?? 0 };
  const end = shape.size[0] / 2;
  return { from: fromPose(pose, end, 0), to: fromPose(pose, end + REACH_PX / view.camera.scale, 0) };
}
