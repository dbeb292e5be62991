/**
 * Signs for what became of a move: ✓ kept, ↻ improved, – dearer or closed, ✕ blocked, ⌀ corner, two bars held back, ○
 * drawn.
 */
import type { FateName } from "../../planning/search-replay";
import type { Frame } from "../frame";

/** The same signs as text. */
export const SIGNS: Record<FateName, string> = {
  kept: "✓",
  improved: "↻",
  dearer: "–",
  closed: "▪",
  blocked: "✕",
  corner: "⌀",
  heldBack: "II",
  requeued: "II",
  leftOut: "·",
  drawn: "○",
};

/** Draws the sign of a fate with its middle at (x, y) and half its width, CSS pixels. */
export function drawMark(
  { ctx, tokens }: Frame,
  fate: FateName,
  x: number,
  y: number,
  half: number,
  isNow: boolean,
): void {
  const { colour } = tokens;
  ctx.lineCap = "round";
  for (const [style, width] of [
    [colour.floor, 4.5],
    [
      fate === "blocked" || fate === "corner"
        ? colour.err
        : fate === "kept" || fate === "improved"
          ? colour.accent
          : colour.t1,
      isNow ? 2.4 : 1.8,
    ],
  ] as const) {
    ctx.strokeStyle = style;
    ctx.lineWidth = width;
    ctx.beginPath();
    trace(ctx, fate, x, y, half);
    ctx.stroke();
  }
  ctx.lineCap = "butt";
}

function trace(ctx: CanvasRenderingContext2D, fate: FateName, x: number, y: number, r: number): void {
  const line = (x1: number, y1: number, x2: number, y2: number): void => {
    ctx.moveTo(x + x1 * r, y + y1 * r);
    ctx.lineTo(x + x2 * r, y + y2 * r);
  };
  switch (fate) {
    case "kept":
      line(-0.8, 0, -0.2, 0.7);
      line(-0.2, 0.7, 0.9, -0.7);
      return;
    case "improved":
      ctx.moveTo(x + 0.8 * r, y);
      ctx.arc(x, y, 0.8 * r, 0, 4.9);
      line(0.15, -0.8, -0.3, -1.1);
      line(0.15, -0.8, -0.2, -0.35);
      return;
    case "blocked":
      line(-0.7, -0.7, 0.7, 0.7);
      line(-0.7, 0.7, 0.7, -0.7);
      return;
    case "corner":
      ctx.moveTo(x + 0.8 * r, y);
      ctx.arc(x, y, 0.8 * r, 0, 6.3);
      line(-0.8, 0.8, 0.8, -0.8);
      return;
    case "heldBack":
    case "requeued":
      line(-0.35, -0.7, -0.35, 0.7);
      line(0.35, -0.7, 0.35, 0.7);
      return;
    case "drawn":
      ctx.moveTo(x + 0.6 * r, y);
      ctx.arc(x, y, 0.6 * r, 0, 6.3);
      return;
    case "closed":
      ctx.rect(x - 0.5 * r, y - 0.5 * r, r, r);
      return;
    case "leftOut":
      line(-0.1, 0, 0.1, 0);
      return;
    default:
      line(-0.7, 0, 0.7, 0);
  }
}
