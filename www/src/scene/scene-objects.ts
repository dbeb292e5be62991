/** Obstacles, slots and moving obstacles by their ids, whatever they are. */
import { thingsOf, type Selection } from "./selection";
import type { CostArea, MovingObstacle, Obstacle, Slot } from "./scenario";
import type { Run } from "./cells";
import {
  addMoving,
  addObstacle,
  addSlots,
  findCost,
  findMoving,
  findObstacle,
  findSlot,
  updateMoving,
  updateObstacle,
  updateSlot,
  withCosts,
  type Scene,
} from "./model";
import { boxOf, type Box, type Point } from "./geometry";
import { cornersOf, moveShape } from "./shapes";
import { slotOutline } from "./slots";

type Thing =
  | { kind: "obstacle"; thing: Obstacle }
  | { kind: "slot"; thing: Slot }
  | { kind: "moving"; thing: MovingObstacle }
  | { kind: "cost"; thing: CostArea };

export function findThing(scene: Scene, id: string): Thing | null {
  const obstacle = findObstacle(scene, id);
  if (obstacle) return { kind: "obstacle", thing: obstacle };
  const slot = findSlot(scene, id);
  if (slot) return { kind: "slot", thing: slot };
  const moving = findMoving(scene, id);
  if (moving) return { kind: "moving", thing: moving };
  const cost = findCost(scene, id);
  return cost ? { kind: "cost", thing: cost } : null;
}

/** Ids of what is chosen; none for start and goal. */
export const idsOf = (selection: Selection): readonly string[] =>
  selection === null ? [] : selection.kind === "group" ? selection.ids : "id" in selection ? [selection.id] : [];

/** One thing is chosen as itself, several as a group. */
export function selectionOf(scene: Scene, ids: readonly string[]): Selection {
  if (ids.length > 1) return { kind: "group", ids };
  const found = ids[0] === undefined ? null : findThing(scene, ids[0]);
  return found && { kind: found.kind, id: ids[0]! };
}

export const allIds = (scene: Scene): string[] => thingsOf(scene).map((one) => one.id);

/** Corners of a thing; of brushed cells those of their extent. */
export function outlineOfThing(scene: Scene, id: string): Point[] {
  const found = findThing(scene, id);
  if (!found) return [];
  if (found.kind === "slot") return slotOutline(found.thing);
  if (found.kind === "moving") return found.thing.points;
  if (found.kind === "cost") return extentOf(found.thing.runs, scene.map);
  return found.thing.type === "cells" ? extentOf(found.thing.runs, scene.map) : cornersOf(found.thing);
}

function extentOf(runs: readonly Run[], { origin: [ox, oy], resolution: side }: Scene["map"]): Point[] {
  let left = Infinity,
    right = -Infinity,
    low = Infinity,
    high = -Infinity;
  for (const [x, y, count] of runs) {
    left = Math.min(left, x);
    right = Math.max(right, x + count);
    low = Math.min(low, y);
    high = Math.max(high, y + 1);
  }
  return runs.length === 0
    ? []
    : [
        [ox + left * side, oy + low * side],
        [ox + right * side, oy + high * side],
      ];
}

export const boxOfThings = (scene: Scene, ids: readonly string[]): Box =>
  boxOf(ids.flatMap((id) => outlineOfThing(scene, id)));

/** The things wholly inside a box; brushed cells cannot be picked. */
export function thingsWithin(scene: Scene, { minX, minY, maxX, maxY }: Box): string[] {
  const cells = new Set(
    thingsOf(scene)
      .filter((one) => "runs" in one)
      .map((one) => one.id),
  );
  return allIds(scene).filter(
    (id) =>
      !cells.has(id) && outlineOfThing(scene, id).every(([x, y]) => x >= minX && x <= maxX && y >= minY && y <= maxY),
  );
}

/** Brushed cells move by whole cells. */
export function moveThings(scene: Scene, ids: readonly string[], dx: number, dy: number): Scene {
  return ids.reduce((next, id) => {
    const found = findThing(next, id);
    if (found?.kind === "slot") return updateSlot(next, id, { x: found.thing.x + dx, y: found.thing.y + dy });
    if (found?.kind === "moving")
      return updateMoving(next, id, { points: found.thing.points.map(([x, y]) => [x + dx, y + dy]) });
    if (found?.kind === "cost")
      return withCosts(
        next,
        next.costs!.map((one) => (one.id === id ? { ...one, runs: movedRuns(one.runs, next.map, dx, dy) } : one)),
      );
    if (found?.kind !== "obstacle") return next;
    const { thing } = found;
    return updateObstacle(
      next,
      id,
      thing.type === "cells" ? { ...thing, runs: movedRuns(thing.runs, next.map, dx, dy) } : moveShape(thing, dx, dy),
    );
  }, scene);
}

function movedRuns(runs: readonly Run[], { width, height, resolution }: Scene["map"], dx: number, dy: number): Run[] {
  const columns = Math.round(dx / resolution),
    rows = Math.round(dy / resolution);
  return runs.flatMap(([x, y, count]): Run[] => {
    const from = Math.max(0, x + columns),
      to = Math.min(width, x + columns + count),
      row = y + rows;
    return from < to && row >= 0 && row < height ? [[from, row, to - from]] : [];
  });
}

/** Copies where the originals are; brushed cells are one and are not copied. */
export function copyThings(scene: Scene, ids: readonly string[]): { scene: Scene; ids: string[] } {
  const copies: string[] = [];
  const next = ids.reduce((before, id) => {
    const found = findThing(before, id);
    if (!found || "runs" in found.thing) return before;
    const made =
      found.kind === "slot"
        ? addSlots(before, [found.thing])
        : found.kind === "moving"
          ? addMoving(before, found.thing)
          : addObstacle(before, found.thing as Obstacle);
    copies.push("ids" in made ? made.ids[0]! : made.id);
    return made.scene;
  }, scene);
  return { scene: next, ids: copies };
}
