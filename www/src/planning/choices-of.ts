/** Which of a planner's paths are worth a chip. */
import type { Choice } from "../store/results";
import type { Drive, Encounter, HybridPlan, Prefer } from "parkade";
import { keysOf } from "../scene/records";

const MOST = 4;
/** Smaller differences count as equal: a share of the length or the time, and metres of clearance. */
const SAME = 0.01,
  SAME_CLEARANCE = 0.05;

/** A choice with its drive, as of a plan. */
export interface Driven extends Choice {
  drive: Drive | Encounter | null;
}

/** The path that costs least with as much margin as the first, which is told first. */
export const cheapest = (first: HybridPlan, others: readonly HybridPlan[]): HybridPlan =>
  others
    .filter(({ metrics: { margin = 0 } }) => margin >= (first.metrics.margin ?? 0))
    .reduce((best, plan) => ((plan.metrics.cost ?? Infinity) < (best.metrics.cost ?? Infinity) ? plan : best), first);

const MEASURES: Record<Prefer, (plan: HybridPlan) => readonly [number, number]> = {
  shortest: ({ metrics: { length } }) => [length, 0],
  "fewest-changes": ({ metrics: { directionChanges, length } }) => [directionChanges, length],
  widest: ({ metrics: { minClearance, length } }) => [-minClearance, length],
  fastest: ({ metrics: { driveTime = Infinity, length } }) => [driveTime, length],
};
const PREFERENCES = keysOf(MEASURES);

/** The paths that are best by some measure, and the ordinary one, the shortest first. */
export function choicesOf(ordinary: HybridPlan, alternatives: readonly HybridPlan[]): Choice[] {
  const choices: Choice[] = [{ plan: ordinary, by: [], isOrdinary: true }];
  for (const prefer of PREFERENCES) {
    const best = bestBy(prefer, alternatives);
    if (!best) continue;
    const known = choices.find(({ plan }) => alike(plan, best));
    if (known) known.by.push(prefer);
    else choices.push({ plan: best, by: [prefer], isOrdinary: false });
  }
  return choices.slice(0, MOST).sort((a, b) => a.plan.metrics.length - b.plan.metrics.length);
}

const bestBy = (prefer: Prefer, plans: readonly HybridPlan[]): HybridPlan | undefined => {
  const measure = MEASURES[prefer];
  return [...plans].sort((a, b) => measure(a)[0] - measure(b)[0] || measure(a)[1] - measure(b)[1])[0];
};

const alike = ({ metrics: a }: HybridPlan, { metrics: b }: HybridPlan): boolean =>
  a.directionChanges === b.directionChanges &&
  Math.abs(a.length - b.length) <= SAME * a.length &&
  Math.abs(a.minClearance - b.minClearance) <= SAME_CLEARANCE;
