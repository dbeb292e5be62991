/** Parts of a planner's results. */
import type { Drive, Encounter, HybridPlan, Judgement, OptimisedTrajectory, Plan, Prefer } from "parkade";
import type { PanelResult, Scene, State } from ".";
import type { Said } from "../i18n/said";

/** Milliseconds of a plan: until its search ended, and with what follows, measures and checks its path. */
export interface Timing {
  search: number;
  total: number;
}

/** An alternative path: the best by some measures, or the one that costs least. */
export interface Choice {
  plan: HybridPlan;
  by: Prefer[];
  isOrdinary: boolean;
}

/**
 * What drives in the place of a plan: `plan` has the path of the optimised trajectory `drive`; both are the plan's own
 * where there is none.
 */
export interface Smoothed {
  /** The plan that it was made of. */
  of: Plan;
  plan: Plan;
  drive: Drive | Encounter | null;
  trajectory: OptimisedTrajectory | null;
  /** Why there is none. */
  failure: Said | null;
}

/** Somebody else's trajectory, from a file. */
export interface Guest {
  name: string;
  /** The file's text. */
  text: string;
  /** The scene that it was judged in. */
  scene: Scene;
  drive: Drive;
  verdict: Judgement;
}

/** The path and the drive of a result as they are shown. */
export const played = (
  result: PanelResult | null | undefined,
): Pick<PanelResult, "plan" | "drive"> | null | undefined =>
  result?.smoothed && result.smoothed.of === result.plan ? result.smoothed : result;

/** The planned path of which the shown one was made; null where it is the planned one itself. */
export function plannedOf(plan: Plan | null, result: PanelResult | null | undefined): Float64Array | null {
  const smoothed = result?.smoothed;
  return smoothed?.trajectory && smoothed.plan === plan ? smoothed.of.path : null;
}

/** The path in front. */
export function focusedPlan({ results, focus }: State): Plan | null {
  const plan = played(results[focus])?.plan;
  return plan?.outcome === "found" ? plan : null;
}
