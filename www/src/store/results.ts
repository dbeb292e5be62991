/** What a panel shows of its planner, and the parts of it. */
import type {
  Drive,
  Encounter,
  HybridPlan,
  Judgement,
  Layer,
  LayerName,
  OptimisedTrajectory,
  Plan,
  PlannerId,
  Prefer,
} from "parkade";
import type { Said } from "../i18n/said";
import type { Scenario } from "../scene/scenario";

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

export interface PanelResult {
  plan: Plan | null;
  lastGood: Plan | null;
  /** `plan`, where that is another than the planner's first answer. */
  chosen?: Plan | null;
  /** The planner's first answer, where `chosen` stands in its place. */
  ordinary?: Plan | null;
  /** `plan` in time, among moving obstacles where there are some; null where no car drives it, and during drags. */
  drive: Drive | Encounter | null;
  /** Shown in the place of `plan` and `drive`, while it is of this plan. */
  smoothed?: Smoothed | null;
  layers: Partial<Record<LayerName, Layer>>;
  status: "idle" | "planning" | "done" | "error";
  error: { code: string; path: string; message: string } | null;
  /** Medians of `samples`; null until the planner has warmed up on the scene. */
  time: Timing | null;
  samples: Timing[];
}

/** Somebody else's trajectory, from a file. */
export interface Guest {
  name: string;
  /** The file's text. */
  text: string;
  /** The scene that it was judged in. */
  scene: Scenario;
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
export function focusedPlan({
  results,
  focus,
}: {
  results: Record<string, PanelResult>;
  focus: PlannerId;
}): Plan | null {
  const plan = played(results[focus])?.plan;
  return plan?.outcome === "found" ? plan : null;
}
