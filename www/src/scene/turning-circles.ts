/** Circles of a vehicle at full lock, about the point that it turns about. */
import type { Vehicle } from "parkade";

export interface TurningCircles {
  /** Of the middle of the rear axle. */
  axle: number;
  /** Of the outer front wheel's outer face: between kerbs. */
  kerb: number;
  /** Of the outer front corner: between walls. */
  wall: number;
  /** Of the body's inner side; negative where the vehicle turns about a point within itself. */
  inner: number;
}

/** Radii, metres. */
export function turningCircles({ wheelbase, width, rearToFront, maxSteer }: Vehicle): TurningCircles {
  const axle = wheelbase / Math.tan(maxSteer);
  return {
    axle,
    kerb: Math.hypot(axle + width / 2, wheelbase),
    wall: Math.hypot(axle + width / 2, rearToFront),
    inner: axle - width / 2,
  };
}
