/** Parking slots: outlines, poses in them, rows of them. */
import type { Pose, Slot, Vehicle } from "parkade";
import { distance, fromPose, towards, wrapAngle, type Point } from "./geometry";
import { poseAround, vehicleOf } from "./vehicle";

export type SlotKind = Slot["kind"];
export type Entry = "reverse-in" | "head-in";
/** Parameters of a row of slots. */
export interface SlotShape {
  kind: SlotKind;
  width: number;
  length: number;
  angle?: number;
  lean?: "left" | "right";
}

const MOST_SLOTS = 60;

export const slotAngle = (slot: { kind: SlotKind; angle?: number }): number =>
  slot.kind === "angled" ? (slot.angle ?? Math.PI / 4) : Math.PI / 2;

/** Length of the open side along the aisle. */
export function openingOf(slot: SlotShape): number {
  return slot.kind === "parallel" ? slot.length : slot.width / Math.sin(slotAngle(slot));
}

/** Direction of the slot's sides: from the aisle into the slot. */
function sideDirection(slot: Slot): number {
  if (slot.kind !== "angled") return slot.heading;
  const off = Math.PI / 2 - slotAngle(slot);
  return slot.heading + (slot.lean === "right" ? -off : off);
}

/** Near left, near right, far right, far left, seen from the aisle. */
/** Near left, near right, far right, far left, as seen from the aisle. */
export type Quad = [Point, Point, Point, Point];

export function slotOutline(slot: Slot): Quad {
  const mouth: Pose = { x: slot.x, y: slot.y, heading: slot.heading };
  const half = openingOf(slot) / 2;
  const reach = slot.kind === "parallel" ? slot.width : slot.length;
  const side = sideDirection(slot);
  const dx = reach * Math.cos(side),
    dy = reach * Math.sin(side);
  const left = fromPose(mouth, 0, half),
    right = fromPose(mouth, 0, -half);
  return [left, right, [right[0] + dx, right[1] + dy], [left[0] + dx, left[1] + dy]];
}

/** Ends of lines closer than this are one, metres. */
const SAME_END = 0.05;

/** The painted lines: three sides of each slot, one that neighbours share once. */
export function slotLines(slots: readonly Slot[]): [Point, Point][] {
  const lines: [Point, Point][] = [],
    isSame = (p: Point, q: Point): boolean => distance(p, q) < SAME_END;
  for (const slot of slots) {
    const [nearLeft, nearRight, farRight, farLeft] = slotOutline(slot);
    for (const [p, q] of [
      [nearLeft, farLeft],
      [farLeft, farRight],
      [farRight, nearRight],
    ] as const) {
      if (!lines.some(([a, b]) => (isSame(p, a) && isSame(q, b)) || (isSame(p, b) && isSame(q, a)))) lines.push([p, q]);
    }
  }
  return lines;
}

export function slotCentre(slot: Slot): Point {
  const [a, b, c, d] = slotOutline(slot);
  return [(a[0] + b[0] + c[0] + d[0]) / 4, (a[1] + b[1] + c[1] + d[1]) / 4];
}

/** The pose centred in a slot: nose to the aisle for `reverse-in`, away from it for `head-in`. */
export function poseInSlot(slot: Slot, entry: Entry, vehicle: Vehicle): Pose {
  const inward = slot.kind === "parallel" ? slot.heading + Math.PI / 2 : sideDirection(slot);
  const flipped = slot.kind === "parallel" ? entry === "head-in" : entry === "reverse-in";
  return poseAround(slotCentre(slot), wrapAngle(flipped ? inward + Math.PI : inward), vehicle);
}

/** The car that stands in an occupied slot. */
export const parkedPose = (slot: Slot): Pose => poseInSlot(slot, "reverse-in", vehicleOf("sedan"));

/** As many slots as fit between `from` and `to` (at least one), to one side of that line. */
export function slotRow(shape: SlotShape, from: Point, to: Point, side: "left" | "right" = "left"): Omit<Slot, "id">[] {
  const along = towards(from, to),
    step = openingOf(shape);
  const count = Math.max(1, Math.floor(distance(from, to) / step + 1e-6));
  const heading = wrapAngle(side === "left" ? along + Math.PI / 2 : along - Math.PI / 2);
  const base = { kind: shape.kind, width: shape.width, length: shape.length, heading };
  const leaning = shape.kind === "angled" ? { angle: slotAngle(shape), lean: shape.lean ?? "left" } : {};
  return Array.from({ length: Math.min(count, MOST_SLOTS) }, (_, i) => ({
    ...base,
    ...leaning,
    x: from[0] + Math.cos(along) * step * (i + 0.5),
    y: from[1] + Math.sin(along) * step * (i + 0.5),
  }));
}
