/** The other planners' paths, faint, for comparison. */
import type { Narrowest } from "parkade";
import { GHOST, inPixels, toScreen, type Frame, type Shown } from "../frame";
import { fixed } from "../text";
import { drawDimension } from "./dimension";
import { drawPath } from "./path";
import { drawSweep } from "./sweep";

/** Strength of a path that is only looked at. */
const PREVIEW = 0.6;

export function drawOthers(frame: Frame): void {
  const { state, shown } = frame;
  for (const planner of state.planners) {
    if (state.hidden.has(planner) || shown.some((one) => one.planner === planner)) continue;
    const result = state.results[planner] ?? null;
    const plan = result?.plan?.outcome === "found" ? result.plan : null;
    const other: Shown = { planner, plan, result, ghost: true };
    drawPath(frame, other, GHOST);
  }
}

/** Another path of a planner, while its chip is pointed at; or where its own is narrowest. */
export function drawPreview(frame: Frame): void {
  const { preview, results } = frame.state;
  if (!preview || !frame.shown.some(({ planner }) => planner === preview.planner)) return;
  if (preview.place) return drawNarrowest(frame, preview.place);
  const shown: Shown = { ...preview, result: results[preview.planner] ?? null, ghost: false };
  drawSweep(frame, shown);
  drawPath(frame, shown, PREVIEW);
}

function drawNarrowest(frame: Frame, { body, point }: Narrowest): void {
  const {
      ctx,
      tokens: { colour },
    } = frame,
    [x, y] = toScreen(frame, [(body[0] + point[0]) / 2, (body[1] + point[1]) / 2]);
  drawDimension(frame, body, point, `${fixed(Math.hypot(body[0] - point[0], body[1] - point[1]), 2)} m`, colour.warn);
  inPixels(frame);
  ctx.beginPath();
  ctx.arc(x, y, 11, 0, 2 * Math.PI);
  ctx.lineWidth = 2;
  ctx.strokeStyle = colour.warn;
  ctx.stroke();
}
