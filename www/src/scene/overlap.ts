/** How far something reaches into the car: exact, by the corners of what both share. */
import type { Hit, Pose } from "parkade";
import { mapOutline, parkedPose, type Scene } from "./model";
import { boxOf, distance, fromPose, insidePolygon, intoPose, type Point } from "./geometry";
import { cornersOf, rectangleCorners } from "./shapes";
import { footprint, vehicleOf, type ResolvedVehicle } from "./vehicle";
import { nth } from "./nth";

/** `from` is on the car's side, `to` the innermost point; `shared` are the corners of what car and obstacle share. */
export interface Overlap {
  pose: Pose;
  depth: number;
  from: Point;
  to: Point;
  shared: Point[];
}

/** An area (or, for the boundary, all but an area) with its edges; a line has no area. */
export interface Form {
  points: readonly Point[];
  closed: boolean;
  outside?: boolean;
}

export type Owner = Pick<Hit, "obstacle" | "index">;

/** What of a thing may reach into a car within these points; nothing for kerbs, which are lines between roads. */
export function formsOf(scene: Scene, { obstacle: id, index }: Owner, near: readonly Point[]): Form[] {
  const obstacle = scene.obstacles?.[index];
  const area = (points: readonly Point[]): Form => ({ points, closed: true });
  if (!obstacle) {
    const slot = scene.slots?.find((one) => one.id === id);
    if (slot) return [area(footprint(parkedPose(slot), vehicleOf("sedan")))];
    return id === "border" ? [{ ...area(mapOutline(scene)), outside: true }] : [];
  }
  switch (obstacle.type) {
    case "road":
      return [];
    case "cells":
      return cellsNear(scene, obstacle.runs, near).map(area);
    case "wall":
      return obstacle.points.slice(1).map((b, i) => wallPiece(nth(obstacle.points, i), b, obstacle.thickness ?? 0));
    default:
      return [area(cornersOf(obstacle))];
  }
}

/** With square caps, as the planners take it. */
function wallPiece(a: Point, b: Point, thickness: number): Form {
  if (thickness === 0) return { points: [a, b], closed: false };
  const size: Point = [distance(a, b) + thickness, thickness];
  return {
    points: rectangleCorners({
      center: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
      size,
      heading: Math.atan2(b[1] - a[1], b[0] - a[0]),
    }),
    closed: true,
  };
}

function cellsNear(
  {
    map: {
      origin: [ox, oy],
      resolution: side,
    },
  }: Scene,
  runs: readonly (readonly [number, number, number])[],
  near: readonly Point[],
): Point[][] {
  const { minX, minY, maxX, maxY } = boxOf([...near]);
  return runs.flatMap(([x, y, count]): Point[][] => {
    const left = ox + x * side,
      right = left + count * side,
      low = oy + y * side,
      high = low + side;
    return right < minX || left > maxX || high < minY || low > maxY
      ? []
      : [
          [
            [left, low],
            [right, low],
            [right, high],
            [left, high],
          ],
        ];
  });
}

/** The part of a segment within a box, as its two ends; null where it passes by. */
function clipped(a: Point, b: Point, low: Point, high: Point): [Point, Point] | null {
  let from = 0,
    to = 1;
  for (const k of [0, 1] as const) {
    const along = b[k] - a[k];
    if (along === 0) {
      if (a[k] < low[k] || a[k] > high[k]) return null;
      continue;
    }
    const one = (low[k] - a[k]) / along,
      other = (high[k] - a[k]) / along;
    from = Math.max(from, Math.min(one, other));
    to = Math.min(to, Math.max(one, other));
  }
  const at = (t: number): Point => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
  return from <= to ? [at(from), at(to)] : null;
}

/** How deep a thing reaches into the car that stands at `pose`, over the nearest side; null where it does not. */
export function overlapAt(scene: Scene, owner: Owner, pose: Pose, vehicle: ResolvedVehicle): Overlap | null {
  const side = vehicle.width / 2,
    low: Point = [-vehicle.rearToBack, -side],
    high: Point = [vehicle.rearToFront, side];
  const corners = footprint(pose, vehicle),
    shared: Point[] = [];
  for (const { points, closed, outside = false } of formsOf(scene, owner, corners)) {
    const local = points.map((p) => intoPose(pose, p));
    for (let i = closed ? 0 : 1; i < local.length; i++)
      shared.push(...(clipped(local.at(i - 1)!, nth(local, i), low, high) ?? []));
    if (closed)
      shared.push(
        ...corners
          .filter((corner) => insidePolygon(corner, points) !== outside)
          .map((corner) => intoPose(pose, corner)),
      );
  }
  if (shared.length === 0) return null;
  return {
    pose,
    ...innermost(shared, low, high, (p) => fromPose(pose, ...p)),
    shared: shared.map((p) => fromPose(pose, ...p)),
  };
}

/** The side over which the least is shared, and the point farthest from it. */
function innermost(
  shared: readonly Point[],
  low: Point,
  high: Point,
  world: (p: Point) => Point,
): Pick<Overlap, "depth" | "from" | "to"> {
  let best = { depth: Infinity, from: low, to: low };
  for (const k of [0, 1] as const) {
    for (const [edge, sign] of [
      [low[k], 1],
      [high[k], -1],
    ] as const) {
      const to = shared.reduce((far, p) => (sign * (p[k] - far[k]) > 0 ? p : far)),
        depth = sign * (to[k] - edge);
      if (depth < best.depth) best = { depth, from: k === 0 ? [edge, to[1]] : [to[0], edge], to };
    }
  }
  return { depth: best.depth, from: world(best.from), to: world(best.to) };
}
