import type { Slot } from "../../www/src/scene/scenario";
import { describe, expect, it } from "vitest";
import { resolve, slotOutline, poseInSlot } from "../../www/src/scene/model";
import { insidePolygon, distance } from "../../www/src/scene/geometry";
import { fitRows, fittingSize, misfitOf, rowOf, sizedShape, turnRows } from "../../www/src/scene/slot-fit";
import { openingOf, slotLines, slotRow, type SlotKind } from "../../www/src/scene/slots";
import { footprint, vehicleOf } from "../../www/src/scene/vehicle";
import { createStore, initialState, type Scene } from "../../www/src/store";
import { SlotTool } from "../../www/src/tools/slot";
import { watchGoalSlot } from "../../www/src/tools/slot-fit";
import type { ToolContext, Input } from "../../www/src/tools/tool";

const KINDS: readonly SlotKind[] = ["perpendicular", "parallel", "angled"];
const yard: Scene = {
  version: 1,
  map: { origin: [0, 0], width: 160, height: 120, resolution: 0.25 },
  obstacles: [],
  slots: [],
  vehicle: "paper",
  start: { x: 4, y: 24, heading: 0 },
  goal: { x: 14, y: 24, heading: 0 },
};
const row = (
  shape: { width: number; length: number; kind?: SlotKind },
  count = 5,
  from: [number, number] = [6, 12],
): Slot[] => {
  const made = { kind: "perpendicular" as const, ...shape };
  return slotRow(made, from, [from[0] + openingOf(made) * count + 0.01, from[1]], "right").map((slot, i) => ({
    ...slot,
    id: `s${i + 1}`,
  }));
};

function benchOf(scene: Scene): ToolContext {
  const store = createStore({ scene });
  return {
    store,
    canvas: null,
    view: { camera: { x: 15, y: 10, scale: 20 }, width: 600, height: 400 },
    show: () => undefined,
    preview: (next) => store.edit(next, { transient: true }),
    commit: (next, label) => store.edit(next, { label }),
    revert: () => undefined,
    done: () => undefined,
  };
}
const input = (x: number, y: number): Input => ({
  at: [x, y],
  pixel: [x * 20, -y * 20],
  trail: [[x, y]],
  shift: false,
  alt: false,
  ctrl: false,
  touch: false,
});

function place(bench: ToolContext, from: [number, number], to: [number, number]): Slot[] {
  const before = bench.store.state.scene.slots?.length ?? 0,
    tool = new SlotTool();
  tool.down(bench, input(...from));
  tool.move(bench, input(...to));
  tool.up(bench, input(...to));
  return bench.store.state.scene.slots!.slice(before);
}

describe("slots side by side", () => {
  it.each(KINDS)("of the kind %s share the line between them, which is painted once", (kind) => {
    for (const [count, angle] of [
      [1, 0],
      [5, 0.3],
      [9, -2],
    ] as const) {
      const made = row({ width: 2.7, length: 5.3, kind }, count).map((slot): Slot => {
        const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
        return {
          ...slot,
          x: slot.x * cos - slot.y * sin + 1e-9 * slot.x,
          y: slot.x * sin + slot.y * cos,
          heading: slot.heading + angle,
        };
      });
      expect(made).toHaveLength(count);
      expect(slotLines(made)).toHaveLength(2 * count + 1);
      // Back to back they share the far sides too.
      const behind = made.map((slot, i): Slot => {
        const [, , right, left] = slotOutline(slot) as [number, number][];
        return {
          ...slot,
          id: `b${i}`,
          heading: slot.heading + Math.PI,
          x: right![0] + left![0] - slot.x,
          y: right![1] + left![1] - slot.y,
        };
      });
      if (kind !== "angled") expect(slotLines([...made, ...behind])).toHaveLength(3 * count + 2);
      // Slots apart share nothing.
      expect(slotLines(made.map((slot, i) => ({ ...slot, x: slot.x + 20 * i })))).toHaveLength(3 * count);
    }
  });

  it.each(KINDS)("of the kind %s change to the other side of their aisle line together, and back", (kind) => {
    const scene: Scene = { ...yard, slots: row({ width: 2.7, length: 5.3, kind }) };
    const mouths = (one: Scene): string[] =>
      one
        .slots!.flatMap((slot) => slotOutline(slot).slice(0, 2))
        .map(([x, y]) => `${x.toFixed(6)} ${y.toFixed(6)}`)
        .sort();
    const turned = turnRows(scene, ["s3"]);
    expect(mouths(turned)).toEqual(mouths(scene));
    const depth = (one: Scene, i: number): number => slotOutline(one.slots![i]!)[3]![1] - one.slots![i]!.y;
    for (let i = 0; i < 5; i++) expect(depth(turned, i)).toBeCloseTo(-depth(scene, i), 9);
    expect(rowOf(turned, "s1")).toHaveLength(5);
    for (const [i, slot] of turnRows(turned, ["s1"]).slots!.entries())
      expect(slot.heading).toBeCloseTo(scene.slots![i]!.heading, 9);
  });
});

describe("new slots", () => {
  it.each(["paper", "sedan"] as const)("follow the %s", (vehicle) => {
    const bench = benchOf({ ...yard, vehicle }),
      car = vehicleOf(vehicle);
    const [slot] = place(bench, [6, 12], [20, 12]);
    expect(slot!.length).toBeCloseTo(car.rearToFront + car.rearToBack + 0.5, 9);
    expect(slot!.width).toBeCloseTo(car.width + 0.6, 9);
  });

  it("follow another car at once, unless their size was typed", () => {
    const bench = benchOf(yard);
    bench.store.edit({ ...yard, vehicle: "sedan" });
    expect(place(bench, [6, 12], [20, 12])[0]).toMatchObject({ width: 2.5, length: 5.2 });
    const { toolOptions } = bench.store.state;
    bench.store.set({ toolOptions: { ...toolOptions, slot: { ...toolOptions.slot, width: 3.3 } } });
    bench.store.edit({ ...bench.store.state.scene, vehicle: "paper" });
    expect(place(bench, [6, 22], [20, 22])[0]).toMatchObject({ width: 3.3, length: 6 });
  });

  it.each(KINDS)("hold the whole car: %s", (kind) => {
    for (const spec of ["paper", "sedan"] as const) {
      for (const angle of [0.35, Math.PI / 4, 1.2]) {
        const car = vehicleOf(spec),
          shape = { ...sizedShape({ ...initialState().toolOptions.slot, kind, angle }, car) };
        const [slot] = slotRow(shape, [6, 12], [7, 12]) as [Slot];
        expect(misfitOf(slot, car)).toBeNull();
        for (const entry of ["head-in", "reverse-in"] as const) {
          for (const corner of footprint(poseInSlot(slot, entry, car), car))
            expect(insidePolygon(corner, slotOutline(slot)), `${kind} ${angle}`).toBe(true);
        }
      }
    }
  });
});

describe("a slot that is too small", () => {
  const car = vehicleOf("paper");

  it("is told from one that fits to the centimetre", () => {
    expect(misfitOf({ kind: "perpendicular", width: 2.6, length: 5.5 }, car)).toBeNull();
    expect(misfitOf({ kind: "perpendicular", width: 2.8, length: 5.3 }, car)).toEqual({ short: 0.2, narrow: 0 });
    expect(misfitOf({ kind: "perpendicular", width: 2.5, length: 5.495 }, car)).toEqual({ short: 0.01, narrow: 0.1 });
    expect(misfitOf({ kind: "angled", angle: Math.PI / 4, width: 2.8, length: 8 }, car)).toEqual({
      short: 0.1,
      narrow: 0,
    });
  });

  it("says so when it is placed, and one click makes its row fit in one step", () => {
    const bench = benchOf(yard),
      { toolOptions } = bench.store.state;
    bench.store.set({ toolOptions: { ...toolOptions, slot: { ...toolOptions.slot, length: 5.3 } } });
    const placed = place(bench, [6, 12], [20, 12]);
    const { message } = bench.store.state;
    expect(message?.text).toBe("These slots are 0.2 m too short for the car.");
    message!.action!.run();
    expect(bench.store.state.scene.slots!.map((slot) => slot.length)).toEqual(placed.map(() => 6));
    bench.store.undo();
    expect(bench.store.state.scene.slots).toEqual(placed);
  });

  it("says so when the goal comes into it, also because the car changes", () => {
    const scene = { ...yard, vehicle: "sedan" as const, slots: row({ width: 2.5, length: 5.2 }) },
      { store } = benchOf(scene);
    watchGoalSlot(store);
    store.edit({ ...scene, goal: { slot: "s2", entry: "reverse-in" } });
    expect(store.state.message).toBeNull();
    store.edit({ ...store.state.scene, vehicle: "paper" });
    expect(store.state.message?.text).toBe("This slot is 0.3 m too short and 0.1 m too narrow for the car.");
    store.set({ lang: "zh", message: null });
    store.edit({ ...store.state.scene, goal: { slot: "s3", entry: "reverse-in" } });
    expect(store.state.message?.text).toBe("车位比车辆短 0.3 m、窄 0.1 m。");
    store.set({ message: null });
    store.undo();
    expect(store.state.message).toBeNull();
  });
});

describe("a row that is made to fit", () => {
  it("keeps its order, its middle and its aisle, and has no gaps and no overlaps", () => {
    const scene = {
      ...yard,
      slots: [...row({ width: 2.5, length: 5 }), { ...row({ width: 2.5, length: 5 }, 1, [6, 28])[0]!, id: "alone" }],
    };
    expect(
      rowOf(scene, "s3")
        .map((slot) => slot.id)
        .sort(),
    ).toEqual(["s1", "s2", "s3", "s4", "s5"]);
    const fitted = fitRows(scene, ["s3", "s1"]),
      slots = fitted.slots!;
    expect(slots.at(-1)).toEqual(scene.slots.at(-1));
    const whole = slots.slice(0, 5);
    expect(whole.reduce((sum, slot) => sum + slot.x, 0) / 5).toBeCloseTo(scene.slots[2]!.x, 9);
    expect(whole.map((slot) => slot.y)).toEqual(whole.map(() => expect.closeTo(12, 9)));
    whole
      .slice(1)
      .forEach((slot, i) => expect(distance([slot.x, slot.y], [whole[i]!.x, whole[i]!.y])).toBeCloseTo(3.2, 9));
    expect(rowOf(fitted, "s3")).toHaveLength(5);
    for (const slot of whole) expect(misfitOf(slot, vehicleOf("paper"))).toBeNull();
  });

  it("stays on the ground: its aisle side gives way where its back is at the border", () => {
    const scene = { ...yard, slots: row({ width: 2.6, length: 5 }, 5, [6, 5]) };
    const { slots } = fitRows(scene, ["s1"]),
      [size] = [fittingSize({ kind: "perpendicular" }, resolve(scene).vehicle)];
    expect(slots!.map((slot) => [slot.y, slot.length])).toEqual(slots!.map(() => [expect.closeTo(size.length, 9), 6]));
  });
});
