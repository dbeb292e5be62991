/** Obstacles as shapes: outlines, hits, moves. */
import type { MapFrame, Obstacle } from "parkade";
import {
  boxOf,
  distance,
  distanceToPolyline,
  fromPose,
  insidePolygon,
  intoPose,
  rotateAbout,
  wrapAngle,
  type Point,
} from "./geometry";
import { halfOf } from "./road-width";
import { footprint, vehicleOf } from "./vehicle";

export type Shape = Exclude<Obstacle, { type: "cells" }>;

export function rectangleCorners(box: { center: Point; size: Point; heading?: number }): Point[] {
  const pose = { x: box.center[0], y: box.center[1], heading: box.heading ?? 0 };
  const [l, w] = [box.size[0] / 2, box.size[1] / 2];
  return [fromPose(pose, -l, -w), fromPose(pose, l, -w), fromPose(pose, l, w), fromPose(pose, -l, w)];
}

/** Corners of a closed shape, or of the middle line of a wall. */
export function cornersOf(shape: Shape): Point[] {
  if (shape.type === "rectangle") return rectangleCorners(shape);
  if (shape.type === "car") return footprint(shape.pose, vehicleOf(shape.vehicle));
  return shape.points;
}

/** Metres from `p` to the shape; 0 inside. */
export function distanceToShape(p: Point, shape: Shape): number {
  const corners = cornersOf(shape);
  const half = shape.type === "wall" ? (shape.thickness ?? 0) / 2 : shape.type === "road" ? halfOf(shape) : null;
  if (half !== null) return Math.max(0, distanceToPolyline(p, corners) - half);
  return insidePolygon(p, corners) ? 0 : distanceToPolyline(p, corners, true);
}

/** True if `p` is on a brushed cell. */
export function onCells(p: Point, runs: readonly [number, number, number][], frame: MapFrame): boolean {
  const x = Math.floor((p[0] - frame.origin[0]) / frame.resolution),
    y = Math.floor((p[1] - frame.origin[1]) / frame.resolution);
  return runs.some(([rx, ry, count]) => ry === y && x >= rx && x < rx + count);
}

/** The point a shape turns about. */
export function pivotOf(shape: Shape): Point {
  if (shape.type === "rectangle") return shape.center;
  if (shape.type === "car") return [shape.pose.x, shape.pose.y];
  const box = boxOf(shape.points);
  return [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2];
}

export function moveShape<T extends Shape>(shape: T, dx: number, dy: number): T {
  const by = ([x, y]: Point): Point => [x + dx, y + dy];
  if (shape.type === "rectangle") return { ...shape, center: by(shape.center) };
  if (shape.type === "car") return { ...shape, pose: { ...shape.pose, x: shape.pose.x + dx, y: shape.pose.y + dy } };
  return { ...shape, points: shape.points.map(by) };
}

export function turnShape<T extends Shape>(shape: T, angle: number): T {
  if (shape.type === "rectangle") return { ...shape, heading: wrapAngle((shape.heading ?? 0) + angle) };
  if (shape.type === "car")
    return { ...shape, pose: { ...shape.pose, heading: wrapAngle(shape.pose.heading + angle) } };
  const about = pivotOf(shape);
  return { ...shape, points: shape.points.map((p) => rotateAbout(p, about, angle)) };
}

/** Heading of shapes that have one. */
export function headingOf(shape: Shape): number | null {
  if (shape.type === "rectangle") return shape.heading ?? 0;
  return shape.type === "car" ? shape.pose.heading : null;
}

/** Points that can be dragged on their own: polygon and wall vertices, rectangle corners. */
export function verticesOf(shape: Shape): Point[] {
  return shape.type === "car" ? [] : cornersOf(shape);
}

/** The shape with one of its vertices at `to`; a rectangle keeps the opposite corner. */
export function dragVertex(shape: Shape, index: number, to: Point): Shape {
  if (shape.type === "car") return shape;
  if (shape.type !== "rectangle") return { ...shape, points: shape.points.map((p, i) => (i === index ? to : p)) };
  const fixed = cornersOf(shape)[(index + 2) % 4]!;
  return rectangleBetween(shape, fixed, to);
}

/** A rectangle of the same heading with `a` and `b` as opposite corners. */
export function rectangleBetween<T extends { heading?: number }>(
  shape: T,
  a: Point,
  b: Point,
): T & { center: Point; size: Point } {
  const [ahead, left] = intoPose({ x: a[0], y: a[1], heading: shape.heading ?? 0 }, b);
  return { ...shape, center: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], size: [Math.abs(ahead), Math.abs(left)] };
}

/** Index of the edge of a closed or open line within `reach` of `p`, or −1. */
export function edgeAt(points: readonly Point[], p: Point, reach: number, closed: boolean): number {
  let best = -1,
    nearest = reach;
  for (let i = closed ? 0 : 1; i < points.length; i++) {
    const gap = distanceToPolyline(p, [points.at(i - 1)!, points[i]!]);
    if (gap <= nearest) {
      best = i;
      nearest = gap;
    }
  }
  return best;
}

export const vertexAt = (points: readonly Point[], p: Point, reach: number): number =>
  points.findIndex((corner) => distance(corner, p) <= reach);
