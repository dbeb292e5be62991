/** The area a car sweeps along its plan: its union and the outline of that, in metres. */
import type { Plan, Vehicle } from "parkade";
import { boxOf, convexHull, wrapAngle, type Box, type Point } from "../scene/geometry";
import { footprint } from "../scene/vehicle";
import { poseAt, segmentDirections } from "./drive";
import { newPath, perSurface } from "./surface";

/** With these, a corner between two kept poses strays from its arc by about a millimetre. */
const MOST_TURN = 0.035;
const MOST_STEP = 1;
/** Outlines closer than this are the same line. */
const SAME = 1e-4;
/** Pieces of outline shorter than this (m) are not drawn. */
const SLIVER = 0.003;

export interface Swept {
  /** One path for a single non-zero fill: however often the car passes, nothing stacks. */
  fill: Path2D;
  edge: Path2D;
}

/** `sides`: inward normal and offset of each side. */
export interface Convex {
  corners: Point[];
  box: Box;
  sides: Float64Array;
}

const areas = perSurface(() => new WeakMap<Plan, { vehicle: Vehicle; swept: Swept }>());

export function sweptArea(plan: Plan, vehicle: Vehicle): Swept {
  const known = areas().get(plan);
  if (known?.vehicle === vehicle) return known.swept;
  const hulls = hullsAlong(plan, vehicle);
  const swept = { fill: newPath(), edge: newPath() };
  for (const { corners } of hulls) {
    corners.forEach(([x, y], i) => (i === 0 ? swept.fill.moveTo(x, y) : swept.fill.lineTo(x, y)));
    swept.fill.closePath();
  }
  for (const [a, b] of outlineOf(hulls)) {
    swept.edge.moveTo(...a);
    swept.edge.lineTo(...b);
  }
  areas().set(plan, { vehicle, swept });
  return swept;
}

/** Hulls of neighbouring footprints, counter-clockwise: they close the gaps that sampling alone leaves as scallops. */
export function hullsAlong(plan: Plan, vehicle: Vehicle): Convex[] {
  const hulls: Convex[] = [];
  let before: Point[] | null = null;
  for (const corners of footprintsAlong(plan, vehicle)) {
    const hull = convexHull(before ? [...before, ...corners] : corners);
    if (before) hulls.push({ corners: hull, box: boxOf(hull), sides: sidesOf(hull) });
    before = corners;
  }
  return hulls;
}

function sidesOf(corners: readonly Point[]): Float64Array {
  const sides = new Float64Array(3 * corners.length);
  corners.forEach((q, i) => {
    const p = corners.at(i - 1)!,
      length = Math.hypot(q[0] - p[0], q[1] - p[1]);
    const nx = (p[1] - q[1]) / length,
      ny = (q[0] - p[0]) / length;
    sides.set([nx, ny, nx * p[0] + ny * p[1]], 3 * i);
  });
  return sides;
}

function* footprintsAlong(plan: Plan, vehicle: Vehicle): Iterable<Point[]> {
  const count = plan.path.length / 3;
  const sense = segmentDirections(plan);
  if (count === 0) return;
  let last = poseAt(plan, 0);
  yield footprint(last, vehicle);
  for (let i = 1; i < count; i++) {
    const pose = poseAt(plan, i),
      turn = wrapAngle(pose.heading - last.heading);
    if (i + 1 < count && sense[i] === sense[i - 1]) {
      const next = poseAt(plan, i + 1);
      const near = Math.hypot(next.x - last.x, next.y - last.y) < MOST_STEP;
      if (near && Math.abs(wrapAngle(next.heading - last.heading)) < MOST_TURN) continue;
    }
    const parts = Math.ceil(Math.abs(turn) / MOST_TURN);
    for (let k = 1; k < parts; k++) {
      const t = k / parts;
      yield footprint(
        { x: last.x + (pose.x - last.x) * t, y: last.y + (pose.y - last.y) * t, heading: last.heading + turn * t },
        vehicle,
      );
    }
    last = pose;
    yield footprint(pose, vehicle);
  }
}

/** The parts of the hulls' sides that lie inside no other hull. */
export function outlineOf(hulls: readonly Convex[]): [Point, Point][] {
  const kept: [Point, Point][] = [];
  hulls.forEach(({ corners }, own) => {
    for (let i = 0, j = corners.length - 1; i < corners.length; j = i++) {
      const a = corners[j]!,
        b = corners[i]!;
      const at = (t: number): Point => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
      for (const [from, to] of outsideParts(a, b, hulls, own)) kept.push([at(from), at(to)]);
    }
  });
  return kept;
}

/**
 * What no other hull covers of a → b. Neighbours come first: from both ends they hide most sides whole, and then
 * nothing else needs a look.
 */
function outsideParts(a: Point, b: Point, hulls: readonly Convex[], own: number): [number, number][] {
  const covered: [number, number][] = [];
  const sliver = SLIVER / Math.max(SLIVER, Math.hypot(b[0] - a[0], b[1] - a[1]));
  const minX = Math.min(a[0], b[0]),
    maxX = Math.max(a[0], b[0]),
    minY = Math.min(a[1], b[1]),
    maxY = Math.max(a[1], b[1]);
  const left = { low: 0, high: 1 },
    part = { low: 0, high: 1 };
  for (let step = 1; step < 2 * hulls.length; step++) {
    const other = own + (step & 1 ? (step + 1) >> 1 : -(step >> 1)),
      hull = hulls[other];
    if (!hull) continue;
    const { box } = hull;
    if (box.minX > maxX || box.maxX < minX || box.minY > maxY || box.maxY < minY) continue;
    part.low = left.low;
    part.high = left.high;
    // Of sides that lie on each other the first hull's is kept: drawn twice, a thin line looks bold.
    if (!clipInside(a, b, hull.sides, other < own ? -SAME : SAME, part)) continue;
    const fromLow = part.low <= left.low + sliver,
      toHigh = part.high >= left.high - sliver;
    if (fromLow && toHigh) return [];
    if (fromLow) left.low = part.high;
    else if (toHigh) left.high = part.low;
    else covered.push([part.low, part.high]);
  }
  return gapsBetween(covered, left, sliver);
}

function gapsBetween(covered: [number, number][], { low, high }: Span, sliver: number): [number, number][] {
  covered.sort((p, q) => p[0] - q[0]);
  const gaps: [number, number][] = [];
  let at = low;
  for (const [from, to] of covered) {
    if (Math.min(from, high) > at + sliver) gaps.push([at, Math.min(from, high)]);
    at = Math.max(at, to);
  }
  if (at < high - sliver) gaps.push([at, high]);
  return gaps;
}

interface Span {
  low: number;
  high: number;
}

/** Narrows `span` of a → b to what lies at least `depth` inside every half-plane; false where nothing does. */
function clipInside(a: Point, b: Point, sides: Float64Array, depth: number, span: Span): boolean {
  const ax = a[0],
    ay = a[1],
    bx = b[0],
    by = b[1];
  let { low, high } = span;
  for (let i = 0; i < sides.length; i += 3) {
    const nx = sides[i]!,
      ny = sides[i + 1]!,
      c = sides[i + 2]! + depth;
    const atA = nx * ax + ny * ay - c,
      atB = nx * bx + ny * by - c;
    if (atA <= 0) {
      if (atB <= 0) return false;
      low = Math.max(low, atA / (atA - atB));
    } else if (atB < 0) high = Math.min(high, atA / (atA - atB));
    if (low >= high) return false;
  }
  span.low = low;
  span.high = high;
  return true;
}
