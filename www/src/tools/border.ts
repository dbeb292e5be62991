/** The ground's border: handles on its sides, beside what selects. */
import { stopText } from "../texts/ground-limit";
import {
  axisOf,
  coordinateOf,
  groundOf,
  moveSide,
  opposite,
  outward,
  roomOf,
  type Room,
  type Side,
} from "../scene/ground";
import { distanceToPolyline } from "../scene/geometry";
import { mapOutline, type Scene } from "../scene/model";
import { findThing } from "../scene/scene-objects";
import { countRuns, MANY } from "../scene/large-scene";
import { cameraFor, forgetFit, keepFit, worldToScreen } from "../view/camera";
import { handlesOn } from "../view/border-handles";
import { hitAt } from "./hit";
import type { SelectTool } from "./select";
import { snaps } from "./snap";
import { metresOf, reachOf, type ToolContext, type Input, type Tool } from "./tool";
import { editVertex } from "./vertices";

/** Handles are shown to a pointer this near to the border, CSS pixels. */
const NEAR_PX = 64;
/** Metres of a size. */
const STEP = 0.1;

/** `by` is from the pointer to the side; `next` what a release makes of it. */
interface Press {
  side: Side;
  scene: Scene;
  room: Room;
  by: number;
  next: Scene;
  stopped: boolean;
  follows: boolean;
}

export class BorderTool implements Tool {
  private press: Press | null = null;
  /** A press on free ground chose it: where pointers do not hover, handles come with that. */
  private chosen = false;

  constructor(private readonly select: SelectTool) {}

  cursor(context: ToolContext, input: Input | null): string {
    const side = this.press?.side ?? (input && sideAt(context, input));
    return side ? (axisOf(side) === 0 ? "ew-resize" : "ns-resize") : this.select.cursor(context, input);
  }

  hover(context: ToolContext, input: Input | null): void {
    const hot = input && !input.touch ? sideAt(context, input) : null;
    this.select.hover(this.beside(context, input, hot), hot ? null : input);
  }

  down(context: ToolContext, input: Input): void {
    const { state } = context.store,
      side = input.touch && !this.isChosen(context) ? null : sideAt(context, input);
    this.chosen = false;
    if (!side) return this.select.down(this.beside(context, null, null), input);
    const { scene } = state,
      follows = state.follow && !state.camera;
    if (follows) context.store.set({ camera: context.view.camera });
    this.press = {
      side,
      scene,
      room: roomOf(scene, side),
      by: coordinateOf(groundOf(scene), side) - input.at[axisOf(side)],
      next: scene,
      stopped: false,
      follows,
    };
    context.show({ border: { scene, hot: side, drags: true, canvas: context.canvas } });
  }

  move(context: ToolContext, input: Input): void {
    const { press } = this;
    if (!press) return this.select.move(context, input);
    const { side, scene, room } = press,
      wanted = input.at[axisOf(side)] + press.by,
      at = placed(context, input, press, wanted);
    press.next = moveSide(scene, side, at);
    const inward = outward(side) * (wanted - at) < 0,
      stopped = Math.abs(wanted - at) > 2 * Math.max(STEP, scene.map.resolution);
    if (stopped !== press.stopped)
      context.store.set({
        message: stopped ? { tone: "warn", text: stopText(context.store.state, room, inward) } : null,
      });
    press.stopped = stopped;
    const { id } = room.inner,
      found = stopped && inward && id !== null && findThing(scene, id);
    context.show({
      border: { scene: press.next, hot: side, drags: true, canvas: context.canvas },
      ...(found ? { hot: { kind: found.kind, id } } : {}),
    });
    keepFit(scene.map, press.next.map);
    // Very many cells follow when the drag ends.
    if (countRuns(scene) <= MANY) context.preview(press.next);
  }

  up(context: ToolContext, input: Input): void {
    const { press } = this;
    this.press = null;
    if (!press) {
      this.select.up(context, input);
      this.chosen = input.touch && context.store.state.tool === "select";
      return this.hover(context, input);
    }
    if (!isInView(context, press.next)) forgetFit(press.next);
    context.commit(press.next, "ground");
    this.release(context, press);
    this.chosen = input.touch;
    this.hover(context, input);
  }

  doubleClick(context: ToolContext, input: Input): void {
    editVertex(context, input);
  }

  confirm(context: ToolContext): boolean {
    return this.select.confirm(context);
  }

  cancel(context: ToolContext): boolean {
    const { press } = this;
    this.press = null;
    this.chosen = false;
    if (!press) return this.select.cancel(context);
    context.revert();
    this.release(context, press);
    context.show(null);
    return true;
  }

  private isChosen({ store }: ToolContext): boolean {
    return this.chosen && store.state.selection === null;
  }

  private release({ store }: ToolContext, { follows }: Press): void {
    if (follows) store.set({ camera: null });
  }

  /** What selects shows what it shows, and the handles with it. */
  private beside(context: ToolContext, input: Input | null, hot: Side | null): ToolContext {
    const isNear =
      hot !== null || this.isChosen(context) || (input !== null && !input.touch && isBeside(context, input));
    return isNear
      ? {
          ...context,
          show: (draft) =>
            context.show({
              ...draft,
              border: { scene: context.store.state.scene, hot, drags: false, canvas: context.canvas },
            }),
        }
      : context;
  }
}

/** Cars, their grips and those of what is selected come before the border. */
function sideAt(context: ToolContext, input: Input): Side | null {
  const { scene } = context.store.state,
    reach = reachOf(input);
  const found = handlesOn(scene, context.view).find(
    ({ at: [x, y] }) => Math.max(Math.abs(x - input.pixel[0]), Math.abs(y - input.pixel[1])) <= reach,
  );
  if (!found) return null;
  const hit = hitAt(context, input, null);
  if (hit?.part !== "object") return hit ? null : found.side;
  const { selection } = hit,
    thing = "id" in selection ? findThing(scene, selection.id)?.thing : null;
  const isCar = !thing || ("kind" in thing ? thing.occupied : !("type" in thing) || thing.type === "car");
  return isCar ? null : found.side;
}

const isBeside = (context: ToolContext, { at }: Input): boolean =>
  distanceToPolyline(at, mapOutline(context.store.state.scene), true) <= metresOf(context, NEAR_PX);

/** On whole cells where cells are painted, else at whole decimetres of the size; never past what stops it. */
function placed(context: ToolContext, input: Input, { side, scene, room }: Press, wanted: number): number {
  const sign = outward(side),
    { map } = scene,
    box = groundOf(scene),
    now = sign * coordinateOf(box, side);
  const isGrid = [...(scene.obstacles ?? []), ...(scene.costs ?? [])].some((one) => "runs" in one);
  const from = sign * (isGrid ? map.origin[axisOf(side)] : coordinateOf(box, opposite(side)));
  const step = !snaps(context, input) ? 0.001 : isGrid ? map.resolution : STEP;
  const least = Math.min(now, from + Math.ceil((sign * room.inner.at - from) / step - 1e-6) * step);
  const at = Math.min(sign * room.outer, Math.max(least, from + Math.round((sign * wanted - from) / step) * step));
  return (sign * Math.round(at * 1e6)) / 1e6;
}

/** True if a fit to the view as it is would still show the whole ground. */
function isInView(context: ToolContext, scene: Scene): boolean {
  const { width, height } = context.view,
    camera = cameraFor({ ...context.store.state, scene }, width, height);
  return mapOutline(scene)
    .map((p) => worldToScreen({ camera, width, height }, ...p))
    .every(([x, y]) => x >= 0 && y >= 0 && x <= width && y <= height);
}
