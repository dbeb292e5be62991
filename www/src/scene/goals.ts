/** The goal of a scene: one place, or any of several. */
import type { Goal, GoalSet, Pose, TakenGoal } from "parkade";
import type { Slot } from "./scenario";
import {
  findSlot,
  goalPose,
  isGoalPose,
  isOneGoal,
  moveGoal,
  resolve,
  showGoal,
  vehicleOf,
  type Entry,
  type Scene,
} from "./model";
import { fromPose, insidePolygon, type Point } from "./geometry";
import { slotOutline } from "./slots";

/** Metres between a slot and the aisle that a car shall leave it to. */
const CLEAR = 0.2;

export type AnyEntry = Entry | "either";
export type GoalKind = "one" | "slots" | "poses" | "region";

export const goalKind = (goal: Goal | GoalSet): GoalKind =>
  isOneGoal(goal) ? "one" : Array.isArray(goal) ? "poses" : "slots" in goal ? "slots" : "region";

/** A set asked for in place of another goal; until it is planned the car stays where it is shown. */
export function withSet(scene: Scene, goal: GoalSet): Scene {
  const next = { ...scene, goal };
  showGoal(next, goal, goalPose(scene));
  return next;
}

export const freeSlots = ({ slots = [] }: Scene): Slot[] => slots.filter((slot) => !slot.occupied);

export const anyFreeSlot = (scene: Scene, entry: AnyEntry = "either"): Scene =>
  withSet(scene, { slots: "free", entry });

/** Any of these slots. */
export const anyOfSlots = (scene: Scene, slots: string[], entry: AnyEntry = "either"): Scene =>
  withSet(scene, { slots, entry });

/** The slots that a goal names, whether they are free or not. */
export function slotsOfGoal(scene: Scene): Slot[] {
  const { goal, slots = [] } = scene;
  if ("slot" in goal) return slots.filter((slot) => slot.id === goal.slot);
  if (!("slots" in goal)) return [];
  return goal.slots === "free" ? freeSlots(scene) : slots.filter(({ id }) => goal.slots.includes(id!));
}

/** Anywhere within a polygon; with `heading` only so. */
export const anywhereIn = (scene: Scene, region: Point[], heading?: number): Scene =>
  withSet(scene, { region, ...(heading === undefined ? {} : { heading }) });

/** Another pose that is as good as those that are asked for. */
export const orThere = (scene: Scene, pose: Pose): Scene =>
  withSet(scene, [...(Array.isArray(scene.goal) ? scene.goal : [goalPose(scene)]), pose]);

/** The goal of a set that an answer leads to, or that is shown, alone. */
export function onlyOne(scene: Scene, taken?: TakenGoal): Scene {
  const { slot, entry, pose = goalPose(scene) } = taken ?? {};
  return slot !== undefined && entry && findSlot(scene, slot)
    ? { ...scene, goal: { slot, entry } }
    : moveGoal(scene, pose);
}

/** A rectangle about the goal car with room to stand in more ways than one. */
export function regionAroundGoal(scene: Scene): Point[] {
  const { goal, vehicle } = resolve(scene),
    length = vehicle.rearToFront + vehicle.rearToBack;
  return boxAt(goal, vehicle.rearToFront - length * 1.5, vehicle.rearToFront + length * 0.5, length * 0.75);
}

/** The slot in which the car stands at its start. */
export function slotOfStart(scene: Scene): Slot | undefined {
  const { start, vehicle } = resolve(scene),
    middle = fromPose(start, (vehicle.rearToFront - vehicle.rearToBack) / 2, 0);
  return scene.slots?.find((slot) => insidePolygon(middle, slotOutline(slot)));
}

/** Out of the slot in which the car stands: anywhere in the aisle before it. */
export function leaveSlot(scene: Scene): Scene {
  const slot = slotOfStart(scene);
  if (!slot) return scene;
  const { rearToFront, rearToBack, width } = resolve(scene).vehicle,
    length = rearToFront + rearToBack;
  const reach = slot.kind === "parallel" ? 2 * width : length + width / 2;
  return anywhereIn(scene, boxAt(slot, -CLEAR - reach, -CLEAR, 2 * length));
}

/** A rectangle that reaches from `back` to `front` along a heading, and `half` to either side, whole centimetres. */
function boxAt(at: Pose, back: number, front: number, half: number): Point[] {
  const whole = (value: number): number => Math.round(value * 100) / 100;
  const corner = (along: number, across: number): Point => {
    const [x, y] = fromPose(at, along, across);
    return [whole(x), whole(y)];
  };
  return [corner(back, -half), corner(front, -half), corner(front, half), corner(back, half)];
}

export function withEntry(scene: Scene, entry: AnyEntry): Scene {
  const { goal } = scene;
  if ("slots" in goal) return withSet(scene, { ...goal, entry });
  return "slot" in goal && entry !== "either" ? { ...scene, goal: { ...goal, entry } } : scene;
}

/** Turns the goal round: the other entry in slots, about the body's middle at a pose; in a region nothing is turned. */
export function flipGoal(scene: Scene): Scene {
  const { goal } = scene;
  if ("entry" in goal) return withEntry(scene, goal.entry === "head-in" ? "reverse-in" : "head-in");
  if (!isGoalPose(goal)) return scene;
  const { rearToFront, rearToBack } = vehicleOf(scene.vehicle);
  const shift = rearToFront - rearToBack;
  return moveGoal(scene, {
    x: goal.x + Math.cos(goal.heading) * shift,
    y: goal.y + Math.sin(goal.heading) * shift,
    heading: goal.heading + Math.PI,
  });
}
