/** The area a car sweeps along its plan: its union and the outline of that, in metres. */
import type { Plan, Vehicle } from "parkade";
import { boxOf, convexHull, wrapAngle, type Box, type Point } from "../scene/plane";
import { footprint } from "../scene/vehicle";
import { poseAt, segmentDirections } from "./drive";

/** With these, a corner between two kept poses strays from its arc by about 2 mm. */
const MOST_TURN = 0.05;
const MOST_STEP = 1;
/** Outlines closer than this are the same line. */
const SAME = 1e-4;

export interface Swept {
  /** One path for a single non-zero fill: however often the car passes, nothing stacks. */
  fill: Path2D;
  edge: Path2D;
}

interface Convex { corners: Point[]; box: Box }

const areas = new WeakMap<Plan, { vehicle: Vehicle; swept: Swept }>();

export function sweptArea(plan: Plan, vehicle: Vehicle): Swept {
  const known = areas.get(plan);
  if (known?.vehicle === vehicle) return known.swept;
  const hulls = hullsAlong(plan, vehicle);
  const swept = { fill: new Path2D(), edge: new Path2D() };
  for (const { corners } of hulls) {
    corners.forEach(([x, y], i) => (i === 0 ? swept.fill.moveTo(x, y) : swept.fill.lineTo(x, y)));
    swept.fill.closePath();
  }
  for (const [a, b] of outlineOf(hulls)) {
    swept.edge.moveTo(...a);
    swept.edge.lineTo(...b);
  }
  areas.set(plan, { vehicle, swept });
  return swept;
}

/** Hulls of neighbouring footprints, counter-clockwise: they close the gaps that sampling alone leaves as scallops. */
function hullsAlong(plan: Plan, vehicle: Vehicle): Convex[] {
  const hulls: Convex[] = [];
  let before: Point[] | null = null;
  for (const corners of footprintsAlong(plan, vehicle)) {
    const hull = convexHull(before ? [...before, ...corners] : corners);
    if (before) hulls.push({ corners: hull, box: boxOf(hull) });
    before = corners;
  }
  return hulls;
}

function* footprintsAlong(plan: Plan, vehicle: Vehicle): Iterable<Point[]> {
  const count = plan.path.length / 3;
  const sense = segmentDirections(plan);
  if (count === 0) return;
  let last = poseAt(plan, 0);
  yield footprint(last, vehicle);
  for (let i = 1; i < count; i++) {
    const pose = poseAt(plan, i), turn = wrapAngle(pose.heading - last.heading);
    if (i + 1 < count && sense[i] === sense[i - 1]) {
      const next = poseAt(plan, i + 1);
      const near = Math.hypot(next.x - last.x, next.y - last.y) < MOST_STEP;
      if (near && Math.abs(wrapAngle(next.heading - last.heading)) < MOST_TURN) continue;
    }
    const parts = Math.ceil(Math.abs(turn) / MOST_TURN);
    for (let k = 1; k < parts; k++) {
      const t = k / parts;
      yield footprint({ x: last.x + (pose.x - last.x) * t, y: last.y + (pose.y - last.y) * t, heading: last.heading + turn * t }, vehicle);
    }
    last = pose;
    yield footprint(pose, vehicle);
  }
}

/** The parts of the hulls' sides that lie inside no other hull. */
function outlineOf(hulls: readonly Convex[]): [Point, Point][] {
  const kept: [Point, Point][] = [];
  for (const hull of hulls) {
    hull.corners.forEach((b, i) => {
      const a = hull.corners.at(i - 1)!;
      for (const [from, to] of outsideParts(a, b, hulls, hull)) {
        kept.push([[a[0] + (b[0] - a[0]) * from, a[1] + (b[1] - a[1]) * from], [a[0] + (b[0] - a[0]) * to, a[1] + (b[1] - a[1]) * to]]);
      }
    });
  }
  return kept;
}

function outsideParts(a: Point, b: Point, hulls: readonly Convex[], own: Convex): [number, number][] {
  const covered: [number, number][] = [];
  const minX = Math.min(a[0], b[0]), maxX = Math.max(a[0], b[0]), minY = Math.min(a[1], b[1]), maxY = Math.max(a[1], b[1]);
  for (const hull of hulls) {
    const { box } = hull;
    if (hull === own || box.minX > maxX || box.maxX < minX || box.minY > maxY || box.maxY < minY) continue;
    const part = insidePart(a, b, hull.corners);
    if (!part) continue;
    if (part[0] <= 0 && part[1] >= 1) return [];
    covered.push(part);
  }
  covered.sort((p, q) => p[0] - q[0]);
  const left: [number, number][] = [];
  let at = 0;
  for (const [from, to] of covered) {
    if (from > at) left.push([at, from]);
    at = Math.max(at, to);
  }
  if (at < 1) left.push([at, 1]);
  return left;
}

/** The interval of a → b strictly inside a counter-clockwise convex outline. */
function insidePart(a: Point, b: Point, corners: readonly Point[]): [number, number] | null {
  let low = 0, high = 1;
  for (let i = 0, j = corners.length - 1; i < corners.length; j = i++) {
    const p = corners[j]!, q = corners[i]!;
    const ex = q[0] - p[0], ey = q[1] - p[1], slack = SAME * Math.hypot(ex, ey);
    const atA = ex * (a[1] - p[1]) - ey * (a[0] - p[0]) - slack, atB = ex * (b[1] - p[1]) - ey * (b[0] - p[0]) - slack;
    if (atA <= 0 && atB <= 0) return null;
    if (atA < 0) low = Math.max(low, atA / (atA - atB));
    else if (atB < 0) high = Math.min(high, atA / (atA - atB));
    if (low >= high) return null;
  }
  return [low, high];
}
