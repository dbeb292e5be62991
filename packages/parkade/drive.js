// @ts-check
// Driving in time; in the complete module only.
import { packedScene } from "./cells.js";
import * as raw from "./parkade.js";
import { call, measures, numbers, object } from "./runtime.js";

/** @type {typeof import("./index.js").trajectory} */
export const trajectory = (scene, plan, options = {}) =>
  call(() => raw.trajectory(packedScene(scene), ...columns(plan), options));

/** @type {typeof import("./index.js").optimise} */
export const optimise = (scene, plan, options = {}) =>
  call(() => raw.optimise(packedScene(scene), ...columns(plan), options));

/** @type {typeof import("./index.js").track} */
export function track(scene, plan, options = {}) {
  const { stage, path, t, speeds, steering } = /** @type {Partial<import("./index.js").OptimisedTrajectory>} */ (
    object(plan, "plan")
  );
  if (stage === undefined) return call(() => raw.track(packedScene(scene), ...columns(plan), options));
  const column = (/** @type {ArrayLike<number> | undefined} */ values, /** @type {string} */ name) =>
    numbers(Float64Array, values, `plan.${name}`);
  return call(() =>
    raw.trackStates(
      packedScene(scene),
      column(path, "path"),
      column(t, "t"),
      column(speeds, "speeds"),
      column(steering, "steering"),
    ),
  );
}

/** @type {typeof import("./index.js").stopWaitGo} */
export const stopWaitGo = (scene, plan, options = {}) =>
  call(() => raw.stopWaitGo(packedScene(scene), ...columns(plan), options));

/** @type {typeof import("./index.js").judge} */
export function judge(scene, trajectory, limits = {}) {
  if (typeof trajectory === "string") return call(() => raw.judgeText(packedScene(scene), trajectory, limits));
  const { path, t, speeds, steering, directions } = object(trajectory, "trajectory");
  const column = (/** @type {ArrayLike<number> | undefined} */ values, /** @type {string} */ name) =>
    values === undefined ? undefined : numbers(Float64Array, values, `trajectory.${name}`);
  return call(() =>
    raw.judgeColumns(
      packedScene(scene),
      numbers(Float64Array, path, "trajectory.path"),
      column(t, "t"),
      column(speeds, "speeds"),
      column(steering, "steering"),
      directions === undefined ? undefined : numbers(Int8Array, directions, "trajectory.directions"),
      limits,
    ),
  );
}

/**
 * @param {import("./index.js").DrivenPath} plan
 * @returns {[Float64Array, Int8Array | undefined, Float64Array | undefined]}
 */
function columns(plan) {
  const { path, directions, curvatures } = object(plan, "plan");
  return [
    numbers(Float64Array, path, "plan.path"),
    directions === undefined ? undefined : numbers(Int8Array, directions, "plan.directions"),
    curvatures === undefined ? undefined : measures(curvatures, "plan.curvatures"),
  ];
}
