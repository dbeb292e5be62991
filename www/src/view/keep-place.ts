/** Keeps a driving car where it is when its path gets other times. */
import type { State, Store } from "../store";
import { played } from "../store/results";
import { distancesOf } from "./drive";
import { drivenAt, durationOf, rowAt } from "./playback-time";
import { nth } from "../scene/nth";

/** Differences that nobody sees, as shares of the way. */
const SAME = 1e-3;

/**
 * Where other answers come under a car that drives, the playhead moves so that the car does not; at rest the playhead
 * is somebody's choice, and boxes have a clock of their own.
 */
export function keepPlace(store: Store): void {
  store.derive((state, previous) => {
    const { playback, results, scene } = state;
    const isUnderWay = playback.playing && playback.base === "drive" && playback.fraction > 0 && playback.fraction < 1;
    if (results === previous.results || !isUnderWay || scene.moving?.length) return;
    const share = shareOf({ ...previous, playback }),
      now = shareOf(state);
    if (share === null || now === null || share >= 1 || Math.abs(share - now) < SAME) return;
    store.set({ playback: { ...playback, fraction: fractionAt(state, share) } });
  });
}

/** The share of its way that the focused planner's car has behind it. */
function shareOf(state: State): number | null {
  const result = state.results[state.focus],
    plan = played(result)?.plan;
  const length = plan?.outcome === "found" ? (distancesOf(plan).at(-1) ?? 0) : 0;
  const car = length > 0 ? drivenAt(state, plan!, result, 1) : null;
  return car && car.along / length;
}

/** The moment at which the focused planner's car has a share of its way behind it. */
function fractionAt(state: State, share: number): number {
  const drive = played(state.results[state.focus])?.drive;
  if (!drive) return share;
  const { t, stations } = drive,
    along = share * (stations.at(-1) ?? 0),
    low = rowAt(stations, along),
    next = Math.min(t.length - 1, low + 1);
  const step = nth(stations, next) - nth(stations, low),
    part = step > 0 ? (along - nth(stations, low)) / step : 0;
  return Math.min(1, (nth(t, low) + (nth(t, next) - nth(t, low)) * part) / durationOf(state));
}
