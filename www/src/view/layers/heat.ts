/** The order in which a grid planner expanded its cells. */
import type { Plan } from "parkade";
import type { State } from "../../store";
import { vast } from "../lazy-large-maps";
import { inPixels, toScreen, type Frame, type Shown } from "../frame";
import { RAMP_SIZE, RAMP_WORDS } from "../ramp";
import { context2d, newCanvas } from "../surface";

/** Cells of which a whole picture is too slow to paint again and again. */
const TOO_MANY = 500_000;

interface Painted {
  trace: Plan["trace"];
  count: number;
  canvas: HTMLCanvasElement;
  ctx: CanvasRenderingContext2D;
  image: ImageData;
  words: Uint32Array;
}

/** How many expansions of `total` are shown at this point of the playback. */
export function expansionsShown(state: State, plan: Plan): number {
  const total = traceLength(plan);
  const { base, searchMode, fraction } = state.playback;
  if (base === "drive") return total;
  if (searchMode === "percent") return Math.round(total * fraction);
  const longest = Math.max(0, ...state.planners.map((id) => traceLength(state.results[id]?.plan ?? null)));
  return Math.min(total, Math.round(longest * fraction));
}

/** Expansions a plan has kept. */
export function traceLength(plan: Plan | null): number {
  const trace = plan?.trace;
  if (!trace) return 0;
  return trace.kind === "cells" ? trace.cells.length : trace.arcs.length / 5;
}

export class HeatLayer {
  private painted: Painted | null = null;

  draw(frame: Frame, { plan }: Shown): void {
    if (plan?.trace?.kind !== "cells") return;
    const { origin, width, height, resolution } = frame.state.scene.map;
    if (width * height > TOO_MANY && vast()?.drawHeat(frame, plan.trace.cells, expansionsShown(frame.state, plan)))
      return;
    const painted = this.paint(plan.trace, expansionsShown(frame.state, plan), width, height);
    const [left, top] = toScreen(frame, [origin[0], origin[1] + height * resolution]);
    const scale = resolution * frame.view.camera.scale;
    const { ctx } = frame;
    inPixels(frame);
    ctx.save();
    ctx.imageSmoothingEnabled = false;
    ctx.globalAlpha = frame.tokens.dark ? 0.46 : 0.5;
    ctx.drawImage(painted.canvas, left, top, width * scale, height * scale);
    ctx.restore();
  }

  private paint(trace: { kind: "cells"; cells: Uint32Array }, count: number, width: number, height: number): Painted {
    const before = this.painted;
    if (before?.trace === trace && before.count === count) return before;
    const painted = before?.image.width === width && before.image.height === height ? before : blank(width, height);
    const { cells } = trace,
      { words } = painted;
    const step = RAMP_SIZE / Math.max(1, cells.length);
    words.fill(0);
    for (let i = count - 1; i >= 0; i--) {
      const cell = cells[i]!,
        x = cell % width,
        y = (cell - x) / width;
      if (y < height) words[(height - 1 - y) * width + x] = RAMP_WORDS[(i * step) | 0]!;
    }
    painted.ctx.putImageData(painted.image, 0, 0);
    this.painted = { ...painted, trace: trace as Plan["trace"], count };
    return this.painted;
  }
}

function blank(width: number, height: number): Painted {
  const canvas = newCanvas(width, height);
  const ctx = context2d(canvas);
  const image = ctx.createImageData(width, height);
  return { trace: null, count: -1, canvas, ctx, image, words: new Uint32Array(image.data.buffer) };
}
