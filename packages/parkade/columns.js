// @ts-check
// A plan as columns of text; in the complete module only.
import { trajectory } from "./drive.js";
import { measures, numbers, object } from "./runtime.js";

/** @type {typeof import("./index.js").toCSV} */
export function toCSV(scene, plan) {
  const path = numbers(Float64Array, object(plan, "plan").path, "plan.path");
  const curvatures = measures(plan.curvatures, "plan.curvatures"),
    clearances = measures(plan.clearances, "plan.clearances");
  const directions = numbers(Int8Array, plan.directions, "plan.directions");
  const rows = ["s,x,y,theta,kappa,clearance,v,direction"];
  const speedAt = speeds(scene, plan);
  let s = 0;
  for (let i = 0; 3 * i < path.length; i++) {
    const [x = 0, y = 0, theta = 0] = path.subarray(3 * i, 3 * i + 3);
    if (i > 0) s += Math.hypot(x - (path[3 * i - 3] ?? x), y - (path[3 * i - 2] ?? y));
    rows.push([s.toFixed(4), x, y, theta, curvatures[i], clearances[i], speedAt(s), directions[i]].map(cell).join(","));
  }
  return `${rows.join("\n")}\n`;
}

/** @type {typeof import("./index.js").toTrajectoryCSV} */
export function toTrajectoryCSV(trajectory) {
  const { t, path, speeds, steering, accelerations, steeringRates } = object(trajectory, "trajectory");
  const column = (/** @type {ArrayLike<number>} */ values, /** @type {string} */ name) =>
    numbers(Float64Array, values, `trajectory.${name}`);
  const poses = column(path, "path");
  const times = column(t, "t"),
    rest = [
      column(speeds, "speeds"),
      column(steering, "steering"),
      column(accelerations, "accelerations"),
      column(steeringRates, "steeringRates"),
    ];
  const rows = Array.from(times, (time, i) =>
    [time, ...poses.subarray(3 * i, 3 * i + 3), ...rest.map((values) => values[i])].join(","),
  );
  return `${["t,x,y,theta,v,phi,a,omega", ...rows].join("\n")}\n`;
}

/** Corners have no curvature, undrivable paths no speed: their cells are empty. @param {string | number | undefined} value */
const cell = (value) => (typeof value === "string" || Number.isFinite(value) ? String(value) : "");

/**
 * Speed by distance; nothing for paths that this car cannot drive.
 * @param {import("./index.js").Scenario} scene
 * @param {import("./index.js").Plan} plan
 * @returns {(s: number) => number | undefined}
 */
function speeds(scene, plan) {
  if (plan.outcome !== "found" || !plan.check?.drivable) return () => undefined;
  const drive = trajectory(scene, plan);
  let i = 0;
  return (s) => {
    while (i + 1 < drive.stations.length - 1 && (drive.stations[i + 1] ?? 0) < s) i++;
    const from = drive.stations[i] ?? 0,
      to = drive.stations[i + 1] ?? from;
    const part = to > from ? Math.min(1, Math.max(0, (s - from) / (to - from))) : 0;
    const a = drive.speeds[i] ?? 0,
      b = drive.speeds[i + 1] ?? a;
    return Math.round((a + (b - a) * part) * 1e6) / 1e6;
  };
}
