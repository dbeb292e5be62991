/** Pointer events as world coordinates of the canvas they are on. */
import type { State } from "../store";
import type { Point } from "../scene/geometry";
import { cameraFor, screenToWorld, worldToScreen, type View } from "../view/camera";
import type { Input } from "./tool";

export function viewOf(canvas: HTMLElement, state: State): View {
  const width = canvas.clientWidth,
    height = canvas.clientHeight;
  return { camera: cameraFor(state, width, height), width, height };
}

export function inputOf(canvas: HTMLElement, state: State, event: MouseEvent): Input {
  const box = canvas.getBoundingClientRect();
  const view = viewOf(canvas, state);
  const pixelOf = (one: MouseEvent): Point => [one.clientX - box.left, one.clientY - box.top];
  const worldOf = (one: MouseEvent): Point => screenToWorld(view, ...pixelOf(one));
  const coalesced = event instanceof PointerEvent ? (event.getCoalescedEvents?.() ?? []) : [];
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

/** A place that keys have chosen; it is not moved onto anything. */
export function keyedInput(view: View, at: Point): Input {
  return {
    at,
    pixel: worldToScreen(view, ...at),
    trail: [at],
    shift: false,
    alt: false,
    ctrl: false,
    touch: false,
    keyed: true,
  };
}
