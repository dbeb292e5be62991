/** The area a car sweeps along its plan. */
import type { Plan, Vehicle } from "parkade";
import { convexHull, wrapAngle, type Point } from "../scene/plane";
import { footprint } from "../scene/vehicle";
import { poseAt } from "./drive";

/** Between hulls no corner strays from its true arc by more than a millimetre or two. */
const MOST_TURN = 0.03;
const MOST_STEP = 0.25;

const areas = new WeakMap<Plan, { vehicle: Vehicle; path: Path2D }>();

/**
 * One path whose non-zero fill is the union of all footprints: hulls of neighbouring footprints, all wound the same way.
 * Hulls close the gaps that sampling alone would leave as scallops.
 */
export function sweptPath(plan: Plan, vehicle: Vehicle): Path2D {
  const known = areas.get(plan);
  if (known?.vehicle === vehicle) return known.path;
  const path = new Path2D();
  let before: Point[] | null = null;
  for (const corners of footprintsAlong(plan, vehicle)) {
    addLoop(path, convexHull(before ? [...before, ...corners] : corners));
    before = corners;
  }
  areas.set(plan, { vehicle, path });
  return path;
}

function* footprintsAlong(plan: Plan, vehicle: Vehicle): Iterable<Point[]> {
  const count = plan.path.length / 3;
  let kept = -1;
  for (let i = 0; i < count; i++) {
    const pose = poseAt(plan, i);
    if (kept >= 0) {
      const last = poseAt(plan, kept), turn = wrapAngle(pose.heading - last.heading);
      const ahead = i + 1 < count ? poseAt(plan, i + 1) : null;
      const skip = ahead && Math.abs(wrapAngle(ahead.heading - last.heading)) < MOST_TURN / 2
        && Math.hypot(ahead.x - last.x, ahead.y - last.y) < MOST_STEP && plan.directions[i] === plan.directions[kept];
      if (skip) continue;
      const parts = Math.ceil(Math.abs(turn) / MOST_TURN);
      for (let k = 1; k < parts; k++) {
        const t = k / parts;
        yield footprint({ x: last.x + (pose.x - last.x) * t, y: last.y + (pose.y - last.y) * t, heading: last.heading + turn * t }, vehicle);
      }
    }
    kept = i;
    yield footprint(pose, vehicle);
  }
}

function addLoop(path: Path2D, loop: readonly Point[]): void {
  loop.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  path.closePath();
}
