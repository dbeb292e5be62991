import type { Drive } from "parkade";
import { lastIn, nth } from "../scene/nth";

type Name = "t" | "x" | "y" | "theta" | "v" | "phi" | "a" | "omega" | "gear";
export type Columns = Partial<Record<Name, number[]>>;

/** Limits of the profile that gives a path times: those of the referee, m/s and m/s². */
const PROFILE_LIMITS = { speed: 2.5, acceleration: 1 };
/** Motions shorter than this tell no direction and no curvature, metres. */
const SHORTEST = 1e-6;

/** Not the page's own: a worker that imported it would load the page. */
const wrapAngle = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));

export function columnsOf(text: string): Columns {
  const [head = "", ...rows] = text
    .replace(/^\ufeff/, "")
    .split(/\r?\n/)
    .filter((line) => line.trim());
  const names = head.split(",").map((name) => name.trim() as Name);
  const columns: Columns = Object.fromEntries(names.map((name) => [name, []]));
  for (const row of rows) row.split(",").forEach((field, i) => columns[nth(names, i)]?.push(Number(field)));
  return columns;
}

/** `duration`: seconds that the referee says of it; a path is driven run by run, from rest to rest, in this time. */
export function drivenOf(columns: Columns, wheelbase: number, duration: number): Drive {
  const { x = [], y = [], theta = [] } = columns,
    steps = signedSteps(columns);
  const stations = Float64Array.from(x, () => 0);
  steps.forEach((step, i) => {
    stations[i + 1] = nth(stations, i) + Math.abs(step);
  });
  const t = columns.t ? Float64Array.from(columns.t) : timesOf(steps, duration);
  const speeds = columns.v ? Float64Array.from(columns.v) : speedsOf(steps, t);
  const steering = columns.phi
    ? Float64Array.from(columns.phi)
    : Float64Array.from(x, (_, i) => Math.atan(wheelbase * curvatureAt(steps, theta, i)));
  return {
    t,
    path: Float64Array.from(x.flatMap((at, i) => [at, nth(y, i), nth(theta, i)])),
    stations,
    speeds,
    accelerations: Float64Array.from(t, (_, i) => slope(speeds, t, i)),
    steering,
    hash: "",
  };
}

const slope = (values: Float64Array, t: Float64Array, i: number): number =>
  i + 1 < t.length ? (nth(values, i + 1) - nth(values, i)) / (nth(t, i + 1) - nth(t, i)) : 0;

/** Metres from pose to pose, negative where the car moves against its heading, or as the gear says. */
function signedSteps({ x = [], y = [], theta = [], gear }: Columns): number[] {
  return x.slice(1).map((to, i) => {
    const dx = to - nth(x, i),
      dy = nth(y, i + 1) - nth(y, i),
      heading = nth(theta, i) + wrapAngle(nth(theta, i + 1) - nth(theta, i)) / 2;
    const sign = gear?.[i] ?? (dx * Math.cos(heading) + dy * Math.sin(heading) < 0 ? -1 : 1);
    return sign * Math.hypot(dx, dy);
  });
}

/** The times of a path whose runs go from rest to rest with steady accelerations, stretched to `duration`. */
function timesOf(steps: readonly number[], duration: number): Float64Array {
  const t = new Float64Array(steps.length + 1);
  let from = 0;
  while (from < steps.length) {
    let to = from;
    while (to < steps.length && Math.sign(nth(steps, to)) !== -Math.sign(nth(steps, from))) to++;
    const length = steps.slice(from, to).reduce((sum, step) => sum + Math.abs(step), 0),
      begin = nth(t, from);
    let along = 0;
    for (let i = from; i < to; i++) {
      along += Math.abs(nth(steps, i));
      t[i + 1] = begin + timeAt(along, length);
    }
    from = to;
  }
  const end = lastIn(t);
  return end > 0 ? t.map((at) => (at / end) * duration) : t;
}

/** Seconds after which a run of `length` metres has come to `along`. */
function timeAt(along: number, length: number): number {
  const { speed, acceleration } = PROFILE_LIMITS,
    top = Math.min(speed, Math.sqrt(length * acceleration)),
    ramp = (top * top) / (2 * acceleration);
  const total = top > 0 ? (2 * top) / acceleration + (length - 2 * ramp) / top : 0;
  if (along <= ramp) return Math.sqrt((2 * along) / acceleration);
  if (along >= length - ramp) return total - Math.sqrt((2 * Math.max(0, length - along)) / acceleration);
  return top / acceleration + (along - ramp) / top;
}

/** At rest at both ends and at gear changes; between them the mean of the two ways that meet. */
function speedsOf(steps: readonly number[], t: Float64Array): Float64Array {
  return t.map((_, i) => {
    if (i === 0 || i === t.length - 1 || nth(steps, i - 1) * nth(steps, i) < 0) return 0;
    return (nth(steps, i - 1) + nth(steps, i)) / (nth(t, i + 1) - nth(t, i - 1));
  });
}

function curvatureAt(steps: readonly number[], theta: readonly number[], i: number): number {
  const at = Math.min(i, steps.length - 1),
    step = steps[at] ?? 0;
  return Math.abs(step) > SHORTEST ? wrapAngle(nth(theta, at + 1) - nth(theta, at)) / step : 0;
}
