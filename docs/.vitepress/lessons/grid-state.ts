/** What a grid figure knows: its map, the planners' answers, and what the reader looks at. */
import type { Explanation, GridPlan, GridPlannerId, PlannerSettings } from "parkade";
import { cellOf, mapOf, middleOf, sceneOf, type GridMap } from "./grid-map";
import type { Text } from "./words";

export type Engine = Pick<typeof import("parkade"), "Planner">;

export interface Choice {
  /** Unique in the figure. */
  key: string;
  planner: GridPlannerId;
  settings?: Record<string, number | boolean | string>;
  title: Text;
}

export interface Slider {
  setting: string;
  min: number;
  max: number;
  step: number;
  value: number;
  title: Text;
}

export interface GridFigure {
  kind: "grid";
  map: readonly string[];
  choices: readonly Choice[];
  /** The choice drawn at first, by its index. */
  chosen?: number;
  /** What is drawn beside walls and path. */
  view: "search" | "force" | "stages";
  slider?: Slider;
  /** The part of the search that is drawn at first, 0 to 1; default 1. */
  share?: number;
  /** The cell that is picked at first: column, row from the top. */
  picked?: readonly [number, number];
  /** True once the reader has done the task. */
  done(state: GridState): boolean;
}

/** The costs of the best path through a cell, in cells. */
export interface Costs {
  g: number;
  h: number;
}

export interface GridState {
  figure: GridFigure;
  map: GridMap;
  /** The key of the choice that is drawn. */
  chosen: string;
  share: number;
  /** Of the figure's slider. */
  value: number;
  stage: "raw" | "pruned" | "arcs";
  plans: Record<string, GridPlan>;
  picked: number | null;
  /** Of the picked cell; null on walls and where no way leads. */
  costs: Costs | null;
  explanation: Explanation | null;
}

export function initialState(figure: GridFigure): GridState {
  const map = mapOf(figure.map);
  return {
    figure,
    map,
    chosen: figure.choices[figure.chosen ?? 0]!.key,
    share: figure.share ?? 1,
    value: figure.slider?.value ?? 0,
    stage: "arcs",
    plans: {},
    picked: figure.picked ? figure.picked[1] * map.width + figure.picked[0] : null,
    costs: null,
    explanation: null,
  };
}

function settingsOf(state: GridState, { settings, planner }: Choice): PlannerSettings[GridPlannerId] {
  const { slider } = state.figure;
  const own = slider && planner === chosenOf(state).planner ? { [slider.setting]: state.value } : {};
  return { ...settings, ...own } as PlannerSettings[GridPlannerId];
}

export const chosenOf = ({ figure, chosen }: GridState): Choice => figure.choices.find(({ key }) => key === chosen)!;

/** Plans with every choice, and looks at the picked cell. */
export function solve(state: GridState, { Planner }: Engine): void {
  const scene = sceneOf(state.map);
  for (const choice of state.figure.choices) {
    const planner = new Planner(choice.planner, scene, settingsOf(state, choice));
    state.plans[choice.key] = planner.plan({ trace: true }) as GridPlan;
    if (choice.key === state.chosen && state.picked !== null && state.figure.view === "force")
      state.explanation = planner.explain(middleOf(state.map, state.picked));
    planner.free();
  }
  state.costs = state.picked === null || state.figure.view !== "search" ? null : costsOf(state, { Planner });
}

const MICRO = 1e6;

/** g is the cheapest way from the start by this choice's moves; h its straight estimate. */
function costsOf({ map, picked, ...state }: GridState, { Planner }: Engine): Costs | null {
  if (picked === null || map.walls[picked]) return null;
  const from = middleOf(map, map.start),
    to = middleOf(map, map.goal),
    at = middleOf(map, picked);
  const planner = new Planner("dijkstra", sceneOf(map));
  const { outcome, costMicro } = planner.search(from, at);
  planner.free();
  if (outcome !== "found") return null;
  const chosen = chosenOf({ map, picked, ...state });
  return { g: costMicro / MICRO, h: chosen.planner === "dijkstra" ? 0 : Math.hypot(to.x - at.x, to.y - at.y) };
}

/** Cells of this map in order of expansion, up to the share that is shown. */
export function expandedOf(state: GridState, share = state.share): number[] {
  const trace = state.plans[state.chosen]?.trace;
  if (!trace) return [];
  const cells = Array.from(trace.cells, (cell) => cellOf(state.map, cell));
  return cells.slice(0, Math.round(cells.length * share));
}

/** The path's cost by its moves, in cells; Infinity where there is none. */
export function costOf(plan: GridPlan | undefined): number {
  return plan?.outcome === "found" ? (plan.metrics.lengthRaw ?? Number.POSITIVE_INFINITY) : Number.POSITIVE_INFINITY;
}
