/** The things of a scene by their ids, and which of them is selected. */
import type { Scenario } from "./scenario";

export type Selection =
  | { kind: "start" | "goal" }
  | { kind: "obstacle" | "slot" | "moving" | "cost"; id: string }
  | { kind: "group"; ids: readonly string[] }
  | null;

/** Everything in a scene that has an id. */
export const thingsOf = ({ obstacles = [], slots = [], costs = [], moving = [] }: Scenario) => [
  ...obstacles,
  ...slots,
  ...costs,
  ...moving,
];

export const isPose = (selection: Selection | undefined): selection is { kind: "start" | "goal" } =>
  selection?.kind === "start" || selection?.kind === "goal";
