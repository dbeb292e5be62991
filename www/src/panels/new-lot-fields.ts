/** The fields of the form for a new lot. */
import type { LotForm, NumberField, Sizes } from "../scene/lot";

export type Block = "ground" | "bays" | "obstacles" | "vehicle";
export type Choice = "kind" | "sides" | "entrance" | "entry" | "car";

export const BLOCKS: Record<Block, readonly (keyof LotForm)[]> = {
  ground: ["width", "depth", "entrance"],
  bays: ["kind", "angle", "count", "bayWidth", "bayLength", "sides", "aisles", "aisle"],
  obstacles: ["parked", "every", "column", "wall"],
  vehicle: ["car", "carLength", "carWidth", "wheelbase", "radius", "entry"],
};
export const CHOICES: { [K in Choice]: readonly LotForm[K][] } = {
  kind: ["perpendicular", "angled", "parallel"],
  sides: ["one", "both"],
  entrance: ["left", "right", "bottom", "top"],
  entry: ["reverse-in", "head-in"],
  car: ["sedan", "paper", "own"],
};
export const UNITS: Partial<Record<NumberField, string>> = { angle: "°", count: "", aisles: "", parked: "", every: "" };
export const isChoice = (field: keyof LotForm): field is Choice => field in CHOICES;

/** The number that a field shows while it follows others. */
export function followed(field: NumberField, { width, depth, bay }: Sizes): number {
  switch (field) {
    case "width":
      return width;
    case "depth":
      return depth;
    case "bayWidth":
      return bay.width;
    case "bayLength":
      return bay.length;
    default:
      return NaN;
  }
}
