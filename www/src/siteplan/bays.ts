import type { SitePlanLine } from "parkade/siteplan";
import type { Slot } from "parkade";
import { boxOf, distance, insidePolygon, towards, wrapAngle, type Box, type Point } from "../scene/geometry";
import { chained, straightened } from "./chain";
import { SitePlanError } from "./site-plan";
import { nth } from "../scene/nth";
import { rule } from "../i18n/rule";

export type Quad = [Point, Point, Point, Point];
export type Segment = [Point, Point];

/** Sides of a bay and distances between its lines, metres: from a motorcycle's to a coach's. */
const SHORTEST = 0.9,
  LONGEST = 20;
/** Lines that bound bays side by side, and bays one behind the other; metres. */
const BESIDE = { length: [3.5, 8], apart: [1.8, 4.2] } as const,
  BEHIND = { length: [1.7, 3.4], apart: [4.4, 8] } as const;
const SAME = 0.05;
/** Each is held against each. */
const MOST_LINES = 4000;
/** A square corner may be off by so much, radians. */
const SQUARE = 0.05;
/** Ends within which lines meet, metres. */
const REACH = 0.02;

export interface FoundBays {
  quads: Quad[];
  /** Painted lines, of which the open side of a bay has none. */
  lines: Segment[];
  /** Closed outlines that are no bay. */
  others: number;
}

export function findBays(given: readonly SitePlanLine[]): FoundBays {
  const lines = chained(given, REACH),
    quads: Quad[] = [],
    open: Segment[] = [];
  let others = 0;
  for (const { points, closed } of lines) {
    const corners = straightened(points, REACH, closed);
    if (!closed) for (let i = 1; i < corners.length; i++) open.push([nth(corners, i - 1), nth(corners, i)]);
    else {
      const quad = isQuad(corners) ? withoutTaper(corners) : null;
      if (quad && isBay(quad)) quads.push(quad);
      else others++;
    }
  }
  if (open.length > MOST_LINES)
    throw new SitePlanError(
      rule`the layers of bays must have at most ${MOST_LINES} lines, and have ${open.length}; leave layers out`,
    );
  const pieces = split(open);
  for (const kind of [BESIDE, BEHIND])
    for (const quad of between(pieces, kind)) if (!quads.some((one) => overlap(one, quad))) quads.push(quad);
  return { quads, lines: pieces, others };
}

const isQuad = (corners: Point[]): corners is Quad => corners.length === 4;

/** Parallel sides may be off by so much, as a sine. */
const PARALLEL = 0.05;

/**
 * The last bay of a row often ends aslant: of a quadrilateral with two parallel sides, the longer one is cut to the
 * shorter, and the end that is nearer to square stays. Null where the sides are too different.
 */
function withoutTaper([a, b, c, d]: Quad): Quad | null {
  const isAlong = sineBetween(a, b, d, c) < PARALLEL,
    isAcross = sineBetween(b, c, a, d) < PARALLEL;
  if (isAlong === isAcross) return [a, b, c, d];
  if (isAcross) return withoutTaper([b, c, d, a]);
  const sides = [distance(a, b), distance(d, c)] as const,
    length = Math.min(...sides);
  if (length < Math.max(...sides) / 2) return null;
  const isStartSquarer = Math.abs(cosineBetween(a, b, a, d)) <= Math.abs(cosineBetween(a, b, b, c));
  return isStartSquarer
    ? [a, alongTo(a, b, length), alongTo(d, c, length), d]
    : [alongTo(b, a, length), b, c, alongTo(c, d, length)];
}

function alongTo(a: Point, b: Point, length: number): Point {
  const part = length / distance(a, b);
  return [a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part];
}

const sineBetween = (a: Point, b: Point, c: Point, d: Point): number =>
  Math.abs((b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])) / (distance(a, b) * distance(c, d));

const cosineBetween = (a: Point, b: Point, c: Point, d: Point): number =>
  ((b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1])) / (distance(a, b) * distance(c, d));

/** A parallelogram of a bay's size. */
function isBay([a, b, c, d]: Quad): boolean {
  const sides = [distance(a, b), distance(b, c), distance(c, d), distance(d, a)] as const;
  const isParallel = Math.hypot(b[0] - a[0] - (c[0] - d[0]), b[1] - a[1] - (c[1] - d[1])) < 0.15 * Math.min(...sides);
  return isParallel && Math.min(...sides) >= SHORTEST && Math.max(...sides) <= LONGEST;
}

const middleOf = (quad: readonly Point[]): Point => [
  quad.reduce((sum, [x]) => sum + x, 0) / quad.length,
  quad.reduce((sum, [, y]) => sum + y, 0) / quad.length,
];

const overlap = (a: Quad, b: Quad): boolean => insidePolygon(middleOf(b), a) || insidePolygon(middleOf(a), b);

/** Bays of one place are no farther from the next than a street is wide, metres. */
const NEXT = 25;

/** Of the bays of a town, those of the place with the most. */
export function largestGroup(quads: readonly Quad[]): Quad[] {
  const middles = quads.map(middleOf),
    cellOf = ([x, y]: Point): Point => [Math.floor(x / NEXT), Math.floor(y / NEXT)],
    cells = new Map<string, number[]>();
  middles.forEach((middle, i) => {
    const key = cellOf(middle).join();
    cells.set(key, [...(cells.get(key) ?? []), i]);
  });
  const around = ([column, row]: Point): number[] =>
    [-1, 0, 1].flatMap((dx) => [-1, 0, 1].flatMap((dy) => cells.get(`${column + dx},${row + dy}`) ?? []));
  const left = new Set(middles.keys());
  let largest: number[] = [];
  for (const first of left) {
    const group = [first];
    left.delete(first);
    for (const i of group)
      for (const j of around(cellOf(nth(middles, i))))
        if (left.has(j) && distance(nth(middles, i), nth(middles, j)) <= NEXT) {
          left.delete(j);
          group.push(j);
        }
    if (group.length > largest.length) largest = group;
  }
  return largest.map((i) => nth(quads, i));
}

/** Lines cut where others end on them or cross them. */
function split(lines: readonly Segment[]): Segment[] {
  return lines.flatMap(([a, b]) => {
    const length = distance(a, b);
    const cuts = lines.flatMap(([c, d]) => {
      const at = crossing(a, b, c, d);
      return at !== null && at * length > SAME && (1 - at) * length > SAME ? [at] : [];
    });
    const parts = [0, ...cuts.sort((s, t) => s - t), 1].filter(
      (t, i, all) => i === 0 || (t - nth(all, i - 1)) * length > SAME,
    );
    const at = (t: number): Point => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
    return parts.slice(1).map((t, i): Segment => [at(nth(parts, i)), at(t)]);
  });
}

/** Where a–b meets c–d, as a part of a–b; null where they are parallel or apart. */
function crossing(a: Point, b: Point, c: Point, d: Point): number | null {
  const [ux, uy, vx, vy] = [b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]],
    cross = ux * vy - uy * vx;
  if (Math.abs(cross) < 1e-9) return null;
  const s = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / cross,
    t = ((c[0] - a[0]) * uy - (c[1] - a[1]) * ux) / cross,
    slack = SAME / Math.hypot(vx, vy);
  return s >= 0 && s <= 1 && t >= -slack && t <= 1 + slack ? s : null;
}

interface Rule {
  length: readonly [number, number];
  apart: readonly [number, number];
}

/** Bays between parallel lines of about the same length, each line with the nearest to its left. */
function between(lines: readonly Segment[], { length: [short, long], apart: [near, far] }: Rule): Quad[] {
  const found = lines
    .map(([a, b]): Segment => (b[0] > a[0] + 1e-6 || (Math.abs(b[0] - a[0]) <= 1e-6 && b[1] > a[1]) ? [a, b] : [b, a]))
    .filter(([a, b]) => distance(a, b) >= short && distance(a, b) <= long);
  return found.flatMap(([a, b]): Quad[] => {
    const length = distance(a, b),
      ux = (b[0] - a[0]) / length,
      uy = (b[1] - a[1]) / length;
    let best: { quad: Quad; off: number } | null = null;
    for (const [c, d] of found) {
      const other = distance(c, d),
        left = ux * (c[1] - a[1]) - uy * (c[0] - a[0]),
        shift = Math.abs(ux * (c[0] - a[0]) + uy * (c[1] - a[1]));
      if (left < near || left > far || shift > 0.8 * length || Math.abs(other - length) > 0.1 * length) continue;
      if (Math.abs(ux * (d[1] - c[1]) - uy * (d[0] - c[0])) > 0.03 * other) continue;
      const off = left + shift / 10;
      if (!best || off < best.off) best = { quad: [a, b, d, c], off };
    }
    return best ? [best.quad] : [];
  });
}

/** How far one can see from the middle of a side, outwards, metres. */
const VIEW = 15;

/**
 * The bays as slots, each open at the side that has the most room before it. `solid`: what stands in the way besides
 * other bays.
 */
export function slotsOf({ quads, lines }: FoundBays, solid: readonly Segment[]): Slot[] {
  const all = [...solid, ...lines, ...quads.flatMap(sidesOf)].map((edge) => ({ edge, box: boxOf(edge) })),
    open = quads.map((quad) => openSide(quad, all));
  return quads.map((quad, i) => ({ id: `bay-${i + 1}`, ...slotFrom(quad, likeNeighbours(quads, open, i)) }));
}

const sidesOf = (quad: Quad): Segment[] => quad.map((corner, i): Segment => [corner, nth(quad, (i + 1) % 4)]);

function openSide(quad: Quad, all: readonly { edge: Segment; box: Box }[]): number {
  const own = new Set<Point>(quad),
    near = boxOf(quad),
    around = all
      .filter(({ edge: [a, b], box }) => !(own.has(a) && own.has(b)) && meets(box, near, VIEW))
      .map(({ edge }) => edge);
  const sides = sidesOf(quad),
    lengths = sides.map(([a, b]) => distance(a, b)),
    isShort = (k: number): boolean => nth(lengths, k) <= Math.min(...lengths) * 1.05;
  const views = sides.map((side, k) => viewFrom(side, middleOf(quad), around) * (isShort(k) ? 1 : 0.8));
  return views.indexOf(Math.max(...views));
}

/** The last bay of a row has room at its end as well: it opens to where its neighbour does. */
function likeNeighbours(quads: readonly Quad[], open: readonly number[], i: number): number {
  const quad = nth(quads, i),
    sides = sidesOf(quad),
    outOf = (one: Quad, side: number): Point => {
      const [a, b] = nth(sidesOf(one), side),
        [x, y] = middleOf(one);
      return [(a[0] + b[0]) / 2 - x, (a[1] + b[1]) / 2 - y];
    };
  const shared = sides.flatMap((side, k) => {
    const other = quads.findIndex((one, j) => j !== i && sidesOf(one).some((edge) => isSame(edge, side)));
    return other < 0 ? [] : [{ k, other }];
  });
  const neighbour = shared.length === 1 && nth(shared, 0).k % 2 === nth(open, i) % 2 ? nth(shared, 0) : null;
  if (!neighbour) return nth(open, i);
  const along = outOf(quad, neighbour.k),
    out = outOf(nth(quads, neighbour.other), nth(open, neighbour.other));
  // The neighbour may be open to its own end, or to an aisle between both.
  if (Math.abs(along[0] * out[0] + along[1] * out[1]) > 0.7 * Math.hypot(...along) * Math.hypot(...out))
    return nth(open, i);
  const matches = [0, 1, 2, 3].map((k) => outOf(quad, k)).map(([x, y]) => (x * out[0] + y * out[1]) / Math.hypot(x, y));
  return matches.indexOf(Math.max(...matches));
}

const isSame = ([a, b]: Segment, [c, d]: Segment): boolean =>
  (distance(a, c) < SAME && distance(b, d) < SAME) || (distance(a, d) < SAME && distance(b, c) < SAME);

const meets = (box: Box, near: Box, by: number): boolean =>
  box.minX <= near.maxX + by && box.maxX >= near.minX - by && box.minY <= near.maxY + by && box.maxY >= near.minY - by;

/** The shortest of three looks out of a side, from `middle` outwards. */
function viewFrom([a, b]: Segment, middle: Point, around: readonly Segment[]): number {
  const length = distance(a, b),
    normal: Point = [(b[1] - a[1]) / length, (a[0] - b[0]) / length],
    isOut = normal[0] * (a[0] - middle[0]) + normal[1] * (a[1] - middle[1]) > 0,
    out: Point = isOut ? normal : [-normal[0], -normal[1]];
  const looks = [0.25, 0.5, 0.75].map((t) => {
    // A neighbour's line may lie on the side itself.
    const from: Point = [a[0] + (b[0] - a[0]) * t - out[0] * 2 * SAME, a[1] + (b[1] - a[1]) * t - out[1] * 2 * SAME],
      to: Point = [from[0] + out[0] * VIEW, from[1] + out[1] * VIEW];
    return Math.min(VIEW, ...around.flatMap(([c, d]) => (crossing(from, to, c, d) ?? 1) * VIEW));
  });
  return Math.min(...looks);
}

function slotFrom(quad: Quad, open: number): Slot {
  const at = (k: number): Point => nth(quad, (open + k) % 4),
    [a, b, c, d] = [at(0), at(1), at(2), at(3)];
  const mouth = middleOf([a, b]),
    inward = towards(mouth, middleOf([c, d])),
    along = towards(a, b),
    opening = (distance(a, b) + distance(c, d)) / 2,
    depth = (distance(b, c) + distance(d, a)) / 2;
  // Into the bay, at right angles to its mouth.
  const left = wrapAngle(along + Math.PI / 2),
    heading = Math.abs(wrapAngle(left - inward)) < Math.PI / 2 ? left : wrapAngle(along - Math.PI / 2),
    lean = wrapAngle(inward - heading);
  const place = { x: rounded(mouth[0]), y: rounded(mouth[1]), heading };
  if (Math.abs(lean) < SQUARE)
    return opening <= depth
      ? { kind: "perpendicular", ...place, width: rounded(opening), length: rounded(depth) }
      : { kind: "parallel", ...place, width: rounded(depth), length: rounded(opening) };
  const angle = Math.PI / 2 - Math.abs(lean);
  return {
    kind: "angled",
    ...place,
    width: rounded(opening * Math.sin(angle)),
    length: rounded(depth),
    angle,
    lean: lean > 0 ? "left" : "right",
  };
}

const rounded = (metres: number): number => Math.round(metres * 1000) / 1000;
