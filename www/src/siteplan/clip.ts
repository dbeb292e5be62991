import type { Box, Point } from "../scene/geometry";
import { lastIn, nth } from "../scene/nth";

/** The pieces of a line within a box. */
export function clippedLine(points: readonly Point[], box: Box): Point[][] {
  const pieces: Point[][] = [];
  for (let i = 1; i < points.length; i++) {
    const part = segmentIn(nth(points, i - 1), nth(points, i), box);
    if (!part) continue;
    const last = pieces.at(-1)?.at(-1);
    if (last && last[0] === part[0][0] && last[1] === part[0][1]) lastIn(pieces).push(part[1]);
    else pieces.push([...part]);
  }
  return pieces;
}

function segmentIn(a: Point, b: Point, box: Box): [Point, Point] | null {
  let from = 0,
    to = 1;
  const sides = [
    [b[0] - a[0], box.minX - a[0], box.maxX - a[0]],
    [b[1] - a[1], box.minY - a[1], box.maxY - a[1]],
  ] as const;
  for (const [along, low, high] of sides) {
    if (along === 0) {
      if (low > 0 || high < 0) return null;
      continue;
    }
    const [enter, leave] = along > 0 ? [low / along, high / along] : [high / along, low / along];
    from = Math.max(from, enter);
    to = Math.min(to, leave);
  }
  const at = (t: number): Point => (t === 0 ? a : t === 1 ? b : [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]);
  return from < to ? [at(from), at(to)] : null;
}

/** An outline cut at the box's sides, one after the other; empty where nothing is inside. */
export function clippedPolygon(points: readonly Point[], { minX, minY, maxX, maxY }: Box): Point[] {
  const sides: [axis: 0 | 1, limit: number, sign: 1 | -1][] = [
    [0, minX, 1],
    [0, maxX, -1],
    [1, minY, 1],
    [1, maxY, -1],
  ];
  return sides.reduce<Point[]>(
    (outline, [axis, limit, sign]) => {
      const isInside = (point: Point): boolean => sign * (point[axis] - limit) >= 0;
      return outline.flatMap((point, i) => {
        const before = outline.at(i - 1)!,
          cut: Point[] = [];
        if (isInside(point) !== isInside(before)) {
          const t = (limit - before[axis]) / (point[axis] - before[axis]);
          cut.push([before[0] + (point[0] - before[0]) * t, before[1] + (point[1] - before[1]) * t]);
        }
        return isInside(point) ? [...cut, point] : cut;
      });
    },
    [...points],
  );
}
