/** Paints the lines of a site plan, a share of them in each frame: the page stays alive while it paints many. */
import { nth } from "../scene/nth";
import type { LayerOutline } from "../siteplan/plan-outline";

/** Points of one frame: some ten milliseconds. */
const MOST_POINTS = 8000;

export interface Fit {
  scale: number;
  x: number;
  y: number;
}

export interface LineStyle {
  stroke: string;
  width: number;
  dash: number[];
  fill: string | null;
  alpha: number;
}

export class PlanPainter {
  /** What is painted; empty until the first picture is begun. */
  readonly canvas = document.createElement("canvas");
  private layers: readonly (readonly [LayerOutline, LineStyle])[] = [];
  private fit: Fit = { scale: 1, x: 0, y: 0 };
  private layer = 0;
  private line = 0;

  begin(
    { width, height, ratio }: { width: number; height: number; ratio: number },
    layers: readonly (readonly [LayerOutline, LineStyle])[],
    fit: Fit,
  ): void {
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    this.canvas.getContext("2d")!.scale(ratio, ratio);
    this.layers = layers;
    this.fit = fit;
    this.layer = this.line = 0;
  }

  get isDone(): boolean {
    return this.layer >= this.layers.length;
  }

  /** Paints the next share. */
  paint(): void {
    const ctx = this.canvas.getContext("2d")!;
    for (let left = MOST_POINTS; left > 0 && !this.isDone; this.layer++) {
      const [outline, style] = nth(this.layers, this.layer);
      left -= this.paintLayer(ctx, outline, style, left);
      if (this.line < outline.ends.length) return;
      this.line = 0;
    }
  }

  /** Paints lines of a layer, from where the last share ended; tells how many points they had. */
  private paintLayer(ctx: CanvasRenderingContext2D, outline: LayerOutline, style: LineStyle, most: number): number {
    ctx.globalAlpha = style.alpha;
    ctx.strokeStyle = style.stroke;
    ctx.lineWidth = style.width;
    ctx.setLineDash(style.dash);
    let done = 0;
    for (; this.line < outline.ends.length && done < most; this.line++) {
      const from = this.line === 0 ? 0 : nth(outline.ends, this.line - 1),
        to = nth(outline.ends, this.line),
        isClosed = nth(outline.closed, this.line) === 1;
      trace(ctx, outline.points.subarray(2 * from, 2 * to), isClosed, this.fit);
      if (style.fill && isClosed) {
        ctx.fillStyle = style.fill;
        ctx.fill();
      }
      ctx.stroke();
      done += to - from;
    }
    return done;
  }
}

/** Begins a path through points: x, y, …. */
export function trace(
  ctx: CanvasRenderingContext2D,
  points: ArrayLike<number>,
  isClosed: boolean,
  { scale, x, y }: Fit,
): void {
  ctx.beginPath();
  for (let i = 0; i + 1 < points.length; i += 2) ctx.lineTo(nth(points, i) * scale + x, y - nth(points, i + 1) * scale);
  if (isClosed) ctx.closePath();
}
