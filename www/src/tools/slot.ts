/** Rows of parking slots: a drag along the aisle, as many as fit. The bays lie to its right; Alt puts them to its left. */
import { addSlots, resolve } from "../scene/model";
import { distance, insidePolygon, towards, type Point } from "../scene/plane";
import { distanceToShape, onCells } from "../scene/shapes";
import { selectionOf } from "../scene/things";
import { sizedShape } from "../scene/slot-fit";
import { openingOf, slotRow, type SlotShape } from "../scene/slots";
import { fixed } from "../view/text";
import type { Aisle, Draft } from "./draft";
import { sayMisfit } from "./slot-fit";
import { constrainAngle, snapAngle, snapPoint } from "./snap";
import type { Bench, Input, Tool } from "./tool";
import { word } from "./words";

export class SlotTool implements Tool {
  readonly drags = true;
  private from: Point | null = null;

  cursor(): string {
    return "crosshair";
  }

  down(bench: Bench, input: Input): void {
    this.from = snapPoint(bench, input).at;
    this.move(bench, input);
  }

  move(bench: Bench, input: Input): void {
    if (this.from) bench.show(rowDraft(bench, this.from, this.end(bench, this.from, input), input.alt));
  }

  up(bench: Bench, input: Input): void {
    const { from } = this;
    this.from = null;
    bench.show(null);
    if (!from) return;
    const slots = slotRow(shapeOf(bench, input.alt), from, this.end(bench, from, input), input.alt ? "left" : "right");
    const { scene, ids } = addSlots(bench.store.state.scene, slots);
    bench.commit(scene, "slots");
    bench.store.set({ selection: selectionOf(bench.store.state.scene, ids) });
    bench.done();
    sayMisfit(bench.store, ids);
  }

  cancel(bench: Bench): boolean {
    const drawing = this.from !== null;
    this.from = null;
    bench.show(null);
    return drawing;
  }

  /** Rows go straight unless they are pulled away from it. */
  private end(bench: Bench, from: Point, input: Input): Point {
    if (input.shift) return constrainAngle(from, input.at);
    const to = snapPoint(bench, input).at, angle = towards(from, to), straight = snapAngle(angle);
    if (input.ctrl || straight === angle) return to;
    const length = distance(from, to);
    return [from[0] + length * Math.cos(straight), from[1] + length * Math.sin(straight)];
  }
}

/** The option says where bays lean on the page, along the drag or against it; a slot says it as seen from its aisle. */
function shapeOf(bench: Bench, flipped: boolean): SlotShape {
  const { scene, toolOptions } = bench.store.state;
  const { kind, width, length, angle, lean } = sizedShape(toolOptions.slot, resolve(scene).vehicle);
  if (kind !== "angled") return { kind, width, length };
  return { kind, width, length, angle, lean: (lean === "right") === flipped ? "right" : "left" };
}

function rowDraft(bench: Bench, from: Point, to: Point, flipped: boolean): Draft {
  const shape = shapeOf(bench, flipped), { state } = bench.store, { angle, lean } = state.toolOptions.slot;
  const slots = slotRow(shape, from, to, flipped ? "left" : "right");
  const leaning = shape.kind === "angled" ? ` · ${fixed((angle * 180) / Math.PI, 0)}° ${word(state, lean)}` : "";
  const count = `${slots.length} ${word(state, slots.length === 1 ? "slot" : "slots")}`;
  const row = slots.length * openingOf(shape);
  return {
    preview: { kind: "slots", slots, from, to, aisle: aisleOf(bench, slots[0]?.heading ?? 0, from, to) },
    label: {
      text: `${count}${leaning} · ${fixed(shape.width, 2)} × ${fixed(shape.length, 2)} m · ${word(state, "row")} ${fixed(row, 2)} m`,
      at: [(from[0] + to[0]) / 2, Math.max(from[1], to[1])],
    },
  };
}

/** The aisle in front of a row, and how much of it is free, measured from the row's middle. */
function aisleOf(bench: Bench, heading: number, from: Point, to: Point): Aisle {
  const { scene, toolOptions: { slot: { aisle } } } = bench.store.state;
  const middle: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], dx = -Math.cos(heading), dy = -Math.sin(heading);
  const at = (metres: number): Point => [middle[0] + dx * metres, middle[1] + dy * metres];
  const { boundary } = resolve(scene);
  const taken = (p: Point): boolean => !insidePolygon(p, boundary)
    || (scene.obstacles ?? []).some((one) => (one.type === "cells" ? onCells(p, one.runs, scene.map) : distanceToShape(p, one) <= 0));
  let free = RAY_STEP;
  while (free < aisle && !taken(at(free))) free += RAY_STEP;
  return { from: middle, to: at(aisle), width: aisle, free: Math.min(aisle, free) };
}

/** Metres from look to look. */
const RAY_STEP = 0.1;
