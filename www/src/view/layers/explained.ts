/**
 * The risk field at the cell under the pointer as its paper's tables put it: the force, the three cells it picks, their
 * double steps.
 */
import type { Explanation } from "parkade";
import { inPixels, toScreen, type Frame } from "../frame";
import { fade } from "../tokens";
import { newPath } from "../surface";

type Cell = readonly [number, number];

/** Cells smaller than this (px) are not told apart. */
const LEAST = 5;
const FORCE = 34;

export function drawExplained(frame: Frame, { cell, candidates, force }: Explanation): void {
  const {
    ctx,
    view,
    tokens: { colour },
    state: {
      scene: { map },
    },
  } = frame;
  const size = map.resolution * view.camera.scale;
  inPixels(frame);
  const middle = ([column, row]: Cell): [number, number] =>
    toScreen(frame, [map.origin[0] + (column + 0.5) * map.resolution, map.origin[1] + (row + 0.5) * map.resolution]);
  const from = middle(cell);
  if (size >= LEAST) {
    for (const { cell: to, role, free } of candidates) {
      const [x, y] = middle(to),
        held = role === "held-back";
      ctx.setLineDash(role === "primary" ? [] : role === "extension" ? [4, 2] : [1, 2]);
      ctx.lineWidth = held ? 1 : 1.6;
      ctx.strokeStyle = held ? colour.t3 : free ? colour.accent : colour.err;
      if (role === "primary" && free) {
        ctx.fillStyle = fade(colour.accent, 0.22);
        ctx.fillRect(x - size / 2, y - size / 2, size, size);
      }
      ctx.strokeRect(x - size / 2 + 1, y - size / 2 + 1, size - 2, size - 2);
      if (!free && !held) cross(ctx, x, y, size * 0.3);
    }
    ctx.setLineDash([]);
    ctx.lineWidth = 2;
    ctx.strokeStyle = colour.t1;
    ctx.strokeRect(from[0] - size / 2 + 1, from[1] - size / 2 + 1, size - 2, size - 2);
  }
  const strength = Math.hypot(force[0], force[1]);
  if (strength > 0) arrow(frame, from, [force[0] / strength, -force[1] / strength]);
  ctx.setLineDash([]);
}

function cross(ctx: CanvasRenderingContext2D, x: number, y: number, half: number): void {
  ctx.setLineDash([]);
  ctx.beginPath();
  ctx.moveTo(x - half, y - half);
  ctx.lineTo(x + half, y + half);
  ctx.moveTo(x - half, y + half);
  ctx.lineTo(x + half, y - half);
  ctx.stroke();
}

function arrow(
  { ctx, tokens: { colour } }: Frame,
  [x, y]: readonly [number, number],
  [dx, dy]: readonly [number, number],
): void {
  const tipX = x + dx * FORCE,
    tipY = y + dy * FORCE,
    head = 8;
  const body = newPath();
  body.moveTo(x, y);
  body.lineTo(tipX, tipY);
  body.moveTo(tipX - head * (dx - dy * 0.6), tipY - head * (dy + dx * 0.6));
  body.lineTo(tipX, tipY);
  body.lineTo(tipX - head * (dx + dy * 0.6), tipY - head * (dy - dx * 0.6));
  for (const [style, width] of [
    [colour.floor, 5],
    [colour.accent, 2.4],
  ] as const) {
    ctx.strokeStyle = style;
    ctx.lineWidth = width;
    ctx.stroke(body);
  }
}
