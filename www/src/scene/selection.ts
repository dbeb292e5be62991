/** The things of a scene by their ids, and which of them is selected. */
export type Selection =
  | { kind: "start" | "goal" }
  | { kind: "obstacle" | "slot" | "moving" | "cost"; id: string }
  | { kind: "group"; ids: readonly string[] }
  | null;

/** Everything in a scene that has an id. */
export const thingsOf = <Obstacle, Slot, Cost, Moving>({
  obstacles = [],
  slots = [],
  costs = [],
  moving = [],
}: {
  obstacles?: Obstacle[];
  slots?: Slot[];
  costs?: Cost[];
  moving?: Moving[];
}): (Obstacle | Slot | Cost | Moving)[] => [...obstacles, ...slots, ...costs, ...moving];

export const isPose = (selection: Selection | undefined): selection is { kind: "start" | "goal" } =>
  selection?.kind === "start" || selection?.kind === "goal";
