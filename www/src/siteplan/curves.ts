/** Curves of drawings as lines. */
import { TAU, type Point } from "../scene/geometry";
import { nth } from "../scene/nth";

/** Corners of a whole circle: a radius of 10 m is kept to 5 cm. */
const CIRCLE_PARTS = 32;

/** Affine map [a, b, c, d, e, f]: x' = a x + c y + e, y' = b x + d y + f. */
export type Affine = readonly [number, number, number, number, number, number];
export const IDENTITY: Affine = [1, 0, 0, 1, 0, 0];

/** `second` first, then `first`. */
export const after = (first: Affine, second: Affine): Affine => [
  first[0] * second[0] + first[2] * second[1],
  first[1] * second[0] + first[3] * second[1],
  first[0] * second[2] + first[2] * second[3],
  first[1] * second[2] + first[3] * second[3],
  first[0] * second[4] + first[2] * second[5] + first[4],
  first[1] * second[4] + first[3] * second[5] + first[5],
];

export const mapped = ([a, b, c, d, e, f]: Affine, [x, y]: Point): Point => [a * x + c * y + e, b * x + d * y + f];

/** Of an ellipse by its half axes as vectors, from parameter `from` over `sweep` radians, both ends included. */
export function ellipseArc(center: Point, major: Point, minor: Point, from: number, sweep: number): Point[] {
  const parts = Math.max(2, Math.ceil((Math.abs(sweep) / TAU) * CIRCLE_PARTS));
  return Array.from({ length: parts + 1 }, (_, i) => {
    const t = from + (sweep * i) / parts;
    return [
      center[0] + Math.cos(t) * major[0] + Math.sin(t) * minor[0],
      center[1] + Math.cos(t) * major[1] + Math.sin(t) * minor[1],
    ];
  });
}

export const circleArc = (center: Point, radius: number, from: number, sweep: number): Point[] =>
  ellipseArc(center, [radius, 0], [0, radius], from, sweep);

/**
 * From `a` to `b` without `a`; `bulge` is the tangent of a quarter of the angle, positive to the left of the chord's
 * right.
 */
export function bulged(a: Point, b: Point, bulge: number): Point[] {
  if (Math.abs(bulge) < 1e-6) return [b];
  const sweep = 4 * Math.atan(bulge),
    chord = Math.hypot(b[0] - a[0], b[1] - a[1]),
    radius = chord / (2 * Math.sin(Math.abs(sweep) / 2));
  const offset = (1 - bulge * bulge) / (4 * bulge);
  const center: Point = [(a[0] + b[0]) / 2 - (b[1] - a[1]) * offset, (a[1] + b[1]) / 2 + (b[0] - a[0]) * offset];
  const points = circleArc(center, radius, Math.atan2(a[1] - center[1], a[0] - center[0]), sweep).slice(1);
  points[points.length - 1] = b;
  return points;
}

/** A cubic curve without its beginning. */
export const bezier = (a: Point, b: Point, c: Point, d: Point, parts = 12): Point[] =>
  Array.from({ length: parts }, (_, i) => {
    const t = (i + 1) / parts,
      s = 1 - t;
    const at = (k: 0 | 1): number => s * s * s * a[k] + 3 * s * s * t * b[k] + 3 * s * t * t * c[k] + t * t * t * d[k];
    return [at(0), at(1)];
  });

/** A B-spline by de Boor's recursion; null where the knots do not belong to the control points. */
export function spline(degree: number, knots: readonly number[], controls: readonly Point[]): Point[] | null {
  const n = controls.length;
  if (!(degree >= 1 && degree <= 10) || n <= degree || knots.length !== n + degree + 1) return null;
  if (knots.some((knot, i) => i > 0 && knot < nth(knots, i - 1))) return null;
  const from = nth(knots, degree),
    to = nth(knots, n),
    parts = Math.min(400, 8 * (n - degree));
  return Array.from({ length: parts + 1 }, (_, i) => {
    const t = from + ((to - from) * i) / parts;
    let k = degree;
    while (k < n - 1 && t >= nth(knots, k + 1)) k++;
    const d = controls.slice(k - degree, k + 1).map(([x, y]): Point => [x, y]);
    for (let r = 1; r <= degree; r++)
      for (let j = degree; j >= r; j--) {
        const low = nth(knots, j + k - degree),
          span = nth(knots, j + 1 + k - r) - low,
          share = span > 0 ? (t - low) / span : 0;
        d[j] = [
          nth(d, j - 1)[0] * (1 - share) + nth(d, j)[0] * share,
          nth(d, j - 1)[1] * (1 - share) + nth(d, j)[1] * share,
        ];
      }
    return nth(d, degree);
  });
}
