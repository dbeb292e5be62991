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
import { metresOf, reachOf, type Bench, type Input, type Tool } from "./tool";
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

  cursor(bench: Bench, input: Input | null): string {
    const side = this.press?.side ?? (input && sideAt(bench, input));
    return side ? (axisOf(side) === 0 ? "ew-resize" : "ns-resize") : this.select.cursor(bench, input);
  }

  hover(bench: Bench, input: Input | null): void {
    const hot = input && !input.touch ? sideAt(bench, input) : null;
    this.select.hover(this.beside(bench, input, hot), hot ? null : input);
  }

  down(bench: Bench, input: Input): void {
    const { state } = bench.store,
      side = input.touch && !this.isChosen(bench) ? null : sideAt(bench, input);
    this.chosen = false;
    if (!side) return this.select.down(this.beside(bench, null, null), input);
    const { scene } = state,
      follows = state.follow && !state.camera;
    if (follows) bench.store.set({ camera: bench.view.camera });
    this.press = {
      side,
      scene,
      room: roomOf(scene, side),
      by: coordinateOf(groundOf(scene), side) - input.at[axisOf(side)],
      next: scene,
      stopped: false,
      follows,
    };
    bench.show({ border: { scene, hot: side, drags: true, canvas: bench.canvas } });
  }

  move(bench: Bench, input: Input): void {
    const { press } = this;
    if (!press) return this.select.move(bench, input);
    const { side, scene, room } = press,
      wanted = input.at[axisOf(side)] + press.by,
      at = placed(bench, input, press, wanted);
    press.next = moveSide(scene, side, at);
    const inward = outward(side) * (wanted - at) < 0,
      stopped = Math.abs(wanted - at) > 2 * Math.max(STEP, scene.map.resolution);
    if (stopped !== press.stopped)
      bench.store.set({ message: stopped ? { tone: "warn", text: stopText(bench.store.state, room, inward) } : null });
    press.stopped = stopped;
    const { id } = room.inner,
      found = stopped && inward && id !== null && findThing(scene, id);
    bench.show({
      border: { scene: press.next, hot: side, drags: true, canvas: bench.canvas },
      ...(found ? { hot: { kind: found.kind, id } } : {}),
    });
    keepFit(scene.map, press.next.map);
    // Very many cells follow when the drag ends.
    if (countRuns(scene) <= MANY) bench.preview(press.next);
  }

  up(bench: Bench, input: Input): void {
    const { press } = this;
    this.press = null;
    if (!press) {
      this.select.up(bench, input);
      this.chosen = input.touch && bench.store.state.tool === "select";
      return this.hover(bench, input);
    }
    if (!isInView(bench, press.next)) forgetFit(press.next);
    bench.commit(press.next, "ground");
    this.release(bench, press);
    this.chosen = input.touch;
    this.hover(bench, input);
  }

  doubleClick(bench: Bench, input: Input): void {
    editVertex(bench, input);
  }

  confirm(bench: Bench): boolean {
    return this.select.confirm(bench);
  }

  cancel(bench: Bench): boolean {
    const { press } = this;
    this.press = null;
    this.chosen = false;
    if (!press) return this.select.cancel(bench);
    bench.revert();
    this.release(bench, press);
    bench.show(null);
    return true;
  }

  private isChosen({ store }: Bench): boolean {
    return this.chosen && store.state.selection === null;
  }

  private release({ store }: Bench, { follows }: Press): void {
    if (follows) store.set({ camera: null });
  }

  /** What selects shows what it shows, and the handles with it. */
  private beside(bench: Bench, input: Input | null, hot: Side | null): Bench {
    const isNear = hot !== null || this.isChosen(bench) || (input !== null && !input.touch && isBeside(bench, input));
    return isNear
      ? {
          ...bench,
          show: (draft) =>
            bench.show({
              ...draft,
              border: { scene: bench.store.state.scene, hot, drags: false, canvas: bench.canvas },
            }),
        }
      : bench;
  }
}

/** Cars, their grips and those of what is selected come before the border. */
function sideAt(bench: Bench, input: Input): Side | null {
  const { scene } = bench.store.state,
    reach = reachOf(input);
  const found = handlesOn(scene, bench.view).find(
    ({ at: [x, y] }) => Math.max(Math.abs(x - input.pixel[0]), Math.abs(y - input.pixel[1])) <= reach,
  );
  if (!found) return null;
  const hit = hitAt(bench, input, null);
  if (hit?.part !== "object") return hit ? null : found.side;
  const { selection } = hit,
    thing = "id" in selection ? findThing(scene, selection.id)?.thing : null;
  const isCar = !thing || ("kind" in thing ? thing.occupied : !("type" in thing) || thing.type === "car");
  return isCar ? null : found.side;
}

const isBeside = (bench: Bench, { at }: Input): boolean =>
  distanceToPolyline(at, mapOutline(bench.store.state.scene), true) <= metresOf(bench, NEAR_PX);

/** On whole cells where cells are painted, else at whole decimetres of the size; never past what stops it. */
function placed(bench: Bench, input: Input, { side, scene, room }: Press, wanted: number): number {
  const sign = outward(side),
    { map } = scene,
    box = groundOf(scene),
    now = sign * coordinateOf(box, side);
  const isGrid = [...(scene.obstacles ?? []), ...(scene.costs ?? [])].some((one) => "runs" in one);
  const from = sign * (isGrid ? map.origin[axisOf(side)] : coordinateOf(box, opposite(side)));
  const step = !snaps(bench, input) ? 0.001 : isGrid ? map.resolution : STEP;
  const least = Math.min(now, from + Math.ceil((sign * room.inner.at - from) / step - 1e-6) * step);
  const at = Math.min(sign * room.outer, Math.max(least, from + Math.round((sign * wanted - from) / step) * step));
  return (sign * Math.round(at * 1e6)) / 1e6;
}

/** True if a fit to the view as it is would still show the whole ground. */
function isInView(bench: Bench, scene: Scene): boolean {
  const { width, height } = bench.view,
    camera = cameraFor({ ...bench.store.state, scene }, width, height);
  return mapOutline(scene)
    .map((p) => worldToScreen({ camera, width, height }, ...p))
    .every(([x, y]) => x >= 0 && y >= 0 && x <= width && y <= height);
}
