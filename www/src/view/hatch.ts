/** 45° hatching as canvas patterns. */
import type { Frame } from "./frame";
import { newCanvas, perSurface } from "./surface";

const tiles = perSurface(() => new Map<string, HTMLCanvasElement>());

/** Lines of `width` px every `every` px, rising to the right; fixed to the canvas, not to the world. */
export function hatchPattern(frame: Frame, colour: string, every: number, width: number): CanvasPattern | string {
  const side = Math.max(4, Math.round(every * Math.SQRT2 * frame.ratio));
  const key = `${colour}|${side}|${width * frame.ratio}`;
  let tile = tiles().get(key);
  if (!tile) {
    tile = hatchTile(side, colour, width * frame.ratio);
    if (tiles().size > 32) tiles().clear();
    tiles().set(key, tile);
  }
  const pattern = frame.ctx.createPattern(tile, "repeat");
  // Patterns are drawn in user space; a tile of device pixels must not be scaled again.
  pattern?.setTransform({ a: 1 / frame.ratio, d: 1 / frame.ratio });
  return pattern ?? colour;
}

function hatchTile(side: number, colour: string, width: number): HTMLCanvasElement {
  const tile = newCanvas(side, side);
  const ctx = tile.getContext("2d");
  if (!ctx) return tile;
  ctx.strokeStyle = colour;
  ctx.lineWidth = width;
  ctx.beginPath();
  for (const shift of [-side, 0, side]) {
    ctx.moveTo(shift - side * 0.5, side * 1.5);
    ctx.lineTo(shift + side * 1.5, -side * 0.5);
  }
  ctx.stroke();
  return tile;
}
