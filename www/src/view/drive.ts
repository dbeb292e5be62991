/** Positions of a car along its plan. */
import type { Plan, Pose } from "parkade";
import { wrapAngle } from "../scene/geometry";

/** Hit poses drawn of a path. */
const MOST_HITS = 3;

/** A pose of a plan with what the car does there. */
export interface DrivePose extends Pose {
  /** Metres driven, reverse counted as positive. */
  distance: number;
  direction: 1 | -1;
  curvature: number;
  clearance: number;
  /** Index of the pose of `plan.path` at or before it. */
  index: number;
}

const lengths = new WeakMap<Plan, Float64Array>();

/** Metres driven up to each pose of the path. */
export function distancesOf(plan: Plan): Float64Array {
  const known = lengths.get(plan);
  if (known) return known;
  const count = plan.path.length / 3;
  const along = new Float64Array(count);
  for (let i = 1; i < count; i++) {
    along[i] =
      along[i - 1]! +
      Math.hypot(plan.path[3 * i]! - plan.path[3 * i - 3]!, plan.path[3 * i + 1]! - plan.path[3 * i - 2]!);
  }
  lengths.set(plan, along);
  return along;
}

export function poseAt(plan: Plan, index: number): Pose {
  return { x: plan.path[3 * index]!, y: plan.path[3 * index + 1]!, heading: plan.path[3 * index + 2]! };
}

/** The car at a share of its way in [0, 1]; null where there is no path. */
export function poseAtFraction(plan: Plan, fraction: number): DrivePose | null {
  const along = distancesOf(plan);
  return poseAtDistance(plan, Math.min(1, Math.max(0, fraction)) * (along.at(-1) ?? 0));
}

/** The car after a number of metres; null where there is no path. */
export function poseAtDistance(plan: Plan, metres: number): DrivePose | null {
  const along = distancesOf(plan),
    last = along.length - 1;
  if (last < 0) return null;
  let low = 0,
    high = last;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (along[middle]! <= metres) low = middle;
    else high = middle - 1;
  }
  const next = Math.min(last, low + 1),
    step = along[next]! - along[low]!;
  const part = step > 0 ? Math.min(1, Math.max(0, (metres - along[low]!) / step)) : 0;
  const a = poseAt(plan, low),
    b = poseAt(plan, next);
  const mixed = (list: Float64Array): number => list[low]! + (list[next]! - list[low]!) * part;
  return {
    x: a.x + (b.x - a.x) * part,
    y: a.y + (b.y - a.y) * part,
    heading: wrapAngle(a.heading + wrapAngle(b.heading - a.heading) * part),
    distance: along[low]! + step * part,
    direction: segmentDirections(plan)[Math.min(low, last - 1)] === -1 ? -1 : 1,
    curvature: plan.curvatures[low] ?? NaN,
    clearance: mixed(plan.clearances),
    index: low,
  };
}

/** Angle of the middle front wheel; straight at a corner of a grid path. */
export const steerAngle = (curvature: number, wheelbase: number): number =>
  Number.isFinite(curvature) ? Math.atan(wheelbase * curvature) : 0;

const senses = new WeakMap<Plan, Int8Array>();

/** Forward (+1) or reverse (−1) from each pose to the next, by where the nose points; in doubt as the pose says. */
export function segmentDirections(plan: Plan): Int8Array {
  const known = senses.get(plan);
  if (known) return known;
  const { path, directions } = plan;
  const sense = new Int8Array(Math.max(0, path.length / 3 - 1));
  for (let i = 0; i < sense.length; i++) {
    const at = 3 * i,
      heading = path[at + 2]!,
      step = wrapAngle(path[at + 5]! - heading);
    const way =
      (path[at + 3]! - path[at]!) * Math.cos(heading + step / 2) +
      (path[at + 4]! - path[at + 1]!) * Math.sin(heading + step / 2);
    sense[i] = Math.abs(way) > 1e-6 ? Math.sign(way) : (directions[i] ?? 1);
  }
  senses.set(plan, sense);
  return sense;
}

/** Indices of the poses at which the direction of travel changes. */
export function cuspsOf(plan: Plan): number[] {
  const sense = segmentDirections(plan);
  const cusps: number[] = [];
  for (let i = 1; i < sense.length; i++) if (sense[i] !== sense[i - 1]) cusps.push(i);
  return cusps;
}

/** Metres from the path within which its own numbers are read. */
const NEAR = 0.8;

/** Index of the pose nearest to a point, when one is near. */
export function nearestPose(plan: Plan, x: number, y: number, reach = NEAR): number | null {
  let best = -1,
    least = reach * reach;
  for (let i = 0; 3 * i < plan.path.length; i++) {
    const dx = plan.path[3 * i]! - x,
      dy = plan.path[3 * i + 1]! - y,
      square = dx * dx + dy * dy;
    if (square < least) [best, least] = [i, square];
  }
  return best < 0 ? null : best;
}

/** At most three of the hit poses, evenly picked: the first, one between, the last. */
export function pickHits(hits: ArrayLike<number>): number[] {
  const picked = new Set<number>();
  const count = Math.min(MOST_HITS, hits.length);
  for (let i = 0; i < count; i++) picked.add(hits[Math.round((i * (hits.length - 1)) / Math.max(1, count - 1))]!);
  return [...picked];
}
