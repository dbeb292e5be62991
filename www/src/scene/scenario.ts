/** The page's scenes: they have one goal. */
import type { Goal, Scenario as AnyScenario } from "parkade";

export type Scenario = AnyScenario<Goal>;
