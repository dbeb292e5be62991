/** Moving pictures of canvases: GIF, and WebM or MP4 where the browser encodes video. */
import { GIFEncoder } from "gifenc";
import { nth } from "../scene/nth";
import { ColourTable } from "./colour-table";
import type { Format, Movie } from "./movie-format";
import { refused } from "../i18n/refusal";

/** Frames whose colours make the palette of a GIF. */
const SAMPLED = 5;
/** Work between two breaths of the page, milliseconds. */
const SLICE_MS = 24;
/** How long a GIF rests on its last frame, milliseconds. */
const LAST_MS = 1500;

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
  if (!ctx) throw refused`This browser gives no 2D canvas.`;
  return [canvas, ctx];
}

/** One table of colours for all frames; pixels that stay are transparent, so that only what moves takes room. */
async function encodeGif(movie: Movie, tell: (done: number) => boolean): Promise<Blob | null> {
  const { width, height, frames, rate } = movie,
    [canvas, ctx] = canvasOf(movie);
  const pixels = (i: number): Uint32Array => {
    movie.draw(canvas, i);
    return new Uint32Array(ctx.getImageData(0, 0, width, height).data.buffer);
  };
  const table = new ColourTable(
    Array.from({ length: SAMPLED }, (_, k) => pixels(Math.round((k * (frames - 1)) / (SAMPLED - 1)))),
  );
  const same = table.colours.length,
    palette = [...table.colours, [0, 0, 0]];
  const gif = GIFEncoder(),
    shown = new Uint8Array(width * height),
    indices = new Uint8Array(width * height);
  // A GIF counts hundredths of a second: their remainders must not add up.
  const hundredths = (i: number): number => Math.round((100 * i) / rate);
  let before: Uint32Array | null = null,
    since = performance.now();
  for (let i = 0; i < frames; i++) {
    const now = pixels(i);
    for (let p = 0; p < now.length; p++) {
      if (before?.[p] === now[p]) {
        shown[p] = same;
        continue;
      }
      const index = table.indexOf(nth(now, p));
      shown[p] = before && index === indices[p] ? same : index;
      indices[p] = index;
    }
    gif.writeFrame(shown, width, height, {
      ...(before ? {} : { palette, repeat: 0 }),
      delay: i === frames - 1 ? LAST_MS : 10 * (hundredths(i + 1) - hundredths(i)),
      ...(before && { transparent: true, transparentIndex: same, dispose: 1 }),
    });
    before = now;
    if (performance.now() - since > SLICE_MS) {
      if (!tell(i / frames)) return null;
      await new Promise((done) => setTimeout(done));
      since = performance.now();
    }
  }
  gif.finish();
  return new Blob([gif.bytes()], { type: "image/gif" });
}
