/** Stretches of a path that lie farther from every other path than the car's width. */
import type { Plan } from "parkade";
import type { Point } from "../../scene/geometry";
import { inPixels, toScreen, type Frame, type Shown } from "../frame";
import { fade } from "../tokens";
import { nth } from "../../scene/nth";

/** Poses looked at of each path. */
const MOST = 400;
const BAND_PX = 13;

const sampled = new WeakMap<Plan, Point[]>();

function pointsOf(plan: Plan): Point[] {
  const known = sampled.get(plan);
  if (known) return known;
  const count = plan.path.length / 3,
    step = Math.max(1, Math.ceil(count / MOST)),
    points: Point[] = [];
  for (let i = 0; i < count; i += step) points.push([nth(plan.path, 3 * i), nth(plan.path, 3 * i + 1)]);
  sampled.set(plan, points);
  return points;
}

let known: { plan: Plan; others: readonly Plan[]; width: number; stretches: Point[][] }[] = [];

/** Stretches of `plan` that no other path comes near. */
function stretchesOf(plan: Plan, others: readonly Plan[], width: number): Point[][] {
  const before = known.find(
    (one) =>
      one.plan === plan &&
      one.width === width &&
      one.others.length === others.length &&
      one.others.every((other, i) => other === others[i]),
  );
  if (before) return before.stretches;
  const lines = others.map(pointsOf),
    near = width * width,
    stretches: Point[][] = [];
  let stretch: Point[] = [];
  for (const [x, y] of pointsOf(plan)) {
    const alone = lines.every((line) => line.every((p) => (p[0] - x) ** 2 + (p[1] - y) ** 2 > near));
    if (alone) stretch.push([x, y]);
    else if (stretch.length > 0) {
      stretches.push(stretch);
      stretch = [];
    }
  }
  if (stretch.length > 0) stretches.push(stretch);
  known = [...known.slice(-15), { plan, others, width, stretches }];
  return stretches;
}

export function drawDifference(frame: Frame, { plan, planner }: Shown): void {
  const {
    ctx,
    state,
    resolved,
    tokens: { colour },
  } = frame;
  const others = state.planners.flatMap((other) => {
    const answer = state.results[other]?.plan;
    return other !== planner && !state.hidden.has(other) && answer?.outcome === "found" ? [answer] : [];
  });
  if (!plan || plan.path.length < 6 || others.length === 0) return;
  inPixels(frame);
  ctx.lineCap = ctx.lineJoin = "round";
  ctx.lineWidth = BAND_PX;
  ctx.strokeStyle = fade(colour.accent, 0.22);
  for (const stretch of stretchesOf(plan, others, resolved.vehicle.width)) {
    ctx.beginPath();
    stretch.forEach((p, i) => (i === 0 ? ctx.moveTo(...toScreen(frame, p)) : ctx.lineTo(...toScreen(frame, p))));
    ctx.stroke();
  }
  ctx.lineCap = "butt";
}
