import * as parkade from "parkade";
import { beforeAll, expect, test } from "vitest";
import { FIGURES } from "../../docs/.vitepress/lessons/figures";
import { meetingOf } from "../../docs/.vitepress/lessons/figures-grid";
import type { MetricFigure, MetricState } from "../../docs/.vitepress/lessons/metric-state";
import { initialMetric, solveMetric } from "../../docs/.vitepress/lessons/metric-state";
import { initialState, solve, type GridFigure, type GridState } from "../../docs/.vitepress/lessons/grid-state";

const engine = parkade;
beforeAll(async () => {
  await parkade.init();
});

/** Blocks the cells of a rectangle: columns and rows from the upper left corner, both ends included. */
function wall({ map }: GridState, x0: number, y0: number, x1: number, y1: number): void {
  for (let y = y0; y <= y1; y++)
    for (let x = x0; x <= x1; x++) {
      const cell = y * map.width + x;
      if (cell !== map.start && cell !== map.goal) map.walls[cell] = true;
    }
}

const clear = ({ map }: GridState): void => void map.walls.fill(false);
const move = ({ map }: GridState, end: "start" | "goal", x: number, y: number): void => {
  map[end] = y * map.width + x;
};

/** One way to do each task. */
const SOLUTIONS: Record<string, (state: GridState) => void> = {
  "flood-order": (state) => {
    state.share = 1;
  },
  "flood-estimate": (state) => {
    state.picked = 0;
  },
  "flood-trap": (state) => {
    clear(state);
    wall(state, 24, 1, 24, 16);
    wall(state, 1, 1, 24, 1);
    wall(state, 1, 16, 24, 16);
  },
  "flood-greedy": (state) => {
    wall(state, 15, 12, 15, 16);
    wall(state, 4, 16, 15, 16);
    wall(state, 20, 4, 20, 17);
  },
  "neighbours-count": (state) => move(state, "goal", 25, 17),
  "neighbours-angle": (state) => move(state, "goal", 25, 17),
  "neighbours-estimate": (state) => move(state, "goal", 25, 17),
  "neighbours-weight": (state) => {
    wall(state, 10, 3, 10, 7);
  },
  "both-meet": (state) => {
    state.share = meetingOf(state, "first")! / state.plans["first"]!.trace!.cells.length;
  },
  "both-first": (state) => {
    wall(state, 13, 2, 13, 9);
    wall(state, 21, 2, 21, 9);
  },
  "both-trap": (state) => {
    clear(state);
    wall(state, 27, 6, 27, 12);
    wall(state, 27, 6, 31, 6);
    wall(state, 27, 12, 31, 12);
  },
  "risk-dial": (state) => move(state, "goal", 4, 0),
  "risk-push": (state) => {
    wall(state, 8, 5, 8, 5);
  },
  "risk-price": (state) => {
    wall(state, 8, 9, 8, 15);
  },
  "rounding-prune": (state) => {
    wall(state, 15, 8, 15, 17);
    wall(state, 25, 0, 25, 9);
  },
  "rounding-sharp": (state) => {
    wall(state, 15, 8, 15, 17);
    wall(state, 25, 0, 25, 9);
  },
  "rounding-radius": (state) => {
    state.value = 8;
  },
};

const grids = Object.entries(FIGURES).filter((entry): entry is [string, GridFigure] => entry[1].kind === "grid");

test.each(grids)("the task of %s is open at first, and a solution does it", (id, figure) => {
  const state = initialState(figure);
  solve(state, engine);
  expect(figure.done(state)).toBe(false);
  SOLUTIONS[id]!(state);
  solve(state, engine);
  expect(figure.done(state)).toBe(true);
});

const CARS: Record<string, (state: MetricState) => void> = {
  "body-gap": (state) => {
    state.start = { x: 15.5, y: 9, heading: 0 };
  },
  "body-turn": (state) => {
    state.values["steer"] = 33;
  },
  "body-curves": (state) => {
    state.goal = { x: 9, y: 10, heading: 0 };
  },
  "body-forward": (state) => {
    const forward = state.curves.findIndex(({ arcs }) => arcs.every(([, , , , length]) => length > 0));
    state.values["curve"] = forward + 1;
  },
  "hybrid-ends": (state) => {
    state.start = { x: 12, y: 9, heading: 0 };
  },
  "hybrid-gears": (state) => {
    state.start = { x: 26, y: 9.5, heading: 0 };
  },
  "hybrid-tight": (state) => {
    state.values["margin"] = 0.25;
  },
  "road-decay": (state) => {
    state.values["factor"] = 3;
  },
  "road-shape": (state) => {
    state.values["amplitude"] = 1;
    state.values["decay"] = 0.5;
  },
  "road-lane": (state) => {
    state.values["laneWeight"] = 3;
  },
  "road-risk": (state) => {
    state.chosen = "cost";
  },
};

const metrics = Object.entries(FIGURES).filter((entry): entry is [string, MetricFigure] => entry[1].kind === "metric");

test.each(metrics)("the task of %s is open at first, and a solution does it", (id, figure) => {
  const state = initialMetric(figure);
  solveMetric(state, engine);
  expect(figure.done(state)).toBe(false);
  CARS[id]!(state);
  solveMetric(state, engine);
  expect(figure.done(state)).toBe(true);
});
