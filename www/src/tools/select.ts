/** Select, move, turn. */
import {
  addObstacle, findMoving, findObstacle, findSlot, movePose, resolve, setGoalFromSlot, shiftMoving, updateMoving, updateObstacle, updateSlot, withShape, type Scene,
} from "../scene/model";
import { crossesItself, distance, towards, wrapAngle, type Point } from "../scene/plane";
import { dragVertex, edgeAt, headingOf, moveShape, pivotOf, turnShape, vertexAt, type Shape } from "../scene/shapes";
import type { Selection } from "../store";
import type { Draft } from "./draft";
import { hitAt, selectedShape, type Hit } from "./hit";
import { snapAngle, snapPoint, snapPose } from "./snap";
import { metresOf, type Bench, type Input, type Tool } from "./tool";
import { word } from "./words";

interface Press { hit: Hit; at: Point; pixel: Point; scene: Scene; dragging: boolean; duplicate: string | null }

const DRAG_PX = 3;

export class SelectTool implements Tool {
  private press: Press | null = null;
  private hot: Selection = null;

  cursor(bench: Bench, input: Input | null): string {
    if (this.press?.dragging) return this.press.hit.part === "object" ? "grabbing" : "crosshair";
    const hit = input ? hitAt(bench, input, this.hot) : null;
    if (!hit) return "default";
    return hit.part === "object" ? "grab" : "pointer";
  }

  hover(bench: Bench, input: Input | null): void {
    const hit = input && !input.touch ? hitAt(bench, input, this.hot) : null;
    this.hot = hit?.part === "object" ? hit.selection : hit?.part === "pose-grip" ? { kind: hit.which } : null;
    bench.show(this.hot ? { hot: this.hot } : null);
  }

  down(bench: Bench, input: Input): void {
    const hit = hitAt(bench, input, this.hot);
    this.press = hit && { hit, at: input.at, pixel: input.pixel, scene: bench.store.state.scene, dragging: false, duplicate: null };
    if (!hit) bench.store.set({ selection: null });
    else if (hit.part === "object") bench.store.set({ selection: hit.selection });
    else if (hit.part === "pose-grip") bench.store.set({ selection: { kind: hit.which } });
  }

  move(bench: Bench, input: Input): void {
    const { press } = this;
    if (!press) return;
    if (!press.dragging) {
      if (distance(press.pixel, input.pixel) < DRAG_PX * (input.touch ? 2 : 1)) return;
      press.dragging = true;
      if (input.alt) this.duplicate(bench, press);
    }
    const { scene, draft } = this.dragged(bench, press, input);
    bench.show(draft);
    if (scene) bench.preview(scene);
  }

  up(bench: Bench, input: Input): void {
    const { press } = this;
    this.press = null;
    bench.show(null);
    if (!press) return;
    if (press.dragging) bench.commit(bench.store.state.scene, "move");
    else if (press.hit.part === "object" && press.hit.selection.kind === "slot") this.clickSlot(bench, press.hit.selection.id);
    this.hover(bench, input);
  }

  /** On an edge of the selected polygon or wall: a new vertex. */
  doubleClick(bench: Bench, input: Input): void {
    const shape = selectedShape(bench.store.state);
    if (!shape || (shape.type !== "polygon" && shape.type !== "wall")) return;
    const index = edgeAt(shape.points, input.at, metresOf(bench, 8), shape.type === "polygon");
    if (index < 0 || vertexAt(shape.points, input.at, metresOf(bench, 10)) >= 0) return;
    const points = [...shape.points.slice(0, index), input.at, ...shape.points.slice(index)];
    if (index === 0) points.push(points.shift()!);
    bench.commit(updateObstacle(bench.store.state.scene, shape.id, { ...shape, points }), "vertex");
  }

  cancel(bench: Bench): boolean {
    if (this.press?.dragging) {
      this.press = null;
      bench.show(null);
      bench.revert();
      return true;
    }
    this.press = null;
    if (!bench.store.state.selection) return false;
    bench.store.set({ selection: null });
    return true;
  }

  private clickSlot(bench: Bench, id: string): void {
    const { scene } = bench.store.state;
    if (!findSlot(scene, id)?.occupied) bench.commit(setGoalFromSlot(scene, id), "goal");
  }

  private duplicate(bench: Bench, press: Press): void {
    if (press.hit.part !== "object" || press.hit.selection.kind !== "obstacle") return;
    const original = findObstacle(press.scene, press.hit.selection.id);
    if (!original) return;
    const { scene, id } = addObstacle(press.scene, original);
    press.scene = scene;
    press.hit = { part: "object", selection: { kind: "obstacle", id } };
    bench.preview(scene);
    bench.store.set({ selection: press.hit.selection });
  }

  /** Every step starts from the scene at the press: rounding cannot add up. */
  private dragged(bench: Bench, press: Press, input: Input): { scene: Scene | null; draft: Draft | null } {
    const { hit } = press;
    switch (hit.part) {
      case "pose-grip": return turnPose(press, hit.which, input);
      case "turn-grip": return { scene: withShape(press.scene, hit.id, (shape) => turnTowards(shape, press.at, input)), draft: null };
      case "vertex": return { scene: moveVertex(bench, press.scene, hit, input), draft: null };
      case "way": return { scene: moveCorner(bench, press.scene, hit, input), draft: null };
      case "object": return moveObject(bench, press, hit.selection, input);
    }
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
  const pivot = pivotOf(shape), heading = headingOf(shape) ?? 0;
  const turned = heading + wrapAngle(towards(pivot, input.at) - towards(pivot, from));
  return turnShape(shape, wrapAngle(snapAngle(turned, input.alt ? "free" : input.shift ? "always" : "near") - heading));
}

function moveVertex(bench: Bench, scene: Scene, { id, index }: { id: string; index: number }, input: Input): Scene | null {
  const shape = findObstacle(scene, id);
  if (!shape || shape.type === "cells") return null;
  const next = dragVertex(shape, index, snapPoint(bench, input, id));
  if (next.type === "polygon" && crossesItself(next.points)) {
    bench.store.set({ message: { tone: "err", text: word(bench.store.state, "crosses") } });
    return null;
  }
  return updateObstacle(scene, id, next);
}

function moveCorner(bench: Bench, scene: Scene, { id, index }: { id: string; index: number }, input: Input): Scene {
  const to = snapPoint(bench, input, id);
  return updateMoving(scene, id, { points: (findMoving(scene, id)?.points ?? []).map((p, i) => (i === index ? to : p)) });
}

function moveObject(bench: Bench, press: Press, selection: NonNullable<Selection>, input: Input): { scene: Scene; draft: Draft | null } {
  const { scene } = press;
  const dx = input.at[0] - press.at[0], dy = input.at[1] - press.at[1];
  if (!("id" in selection)) {
    const from = resolve(scene)[selection.kind];
    const { pose, goal, guides } = snapPose(bench, input, selection.kind, { ...from, x: from.x + dx, y: from.y + dy });
    const moved = "slot" in goal ? { ...scene, goal } : movePose(scene, selection.kind, pose);
    return { scene: moved, draft: { grabbed: { which: selection.kind, part: "body" }, guides } };
  }
  if (selection.kind === "moving") return { scene: shiftMoving(scene, selection.id, dx, dy), draft: null };
  if (selection.kind === "slot") {
    const slot = findSlot(scene, selection.id);
    return { scene: slot ? updateSlot(scene, selection.id, { x: slot.x + dx, y: slot.y + dy }) : scene, draft: null };
  }
  return { scene: withShape(scene, selection.id, (shape) => moveShape(shape, dx, dy)), draft: null };
}
