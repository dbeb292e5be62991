/**
 * Times of the playing drive: all cars and boxes share one clock; a path that no car drives takes as long as the
 * longest drive.
 */
import type { Drive, Encounter, MovingObstacle, Plan, Pose } from "parkade";
import { paceOn } from "../scene/speed-limits";
import { distance, towards, wrapAngle } from "../scene/geometry";
import type { PanelResult, State } from "../store";
import { played } from "../store/results";
import { poseAtFraction, steerAngle } from "./drive";

const SEARCH_SECONDS = 4;

/** Seconds the playback's time base lasts at speed 1. */
export const durationOf = (state: State): number =>
  state.playback.base === "search" ? SEARCH_SECONDS : lastOf(state) || longestPath(state) / paceOn(state.scene) || 1;

/** Metres of the longest path in sight. */
function longestPath(state: State): number {
  return Math.max(
    0,
    ...state.planners
      .filter((planner) => !state.hidden.has(planner))
      .map((planner) => {
        const result = state.results[planner];
        const plan = result?.plan?.outcome === "found" ? result.plan : result?.lastGood;
        return plan?.metrics.length ?? 0;
      }),
  );
}

export interface Driven {
  pose: Pose;
  steering: number /** Metres driven. */;
  along: number;
}

export const isEncounter = (drive: Drive | Encounter | null | undefined): drive is Encounter =>
  !!drive && "ending" in drive;

/** Seconds until the last car in sight has arrived or been stopped; 0 where no drive is known. */
export const lastOf = ({ planners, hidden, results, guest }: State): number =>
  Math.max(
    guest?.drive.t.at(-1) ?? 0,
    ...planners.map((planner) => (hidden.has(planner) ? 0 : (played(results[planner])?.drive?.t.at(-1) ?? 0))),
  );

/** Seconds since the start. */
export const clockOf = (state: State): number =>
  state.playback.base === "drive" ? state.playback.fraction * durationOf(state) : 0;

/** The car of a plan as the drive plays; null where there is no path. */
export function drivenAt(
  state: State,
  plan: Plan,
  result: PanelResult | null | undefined,
  wheelbase: number,
): Driven | null {
  const now = played(result),
    drive = now?.plan === plan && now.drive;
  if (drive) return atTime(drive, clockOf(state));
  const pose = poseAtFraction(plan, state.playback.fraction);
  return pose && { pose, steering: steerAngle(pose.curvature, wheelbase), along: pose.distance };
}

export function atTime({ t, path, stations, steering }: Drive, clock: number): Driven | null {
  const last = t.length - 1;
  if (last < 0) return null;
  const low = rowAt(t, clock),
    next = Math.min(last, low + 1),
    span = t[next]! - t[low]!;
  const part = span > 0 ? Math.min(1, Math.max(0, (clock - t[low]!) / span)) : 0;
  const mixed = (list: Float64Array, a: number, b: number): number => list[a]! + (list[b]! - list[a]!) * part;
  const heading = path[3 * low + 2]!;
  return {
    pose: {
      x: mixed(path, 3 * low, 3 * next),
      y: mixed(path, 3 * low + 1, 3 * next + 1),
      heading: wrapAngle(heading + wrapAngle(path[3 * next + 2]! - heading) * part),
    },
    steering: mixed(steering, low, next),
    along: mixed(stations, low, next),
  };
}

/** The last row at or before a value of a rising column. */
export function rowAt(column: Float64Array, value: number): number {
  let low = 0,
    high = column.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (column[middle]! <= value) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Pose of a moving obstacle's box: at its first point before the start, at its last after arrival. */
export function boxAt({ points, speed, start = 0 }: MovingObstacle, clock: number): Pose {
  let left = Math.max(0, clock - start) * speed;
  let heading = 0;
  for (let i = 1; i < points.length; i++) {
    const a = points[i - 1]!,
      b = points[i]!,
      length = distance(a, b);
    if (length === 0) continue;
    heading = towards(a, b);
    if (left <= length)
      return { x: a[0] + ((b[0] - a[0]) * left) / length, y: a[1] + ((b[1] - a[1]) * left) / length, heading };
    left -= length;
  }
  const end = points.at(-1)!;
  return { x: end[0], y: end[1], heading };
}
