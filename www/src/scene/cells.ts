/** Brushed cells as runs [x, y, count]: rasters of strokes, union and difference. */
import type { MapFrame } from "parkade";
import { rowOfConvex, type Point } from "./geometry";

export type Run = [number, number, number];
/** Half-open intervals of x per row, ascending and apart. */
type Rows = Map<number, [number, number][]>;

/** Thinner strokes would leave diagonal gaps between cells. */
const THINNEST = Math.SQRT1_2 + 1e-6;

/** Cells whose centre lies within `radius` of the segment, clipped to the map. */
export function capsuleRuns(frame: MapFrame, from: Point, to: Point, radius: number): Run[] {
  const { resolution: side, width, height } = frame;
  const a = cellPoint(frame, from),
    b = cellPoint(frame, to);
  const r = Math.max(radius / side, THINNEST);
  const first = Math.max(0, Math.ceil(Math.min(a[1], b[1]) - r)),
    last = Math.min(height - 1, Math.floor(Math.max(a[1], b[1]) + r));
  const runs: Run[] = [];
  for (let y = first; y <= last; y++) {
    const [low, high] = capsuleRow(a, b, r, y);
    const x0 = Math.max(0, Math.ceil(low - 1e-9)),
      x1 = Math.min(width - 1, Math.floor(high + 1e-9));
    if (x0 <= x1) runs.push([x0, y, x1 - x0 + 1]);
  }
  return runs;
}

/** Cell coordinates in which cell centres are whole numbers. */
function cellPoint({ origin, resolution }: MapFrame, [x, y]: Point): Point {
  return [(x - origin[0]) / resolution - 0.5, (y - origin[1]) / resolution - 0.5];
}

function capsuleRow(a: Point, b: Point, r: number, y: number): Point {
  let low = Infinity,
    high = -Infinity;
  for (const [x, cy] of [a, b]) {
    const squared = r * r - (y - cy) * (y - cy);
    if (squared < 0) continue;
    const half = Math.sqrt(squared);
    low = Math.min(low, x - half);
    high = Math.max(high, x + half);
  }
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (length > 0) {
    const nx = (-(b[1] - a[1]) / length) * r,
      ny = ((b[0] - a[0]) / length) * r;
    const body = rowOfConvex(
      [
        [a[0] + nx, a[1] + ny],
        [b[0] + nx, b[1] + ny],
        [b[0] - nx, b[1] - ny],
        [a[0] - nx, a[1] - ny],
      ],
      y,
    );
    if (body) {
      low = Math.min(low, body[0]);
      high = Math.max(high, body[1]);
    }
  }
  return [low, high];
}

/** Cells whose centre lies in a convex outline, clipped to the map. */
export function convexRuns(frame: MapFrame, outline: readonly Point[]): Run[] {
  const corners = outline.map((p) => cellPoint(frame, p));
  const ys = corners.map((p) => p[1]);
  const runs: Run[] = [];
  for (
    let y = Math.max(0, Math.ceil(Math.min(...ys)));
    y <= Math.min(frame.height - 1, Math.floor(Math.max(...ys)));
    y++
  ) {
    const row = rowOfConvex(corners, y);
    if (!row) continue;
    const x0 = Math.max(0, Math.ceil(row[0])),
      x1 = Math.min(frame.width - 1, Math.floor(row[1]));
    if (x0 <= x1) runs.push([x0, y, x1 - x0 + 1]);
  }
  return runs;
}

function rowsOf(runs: readonly Run[]): Rows {
  const rows: Rows = new Map();
  for (const [x, y, count] of runs) {
    const row = rows.get(y);
    if (row) row.push([x, x + count]);
    else rows.set(y, [[x, x + count]]);
  }
  for (const [y, row] of rows) rows.set(y, joinIntervals(row));
  return rows;
}

function joinIntervals(row: [number, number][]): [number, number][] {
  row.sort((a, b) => a[0] - b[0]);
  const joined: [number, number][] = [];
  for (const [from, to] of row) {
    const last = joined.at(-1);
    if (last && from <= last[1]) last[1] = Math.max(last[1], to);
    else joined.push([from, to]);
  }
  return joined;
}

function runsOf(rows: Rows): Run[] {
  return [...rows.keys()]
    .sort((a, b) => a - b)
    .flatMap((y) => rows.get(y)!.map(([from, to]): Run => [from, y, to - from]));
}

/** Canonical runs of all cells in either list. */
export const unionRuns = (a: readonly Run[], b: readonly Run[]): Run[] =>
  nearby(a, b, (rows) => runsOf(rowsOf([...rows, ...b])));

/** Canonical runs of the cells of `from` that are not in `minus`. */
export const subtractRuns = (from: readonly Run[], minus: readonly Run[]): Run[] =>
  nearby(from, minus, (rows) => subtracted(rows, minus));

const FEW = 500;
const canonical = new WeakSet<readonly Run[]>();

/** Changes the rows that `cells` touch; of many canonical runs all others stay the same objects. */
function nearby(runs: readonly Run[], cells: readonly Run[], change: (rows: readonly Run[]) => Run[]): Run[] {
  if (runs.length < FEW || cells.length === 0 || !isCanonical(runs)) return change(runs);
  const rows = cells.map((run) => run[1]);
  const from = firstOfRow(runs, Math.min(...rows)),
    to = firstOfRow(runs, Math.max(...rows) + 1);
  const before = runs.slice(from, to),
    after = change(before);
  if (sameRuns(before, after)) return runs as Run[];
  const next = runs.slice(0, from).concat(after, runs.slice(to));
  canonical.add(next);
  return next;
}

function isCanonical(runs: readonly Run[]): boolean {
  if (canonical.has(runs)) return true;
  for (let i = 1; i < runs.length; i++) {
    const [x, y, count] = runs[i - 1]!,
      [nextX, nextY] = runs[i]!;
    if (nextY < y || (nextY === y && nextX <= x + count)) return false;
  }
  canonical.add(runs);
  return true;
}

/** Index of the first run in this row or beyond. */
export function firstOfRow(runs: readonly Run[], row: number): number {
  let low = 0,
    high = runs.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (runs[middle]![1] < row) low = middle + 1;
    else high = middle;
  }
  return low;
}

function subtracted(from: readonly Run[], minus: readonly Run[]): Run[] {
  const rows = rowsOf(from),
    cut = rowsOf(minus);
  for (const [y, row] of rows) {
    const holes = cut.get(y);
    if (holes)
      rows.set(
        y,
        row.flatMap((interval) => subtractInterval(interval, holes)),
      );
  }
  return runsOf(rows);
}

function subtractInterval([from, to]: [number, number], holes: readonly [number, number][]): [number, number][] {
  const left: [number, number][] = [];
  let start = from;
  for (const [a, b] of holes) {
    if (b <= start || a >= to) continue;
    if (a > start) left.push([start, a]);
    start = Math.max(start, b);
  }
  if (start < to) left.push([start, to]);
  return left;
}

export function sameRuns(a: readonly Run[], b: readonly Run[]): boolean {
  if (a === b) return true;
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) {
    const p = a[i]!,
      q = b[i]!;
    if (p !== q && (p[0] !== q[0] || p[1] !== q[1] || p[2] !== q[2])) return false;
  }
  return true;
}

export const countCells = (runs: readonly Run[]): number => runs.reduce((sum, run) => sum + run[2], 0);
