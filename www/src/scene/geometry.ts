/** Plane geometry of the page: metres, radians, x east, y north. */
import type { Pose } from "parkade";

export type Point = [number, number];
export interface Box {
  minX: number;
  minY: number;
  maxX: number;
  maxY: number;
}

export const TAU = 2 * Math.PI;
export const radians = (degrees: number): number => (degrees * Math.PI) / 180;
export const degrees = (angle: number): number => (angle * 180) / Math.PI;

/** The same direction in (−π, π]. */
export function wrapAngle(angle: number): number {
  const a = ((angle % TAU) + TAU) % TAU;
  return a > Math.PI ? a - TAU : a;
}

export const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
export const towards = (a: Point, b: Point): number => Math.atan2(b[1] - a[1], b[0] - a[0]);

/** A point given in the frame of `pose` (x ahead, y to its left). */
export function fromPose(pose: Pose, ahead: number, left: number): Point {
  const c = Math.cos(pose.heading),
    s = Math.sin(pose.heading);
  return [pose.x + ahead * c - left * s, pose.y + ahead * s + left * c];
}

/** A world point in the frame of `pose`: [ahead, left]. */
export function intoPose(pose: Pose, [x, y]: Point): Point {
  const c = Math.cos(pose.heading),
    s = Math.sin(pose.heading);
  const dx = x - pose.x,
    dy = y - pose.y;
  return [dx * c + dy * s, dy * c - dx * s];
}

export function rotateAbout([x, y]: Point, [cx, cy]: Point, angle: number): Point {
  const c = Math.cos(angle),
    s = Math.sin(angle);
  return [cx + (x - cx) * c - (y - cy) * s, cy + (x - cx) * s + (y - cy) * c];
}

export function boxOf(points: readonly Point[]): Box {
  const box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
  for (const [x, y] of points) {
    box.minX = Math.min(box.minX, x);
    box.maxX = Math.max(box.maxX, x);
    box.minY = Math.min(box.minY, y);
    box.maxY = Math.max(box.maxY, y);
  }
  return box;
}

export function insidePolygon([x, y]: Point, polygon: readonly Point[]): boolean {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const [xi, yi] = polygon[i]!,
      [xj, yj] = polygon[j]!;
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) inside = !inside;
  }
  return inside;
}

export function nearestOnSegment(p: Point, a: Point, b: Point): Point {
  const dx = b[0] - a[0],
    dy = b[1] - a[1];
  const along = dx * dx + dy * dy;
  const t = along === 0 ? 0 : Math.min(1, Math.max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / along));
  return [a[0] + t * dx, a[1] + t * dy];
}

export const distanceToSegment = (p: Point, a: Point, b: Point): number => distance(p, nearestOnSegment(p, a, b));

export function distanceToPolyline(p: Point, points: readonly Point[], closed = false): number {
  if (points.length === 1) return distance(p, points[0]!);
  let best = Infinity;
  for (let i = closed ? 0 : 1; i < points.length; i++) {
    best = Math.min(best, distanceToSegment(p, points.at(i - 1)!, points[i]!));
  }
  return best;
}

/** Twice the signed area of a, b, c: positive where c lies left of a → b. */
const turn = (a: Point, b: Point, c: Point): number => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

const within = (a: Point, b: Point, c: Point): boolean =>
  Math.min(a[0], b[0]) <= c[0] &&
  c[0] <= Math.max(a[0], b[0]) &&
  Math.min(a[1], b[1]) <= c[1] &&
  c[1] <= Math.max(a[1], b[1]);

/** True if the closed segments share a point. */
export function segmentsMeet(a: Point, b: Point, c: Point, d: Point): boolean {
  const abc = turn(a, b, c),
    abd = turn(a, b, d),
    cda = turn(c, d, a),
    cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (
    (abc === 0 && within(a, b, c)) ||
    (abd === 0 && within(a, b, d)) ||
    (cda === 0 && within(c, d, a)) ||
    (cdb === 0 && within(c, d, b))
  );
}

/** True if `next` can follow `points` without its new edge meeting an earlier one. */
export function canExtend(points: readonly Point[], next: Point): boolean {
  const last = points.at(-1);
  if (last === undefined) return true;
  if (distance(last, next) === 0) return false;
  const before = points.at(-2);
  if (before !== undefined && turn(before, last, next) === 0 && within(before, last, next)) return false;
  for (let i = 1; i < points.length - 1; i++) {
    if (segmentsMeet(points[i - 1]!, points[i]!, last, next)) return false;
  }
  return true;
}

/** True if any two edges of a closed outline meet other than at a shared corner. */
export function crossesItself(outline: readonly Point[]): boolean {
  const n = outline.length;
  for (let i = 0; i < n; i++) {
    const a = outline[i]!,
      b = outline[(i + 1) % n]!,
      c = outline[(i + 2) % n]!;
    if (distance(a, b) === 0 || (turn(a, b, c) === 0 && within(a, b, c))) return true;
    for (let j = i + 2; j < n; j++) {
      if (i === 0 && j === n - 1) continue;
      if (segmentsMeet(a, b, outline[j]!, outline[(j + 1) % n]!)) return true;
    }
  }
  return false;
}

/** Convex hull, counter-clockwise (monotone chain). */
export function convexHull(points: readonly Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: readonly Point[]): Point[] => {
    const chain: Point[] = [];
    for (const p of list) {
      while (chain.length > 1 && turn(chain.at(-2)!, chain.at(-1)!, p) <= 0) chain.pop();
      chain.push(p);
    }
    chain.pop();
    return chain;
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** Ends of the row `y` inside a convex outline, or null. */
export function rowOfConvex(outline: readonly Point[], y: number): Point | null {
  let low = Infinity,
    high = -Infinity;
  for (let i = 0, j = outline.length - 1; i < outline.length; j = i++) {
    const a = outline[j]!,
      b = outline[i]!;
    if (Math.min(a[1], b[1]) > y || Math.max(a[1], b[1]) < y) continue;
    const xs = a[1] === b[1] ? [a[0], b[0]] : [a[0] + ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1])];
    for (const x of xs) {
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
  }
  return low <= high ? [low, high] : null;
}
