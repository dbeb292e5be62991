/** The other planners' paths, faint, for comparison. */
import { GHOST, type Frame, type Shown } from "../frame";
import { drawPath } from "./path";

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
