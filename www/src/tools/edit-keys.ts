/** Edits that need no pointer. */
import { isPose } from "../scene/selection";
import { flipGoal } from "../scene/goals";
import { movePose, resolve, type Scene } from "../scene/model";
import { removeThings } from "../scene/removal";
import { radians } from "../scene/geometry";
import { allIds, copyThings, idsOf, moveThings, selectionOf } from "../scene/scene-objects";
import { turnThings } from "../scene/turning";
import type { State, Store } from "../store";
import { stepOf } from "./arrow-keys";

const RADIUS = { least: 0.1, most: 5, step: 1.25 };

/** One step larger, or smaller. */
export function setRadius(store: Store, steps: 1 | -1): boolean {
  const { toolOptions } = store.state,
    radius = toolOptions.brushRadius * RADIUS.step ** steps;
  const brushRadius = Math.min(RADIUS.most, Math.max(RADIUS.least, Math.round(radius * 100) / 100));
  store.set({ toolOptions: { ...toolOptions, brushRadius } });
  return true;
}

/** The goal's heading, or the way into its slot. */
export function flipEntry(store: Store): true {
  store.edit(flipGoal(store.state.scene), { label: "flip" });
  return true;
}

/** Whether a tool stays in force after a shape. */
export function toggleLock(store: Store): true {
  const { toolOptions } = store.state;
  store.set({ toolOptions: { ...toolOptions, locked: !toolOptions.locked } });
  return true;
}

export function setWeight(store: Store, step: number): boolean {
  const { toolOptions } = store.state;
  store.set({ toolOptions: { ...toolOptions, costWeight: Math.min(10, Math.max(1, toolOptions.costWeight + step)) } });
  return true;
}

/** Moves the selection by one cell, or by a metre. */
export function nudge(store: Store, [dx, dy]: [number, number], far: boolean): boolean {
  const step = stepOf(store.state.scene.map, far);
  const moved = nudged(store.state, dx * step, dy * step);
  if (!moved) return false;
  store.edit(moved, { label: "nudge" });
  return true;
}

function nudged({ scene, selection }: State, dx: number, dy: number): Scene | null {
  if (isPose(selection)) {
    const pose = resolve(scene)[selection.kind];
    return movePose(scene, selection.kind, { ...pose, x: pose.x + dx, y: pose.y + dy });
  }
  const ids = idsOf(selection);
  return ids.length > 0 ? moveThings(scene, ids, dx, dy) : null;
}

/** Turns the selection to the left. */
export function turn(store: Store, degrees: number): boolean {
  const { scene, selection } = store.state,
    angle = radians(degrees);
  if (isPose(selection)) {
    const pose = resolve(scene)[selection.kind];
    store.edit(movePose(scene, selection.kind, { ...pose, heading: pose.heading + angle }), { label: "turn" });
    return true;
  }
  const ids = idsOf(selection);
  if (ids.length > 0) store.edit(turnThings(scene, ids, angle), { label: "turn" });
  return ids.length > 0;
}

export function removeSelected(store: Store): boolean {
  const { scene, selection } = store.state,
    ids = idsOf(selection);
  if (ids.length === 0) return false;
  store.edit(removeThings(scene, ids), { label: "delete" });
  store.set({ selection: null });
  return true;
}

/** Copies a cell to the right and below, chosen. */
export function duplicateSelected(store: Store): boolean {
  const { scene, selection } = store.state,
    step = Math.max(0.5, scene.map.resolution);
  const { scene: copied, ids } = copyThings(scene, idsOf(selection));
  if (ids.length === 0) return false;
  store.edit(moveThings(copied, ids, step, -step), { label: "duplicate" });
  store.set({ selection: selectionOf(store.state.scene, ids) });
  return true;
}

export function selectAll(store: Store): boolean {
  const { scene } = store.state;
  store.set({ selection: selectionOf(scene, allIds(scene)), tool: "select" });
  return true;
}
