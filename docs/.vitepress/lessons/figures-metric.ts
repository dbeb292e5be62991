/** Lessons 6 to 8: bodies and curves, hybrid A*, roads. */
import type { Obstacle, Pose, Scenario } from "parkade";
import {
  curveOf,
  curvatureOf,
  hybridOf,
  roadOf,
  type MetricChoice,
  type MetricFigure,
  type MetricState,
} from "./metric-state";

const block = (left: number, bottom: number, right: number, top: number): Obstacle => ({
  type: "rectangle",
  center: [(left + right) / 2, (bottom + top) / 2],
  size: [right - left, top - bottom],
});

function lot(obstacles: Obstacle[], start: Pose, goal: Pose): Scenario {
  return {
    version: 1,
    map: { origin: [0, 0], width: 68, height: 36, resolution: 0.5 },
    obstacles,
    start,
    goal,
  };
}

const pose = (x: number, y: number, heading = 0): Pose => ({ x, y, heading });

export const body: Record<string, MetricFigure> = {
  "body-gap": {
    kind: "metric",
    scene: lot([block(15, 0, 19, 7.4), block(15, 10.6, 19, 18)], pose(5, 12, 0.5), pose(30, 9)),
    across: 34,
    shows: "body",
    done: ({ check, start }) => check!.hits === 0 && Math.abs(start.x + 1.75 * Math.cos(start.heading) - 17) < 1.5,
  },
  "body-turn": {
    kind: "metric",
    scene: lot([block(15, 0, 21, 9)], pose(6, 4.5), pose(30, 9)),
    across: 34,
    shows: "arc",
    moves: [],
    sliders: [
      { setting: "steer", min: -34, max: 34, step: 1, value: 15, title: ["Steering, °", "前轮转角，°"] },
      { setting: "metres", min: 2, max: 12, step: 0.5, value: 10, title: ["Drive, m", "行驶，m"] },
    ],
    done: (state) => state.check!.hits === 0 && curvatureOf(state) * state.values["metres"]! > 1.3,
  },
  "body-curves": {
    kind: "metric",
    scene: lot([], pose(9, 8), pose(21, 9, 0.4)),
    across: 34,
    shows: "curves",
    sliders: [{ setting: "curve", min: 1, max: 24, step: 1, value: 1, title: ["Curve", "曲线"] }],
    done: ({ curves }) => curves[0]?.directionChanges === 2,
  },
  "body-forward": {
    kind: "metric",
    scene: lot([], pose(9, 7), pose(24, 12, 2.6)),
    across: 34,
    shows: "curves",
    sliders: [{ setting: "curve", min: 1, max: 24, step: 1, value: 1, title: ["Curve", "曲线"] }],
    done: (state) =>
      curveOf(state) !== undefined &&
      curveOf(state) === state.curves.find(({ arcs }) => arcs.every(([, , , , length]) => length > 0)),
  },
};

const FROM_GOAL: MetricChoice = { key: "goal", planner: "hybrid", title: ["From the goal", "从终点"] };
const FROM_START: MetricChoice = { key: "start", planner: "hybrid-forward", title: ["From the start", "从起点"] };
/** A bay of 3.2 m between two parked cars, below an aisle. */
const BAY = [block(0, 0, 14.4, 5.8), block(17.6, 0, 34, 5.8), block(0, 13, 34, 18)];

export const hybrid: Record<string, MetricFigure> = {
  "hybrid-ends": {
    kind: "metric",
    scene: lot(BAY, pose(3, 9), pose(16, 1.4, Math.PI / 2)),
    across: 34,
    shows: "plan",
    choices: [FROM_GOAL, FROM_START],
    done: (state) => {
      const [goal, start] = ["goal", "start"].map((key) => hybridOf(state, key));
      return goal!.outcome === "found" && start!.stats.expanded >= 50 * goal!.stats.expanded;
    },
  },
  "hybrid-gears": {
    kind: "metric",
    scene: lot(BAY, pose(3, 9), pose(16, 1.4, Math.PI / 2)),
    across: 34,
    shows: "plan",
    choices: [FROM_GOAL],
    done: (state) => hybridOf(state).outcome === "found" && hybridOf(state).metrics.directionChanges === 0,
  },
  "hybrid-tight": {
    kind: "metric",
    scene: lot(BAY, pose(3, 9), pose(16, 1.4, Math.PI / 2)),
    across: 34,
    shows: "plan",
    choices: [FROM_GOAL],
    sliders: [{ setting: "margin", min: 0, max: 0.5, step: 0.05, value: 0.1, title: ["Margin, m", "余量，m"] }],
    done: (state) => hybridOf(state).outcome === "found" && hybridOf(state).metrics.directionChanges >= 3,
  },
};

const ROAD: Scenario = {
  version: 1,
  map: { origin: [0, 0], width: 136, height: 72, resolution: 0.5 },
  obstacles: [block(0, 0, 68, 10), block(0, 26, 68, 36), block(16, 10, 24, 15), block(40, 19, 48, 26)],
  start: pose(4, 14),
  goal: pose(62, 20),
};
/** The room that the planner asks for besides what its costs say would hide them. */
const COST: MetricChoice = {
  key: "cost",
  planner: "cost-map",
  settings: { margin: 0 },
  title: ["Cost map", "代价地图"],
};
const PLAIN: MetricChoice = {
  key: "plain",
  planner: "eight",
  settings: { post: "prune" },
  title: ["8 neighbours, pruned", "八邻域，剪枝"],
};
const EXPONENTIAL: MetricChoice = { ...COST, settings: { margin: 0, base: "exponential" } };

const clearOf = (state: MetricState): number =>
  roadOf(state, "cost").outcome === "found" ? roadOf(state, "cost").metrics.minClearance : 0;

const LANES: Scenario = {
  ...ROAD,
  obstacles: [block(0, 0, 68, 10), block(0, 26, 68, 36)],
  start: pose(4, 22),
  goal: pose(62, 22),
  lanes: [{ start: pose(0, 14), pieces: [{ length: 68 }], width: 8 }],
};

export const road: Record<string, MetricFigure> = {
  "road-decay": {
    kind: "metric",
    scene: ROAD,
    across: 68,
    shows: "cost",
    choices: [COST],
    sliders: [{ setting: "factor", min: 0.2, max: 3, step: 0.1, value: 0.2, title: ["Weight", "权重"] }],
    done: (state) => clearOf(state) >= 1.3,
  },
  "road-shape": {
    kind: "metric",
    scene: ROAD,
    across: 68,
    shows: "cost",
    choices: [EXPONENTIAL],
    sliders: [
      { setting: "amplitude", min: 1, max: 10, step: 0.5, value: 10, title: ["Height", "高度"] },
      { setting: "decay", min: 0.5, max: 4, step: 0.1, value: 4, title: ["Decay, 1/m", "衰减，1/m"] },
    ],
    done: (state) => clearOf(state) >= 1.2,
  },
  "road-lane": {
    kind: "metric",
    scene: LANES,
    across: 68,
    shows: "cost",
    choices: [COST],
    sliders: [{ setting: "laneWeight", min: 0, max: 3, step: 0.1, value: 0, title: ["Lane weight", "车道权重"] }],
    done: (state) => (roadOf(state, "cost").metrics.laneDeviationMean ?? Number.POSITIVE_INFINITY) < 2,
  },
  "road-risk": {
    kind: "metric",
    scene: ROAD,
    across: 68,
    shows: "cost",
    choices: [PLAIN, COST],
    drives: 300,
    done: ({ chosen, hits }) => chosen === "cost" && hits === 0,
  },
};
