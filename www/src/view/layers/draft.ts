/** The preview of the active tool. */
import { polygonPath, inMetres, inPixels, linePath, pixels, toScreen, type Frame } from "../frame";
import { slotOutline } from "../../scene/slots";
import { rectangleCorners } from "../../scene/shapes";
import { vehicleOf } from "../../scene/vehicle";
import type { Point } from "../../scene/geometry";
import type { Aisle, Guide, Preview } from "../../store/draft";
import { word } from "../tool-messages";
import { drawCar, parkedStyle } from "../car";
import { drawPill, fixed, labelFont, PILL_HEIGHT, pillWidth, useFont } from "../text";
import { fade } from "../tokens";
import { drawBorderHandles } from "./border-handles";
import { drawPoseCar } from "./cars";
import { newPath } from "../surface";
import { nth } from "../../scene/nth";

export function drawDraft(frame: Frame): void {
  const { draft } = frame;
  if (!draft) return;
  for (const guide of draft.guides ?? []) drawGuide(frame, guide);
  if (draft.preview) drawPreview(frame, draft.preview);
  if (draft.border) drawBorderHandles(frame, draft.border);
  if (draft.label) drawLiveLabel(frame, draft.label.text, draft.label.at);
}

function drawPreview(frame: Frame, preview: Preview): void {
  switch (preview.kind) {
    case "brush":
      return drawBrush(frame, preview);
    case "line":
      return drawLine(frame, preview);
    case "rectangle":
      return drawRectangle(frame, preview);
    case "marquee":
      return drawMarquee(frame, preview);
    case "slots":
      return drawSlotRow(frame, preview);
    case "pose":
      return drawPoseCar(frame, preview.which, preview.pose);
    case "car":
      return drawParked(frame, preview);
  }
}

function drawParked(frame: Frame, preview: Extract<Preview, { kind: "car" }>): void {
  const { ctx } = frame;
  ctx.save();
  ctx.globalAlpha = 0.75;
  const style = parkedStyle(frame);
  drawCar(frame, preview.pose, vehicleOf(preview.vehicle), 0, {
    ...style,
    edge: frame.tokens.colour.accent,
    dash: [5, 3.5],
    edgeWidth: 1.5,
  });
  ctx.restore();
}

/** Half of the crosses at a guide's ends, px. */
const TICK = 3.5;

function drawGuide(frame: Frame, { from, to }: Guide): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  inPixels(frame);
  ctx.beginPath();
  ctx.moveTo(...toScreen(frame, from));
  ctx.lineTo(...toScreen(frame, to));
  ctx.setLineDash([1, 4]);
  ctx.lineWidth = 1;
  ctx.strokeStyle = colour.accent;
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.beginPath();
  for (const [x, y] of [toScreen(frame, from), toScreen(frame, to)]) {
    ctx.moveTo(x - TICK, y - TICK);
    ctx.lineTo(x + TICK, y + TICK);
    ctx.moveTo(x - TICK, y + TICK);
    ctx.lineTo(x + TICK, y - TICK);
  }
  ctx.stroke();
}

function drawMarquee(frame: Frame, { from, to }: Extract<Preview, { kind: "marquee" }>): void {
  const {
      ctx,
      tokens: { colour },
    } = frame,
    [x0, y0] = toScreen(frame, from),
    [x1, y1] = toScreen(frame, to);
  inPixels(frame);
  ctx.fillStyle = fade(colour.accent, 0.08);
  ctx.fillRect(x0, y0, x1 - x0, y1 - y0);
  ctx.lineWidth = 1;
  ctx.strokeStyle = colour.accent;
  ctx.strokeRect(Math.round(x0) + 0.5, Math.round(y0) + 0.5, Math.round(x1 - x0), Math.round(y1 - y0));
}

function drawBrush(frame: Frame, { at, radius, erase, label }: Extract<Preview, { kind: "brush" }>): void {
  const {
    ctx,
    tokens: { colour },
    view,
  } = frame;
  const [x, y] = toScreen(frame, at);
  inPixels(frame);
  ctx.beginPath();
  ctx.arc(x, y, Math.max(2, radius * view.camera.scale), 0, 2 * Math.PI);
  ctx.fillStyle = fade(erase ? colour.floor : colour.obs, erase ? 0.6 : 0.35);
  ctx.fill();
  ctx.lineWidth = 1.25;
  ctx.strokeStyle = erase ? colour.t2 : colour.accent;
  if (erase) ctx.setLineDash([3, 3]);
  ctx.stroke();
  ctx.setLineDash([]);
  if (label) drawPill(frame, label, x + Math.max(2, radius * view.camera.scale) + 6, y - 11);
}

/** Corners set so far, the edge to the pointer, in the colour of errors where it is refused. */
function drawLine(frame: Frame, preview: Extract<Preview, { kind: "line" }>): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const { points, cursor, thickness, refused, closing, closed } = preview;
  const all = cursor && !closing ? [...points, cursor] : points;
  inMetres(frame);
  ctx.lineJoin = "round";
  if (closed && all.length > 2) {
    ctx.fillStyle = fade(refused ? colour.err : colour.accent, 0.09);
    ctx.fill(polygonPath(all));
  }
  ctx.strokeStyle = fade(colour.accent, 0.22);
  ctx.lineWidth = Math.max(thickness, pixels(frame, 3));
  if (!closed) ctx.stroke(linePath(all));
  ctx.strokeStyle = colour.accent;
  ctx.lineWidth = pixels(frame, 1.5);
  ctx.stroke(linePath(closing ? [...points, nth(points, 0)] : points));
  const last = points.at(-1);
  if (cursor && last && !closing) {
    ctx.strokeStyle = refused ? colour.err : colour.accent;
    ctx.setLineDash([pixels(frame, 5), pixels(frame, 3.5)]);
    ctx.stroke(linePath([last, cursor]));
    ctx.setLineDash([]);
  }
  points.forEach((p, i) => drawVertex(frame, p, i === 0 && closing));
  if (cursor) drawMovingEnd(frame, cursor);
}

function drawVertex(frame: Frame, p: Point, solid: boolean): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const [x, y] = toScreen(frame, p);
  inPixels(frame);
  ctx.beginPath();
  ctx.arc(x, y, 5, 0, 2 * Math.PI);
  ctx.fillStyle = solid ? colour.accent : colour.floor;
  ctx.fill();
  ctx.lineWidth = 1.75;
  ctx.strokeStyle = colour.accent;
  ctx.stroke();
}

/** The end under the pointer: solid, with a wide cross. */
function drawMovingEnd(frame: Frame, p: Point): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const [x, y] = toScreen(frame, p);
  inPixels(frame);
  ctx.beginPath();
  ctx.moveTo(x - 26, y);
  ctx.lineTo(x + 26, y);
  ctx.moveTo(x, y - 26);
  ctx.lineTo(x, y + 26);
  ctx.lineWidth = 1;
  ctx.strokeStyle = colour.accent;
  ctx.stroke();
  ctx.beginPath();
  ctx.arc(x, y, 5, 0, 2 * Math.PI);
  ctx.fillStyle = colour.accent;
  ctx.fill();
}

/** New outlines are dashed in the accent colour on a tint of it. */
function drawRectangle(frame: Frame, preview: Extract<Preview, { kind: "rectangle" }>): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const outline = polygonPath(rectangleCorners(preview));
  inMetres(frame);
  ctx.lineJoin = "miter";
  ctx.lineWidth = pixels(frame, 1.5);
  ctx.setLineDash([pixels(frame, 5), pixels(frame, 3.5)]);
  ctx.strokeStyle = colour.accent;
  ctx.fillStyle = fade(colour.accent, 0.09);
  ctx.fill(outline);
  ctx.stroke(outline);
  ctx.setLineDash([]);
  drawVertex(frame, preview.from, false);
  drawMovingEnd(frame, preview.to);
}

/** Bays tinted and numbered; dividers once each, the aisle side solid. */
function drawSlotRow(frame: Frame, { slots, from, to, aisle }: Extract<Preview, { kind: "slots" }>): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const outlines = slots.map((slot) => slotOutline(slot));
  inMetres(frame);
  const dividers = newPath();
  outlines.forEach((outline, i) => {
    const [nearLeft, nearRight, farRight, farLeft] = outline;
    ctx.fillStyle = fade(colour.accent, i === outlines.length - 1 ? 0.04 : 0.09);
    ctx.fill(polygonPath(outline));
    linePath(i === 0 ? [nearLeft, farLeft, farRight, nearRight] : [farLeft, farRight], dividers);
    if (i > 0) linePath(outerSide(outline, nth(outlines, i - 1)), dividers);
  });
  ctx.lineJoin = "miter";
  ctx.lineWidth = pixels(frame, 1.5);
  ctx.strokeStyle = colour.accent;
  ctx.setLineDash([pixels(frame, 5), pixels(frame, 3.5)]);
  ctx.stroke(dividers);
  ctx.setLineDash([]);
  ctx.stroke(linePath([from, to]));
  if (aisle.width > 0) drawAisle(frame, from, to, aisle);
  numberBays(frame, outlines);
  drawVertex(frame, from, false);
  drawMovingEnd(frame, to);
}

/** A dimension line across the aisle; in the colour of errors where something stands in it. */
function drawAisle(frame: Frame, from: Point, to: Point, aisle: Aisle): void {
  const {
      ctx,
      state,
      tokens: { colour },
    } = frame,
    short = aisle.free < aisle.width - 0.05;
  const dx = aisle.to[0] - aisle.from[0],
    dy = aisle.to[1] - aisle.from[1];
  const a = toScreen(frame, aisle.from),
    b = toScreen(frame, aisle.to),
    length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  inPixels(frame);
  ctx.strokeStyle = short ? colour.err : colour.accent;
  ctx.lineWidth = 1;
  ctx.setLineDash([2, 3]);
  ctx.beginPath();
  ctx.moveTo(...toScreen(frame, [from[0] + dx, from[1] + dy]));
  ctx.lineTo(...toScreen(frame, [to[0] + dx, to[1] + dy]));
  ctx.stroke();
  ctx.setLineDash([]);
  const ux = (b[0] - a[0]) / length,
    uy = (b[1] - a[1]) / length;
  ctx.beginPath();
  ctx.moveTo(...a);
  ctx.lineTo(...b);
  for (const [[x, y], sign] of [
    [a, 1],
    [b, -1],
  ] as const) {
    ctx.moveTo(x + sign * ux * 6 - uy * 3, y + sign * uy * 6 + ux * 3);
    ctx.lineTo(x, y);
    ctx.lineTo(x + sign * ux * 6 + uy * 3, y + sign * uy * 6 - ux * 3);
  }
  ctx.stroke();
  const text = `${word(state, "aisle")} ${fixed(aisle.width, 2)} m${
    short ? ` · ${word(state, "free")} ${fixed(aisle.free, 2)} m` : ""
  }`;
  drawPill(frame, text, a[0] + (b[0] - a[0]) * 0.75 + 10, a[1] + (b[1] - a[1]) * 0.75 - PILL_HEIGHT / 2);
}

/** The side of a bay that its neighbour does not have. */
function outerSide([nearLeft, nearRight, farRight, farLeft]: Point[], neighbour: Point[]): [Point, Point] {
  const onLeft = neighbour.some((p) => Math.hypot(p[0] - nearLeft![0], p[1] - nearLeft![1]) < 1e-6);
  return onLeft ? [nearRight!, farRight!] : [nearLeft!, farLeft!];
}

function numberBays(frame: Frame, outlines: readonly Point[][]): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  inPixels(frame);
  useFont(ctx, labelFont(frame, 600));
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.fillStyle = colour.accent;
  outlines.forEach(([a, , c], i) =>
    ctx.fillText(String(i + 1), ...toScreen(frame, [(a![0] + c![0]) / 2, (a![1] + c![1]) / 2])),
  );
}

/** Above the point, so that a finger does not cover it. */
function drawLiveLabel(frame: Frame, text: string, at: Point): void {
  const [x, y] = toScreen(frame, at);
  const width = pillWidth(frame, text);
  const left = Math.min(Math.max(4, x - width / 2), frame.view.width - width - 4);
  const top = y - PILL_HEIGHT - 14 < 4 ? y + 16 : y - PILL_HEIGHT - 14;
  drawPill(frame, text, left, top, "solid");
}
