// @ts-check
// Driving in time; in the complete module only.
import { packedScene } from "./cells.js";
import * as raw from "./parkade.js";
import { call, measures, numbers, object, optional } from "./runtime.js";

/** @param {object | undefined} options */
const configured = (options) => optional(options, "options", "bad-config");

/** @type {typeof import("./index.js").trajectory} */
export const trajectory = (scene, plan, options) =>
  call(() => raw.trajectory(packedScene(scene), ...columns(plan), configured(options)));

/** @type {typeof import("./index.js").optimise} */
export const optimise = (scene, plan, options) =>
  call(() => raw.optimise(packedScene(scene), ...columns(plan), configured(options)));

/** @type {typeof import("./index.js").track} */
export function track(scene, plan, options) {
  const states = trajectoryColumns(plan);
  return call(() =>
    states
      ? raw.trackStates(packedScene(scene), ...states)
      : raw.track(packedScene(scene), ...columns(plan), configured(options)),
  );
}

/** @type {typeof import("./index.js").stopWaitGo} */
export function stopWaitGo(scene, plan, options) {
  const states = trajectoryColumns(plan);
  return call(() =>
    states
      ? raw.stopWaitGoStates(packedScene(scene), ...states, configured(options))
      : raw.stopWaitGo(packedScene(scene), ...columns(plan), configured(options)),
  );
}

/** @type {typeof import("./index.js").judge} */
export function judge(scene, trajectory, limits) {
  if (typeof trajectory === "string")
    return call(() => raw.judgeText(packedScene(scene), trajectory, optional(limits, "limits", "bad-config")));
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
      optional(limits, "limits", "bad-config"),
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

/**
 * The columns of an optimised trajectory; nothing for another path.
 * @param {import("./index.js").DrivenPath | import("./index.js").OptimisedTrajectory} plan
 * @returns {[Float64Array, Float64Array, Float64Array, Float64Array] | null}
 */
function trajectoryColumns(plan) {
  const { stage, path, t, speeds, steering } = /** @type {Partial<import("./index.js").OptimisedTrajectory>} */ (
    object(plan, "plan")
  );
  if (stage === undefined) return null;
  const column = (/** @type {ArrayLike<number> | undefined} */ values, /** @type {string} */ name) =>
    numbers(Float64Array, values, `plan.${name}`);
  return [column(path, "path"), column(t, "t"), column(speeds, "speeds"), column(steering, "steering")];
}
