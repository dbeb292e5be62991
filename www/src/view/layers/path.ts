/** Paths: casing, the planner's dash, dots and chevrons in reverse, numbered diamonds at gear changes. */
import type { Plan } from "parkade";
import type { Point } from "../../scene/geometry";
import { cuspsOf, segmentDirections } from "../drive";
import { inPixels, toScreen, type Frame, type Shown } from "../frame";
import { labelFont, useFont } from "../text";
import { plannerStyle, type PlannerStyle } from "../tokens";

/** Pixels between two points of a drawn path. */
const FINEST = 0.7;

/** Pixels beyond the view where a path still shows. */
const BESIDE = 24;

/** `from`: pixels of the way since the last gear change, where dashes begin. */
interface Leg {
  points: Point[];
  headings: number[];
  reverse: boolean;
  from: number;
}

/** The stretches in view, each of one direction of travel, in pixels. */
function legsOf(frame: Frame, plan: Plan): Leg[] {
  const { path } = plan;
  const {
    view: { width, height },
  } = frame;
  const sense = segmentDirections(plan);
  const sides = (x: number, y: number): number =>
    (x < -BESIDE ? 1 : x > width + BESIDE ? 2 : 0) | (y < -BESIDE ? 4 : y > height + BESIDE ? 8 : 0);
  const legs: Leg[] = [];
  let leg: Leg | null = null,
    from = 0;
  let [lastX, lastY] = toScreen(frame, [path[0]!, path[1]!]),
    out = sides(lastX, lastY);
  // Pixels of a metre; nothing is made for each of very many poses.
  const startX = lastX,
    startY = lastY,
    scale = frame.view.camera.scale;
  for (let i = 0; i < sense.length; i++) {
    const reverse = sense[i]! < 0;
    if (i > 0 && reverse !== sense[i - 1]! < 0) {
      leg = null;
      from = 0;
    }
    const x = startX + (path[3 * i + 3]! - path[0]!) * scale,
      y = startY - (path[3 * i + 4]! - path[1]!) * scale;
    // Long paths seen from afar have many poses to a pixel.
    if (Math.abs(x - lastX) + Math.abs(y - lastY) < FINEST && sense[i + 1] === sense[i]) continue;
    const beside = sides(x, y);
    // Both ends to the same side of the view: nothing to see between them.
    if (out & beside) leg = null;
    else {
      if (!leg) legs.push((leg = { points: [[lastX, lastY]], headings: [path[3 * i + 2]!], reverse, from }));
      leg.points.push([x, y]);
      leg.headings.push(path[3 * i + 5]!);
    }
    from += Math.sqrt((x - lastX) ** 2 + (y - lastY) ** 2);
    lastX = x;
    lastY = y;
    out = beside;
  }
  return legs;
}

export function drawPath(frame: Frame, shown: Shown, alpha: number): void {
  const { plan, planner } = shown;
  if (!plan || plan.path.length < 6) return;
  const { ctx } = frame;
  const style = plannerStyle(frame.tokens, planner);
  const legs = legsOf(frame, plan);
  ctx.save();
  inPixels(frame);
  ctx.globalAlpha = alpha;
  ctx.lineJoin = "round";
  for (const leg of legs) strokeCasing(frame, leg, style);
  for (const leg of legs) strokeLeg(frame, leg, style);
  for (const leg of legs) if (leg.reverse) drawChevrons(frame, leg, style);
  ctx.restore();
}

function trace({ ctx }: Frame, points: readonly Point[]): void {
  ctx.beginPath();
  points.forEach(([x, y], i) => (i === 0 ? ctx.moveTo(x, y) : ctx.lineTo(x, y)));
}

const dotted = (leg: Leg, style: PlannerStyle): boolean => leg.reverse && style.hybrid;

function setDash({ ctx }: Frame, leg: Leg, style: PlannerStyle): void {
  const dots = dotted(leg, style);
  ctx.lineCap = dots ? "round" : "butt";
  ctx.setLineDash(dots ? [0.1, 6.5] : [...style.dash]);
  ctx.lineDashOffset = leg.from;
}

/** Dots get a casing of dots: a full band would look like a road. */
function strokeCasing(frame: Frame, leg: Leg, style: PlannerStyle): void {
  const { ctx } = frame;
  setDash(frame, leg, style);
  if (!dotted(leg, style)) ctx.setLineDash([]);
  ctx.strokeStyle = frame.tokens.colour.floor;
  ctx.lineWidth = style.width + 2.4;
  trace(frame, leg.points);
  ctx.stroke();
}

function strokeLeg(frame: Frame, leg: Leg, style: PlannerStyle): void {
  const { ctx } = frame;
  setDash(frame, leg, style);
  ctx.strokeStyle = style.colour;
  ctx.lineWidth = style.width;
  trace(frame, leg.points);
  ctx.stroke();
  ctx.setLineDash([]);
}

const CHEVRON = { every: 26, tall: 8, wide: 5 };

/** Open chevrons that point where the nose points: against the travel. */
function drawChevrons(frame: Frame, leg: Leg, style: PlannerStyle): void {
  const { ctx } = frame;
  const marks = marksAlong(leg, CHEVRON.every);
  ctx.setLineDash([]);
  ctx.lineCap = "round";
  ctx.beginPath();
  for (const { x, y, heading } of marks) {
    const c = Math.cos(heading),
      s = -Math.sin(heading);
    const at = (ahead: number, left: number): Point => [x + ahead * c - left * s, y + ahead * s + left * c];
    const half = CHEVRON.tall / 2,
      tip = CHEVRON.wide / 2;
    ctx.moveTo(...at(-tip, half));
    ctx.lineTo(...at(tip, 0));
    ctx.lineTo(...at(-tip, -half));
  }
  ctx.strokeStyle = frame.tokens.colour.floor;
  ctx.lineWidth = 4.4;
  ctx.stroke();
  ctx.strokeStyle = style.colour;
  ctx.lineWidth = 2;
  ctx.stroke();
}

function marksAlong({ points, headings, from }: Leg, every: number): { x: number; y: number; heading: number }[] {
  const marks = [];
  let due = (every * 1.6 - (from % every)) % every;
  for (let i = 1; i < points.length; i++) {
    const [x0, y0] = points[i - 1]!,
      [x1, y1] = points[i]!;
    const length = Math.hypot(x1 - x0, y1 - y0);
    for (; due <= length && length > 0; due += every) {
      const part = due / length;
      marks.push({ x: x0 + (x1 - x0) * part, y: y0 + (y1 - y0) * part, heading: headings[i]! });
    }
    due -= length;
  }
  return marks;
}

const DIAMOND = { half: 11, ink: "#1B1D20" };

/** Gear changes, numbered along the way. Closer together than they are wide, they stand beside each other. */
export function drawCusps(frame: Frame, shown: Shown, alpha: number): void {
  const { plan } = shown;
  const cusps = plan ? cuspsOf(plan) : [];
  if (!plan || cusps.length === 0) return;
  const { ctx } = frame;
  const placed: Point[] = [];
  ctx.save();
  inPixels(frame);
  ctx.globalAlpha = alpha;
  useFont(ctx, labelFont(frame, 700));
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  cusps.forEach((at, i) => {
    const spot = apart(toScreen(frame, [plan.path[3 * at]!, plan.path[3 * at + 1]!]), placed);
    placed.push(spot);
    drawDiamond(frame, spot, String(i + 1));
  });
  ctx.restore();
}

function apart([x, y]: Point, placed: readonly Point[]): Point {
  const reach = DIAMOND.half * 1.5;
  const taken = (px: number, py: number): boolean =>
    placed.some((p) => Math.abs(p[0] - px) + Math.abs(p[1] - py) < reach);
  for (let ring = 0; ring < 6; ring++) {
    for (const [dx, dy] of [
      [1, -1],
      [1, 1],
      [-1, -1],
      [-1, 1],
    ] as const) {
      const px = x + dx * ring * DIAMOND.half,
        py = y + dy * ring * DIAMOND.half;
      if (!taken(px, py)) return [px, py];
    }
  }
  return [x, y];
}

function drawDiamond({ ctx }: Frame, [x, y]: Point, label: string): void {
  const h = DIAMOND.half;
  ctx.beginPath();
  ctx.moveTo(x, y - h);
  ctx.lineTo(x + h, y);
  ctx.lineTo(x, y + h);
  ctx.lineTo(x - h, y);
  ctx.closePath();
  ctx.fillStyle = "#FFFFFF";
  ctx.fill();
  ctx.lineWidth = 1.25;
  ctx.strokeStyle = DIAMOND.ink;
  ctx.stroke();
  ctx.fillStyle = DIAMOND.ink;
  ctx.fillText(label, x, y + 0.5);
}
