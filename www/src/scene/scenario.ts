/** The page's scenes. */
export type { Scenario } from "parkade";
