// @ts-check
// A plan as columns of text; in the complete module only.
import { trajectory } from "./drive.js";
import { measures, numbers, object } from "./runtime.js";

/** @type {typeof import("./index.js").toCSV} */
export function toCSV(scene, plan, drive) {
  const path = numbers(Float64Array, object(plan, "plan").path, "plan.path");
  const curvatures = measures(plan.curvatures, "plan.curvatures"),
    clearances = measures(plan.clearances, "plan.clearances");
  const directions = numbers(Int8Array, plan.directions, "plan.directions");
  const rows = ["s,x,y,theta,kappa,clearance,v,direction,t"];
  const along = motion(drive === undefined ? driven(scene, plan) : drive);
  const last = path.length / 3 - 1;
  let s = 0;
  for (let i = 0; i <= last; i++) {
    const [x = 0, y = 0, theta = 0] = path.subarray(3 * i, 3 * i + 3);
    if (i > 0) s += Math.hypot(x - (path[3 * i - 3] ?? x), y - (path[3 * i - 2] ?? y));
    const [v, t] = along(s, i === last);
    rows.push([s.toFixed(4), x, y, theta, curvatures[i], clearances[i], v, directions[i], t].map(cell).join(","));
  }
  return `${rows.join("\n")}\n`;
}

/** @type {typeof import("./index.js").toTrajectoryCSV} */
export function toTrajectoryCSV(drive) {
  const { t, path, speeds, steering, accelerations } = object(drive, "drive");
  const column = (/** @type {ArrayLike<number>} */ values, /** @type {string} */ name) =>
    numbers(Float64Array, values, `drive.${name}`);
  const poses = column(path, "path"),
    times = column(t, "t"),
    angles = column(steering, "steering");
  const rates = "steeringRates" in drive ? column(drive.steeringRates, "steeringRates") : slopes(times, angles);
  const rest = [column(speeds, "speeds"), angles, column(accelerations, "accelerations"), rates];
  const rows = Array.from(times, (time, i) =>
    [time, ...poses.subarray(3 * i, 3 * i + 3), ...rest.map((values) => values[i])].join(","),
  );
  return `${["t,x,y,theta,v,phi,a,omega", ...rows].join("\n")}\n`;
}

/** From each row on. @param {Float64Array} t @param {Float64Array} values */
const slopes = (t, values) =>
  values.map((value, i) => ((values[i + 1] ?? value) - value) / ((t[i + 1] ?? Infinity) - (t[i] ?? 0)));

/**
 * Corners have no curvature, undrivable paths no speed: their cells are empty.
 * @param {string | number | undefined} value
 */
const cell = (value) => (typeof value === "string" || Number.isFinite(value) ? String(value) : "");

/**
 * A plan in time; null where this car cannot drive it.
 * @param {import("./index.js").Scenario} scene
 * @param {import("./index.js").Plan | import("./index.js").MeasuredPath} plan
 */
const driven = (scene, plan) =>
  "outcome" in plan && plan.outcome === "found" && plan.check?.drivable ? trajectory(scene, plan) : null;

/**
 * Speed and time by distance, which must not shrink: when the car gets there, and at the end when it rests.
 * @param {import("./index.js").Drive | null} drive
 * @returns {(s: number, ends: boolean) => [v: number | undefined, t: number | undefined]}
 */
function motion(drive) {
  if (drive === null) return () => [undefined, undefined];
  const stations = numbers(Float64Array, drive.stations, "drive.stations"),
    speeds = numbers(Float64Array, drive.speeds, "drive.speeds"),
    times = numbers(Float64Array, drive.t, "drive.t");
  const round = (/** @type {number} */ value) => Math.round(value * 1e6) / 1e6;
  let i = 0;
  return (s, ends) => {
    while (i + 1 < stations.length - 1 && (stations[i + 1] ?? 0) < s) i++;
    const from = stations[i] ?? 0,
      to = stations[i + 1] ?? from;
    const part = to > from ? Math.min(1, Math.max(0, (s - from) / (to - from))) : 0;
    const a = Math.abs(speeds[i] ?? 0),
      b = Math.abs(speeds[i + 1] ?? 0),
      t = times[i] ?? 0;
    // Along a stretch of steady acceleration the square of the speed is linear.
    const v = Math.sqrt(a * a + (b * b - a * a) * part);
    const spent = v > 0 ? (2 * part * (to - from)) / (a + v) : 0;
    const sign = (speeds[i] ?? 0) + (speeds[i + 1] ?? 0) < 0 ? -1 : 1;
    return [round(sign * v), round(ends ? (times.at(-1) ?? 0) : Math.min(times[i + 1] ?? t, t + spent))];
  };
}
