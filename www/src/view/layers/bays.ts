import { boxOf, type Point } from "../../scene/geometry";
import { slotOutline } from "../../scene/slots";
import { bestRow, gradeOf, type BayCheck } from "../../store/bay-check";
import { inPixels, polygonPath, toScreen, type Frame } from "../frame";
import { hatchPattern } from "../hatch";
import { labelFont, useFont } from "../text";
import { nth } from "../../scene/nth";

/** One move, two, three, more; on a light floor and on a dark one. */
export const RAMP = {
  light: ["#CFE3F1", "#8FBBDD", "#4A90C4", "#1F5E93"],
  dark: ["#3F5A6E", "#5186AE", "#72B4E6", "#BFE0F9"],
} as const;
/** Ink that is read on each of them. */
export const INK = {
  light: ["#1B1D20", "#1B1D20", "#1B1D20", "#FFFFFF"],
  dark: ["#FFFFFF", "#0E1013", "#0E1013", "#0E1013"],
} as const;
/** Of answers that an edit has overtaken. */
const STALE = 0.5;
/** Numbers stand on bays that are at least so wide, CSS pixels. */
const LEGIBLE = 11;

const outlineOf = (frame: Frame, index: number): Point[] =>
  slotOutline(nth(frame.state.scene.slots!, index)).map((point) => toScreen(frame, point));

export function drawBays(frame: Frame): void {
  const { bays, scene } = frame.state;
  if (!bays || bays.opened) return;
  const {
    ctx,
    tokens: { colour, dark },
  } = frame;
  inPixels(frame);
  scene.slots?.forEach((_, index) => {
    const row = bestRow(bays, index);
    if (!row) return;
    const path = polygonPath(outlineOf(frame, index)),
      grade = gradeOf(row);
    ctx.globalAlpha = bays.stale.has(index) ? STALE : 1;
    ctx.fillStyle = grade === 0 ? colour["err-soft"] : nth(RAMP[dark ? "dark" : "light"], grade - 1);
    ctx.fill(path);
    if (grade === 0) {
      ctx.fillStyle = hatchPattern(frame, colour.err, 6, 1.4);
      ctx.fill(path);
    }
    ctx.globalAlpha = 1;
  });
}

/** Above cars and paths: numbers, and the bay pointed at. */
export function drawBayNumbers(frame: Frame): void {
  const { bays, scene } = frame.state;
  if (!bays || bays.opened) return;
  const { goal } = scene,
    parkedIn = "slot" in goal ? goal.slot : undefined;
  scene.slots?.forEach((slot, index) => {
    const outline = outlineOf(frame, index),
      row = bestRow(bays, index);
    if (index === bays.lit) outlined(frame, outline);
    if (row) numbered(frame, outline, slot.occupied === true || slot.id === parkedIn, bays, row);
  });
}

/** Ink on a casing of the floor's colour, so that it stands out from every step of the ramp. */
function outlined({ ctx, tokens: { colour } }: Frame, outline: readonly Point[]): void {
  const path = polygonPath(outline);
  for (const [ink, width] of [
    [colour.floor, 5],
    [colour.t1, 2],
  ] as const) {
    ctx.strokeStyle = ink;
    ctx.lineWidth = width;
    ctx.stroke(path);
  }
}

function numbered(
  frame: Frame,
  outline: readonly Point[],
  occupied: boolean,
  bays: BayCheck,
  row: NonNullable<ReturnType<typeof bestRow>>,
): void {
  const { minX, maxX, minY, maxY } = boxOf([...outline]);
  if (Math.min(maxX - minX, maxY - minY) < LEGIBLE) return;
  const {
      ctx,
      tokens: { colour, dark },
    } = frame,
    [a, b] = outline as [Point, Point, ...Point[]],
    grade = gradeOf(row);
  const middle: Point = [(minX + maxX) / 2, (minY + maxY) / 2],
    mouth: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  // Beside the car that stands in the bay: at its open side.
  const [x, y]: Point = occupied
    ? [mouth[0] + (middle[0] - mouth[0]) * 0.16, mouth[1] + (middle[1] - mouth[1]) * 0.16]
    : middle;
  inPixels(frame);
  ctx.globalAlpha = bays.stale.has(row.index) ? STALE : 1;
  const text = grade === 0 ? "\u2715" : String(row.moves),
    scheme = dark ? "dark" : "light";
  if (occupied || grade === 0) {
    ctx.fillStyle = grade === 0 ? colour.panel : nth(RAMP[scheme], grade - 1);
    ctx.beginPath();
    ctx.arc(x, y, 8, 0, 2 * Math.PI);
    ctx.fill();
  }
  ctx.fillStyle = grade === 0 ? colour.err : nth(INK[scheme], grade - 1);
  useFont(ctx, labelFont(frame, 600));
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.fillText(text, x, y + 0.5);
  ctx.globalAlpha = 1;
}
