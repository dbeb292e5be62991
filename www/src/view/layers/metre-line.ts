/** Lines of poses in metres, made once. */
import type { Point } from "../../scene/geometry";
import { linePath } from "../frame";
import { perSurface } from "../surface";
import { nth } from "../../scene/nth";

/** Poses closer than this, metres, are one point: a file may have very many. */
const FINEST = 0.02;

const lines = perSurface(() => new WeakMap<Float64Array, Path2D>());

export function metreLine(path: Float64Array): Path2D {
  let line = lines().get(path);
  if (!line) {
    const points: Point[] = [];
    for (let i = 0; i + 2 < path.length; i += 3) {
      const [x, y] = points.at(-1) ?? [Infinity, 0],
        isLast = i + 5 >= path.length;
      if (isLast || Math.hypot(nth(path, i) - x, nth(path, i + 1) - y) >= FINEST)
        points.push([nth(path, i), nth(path, i + 1)]);
    }
    lines().set(path, (line = linePath(points)));
  }
  return line;
}
