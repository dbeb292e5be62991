/** Lines of equal potential of the risk field, narrower where it is steeper. */
import type { Layer } from "parkade";
import { contours } from "../contour";
import { inMetres, pixels, type Frame } from "../frame";
import { RAMP_STOPS } from "../ramp";
import { newPath, perSurface } from "../surface";

/**
 * Between the least and the greatest potential; evenly spaced in the square root, as the goal's grows with the distance
 * squared.
 */
const LEVELS = 24;
const SAMPLES = 20_000;
const built = perSurface(() => new WeakMap<Layer, Path2D[]>());

export function drawPotential(frame: Frame, layer: Layer): void {
  const {
    ctx,
    state: {
      scene: {
        map: { origin, resolution },
      },
    },
  } = frame;
  let lines = built().get(layer);
  if (!lines) built().set(layer, (lines = linesOf(layer, origin, resolution)));
  ctx.save();
  inMetres(frame);
  ctx.lineWidth = pixels(frame, 1.1);
  lines.forEach((line, i) => {
    ctx.strokeStyle = RAMP_STOPS[Math.floor((i * RAMP_STOPS.length) / LEVELS)]!;
    ctx.stroke(line);
  });
  ctx.restore();
}

/** A path for each level, low ones first. */
function linesOf(
  { width, height, data }: Layer,
  [left, bottom]: readonly [number, number],
  resolution: number,
): Path2D[] {
  const step = Math.max(1, Math.floor(data.length / SAMPLES)) | 1,
    values: number[] = [];
  for (let i = 0; i < data.length; i += step) values.push(data[i]!);
  values.sort((a, b) => a - b);
  const rootOf = (value: number): number => Math.sqrt(Math.max(0, value)),
    low = rootOf(values[0] ?? 0),
    high = rootOf(values.at(-1) ?? 1);
  return Array.from({ length: LEVELS }, (_, i) => {
    const root = low + ((high - low) * (i + 0.5)) / LEVELS,
      path = newPath();
    for (const loop of contours(width, height, (x, y) => data[y * width + x]!, root * root)) {
      let on = false;
      for (let k = 0; k < loop.length; k += 2) {
        const x = loop[k]!,
          y = loop[k + 1]!;
        // Loops close around the raster: what runs along its border is no line of the field.
        const inside = x >= 0 && y >= 0 && x <= width - 1 && y <= height - 1;
        const at = [left + (x + 0.5) * resolution, bottom + (y + 0.5) * resolution] as const;
        if (on && inside) path.lineTo(...at);
        else if (inside) path.moveTo(...at);
        on = inside;
      }
    }
    return path;
  });
}
