/**
 * Rows of parking slots: a drag along the aisle, as many as fit. The bays lie where there is room, else to its right;
 * Alt swaps.
 */
import "../i18n/later";
import { addSlots, resolve } from "../scene/model";
import { distance, insidePolygon, towards, type Point } from "../scene/geometry";
import { distanceToShape, onCells } from "../scene/shapes";
import { selectionOf } from "../scene/scene-objects";
import { sizedShape } from "../scene/slot-fit";
import { openingOf, slotCentre, slotRow, type SlotShape } from "../scene/slots";
import { fixed } from "../view/text";
import type { Aisle, Draft } from "../store/draft";
import { sayMisfit } from "./slot-fit";
import { constrainAngle, snapAngle, snapPoint } from "./snap";
import type { ToolContext, Input, Tool } from "./tool";
import { word } from "../view/tool-messages";
import { nth } from "../scene/nth";

type Side = "left" | "right";
/** By how much the other side must be better than the right one. */
const CLEARLY = 0.25;

export class SlotTool implements Tool {
  readonly drags = true;
  private from: Point | null = null;

  cursor(): string {
    return "crosshair";
  }

  down(context: ToolContext, input: Input): void {
    this.from = snapPoint(context, input).at;
    this.move(context, input);
  }

  move(context: ToolContext, input: Input): void {
    if (this.from) context.show(rowDraft(context, this.from, this.end(context, this.from, input), input.alt));
  }

  up(context: ToolContext, input: Input): void {
    const { from } = this;
    this.from = null;
    context.show(null);
    if (!from) return;
    const to = this.end(context, from, input),
      side = sideOf(context, from, to, input.alt);
    const slots = slotRow(shapeOf(context, side), from, to, side);
    const { scene, ids } = addSlots(context.store.state.scene, slots);
    context.commit(scene, "slots");
    context.store.set({ selection: selectionOf(context.store.state.scene, ids) });
    context.done();
    sayMisfit(context.store, ids);
  }

  cancel(context: ToolContext): boolean {
    const drawing = this.from !== null;
    this.from = null;
    context.show(null);
    return drawing;
  }

  /** Rows go straight unless they are pulled away from it. */
  private end(context: ToolContext, from: Point, input: Input): Point {
    if (input.shift) return constrainAngle(from, input.at);
    const to = snapPoint(context, input).at,
      angle = towards(from, to),
      straight = snapAngle(angle);
    if (input.ctrl || straight === angle) return to;
    const length = distance(from, to);
    return [from[0] + length * Math.cos(straight), from[1] + length * Math.sin(straight)];
  }
}

/** The option says where bays lean on the page, along the drag or against it; a slot says it as seen from its aisle. */
function shapeOf(context: ToolContext, side: Side): SlotShape {
  const { scene, toolOptions } = context.store.state;
  const { kind, width, length, angle, lean } = sizedShape(toolOptions.slot, resolve(scene).vehicle);
  if (kind !== "angled") return { kind, width, length };
  return { kind, width, length, angle, lean: (lean === "right") === (side === "left") ? "right" : "left" };
}

/** The side of the drag with more free ground for bays, and then with the freer aisle in front of them. */
function sideOf(context: ToolContext, from: Point, to: Point, swapped: boolean): Side {
  const roomAt = (side: Side): number => {
    const slots = slotRow(shapeOf(context, side), from, to, side),
      aisle = aisleOf(context, nth(slots, 0).heading, from, to);
    const free = slots.filter((slot) => !isTaken(context, slotCentre({ ...slot, id: "" }))).length / slots.length;
    return 2 * free + (aisle.width > 0 ? aisle.free / aisle.width : 1);
  };
  return roomAt("left") > roomAt("right") + CLEARLY !== swapped ? "left" : "right";
}

function rowDraft(context: ToolContext, from: Point, to: Point, swapped: boolean): Draft {
  const side = sideOf(context, from, to, swapped),
    shape = shapeOf(context, side),
    { state } = context.store,
    { angle, lean } = state.toolOptions.slot;
  const slots = slotRow(shape, from, to, side);
  const leaning = shape.kind === "angled" ? ` · ${fixed((angle * 180) / Math.PI, 0)}° ${word(state, lean)}` : "";
  const count = `${slots.length} ${word(state, slots.length === 1 ? "slot" : "slots")}`;
  const row = slots.length * openingOf(shape);
  return {
    preview: { kind: "slots", slots, from, to, aisle: aisleOf(context, slots[0]?.heading ?? 0, from, to) },
    label: {
      text:
        `${count}${leaning} · ${fixed(shape.width, 2)} × ${fixed(shape.length, 2)} m · ` +
        `${word(state, "row")} ${fixed(row, 2)} m`,
      at: [(from[0] + to[0]) / 2, Math.max(from[1], to[1])],
    },
  };
}

/** The aisle in front of a row, and how much of it is free, measured from the row's middle. */
function aisleOf(context: ToolContext, heading: number, from: Point, to: Point): Aisle {
  const { aisle } = context.store.state.toolOptions.slot;
  const middle: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2],
    dx = -Math.cos(heading),
    dy = -Math.sin(heading);
  const at = (metres: number): Point => [middle[0] + dx * metres, middle[1] + dy * metres];
  let free = RAY_STEP;
  while (free < aisle && !isTaken(context, at(free))) free += RAY_STEP;
  return { from: middle, to: at(aisle), width: aisle, free: Math.min(aisle, free) };
}

/** True if a point lies off the ground, on an obstacle or in a bay. */
function isTaken(context: ToolContext, p: Point): boolean {
  const { scene } = context.store.state,
    { boundary, slots } = resolve(scene);
  return (
    !insidePolygon(p, boundary) ||
    slots.some(({ outline }) => insidePolygon(p, outline)) ||
    (scene.obstacles ?? []).some((one) =>
      one.type === "cells" ? onCells(p, one.runs, scene.map) : distanceToShape(p, one) <= 0,
    )
  );
}

/** Metres from look to look. */
const RAY_STEP = 0.1;
