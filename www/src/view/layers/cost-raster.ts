/** Cost of each cell for a cost-map planner, cheap at the dark end; the legend has the numbers. */
import type { Layer } from "parkade";
import { inPixels, toScreen, type Frame } from "../frame";
import { RAMP_SIZE, RAMP_WORDS } from "../ramp";
import { newCanvas, perSurface } from "../surface";

export interface CostRange {
  low: number;
  high: number;
}

const ranges = new WeakMap<Layer, CostRange>();
const pictures = perSurface(() => new WeakMap<Layer, HTMLCanvasElement>());
const SAMPLES = 20_000;

/** Smallest value and 98th percentile, of a sample: the few cells beside walls must not flatten all others. */
export function costRange(layer: Layer): CostRange {
  const known = ranges.get(layer);
  if (known) return known;
  const { data } = layer,
    step = Math.max(1, Math.floor(data.length / SAMPLES)) | 1,
    values: number[] = [];
  for (let i = 0; i < data.length; i += step) if (Number.isFinite(data[i])) values.push(data[i]!);
  values.sort((a, b) => a - b);
  const range = { low: values[0] ?? 0, high: values[Math.floor(values.length * 0.98)] ?? 1 };
  ranges.set(layer, range);
  return range;
}

export function drawCost(frame: Frame, layer: Layer): void {
  const {
    ctx,
    state: {
      scene: { map },
    },
    tokens,
  } = frame;
  const [left, top] = toScreen(frame, [map.origin[0], map.origin[1] + map.height * map.resolution]);
  const scale = map.resolution * frame.view.camera.scale;
  inPixels(frame);
  ctx.save();
  ctx.imageSmoothingEnabled = false;
  ctx.globalAlpha = tokens.dark ? 0.5 : 0.6;
  ctx.drawImage(pictureOf(layer), left, top, layer.width * scale, layer.height * scale);
  ctx.restore();
}

function pictureOf(layer: Layer): HTMLCanvasElement {
  const known = pictures().get(layer);
  if (known) return known;
  const { width, height, data } = layer,
    { low, high } = costRange(layer);
  const canvas = newCanvas(width, height),
    pen = canvas.getContext("2d");
  if (!pen) return canvas;
  const image = pen.createImageData(width, height),
    words = new Uint32Array(image.data.buffer);
  const step = (RAMP_SIZE - 1) / Math.max(1e-9, high - low);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const value = data[y * width + x]!;
      if (Number.isFinite(value))
        words[(height - 1 - y) * width + x] =
          RAMP_WORDS[Math.min(RAMP_SIZE - 1, Math.max(0, ((value - low) * step) | 0))]!;
    }
  }
  pen.putImageData(image, 0, 0);
  pictures().set(layer, canvas);
  return canvas;
}
