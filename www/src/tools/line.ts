/** Walls, roads and polygons: corner after corner. */
import { addMoving, addObstacle } from "../scene/model";
import { canExtend, crossesItself, distance, type Point } from "../scene/geometry";
import { tooTight } from "../scene/road";
import { fixed } from "../view/text";
import type { Scene, ToolOptions } from "../store";
import type { Draft } from "../store/draft";
import { constrainAngle, snapPoint, type Snapped } from "./snap";
import { metresOf, reachOf, type Bench, type Input, type Tool } from "./tool";
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
  protected mends(_: Bench): boolean {
    return false;
  }

  /** Of the preview's line, metres. */
  protected width(bench: Bench): { thickness: number } {
    return { thickness: this.closed ? 0 : bench.store.state.toolOptions.wallThickness };
  }

  cursor(): string {
    return "crosshair";
  }

  hover(bench: Bench, input: Input | null): void {
    if (!input) bench.show(this.points.length > 0 ? this.draft(bench, null) : null);
    else if (!input.touch) this.showAim(bench, input);
  }

  down(bench: Bench, input: Input): void {
    this.twice = this.before !== null && distance(this.before, input.pixel) <= TWICE_PX;
    this.before = this.pressed = input.pixel;
    const { at } = this.aim(bench, input);
    if (this.closes(bench, input, at) || this.repeats(bench, input, at)) {
      this.finish(bench);
      return;
    }
    this.add(bench, at);
  }

  move(bench: Bench, input: Input): void {
    this.showAim(bench, input);
  }

  /** A drag draws one edge; a wall is complete then. */
  up(bench: Bench, input: Input): void {
    const dragged = this.pressed !== null && distance(this.pressed, input.pixel) > DRAG_PX;
    this.pressed = null;
    if (!dragged || this.points.length === 0) return;
    this.add(bench, this.aim(bench, input).at);
    if (!this.closed && this.points.length === 2) this.finish(bench);
  }

  /** Quick presses in different places are corners. */
  doubleClick(bench: Bench): void {
    if (this.twice) this.finish(bench);
  }

  confirm(bench: Bench): boolean {
    return this.points.length > 0 && this.finish(bench);
  }

  cancel(bench: Bench): boolean {
    const drawing = this.points.length > 0;
    this.reset(bench);
    return drawing;
  }

  /** Adds the line to the scene; an open one that is too short is dropped. */
  private finish(bench: Bench): boolean {
    const { points } = this,
      { store } = bench,
      { scene, toolOptions } = store.state;
    if (this.closed && points.length < 3) return false;
    if (this.mends(bench)) return true;
    this.reset(bench);
    if (points.length < 2) return false;
    const { scene: next, id, kind, label } = this.made(scene, points, toolOptions);
    bench.commit(next, label);
    store.set({ selection: { kind, id } });
    bench.done();
    return true;
  }

  private reset(bench: Bench): void {
    this.points = [];
    this.pressed = this.before = null;
    bench.show(null);
  }

  protected refuse(bench: Bench): void {
    bench.store.set({ message: { tone: "err", text: word(bench.store.state, "crosses") } });
  }

  private add(bench: Bench, at: Point): void {
    const last = this.points.at(-1);
    if (last && distance(last, at) < 1e-6) return;
    if (this.closed && !canExtend(this.points, at)) return this.refuse(bench);
    this.points = [...this.points, at];
    bench.show(this.draft(bench, at));
  }

  private aim(bench: Bench, input: Input): Snapped {
    const last = this.points.at(-1);
    return input.shift && last ? { at: constrainAngle(last, input.at), guides: [] } : snapPoint(bench, input);
  }

  private showAim(bench: Bench, input: Input): void {
    const { at, guides } = this.aim(bench, input);
    bench.show({ ...this.draft(bench, at), guides });
  }

  /** Fingers and keys have no double click: a press on the last corner ends the line. */
  private repeats(bench: Bench, input: Input, at: Point): boolean {
    const last = this.points.at(-1),
      reach = input.keyed ? 1e-6 : input.touch ? metresOf(bench, reachOf(input)) : -1;
    return last !== undefined && distance(last, at) <= reach;
  }

  private closes(bench: Bench, input: Input, at: Point): boolean {
    const first = this.points[0];
    return (
      this.closed &&
      this.points.length > 2 &&
      first !== undefined &&
      distance(first, at) <= metresOf(bench, reachOf(input))
    );
  }

  private draft(bench: Bench, cursor: Point | null): Draft {
    const { points } = this;
    const last = points.at(-1),
      first = points[0];
    const closing =
      this.closed &&
      points.length > 2 &&
      cursor !== null &&
      first !== undefined &&
      distance(first, cursor) <= metresOf(bench, 12);
    const refused =
      this.closed &&
      cursor !== null &&
      !closing &&
      last !== undefined &&
      distance(last, cursor) > 1e-6 &&
      !canExtend(points, cursor);
    const { thickness } = this.width(bench);
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

  protected override width(bench: Bench): { thickness: number } {
    const { lanes, laneWidth } = bench.store.state.toolOptions.road;
    return { thickness: (lanes[0] + lanes[1]) * laneWidth };
  }

  /** A bend that is too tight is taken back, with what follows. */
  protected override mends(bench: Bench): boolean {
    const { points } = this,
      tight = tooTight({ type: "road", points, ...bench.store.state.toolOptions.road });
    if (points.length < 2 || tight <= 0) return false;
    bench.store.set({ message: { tone: "err", text: word(bench.store.state, "tight") } });
    this.points = points.slice(0, tight + 1);
    return true;
  }

  protected override made(scene: Scene, points: Point[], { road }: ToolOptions): Made {
    return { ...addObstacle(scene, { type: "road", points, ...road }), kind: "obstacle", label: "road" };
  }
}

export class PolygonTool extends LineTool {
  protected override readonly closed = true;

  protected override mends(bench: Bench): boolean {
    if (!crossesItself(this.points)) return false;
    this.refuse(bench);
    return true;
  }

  protected override made(scene: Scene, points: Point[]): Made {
    return { ...addObstacle(scene, { type: "polygon", points }), kind: "obstacle", label: "polygon" };
  }
}
