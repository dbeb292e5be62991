/** Dimensions of the car and its outline. */
import type { Pose, Vehicle, VehicleSpec } from "parkade";
import { fromPose, type Point } from "./geometry";

export type ResolvedVehicle = Required<Vehicle> & { minTurningRadius: number };

const PROFILES: Record<"paper" | "sedan" | "ship", Required<Vehicle>> = {
  paper: { wheelbase: 3.7, width: 2.6, rearToFront: 4.5, rearToBack: 1, maxSteer: 0.6, maxSteerRate: 0.6 },
  sedan: {
    wheelbase: 2.8,
    width: 1.9,
    rearToFront: 3.75,
    rearToBack: 0.95,
    maxSteer: Math.atan(2.8 / 5.5),
    maxSteerRate: 0.6,
  },
  ship: {
    wheelbase: 36,
    width: 16,
    rearToFront: 54,
    rearToBack: 18,
    maxSteer: Math.atan(36 / 144),
    maxSteerRate: 0.05,
  },
};

const resolved = new Map<string, ResolvedVehicle>();

/** The dimensions behind a profile name or a custom car; the same object for the same profile. */
export function vehicleOf(spec: VehicleSpec | undefined): ResolvedVehicle {
  const key = typeof spec === "object" ? JSON.stringify(spec) : (spec ?? "paper");
  const known = resolved.get(key);
  if (known) return known;
  const base =
    typeof spec === "object" ? { maxSteerRate: 0.6, ...spec } : (PROFILES[spec ?? "paper"] ?? PROFILES.paper);
  const vehicle = { ...base, minTurningRadius: base.wheelbase / Math.tan(base.maxSteer) };
  if (resolved.size > 64) resolved.clear();
  resolved.set(key, vehicle);
  return vehicle;
}

/** Corners of the body: rear right, front right, front left, rear left. `margin` grows every side. */
export function footprint(pose: Pose, vehicle: Vehicle, margin = 0): Point[] {
  const front = vehicle.rearToFront + margin,
    back = -vehicle.rearToBack - margin,
    side = vehicle.width / 2 + margin;
  return [
    fromPose(pose, back, -side),
    fromPose(pose, front, -side),
    fromPose(pose, front, side),
    fromPose(pose, back, side),
  ];
}

/** The pose whose body is centred on `centre`. */
export function poseAround(centre: Point, heading: number, vehicle: Vehicle): Pose {
  const [x, y] = fromPose({ x: centre[0], y: centre[1], heading }, -(vehicle.rearToFront - vehicle.rearToBack) / 2, 0);
  return { x, y, heading };
}
