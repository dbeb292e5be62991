/** Which of a planner's paths is shown, and whether there can be a better one. */
import type { Choice } from "../store/results";
import type { HybridPlan, Prefer } from "parkade";

/** The chosen path among choices that include the ordinary path. */
export const chosenOf = <T extends Choice>(choices: readonly T[], prefer: Prefer | undefined): T | undefined =>
  choices.find(({ by, isOrdinary }) => (prefer ? by.includes(prefer) : isOrdinary)) ?? choices[0];

/** Lengths and costs that differ by less, in shares, are the same. */
const ROUNDING = 1e-6;

/** True if no path of this car can be better by what is preferred: it is as short as it could be without obstacles. */
export function isProven(
  { metrics: { length, rsBound = 0, cost = Infinity, directionChanges } }: HybridPlan,
  prefer: Prefer | undefined,
): boolean {
  const isLeast = (value: number): boolean => value <= rsBound * (1 + ROUNDING);
  if (prefer === undefined) return isLeast(cost);
  return isLeast(length) && (prefer === "shortest" || (prefer === "fewest-changes" && directionChanges === 0));
}
