/** The other planners' paths, faint, for comparison. */
import { GHOST, type Frame, type Shown } from "../frame";
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

/** Another path of a planner, while its chip is pointed at. */
export function drawPreview(frame: Frame): void {
  const { preview, results } = frame.state;
  if (!preview || !frame.shown.some(({ planner }) => planner === preview.planner)) return;
  const shown: Shown = { ...preview, result: results[preview.planner] ?? null, ghost: false };
  drawSweep(frame, shown);
  drawPath(frame, shown, PREVIEW);
}
