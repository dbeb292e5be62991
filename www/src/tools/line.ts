/** Walls, roads and polygons: corner after corner. */
import "../i18n/later";
import { addMoving, addObstacle } from "../scene/model";
import { canExtend, crossesItself, distance, type Point } from "../scene/geometry";
import { tooTight } from "../scene/road";
import { fixed } from "../view/text";
import type { Scene, ToolOptions } from "../store";
import type { Draft } from "../store/draft";
import { constrainAngle, snapPoint, type Snapped } from "./snap";
import { metresOf, reachOf, type ToolContext, type Input, type Tool } from "./tool";
import { word } from "../view/tool-messages";

const DRAG_PX = 8;
const TWICE_PX = 5;
/** Metres, metres per second, seconds. */
const PERSON: { size: Point; speed: number; start: number } = { size: [0.6, 0.6], speed: 1.2, start: 0 };

/** A scene with a new thing. */
interface Made {
  scene: Scene;
  id: string;
  kind: "obstacle" | "moving";
  label: string;
}

abstract class LineTool implements Tool {
  protected points: Point[] = [];
  private pressed: Point | null = null;
  /** Place of the previous press, and whether this press is at the same place. */
  private before: Point | null = null;
  private twice = false;

  protected abstract readonly closed: boolean;
  /** The scene with what the corners make. */
  protected abstract made(scene: Scene, points: Point[], options: ToolOptions): Made;

  /** True where the corners make nothing yet, and it was said why: the line goes on. */
  protected mends(_: ToolContext): boolean {
    return false;
  }

  /** Of the preview's line, metres. */
  protected width(context: ToolContext): { thickness: number } {
    return { thickness: this.closed ? 0 : context.store.state.toolOptions.wallThickness };
  }

  cursor(): string {
    return "crosshair";
  }

  hover(context: ToolContext, input: Input | null): void {
    if (!input) context.show(this.points.length > 0 ? this.draft(context, null) : null);
    else if (!input.touch) this.showAim(context, input);
  }

  down(context: ToolContext, input: Input): void {
    this.twice = this.before !== null && distance(this.before, input.pixel) <= TWICE_PX;
    this.before = this.pressed = input.pixel;
    const { at } = this.aim(context, input);
    if (this.closes(context, input, at) || this.repeats(context, input, at)) {
      this.finish(context);
      return;
    }
    this.add(context, at);
  }

  move(context: ToolContext, input: Input): void {
    this.showAim(context, input);
  }

  /** A drag draws one edge; a wall is complete then. */
  up(context: ToolContext, input: Input): void {
    const dragged = this.pressed !== null && distance(this.pressed, input.pixel) > DRAG_PX;
    this.pressed = null;
    if (!dragged || this.points.length === 0) return;
    this.add(context, this.aim(context, input).at);
    if (!this.closed && this.points.length === 2) this.finish(context);
  }

  /** Quick presses in different places are corners. */
  doubleClick(context: ToolContext): void {
    if (this.twice) this.finish(context);
  }

  confirm(context: ToolContext): boolean {
    return this.points.length > 0 && this.finish(context);
  }

  cancel(context: ToolContext): boolean {
    const drawing = this.points.length > 0;
    this.reset(context);
    return drawing;
  }

  /** Adds the line to the scene; an open one that is too short is dropped. */
  private finish(context: ToolContext): boolean {
    const { points } = this,
      { store } = context,
      { scene, toolOptions } = store.state;
    if (this.closed && points.length < 3) return false;
    if (this.mends(context)) return true;
    this.reset(context);
    if (points.length < 2) return false;
    const { scene: next, id, kind, label } = this.made(scene, points, toolOptions);
    context.commit(next, label);
    store.set({ selection: { kind, id } });
    context.done();
    return true;
  }

  private reset(context: ToolContext): void {
    this.points = [];
    this.pressed = this.before = null;
    context.show(null);
  }

  protected refuse(context: ToolContext): void {
    context.store.set({ message: { tone: "err", text: word(context.store.state, "crosses") } });
  }

  private add(context: ToolContext, at: Point): void {
    const last = this.points.at(-1);
    if (last && distance(last, at) < 1e-6) return;
    if (this.closed && !canExtend(this.points, at)) return this.refuse(context);
    this.points = [...this.points, at];
    context.show(this.draft(context, at));
  }

  private aim(context: ToolContext, input: Input): Snapped {
    const last = this.points.at(-1);
    return input.shift && last ? { at: constrainAngle(last, input.at), guides: [] } : snapPoint(context, input);
  }

  private showAim(context: ToolContext, input: Input): void {
    const { at, guides } = this.aim(context, input);
    context.show({ ...this.draft(context, at), guides });
  }

  /** Fingers and keys have no double click: a press on the last corner ends the line. */
  private repeats(context: ToolContext, input: Input, at: Point): boolean {
    const last = this.points.at(-1),
      reach = input.keyed ? 1e-6 : input.touch ? metresOf(context, reachOf(input)) : -1;
    return last !== undefined && distance(last, at) <= reach;
  }

  private closes(context: ToolContext, input: Input, at: Point): boolean {
    const first = this.points[0];
    return (
      this.closed &&
      this.points.length > 2 &&
      first !== undefined &&
      distance(first, at) <= metresOf(context, reachOf(input))
    );
  }

  private draft(context: ToolContext, cursor: Point | null): Draft {
    const { points } = this;
    const last = points.at(-1),
      first = points[0];
    const closing =
      this.closed &&
      points.length > 2 &&
      cursor !== null &&
      first !== undefined &&
      distance(first, cursor) <= metresOf(context, 12);
    const refused =
      this.closed &&
      cursor !== null &&
      !closing &&
      last !== undefined &&
      distance(last, cursor) > 1e-6 &&
      !canExtend(points, cursor);
    const { thickness } = this.width(context);
    const length = cursor && last ? distance(last, cursor) : 0;
    return {
      preview: { kind: "line", points, cursor, thickness, closing, refused, closed: this.closed },
      ...(cursor && length > 0 ? { label: { text: `${fixed(length, 2)} m`, at: cursor } } : {}),
    };
  }
}

/** The way of a moving obstacle: a person's pace and size at first. */
export class MovingTool extends LineTool {
  protected override readonly closed = false;

  protected override width(): { thickness: number } {
    return { thickness: PERSON.size[1] };
  }

  protected override made(scene: Scene, points: Point[]): Made {
    return { ...addMoving(scene, { points, ...PERSON }), kind: "moving", label: "moving" };
  }
}

export class WallTool extends LineTool {
  protected override readonly closed = false;

  protected override made(scene: Scene, points: Point[], { wallThickness: thickness }: ToolOptions): Made {
    return { ...addObstacle(scene, { type: "wall", points, thickness }), kind: "obstacle", label: "wall" };
  }
}

/** The middle line of a road. */
export class RoadTool extends LineTool {
  protected override readonly closed = false;

  protected override width(context: ToolContext): { thickness: number } {
    const { lanes, laneWidth } = context.store.state.toolOptions.road;
    return { thickness: (lanes[0] + lanes[1]) * laneWidth };
  }

  /** A bend that is too tight is taken back, with what follows. */
  protected override mends(context: ToolContext): boolean {
    const { points } = this,
      tight = tooTight({ type: "road", points, ...context.store.state.toolOptions.road });
    if (points.length < 2 || tight <= 0) return false;
    context.store.set({ message: { tone: "err", text: word(context.store.state, "tight") } });
    this.points = points.slice(0, tight + 1);
    return true;
  }

  protected override made(scene: Scene, points: Point[], { road }: ToolOptions): Made {
    return { ...addObstacle(scene, { type: "road", points, ...road }), kind: "obstacle", label: "road" };
  }
}

export class PolygonTool extends LineTool {
  protected override readonly closed = true;

  protected override mends(context: ToolContext): boolean {
    if (!crossesItself(this.points)) return false;
    this.refuse(context);
    return true;
  }

  protected override made(scene: Scene, points: Point[]): Made {
    return { ...addObstacle(scene, { type: "polygon", points }), kind: "obstacle", label: "polygon" };
  }
}
