/** Keys of the playground, where they need no pointer. */
import {
  findObstacle, findSlot, flipGoal, moveObstacle, movePose, removeMoving, removeObstacle, removeSlot, resolve, shiftMoving, updateSlot, type Scene,
} from "../scene/model";
import type { State, Store, ToolId } from "../store";

const TOOL_KEYS: Record<string, ToolId> = {
  v: "select", 1: "select", b: "brush", 2: "brush", l: "wall", 3: "wall", r: "rectangle", 4: "rectangle", g: "polygon", 5: "polygon",
  c: "car", 6: "car", p: "slot", 7: "slot", m: "moving", 8: "moving", e: "eraser", 9: "eraser", h: "hand",
};

const ARROWS: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const RADIUS = { least: 0.1, most: 5, step: 1.25 };

export const toolOfKey = (key: string): ToolId | undefined => TOOL_KEYS[key.toLowerCase()];

/** Edits a key makes by itself; false where the key means nothing here. */
export function editByKey(store: Store, event: KeyboardEvent): boolean {
  const { state } = store;
  if (ARROWS[event.key]) return nudge(store, ARROWS[event.key]!, event.shiftKey);
  switch (event.key) {
    case "Delete": case "Backspace": return removeSelected(store);
    case "[": return setRadius(store, state.toolOptions.brushRadius / RADIUS.step);
    case "]": return setRadius(store, state.toolOptions.brushRadius * RADIUS.step);
    case "x": case "X": store.edit(flipGoal(state.scene), { label: "flip" }); return true;
    case "q": case "Q": store.set({ toolOptions: { ...state.toolOptions, locked: !state.toolOptions.locked } }); return true;
    default: return false;
  }
}

function setRadius(store: Store, radius: number): boolean {
  const brushRadius = Math.min(RADIUS.most, Math.max(RADIUS.least, Math.round(radius * 100) / 100));
  store.set({ toolOptions: { ...store.state.toolOptions, brushRadius } });
  return true;
}

/** One cell, a metre with Shift. */
function nudge(store: Store, [dx, dy]: [number, number], far: boolean): boolean {
  const { scene } = store.state;
  const step = far ? 1 : scene.map.resolution;
  const moved = nudged(store.state, dx * step, dy * step);
  if (!moved) return false;
  store.edit(moved, { label: "nudge" });
  return true;
}

function nudged({ scene, selection }: State, dx: number, dy: number): Scene | null {
  if (!selection) return null;
  if (!("id" in selection)) {
    const pose = resolve(scene)[selection.kind];
    return movePose(scene, selection.kind, { ...pose, x: pose.x + dx, y: pose.y + dy });
  }
  if (selection.kind === "obstacle") return findObstacle(scene, selection.id) ? moveObstacle(scene, selection.id, dx, dy) : null;
  if (selection.kind === "moving") return shiftMoving(scene, selection.id, dx, dy);
  const slot = findSlot(scene, selection.id);
  return slot ? updateSlot(scene, selection.id, { x: slot.x + dx, y: slot.y + dy }) : null;
}

function removeSelected(store: Store): boolean {
  const { scene, selection } = store.state;
  if (!selection || !("id" in selection)) return false;
  const remove = { slot: removeSlot, obstacle: removeObstacle, moving: removeMoving }[selection.kind];
  store.edit(remove(scene, selection.id), { label: "delete" });
  store.set({ selection: null });
  return true;
}
