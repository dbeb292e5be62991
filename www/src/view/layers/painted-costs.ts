/** Painted cells: hatched, the more densely the dearer. */
import type { CostArea } from "../../scene/scenario";
import { cellPaths, type CellPaths } from "../outline";
import { inMetres, inPixels, pixels, type Frame } from "../frame";
import { hatchPattern } from "../hatch";
import { fade } from "../tokens";
import { perSurface } from "../surface";

const drawn = perSurface(() => new WeakMap<CostArea, CellPaths>());

/** Pixels between two lines of the hatching: 12 for a weight of 2, 4 for one of 10. */
export const spacingOf = (weight: number): number => 14 - weight;

export function drawCosts(frame: Frame): void {
  const {
    ctx,
    state: { scene },
    tokens: { colour },
    view,
  } = frame;
  for (const area of scene.costs ?? []) {
    let paths = drawn().get(area);
    if (!paths) drawn().set(area, (paths = cellPaths(area.runs, scene.map)));
    ctx.save();
    inMetres(frame);
    ctx.fillStyle = fade(colour.warn, 0.04 + 0.022 * area.weight);
    ctx.fill(paths.fill);
    ctx.strokeStyle = fade(colour.warn, 0.7);
    ctx.lineWidth = pixels(frame, 1);
    ctx.stroke(paths.edge);
    ctx.clip(paths.fill);
    inPixels(frame);
    ctx.fillStyle = hatchPattern(frame, fade(colour.warn, 0.6), spacingOf(area.weight), 1.25);
    ctx.fillRect(0, 0, view.width, view.height);
    ctx.restore();
  }
}
