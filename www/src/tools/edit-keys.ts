/** Keys that edit, where they need no pointer. */
import { isPose } from "../scene/selection";
import { flipGoal } from "../scene/goals";
import { movePose, resolve, type Scene } from "../scene/model";
import { removeThings } from "../scene/removal";
import { radians } from "../scene/geometry";
import { allIds, copyThings, idsOf, moveThings, selectionOf } from "../scene/scene-objects";
import { turnThings } from "../scene/turning";
import { type State, type Store } from "../store";
import { arrowOf, stepOf } from "./keys";

const RADIUS = { least: 0.1, most: 5, step: 1.25 };

/** Edits a key makes by itself; false where the key means nothing here. */
export function editByKey(store: Store, event: KeyboardEvent): boolean {
  const { state } = store;
  if (event.ctrlKey || event.metaKey) return editWithCtrl(store, event);
  const way = arrowOf(event.key);
  if (way) return nudge(store, way, event.shiftKey);
  switch (event.key) {
    case "Delete":
    case "Backspace":
      return removeSelected(store);
    case "[":
      return setRadius(store, state.toolOptions.brushRadius / RADIUS.step);
    case "]":
      return setRadius(store, state.toolOptions.brushRadius * RADIUS.step);
    case "{":
      return setWeight(store, -1);
    case "}":
      return setWeight(store, 1);
    case "x":
    case "X":
      store.edit(flipGoal(state.scene), { label: "flip" });
      return true;
    case "q":
    case "Q":
      store.set({ toolOptions: { ...state.toolOptions, locked: !state.toolOptions.locked } });
      return true;
    default:
      return false;
  }
}

function editWithCtrl(store: Store, event: KeyboardEvent): boolean {
  switch (event.key) {
    case "a":
    case "A":
      return selectAll(store);
    case "d":
    case "D":
      return duplicateSelected(store);
    case "ArrowLeft":
      return turn(store, 1, event.shiftKey);
    case "ArrowRight":
      return turn(store, -1, event.shiftKey);
    default:
      return false;
  }
}

function setRadius(store: Store, radius: number): boolean {
  const brushRadius = Math.min(RADIUS.most, Math.max(RADIUS.least, Math.round(radius * 100) / 100));
  store.set({ toolOptions: { ...store.state.toolOptions, brushRadius } });
  return true;
}

function setWeight(store: Store, step: number): boolean {
  const { toolOptions } = store.state;
  store.set({ toolOptions: { ...toolOptions, costWeight: Math.min(10, Math.max(1, toolOptions.costWeight + step)) } });
  return true;
}

/** One cell, a metre with Shift. */
function nudge(store: Store, [dx, dy]: [number, number], far: boolean): boolean {
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

/** By five degrees, one with Shift. */
function turn(store: Store, sign: 1 | -1, little: boolean): boolean {
  const { scene, selection } = store.state,
    angle = sign * radians(little ? 1 : 5);
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
