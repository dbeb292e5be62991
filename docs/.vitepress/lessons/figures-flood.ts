/** Lesson 1: from flood to A*. */
import { costOf, expandedOf, type Choice, type GridFigure } from "./grid-state";

const FLOOD: Choice = { key: "flood", planner: "dijkstra", title: ["Flood", "泛洪"] };
const ASTAR: Choice = { key: "astar", planner: "eight", title: ["A*", "A*"] };
const GREEDY: Choice = { key: "greedy", planner: "greedy", title: ["Greedy", "贪婪"] };

const ROOMS = [
  "..................................",
  "..................................",
  "..........#.......................",
  "..........#...........#...........",
  "..........#...........#...........",
  "..........#...........#...........",
  "..........#...........#...........",
  "..........#...........#...........",
  "..........#...........#...........",
  "....S.....#...........#......G....",
  "..........#...........#...........",
  "..........#...........#...........",
  "..........#...........#...........",
  "..........#...........#...........",
  "......................#...........",
  "......................#...........",
  "..................................",
  "..................................",
];

const OPEN = [
  "..................................",
  "..................................",
  "..................................",
  "..................................",
  "..................................",
  "...............#..................",
  "...............#..................",
  "...............#..................",
  "...............#..................",
  ".....S.........#............G.....",
  "...............#..................",
  "...............#..................",
  "..................................",
  "..................................",
  "..................................",
  "..................................",
  "..................................",
  "..................................",
];

const EPSILON = 1e-9;

export const flood: Record<string, GridFigure> = {
  "flood-order": {
    kind: "grid",
    map: ROOMS,
    choices: [FLOOD],
    view: "search",
    share: 0.4,
    done: ({ share }) => share === 1,
  },
  "flood-estimate": {
    kind: "grid",
    map: OPEN,
    choices: [FLOOD, ASTAR],
    chosen: 1,
    view: "search",
    picked: [9, 9],
    done: (state) =>
      state.chosen === "astar" &&
      state.costs !== null &&
      !expandedOf(state, 1).includes(state.picked!) &&
      state.costs.g + state.costs.h > costOf(state.plans["astar"]) + EPSILON,
  },
  "flood-trap": {
    kind: "grid",
    map: OPEN,
    choices: [FLOOD, ASTAR],
    chosen: 1,
    view: "search",
    done: ({ plans }) =>
      plans["astar"]!.outcome === "found" && plans["astar"]!.stats.expanded >= 0.75 * plans["flood"]!.stats.expanded,
  },
  "flood-greedy": {
    kind: "grid",
    map: OPEN,
    choices: [FLOOD, ASTAR, GREEDY],
    chosen: 2,
    view: "search",
    done: ({ plans }) =>
      plans["astar"]!.outcome === "found" && costOf(plans["greedy"]) >= 1.1 * costOf(plans["astar"]) - EPSILON,
  },
};
