/** The ground's sides: what stands in their way, and the scene with one of them elsewhere. */
import { thingsOf } from "./selection";
import type { Pose } from "parkade";
import { footprint, mapOutline, resolve, type Scene } from "./model";
import { boxOf, type Box, type Point } from "./geometry";
import type { Scenario } from "./scenario";
import { outlineOfThing } from "./scene-objects";
import { nth } from "./nth";

export type Side = "left" | "right" | "bottom" | "top";
export const SIDES: readonly Side[] = ["right", "top", "left", "bottom"];

/** Metres that a side keeps from the opposite one, and cells that a map has, at most, from side to side. */
export const LEAST = 1,
  MOST_CELLS = 4096;
/** Two coordinates are one. */
const SAME = 1e-6;

export const axisOf = (side: Side): 0 | 1 => (side === "left" || side === "right" ? 0 : 1);
/** Outward along the axis. */
export const outward = (side: Side): 1 | -1 => (side === "right" || side === "top" ? 1 : -1);
export const opposite = (side: Side): Side => nth(SIDES, (SIDES.indexOf(side) + 2) % 4);

export const groundOf = (scene: Scene): Box => boxOf(mapOutline(scene));

export function coordinateOf({ minX, maxX, minY, maxY }: Box, side: Side): number {
  return { left: minX, right: maxX, bottom: minY, top: maxY }[side];
}

export const sizeAlong = (box: Box, axis: 0 | 1): number => (axis === 0 ? box.maxX - box.minX : box.maxY - box.minY);

/** The longest straight edge on a side; null where moving it would bend the edges beside it. */
export function edgeOn(scene: Scene, side: Side): [Point, Point] | null {
  const outline = mapOutline(scene),
    k = axisOf(side),
    at = coordinateOf(boxOf(outline), side);
  const isOn = (p: Point): boolean => Math.abs(p[k] - at) < SAME;
  let best: [Point, Point] | null = null,
    longest = SAME;
  for (let i = 0; i < outline.length; i++) {
    const p = nth(outline, i),
      q = nth(outline, (i + 1) % outline.length),
      length = Math.abs(nth(q, 1 - k) - nth(p, 1 - k));
    if (isOn(p) !== isOn(q) && length > SAME) return null;
    if (isOn(p) && isOn(q) && length > longest) [best, longest] = [[p, q], length];
  }
  return best;
}

/** What a side stops at; `id` of a thing, of a pose, or nothing where only the ground's own size does. */
export interface Stop {
  at: number;
  id: string | null;
}
/** How far a side may move, as coordinates. */
export interface Room {
  inner: Stop;
  outer: number;
}

/**
 * Nothing that is on the ground ends up off it: what stands inside stays so, what lies across the border keeps to it.
 */
export function roomOf(scene: Scene, side: Side): Room {
  const outline = mapOutline(scene),
    k = axisOf(side),
    sign = outward(side),
    now = sign * coordinateOf(boxOf(outline), side);
  const out = (points: readonly Point[]): number[] => points.map((p) => sign * p[k]);
  const own = Math.max(...out(outline).filter((value) => value < now - SAME));
  const inner: Stop = { at: Math.min(now, own + LEAST), id: null };
  for (const [id, points] of standing(scene)) {
    const reach = out(points),
      far = Math.max(...reach),
      limit = far <= now + SAME ? far : Math.min(...reach);
    if (limit <= now + SAME && limit > inner.at)
      Object.assign(inner, { at: Math.min(now, Math.ceil(limit * 1000 - SAME) / 1000), id });
  }
  return { inner: { ...inner, at: sign * inner.at }, outer: outerOf(scene, side) };
}

/** Corners of everything that stands somewhere, by its id; the car's poses are "start" and "goal". */
function standing(scene: Scene): [string, readonly Point[]][] {
  const { start, goal, vehicle, parked } = resolve(scene),
    car = (pose: Pose): Point[] => footprint(pose, vehicle);
  const things = thingsOf(scene).map((one): [string, Point[]] => {
    const half = "thickness" in one ? (one.thickness ?? 0) / 2 : 0,
      points = outlineOfThing(scene, one.id);
    return [
      one.id,
      half > 0
        ? points.flatMap(([x, y]): Point[] => [
            [x - half, y - half],
            [x + half, y + half],
          ])
        : points,
    ];
  });
  const cars = parked.map((one): [string, Point[]] => [one.slot.id, footprint(one.pose, one.vehicle)]);
  return [["start", car(start)], ["goal", car(goal)], ...cars, ...things.filter(([, points]) => points.length > 0)];
}

/** The lattice line on or beyond a place. */
const lineAt = ({ map: { origin, resolution } }: Scene, side: Side, at: number): number =>
  outward(side) * Math.ceil((outward(side) * (at - origin[axisOf(side)])) / resolution - SAME);

/** The line at which the map ends on a side. */
const endOf = ({ map: { width, height } }: Scene, side: Side): number =>
  outward(side) < 0 ? 0 : axisOf(side) === 0 ? width : height;

function outerOf(scene: Scene, side: Side): number {
  const { map } = scene,
    k = axisOf(side),
    spare = Math.max(0, MOST_CELLS - (k === 0 ? map.width : map.height));
  return (
    map.origin[k] + (lineAt(scene, side, coordinateOf(groundOf(scene), side)) + outward(side) * spare) * map.resolution
  );
}

/** The scene with a side there. Cells keep their places in the world, painted ones stay on the map. */
export function moveSide(scene: Scene, side: Side, at: number): Scene {
  const outline = mapOutline(scene),
    k = axisOf(side),
    from = coordinateOf(boxOf(outline), side),
    sign = outward(side);
  if (at === from) return scene;
  const boundary = outline.map((p): Point => (Math.abs(p[k] - from) < SAME ? (k === 0 ? [at, p[1]] : [p[0], at]) : p));
  // What lies between the ground and the map's end stays between them.
  const end = endOf(scene, side) + lineAt(scene, side, at) - lineAt(scene, side, from),
    painted = paintedTo(scene, side);
  return withFrame(scene, k, sign, painted === null ? end : sign * Math.max(sign * end, sign * painted), boundary);
}

/** The lattice line beyond the outermost painted cell. */
function paintedTo(scene: Scene, side: Side): number | null {
  const k = axisOf(side);
  let far: number | null = null;
  for (const one of thingsOf(scene)) {
    if (!("runs" in one)) continue;
    for (const [x, y, count] of one.runs) {
      const [low, high] = k === 0 ? [x, x + count] : [y, y + 1];
      far = outward(side) > 0 ? Math.max(far ?? high, high) : Math.min(far ?? low, low);
    }
  }
  return far;
}

function withFrame(scene: Scene, k: 0 | 1, sign: 1 | -1, end: number, boundary: Point[]): Scene {
  const { origin, resolution, width, height } = scene.map,
    shift = sign < 0 ? end : 0;
  const cells: Point = [width, height],
    start: Point = [...origin];
  cells[k] = sign > 0 ? end : cells[k] - end;
  if (shift !== 0) start[k] = Math.round((origin[k] + shift * resolution) * 1e9) / 1e9;
  const map: Scenario["map"] = { origin: start, width: cells[0], height: cells[1], resolution };
  const { minX, maxX, minY, maxY } = boxOf(boundary),
    close = (a: number, b: number): boolean => Math.abs(a - b) < SAME;
  const isWhole =
    boundary.length === 4 &&
    close(minX, start[0]) &&
    close(minY, start[1]) &&
    close(maxX, start[0] + cells[0] * resolution) &&
    close(maxY, start[1] + cells[1] * resolution);
  return { ...(shift === 0 ? scene : shifted(scene, k, -shift)), map: isWhole ? map : { ...map, boundary } };
}

/** Painted cells by as many columns or rows. */
function shifted(scene: Scene, k: 0 | 1, by: number): Scene {
  const moved = <T>(one: T): T =>
    typeof one === "object" && one !== null && "runs" in one
      ? {
          ...one,
          runs: (one.runs as [number, number, number][]).map(([x, y, count]) =>
            k === 0 ? [x + by, y, count] : [x, y + by, count],
          ),
        }
      : one;
  const { obstacles, costs } = scene;
  return {
    ...scene,
    ...(obstacles ? { obstacles: obstacles.map(moved) } : {}),
    ...(costs ? { costs: costs.map(moved) } : {}),
  };
}
