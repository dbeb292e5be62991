/** Pointers and keys of all canvases, handed to the tool in force. */
import type { Scene, State, Store, ToolId } from "../store";
import { cameraFor, forgetFit, leastScale, screenToWorld, zoomAt, type View } from "../view/camera";
import type { Point } from "../scene/plane";
import type { Draft } from "./draft";
import type { Drawing } from "./drawing";
import { HandTool } from "./hand";
import { editByKey, toolOfKey } from "./keys";
import { Pinch } from "./pinch";
import { SelectTool } from "./select";
import type { Bench, Input, Tool } from "./tool";

export type { Draft } from "./draft";

/** A second finger within this time takes back what the first one drew: it was meant to be a pinch. */
const STRAY_MS = 120;

interface Press { pointer: number; tool: Tool; input: Input; since: number }

export class ToolController {
  draft: Draft | null = null;
  /** Which wheel turns zoom: embedded pages keep plain ones for scrolling. */
  wheel: "always" | "ctrl" | "none" = "always";

  private readonly select = new SelectTool();
  private readonly hand = new HandTool();
  /** All other tools; null until they are fetched. */
  private drawing: Drawing | null = null;
  /** Set by S or T: the next press places that pose. */
  private armed: "start" | "goal" | null = null;
  private spaceDown = false;
  private press: Press | null = null;
  /** The drag's move of this frame that was taken at once. */
  private early: PointerEvent | null = null;
  private pinch: Pinch | null = null;
  private readonly fingers = new Map<number, Point>();
  private readonly listeners = new Set<(draft: Draft | null) => void>();
  /** The canvas last used, and the last input on it. */
  private canvas: HTMLElement | null = null;
  private last: Input | null = null;

  constructor(private readonly store: Store) {
    store.subscribe((state, previous) => this.toolChanged(state, previous));
  }

  /** The first picture does without the tools that draw. */
  async fetchTools(): Promise<void> {
    if (this.drawing) return;
    const { makeDrawing } = await import("./drawing");
    this.drawing ??= makeDrawing();
    this.refresh();
  }

  onDraft(listener: (draft: Draft | null) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  attach(canvas: HTMLElement): () => void {
    const events = new AbortController();
    const on = <K extends keyof HTMLElementEventMap>(type: K, handler: (event: HTMLElementEventMap[K]) => void, passive = true): void =>
      canvas.addEventListener(type, handler, { signal: events.signal, passive });
    on("pointerdown", (event) => this.pointerDown(canvas, event), false);
    on("pointerrawupdate", (event) => this.pointerEarly(canvas, event as PointerEvent));
    on("pointermove", (event) => this.pointerFrame(canvas, event));
    on("pointerup", (event) => this.pointerUp(canvas, event));
    on("pointercancel", (event) => this.pointerUp(canvas, event));
    on("lostpointercapture", (event) => this.pointerUp(canvas, event));
    on("pointerleave", () => this.leave());
    on("dblclick", (event) => this.tool().doubleClick?.(this.bench(), this.inputOf(canvas, event)));
    on("contextmenu", (event) => event.preventDefault(), false);
    on("wheel", (event) => this.wheelTurned(canvas, event), false);
    const blur = (): void => this.endPress();
    globalThis.addEventListener("blur", blur, { signal: events.signal });
    return () => events.abort();
  }

  /** Shows start, goal and the plans as they are now. */
  fit(): void {
    forgetFit(this.store.state.scene);
    this.store.set({ camera: null });
  }

  /** True where the key was used; the caller then prevents its default. Takes keydown and keyup. */
  handleKey(event: KeyboardEvent): boolean {
    if (event.type === "keyup") return this.keyUp(event);
    if (event.ctrlKey || event.metaKey) return false;
    const key = event.key.toLowerCase();
    if (key === "escape") return this.escape();
    if (key === "enter") return this.tool().confirm?.(this.bench()) ?? false;
    if (key === " ") return this.holdSpace();
    if (key === "s" || key === "t") return this.arm(key === "s" ? "start" : "goal");
    if (editByKey(this.store, event)) return this.refresh();
    const tool = toolOfKey(key);
    if (tool) this.store.set({ tool });
    return tool !== undefined;
  }

  private pointerDown(canvas: HTMLElement, event: PointerEvent): void {
    this.canvas = canvas;
    const input = this.inputOf(canvas, event);
    canvas.setPointerCapture(event.pointerId);
    if (event.pointerType === "touch") {
      this.fingers.set(event.pointerId, input.pixel);
      if (this.fingers.size === 2) return this.beginPinch();
    }
    if (this.press || this.pinch) return;
    const tool = this.toolFor(event);
    if (event.button === 1) event.preventDefault();
    this.press = { pointer: event.pointerId, tool, input, since: event.timeStamp };
    tool.down?.(this.bench(), input);
    this.setCursor(tool, input);
  }

  /** Browsers hold moves back until the next frame; a drag's first one is taken at once, so that its plans make that frame. */
  private pointerEarly(canvas: HTMLElement, event: PointerEvent): void {
    if (this.early || this.press?.pointer !== event.pointerId) return;
    this.early = event;
    this.pointerMove(canvas, event);
  }

  private pointerFrame(canvas: HTMLElement, event: PointerEvent): void {
    const { early } = this;
    this.early = null;
    const isKnown = early !== null && early.pointerId === event.pointerId && event.getCoalescedEvents().length <= 1
      && early.clientX === event.clientX && early.clientY === event.clientY;
    if (!isKnown) this.pointerMove(canvas, event);
  }

  private pointerMove(canvas: HTMLElement, event: PointerEvent): void {
    if (!this.press) this.canvas = canvas;
    const input = this.inputOf(canvas, event);
    if (this.fingers.has(event.pointerId)) this.fingers.set(event.pointerId, input.pixel);
    if (this.pinch) return this.movePinch();
    this.last = input;
    const { press } = this;
    if (press && press.pointer !== event.pointerId) return;
    if (press) {
      press.input = input;
      press.tool.move?.(this.bench(), input);
    } else this.tool().hover?.(this.bench(), input);
    this.store.set({ hover: { x: input.at[0], y: input.at[1] } });
    this.setCursor(press?.tool ?? this.tool(), input);
  }

  private pointerUp(canvas: HTMLElement, event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    if (this.fingers.size < 2) this.pinch = null;
    if (this.press?.pointer !== event.pointerId) return;
    // A cancelled pointer carries no position worth drawing to.
    if (event.type === "pointerup") this.press.input = this.inputOf(canvas, event);
    this.endPress();
    if (event.pointerType === "touch") this.store.set({ hover: null });
  }

  private endPress(): void {
    const { press } = this;
    if (!press) return;
    this.press = null;
    press.tool.up?.(this.bench(), press.input);
    if (this.drawing && (press.tool === this.drawing.place.start || press.tool === this.drawing.place.goal)) this.armed = null;
    this.setCursor(this.tool(), this.last);
  }

  private leave(): void {
    if (this.press) return;
    this.last = null;
    this.tool().hover?.(this.bench(), null);
    this.store.set({ hover: null });
  }

  private beginPinch(): void {
    const { press } = this;
    const [a, b] = [...this.fingers.values()] as [Point, Point];
    this.press = null;
    if (press && performance.now() - press.since < STRAY_MS) press.tool.cancel?.(this.bench());
    else if (press) press.tool.up?.(this.bench(), press.input);
    this.pinch = new Pinch(a, b);
    this.store.set({ hover: null });
  }

  private movePinch(): void {
    const [a, b] = [...this.fingers.values()];
    if (a && b && this.pinch) this.store.set({ camera: this.pinch.move(this.view(), a, b, leastScale(this.store.state.scene.map)) });
  }

  private wheelTurned(canvas: HTMLElement, event: WheelEvent): void {
    if (this.wheel === "none" || (this.wheel === "ctrl" && !event.ctrlKey)) return;
    event.preventDefault();
    if (!this.press) this.canvas = canvas;
    const input = this.inputOf(canvas, event);
    const pixels = event.deltaMode === 1 ? event.deltaY * 33 : event.deltaMode === 2 ? event.deltaY * 400 : event.deltaY;
    if (this.tool().wheel?.(this.bench(), input, -Math.sign(pixels) * Math.max(1, Math.round(Math.abs(pixels) / 100)))) return;
    // Pinches on a track pad arrive as small turns with Ctrl.
    const factor = Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0015));
    this.store.set({ camera: zoomAt(this.view(), input.pixel[0], input.pixel[1], Math.min(4, Math.max(0.25, factor)), leastScale(this.store.state.scene.map)) });
  }

  private toolFor(event: PointerEvent): Tool {
    if (event.button === 1 || this.spaceDown) return this.hand;
    const { tool } = this.store.state;
    if (event.button === 2) return tool === "select" || tool === "hand" ? this.hand : this.drawing?.eraser ?? this.hand;
    return this.tool();
  }

  private tool(): Tool {
    if (this.spaceDown) return this.hand;
    const { tool } = this.store.state;
    if (this.armed && this.drawing) return this.drawing.place[this.armed];
    return tool === "select" ? this.select : this.toolCalled(tool);
  }

  private toolCalled(tool: Exclude<ToolId, "select">): Tool {
    if (tool === "hand") return this.hand;
    if (!this.drawing) void this.fetchTools();
    return this.drawing?.tools[tool] ?? this.hand;
  }

  private escape(): boolean {
    const { press } = this;
    this.press = null;
    if (this.armed) {
      this.drawing?.place[this.armed].cancel(this.bench());
      this.armed = null;
      return this.refresh();
    }
    if ((press?.tool ?? this.tool()).cancel?.(this.bench())) return this.refresh();
    if (this.store.state.selection) this.store.set({ selection: null });
    else if (this.store.state.tool !== "select") this.store.set({ tool: "select" });
    else return false;
    return true;
  }

  private arm(which: "start" | "goal"): boolean {
    this.armed = which;
    void this.fetchTools();
    return this.refresh();
  }

  /** The release may reach only the window. */
  private holdSpace(): true {
    if (this.spaceDown) return true;
    this.spaceDown = true;
    const released = new AbortController();
    globalThis.addEventListener("keyup", (event) => {
      if (this.keyUp(event)) released.abort();
    }, { signal: released.signal });
    return this.refresh();
  }

  private keyUp(event: KeyboardEvent): boolean {
    if (event.key !== " " || !this.spaceDown) return false;
    this.spaceDown = false;
    return this.refresh();
  }

  private toolChanged(state: State, previous: State): void {
    if (state.tool === previous.tool) return;
    if (previous.tool === "select") this.select.cancel(this.bench());
    else this.toolCalled(previous.tool).cancel?.(this.bench());
    this.press = null;
    this.armed = null;
    this.refresh();
  }

  /** Draws the preview of the tool in force again where the pointer rests. */
  private refresh(): true {
    if (!this.press) {
      this.show(null);
      this.tool().hover?.(this.bench(), this.last);
    }
    this.setCursor(this.press?.tool ?? this.tool(), this.last);
    return true;
  }

  private show(draft: Draft | null): void {
    if (draft === this.draft) return;
    this.draft = draft;
    for (const listener of [...this.listeners]) listener(draft);
  }

  private setCursor(tool: Tool, input: Input | null): void {
    if (this.canvas) this.canvas.style.cursor = tool.cursor(this.bench(), input);
  }

  private view(): View {
    return this.canvas ? this.viewOf(this.canvas) : { camera: cameraFor(this.store.state, 1, 1), width: 1, height: 1 };
  }

  private bench(): Bench {
    const { store } = this;
    return {
      store,
      view: this.view(),
      show: (draft) => this.show(draft),
      preview: (scene: Scene) => store.edit(scene, { transient: true }),
      commit: (scene: Scene, label: string) => {
        if (scene !== store.state.scene || store.state.transient) store.edit(scene, { label });
      },
      revert: () => { if (store.state.transient) store.undo(); },
      done: () => { if (!store.state.toolOptions.locked) store.set({ tool: "select" }); },
    };
  }

  private inputOf(canvas: HTMLElement, event: MouseEvent): Input {
    const box = canvas.getBoundingClientRect();
    const view = this.viewOf(canvas);
    const pixelOf = (one: MouseEvent): Point => [one.clientX - box.left, one.clientY - box.top];
    const worldOf = (one: MouseEvent): Point => screenToWorld(view, ...pixelOf(one));
    const coalesced = event instanceof PointerEvent ? event.getCoalescedEvents?.() ?? [] : [];
    const at = worldOf(event);
    return {
      at,
      pixel: pixelOf(event),
      trail: [...coalesced.map(worldOf), at],
      shift: event.shiftKey,
      alt: event.altKey,
      ctrl: event.ctrlKey || event.metaKey,
      touch: event instanceof PointerEvent && event.pointerType === "touch",
    };
  }

  private viewOf(canvas: HTMLElement): View {
    const width = canvas.clientWidth, height = canvas.clientHeight;
    return { camera: cameraFor(this.store.state, width, height), width, height };
  }
}
