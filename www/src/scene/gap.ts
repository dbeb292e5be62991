/** The width of a gap between drawn things: planners know it to a cell, the drawing exactly. */
import type { Pose } from "parkade";
import type { Scene } from "./model";
import { distance, fromPose, intoPose, nearestOnSegment, type Point } from "./geometry";
import { formsOf, type Form } from "./overlap";
import type { ResolvedVehicle } from "./vehicle";
import { nth } from "./nth";

export interface Gap {
  from: Point;
  to: Point;
  width: number;
}

/** Projections to and fro between two convex sides come to rest within these. */
const ROUNDS = 40;
const ENOUGH = 1e-6;

/**
 * The gap that leads by `at`, about `width` metres wide; null where nothing is drawn that makes one of that width
 * within `slack`.
 */
export function gapAt(scene: Scene, at: Point, width: number, slack: number): Gap | null {
  const reach = width / 2 + 2 * slack,
    near: Point[] = [
      [at[0] - reach, at[1] - reach],
      [at[0] + reach, at[1] + reach],
    ];
  const sides = formsNear(scene, near)
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

/**
 * The passage between what is nearest on the left and on the right of a pose; null where a side is open for `most`
 * metres.
 */
export function passageAt(scene: Scene, pose: Pose, most: number): Gap | null {
  const ends = [fromPose(pose, 0, most), fromPose(pose, 0, -most)],
    edges = formsNear(scene, ends).flatMap(edgesOf);
  const [left, right] = [1, -1].map((side) => nearestAcross(edges, pose, side, most));
  if (!left || !right) return null;
  const gap = between(left, right, [pose.x, pose.y]),
    middle: Point = [(gap.from[0] + gap.to[0]) / 2, (gap.from[1] + gap.to[1]) / 2];
  return gap.width > 0 && gap.width <= most && distance(middle, [pose.x, pose.y]) <= most / 2 ? gap : null;
}

/**
 * How wide a car is that turns at full lock: from the circle of its outer front corner to that of its inner side,
 * metres.
 */
export function sweptWidth({ minTurningRadius, width, rearToFront }: ResolvedVehicle): number {
  return Math.hypot(minTurningRadius + width / 2, rearToFront) - (minTurningRadius - width / 2);
}

/** What is drawn and stands in the way, as far as it may be near some points. */
function formsNear(scene: Scene, near: readonly Point[]): Form[] {
  const owners = [
    { obstacle: "border", index: -1 },
    ...(scene.obstacles ?? []).map((one, index) => ({ obstacle: one.id ?? "", index })),
    ...(scene.slots ?? []).filter(({ occupied }) => occupied).map(({ id }) => ({ obstacle: id!, index: -1 })),
  ];
  return owners.flatMap((owner) => formsOf(scene, owner, near));
}

const edgesOf = ({ points, closed }: Form): Form[] =>
  points.flatMap((b, i) =>
    i > 0 || closed ? [{ points: [nth(points, (i || points.length) - 1), b], closed: false }] : [],
  );

/** The edge that a line straight to one side of a pose meets first. */
function nearestAcross(edges: readonly Form[], pose: Pose, side: number, most: number): Form | undefined {
  let best: Form | undefined,
    least = most;
  for (const edge of edges) {
    const [a, b] = [intoPose(pose, nth(edge.points, 0)), intoPose(pose, nth(edge.points, 1))];
    if (a[0] < 0 === b[0] < 0) continue;
    const across = side * (a[1] + ((b[1] - a[1]) * a[0]) / (a[0] - b[0]));
    if (across >= 0 && across < least) [best, least] = [edge, across];
  }
  return best;
}

const opposite = (at: Point, a: Point, b: Point): boolean =>
  (a[0] - at[0]) * (b[0] - at[0]) + (a[1] - at[1]) * (b[1] - at[1]) < 0;

function nearestOn({ points, closed }: Form, p: Point): Point {
  let best = nth(points, 0);
  for (let i = closed ? 0 : 1; i < points.length; i++) {
    const one = nearestOnSegment(p, points.at(i - 1)!, nth(points, i));
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
