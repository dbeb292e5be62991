/** Snapping: to corners, to the cell grid, to angles, to slots and to the other pose. */
import type { Goal, Pose } from "parkade";
import { poseInSlot, resolve, type Scene } from "../scene/model";
import { distance, radians, wrapAngle, type Point } from "../scene/plane";
import { verticesOf } from "../scene/shapes";
import type { Guide } from "./draft";
import { metresOf, type Bench, type Input } from "./tool";

const SNAP_PX = 8;
const ANGLE_STEP = radians(15), ANGLE_REACH = radians(3);

/** Ctrl inverts the setting. */
export const snaps = (bench: Bench, input: Input): boolean => bench.store.state.toolOptions.snap !== input.ctrl;

/** Multiples of 15° within 3°; `free` leaves the angle alone, `always` takes the nearest. */
export function snapAngle(angle: number, mode: "near" | "always" | "free" = "near"): number {
  const nearest = Math.round(angle / ANGLE_STEP) * ANGLE_STEP;
  return mode === "always" || (mode === "near" && Math.abs(wrapAngle(angle - nearest)) <= ANGLE_REACH) ? wrapAngle(nearest) : wrapAngle(angle);
}

/** `to` turned about `from` onto the nearest multiple of 15°. */
export function constrainAngle(from: Point, to: Point): Point {
  const angle = snapAngle(Math.atan2(to[1] - from[1], to[0] - from[0]), "always");
  const along = (to[0] - from[0]) * Math.cos(angle) + (to[1] - from[1]) * Math.sin(angle);
  return [from[0] + along * Math.cos(angle), from[1] + along * Math.sin(angle)];
}

/** The nearest corner within 8 px, else the nearest cell corner within 8 px, else the point. */
export function snapPoint(bench: Bench, input: Input, skip?: string): Point {
  if (!snaps(bench, input)) return input.at;
  const reach = metresOf(bench, SNAP_PX);
  const corner = nearestCorner(bench.store.state.scene, input.at, skip);
  if (corner && distance(corner, input.at) <= reach) return corner;
  const { origin, resolution } = bench.store.state.scene.map;
  const onGrid = (value: number, from: number): number => {
    const line = from + Math.round((value - from) / resolution) * resolution;
    return Math.abs(line - value) <= reach ? line : value;
  };
  return [onGrid(input.at[0], origin[0]), onGrid(input.at[1], origin[1])];
}

function nearestCorner(scene: Scene, at: Point, skip: string | undefined): Point | null {
  const { boundary, slots } = resolve(scene);
  const shapes = (scene.obstacles ?? []).flatMap((o) => (o.type === "cells" || o.id === skip ? [] : verticesOf(o)));
  let best: Point | null = null;
  for (const corner of [...boundary, ...shapes, ...slots.flatMap((one) => one.outline)]) {
    if (!best || distance(corner, at) < distance(best, at)) best = corner;
  }
  return best;
}

export interface SnappedPose { pose: Pose; goal: Goal; guides: Guide[] }

/** A dragged pose: into a free slot close by, or in line with the other pose. */
export function snapPose(bench: Bench, input: Input, which: "start" | "goal", pose: Pose): SnappedPose {
  if (!snaps(bench, input)) return { pose, goal: pose, guides: [] };
  const slot = which === "goal" ? snapToSlot(bench, pose) : null;
  if (slot) return slot;
  const resolved = resolve(bench.store.state.scene);
  return align(bench, pose, which === "start" ? resolved.goal : resolved.start);
}

function snapToSlot(bench: Bench, pose: Pose): SnappedPose | null {
  const { scene } = bench.store.state;
  const reach = Math.max(metresOf(bench, SNAP_PX), 0.25);
  const { vehicle } = resolve(scene);
  for (const slot of scene.slots ?? []) {
    if (slot.occupied || slot.id === undefined) continue;
    for (const entry of ["reverse-in", "head-in"] as const) {
      const there = poseInSlot(slot, entry, vehicle);
      const turned = Math.abs(wrapAngle(there.heading - pose.heading));
      if (Math.hypot(there.x - pose.x, there.y - pose.y) <= reach && turned < radians(10)) {
        return { pose: there, goal: { slot: slot.id, entry }, guides: [axisGuide(there)] };
      }
    }
  }
  return null;
}

const axisGuide = ({ x, y, heading }: Pose): Guide => {
  const dx = Math.cos(heading) * 8, dy = Math.sin(heading) * 8;
  return { from: [x - dx, y - dy], to: [x + dx, y + dy] };
};

function align(bench: Bench, pose: Pose, other: Pose): SnappedPose {
  const reach = metresOf(bench, SNAP_PX) * 0.75;
  const x = Math.abs(pose.x - other.x) <= reach ? other.x : pose.x;
  const y = Math.abs(pose.y - other.y) <= reach ? other.y : pose.y;
  const guides = x === other.x || y === other.y ? [{ from: [x, y] as Point, to: [other.x, other.y] as Point }] : [];
  const snapped = { ...pose, x, y };
  return { pose: snapped, goal: snapped, guides };
}
