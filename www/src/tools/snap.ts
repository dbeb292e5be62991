/** Snapping: to corners, to the cell grid, to angles, to slots and to the other pose. */
import type { Goal, Pose } from "parkade";
import { poseInSlot, resolve, type Scene } from "../scene/model";
import { boxOf, distance, radians, wrapAngle, type Box, type Point } from "../scene/geometry";
import { cornersOf, verticesOf, type Shape } from "../scene/shapes";
import type { Guide } from "../store/draft";
import { metresOf, type ToolContext, type Input } from "./tool";

const SNAP_PX = 8;
const ANGLE_STEP = radians(15),
  ANGLE_REACH = radians(3);
/** How near and how straight a dragged goal comes to its pose in a slot before it takes it. */
const SLOT_REACH = { metres: 1.2, px: 14, angle: radians(35) };

/** Ctrl inverts the setting. */
export const snaps = (context: ToolContext, input: Input): boolean =>
  !input.keyed && context.store.state.toolOptions.snap !== input.ctrl;

/** Multiples of 15° within 3°; `free` leaves the angle alone, `always` takes the nearest. */
export function snapAngle(angle: number, mode: "near" | "always" | "free" = "near"): number {
  const nearest = Math.round(angle / ANGLE_STEP) * ANGLE_STEP;
  return mode === "always" || (mode === "near" && Math.abs(wrapAngle(angle - nearest)) <= ANGLE_REACH)
    ? wrapAngle(nearest)
    : wrapAngle(angle);
}

/** `to` turned about `from` onto the nearest multiple of 15°. */
export function constrainAngle(from: Point, to: Point): Point {
  const angle = snapAngle(Math.atan2(to[1] - from[1], to[0] - from[0]), "always");
  const along = (to[0] - from[0]) * Math.cos(angle) + (to[1] - from[1]) * Math.sin(angle);
  return [from[0] + along * Math.cos(angle), from[1] + along * Math.sin(angle)];
}

export interface Snapped {
  at: Point;
  guides: Guide[];
}

const both = (shift: (axis: 0 | 1) => Shift): [Shift, Shift] => [shift(0), shift(1)];

/** The nearest corner within 8 px, else in line with one or on the cell grid, else the point. */
export function snapPoint(context: ToolContext, input: Input, skip?: string): Snapped {
  if (!snaps(context, input)) return { at: input.at, guides: [] };
  const reach = metresOf(context, SNAP_PX),
    { scene } = context.store.state;
  const marks = marksOf(scene, skip === undefined ? [] : [skip]);
  const corner = nearest(marks, input.at);
  if (corner && distance(corner, input.at) <= reach) return { at: corner, guides: [{ from: corner, to: corner }] };
  const [x, y] = both((axis) => lineUp(scene, marks, [input.at], axis, reach));
  const at: Point = [input.at[0] + x.by, input.at[1] + y.by];
  return { at, guides: guidesTo(at, x, y) };
}

/**
 * How far things dragged by `by` go: their edges or middle in line with something else, or their lower left corner on
 * the grid.
 */
export function snapMove(
  context: ToolContext,
  input: Input,
  from: Box,
  by: Point,
  skip: readonly string[],
): { by: Point; guides: Guide[] } {
  if (!snaps(context, input)) return { by, guides: [] };
  const reach = metresOf(context, SNAP_PX),
    { scene } = context.store.state;
  const [left, low, right, high] = [from.minX + by[0], from.minY + by[1], from.maxX + by[0], from.maxY + by[1]];
  const marks = marksOf(scene, skip);
  const [x, y] = both((axis) =>
    lineUp(
      scene,
      marks,
      [
        [left, low],
        [right, high],
        [(left + right) / 2, (low + high) / 2],
      ],
      axis,
      reach,
    ),
  );
  const middle: Point = [(left + right) / 2 + x.by, (low + high) / 2 + y.by];
  return { by: [by[0] + x.by, by[1] + y.by], guides: guidesTo(middle, x, y) };
}

/** How far to go along one axis, and the mark that is then in line. */
interface Shift {
  by: number;
  mark: Point | null;
  at: number;
}

function lineUp(
  { map: { origin, resolution } }: Scene,
  marks: readonly Point[],
  points: readonly Point[],
  axis: 0 | 1,
  reach: number,
): Shift {
  let best: Shift = { by: 0, mark: null, at: 0 },
    least = reach;
  for (const mark of marks) {
    for (const p of points) {
      const by = mark[axis] - p[axis];
      if (Math.abs(by) < least || (Math.abs(by) === least && !best.mark))
        [best, least] = [{ by, mark, at: mark[axis] }, Math.abs(by)];
    }
  }
  if (best.mark) return best;
  const value = points[0]![axis],
    line = origin[axis] + Math.round((value - origin[axis]) / resolution) * resolution;
  return Math.abs(line - value) <= reach ? { by: line - value, mark: null, at: line } : best;
}

function guidesTo([x, y]: Point, across: Shift, along: Shift): Guide[] {
  const guides: Guide[] = [];
  if (across.mark) guides.push({ from: [across.at, y], to: across.mark });
  if (along.mark) guides.push({ from: [x, along.at], to: along.mark });
  return guides;
}

/** More corners than this are not looked through at every move. */
const MOST_MARKS = 4000;

/** Snap targets: corners and wall ends, the floor's outline, slots, the cars' reference points. */
function marksOf(scene: Scene, skip: readonly string[]): Point[] {
  const { boundary, slots, start, goal } = resolve(scene);
  const marks: Point[] = [...boundary, [start.x, start.y], [goal.x, goal.y]];
  for (const one of scene.obstacles ?? []) {
    if (one.type === "cells" || skip.includes(one.id ?? "") || marks.length > MOST_MARKS) continue;
    marks.push(
      ...(one.type === "car" ? cornersOf(one) : verticesOf(one)),
      ...(one.type === "wall" || one.type === "road" ? [] : [middleOf(one)]),
    );
  }
  for (const { slot, outline } of slots) if (!skip.includes(slot.id ?? "")) marks.push(...outline);
  return marks;
}

function middleOf(shape: Shape): Point {
  const { minX, maxX, minY, maxY } = boxOf(cornersOf(shape));
  return [(minX + maxX) / 2, (minY + maxY) / 2];
}

function nearest(marks: readonly Point[], at: Point): Point | null {
  let best: Point | null = null;
  for (const mark of marks) if (!best || distance(mark, at) < distance(best, at)) best = mark;
  return best;
}

export interface SnappedPose {
  pose: Pose;
  goal: Goal;
  guides: Guide[];
}

/** A dragged pose: into a free slot close by, or in line with the other pose. */
export function snapPose(context: ToolContext, input: Input, which: "start" | "goal", pose: Pose): SnappedPose {
  if (!snaps(context, input)) return { pose, goal: pose, guides: [] };
  const slot = which === "goal" ? snapToSlot(context, pose) : null;
  if (slot) return slot;
  const resolved = resolve(context.store.state.scene);
  return align(context, pose, which === "start" ? resolved.goal : resolved.start);
}

function snapToSlot(context: ToolContext, pose: Pose): SnappedPose | null {
  const { scene } = context.store.state,
    { vehicle } = resolve(scene);
  let least = Math.max(metresOf(context, SLOT_REACH.px), SLOT_REACH.metres),
    best: SnappedPose | null = null;
  for (const slot of scene.slots ?? []) {
    if (slot.occupied || slot.id === undefined) continue;
    for (const entry of ["reverse-in", "head-in"] as const) {
      const there = poseInSlot(slot, entry, vehicle),
        away = Math.hypot(there.x - pose.x, there.y - pose.y);
      if (away > least || Math.abs(wrapAngle(there.heading - pose.heading)) > SLOT_REACH.angle) continue;
      least = away;
      best = { pose: there, goal: { slot: slot.id, entry }, guides: [axisGuide(there)] };
    }
  }
  return best;
}

const axisGuide = ({ x, y, heading }: Pose): Guide => {
  const dx = Math.cos(heading) * 8,
    dy = Math.sin(heading) * 8;
  return { from: [x - dx, y - dy], to: [x + dx, y + dy] };
};

function align(context: ToolContext, pose: Pose, other: Pose): SnappedPose {
  const reach = metresOf(context, SNAP_PX) * 0.75;
  const x = Math.abs(pose.x - other.x) <= reach ? other.x : pose.x;
  const y = Math.abs(pose.y - other.y) <= reach ? other.y : pose.y;
  const guides: Guide[] = x === other.x || y === other.y ? [{ from: [x, y], to: [other.x, other.y] }] : [];
  const snapped = { ...pose, x, y };
  return { pose: snapped, goal: snapped, guides };
}
