import { init, sceneGeometry, type Obstacle } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";
import { faultText } from "../../www/src/panels/new-lot-words";
import { mapOutline, resolve, type Scene } from "../../www/src/scene/model";
import { buildLot, firstForm, LIMITS, sizesOf, type LotFault, type LotForm, type NumberField } from "../../www/src/scene/lot";
import { fromPose, insidePolygon, type Point } from "../../www/src/scene/plane";
import { rectangleCorners } from "../../www/src/scene/shapes";
import { misfitOf } from "../../www/src/scene/slot-fit";
import { footprint, vehicleOf } from "../../www/src/scene/vehicle";

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

/** Any numbers within the bounds, drawn towards the first form often enough that about half of them give a lot. */
function randomForm(random: () => number): LotForm {
  const pick = <T>(...all: T[]): T => all[Math.floor(random() * all.length)]!;
  const number = (field: NumberField): number => {
    const [least, most, digits] = LIMITS[field], at = random() < 0.15 ? pick(0, 1) : random();
    return Number((least + (most - least) * at).toFixed(digits));
  };
  const follows = (field: NumberField): number | null => (random() < 0.6 ? null : number(field));
  const own = random() < 0.3, count = random() < 0.3 ? number("count") : 1 + Math.floor(random() * 12);
  const form: LotForm = {
    width: follows("width"), depth: follows("depth"), kind: pick("perpendicular", "parallel", "angled"), angle: number("angle"), count,
    bayWidth: follows("bayWidth"), bayLength: follows("bayLength"), aisles: pick(1, 1, 2, 3, number("aisles")), sides: pick("one", "both"), aisle: number("aisle"),
    parked: 0, every: pick(0, 0, 1, 3, number("every")), column: number("column"), wall: pick(0, 0.2, number("wall")),
    entrance: pick("left", "right", "bottom", "top"), entry: pick("head-in", "reverse-in"),
    car: own ? "own" : pick("sedan", "paper"), carLength: number("carLength"), carWidth: number("carWidth"), wheelbase: number("wheelbase"), radius: number("radius"),
  };
  const total = sizesOf(form).rows * count;
  return { ...form, parked: Math.floor(random() * (total + 1)) };
}

/** Whether two convex outlines have more than a hair of ground in common. */
function overlap(a: readonly Point[], b: readonly Point[]): boolean {
  return [a, b].every((outline) => outline.every((p, i) => {
    const q = outline[(i + 1) % outline.length]!, length = Math.hypot(q[0] - p[0], q[1] - p[1]), nx = (q[1] - p[1]) / length, ny = (p[0] - q[0]) / length;
    const span = (points: readonly Point[]): [number, number] => [Math.min(...points.map(([x, y]) => x * nx + y * ny)), Math.max(...points.map(([x, y]) => x * nx + y * ny))];
    const [aLow, aHigh] = span(a), [bLow, bHigh] = span(b);
    return Math.min(aHigh, bHigh) - Math.max(aLow, bLow) > 1e-6;
  }));
}

function outlineOf(obstacle: Obstacle): Point[] {
  if (obstacle.type === "rectangle") return rectangleCorners(obstacle);
  if (obstacle.type !== "wall") throw new Error(`a lot has no ${obstacle.type}`);
  const [[x0, y], [x1]] = obstacle.points as [Point, Point], half = obstacle.thickness! / 2;
  return [[x0 - half, y - half], [x1 + half, y - half], [x1 + half, y + half], [x0 - half, y + half]];
}

const STEP = 0.3;

/** Whether a disc as wide as the car can be brought from the start to the open side of every bay. */
function unreachable(scene: Scene): string[] {
  const { start, slots, vehicle, parked } = resolve(scene), outline = mapOutline(scene), [width, depth] = outline[2]!, half = vehicle.width / 2;
  const blocked = [...scene.obstacles!.map(outlineOf), ...slots.map((one) => one.outline), ...parked.map((car) => footprint(car.pose, car.vehicle))];
  const columns = Math.ceil(width / STEP), rows = Math.ceil(depth / STEP), closed = new Uint8Array(columns * rows).fill(0);
  const boxes = blocked.map((points) => points.map(([x, y]) => [x, y] as const));
  const free = (x: number, y: number): boolean => {
    if (x < half || y < half || x > width - half || y > depth - half) return false;
    const box: Point[] = [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]];
    return !boxes.some((points) => overlap(points as Point[], box));
  };
  const from = fromPose(start, (vehicle.rearToFront - vehicle.rearToBack) / 2, 0), open: [number, number][] = [[Math.floor(from[0] / STEP), Math.floor(from[1] / STEP)]];
  const seen: Point[] = [];
  while (open.length > 0) {
    const [i, j] = open.pop()!;
    if (i < 0 || j < 0 || i >= columns || j >= rows || closed[j * columns + i]) continue;
    closed[j * columns + i] = 1;
    const at: Point = [(i + 0.5) * STEP, (j + 0.5) * STEP];
    if (!free(...at)) continue;
    seen.push(at);
    open.push([i + 1, j], [i - 1, j], [i, j + 1], [i, j - 1]);
  }
  // A hand's breadth in front of the open side, give or take a step of the lattice.
  return slots.filter(({ slot }) => {
    const x = slot.x - Math.cos(slot.heading) * half, y = slot.y - Math.sin(slot.heading) * half;
    return !seen.some(([sx, sy]) => Math.hypot(sx - x, sy - y) < half / 2 + 2 * STEP);
  }).map(({ slot }) => slot.id!);
}

function checkScene(scene: Scene): void {
  const { start, goal, vehicle, slots, parked, boundary } = resolve(scene), [, , [width, depth]] = boundary as [Point, Point, Point, Point];
  expect(() => sceneGeometry(scene)).not.toThrow();
  const solid = scene.obstacles!.map(outlineOf), bays = slots.map((one) => one.outline), car = footprint(start, vehicle);
  for (const [x, y] of [...solid, ...bays, car].flat()) expect(x > -1e-6 && y > -1e-6 && x < width + 1e-6 && y < depth + 1e-6).toBe(true);
  const all = [...solid, ...bays, car];
  for (let i = 0; i < all.length; i++) for (let j = i + 1; j < all.length; j++) expect(overlap(all[i]!, all[j]!)).toBe(false);
  for (const { slot } of slots) expect(misfitOf(slot, slot.occupied ? vehicleOf("sedan") : vehicle)).toBeNull();
  for (const one of parked) expect(overlap(footprint(one.pose, one.vehicle), footprint(goal, vehicle))).toBe(false);
  expect(insidePolygon([goal.x, goal.y], boundary)).toBe(true);
}

describe("a lot from a form", () => {
  it("is the newcomer's: eight bays, two taken, and the car at the entrance", () => {
    const { scene } = buildLot(firstForm);
    expect(scene!.slots!.map((slot) => slot.occupied ?? false)).toEqual([false, false, true, false, false, false, true, false]);
    expect(scene!.goal).toEqual({ slot: "slot-1", entry: "reverse-in" });
    checkScene(scene!);
  });

  it("is valid for any numbers within the bounds, or one sentence says which number to change", () => {
    const random = randomOf(20), rules = new Map<string, number>();
    let lots = 0;
    for (let i = 0; i < 500; i++) {
      const form = randomForm(random), { scene, fault } = buildLot(form);
      try {
        if (fault) {
          rules.set(fault.rule, (rules.get(fault.rule) ?? 0) + 1);
          checkFault(form, fault);
        } else {
          lots++;
          if (scene.slots!.length <= 40) checkScene(scene);
        }
      } catch (error) {
        throw new Error(`form ${i}: ${JSON.stringify(form)}`, { cause: error });
      }
    }
    expect(lots).toBeGreaterThan(100);
    expect(rules.get("least")).toBeGreaterThan(30);
    for (const rule of ["free", "shorter"]) expect(rules.get(rule), rule).toBeGreaterThan(5);
  });

  it("lets the car come to every bay", () => {
    const random = randomOf(21);
    let looked = 0;
    for (let i = 0; i < 1500 && looked < 12; i++) {
      const form = randomForm(random), { scene } = buildLot(form);
      if (!scene || scene.slots!.length > 60 || sizesOf(form).width * sizesOf(form).depth > 900) continue;
      looked++;
      expect(unreachable(scene), JSON.stringify(form)).toEqual([]);
    }
    expect(looked).toBe(12);
  }, 30_000);

  it("grows with what stands in it unless its size was given", () => {
    for (const count of [1, 8, 40]) expect(buildLot({ ...firstForm, count, parked: 0 }).fault).toBeNull();
    expect(buildLot({ ...firstForm, width: 15 }).fault).toEqual({ field: "width", rule: "least", least: 20 });
    expect(buildLot({ ...firstForm, width: 20 }).fault).toBeNull();
  });
});

/** The number is named, and taking the sentence at its word mends it. */
function checkFault(form: LotForm, fault: LotFault): void {
  for (const lang of ["en", "zh"] as const) {
    const text = faultText(lang, fault);
    expect(text).toMatch(lang === "en" ? /^[A-Z][^{}]+\.$/ : /^[^{}]+。$/);
    if (fault.rule !== "free") expect(text).toMatch(/\d/);
  }
  if (fault.rule === "least") {
    const next = buildLot({ ...form, [fault.field]: fault.least }).fault;
    expect(next?.rule === "least" && next.field === fault.field).toBe(false);
  }
}
