/** Rectangles by their diagonal; Shift makes squares. */
import { addObstacle } from "../scene/model";
import { distance, type Point } from "../scene/geometry";
import { rectangleBetween } from "../scene/shapes";
import { fixed } from "../view/text";
import { snapPoint, type Snapped } from "./snap";
import { metresOf, type ToolContext, type Input, type Tool } from "./tool";

const LEAST_PX = 4;

export class RectangleTool implements Tool {
  readonly drags = true;
  private from: Point | null = null;

  cursor(): string {
    return "crosshair";
  }

  down(context: ToolContext, input: Input): void {
    this.from = snapPoint(context, input).at;
  }

  move(context: ToolContext, input: Input): void {
    if (!this.from) return;
    const { at: to, guides } = this.corner(context, this.from, input);
    const { center, size } = rectangleBetween({}, this.from, to);
    context.show({
      guides,
      preview: { kind: "rectangle", center, size, heading: 0, from: this.from, to },
      label: { text: `${fixed(size[0], 2)} × ${fixed(size[1], 2)} m`, at: [center[0], Math.max(this.from[1], to[1])] },
    });
  }

  up(context: ToolContext, input: Input): void {
    const { from } = this;
    this.from = null;
    context.show(null);
    if (!from) return;
    const { center, size } = rectangleBetween({}, from, this.corner(context, from, input).at);
    if (Math.min(...size) < metresOf(context, LEAST_PX) || distance(from, center) === 0) return;
    const { scene, id } = addObstacle(context.store.state.scene, { type: "rectangle", center, size, heading: 0 });
    context.commit(scene, "rectangle");
    context.store.set({ selection: { kind: "obstacle", id } });
    context.done();
  }

  cancel(context: ToolContext): boolean {
    const drawing = this.from !== null;
    this.from = null;
    context.show(null);
    return drawing;
  }

  hover(context: ToolContext, input: Input | null): void {
    const guides = input && !input.touch ? snapPoint(context, input).guides : [];
    context.show(guides.length > 0 ? { guides } : null);
  }

  private corner(context: ToolContext, from: Point, input: Input): Snapped {
    const { at, guides } = snapPoint(context, input);
    if (!input.shift) return { at, guides };
    const side = Math.max(Math.abs(at[0] - from[0]), Math.abs(at[1] - from[1]));
    return {
      at: [from[0] + side * Math.sign(at[0] - from[0] || 1), from[1] + side * Math.sign(at[1] - from[1] || 1)],
      guides: [],
    };
  }
}
