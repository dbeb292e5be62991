/** How each planner is told apart, the same everywhere: name, colour, dash and marker. */
import type { PlannerId, PlannerInfo } from "parkade";
import { isMessage, translate, type Lang } from "../i18n/index";

export type Shape =
  | "circle"
  | "triangle"
  | "square"
  | "diamond"
  | "plus"
  | "pentagon"
  | "wedge"
  | "cross"
  | "hexagon"
  | "bars";

/** `colour` counts the `--parkade-planner-…` properties from 1. */
export interface Identity {
  colour: number;
  dash: readonly number[];
  shape: Shape;
}

/** For the time before a module is loaded, as well. */
const FIRST: Record<string, Identity> = {
  four: { colour: 1, dash: [], shape: "circle" },
  eight: { colour: 2, dash: [9, 5], shape: "triangle" },
  "risk-field": { colour: 3, dash: [10, 4, 2, 4], shape: "square" },
  hybrid: { colour: 4, dash: [], shape: "diamond" },
  "hybrid-forward": { colour: 5, dash: [14, 5], shape: "plus" },
};
/**
 * The others take colour, dash and marker in turn; the three cycles are prime to each other, so that none repeats soon.
 */
const COLOURS = [6, 5],
  DASHES: readonly (readonly number[])[] = [
    [4, 4],
    [2, 3],
    [12, 3, 2, 3, 2, 3],
  ];
const SHAPES: readonly Shape[] = ["pentagon", "wedge", "cross", "hexagon", "bars"];

let catalogue: readonly PlannerInfo[] = [];

/** Makes the planners of a loaded module known by name. */
export function introduce(planners: readonly PlannerInfo[]): void {
  catalogue = planners;
}

export function identityOf(planner: string): Identity {
  const known = FIRST[planner];
  if (known) return known;
  const at = Math.max(
    0,
    catalogue.filter((info) => !(info.id in FIRST)).findIndex((info) => info.id === planner),
  );
  return { colour: COLOURS[at % 2]!, dash: DASHES[at % 3]!, shape: SHAPES[at % 5]! };
}

/** The loaded module's facts of a planner. */
export const infoOf = (planner: string): PlannerInfo | undefined => catalogue.find((info) => info.id === planner);

/** True if it plans for a car that drives and steers. */
export const drivesCar = (planner: string): boolean => infoOf(planner)?.family === "hybrid";

/** True if it plans on a road's cost map. */
export const plansRoads = (planner: PlannerId): planner is "cost-map" => infoOf(planner)?.family === "road";

/** True if a planner looks at a field of risk. */
export const hasField = (planner: string): boolean => infoOf(planner)?.hasRiskField === true;

export function plannerName(lang: Lang, planner: string): string {
  const key = `planner.${planner}`;
  return isMessage(key) ? translate(lang, key) : (infoOf(planner)?.title[lang] ?? planner);
}

/** For a phone's chips. */
export function shortName(lang: Lang, planner: PlannerId): string {
  const key = `short.${planner}`;
  return isMessage(key) ? translate(lang, key) : plannerName(lang, planner);
}
