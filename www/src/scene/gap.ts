/** The width of a gap between drawn things: planners know it to a cell, the drawing exactly. */
import type { Scene } from "./model";
import { distance, nearestOnSegment, type Point } from "./geometry";
import { formsOf, type Form } from "./overlap";

export interface Gap {
  from: Point;
  to: Point;
  width: number;
}

/** Projections to and fro between two convex sides come to rest within these. */
const ROUNDS = 40;
const ENOUGH = 1e-6;

/** The gap that leads by `at`, about `width` metres wide; null where nothing is drawn that makes one of that width within `slack`. */
export function gapAt(scene: Scene, at: Point, width: number, slack: number): Gap | null {
  const reach = width / 2 + 2 * slack,
    near: Point[] = [
      [at[0] - reach, at[1] - reach],
      [at[0] + reach, at[1] + reach],
    ];
  const owners = [
    { obstacle: "border", index: -1 },
    ...(scene.obstacles ?? []).map((one, index) => ({ obstacle: one.id ?? "", index })),
    ...(scene.slots ?? []).filter(({ occupied }) => occupied).map(({ id }) => ({ obstacle: id!, index: -1 })),
  ];
  const sides = owners
    .flatMap((owner) => formsOf(scene, owner, near))
    .map((form) => ({ form, point: nearestOn(form, at) }))
    .filter(({ point }) => distance(point, at) <= reach);
  const pairs = sides.flatMap((one, i) =>
    sides
      .slice(i + 1)
      .filter((other) => opposite(at, one.point, other.point))
      .map((other) => between(one.form, other.form, at)),
  );
  const best = pairs.reduce<Gap | null>((least, pair) => (least && least.width <= pair.width ? least : pair), null);
  return best && Math.abs(best.width - width) <= slack ? best : null;
}

const opposite = (at: Point, a: Point, b: Point): boolean =>
  (a[0] - at[0]) * (b[0] - at[0]) + (a[1] - at[1]) * (b[1] - at[1]) < 0;

function nearestOn({ points, closed }: Form, p: Point): Point {
  let best = points[0]!;
  for (let i = closed ? 0 : 1; i < points.length; i++) {
    const one = nearestOnSegment(p, points.at(i - 1)!, points[i]!);
    if (distance(one, p) < distance(best, p)) best = one;
  }
  return best;
}

function between(a: Form, b: Form, at: Point): Gap {
  let from = nearestOn(a, at),
    to = nearestOn(b, from),
    width = Infinity;
  for (let i = 0; i < ROUNDS && width - distance(from, to) > ENOUGH; i++) {
    width = distance(from, to);
    from = nearestOn(a, to);
    to = nearestOn(b, from);
  }
  return { from, to, width: distance(from, to) };
}
