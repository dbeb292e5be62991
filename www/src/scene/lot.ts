/**
 * A parking lot from a form: rows of bays along aisles, columns and walls, a car at the entrance and a free bay for it.
 */
import type { Pose, Vehicle, VehicleSpec } from "parkade";
import { fromPose, radians, type Point } from "./geometry";
import type { GivenObstacle, GivenSlot, Obstacle, Scenario, Slot } from "./scenario";
import { fittingSize, leastSize } from "./slot-fit";
import { openingOf, poseInSlot, slotCentre, slotOutline, type Entry, type SlotKind } from "./slots";
import { vehicleOf } from "./vehicle";
import { nth } from "./nth";

export type Entrance = "left" | "right" | "bottom" | "top";

/** Metres and degrees; null follows what else is asked. */
export interface LotForm {
  width: number | null;
  depth: number | null;
  kind: SlotKind;
  /** Between aisle and bay, of angled bays. */
  angle: number;
  /** Bays in a row. */
  count: number;
  bayWidth: number | null;
  bayLength: number | null;
  aisles: number;
  sides: "one" | "both";
  /** Its width at least: on deeper ground aisles are wider. */
  aisle: number;
  /** Occupied bays, spread over the rows. */
  parked: number;
  /** Bays from column to column; 0 is none. */
  every: number;
  column: number;
  /** Thickness of walls behind the rows; 0 is none. */
  wall: number;
  entrance: Entrance;
  entry: Entry;
  car: "sedan" | "paper" | "own";
  carLength: number;
  carWidth: number;
  wheelbase: number;
  radius: number;
}

export type NumberField = { [K in keyof LotForm]: LotForm[K] extends number | null ? K : never }[keyof LotForm];

/** Least, most and decimal digits of every number, and the most that is usual. */
export const LIMITS: Record<NumberField, readonly [least: number, most: number, digits: number, usual: number]> = {
  width: [6, 200, 1, 60],
  depth: [6, 200, 1, 60],
  angle: [30, 75, 0, 75],
  count: [1, 40, 0, 20],
  bayWidth: [1.5, 8, 1, 4],
  bayLength: [2.5, 24, 1, 8],
  aisles: [1, 6, 0, 4],
  aisle: [2, 20, 1, 10],
  parked: [0, 480, 0, 20],
  every: [0, 20, 0, 6],
  column: [0.2, 1.5, 1, 1],
  wall: [0, 1, 1, 0.5],
  carLength: [2, 14, 1, 8],
  carWidth: [1, 3.5, 1, 2.6],
  wheelbase: [1, 10, 1, 5],
  radius: [1.5, 20, 1, 10],
};

export const firstForm: LotForm = {
  width: null,
  depth: null,
  kind: "perpendicular",
  angle: 60,
  count: 8,
  bayWidth: null,
  bayLength: null,
  aisles: 1,
  sides: "one",
  aisle: 7,
  parked: 2,
  every: 0,
  column: 0.4,
  wall: 0,
  entrance: "left",
  entry: "reverse-in",
  car: "sedan",
  carLength: 4.7,
  carWidth: 1.9,
  wheelbase: 2.8,
  radius: 5.5,
};

/** Why a form gives no lot: the number to change and the least it has to be, where there is one. */
export interface LotFault {
  field: keyof LotForm;
  rule: "limits" | "least" | "shorter" | "free";
  least: number;
}

export type Lot = { scene: Scenario; fault: null } | { scene: null; fault: LotFault };

/**
 * Between the car at the entrance and the border behind it; beside it in an aisle; from the last bay to the border.
 * Metres.
 */
const BEHIND = 0.5,
  BESIDE = 0.4,
  BEYOND = 5;

/** The numbers behind a form whose fields may follow others. */
export interface Sizes {
  car: Vehicle;
  vehicle: VehicleSpec;
  bay: { kind: SlotKind; width: number; length: number; angle: number };
  width: number;
  depth: number;
  rows: number;
  /** Of one row, its columns and skewed ends included. */
  rowLength: number;
  rowDepth: number;
  /** Width of the lane across the aisles' ends; 0 where cars drive straight into the only aisle. */
  cross: number;
  least: { width: number; depth: number };
}

export function sizesOf(form: LotForm): Sizes {
  const vehicle = specOf(form),
    car = vehicleOf(vehicle),
    angle = radians(form.angle);
  const fitting = fittingSize({ kind: form.kind, angle }, largest(form, car));
  const bay = {
    kind: form.kind,
    angle,
    width: form.bayWidth ?? fitting.width,
    length: form.bayLength ?? fitting.length,
  };
  const rows = form.aisles * (form.sides === "both" ? 2 : 1),
    walls = form.sides === "both" ? form.aisles + 1 : form.aisles;
  const rowLength = form.count * openingOf(bay) + gapsIn(form) * gapOf(form, bay) + skewOf(bay);
  const rowDepth =
    bay.kind === "parallel" ? bay.width : bay.kind === "angled" ? bay.length * Math.sin(angle) : bay.length;
  const cross = form.aisles > 1 || isAcross(form.entrance) ? form.aisle : 0;
  const carLength = car.rearToFront + car.rearToBack,
    entering = carLength + 2 * BEHIND;
  const content = rows * rowDepth + walls * form.wall + form.aisles * form.aisle;
  const least = {
    width: Math.max(cross + rowLength, isAcross(form.entrance) ? 0 : entering),
    depth: Math.max(content, isAcross(form.entrance) ? entering : 0),
  };
  const comfortable = Math.max(least.width + (cross > 0 ? BEYOND : 2 * BEYOND), entering);
  return {
    car,
    vehicle,
    bay,
    rows,
    rowLength,
    rowDepth,
    cross,
    least,
    width: form.width ?? upTo(comfortable, 0.5),
    depth: form.depth ?? upTo(least.depth, 0.1),
  };
}

export function buildLot(form: LotForm): Lot {
  const sizes = sizesOf(form),
    fault = outsideLimits(form) ?? faultOf(form, sizes);
  if (fault) return { scene: null, fault };
  const { slots, obstacles } = rowsOf(form, sizes),
    start = startOf(form, sizes);
  const goal = slots.find((slot) => !slot.occupied)!;
  return {
    fault: null,
    scene: {
      version: 1,
      map: frameOf(sizes),
      obstacles: obstacles.map(named),
      slots,
      vehicle: sizes.vehicle,
      start,
      goal: { slot: goal.id, entry: entryOf(form, goal, sizes) },
    },
  };
}

/** `many` bays spread evenly over `of`, as indices. */
const spread = (many: number, of: number): number[] =>
  Array.from({ length: Math.min(many, of) }, (_, i) => Math.floor(((i + 0.5) * of) / Math.min(many, of)));

const isAcross = (entrance: Entrance): boolean => entrance === "bottom" || entrance === "top";
/** The way cars drive when they come in. */
const wayOf = ({ entrance }: LotForm): 1 | -1 => (entrance === "right" ? -1 : 1);
const upTo = (value: number, step: number): number => Math.round(Math.ceil(value / step - 1e-6) * step * 1000) / 1000;

function specOf({ car, carLength, carWidth, wheelbase, radius }: LotForm): VehicleSpec {
  if (car !== "own") return car;
  const rearToBack = Math.max(0.1, (carLength - wheelbase) / 2);
  return {
    wheelbase,
    width: carWidth,
    rearToBack,
    rearToFront: carLength - rearToBack,
    maxSteer: Math.atan(wheelbase / radius),
  };
}

/** Parked cars are sedans. */
function largest({ parked }: LotForm, car: Vehicle): Vehicle {
  const other = vehicleOf("sedan");
  if (parked === 0) return car;
  const ahead = Math.max(car.rearToFront + car.rearToBack, other.rearToFront + other.rearToBack);
  return { ...car, width: Math.max(car.width, other.width), rearToFront: ahead - car.rearToBack };
}

function outsideLimits(form: LotForm): LotFault | null {
  for (const [name, [least, most, digits]] of Object.entries(LIMITS) as [NumberField, (typeof LIMITS)[NumberField]][]) {
    const value = form[name];
    if (value !== null && !(value >= least && value <= most && (digits > 0 || Number.isInteger(value))))
      return { field: name, rule: "limits", least };
  }
  return null;
}

function faultOf(form: LotForm, { car, bay, width, depth, rows, least }: Sizes): LotFault | null {
  const bare = leastSize(bay, largest(form, car)),
    total = rows * form.count;
  const needs = (field: keyof LotForm, value: number, required: number): LotFault | null =>
    value < required - 1e-6 ? { field, rule: "least", least: upTo(required, 0.1) } : null;
  if (form.car === "own" && form.wheelbase > form.carLength - 0.2)
    return { field: "wheelbase", rule: "shorter", least: form.carLength };
  if (form.parked >= total) return { field: "parked", rule: "free", least: total };
  return (
    needs("bayWidth", bay.width, bare.width) ??
    needs("bayLength", bay.length, bare.length) ??
    needs("aisle", form.aisle, car.width + 2 * BESIDE) ??
    needs("width", width, least.width) ??
    needs("depth", depth, least.depth)
  );
}

/** Cells cover the ground; where they are not even with it, an outline says where it ends. */
function frameOf({ width, depth }: Sizes): Scenario["map"] {
  const resolution = Math.max(width, depth) > 80 ? 0.5 : 0.25;
  const across = Math.ceil(width / resolution - 1e-6),
    up = Math.ceil(depth / resolution - 1e-6);
  const isEven = Math.abs(across * resolution - width) < 1e-6 && Math.abs(up * resolution - depth) < 1e-6;
  const origin: Point = [0, 0],
    frame = { origin, width: across, height: up, resolution };
  return isEven
    ? frame
    : {
        ...frame,
        boundary: [
          [0, 0],
          [width, 0],
          [width, depth],
          [0, depth],
        ],
      };
}

const gapsIn = ({ every, count }: LotForm): number => (every > 0 ? Math.ceil(count / every) - 1 : 0);
const gapOf = ({ column }: LotForm, bay: Sizes["bay"]): number =>
  bay.kind === "angled" ? column / Math.sin(bay.angle) : column;
const skewOf = ({ kind, length, angle }: Sizes["bay"]): number => (kind === "angled" ? length * Math.cos(angle) : 0);

/** One row: the height of its open side, and whether its bays lie below it or above. */
interface Line {
  y: number;
  heading: number;
}

/**
 * Rows from the bottom: a wall, bays, their aisle, with bays on both sides more bays; whatever depth is left widens the
 * aisles.
 */
function rowsOf(form: LotForm, sizes: Sizes): { slots: Slot[]; obstacles: GivenObstacle[] } {
  const aisle = aisleOf(form, sizes),
    lines: Line[] = [],
    walls: number[] = [];
  let y = 0;
  for (let i = 0; i < form.aisles; i++) {
    walls.push(y + form.wall / 2);
    y += form.wall + sizes.rowDepth;
    lines.push({ y, heading: -Math.PI / 2 });
    y += aisle;
    if (form.sides === "one") continue;
    lines.push({ y, heading: Math.PI / 2 });
    y += sizes.rowDepth;
  }
  if (form.sides === "both") walls.push(y + form.wall / 2);
  const rows = lines.map((line) => rowOn(form, sizes, line)),
    taken = new Set(spread(form.parked, sizes.rows * form.count));
  const slots = rows
    .flatMap((row) => row.slots)
    .map((slot, i) => ({ ...slot, id: `slot-${i + 1}`, ...(taken.has(i) ? { occupied: true } : {}) }));
  const columns = rows.flatMap((row) => row.columns);
  return { slots, obstacles: [...(form.wall > 0 ? walls.map((at) => wallAt(form, sizes, at)) : []), ...columns] };
}

const aisleOf = (form: LotForm, { depth, rows, rowDepth }: Sizes): number =>
  (depth - rows * rowDepth - form.wall * (form.sides === "both" ? form.aisles + 1 : form.aisles)) / form.aisles;

/** Where rows begin: in the middle of what the lane across leaves. */
function rowLeft(form: LotForm, { width, cross, rowLength }: Sizes): number {
  return (wayOf(form) > 0 ? cross : 0) + (width - cross - rowLength) / 2;
}

function rowOn(
  form: LotForm,
  sizes: Sizes,
  { y, heading }: Line,
): { slots: Omit<Slot, "id">[]; columns: GivenObstacle[] } {
  const { bay } = sizes,
    way = wayOf(form),
    step = openingOf(bay),
    gap = gapOf(form, bay);
  // Bays lean so that cars on their way in need the smaller turn.
  const leans = form.entry === "head-in" ? way : -way;
  const lean = leans > 0 === heading < 0 ? ("left" as const) : ("right" as const);
  const leaning = bay.kind === "angled" ? { angle: bay.angle, lean } : {};
  const from = rowLeft(form, sizes) + (leans < 0 ? skewOf(bay) : 0),
    mouths = sizes.rowLength - skewOf(bay);
  const at = (along: number): number => (way > 0 ? from + along : from + mouths - along);
  const slotAt = (along: number, width: number, length: number): GivenSlot => ({
    kind: bay.kind,
    x: at(along),
    y,
    heading,
    width,
    length,
    ...leaning,
  });
  const slots: GivenSlot[] = [],
    columns: GivenObstacle[] = [];
  let along = 0;
  for (let i = 0; i < form.count; i++) {
    if (form.every > 0 && i > 0 && i % form.every === 0) {
      const [x, middle] = slotCentre(slotAt(along + gap / 2, bay.width, bay.length)),
        side = slotOutline(slotAt(along, bay.width, bay.length));
      columns.push({
        type: "rectangle",
        center: [x, middle],
        size: [form.column, form.column],
        heading: Math.atan2(nth(side, 3)[1] - nth(side, 0)[1], nth(side, 3)[0] - nth(side, 0)[0]),
      });
      along += gap;
    }
    slots.push(slotAt(along + step / 2, bay.width, bay.length));
    along += step;
  }
  return { slots, columns };
}

/** Ends of thick walls reach half their thickness further. */
function wallAt(form: LotForm, sizes: Sizes, y: number): GivenObstacle {
  const left = rowLeft(form, sizes),
    cap = form.wall / 2;
  return {
    type: "wall",
    points: [
      [left + cap, y],
      [left + sizes.rowLength - cap, y],
    ],
    thickness: form.wall,
  };
}

const named = (obstacle: GivenObstacle, i: number): Obstacle => ({
  ...obstacle,
  id: obstacle.type === "wall" ? `wall-${i + 1}` : `column-${i + 1}`,
});

/** The car just inside the border, on its way in. */
function startOf(form: LotForm, sizes: Sizes): Pose {
  const { width, depth, car, rowDepth } = sizes,
    behind = BEHIND + car.rearToBack;
  const middle = form.wall + rowDepth + aisleOf(form, sizes) / 2;
  switch (form.entrance) {
    case "left":
      return { x: behind, y: middle, heading: 0 };
    case "right":
      return { x: width - behind, y: middle, heading: Math.PI };
    case "bottom":
      return { x: sizes.cross / 2, y: behind, heading: Math.PI / 2 };
    case "top":
      return { x: sizes.cross / 2, y: depth - behind, heading: -Math.PI / 2 };
  }
}

/** Cars stand in parallel bays the way they came. */
function entryOf(form: LotForm, slot: Slot, { car }: Sizes): Entry {
  if (form.kind !== "parallel") return form.entry;
  const [ahead] = fromPose({ ...poseInSlot(slot, "reverse-in", car), x: 0, y: 0 }, wayOf(form), 0);
  return ahead > 0 ? "reverse-in" : "head-in";
}
