/** The scene as the page edits it: every edit gives a new scene and leaves the old one as it was. */
import { thingsOf } from "./selection";
import type { Goal, GoalSet, Pose, VehicleSpec } from "parkade";
import { wrapAngle, type Point } from "./geometry";
import type { CostArea, GivenObstacle, GivenScenario, MovingObstacle, Obstacle, Scenario, Slot } from "./scenario";
import { slotOutline, parkedPose, poseInSlot, type Entry } from "./slots";
import type { Shape } from "./shapes";
import { vehicleOf, type ResolvedVehicle } from "./vehicle";

export { vehicleOf, footprint } from "./vehicle";
export { slotOutline, parkedPose, poseInSlot, type Entry } from "./slots";

export type Scene = Scenario;
export type CellsObstacle = Extract<Obstacle, { type: "cells" }>;

/** The smallest free `prefix-n`. */
export function nextId(scene: Scene, prefix: string): string {
  const taken = new Set(thingsOf(scene).map((thing) => thing.id));
  for (let n = 1; ; n++) {
    const id = `${prefix}-${n}`;
    if (!taken.has(id)) return id;
  }
}

/** The scene with an id on every obstacle and slot; the same object where nothing is missing. */
export function ensureIds(scene: GivenScenario): Scene {
  const seen = new Set<string>();
  const keep = (id: string | undefined): boolean => id !== undefined && !seen.has(id) && seen.add(id) !== undefined;
  const all = thingsOf(scene);
  const missing = new Set<object>(all.filter((thing) => !keep(thing.id)));
  const hasName = <T extends object>(one: T): one is T & { id: string } => !missing.has(one);
  const isReady = (one: GivenScenario): one is Scene => missing.size === 0 && !!one.obstacles && !!one.slots;
  if (isReady(scene)) return scene;
  const last = new Map<string, number>();
  const name = <T extends object>(thing: T, prefix: string): T & { id: string } => {
    if (hasName(thing)) return thing;
    let n = (last.get(prefix) ?? 0) + 1;
    while (seen.has(`${prefix}-${n}`)) n++;
    last.set(prefix, n);
    seen.add(`${prefix}-${n}`);
    return { ...thing, id: `${prefix}-${n}` };
  };
  const { obstacles = [], slots = [], costs, moving, ...rest } = scene;
  return {
    ...rest,
    obstacles: obstacles.map((obstacle) => name(obstacle, obstacle.type)),
    slots: slots.map((slot) => name(slot, "slot")),
    ...(costs && { costs: costs.map((one) => name(one, "cost")) }),
    ...(moving && { moving: moving.map((one) => name(one, "moving")) }),
  };
}

export const findObstacle = (scene: Scene, id: string): Obstacle | undefined =>
  scene.obstacles?.find((o) => o.id === id);
export const findSlot = (scene: Scene, id: string): Slot | undefined => scene.slots?.find((s) => s.id === id);

export const findMoving = (scene: Scene, id: string): MovingObstacle | undefined =>
  scene.moving?.find((m) => m.id === id);

export function addMoving(scene: Scene, one: Omit<MovingObstacle, "id">): { scene: Scene; id: string } {
  const id = nextId(scene, "moving");
  return { scene: { ...scene, moving: [...(scene.moving ?? []), { ...one, id }] }, id };
}

export const updateMoving = (scene: Scene, id: string, patch: Partial<MovingObstacle>): Scene => ({
  ...scene,
  moving: (scene.moving ?? []).map((m) => (m.id === id ? { ...m, ...patch, id } : m)),
});

/** Without painted cells the scene holds no list of them. */
export const withCosts = ({ costs: _, ...scene }: Scene, costs: CostArea[]): Scene =>
  costs.length > 0 ? { ...scene, costs } : scene;
export const findCost = (scene: Scene, id: string): CostArea | undefined => scene.costs?.find((one) => one.id === id);

export const mapOutline = (scene: Scene): Point[] => {
  const {
    origin: [x, y],
    width,
    height,
    resolution,
    boundary,
  } = scene.map;
  const right = x + width * resolution,
    top = y + height * resolution;
  return (
    boundary ?? [
      [x, y],
      [right, y],
      [right, top],
      [x, top],
    ]
  );
};

export const isOneGoal = (goal: Goal | GoalSet): goal is Goal => "x" in goal || "slot" in goal;
export const isGoalPose = (goal: Goal | GoalSet): goal is Pose => "x" in goal;

/** Of sets of goals the one that is drawn and can be grabbed. */
const shownGoals = new WeakMap<GoalSet, Pose>();

/** The goal pose with slots resolved; for a set of goals the one shown, or the start before any is shown. */
export function goalPose({ goal, slots, vehicle, start }: Scene): Pose {
  if (isGoalPose(goal)) return goal;
  if (!isOneGoal(goal)) return shownGoals.get(goal) ?? start;
  const slot = slots?.find((one) => one.id === goal.slot);
  return slot ? poseInSlot(slot, goal.entry, vehicleOf(vehicle)) : start;
}

export function showGoal(scene: Scene, set: GoalSet, pose: Pose): void {
  shownGoals.set(set, pose);
  resolutions.delete(scene);
}

export interface Resolved {
  start: Pose;
  goal: Pose;
  vehicle: ResolvedVehicle;
  boundary: Point[];
  slots: { slot: Slot; outline: Point[] }[];
  parked: { slot: Slot; pose: Pose; vehicle: ResolvedVehicle }[];
}

const resolutions = new WeakMap<Scene, Resolved>();

/** The scene as plain geometry, remembered per scene object. */
export function resolve(scene: Scene): Resolved {
  const known = resolutions.get(scene);
  if (known) return known;
  const slots = scene.slots ?? [];
  const result: Resolved = {
    start: scene.start,
    goal: goalPose(scene),
    vehicle: vehicleOf(scene.vehicle),
    boundary: mapOutline(scene),
    slots: slots.map((slot) => ({ slot, outline: slotOutline(slot) })),
    parked: slots
      .filter((slot) => slot.occupied)
      .map((slot) => ({ slot, pose: parkedPose(slot), vehicle: vehicleOf("sedan") })),
  };
  resolutions.set(scene, result);
  return result;
}

export const moveStart = (scene: Scene, pose: Pose): Scene => ({ ...scene, start: tidy(pose) });
export const moveGoal = (scene: Scene, pose: Pose): Scene => ({ ...scene, goal: tidy(pose) });
export const movePose = (scene: Scene, kind: "start" | "goal", pose: Pose): Scene =>
  kind === "start" ? moveStart(scene, pose) : moveGoal(scene, pose);
export const setVehicle = (scene: Scene, vehicle: VehicleSpec): Scene => ({ ...scene, vehicle });

/** Millimetres and hundredths of a degree: finer digits are noise of the pointer. */
function tidy(pose: Pose): Pose {
  const step = Math.PI / 18000;
  return { x: round(pose.x), y: round(pose.y), heading: Math.round(wrapAngle(pose.heading) / step) * step };
}
const round = (value: number): number => Math.round(value * 1000) / 1000;

export function addObstacle(scene: Scene, obstacle: GivenObstacle): { scene: Scene; id: string } {
  const id = nextId(scene, obstacle.type);
  return { scene: { ...scene, obstacles: [...(scene.obstacles ?? []), { ...obstacle, id }] }, id };
}

export function updateObstacle(scene: Scene, id: string, next: GivenObstacle): Scene {
  return { ...scene, obstacles: (scene.obstacles ?? []).map((o) => (o.id === id ? { ...next, id } : o)) };
}

export function addSlots(scene: Scene, slots: readonly Omit<Slot, "id">[]): { scene: Scene; ids: string[] } {
  let next: Scene = { ...scene, slots: scene.slots ?? [] };
  const ids: string[] = [];
  for (const slot of slots) {
    const id = nextId(next, "slot");
    ids.push(id);
    next = { ...next, slots: [...(next.slots ?? []), { ...slot, id }] };
  }
  return { scene: next, ids };
}
export const addSlot = (scene: Scene, slot: Omit<Slot, "id">): Scene => addSlots(scene, [slot]).scene;

export const updateSlot = (scene: Scene, id: string, patch: Partial<Slot>): Scene => ({
  ...scene,
  slots: (scene.slots ?? []).map((s) => (s.id === id ? { ...s, ...patch, id } : s)),
});

/** The goal in a slot; `entry` stays as it was where it is not given. */
export function setGoalFromSlot(scene: Scene, slot: string, entry?: Entry): Scene {
  const before = "slot" in scene.goal ? scene.goal.entry : "reverse-in";
  const freed = findSlot(scene, slot)?.occupied ? updateSlot(scene, slot, { occupied: false }) : scene;
  return { ...freed, goal: { slot, entry: entry ?? before } };
}

export function withShape(scene: Scene, id: string, change: (shape: Shape) => Shape): Scene {
  const obstacle = findObstacle(scene, id);
  return obstacle && obstacle.type !== "cells" ? updateObstacle(scene, id, change(obstacle)) : scene;
}
