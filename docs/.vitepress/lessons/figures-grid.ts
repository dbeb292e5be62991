/** Lessons 2 to 5: neighbours and estimates, both ends, the risk field, pruning and arcs. */
import { cellOf } from "./grid-map";
import { costOf, type Choice, type GridFigure, type GridState } from "./grid-state";

const FOUR: Choice = { key: "four", planner: "four", title: ["4 neighbours", "四邻域"] };
const EIGHT: Choice = { key: "eight", planner: "eight", title: ["8 neighbours", "八邻域"] };
const SIXTEEN: Choice = { key: "sixteen", planner: "sixteen", title: ["16 neighbours", "十六邻域"] };

/** An empty map, or one with walls of so many rows from a row in these columns. */
function field(
  width: number,
  height: number,
  ends: [number, number][],
  walls: [x: number, y: number, rows: number][] = [],
) {
  return Array.from({ length: height }, (_, y) =>
    Array.from({ length: width }, (_, x) => {
      const [start, goal] = ends.map(([column, row]) => column === x && row === y);
      if (start) return "S";
      if (goal) return "G";
      return walls.some(([column, from, rows]) => column === x && y >= from && y < from + rows) ? "#" : ".";
    }).join(""),
  );
}

/** Goals off the axis: beside it, and between two of eight directions. */
const BESIDE = field(34, 18, [
  [5, 9],
  [28, 8],
]);
const SLANTED = field(34, 18, [
  [5, 9],
  [28, 4],
]);
const GATES = field(
  34,
  18,
  [
    [4, 9],
    [29, 9],
  ],
  [
    [11, 3, 12],
    [21, 0, 11],
    [21, 14, 4],
  ],
);

const expandedBy = ({ plans }: GridState, key: string): number => plans[key]!.stats.expanded;
const found = ({ plans }: GridState): boolean => Object.values(plans).every(({ outcome }) => outcome === "found");

/** Straight distance from start to goal in cells. */
function straightOf({ map: { width, start, goal } }: GridState): number {
  return Math.hypot((goal % width) - (start % width), Math.floor(goal / width) - Math.floor(start / width));
}

export const neighbours: Record<string, GridFigure> = {
  "neighbours-count": {
    kind: "grid",
    map: BESIDE,
    choices: [FOUR, EIGHT],
    view: "search",
    done: (state) => found(state) && 2 * expandedBy(state, "four") < expandedBy(state, "eight"),
  },
  "neighbours-angle": {
    kind: "grid",
    map: SLANTED,
    choices: [EIGHT, SIXTEEN],
    view: "search",
    done: (state) => found(state) && costOf(state.plans["eight"]) >= 1.08 * straightOf(state),
  },
  "neighbours-estimate": {
    kind: "grid",
    map: BESIDE,
    choices: [
      { ...EIGHT, key: "octile", settings: { heuristic: "octile" }, title: ["Octile", "八方距离"] },
      { ...EIGHT, key: "euclid", settings: { heuristic: "euclid" }, title: ["Straight line", "直线距离"] },
      { ...EIGHT, key: "chebyshev", settings: { heuristic: "chebyshev" }, title: ["Larger side", "较大边"] },
    ],
    chosen: 1,
    view: "search",
    done: (state) => found(state) && expandedBy(state, "octile") * 2 < expandedBy(state, "euclid"),
  },
  "neighbours-weight": {
    kind: "grid",
    map: SLANTED,
    choices: [
      { ...EIGHT, key: "exact", title: ["Never too high", "从不偏高"] },
      { ...EIGHT, key: "weighted", settings: { weight: "distance" }, title: ["Weighted", "加权"] },
    ],
    chosen: 1,
    view: "search",
    done: ({ plans }) =>
      plans["exact"]!.outcome === "found" && costOf(plans["weighted"]) > 1.01 * costOf(plans["exact"]),
  },
};

const FIRST: Choice = {
  key: "first",
  planner: "sixteen-bidirectional",
  settings: { stop: "first" },
  title: ["First meeting", "首次相遇"],
};
const PROVEN: Choice = { ...FIRST, key: "proven", settings: { stop: "nba" }, title: ["Until proven", "直到证明最短"] };
const ONE_WAY: Choice = { ...SIXTEEN, key: "one", title: ["One end", "单向"] };

/** How many cells had been expanded when a cell beside both sides came; null if that never happened. */
export function meetingOf(state: GridState, key: string): number | null {
  const trace = state.plans[key]?.trace,
    { map } = state,
    side = new Map<number, Set<"S" | "G">>([
      [map.start, new Set(["S"])],
      [map.goal, new Set(["G"])],
    ]);
  for (const [i, index] of [...(trace?.cells ?? [])].entries()) {
    const cell = cellOf(map, index),
      sides = new Set(side.get(cell));
    for (let y = -2; y <= 2; y++)
      for (let x = -2; x <= 2; x++) {
        const column = (cell % map.width) + x;
        if (column >= 0 && column < map.width)
          for (const one of side.get(cell + y * map.width + x) ?? []) sides.add(one);
      }
    if (sides.size > 1) return i + 1;
    side.set(cell, sides);
  }
  return null;
}

export const both: Record<string, GridFigure> = {
  "both-meet": {
    kind: "grid",
    map: GATES,
    choices: [FIRST],
    view: "search",
    share: 0.3,
    done: (state) => {
      const all = state.plans["first"]!.trace!.cells.length,
        meeting = meetingOf(state, "first");
      return meeting !== null && Math.abs(state.share * all - meeting) <= 0.03 * all;
    },
  },
  "both-first": {
    kind: "grid",
    map: SLANTED,
    choices: [FIRST, PROVEN],
    view: "search",
    done: (state) => found(state) && costOf(state.plans["first"]) > costOf(state.plans["proven"]) + 1e-6,
  },
  "both-trap": {
    kind: "grid",
    map: GATES,
    choices: [ONE_WAY, PROVEN],
    view: "search",
    done: (state) => found(state) && 2 * expandedBy(state, "proven") < expandedBy(state, "one"),
  },
};

const RISK: Choice = { key: "risk", planner: "risk-field", title: ["Risk field", "风险场"] };
const SMALL = field(17, 9, [
  [2, 6],
  [14, 2],
]);
const CLOSE = field(17, 9, [
  [2, 4],
  [11, 4],
]);

const angleOf = ([x, y]: readonly [number, number]): number => Math.atan2(y, x);

export const risk: Record<string, GridFigure> = {
  "risk-dial": {
    kind: "grid",
    map: SMALL,
    choices: [RISK],
    view: "force",
    picked: [8, 4],
    done: ({ explanation }) => explanation?.center === 3,
  },
  "risk-push": {
    kind: "grid",
    map: CLOSE,
    choices: [RISK],
    view: "force",
    picked: [8, 4],
    done: ({ explanation }) => {
      if (!explanation) return false;
      const turn = angleOf(explanation.force) - angleOf(explanation.attraction);
      return Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn))) >= Math.PI / 4;
    },
  },
  "risk-price": {
    kind: "grid",
    map: SLANTED,
    choices: [EIGHT, RISK],
    chosen: 1,
    view: "search",
    done: (state) => found(state) && costOf(state.plans["risk"]) > 1.02 * costOf(state.plans["eight"]),
  },
};

export const rounding: Record<string, GridFigure> = {
  "rounding-prune": {
    kind: "grid",
    map: GATES,
    choices: [RISK],
    view: "stages",
    done: ({ plans, stage }) => stage !== "raw" && (plans["risk"]!.stages?.pruned.length ?? 0) >= 7,
  },
  "rounding-sharp": {
    kind: "grid",
    map: GATES,
    choices: [RISK],
    view: "stages",
    done: ({ plans }) => (plans["risk"]!.stages?.sharp.length ?? 0) > 0,
  },
  "rounding-radius": {
    kind: "grid",
    map: GATES,
    choices: [RISK],
    view: "stages",
    slider: { setting: "minRadius", min: 0.5, max: 8, step: 0.25, value: 1, title: ["Smallest radius", "最小半径"] },
    done: ({ plans }) => (plans["risk"]!.stages?.sharp.length ?? 0) > 0,
  },
};
