import type { Hit, Obstruction, Plan, Pose } from "parkade";
import { overlapAt, type Overlap } from "../scene/overlap";
import { boxOf, distance, fromPose, type Box, type Point } from "../scene/geometry";
import { passageAt, sweptWidth, type Gap } from "../scene/gap";
import { footprint, vehicleOf, type ResolvedVehicle } from "../scene/vehicle";
import type { Scene } from "../store";
import { distancesOf, poseAt } from "./drive";
import { nth } from "../scene/nth";

export interface Failure {
  /** Position of the mark. */
  at: Point;
  /** Metres driven until there; null without a path. */
  along: number | null;
  hit: Hit | null;
  /** The deepest of the poses that follow the first hit without a gap. */
  overlap: Overlap | null;
  /** The area to show. */
  box: Box;
}

/** Curvature above the limit by this factor is still the limit, as for the check. */
const SLACK = 1.001;
/** Of a long overlap this many poses are measured. */
const MOST_POSES = 200;

/** A drag replaces the scene before the plan: what was found for the plan's own scene stays. */
const known = new WeakMap<Plan, Failure | null>();

/** Where `plan`, made for `scene`, fails; null where it does not, or where that is not known. */
export function failureOf(scene: Scene, plan: Plan): Failure | null {
  const before = known.get(plan);
  if (before !== undefined) return before;
  const vehicle = vehicleOf(scene.vehicle);
  const failure =
    plan.outcome !== "found"
      ? ofObstruction(plan.obstruction, vehicle)
      : plan.check.firstHit
        ? ofHit(scene, plan, plan.check.firstHit, vehicle)
        : plan.check.verdict === "too-tight"
          ? ofTurn(plan, vehicle)
          : null;
  known.set(plan, failure);
  return failure;
}

/** The passage in which a search ends, where it is too narrow for turning at full lock, and the width that would do. */
export function passageOf(scene: Scene, { obstruction }: Plan): (Gap & { needed: number }) | null {
  if (obstruction?.kind !== "nearest" || obstruction.heading === null) return null;
  const { x, y, heading } = obstruction,
    vehicle = vehicleOf(scene.vehicle),
    needed = sweptWidth(vehicle),
    [bx, by] = bodyOf({ x, y, heading }, vehicle);
  const passage = passageAt(scene, { x: bx, y: by, heading }, 2 * needed);
  return passage && passage.width < needed ? { ...passage, needed } : null;
}

const bodyOf = (pose: Pose, vehicle: ResolvedVehicle): Point =>
  fromPose(pose, (vehicle.rearToFront - vehicle.rearToBack) / 2, 0);

function ofHit(scene: Scene, plan: Plan, hit: Hit, vehicle: ResolvedVehicle): Failure {
  const overlap = deepest(scene, plan, hit, vehicle),
    first = plan.check.hitPoses[0] ?? 0;
  const touched = overlapAt(scene, hit, hit.pose, vehicle)?.shared ?? [];
  const at: Point = touched.length > 0 ? middle(touched) : bodyOf(hit.pose, vehicle);
  const last = Math.max(0, first - 1),
    before = nth(distancesOf(plan), last),
    from = poseAt(plan, last);
  const along = first === 0 ? 0 : before + distance([from.x, from.y], [hit.pose.x, hit.pose.y]);
  return { at, along, hit, overlap, box: around([hit.pose, ...(overlap ? [overlap.pose] : [])], vehicle) };
}

const middle = (points: readonly Point[]): Point => {
  const { minX, maxX, minY, maxY } = boxOf([...points]);
  return [(minX + maxX) / 2, (minY + maxY) / 2];
};

function deepest(scene: Scene, plan: Plan, hit: Hit, vehicle: ResolvedVehicle): Overlap | null {
  const { hitPoses } = plan.check;
  let count = 1;
  while (count < hitPoses.length && hitPoses[count] === nth(hitPoses, count - 1) + 1) count++;
  const step = Math.max(1, Math.ceil(count / MOST_POSES));
  let best = overlapAt(scene, hit, hit.pose, vehicle);
  for (let i = 0; i < count; i += step) {
    const one = overlapAt(scene, hit, poseAt(plan, nth(hitPoses, i)), vehicle);
    if (one && one.depth > (best?.depth ?? 0)) best = one;
  }
  return best;
}

/** The first place that is too tight; the start where the path begins in another direction. */
function ofTurn(plan: Plan, vehicle: ResolvedVehicle): Failure {
  const limit = SLACK / vehicle.minTurningRadius;
  const sharp = plan.curvatures.findIndex((curvature) => !(Math.abs(curvature) <= limit));
  const index = Math.max(0, sharp),
    pose = poseAt(plan, index);
  return {
    at: [pose.x, pose.y],
    along: nth(distancesOf(plan), index),
    hit: null,
    overlap: null,
    box: around([pose], vehicle),
  };
}

const around = (poses: readonly Pose[], vehicle: ResolvedVehicle): Box =>
  boxOf(poses.flatMap((pose) => footprint(pose, vehicle, 1)));

function ofObstruction(obstruction: Obstruction | null, vehicle: ResolvedVehicle): Failure | null {
  const at = (point: Point, box: Box, hit: Hit | null = null): Failure => ({
    at: point,
    along: null,
    hit,
    overlap: null,
    box,
  });
  const square = (x: number, y: number, reach: number): Box => ({
    minX: x - reach,
    minY: y - reach,
    maxX: x + reach,
    maxY: y + reach,
  });
  switch (obstruction?.kind) {
    case "contact":
      return at(bodyOf(obstruction.hit.pose, vehicle), around([obstruction.hit.pose], vehicle), obstruction.hit);
    case "boxed-in": {
      const box = around(
        obstruction.stops.map(({ pose }) => pose),
        vehicle,
      );
      return at([(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2], box);
    }
    case "gap":
      return at([obstruction.x, obstruction.y], square(obstruction.x, obstruction.y, 2 * obstruction.needed));
    case "nearest":
      return at(
        [obstruction.x, obstruction.y],
        square(obstruction.x, obstruction.y, 1.5 * (vehicle.rearToFront + vehicle.rearToBack)),
      );
    case "enclosed": {
      const { runs, cell } = obstruction;
      const box = boxOf(
        runs.flatMap(([x, y, count]): Point[] => [
          [x, y],
          [x + count * cell, y + cell],
        ]),
      );
      return at([(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2], box);
    }
    default:
      return null;
  }
}
