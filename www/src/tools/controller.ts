/** Pointers and keys of all canvases, handed to the tool in force. */
import type { Scene, State, Store } from "../store";
import { cameraFor, forgetFit, leastScale, zoomAt, type View } from "../view/camera";
import { distance, type Point } from "../scene/geometry";
import type { Draft } from "../store/draft";
import { Fingers } from "./fingers";
import { inputOf, keyedInput, viewOf } from "./input";
import { arrowOf, stepOf } from "./arrow-keys";
import type { ToolContext, Input, Tool } from "./tool";
import { ToolInForce } from "./tool-in-force";
import { turnOf } from "./wheel";

/** A second finger within this time takes back what the first one drew: it was meant to be a pinch. */
const STRAY_MS = 120;

/** A right click moves less than this. */
const CLICK_PX = 4;
/** Of a press by keys. */
const KEYS = -1;

/** Place at which a canvas asks for its menu, CSS pixels of the window. */
export interface MenuRequest {
  x: number;
  y: number;
  at: Point;
}

interface Press {
  pointer: number;
  tool: Tool;
  input: Input;
  since: number;
}

export class ToolController {
  /** Which wheel turns zoom: embedded pages keep plain ones for scrolling. */
  wheel: "always" | "ctrl" | "none" = "always";

  private readonly inForce: ToolInForce;
  private press: Press | null = null;
  /** The tool of the last press. */
  private pressed: Tool | null = null;
  /** The drag's move of this frame that was taken at once. */
  private early: PointerEvent | null = null;
  private readonly fingers = new Fingers();
  /** Start of the last right press; its click asks for the menu. */
  private rightAt: Point | null = null;
  /** Position of the keyboard's pointer. */
  private keyed: Point | null = null;
  /** The canvas last used, and the last input on it. */
  private canvas: HTMLElement | null = null;
  private last: Input | null = null;

  constructor(private readonly store: Store) {
    this.inForce = new ToolInForce(store, () => this.refresh());
    store.subscribe((state, previous) => this.toolChanged(state, previous));
  }

  fetchTools(): Promise<void> {
    return this.inForce.fetch();
  }

  /** True if this is the canvas that the pointer, or else the focus, is on. */
  isAt(canvas: HTMLElement | null): boolean {
    return canvas === this.canvas;
  }

  attach(canvas: HTMLElement): () => void {
    const events = new AbortController();
    this.canvas ??= canvas;
    const on = <K extends keyof HTMLElementEventMap>(
      type: K,
      handler: (event: HTMLElementEventMap[K]) => void,
      passive = true,
      isMove = false,
    ): void =>
      canvas.addEventListener(type, (event) => this.store.batch(() => handler(event), isMove), {
        signal: events.signal,
        passive,
      });
    on("pointerdown", (event) => this.pointerDown(canvas, event), false);
    on("pointerrawupdate", (event) => this.pointerEarly(canvas, event as PointerEvent), true, true);
    on("pointermove", (event) => this.pointerFrame(canvas, event), true, true);
    on("pointerup", (event) => this.pointerUp(canvas, event));
    on("pointercancel", (event) => this.pointerUp(canvas, event));
    on("lostpointercapture", (event) => this.pointerUp(canvas, event));
    on("pointerleave", (event) => this.leave(event.pointerType === "touch"));
    on("dblclick", (event) => {
      // The second press may have ended a shape and handed over to another tool.
      if (this.pressed === this.inForce.now())
        this.pressed.doubleClick?.(this.context(), inputOf(canvas, this.store.state, event));
    });
    on("contextmenu", (event) => this.menuAsked(canvas, event), false);
    on("focus", () => {
      this.canvas = canvas;
    });
    on("wheel", (event) => this.wheelTurned(canvas, event), false, true);
    const blur = (): void => this.endPress();
    globalThis.addEventListener("blur", blur, { signal: events.signal });
    return () => {
      events.abort();
      if (this.canvas === canvas) this.canvas = null;
    };
  }

  /** Shows start, goal and the plans as they are now. */
  fit(): void {
    forgetFit(this.store.state.scene);
    this.store.set({ camera: null, follow: false });
  }

  /** Zooms about the middle of the map. */
  zoom(factor: number): void {
    const view = this.view();
    this.store.set({
      camera: zoomAt(view, view.width / 2, view.height / 2, factor, leastScale(this.store.state.scene.map)),
    });
  }

  /** True where the key was used; the caller then prevents its default. Takes keydown and keyup. */
  handleKey(event: KeyboardEvent): boolean {
    if (event.type === "keyup") return this.inForce.releaseSpace(event.key);
    if (event.ctrlKey || event.metaKey) return false;
    if (event.key === "Escape") return this.escape();
    if (this.drawByKey(event)) return true;
    if (event.key === "Enter") return this.inForce.now().confirm?.(this.context()) ?? false;
    if (event.key === " ") return this.inForce.holdSpace();
    const way = arrowOf(event.key);
    return way !== undefined && this.edit((store) => this.inForce.drawing?.nudge(store, way, event.shiftKey) ?? false);
  }

  /** Changes something by a key or a menu; false where there was nothing to change. */
  edit(change: (store: Store) => boolean): boolean {
    return change(this.store) && this.refresh();
  }

  private pointerDown(canvas: HTMLElement, event: PointerEvent): void {
    this.canvas = canvas;
    this.keyed = null;
    const input = inputOf(canvas, this.store.state, event);
    canvas.setPointerCapture(event.pointerId);
    if (event.pointerType === "pen") this.store.set({ penSeen: true });
    if (event.pointerType === "touch" && this.fingers.press(event.pointerId, input.pixel, event.timeStamp) > 1)
      return this.beginPinch(event.timeStamp);
    if (this.press || this.fingers.pinching) return;
    const tool = (this.pressed = this.inForce.forPress(event));
    if (event.button === 1) event.preventDefault();
    this.rightAt = event.button === 2 ? input.pixel : null;
    this.press = { pointer: event.pointerId, tool, input, since: event.timeStamp };
    if (event.pointerType === "touch")
      this.fingers.whenLong(event.pointerId, input.pixel, () => this.longPress(canvas, event));
    tool.down?.(this.context(), input);
    this.setCursor(tool, input);
  }

  /**
   * Browsers hold moves back until the next frame; a drag's first one is taken at once, so that its plans make that
   * frame.
   */
  private pointerEarly(canvas: HTMLElement, event: PointerEvent): void {
    if (this.early || this.press?.pointer !== event.pointerId) return;
    this.early = event;
    this.pointerMove(canvas, event);
  }

  private pointerFrame(canvas: HTMLElement, event: PointerEvent): void {
    const { early } = this;
    this.early = null;
    const isKnown =
      early !== null &&
      early.pointerId === event.pointerId &&
      event.getCoalescedEvents().length <= 1 &&
      early.clientX === event.clientX &&
      early.clientY === event.clientY;
    if (!isKnown) this.pointerMove(canvas, event);
  }

  private pointerMove(canvas: HTMLElement, event: PointerEvent): void {
    if (!this.press) this.canvas = canvas;
    this.keyed = null;
    const input = inputOf(canvas, this.store.state, event);
    this.fingers.move(event.pointerId, input.pixel);
    if (this.fingers.pinching) return this.movePinch();
    this.last = input;
    const { press } = this;
    if (press && press.pointer !== event.pointerId) return;
    if (press) {
      press.input = input;
      press.tool.move?.(this.context(), input);
    } else this.inForce.now().hover?.(this.context(), input);
    this.store.set({ hover: { x: input.at[0], y: input.at[1] } });
    this.setCursor(press?.tool ?? this.inForce.now(), input);
  }

  private pointerUp(canvas: HTMLElement, event: PointerEvent): void {
    const tapped =
      event.type === "pointerup" && this.store.state.tool === "select" && this.fingers.rests(event.pointerId);
    if (this.fingers.release(event.pointerId, event.timeStamp)) this.store.undo();
    if (this.press?.pointer !== event.pointerId) return;
    // A cancelled pointer carries no position worth drawing to.
    if (event.type === "pointerup") this.press.input = inputOf(canvas, this.store.state, event);
    const [x, y] = this.press.input.at;
    this.endPress();
    // A finger does not hover: a tap tells what is there.
    if (event.pointerType === "touch") this.store.set({ hover: tapped ? { x, y } : null });
  }

  private endPress(): void {
    const { press } = this;
    if (!press) return;
    this.press = null;
    press.tool.up?.(this.context(), press.input);
    this.inForce.ended(press.tool);
    this.setCursor(this.inForce.now(), this.last);
  }

  private leave(lifted: boolean): void {
    if (this.press) return;
    this.last = null;
    this.inForce.now().hover?.(this.context(), null);
    if (!lifted) this.store.set({ hover: null });
  }

  private beginPinch(now: number): void {
    const { press } = this;
    this.press = null;
    if (press && now - press.since < STRAY_MS) press.tool.cancel?.(this.context());
    else if (press) press.tool.up?.(this.context(), press.input);
    this.store.set({ hover: null });
  }

  private movePinch(): void {
    const camera = this.fingers.moved(this.view(), leastScale(this.store.state.scene.map));
    if (camera) this.store.set({ camera });
  }

  /** Takes back what the finger began. */
  private longPress(canvas: HTMLElement, event: PointerEvent): void {
    const { press } = this;
    this.press = null;
    press?.tool.cancel?.(this.context());
    this.inForce.select.pick(this.context(), inputOf(canvas, this.store.state, event));
    this.askForMenu(canvas, event.clientX, event.clientY);
  }

  private menuAsked(canvas: HTMLElement, event: MouseEvent): void {
    event.preventDefault();
    const { tool } = this.store.state,
      input = inputOf(canvas, this.store.state, event),
      from = this.rightAt;
    // Fingers that rest are told apart from drawing ones elsewhere.
    if ((event as PointerEvent).pointerType === "touch" || (tool !== "select" && tool !== "hand")) return;
    if (from && distance(from, input.pixel) > CLICK_PX) return;
    this.inForce.select.pick(this.context(), input);
    this.askForMenu(canvas, event.clientX, event.clientY);
  }

  private askForMenu(canvas: HTMLElement, x: number, y: number): void {
    const { at } = inputOf(canvas, this.store.state, new MouseEvent("contextmenu", { clientX: x, clientY: y }));
    canvas.dispatchEvent(
      new CustomEvent<MenuRequest>("parkade-menu", { detail: { x, y, at }, bubbles: true, composed: true }),
    );
  }

  /** Arrows move the pointer of a drawing tool, Enter presses and releases it. */
  private drawByKey(event: KeyboardEvent): boolean {
    const { state } = this.store,
      way = arrowOf(event.key);
    if (
      !this.canvas ||
      state.tool === "select" ||
      state.tool === "hand" ||
      (!way && (event.key !== "Enter" || !this.keyed))
    )
      return false;
    const view = this.view(),
      { map } = state.scene,
      step = stepOf(map, event.shiftKey);
    // The first arrow puts it on a corner of the lattice in the middle of the view.
    const from =
      this.keyed ??
      (state.hover ? ([state.hover.x, state.hover.y] as Point) : onLattice(map, [view.camera.x, view.camera.y]));
    const at: Point = way ? [from[0] + way[0] * step, from[1] + way[1] * step] : from;
    this.keyed = at;
    const input = keyedInput(view, at),
      tool = this.inForce.now();
    this.last = input;
    if (!way) this.pressByKey(tool, input);
    else if (this.press) {
      this.press.input = input;
      tool.move?.(this.context(), input);
    } else tool.hover?.(this.context(), input);
    this.store.set({ hover: { x: at[0], y: at[1] } });
    return true;
  }

  private pressByKey(tool: Tool, input: Input): void {
    if (this.press) return this.endPress();
    this.press = { pointer: KEYS, tool, input, since: performance.now() };
    tool.down?.(this.context(), input);
    if (!tool.drags) this.endPress();
  }

  private wheelTurned(canvas: HTMLElement, event: WheelEvent): void {
    if (this.wheel === "none" || (this.wheel === "ctrl" && !event.ctrlKey)) return;
    event.preventDefault();
    if (!this.press) this.canvas = canvas;
    const input = inputOf(canvas, this.store.state, event);
    const { notches, factor } = turnOf(event);
    if (this.inForce.now().wheel?.(this.context(), input, notches)) return;
    this.store.set({
      camera: zoomAt(this.view(), input.pixel[0], input.pixel[1], factor, leastScale(this.store.state.scene.map)),
    });
  }

  private escape(): boolean {
    const { press } = this;
    this.press = null;
    const { armed, drawing } = this.inForce;
    if (armed) {
      drawing?.place[armed].cancel(this.context());
      this.inForce.armed = null;
      return this.refresh();
    }
    if ((press?.tool ?? this.inForce.now()).cancel?.(this.context())) return this.refresh();
    if (this.store.state.selection) this.store.set({ selection: null });
    else if (this.store.state.tool !== "select") this.store.set({ tool: "select" });
    else return false;
    return true;
  }

  /** The next press places this pose. */
  arm(which: "start" | "goal"): boolean {
    this.inForce.armed = which;
    void this.fetchTools();
    return this.refresh();
  }

  private toolChanged(state: State, previous: State): void {
    if (state.tool === previous.tool) return;
    this.inForce.called(previous.tool).cancel?.(this.context());
    this.press = null;
    this.inForce.armed = null;
    this.keyed = null;
    this.refresh();
  }

  /** Draws the preview of the tool in force again where the pointer rests. */
  private refresh(): true {
    if (!this.press) {
      this.show(null);
      this.inForce.now().hover?.(this.context(), this.last);
    }
    this.setCursor(this.press?.tool ?? this.inForce.now(), this.last);
    return true;
  }

  private show(draft: Draft | null): void {
    this.store.set({ draft });
  }

  private setCursor(tool: Tool, input: Input | null): void {
    if (this.canvas) this.canvas.style.cursor = tool.cursor(this.context(), input);
  }

  /** Of the map that the pointer or the focus was on last. */
  view(): View {
    return this.canvas
      ? viewOf(this.canvas, this.store.state)
      : { camera: cameraFor(this.store.state, 1, 1), width: 1, height: 1 };
  }

  private context(): ToolContext {
    const { store } = this;
    return {
      store,
      view: this.view(),
      canvas: this.canvas,
      show: (draft) => this.show(draft),
      preview: (scene: Scene) => store.edit(scene, { transient: true }),
      commit: (scene: Scene, label: string) => {
        if (scene !== store.state.scene || store.state.transient) store.edit(scene, { label });
      },
      revert: () => {
        store.cancelEdit();
      },
      done: () => {
        if (!store.state.toolOptions.locked) store.set({ tool: "select" });
      },
    };
  }
}

const onLattice = ({ origin, resolution }: Scene["map"], [x, y]: Point): Point => [
  origin[0] + Math.round((x - origin[0]) / resolution) * resolution,
  origin[1] + Math.round((y - origin[1]) / resolution) * resolution,
];
