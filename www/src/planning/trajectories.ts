/** What workers make of trajectories: a plan's own, and one from a file. */
import {
  checkPath,
  judge,
  optimise,
  sceneGeometry,
  stopWaitGo,
  type Drive,
  type Encounter,
  type Judgement,
  type OptimisedTrajectory,
} from "parkade";
import type { Scenario } from "parkade";
import type { Waiting } from "./protocol";
import { columnsOf, drivenOf } from "./trajectory-columns";
import { nth } from "../scene/nth";

/** Rows that are closer along the way stand at one place, metres. */
const SAME_PLACE = 1e-9;

/** A path with all that is measured along it, as a plan has it. */
export interface Line {
  path: Float64Array;
  directions: Int8Array;
  curvatures: Float64Array;
  clearances: Float64Array;
}

/**
 * The trajectory of a plan's path, driven with waits where obstacles move, and its own path; throws why there is none.
 */
export function smoothed({
  scene,
  waiting,
  margin,
  ...plan
}: { scene: Scenario; waiting: Waiting; margin?: number | undefined } & Omit<Line, "clearances">): {
  trajectory: OptimisedTrajectory;
  drive: Drive | Encounter;
  line: Line;
} {
  const trajectory = optimise(scene, plan, margin === undefined ? {} : { margin }),
    drive = scene.moving?.length ? stopWaitGo(scene, trajectory, { rule: waiting }) : trajectory,
    line = lineOf(trajectory, sceneGeometry(scene).vehicle.wheelbase);
  return { trajectory, drive, line: { ...line, clearances: checkPath(scene, line.path, line.directions).clearances } };
}

/** The poses of a drive without its standstills, with the gear and the curvature of the way on. */
export function lineOf({ path, stations, speeds, steering }: Drive, wheelbase: number): Omit<Line, "clearances"> {
  const last = stations.length - 1;
  const kept = Array.from(stations.keys()).filter(
    (i) => i === last || nth(stations, i + 1) - nth(stations, i) > SAME_PLACE,
  );
  const gear = (i: number): number => Math.sign(nth(speeds, i) + (speeds[i + 1] ?? 0));
  return {
    path: Float64Array.from(kept.flatMap((i) => [...path.subarray(3 * i, 3 * i + 3)])),
    directions: Int8Array.from(kept, (i, at) => gear(i) || gear(kept[at - 1] ?? i) || 1),
    curvatures: Float64Array.from(kept, (i) => Math.tan(nth(steering, i)) / wheelbase),
  };
}

/** The referee's verdict on a file, and its drive; throws what is wrong with it, by line and column. */
export function judged({ scene, text }: { scene: Scenario; text: string }): { verdict: Judgement; drive: Drive } {
  const verdict = judge(scene, text);
  return { verdict, drive: drivenOf(columnsOf(text), sceneGeometry(scene).vehicle.wheelbase, verdict.duration) };
}
