/** The quantities of the charts, their axes and their lines: along the path in metres, or in time. */
import type { Drive, Plan } from "parkade";
import { focusedPlan, played } from "../store/results";
import type { State } from "../store";
import { degrees } from "../scene/geometry";
import { resolve } from "../scene/model";
import { identityOf } from "../styles/planner-style";
import { plannerColour } from "../styles/icons";
import { drivablePlan } from "../texts/status";
import { distancesOf } from "../view/drive";
import { rowAt } from "../view/playback-time";
import { nth } from "../scene/nth";

export type Axis = "path" | "time";
export type Quantity = "curvature" | "clearance" | "speed" | "acceleration" | "steering" | "steeringRate";

/** A planner's or a guest's; `timed`: it has a drive, or will have one when the pointer rests. */
export interface Line {
  colour: string;
  dash: string;
  plan: Plan | null;
  drive: Drive | null;
  timed: boolean;
}

/** `blank`: there is nothing to show yet. */
export interface Plot {
  quantity: Quantity;
  top: number;
  height: number;
  low: number;
  high: number;
  blank?: boolean;
}

export const WIDTH = 1000;
export const HEIGHT = 160;
/** Points closer than this fall on one pixel. */
const MIN_STEP = 2.5;
/** Steps closer than this fall on one line: of those only the peaks show. */
const MIN_GAP = 0.5;

/** Values, and whether one holds until the next (else they are joined). */
interface Series {
  values: ArrayLike<number>;
  steps: boolean;
}

/** The drivable paths in sight, the focused one, and the trajectory from a file. */
export function linesOf(state: State): Line[] {
  const lines = state.planners
    .filter((planner) => !state.hidden.has(planner))
    .flatMap((planner): Line[] => {
      const result = state.results[planner],
        now = played(result),
        isDrivable = drivablePlan(result) !== null;
      const plan = isDrivable ? now!.plan : planner === state.focus ? focusedPlan(state) : null;
      const style = { colour: plannerColour(planner), dash: identityOf(planner).dash.join(" ") || "none" };
      return plan ? [{ ...style, plan, drive: now?.plan === plan ? now.drive : null, timed: isDrivable }] : [];
    });
  const { guest } = state;
  return guest
    ? [...lines, { colour: "var(--parkade-t1)", dash: "2 3", plan: null, drive: guest.drive, timed: true }]
    : lines;
}

/** The length of the x axis: metres, or seconds. */
export function extentOf(lines: readonly Line[], axis: Axis): number {
  const ends = lines.map(({ plan, drive }) =>
    axis === "time" ? drive?.t.at(-1) : plan ? distancesOf(plan).at(-1) : drive?.stations.at(-1),
  );
  return Math.max(...ends.map((end) => end ?? 0), 0.1);
}

export function plotsOf(state: State, lines: readonly Line[], axis: Axis): Plot[] {
  const timed = lines.some(({ drive, timed: will }) => drive || will);
  const quantities: Quantity[] =
    axis === "time"
      ? ["speed", "acceleration", "steering", "steeringRate"]
      : ["curvature", "clearance", ...(timed ? (["speed"] as const) : [])];
  const room = (HEIGHT - 6) / quantities.length,
    height = room - (quantities.length > 3 ? 8 : 14);
  return quantities.map((quantity, i) => {
    const [low, high] = rangeOf(state, lines, quantity);
    const blank = quantity !== "curvature" && quantity !== "clearance" && !lines.some(({ drive }) => drive);
    return { quantity, top: 6 + i * room, height, low, high, blank };
  });
}

/** Half the height of an axis at least: m/s, m/s², degrees per second. */
const LEAST = { speed: 0.5, acceleration: 0.5, steeringRate: 10 };

/** Where a quantity has a limit of the car the axis ends there; other axes hold every value. */
function rangeOf(state: State, lines: readonly Line[], quantity: Quantity): readonly [number, number] {
  if (quantity === "curvature") {
    const limit = lines.find(({ plan }) => plan)?.plan?.metrics.curvatureLimit ?? 0.2;
    return [-limit, limit];
  }
  if (quantity === "steering") {
    const limit = degrees(lockOf(state));
    return [-limit, limit];
  }
  const [low, high] = lines.reduce<[number, number]>(
    ([least, most], line) => {
      const values = seriesOf(line, quantity)?.values;
      if (!values) return [least, most];
      const [own, ownMost] = extremesOf(values);
      return [Math.min(least, own), Math.max(most, ownMost)];
    },
    [0, 0],
  );
  if (quantity === "clearance") return [0, Math.max(0.5, high)];
  if (quantity === "speed") return [low, Math.max(LEAST.speed, high)];
  return [Math.min(-LEAST[quantity], low), Math.max(LEAST[quantity], high)];
}

export const lockOf = ({ scene }: State): number => resolve(scene).vehicle.maxSteer;

const extremes = new WeakMap<object, readonly [low: number, high: number]>();

/** The lowest and the highest value; ways of kilometres have very many. */
function extremesOf(values: ArrayLike<number>): readonly [low: number, high: number] {
  let known = extremes.get(values);
  if (!known) {
    let low = 0,
      high = 0;
    for (let i = 0; i < values.length; i++) {
      if (nth(values, i) < low) low = nth(values, i);
      if (nth(values, i) > high) high = nth(values, i);
    }
    extremes.set(values, (known = [low, high]));
  }
  return known;
}

const angles = new WeakMap<Drive, { steering: Float64Array; rates: Float64Array }>();

/** Steering angles and rates in degrees, as they are read. */
function anglesOf(drive: Drive): { steering: Float64Array; rates: Float64Array } {
  let known = angles.get(drive);
  if (!known) {
    const steering = drive.steering.map(degrees),
      { t } = drive;
    const rates = steering.map((angle, i) =>
      i + 1 < t.length ? (nth(steering, i + 1) - angle) / (nth(t, i + 1) - nth(t, i)) : 0,
    );
    angles.set(drive, (known = { steering, rates }));
  }
  return known;
}

/** Of a line, per pose of its path or per row of its drive; null where it has none. */
export function seriesOf({ plan, drive }: Line, quantity: Quantity): Series | null {
  switch (quantity) {
    case "curvature":
      // Between the poses of a trajectory the curvature is as good as linear.
      return plan && { values: plan.curvatures, steps: !drive || !("steeringRates" in drive) };
    case "clearance":
      return plan && { values: plan.clearances, steps: false };
    case "speed":
      return drive && { values: drive.speeds, steps: false };
    case "acceleration":
      return drive && { values: drive.accelerations, steps: true };
    case "steering":
      return drive && { values: anglesOf(drive).steering, steps: false };
    case "steeringRate":
      return drive && { values: anglesOf(drive).rates, steps: true };
  }
}

const ofPath = (quantity: Quantity): boolean => quantity === "curvature" || quantity === "clearance";

/** Where the values of a line stand on the x axis. */
function placesOf({ plan, drive }: Line, quantity: Quantity, axis: Axis): Float64Array {
  if (ofPath(quantity)) return distancesOf(plan!);
  return axis === "time" ? drive!.t : drive!.stations;
}

/** A line's value at a place of the x axis; `clock` tells apart what a car does at one place for a while. */
export function valueAt(line: Line, quantity: Quantity, place: { at: number; clock: number | null }): number | null {
  const series = seriesOf(line, quantity);
  if (!series) return null;
  const { values, steps } = series,
    isTimed = !ofPath(quantity) && place.clock !== null;
  const places = isTimed ? line.drive!.t : placesOf(line, quantity, "path"),
    at = isTimed ? place.clock! : place.at;
  if (places.length === 0) return null;
  const low = rowAt(places, at),
    next = Math.min(places.length - 1, low + 1),
    span = nth(places, next) - nth(places, low);
  const part = !steps && span > 0 ? Math.min(1, Math.max(0, (at - nth(places, low)) / span)) : 0;
  const value = nth(values, low) + (nth(values, next) - nth(values, low)) * part;
  return Number.isFinite(value) ? value : null;
}

export const yOf = (plot: Plot, value: number): number => {
  const part = (value - plot.low) / (plot.high - plot.low);
  return plot.top + plot.height * (1 - Math.min(1.08, Math.max(-0.08, part)));
};

const drawn = new WeakMap<object, Map<string, { key: string; text: string }>>();

/**
 * A line as SVG, drawn again only where the axes or the answer have changed: one planner's answer leaves the others'
 * lines.
 */
export function pathOf(plot: Plot, line: Line, axis: Axis, total: number): string {
  const series = seriesOf(line, plot.quantity),
    of = ofPath(plot.quantity) ? line.plan : line.drive;
  if (!series || !of) return "";
  const key = [total, plot.top, plot.height, plot.low, plot.high, series.steps].join(" "),
    lines = drawn.get(of) ?? new Map<string, { key: string; text: string }>(),
    name = `${axis} ${plot.quantity}`;
  drawn.set(of, lines);
  let known = lines.get(name);
  if (known?.key !== key) {
    const places = placesOf(line, plot.quantity, axis);
    lines.set(
      name,
      (known = {
        key,
        text: series.steps ? stepped(plot, places, series.values, total) : joined(plot, places, series.values, total),
      }),
    );
  }
  return known.text;
}

/** Values that hold until the next. */
function stepped(plot: Plot, places: Float64Array, values: ArrayLike<number>, total: number): string {
  let text = "",
    before: number | null = null,
    lastX = -MIN_STEP,
    peak = 0;
  for (let i = 0; i < places.length; i++) {
    const value = nth(values, i),
      x = (nth(places, i) / total) * WIDTH,
      isInside = i < places.length - 1;
    if (!Number.isFinite(value) || (value === before && isInside)) continue;
    const y = yOf(plot, value).toFixed(1);
    if (before !== null && x - lastX < MIN_GAP && isInside) {
      before = value;
      if (Math.abs(value) <= peak) continue;
      peak = Math.abs(value);
      text += `V${y}`;
      continue;
    }
    peak = Math.abs(value);
    text += before === null ? `M${x.toFixed(1)} ${y}` : `H${x.toFixed(1)}V${y}`;
    before = value;
    lastX = x;
  }
  return text;
}

/** Values that are joined. */
function joined(plot: Plot, places: Float64Array, values: ArrayLike<number>, total: number): string {
  let text = "",
    lastX = -MIN_STEP,
    lastY = "";
  for (let i = 0; i < places.length; i++) {
    const x = (nth(places, i) / total) * WIDTH,
      isInside = i > 0 && i < places.length - 1;
    if (!Number.isFinite(nth(values, i)) || (isInside && x - lastX < MIN_GAP)) continue;
    const y = yOf(plot, nth(values, i)).toFixed(1);
    if (isInside && x - lastX < MIN_STEP && y === lastY) continue;
    text += `${text ? "L" : "M"}${x.toFixed(1)} ${y}`;
    lastX = x;
    lastY = y;
  }
  return text;
}

export function ticks(total: number): number[] {
  const step = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000].find((one) => total / one <= 6) ?? 10_000;
  return Array.from({ length: Math.floor(total / step) + 1 }, (_, i) => i * step);
}
