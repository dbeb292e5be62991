/**
 * Why there is no path, where it fails: what touches, the gap, the region that has no way out, how near the search
 * came.
 */
import type { Obstruction } from "parkade";
import { gapAt } from "../../scene/gap";
import { inMetres, inPixels, pixels, toScreen, type Frame, type Shown } from "../frame";
import { hatchPattern } from "../hatch";
import { drawPill, fixed, PILL_HEIGHT, pillWidth } from "../text";
import { fade } from "../tokens";
import { drawHatchedPose } from "./collisions";
import { newPath } from "../surface";
import { passageOf } from "../failure";
import { drawDimension } from "./dimension";

type Point = readonly [number, number];

export function drawObstruction(frame: Frame, { result }: Shown): void {
  const plan = result?.status === "planning" ? null : result?.plan;
  if (!plan || plan.outcome === "found" || !plan.obstruction) return;
  draw(frame, plan.obstruction);
  const passage = passageOf(frame.state.scene, plan);
  if (passage) drawDimension(frame, passage.from, passage.to, `${fixed(passage.width, 2)} m`);
}

function draw(frame: Frame, obstruction: Obstruction): void {
  switch (obstruction.kind) {
    case "contact":
      return drawPlace(frame, [obstruction.hit.pose.x, obstruction.hit.pose.y]);
    case "boxed-in":
      return obstruction.stops.forEach(({ pose }) => drawHatchedPose(frame, pose));
    case "enclosed":
      return drawRegion(frame, obstruction);
    case "gap":
      return drawGap(frame, obstruction);
    case "nearest":
      if (obstruction.heading !== null)
        drawHatchedPose(frame, { x: obstruction.x, y: obstruction.y, heading: obstruction.heading });
      return drawPlace(frame, [obstruction.x, obstruction.y]);
  }
}

/** A ring with a cross, on its casing. */
export function drawPlace(frame: Frame, at: Point): void {
  const {
      ctx,
      tokens: { colour },
    } = frame,
    [x, y] = toScreen(frame, [at[0], at[1]]);
  inPixels(frame);
  ctx.lineCap = "round";
  ctx.beginPath();
  ctx.arc(x, y, 9, 0, 2 * Math.PI);
  ctx.fillStyle = colour["err-soft"];
  ctx.fill();
  ctx.moveTo(x - 3.5, y - 3.5);
  ctx.lineTo(x + 3.5, y + 3.5);
  ctx.moveTo(x - 3.5, y + 3.5);
  ctx.lineTo(x + 3.5, y - 3.5);
  ctx.lineWidth = 2;
  ctx.strokeStyle = colour.err;
  ctx.stroke();
  ctx.lineCap = "butt";
}

/** The disc that would have to pass, and the one that can. */
function drawGap(frame: Frame, { x, y, width, needed }: Extract<Obstruction, { kind: "gap" }>): void {
  const {
      ctx,
      tokens: { colour },
      view,
      state: { scene },
    } = frame,
    drawn = gapAt(scene, [x, y], width, 1.5 * scene.map.resolution);
  const gap = drawn && drawn.width < needed ? drawn : null;
  const [px, py] = toScreen(frame, gap ? [(gap.from[0] + gap.to[0]) / 2, (gap.from[1] + gap.to[1]) / 2] : [x, y]);
  inPixels(frame);
  for (const [metres, dash, fill] of [
    [needed, [4, 3], 0.12],
    [gap?.width ?? width, [], 0.2],
  ] as const) {
    ctx.beginPath();
    ctx.arc(px, py, Math.max(5, (metres / 2) * view.camera.scale), 0, 2 * Math.PI);
    ctx.fillStyle = fade(colour.err, fill);
    ctx.fill();
    ctx.setLineDash([...dash]);
    ctx.lineWidth = 1.75;
    ctx.strokeStyle = colour.err;
    ctx.stroke();
  }
  ctx.setLineDash([]);
  if (gap) return drawDimension(frame, gap.from, gap.to, `${fixed(gap.width, 2)} m < ${fixed(needed, 2)} m`);
  const text = `${fixed(width, 2)} m < ${fixed(needed, 2)} m`,
    wide = pillWidth(frame, text),
    reach = Math.max(5, (needed / 2) * view.camera.scale);
  const beside = px + reach + 8 + wide < view.width,
    fits = beside || px - reach - 8 - wide > 4;
  const left = beside
    ? px + reach + 8
    : fits
      ? px - reach - 8 - wide
      : Math.max(4, Math.min(px - wide / 2, view.width - wide - 4));
  drawPill(frame, text, left, fits ? py - PILL_HEIGHT / 2 : py - reach - PILL_HEIGHT - 6);
}

function drawRegion(frame: Frame, { cell, runs }: Extract<Obstruction, { kind: "enclosed" }>): void {
  const {
      ctx,
      tokens: { colour },
    } = frame,
    area = newPath();
  for (const [x, y, count] of runs) area.rect(x, y, count * cell, cell);
  ctx.save();
  inMetres(frame);
  ctx.fillStyle = fade(colour.err, 0.08);
  ctx.fill(area);
  ctx.clip(area);
  ctx.lineWidth = pixels(frame, 1);
  inPixels(frame);
  ctx.fillStyle = hatchPattern(frame, fade(colour.err, 0.45), 7, 1.2);
  ctx.fillRect(0, 0, frame.view.width, frame.view.height);
  ctx.restore();
}
