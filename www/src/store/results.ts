/** Parts of a planner's results. */
import type { HybridPlan, Prefer } from "parkade";

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
