/** How large a slot has to be for a car, and rows that are made so large. */
import type { Vehicle } from "parkade";
import type { Slot } from "./scenario";
import { findSlot, resolve, updateSlot, type Scene } from "./model";
import { boxOf, distance, intoPose, wrapAngle, type Box, type Point } from "./geometry";
import { openingOf, slotAngle, slotOutline, type SlotKind, type SlotShape } from "./slots";
import { nth } from "./nth";

/** Room that a slot leaves around the car, metres: to open its doors, and to steer into a parallel slot. */
const ROOM = { width: 0.6, length: 0.5, parallelLength: 1.7 };
/** Corners closer than this are one, metres. */
const SAME_CORNER = 0.02;

export interface SlotSize {
  width: number;
  length: number;
}
interface SlotForm {
  kind: SlotKind;
  angle?: number;
}

/** The smallest slot whose outline holds the centred car; the ends of an angled one run askew to it. */
export function leastSize(slot: SlotForm, car: Vehicle): SlotSize {
  const skew = slot.kind === "angled" ? car.width / Math.tan(slotAngle(slot)) : 0;
  return { width: car.width, length: car.rearToFront + car.rearToBack + skew };
}

/** The size that slots for this car have unless another is asked for, whole centimetres. */
export function fittingSize(slot: SlotForm, car: Vehicle): SlotSize {
  const { width, length } = leastSize(slot, car);
  return {
    width: rounded(width + ROOM.width),
    length: rounded(length + (slot.kind === "parallel" ? ROOM.parallelLength : ROOM.length)),
  };
}

/** What the slot tool draws: sizes that were not typed follow the car. */
export function sizedShape<T extends SlotForm & { width: number | null; length: number | null }>(
  options: T,
  car: Vehicle,
): T & SlotSize {
  const size = fittingSize(options, car);
  return { ...options, width: options.width ?? size.width, length: options.length ?? size.length };
}

/** How many metres a slot is too short and too narrow for the car, rounded up to centimetres; null where it fits. */
export function misfitOf(slot: SlotShape, car: Vehicle): { short: number; narrow: number } | null {
  const least = leastSize(slot, car);
  const short = missing(least.length - slot.length),
    narrow = missing(least.width - slot.width);
  return short > 0 || narrow > 0 ? { short, narrow } : null;
}

/** The slots that stand side by side with this one, it included, from left to right as seen from the aisle. */
export function rowOf(scene: Scene, id: string): Slot[] {
  const all = scene.slots ?? [],
    row = all.filter((slot) => slot.id === id);
  for (let i = 0; i < row.length; i++)
    row.push(...all.filter((slot) => !row.includes(slot) && areNeighbours(nth(row, i), slot)));
  const [first] = row;
  const along = (slot: Slot): number => intoPose(first!, [slot.x, slot.y])[1];
  return row.sort((a, b) => along(b) - along(a));
}

/** The scene with the whole rows of these slots on the other side of their mouths, so that the aisle changes sides. */
export function turnRows(scene: Scene, ids: readonly string[]): Scene {
  const row = new Set(ids.flatMap((id) => rowOf(scene, id).map((slot) => slot.id)));
  return [...row].reduce(
    (next, id) => updateSlot(next, id, { heading: wrapAngle(findSlot(scene, id)!.heading + Math.PI) }),
    scene,
  );
}

/**
 * The scene with the rows of these slots made large enough for the car; they stay on the ground where it has the room.
 */
export function fitRows(scene: Scene, ids: readonly string[]): Scene {
  const done = new Set<string>();
  return ids.reduce((next, id) => {
    if (done.has(id)) return next;
    const row = rowOf(next, id);
    for (const slot of row) done.add(slot.id);
    return fitRow(next, row);
  }, scene);
}

/** The row's middle and the aisle side stay. */
function fitRow(scene: Scene, row: readonly Slot[]): Scene {
  const car = resolve(scene).vehicle,
    [first] = row,
    last = row.at(-1);
  if (!first || !last) return scene;
  const middle: Point = [(first.x + last.x) / 2, (first.y + last.y) / 2];
  const sized = row.map((slot) => ({ ...slot, ...enlarged(slot, car) }));
  const total = sized.reduce((sum, slot) => sum + openingOf(slot), 0);
  let left = total / 2;
  const placed = sized.map((slot) => {
    const offset = left - openingOf(slot) / 2;
    left -= openingOf(slot);
    return {
      ...slot,
      x: middle[0] - Math.sin(first.heading) * offset,
      y: middle[1] + Math.cos(first.heading) * offset,
    };
  });
  const [dx, dy] = backInside(boxOf(placed.flatMap(slotOutline)), boxOf(resolve(scene).boundary));
  return placed.reduce(
    (next, { id, width, length, x, y }) => updateSlot(next, id!, { width, length, x: x + dx, y: y + dy }),
    scene,
  );
}

function enlarged(slot: Slot, car: Vehicle): SlotSize {
  const misfit = misfitOf(slot, car),
    fitting = fittingSize(slot, car);
  return { width: misfit?.narrow ? fitting.width : slot.width, length: misfit?.short ? fitting.length : slot.length };
}

function areNeighbours(a: Slot, b: Slot): boolean {
  if (a.kind !== b.kind || Math.abs(wrapAngle(a.heading - b.heading)) > 1e-3) return false;
  const [aLeft, aRight] = slotOutline(a),
    [bLeft, bRight] = slotOutline(b);
  return distance(aLeft!, bRight!) < SAME_CORNER || distance(aRight!, bLeft!) < SAME_CORNER;
}

/** The way that brings a box back into another one; it stays put along an axis where it is too large. */
function backInside(box: Box, into: Box): Point {
  const shift = (low: number, high: number, from: number, to: number): number =>
    high - low > to - from ? 0 : Math.max(0, from - low) - Math.max(0, high - to);
  return [shift(box.minX, box.maxX, into.minX, into.maxX), shift(box.minY, box.maxY, into.minY, into.maxY)];
}

const rounded = (metres: number): number => Math.round(metres * 100) / 100;
const missing = (metres: number): number => Math.max(0, Math.ceil(metres * 100 - 1e-6) / 100);
