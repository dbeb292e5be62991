/** What differs between two scenes: where bays may have become easier or harder to reach. */
import { boxOf, distance, fromPose, type Box, type Point } from "./geometry";
import { slotOutline } from "./slots";
import { cornersOf } from "./shapes";
import type { Obstacle, Scenario, Slot } from "./scenario";
import { vehicleOf } from "./vehicle";
import type { Pose, Vehicle } from "parkade";
import { nth } from "./nth";

export interface SceneChanges {
  /** True if every answer may be another: the ground, the car, the start or painted costs have changed. */
  everywhere: boolean;
  /** Boxes around what was added, removed, moved or changed, before and after. */
  boxes: Box[];
  /** Bays that have changed themselves. */
  slots: ReadonlySet<string>;
}

/** Things that no planner of single bays looks at are left out: the goal, moving obstacles, lanes. */
export function changesBetween(before: Scenario, after: Scenario): SceneChanges {
  const whole = ["map", "vehicle", "start", "costs", "planners"] as const,
    everywhere = whole.some((key) => before[key] !== after[key] && !isAlike(before[key], after[key]));
  const boxes: Box[] = [],
    slots = new Set<string>();
  for (const [one, other] of changed(before.obstacles ?? [], after.obstacles ?? []))
    for (const obstacle of [one, other]) if (obstacle) boxes.push(boxOfObstacle(obstacle, after));
  for (const [one, other] of changed(before.slots ?? [], after.slots ?? []))
    for (const slot of [one, other]) {
      if (!slot) continue;
      if (slot.id !== undefined) slots.add(slot.id);
      boxes.push(boxOf(slotOutline(slot)));
    }
  return { everywhere, boxes, slots };
}

const isAlike = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

/** Pairs of things with one id that are not the same; one of them is undefined where it was added or removed. */
function changed<T extends Obstacle | Slot>(
  before: readonly T[],
  after: readonly T[],
): [T | undefined, T | undefined][] {
  const keyOf = (thing: T, i: number): string => thing.id ?? `#${i}`,
    old = new Map(before.map((thing, i) => [keyOf(thing, i), thing]));
  const pairs = after.map((thing, i): [T | undefined, T | undefined] => {
    const was = old.get(keyOf(thing, i));
    old.delete(keyOf(thing, i));
    return [was, thing];
  });
  const left = [...old.values()].map((thing): [T | undefined, T | undefined] => [thing, undefined]);
  return [...pairs, ...left].filter(([a, b]) => a !== b && !(a && b && isAlike(a, b)));
}

function boxOfObstacle(obstacle: Obstacle, { map: { origin, resolution } }: Scenario): Box {
  if (obstacle.type !== "cells") {
    const by = obstacle.type === "wall" ? (obstacle.thickness ?? 0) / 2 : obstacle.type === "road" ? 20 : 0;
    return grown(boxOf(cornersOf(obstacle)), by);
  }
  const corners = obstacle.runs.flatMap(([x, y, count]): Point[] => [
    [origin[0] + x * resolution, origin[1] + y * resolution],
    [origin[0] + (x + count) * resolution, origin[1] + (y + 1) * resolution],
  ]);
  return boxOf(corners);
}

export const grown = ({ minX, minY, maxX, maxY }: Box, by: number): Box => ({
  minX: minX - by,
  minY: minY - by,
  maxX: maxX + by,
  maxY: maxY + by,
});

/**
 * True if the body at any pose of a way (x, y, heading, …) comes within `reach` of a box, by the axes of both; at a
 * corner it may be a little farther away.
 */
export function sweepsNear(poses: ArrayLike<number>, vehicle: Vehicle, boxes: readonly Box[], reach: number): boolean {
  const length = (vehicle.rearToFront + vehicle.rearToBack) / 2,
    ahead = vehicle.rearToFront - length,
    width = vehicle.width / 2;
  for (let i = 0; i + 2 < poses.length; i += 3) {
    const cos = Math.cos(nth(poses, i + 2)),
      sin = Math.sin(nth(poses, i + 2)),
      x = nth(poses, i) + ahead * cos,
      y = nth(poses, i + 1) + ahead * sin;
    for (const box of boxes) {
      const dx = (box.minX + box.maxX) / 2 - x,
        dy = (box.minY + box.maxY) / 2 - y,
        w = (box.maxX - box.minX) / 2 + reach,
        h = (box.maxY - box.minY) / 2 + reach,
        [c, s] = [Math.abs(cos), Math.abs(sin)];
      if (
        Math.abs(dx) <= w + length * c + width * s &&
        Math.abs(dy) <= h + length * s + width * c &&
        Math.abs(dx * cos + dy * sin) <= length + w * c + h * s &&
        Math.abs(dy * cos - dx * sin) <= width + w * s + h * c
      )
        return true;
    }
  }
  return false;
}

export const distanceTo = (place: Point, { minX, minY, maxX, maxY }: Box): number =>
  distance(place, [Math.min(Math.max(place[0], minX), maxX), Math.min(Math.max(place[1], minY), maxY)]);

export const isNear = (place: Point, box: Box, reach: number): boolean => distanceTo(place, box) <= reach;

/** The same place of the tail for another vehicle. */
export function sameTail(pose: Pose, before: Scenario["vehicle"], after: Scenario["vehicle"]): Pose {
  const [x, y] = fromPose(pose, vehicleOf(after).rearToBack - vehicleOf(before).rearToBack, 0);
  return { x, y, heading: pose.heading };
}
