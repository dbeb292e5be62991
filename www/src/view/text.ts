/** Words on the canvas: pills and small numbers. */
import { inPixels, type Context, type Frame } from "./frame";
import type { Box } from "../scene/geometry";
import { perSurface } from "./surface";

export const PILL_HEIGHT = 22;
const PAD = 8;

export type PillTone = "plain" | "editing" | "solid";

const widths = perSurface(() => new Map<string, number>());

/** Fonts as we write them, and as canvases answer. */
const answered = new Map<string, string>();

/** Setting a canvas's font makes the browser settle the page's style first, so a font that is already there stays. */
export function useFont(ctx: Context, font: string): void {
  if (ctx.font === answered.get(font)) return;
  ctx.font = font;
  if (answered.size > 100) answered.clear();
  answered.set(font, ctx.font);
}

/** Digits are all as wide as 0. */
function measure(frame: Frame, text: string): number {
  const font = labelFont(frame),
    like = text.replace(/\d/g, "0"),
    key = `${font}|${like}`;
  const known = widths().get(key);
  if (known !== undefined) return known;
  if (widths().size > 2000) widths().clear();
  useFont(frame.ctx, font);
  const { width } = frame.ctx.measureText(like);
  widths().set(key, width);
  return width;
}

export const labelFont = (frame: Frame, weight = 500): string => `${weight} 12px ${frame.tokens.font}`;

export const pillWidth = (frame: Frame, text: string): number => Math.ceil(measure(frame, text)) + 2 * PAD;

/** A pill with its upper left corner at (x, y), CSS pixels. */
export function drawPill(frame: Frame, text: string, x: number, y: number, tone: PillTone = "plain"): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  inPixels(frame);
  const width = pillWidth(frame, text);
  const left = Math.round(x) + 0.5,
    top = Math.round(y) + 0.5;
  ctx.beginPath();
  ctx.roundRect(left, top, width - 1, PILL_HEIGHT - 1, 5);
  ctx.globalAlpha = tone === "solid" ? 1 : 0.94;
  ctx.fillStyle = tone === "solid" ? colour.accent : colour.panel;
  ctx.fill();
  ctx.globalAlpha = 1;
  if (tone !== "solid") {
    ctx.lineWidth = 1;
    ctx.strokeStyle = tone === "editing" ? colour.accent : colour.hair2;
    ctx.stroke();
  }
  ctx.fillStyle = tone === "solid" ? colour.panel : colour.t1;
  useFont(ctx, labelFont(frame));
  ctx.textAlign = "left";
  ctx.textBaseline = "middle";
  ctx.fillText(text, left + PAD - 0.5, top + PILL_HEIGHT / 2);
}

/**
 * The first of these places (upper left corners, px) that is on the canvas and off every box; the first one pushed
 * inside if none is.
 */
export function placePill(frame: Frame, text: string, keep: Box, grip: Box, avoid: readonly Box[]): [number, number] {
  const { width, height } = frame.view;
  const w = pillWidth(frame, text),
    gap = 8;
  const middle = (low: number, high: number, size: number): number => (low + high - size) / 2;
  const atGrip = middle(grip.minY, grip.maxY, PILL_HEIGHT),
    beside = middle(keep.minY, keep.maxY, PILL_HEIGHT);
  const centred = middle(keep.minX, keep.maxX, w);
  const places: [number, number][] = [
    [centred, keep.maxY + gap],
    [grip.maxX + 2, atGrip],
    [keep.maxX + gap, beside],
    [grip.minX - 2 - w, atGrip],
    [keep.minX - gap - w, beside],
    [centred, keep.minY - gap - PILL_HEIGHT],
    [keep.maxX + gap, keep.maxY + gap],
    [keep.minX - gap - w, keep.maxY + gap],
  ];
  const inside = ([x, y]: [number, number]): boolean =>
    x >= 4 && y >= 4 && x + w <= width - 4 && y + PILL_HEIGHT <= height - 4;
  const clear = ([x, y]: [number, number]): boolean =>
    avoid.every((box) => x > box.maxX || x + w < box.minX || y > box.maxY || y + PILL_HEIGHT < box.minY);
  const [x, y] = places.find((place) => inside(place) && clear(place)) ?? places.find(inside) ?? places[0]!;
  return [
    Math.min(Math.max(4, x), Math.max(4, width - w - 4)),
    Math.min(Math.max(4, y), Math.max(4, height - PILL_HEIGHT - 4)),
  ];
}

const MINUS = "\u2212";
export const fixed = (value: number, digits: number): string => {
  const text = Math.abs(value).toFixed(digits);
  return value < 0 && Number(text) !== 0 ? MINUS + text : text;
};
export const metresText = (value: number): string => `${fixed(value, 2)} m`;
export const degreesText = (angle: number): string => `${fixed((angle * 180) / Math.PI, 1)}°`;
export const poseText = (pose: { x: number; y: number; heading: number }): string =>
  `x ${metresText(pose.x)} · y ${metresText(pose.y)} · ${degreesText(pose.heading)}`;
