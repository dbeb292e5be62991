/** Surfaces for drawings: the browser's canvases, or the marks of a file. */
import { refused } from "../i18n/refusal";

export interface Surface {
  path(): Path2D;
  canvas(width: number, height: number): HTMLCanvasElement;
}

const screen: Surface = {
  path: () => new Path2D(),
  canvas: (width, height) => Object.assign(document.createElement("canvas"), { width, height }),
};

let surface = screen;

export const newPath = (): Path2D => surface.path();
export const newCanvas = (width: number, height: number): HTMLCanvasElement => surface.canvas(width, height);
/** What draws on a canvas; an error where the browser has nothing that does. */
export function context2d(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext("2d");
  if (!context) throw refused`This browser gives no 2D canvas.`;
  return context;
}
export const onScreen = (): boolean => surface === screen;

/** Runs `draw` with this surface. */
export function drawOn<T>(other: Surface, draw: () => T): T {
  const before = surface;
  surface = other;
  try {
    return draw();
  } finally {
    surface = before;
  }
}

/** A store of what is made of a surface's parts, for each surface its own. */
export function perSurface<T>(make: () => T): () => T {
  const stores = new WeakMap<Surface, T>();
  return () => {
    let store = stores.get(surface);
    if (store === undefined) stores.set(surface, (store = make()));
    return store;
  };
}
