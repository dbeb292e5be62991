/** Scenes, settings and goals that bring about every kind of answer. */
import * as parkade from "parkade";
import type { Goal, GoalSet, PlannerId, Scenario } from "parkade";

/** Few enough for a test of every scene; an unfinished search answers as well. */
export const FEW = { maxExpansions: 4000, finestLevel: 1 };

export const scene = (id: string): Scenario<Goal> => parkade.scenario(id);

/** Scenes that fail, each in its way. */
export function failing(): Record<string, [PlannerId, Scenario, object?]> {
  const lot = scene("perpendicular"),
    wall = { type: "rectangle" as const, size: [3, 3] as [number, number] };
  const at = (where: "start" | "goal"): Scenario => {
    const { [where]: pose } = parkade.sceneGeometry(lot);
    return { ...lot, obstacles: [...(lot.obstacles ?? []), { ...wall, center: [pose.x, pose.y] }] };
  };
  const far = { x: 1e4, y: 1e4, heading: 0 };
  const walled: Scenario = {
    version: 1,
    map: { origin: [0, 0], width: 60, height: 30, resolution: 0.5 },
    vehicle: "sedan",
    obstacles: [
      {
        type: "wall",
        points: [
          [15, 0],
          [15, 15],
        ],
        thickness: 0.2,
      },
    ],
    start: { x: 6, y: 7, heading: 0 },
    goal: { x: 24, y: 7, heading: 0 },
  };
  const gap: Scenario = {
    ...walled,
    obstacles: [
      {
        type: "wall",
        points: [
          [15, 0],
          [15, 7],
        ],
        thickness: 0.2,
      },
      {
        type: "wall",
        points: [
          [15, 8.2],
          [15, 15],
        ],
        thickness: 0.2,
      },
    ],
  };
  const box: Scenario = {
    ...walled,
    start: { x: 6, y: 7, heading: 0 },
    obstacles: [
      {
        type: "wall",
        points: [
          [5, 8],
          [5, 6],
          [9.8, 6],
          [9.8, 8],
        ],
      },
    ],
  };
  return {
    "start-blocked": ["hybrid", at("start")],
    "goal-blocked": ["hybrid", at("goal")],
    "start-outside": ["eight", { ...lot, start: far }],
    "goal-outside": ["four", { ...lot, goal: far }],
    "budget-spent": ["four", scene("trap-60"), { maxExpansions: 5 }],
    walled: ["hybrid", walled],
    gap: ["hybrid", gap],
    box: ["hybrid-forward", box],
    cells: ["eight", walled],
    road: ["cost-map", walled],
    incomplete: [
      "risk-field",
      parkade.generateScenario({ family: "random", size: 40, seed: 2, densityPermille: 300 }),
      { fallback: "none" },
    ],
  };
}

export const GOALS: GoalSet[] = [
  { slots: "free", entry: "either" },
  { slots: ["slot-1"], entry: "reverse-in" },
  [
    { x: 6, y: 9, heading: 0 },
    { x: 10, y: 9, heading: 0 },
  ],
  {
    region: [
      [1, 1],
      [30, 1],
      [30, 30],
      [1, 30],
    ],
  },
];
