import type { SitePlanLine } from "parkade/siteplan";
import type { Point } from "../scene/geometry";
import { lastIn, nth } from "../scene/nth";

/**
 * Joins open lines whose ends are within `reach` where no third one meets them; such a line that comes back to its
 * beginning is closed.
 */
export function chained(lines: readonly SitePlanLine[], reach: number): SitePlanLine[] {
  const open = lines.filter((line) => !line.closed).map(({ points }) => [...points]);
  const ends = new Map<string, number[]>(),
    keyOf = ([x, y]: Point): string => `${Math.round(x / reach)} ${Math.round(y / reach)}`;
  open.forEach((points, i) => {
    for (const end of [nth(points, 0), lastIn(points)]) {
      const key = keyOf(end),
        here = ends.get(key);
      if (here) here.push(i);
      else ends.set(key, [i]);
    }
  });
  const used = new Set<number>(),
    result: SitePlanLine[] = lines.filter((line) => line.closed);
  /** The only other unused line at an end. */
  const nextAt = (end: Point, own: number): number | undefined => {
    const met = ends.get(keyOf(end)) ?? [];
    // A line has two ends at most.
    if (met.length > 3) return undefined;
    const here = met.filter((i) => i !== own);
    return here.length === 1 && !used.has(nth(here, 0)) ? here[0] : undefined;
  };
  const extend = (points: Point[], own: number): void => {
    for (let last = own, next = nextAt(lastIn(points), last); next !== undefined; next = nextAt(lastIn(points), last)) {
      used.add(next);
      const more = nth(open, next),
        isAhead = keyOf(nth(more, 0)) === keyOf(lastIn(points));
      points.push(...(isAhead ? more : more.toReversed()).slice(1));
      last = next;
    }
  };
  open.forEach((line, i) => {
    if (used.has(i)) return;
    used.add(i);
    const points = [...line];
    extend(points, i);
    points.reverse();
    extend(points, i);
    const closed = points.length > 3 && keyOf(nth(points, 0)) === keyOf(lastIn(points));
    if (closed) points.pop();
    result.push({ points, closed });
  });
  return result;
}

/** Without points that lie within `reach` of the line between their neighbours. */
export function straightened(points: readonly Point[], reach: number, closed: boolean): Point[] {
  const kept: Point[] = [];
  points.forEach((point, i) => {
    const before = kept.at(-1) ?? (closed ? lastIn(points) : null),
      next = points[i + 1] ?? (closed ? nth(points, 0) : null);
    if (before && next) {
      const dx = next[0] - before[0],
        dy = next[1] - before[1],
        length = Math.hypot(dx, dy);
      const off = length > 0 ? Math.abs((point[0] - before[0]) * dy - (point[1] - before[1]) * dx) / length : Infinity,
        along = length > 0 ? ((point[0] - before[0]) * dx + (point[1] - before[1]) * dy) / length : 0;
      if (off <= reach && along >= 0 && along <= length) return;
    }
    kept.push(point);
  });
  return kept;
}
