/** Freehand walls of map cells, and the eraser. */
import { capsuleRuns } from "../scene/cells";
import { paintCosts } from "../scene/costs";
import { brushCells } from "../scene/brushing";
import { resolve, updateSlot, type Scene } from "../scene/model";
import { removeObstacle, removeSlot } from "../scene/removal";
import { distance, insidePolygon, type Point } from "../scene/geometry";
import { distanceToShape } from "../scene/shapes";
import type { Draft } from "../store/draft";
import type { ToolContext, Input, Tool } from "./tool";
import { nth } from "../scene/nth";

abstract class StrokeTool implements Tool {
  readonly drags = true;
  private last: Point | null = null;

  constructor(private readonly erase: boolean) {}

  cursor(): string {
    return "crosshair";
  }

  hover(context: ToolContext, input: Input | null): void {
    context.show(input && !input.touch ? this.disc(context, input.at) : null);
  }

  down(context: ToolContext, input: Input): void {
    this.last = input.at;
    this.begin();
    this.stroke(context, [input.at]);
  }

  move(context: ToolContext, input: Input): void {
    if (this.last) this.stroke(context, input.trail);
  }

  up(context: ToolContext, input: Input): void {
    if (!this.last) return;
    this.last = null;
    context.commit(context.store.state.scene, this.erase ? "erase" : "brush");
    this.hover(context, input);
  }

  cancel(context: ToolContext): boolean {
    const drawing = this.last !== null;
    this.last = null;
    if (drawing) context.revert();
    context.show(null);
    return drawing;
  }

  protected begin(): void {}
  protected abstract apply(context: ToolContext, scene: Scene, from: Point, to: Point): Scene;

  private stroke(context: ToolContext, trail: readonly Point[]): void {
    const before = context.store.state.scene;
    let scene = before;
    for (const at of trail) {
      scene = this.apply(context, scene, this.last ?? at, at);
      this.last = at;
    }
    context.show(this.disc(context, this.last ?? nth(trail, 0)));
    if (scene !== before) context.preview(scene);
  }

  /** The label beside the disc. */
  protected label(_: ToolContext): string {
    return "";
  }

  private disc(context: ToolContext, at: Point): Draft {
    return {
      preview: {
        kind: "brush",
        at,
        radius: context.store.state.toolOptions.brushRadius,
        erase: this.erase,
        label: this.label(context),
      },
    };
  }
}

export class BrushTool extends StrokeTool {
  constructor() {
    super(false);
  }

  protected override apply(context: ToolContext, scene: Scene, from: Point, to: Point): Scene {
    return brushCells(scene, capsuleRuns(scene.map, from, to, context.store.state.toolOptions.brushRadius), "add");
  }
}

/** Gives cells a weight; 1 takes it away. */
export class CostTool extends StrokeTool {
  constructor() {
    super(false);
  }

  protected override apply(context: ToolContext, scene: Scene, from: Point, to: Point): Scene {
    const { brushRadius, costWeight } = context.store.state.toolOptions;
    return paintCosts(scene, capsuleRuns(scene.map, from, to, brushRadius), costWeight);
  }

  protected override label(context: ToolContext): string {
    return `×${context.store.state.toolOptions.costWeight}`;
  }
}

export class EraserTool extends StrokeTool {
  /** Slots whose car this stroke took away; the slot itself takes another stroke. */
  private readonly freed = new Set<string>();

  constructor() {
    super(true);
  }

  protected override begin(): void {
    this.freed.clear();
  }

  protected override apply(context: ToolContext, scene: Scene, from: Point, to: Point): Scene {
    const radius = context.store.state.toolOptions.brushRadius;
    const cells = capsuleRuns(scene.map, from, to, radius);
    let next = paintCosts(brushCells(scene, cells, "erase"), cells, 1);
    for (const obstacle of scene.obstacles ?? []) {
      if (obstacle.type === "cells" || obstacle.id === undefined) continue;
      const touched = along(from, to, radius).some((p) => distanceToShape(p, obstacle) <= radius);
      if (touched) next = removeObstacle(next, obstacle.id);
    }
    return this.eraseSlots(next, from, to);
  }

  private eraseSlots(scene: Scene, from: Point, to: Point): Scene {
    let next = scene;
    for (const { slot, outline } of resolve(scene).slots) {
      const crossed = along(from, to, 0.5).some((p) => insidePolygon(p, outline));
      if (!crossed || slot.id === undefined || this.freed.has(slot.id)) continue;
      this.freed.add(slot.id);
      next = slot.occupied ? updateSlot(next, slot.id, { occupied: false }) : removeSlot(next, slot.id);
    }
    return next;
  }
}

/** Points from one end to the other, no farther apart than `step`. */
function along(from: Point, to: Point, step: number): Point[] {
  const count = Math.min(400, Math.ceil(distance(from, to) / Math.max(0.05, step)));
  return Array.from({ length: count + 1 }, (_, i): Point => {
    const t = count === 0 ? 1 : i / count;
    return [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
  });
}
