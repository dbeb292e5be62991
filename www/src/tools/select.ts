/** Select, move, turn, copy. */
import { isPose, type Selection } from "../scene/selection";
import {
  findMoving,
  findObstacle,
  findSlot,
  movePose,
  resolve,
  setGoalFromSlot,
  updateMoving,
  updateObstacle,
  withShape,
  type Scene,
} from "../scene/model";
import { boxOf, crossesItself, distance, towards, wrapAngle, type Box, type Point } from "../scene/geometry";
import { dragVertex, headingOf, pivotOf, turnShape, type Shape } from "../scene/shapes";
import {
  boxOfThings,
  copyThings,
  findThing,
  idsOf,
  moveThings,
  selectionOf,
  thingsWithin,
} from "../scene/scene-objects";
import { askForPose, poseLabelAt } from "../view/pose-label";
import type { Draft } from "../store/draft";
import { hitAt, type Hit } from "./hit";
import { snapAngle, snapMove, snapPoint, snapPose } from "./snap";
import type { ToolContext, Input, Tool } from "./tool";
import { word } from "../view/tool-messages";

/** `hit` null: the press began beside everything and draws a frame around what shall be chosen. */
interface Press {
  hit: Hit | null;
  at: Point;
  pixel: Point;
  scene: Scene;
  box: Box | null;
  ids: readonly string[];
  dragging: boolean;
}

const DRAG_PX = 3;

export class SelectTool implements Tool {
  private press: Press | null = null;
  private hot: Selection = null;

  cursor(context: ToolContext, input: Input | null): string {
    if (this.press?.dragging) return this.press.hit?.part === "object" ? "grabbing" : "crosshair";
    if (input && poseLabelAt(context.canvas, input.pixel)) return "text";
    const hit = input ? hitAt(context, input, this.hot) : null;
    if (!hit) return "default";
    return hit.part === "object" ? "grab" : "pointer";
  }

  hover(context: ToolContext, input: Input | null): void {
    const hit = input && !input.touch ? hitAt(context, input, this.hot) : null;
    this.hot = hit?.part === "object" ? hit.selection : hit?.part === "pose-grip" ? { kind: hit.which } : null;
    context.show(this.hot ? { hot: this.hot } : null);
  }

  down(context: ToolContext, input: Input): void {
    const label = poseLabelAt(context.canvas, input.pixel);
    if (label) {
      askForPose(context.canvas, label);
      return;
    }
    const { scene, selection } = context.store.state,
      hit = hitAt(context, input, this.hot);
    if (hit?.part === "object") this.choose(context, hit.selection, input.shift);
    else if (hit?.part === "pose-grip") context.store.set({ selection: { kind: hit.which } });
    else if (!hit && !input.shift) context.store.set({ selection: null });
    const ids = hit?.part === "object" ? idsOf(context.store.state.selection) : idsOf(selection);
    this.press = { hit, at: input.at, pixel: input.pixel, scene, box: null, ids, dragging: false };
  }

  move(context: ToolContext, input: Input): void {
    const { press } = this;
    if (!press) return;
    if (!press.dragging) {
      if (distance(press.pixel, input.pixel) < DRAG_PX * (input.touch ? 2 : 1)) return;
      press.dragging = true;
      if (input.alt && press.hit?.part === "object") duplicate(context, press);
    }
    if (!press.hit) {
      context.show({ preview: { kind: "marquee", from: press.at, to: input.at } });
      return;
    }
    const { scene, draft } = dragged(context, press, press.hit, input);
    context.show(draft);
    if (scene) context.preview(scene);
  }

  up(context: ToolContext, input: Input): void {
    const { press } = this;
    this.press = null;
    context.show(null);
    if (!press) return;
    if (press.dragging && press.hit) context.commit(context.store.state.scene, "move");
    else if (press.dragging) this.gather(context, press, input);
    else if (press.hit?.part === "object") this.click(context, press.hit.selection, input);
    this.hover(context, input);
  }

  /** Chooses what is under the pointer, as menus do before they open; a group that it belongs to stays. */
  pick(context: ToolContext, input: Input): void {
    const hit = hitAt(context, input, null);
    if (hit?.part === "object") this.choose(context, hit.selection, false);
    else if (!hit) context.store.set({ selection: null });
  }

  /** Enter: the chosen pose's numbers. */
  confirm(context: ToolContext): boolean {
    const { selection } = context.store.state;
    return isPose(selection) && askForPose(context.canvas, selection.kind);
  }

  cancel(context: ToolContext): boolean {
    const { press } = this;
    this.press = null;
    context.show(null);
    if (press?.dragging) {
      context.revert();
      return true;
    }
    if (!context.store.state.selection) return false;
    context.store.set({ selection: null });
    return true;
  }

  /** With Shift things join a group or leave it; a press on one of a group keeps the group. */
  private choose(context: ToolContext, hit: NonNullable<Selection>, shift: boolean): void {
    const { scene, selection } = context.store.state;
    const ids = idsOf(selection),
      id = idsOf(hit)[0];
    if (id === undefined || (!shift && !ids.includes(id))) context.store.set({ selection: hit });
    else if (shift)
      context.store.set({
        selection: selectionOf(scene, ids.includes(id) ? ids.filter((one) => one !== id) : [...ids, id]),
      });
  }

  private click(context: ToolContext, hit: NonNullable<Selection>, input: Input): void {
    const { scene, selection } = context.store.state;
    if (input.shift) return;
    if (selection?.kind === "group") context.store.set({ selection: hit });
    if (hit.kind === "slot" && !findSlot(scene, hit.id)?.occupied)
      context.commit(setGoalFromSlot(scene, hit.id), "goal");
  }

  private gather(context: ToolContext, press: Press, input: Input): void {
    const { scene } = context.store.state,
      inside = thingsWithin(scene, boxOf([press.at, input.at]));
    context.store.set({
      selection: selectionOf(scene, input.shift ? [...new Set([...press.ids, ...inside])] : inside),
    });
  }
}

/** The copy is the thing being dragged. */
function duplicate(context: ToolContext, press: Press): void {
  const { scene, ids } = copyThings(press.scene, press.ids);
  const selection = selectionOf(scene, ids);
  if (!selection) return;
  Object.assign(press, { scene, ids });
  context.preview(scene);
  context.store.set({ selection });
}

/** Every step starts from the scene at the press: rounding cannot add up. */
function dragged(
  context: ToolContext,
  press: Press,
  hit: Hit,
  input: Input,
): { scene: Scene | null; draft: Draft | null } {
  switch (hit.part) {
    case "pose-grip":
      return turnPose(press, hit.which, input);
    case "turn-grip":
      return { scene: withShape(press.scene, hit.id, (shape) => turnTowards(shape, press.at, input)), draft: null };
    case "vertex":
      return moveVertex(context, press.scene, hit, input);
    case "way":
      return moveCorner(context, press.scene, hit, input);
    case "object":
      return moveObject(context, press, hit.selection, input);
  }
}

/** The heading follows the pointer about the rear axle. */
function turnPose(press: Press, which: "start" | "goal", input: Input): { scene: Scene; draft: Draft } {
  const pose = resolve(press.scene)[which];
  const axle: Point = [pose.x, pose.y];
  const turned = pose.heading + wrapAngle(towards(axle, input.at) - towards(axle, press.at));
  const heading = snapAngle(turned, input.alt ? "free" : "near");
  return { scene: movePose(press.scene, which, { ...pose, heading }), draft: { grabbed: { which, part: "grip" } } };
}

function turnTowards(shape: Shape, from: Point, input: Input): Shape {
  const pivot = pivotOf(shape),
    heading = headingOf(shape) ?? 0;
  const turned = heading + wrapAngle(towards(pivot, input.at) - towards(pivot, from));
  return turnShape(shape, wrapAngle(snapAngle(turned, input.alt ? "free" : input.shift ? "always" : "near") - heading));
}

function moveVertex(
  context: ToolContext,
  scene: Scene,
  { id, index }: { id: string; index: number },
  input: Input,
): { scene: Scene | null; draft: Draft | null } {
  const shape = findObstacle(scene, id);
  if (!shape || shape.type === "cells") return { scene: null, draft: null };
  const { at, guides } = snapPoint(context, input, id),
    next = dragVertex(shape, index, at);
  if (next.type === "polygon" && crossesItself(next.points)) {
    context.store.set({ message: { tone: "err", text: word(context.store.state, "crosses") } });
    return { scene: null, draft: null };
  }
  return { scene: updateObstacle(scene, id, next), draft: { guides } };
}

function moveCorner(
  context: ToolContext,
  scene: Scene,
  { id, index }: { id: string; index: number },
  input: Input,
): { scene: Scene; draft: Draft } {
  const { at, guides } = snapPoint(context, input, id);
  return {
    scene: updateMoving(scene, id, {
      points: (findMoving(scene, id)?.points ?? []).map((p, i) => (i === index ? at : p)),
    }),
    draft: { guides },
  };
}

function moveObject(
  context: ToolContext,
  press: Press,
  selection: NonNullable<Selection>,
  input: Input,
): { scene: Scene; draft: Draft } {
  const { scene } = press;
  const dx = input.at[0] - press.at[0],
    dy = input.at[1] - press.at[1];
  if (isPose(selection)) {
    const from = resolve(scene)[selection.kind];
    const { pose, goal, guides } = snapPose(context, input, selection.kind, {
      ...from,
      x: from.x + dx,
      y: from.y + dy,
    });
    const moved = "slot" in goal ? { ...scene, goal } : movePose(scene, selection.kind, pose);
    const hot: Selection = "slot" in goal ? { kind: "slot", id: goal.slot } : null;
    return { scene: moved, draft: { grabbed: { which: selection.kind, part: "body" }, guides, hot } };
  }
  const ids = press.ids.filter((id) => findThing(scene, id));
  press.box ??= boxOfThings(scene, ids);
  const { by, guides } = snapMove(context, input, press.box, [dx, dy], ids);
  return { scene: moveThings(scene, ids, ...by), draft: { guides } };
}
