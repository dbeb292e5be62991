/** Gears along a path and along the clock. */
import type { Drive, Plan } from "parkade";
import type { State } from "../store";
import { played } from "../store/results";
import { cuspsOf, distancesOf, segmentDirections } from "./drive";
import { durationOf } from "./playback-time";
import { nth } from "../scene/nth";

type Span = [from: number, to: number];

/** Where a drive is in reverse, and its gear changes, in metres, seconds or shares. */
export interface Gears {
  reverse: Span[];
  changes: number[];
}

/** Slower is standstill, m/s. */
const STANDING = 1e-3;

/** Along a path, metres. */
export function gearsOfPath(plan: Plan): Gears {
  const along = distancesOf(plan),
    cusps = cuspsOf(plan),
    sense = segmentDirections(plan),
    bounds = [0, ...cusps, along.length - 1];
  const reverse = bounds.slice(1).flatMap((to, i): Span[] => {
    const from = nth(bounds, i);
    return (sense[from] ?? 1) < 0 ? [[nth(along, from), nth(along, to)]] : [];
  });
  return { reverse, changes: cusps.map((at) => nth(along, at)) };
}

/**
 * In time, seconds: a standstill belongs to the gear before it, a change is where the car moves on in the other one.
 */
export function gearsOfDrive({ t, speeds }: Drive): Gears {
  const gears: Gears = { reverse: [], changes: [] };
  let gear = 0,
    from = 0;
  const end = (at: number): void => {
    if (gear < 0) gears.reverse.push([from, at]);
    from = at;
  };
  for (let i = 0; i < speeds.length; i++) {
    const now = Math.abs(nth(speeds, i)) < STANDING ? gear : Math.sign(nth(speeds, i));
    if (now === gear) continue;
    // It moves from the row before on.
    const at = gear === 0 ? 0 : nth(t, i - 1);
    end(at);
    if (gear !== 0) gears.changes.push(at);
    gear = now;
  }
  end(t.at(-1) ?? 0);
  return gears;
}

/** Of the focused planner, as shares of the timeline. */
export function gearsOfTimeline(state: State): Gears | null {
  const { plan, drive } = played(state.results[state.focus]) ?? {};
  if (plan?.outcome !== "found" || state.playback.base !== "drive") return null;
  const { reverse, changes } = drive ? gearsOfDrive(drive) : gearsOfPath(plan),
    total = drive ? durationOf(state) : (distancesOf(plan).at(-1) ?? 0);
  if (total === 0) return null;
  return {
    reverse: reverse.map(([from, to]): Span => [from / total, to / total]),
    changes: changes.map((at) => at / total),
  };
}
