/// <reference path="./gifenc.d.ts" />
/** Moving pictures of canvases: GIF, and WebM or MP4 where the browser encodes video. */
import { applyPalette, GIFEncoder, quantize } from "gifenc";

export const FORMATS = ["gif", "webm", "mp4"] as const;
export type Format = (typeof FORMATS)[number];

export interface Movie {
  format: Format;
  /** CSS pixels, even numbers: video needs them. */
  width: number;
  height: number;
  frames: number;
  /** Frames a second. */
  rate: number;
  /** Draws frame `i` on the canvas. */
  draw(canvas: HTMLCanvasElement, i: number): void;
}

/** Frames whose colours make the palette of a GIF. */
const SAMPLED = 5;
const COLOURS = 255;
/** Work between two breaths of the page, milliseconds. */
const SLICE_MS = 24;

/** Encodes a movie; `tell` is given the share that is done and returns whether to go on. Null where it was stopped. */
export async function encode(movie: Movie, tell: (done: number) => boolean): Promise<Blob | null> {
  if (movie.format === "gif") return encodeGif(movie, tell);
  return (await import("./movie-video")).encodeVideo(movie, movie.format, canvasOf(movie)[0], tell);
}

/** True if this browser encodes the format. */
export async function canEncode(format: Format): Promise<boolean> {
  if (format === "gif") return true;
  if (typeof VideoEncoder === "undefined") return false;
  return (await import("./movie-video")).canEncodeVideo(format);
}

function canvasOf({ width, height }: Movie): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const ctx = canvas.getContext("2d", { willReadFrequently: true });
  if (!ctx) throw new Error("This browser gives no 2D canvas.");
  return [canvas, ctx];
}

/** One palette for all frames; pixels that stay are transparent, so that only what moves takes room. */
async function encodeGif(movie: Movie, tell: (done: number) => boolean): Promise<Blob | null> {
  const { width, height, frames, rate } = movie,
    [canvas, ctx] = canvasOf(movie);
  const pixels = (i: number): Uint8ClampedArray => {
    movie.draw(canvas, i);
    return ctx.getImageData(0, 0, width, height).data;
  };
  const palette = paletteOf(
    Array.from({ length: SAMPLED }, (_, k) => pixels(Math.round((k * (frames - 1)) / (SAMPLED - 1)))),
  );
  const same = palette.length;
  const gif = GIFEncoder();
  let before: Uint8Array | null = null,
    since = performance.now();
  for (let i = 0; i < frames; i++) {
    const indices = applyPalette(pixels(i), palette, "rgb565");
    const shown = before ? without(indices, before, same) : indices;
    gif.writeFrame(shown, width, height, {
      ...(before ? {} : { palette: [...palette, [0, 0, 0]], repeat: 0 }),
      delay: i === frames - 1 ? 1500 : 1000 / rate,
      ...(before && { transparent: true, transparentIndex: same, dispose: 1 }),
    });
    before = indices;
    if (performance.now() - since > SLICE_MS) {
      if (!tell(i / frames)) return null;
      await new Promise((done) => setTimeout(done));
      since = performance.now();
    }
  }
  gif.finish();
  return new Blob([gif.bytes()], { type: "image/gif" });
}

function paletteOf(samples: readonly Uint8ClampedArray[]): number[][] {
  // A quarter of the pixels of each: what is drawn is wider than one.
  const each = samples.map((rgba) => {
    const some = new Uint32Array(rgba.buffer, 0, rgba.length >> 2).filter((_, i) => (i & 3) === 0);
    return new Uint8ClampedArray(some.buffer);
  });
  const all = new Uint8ClampedArray(each.reduce((sum, one) => sum + one.length, 0));
  let at = 0;
  for (const one of each) {
    all.set(one, at);
    at += one.length;
  }
  return quantize(all, COLOURS, { format: "rgb565" });
}

function without(indices: Uint8Array, before: Uint8Array, same: number): Uint8Array {
  const shown = new Uint8Array(indices.length);
  for (let p = 0; p < indices.length; p++) shown[p] = indices[p] === before[p] ? same : indices[p]!;
  return shown;
}
