import { init, Planner, sceneGeometry, type Obstacle } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";
import { faultText } from "../../www/src/panels/new-lot-messages";
import { mapOutline, resolve, type Scene } from "../../www/src/scene/model";
import {
  buildLot,
  firstForm,
  LIMITS,
  sizesOf,
  type LotFault,
  type LotForm,
  type NumberField,
} from "../../www/src/scene/lot";
import { boxOf, fromPose, insidePolygon, type Point } from "../../www/src/scene/geometry";
import { rectangleCorners } from "../../www/src/scene/shapes";
import { misfitOf } from "../../www/src/scene/slot-fit";
import { footprint, vehicleOf } from "../../www/src/scene/vehicle";
import { loadChinese } from "./chinese";

beforeAll(() => init());

/** A generator of its own, so that a seed names the same forms for ever. */
function randomOf(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/**
 * Any numbers within the bounds, their ends often; half of the sizes follow the others, so that enough forms give a
 * lot.
 */
function randomForm(random: () => number): LotForm {
  const pick = <T>(...all: T[]): T => all[Math.floor(random() * all.length)]!;
  const number = (field: NumberField): number => {
    const [least, most, digits] = LIMITS[field],
      at = random() < 0.15 ? pick(0, 1) : random();
    return Number((least + (most - least) * at).toFixed(digits));
  };
  const follows = (field: NumberField): number | null => (random() < 0.6 ? null : number(field));
  const form: LotForm = {
    width: follows("width"),
    depth: follows("depth"),
    kind: pick("perpendicular", "parallel", "angled"),
    angle: number("angle"),
    count: number("count"),
    bayWidth: follows("bayWidth"),
    bayLength: follows("bayLength"),
    aisles: number("aisles"),
    sides: pick("one", "both"),
    aisle: number("aisle"),
    parked: 0,
    every: pick(0, number("every")),
    column: number("column"),
    wall: pick(0, number("wall")),
    entrance: pick("left", "right", "bottom", "top"),
    entry: pick("head-in", "reverse-in"),
    car: pick("sedan", "paper", "own"),
    carLength: number("carLength"),
    carWidth: number("carWidth"),
    wheelbase: number("wheelbase"),
    radius: number("radius"),
  };
  const total = sizesOf(form).rows * form.count;
  return { ...form, parked: pick(number("parked"), Math.floor(random() * (total + 1))) };
}

/** True if two convex outlines have more than a hair of ground in common. */
function overlap(a: readonly Point[], b: readonly Point[]): boolean {
  return [a, b].every((outline) =>
    outline.every((p, i) => {
      const q = outline[(i + 1) % outline.length]!,
        length = Math.hypot(q[0] - p[0], q[1] - p[1]),
        nx = (q[1] - p[1]) / length,
        ny = (p[0] - q[0]) / length;
      const span = (points: readonly Point[]): [number, number] => [
        Math.min(...points.map(([x, y]) => x * nx + y * ny)),
        Math.max(...points.map(([x, y]) => x * nx + y * ny)),
      ];
      const [aLow, aHigh] = span(a),
        [bLow, bHigh] = span(b);
      return Math.min(aHigh, bHigh) - Math.max(aLow, bLow) > 1e-6;
    }),
  );
}

/** The same for a square along the axes, by its centre: the outline is projected once, not for every square. */
function overlapsSquare(outline: readonly Point[], half: number): (x: number, y: number) => boolean {
  const edges = outline.map((p, i): Point => {
    const q = outline[(i + 1) % outline.length]!,
      length = Math.hypot(q[0] - p[0], q[1] - p[1]);
    return [(q[1] - p[1]) / length, (p[0] - q[0]) / length];
  });
  const normals: Point[] = [...edges, [1, 0], [0, 1]],
    ranges = normals.map(([nx, ny]) => {
      const along = outline.map(([x, y]) => x * nx + y * ny),
        reach = half * (Math.abs(nx) + Math.abs(ny)) - 1e-6;
      return { nx, ny, low: Math.min(...along) - reach, high: Math.max(...along) + reach };
    });
  return (x, y) => ranges.every(({ nx, ny, low, high }) => x * nx + y * ny > low && x * nx + y * ny < high);
}

function outlineOf(obstacle: Obstacle): Point[] {
  if (obstacle.type === "rectangle") return rectangleCorners(obstacle);
  if (obstacle.type !== "wall") throw new Error(`a lot has no ${obstacle.type}`);
  const [[x0, y], [x1]] = obstacle.points as [Point, Point],
    half = obstacle.thickness! / 2;
  return [
    [x0 - half, y - half],
    [x1 + half, y - half],
    [x1 + half, y + half],
    [x0 - half, y + half],
  ];
}

/** Pairs with ground in common; only outlines whose extents meet are looked at closely. */
function overlapping(outlines: readonly Point[][]): [number, number][] {
  const boxes = outlines.map((points) => boxOf(points)),
    order = boxes.map((_, i) => i).sort((a, b) => boxes[a]!.minX - boxes[b]!.minX);
  return order.flatMap((i, at) => {
    const found: [number, number][] = [];
    for (let next = at + 1; next < order.length && boxes[order[next]!]!.minX < boxes[i]!.maxX; next++) {
      const j = order[next]!;
      if (boxes[j]!.minY < boxes[i]!.maxY && boxes[i]!.minY < boxes[j]!.maxY && overlap(outlines[i]!, outlines[j]!))
        found.push([i, j]);
    }
    return found;
  });
}

const STEP = 0.3;

/** True if a disc as wide as the car can be brought from the start to the open side of every bay. */
function unreachable(scene: Scene): string[] {
  const { start, slots, vehicle, parked } = resolve(scene),
    [width, depth] = mapOutline(scene)[2]!,
    half = vehicle.width / 2;
  const columns = Math.ceil(width / STEP),
    rows = Math.ceil(depth / STEP),
    closed = new Uint8Array(columns * rows),
    reached = new Uint8Array(columns * rows);
  const middle = (i: number): number => (i + 0.5) * STEP,
    near = (low: number, high: number, most: number): [number, number] => [
      Math.max(0, Math.floor((low - half) / STEP)),
      Math.min(most - 1, Math.ceil((high + half) / STEP)),
    ];
  for (const outline of [
    ...scene.obstacles!.map(outlineOf),
    ...slots.map((one) => one.outline),
    ...parked.map((car) => footprint(car.pose, car.vehicle)),
  ]) {
    const box = boxOf(outline),
      [left, right] = near(box.minX, box.maxX, columns),
      [low, high] = near(box.minY, box.maxY, rows),
      overlaps = overlapsSquare(outline, half);
    for (let j = low; j <= high; j++)
      for (let i = left; i <= right; i++)
        if (!closed[j * columns + i] && overlaps(middle(i), middle(j))) closed[j * columns + i] = 1;
  }
  const from = fromPose(start, (vehicle.rearToFront - vehicle.rearToBack) / 2, 0),
    open: [number, number][] = [[Math.floor(from[0] / STEP), Math.floor(from[1] / STEP)]];
  while (open.length > 0) {
    const [i, j] = open.pop()!,
      [x, y] = [middle(i), middle(j)];
    if (x < half || y < half || x > width - half || y > depth - half || closed[j * columns + i]) continue;
    closed[j * columns + i] = reached[j * columns + i] = 1;
    open.push([i + 1, j], [i - 1, j], [i, j + 1], [i, j - 1]);
  }
  // A hand's breadth in front of the open side, give or take a step of the lattice.
  return slots
    .filter(({ slot }) => {
      const x = slot.x - Math.cos(slot.heading) * half,
        y = slot.y - Math.sin(slot.heading) * half,
        reach = half / 2 + 2 * STEP,
        steps = Math.ceil(reach / STEP);
      for (let j = Math.floor(y / STEP) - steps; j <= y / STEP + steps; j++) {
        for (let i = Math.floor(x / STEP) - steps; i <= x / STEP + steps; i++) {
          if (
            i >= 0 &&
            j >= 0 &&
            i < columns &&
            j < rows &&
            reached[j * columns + i] &&
            Math.hypot(middle(i) - x, middle(j) - y) < reach
          )
            return false;
        }
      }
      return true;
    })
    .map(({ slot }) => slot.id!);
}

function checkScene(scene: Scene): void {
  const { start, goal, vehicle, slots, parked, boundary } = resolve(scene),
    { maxX: width, maxY: depth } = boxOf(boundary);
  expect(() => sceneGeometry(scene)).not.toThrow();
  const all = [...scene.obstacles!.map(outlineOf), ...slots.map((one) => one.outline), footprint(start, vehicle)];
  expect(all.flat().filter(([x, y]) => !(x > -1e-6 && y > -1e-6 && x < width + 1e-6 && y < depth + 1e-6))).toEqual([]);
  expect(overlapping(all)).toEqual([]);
  expect(slots.map(({ slot }) => misfitOf(slot, slot.occupied ? vehicleOf("sedan") : vehicle)).filter(Boolean)).toEqual(
    [],
  );
  const car = footprint(goal, vehicle);
  expect(parked.filter((one) => overlap(footprint(one.pose, one.vehicle), car))).toEqual([]);
  expect(insidePolygon([goal.x, goal.y], boundary)).toBe(true);
}

describe("a lot from a form", () => {
  it("is the newcomer's: eight bays, two taken, and the car at the entrance", () => {
    const { scene } = buildLot(firstForm);
    expect(scene!.slots!.map((slot) => slot.occupied ?? false)).toEqual([
      false,
      false,
      true,
      false,
      false,
      false,
      true,
      false,
    ]);
    expect(scene!.goal).toEqual({ slot: "slot-1", entry: "reverse-in" });
    checkScene(scene!);
  });

  it("is valid for any numbers within the bounds, or one sentence says which number to change", () => {
    const random = randomOf(20),
      rules = new Map<string, number>();
    let lots = 0,
      most = 0;
    for (let i = 0; i < 6000; i++) {
      const form = randomForm(random),
        { scene, fault } = buildLot(form);
      try {
        if (fault) {
          rules.set(fault.rule, (rules.get(fault.rule) ?? 0) + 1);
          checkFault(form, fault);
        } else {
          lots++;
          most = Math.max(most, scene.slots!.length);
          checkScene(scene);
        }
      } catch (error) {
        throw new Error(`form ${i}: ${JSON.stringify(form)}`, { cause: error });
      }
    }
    expect(lots).toBeGreaterThan(600);
    expect(most).toBeGreaterThan(400);
    for (const rule of ["least", "free", "shorter"]) expect(rules.get(rule), rule).toBeGreaterThan(100);
  }, 60_000);

  it("lets the car come to every bay", () => {
    const random = randomOf(21);
    let looked = 0;
    while (looked < 25) {
      const form = randomForm(random),
        { scene } = buildLot(form);
      if (!scene) continue;
      looked++;
      expect(unreachable(scene), JSON.stringify(form)).toEqual([]);
    }
  }, 60_000);

  it("of every kind at its usual sizes is parked in", () => {
    const all = (["perpendicular", "angled", "parallel"] as const).flatMap((kind) =>
      (["left", "right", "bottom", "top"] as const).flatMap((entrance) =>
        (["head-in", "reverse-in"] as const).flatMap((entry) =>
          (["one", "both"] as const).map((sides): LotForm => ({ ...firstForm, kind, entrance, entry, sides })),
        ),
      ),
    );
    for (const form of all) {
      const planner = new Planner("hybrid", buildLot(form).scene!);
      const { outcome, check } = planner.plan({ trace: false });
      planner.free();
      expect({ outcome, drivable: check.drivable }, JSON.stringify(form)).toEqual({ outcome: "found", drivable: true });
    }
  }, 60_000);

  it("says in Chinese, too, which number to change", async () => {
    await loadChinese();
    const all = (Object.keys(LIMITS) as NumberField[]).flatMap((field) =>
      (["limits", "least", "shorter", "free"] as const).map((rule) => faultText("zh", { field, rule, least: 7 })),
    );
    expect(all.filter((text) => !/^[^{}A-Za-z]*( m)?[^{}A-Za-z]*。([^{}A-Za-z]+。)?$/.test(text))).toEqual([]);
  });

  it("grows with what stands in it unless its size was given", () => {
    for (const count of [1, 8, 40]) expect(buildLot({ ...firstForm, count, parked: 0 }).fault).toBeNull();
    expect(buildLot({ ...firstForm, width: 15 }).fault).toEqual({ field: "width", rule: "least", least: 20 });
    expect(buildLot({ ...firstForm, width: 20 }).fault).toBeNull();
  });
});

/** The number is named, and taking the sentence at its word mends it. */
function checkFault(form: LotForm, fault: LotFault): void {
  const text = faultText("en", fault);
  expect(text).toMatch(/^[A-Z][^{}]+\.$/);
  if (fault.rule !== "free") expect(text).toMatch(/\d/);
  if (fault.rule === "least") {
    const next = buildLot({ ...form, [fault.field]: fault.least }).fault;
    expect(next?.rule === "least" && next.field === fault.field).toBe(false);
  }
}
