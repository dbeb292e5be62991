/** Scenes of other people's grids. */
import { beforeAll, expect, test } from "vitest";
import {
  fromOccupancy,
  fromOccupancyGrid,
  generateScenario,
  init,
  ParkadeError,
  Planner,
  unpackRuns,
  type Obstacle,
  type OccupancyGrid,
  type OccupancyOptions,
  type Scenario,
} from "parkade";

beforeAll(() => init());

const ENDS = { start: { x: 0.5, y: 0.5, heading: 0 }, goal: { x: 38.5, y: 38.5, heading: 0 } };
const MAP: OccupancyOptions = { ...ENDS, resolution: 1 };

/** The cells that a scene's first obstacle blocks, one value each, the southern row first. */
function cellsOf({ map, obstacles }: Scenario): Int8Array {
  const cells = new Int8Array(map.width * map.height);
  const [first] = obstacles as (Obstacle & { type: "cells"; runs: string | [number, number, number][] })[];
  const runs = first ? (typeof first.runs === "string" ? unpackRuns(first.runs) : first.runs) : [];
  for (const [x, y, count] of runs) cells.fill(1, y * map.width + x, y * map.width + x + count);
  return cells;
}

const upsideDown = (cells: Int8Array, width: number): Int8Array =>
  Int8Array.from(cells, (_, i) => cells[(cells.length / width - 1 - Math.floor(i / width)) * width + (i % width)]!);

test.each(Array.from({ length: 20 }, (_, seed) => seed))("map %i becomes the same scene from its cells", (seed) => {
  const drawn = generateScenario({ family: "random", size: 39, seed });
  const cells = cellsOf(drawn);
  const { start, goal, vehicle, map } = drawn;
  const options = { start, goal, ...(vehicle && { vehicle }), resolution: map.resolution, origin: map.origin };
  const expected = new Planner("eight", drawn).plan();
  const variants: Scenario[] = [
    fromOccupancy(cells, 39, options),
    fromOccupancy(Array.from(cells, Boolean), 39, options),
    fromOccupancy(upsideDown(cells, 39), 39, { ...options, rows: "top-down" }),
    fromOccupancy(
      Float32Array.from(cells, (cell) => cell * 0.7),
      39,
      { ...options, occupied: 0.5 },
    ),
    fromOccupancyGrid(
      {
        info: {
          width: 39,
          height: 39,
          resolution: map.resolution,
          origin: { position: { x: map.origin[0], y: map.origin[1], z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } },
        },
        data: Int8Array.from(cells, (cell) => cell * 100),
      },
      options,
    ),
  ];
  for (const scene of variants) {
    expect(cellsOf(scene)).toEqual(cells);
    const plan = new Planner("eight", scene).plan();
    expect([plan.outcome, plan.rawPath]).toEqual([expected.outcome, expected.rawPath]);
  }
});

test("unknown cells are blocked or free, by what is asked", () => {
  const cells = [0, -1, Number.NaN, 100, 64, 65];
  const ask = (options: Partial<OccupancyOptions>) => [...cellsOf(fromOccupancy(cells, 6, { ...MAP, ...options }))];
  expect(ask({ occupied: 65 })).toEqual([0, 1, 1, 1, 0, 1]);
  expect(ask({ occupied: 65, unknown: "free" })).toEqual([0, 0, 0, 1, 0, 1]);
});

test("costs of cells steer a planner that takes them, and a weight of 1 is nothing", () => {
  const free = new Uint8Array(400);
  const options: OccupancyOptions = {
    resolution: 1,
    start: { x: 0.5, y: 10.5, heading: 0 },
    goal: { x: 19.5, y: 10.5, heading: 0 },
  };
  const costs = new Uint8Array(400).fill(1);
  expect(fromOccupancy(free, 20, { ...options, costs }).costs).toBeUndefined();
  for (let y = 8; y < 20; y++) costs[y * 20 + 10] = 10;
  const scene = fromOccupancy(free, 20, { ...options, costs });
  expect(scene.costs).toEqual([{ weight: 10, runs: Array.from({ length: 12 }, (_, i) => [10, i + 8, 1]) }]);
  /** Where it crosses the column of dear cells. */
  const crossing = (one: Scenario): number => {
    const { rawPath } = new Planner("four", one).plan();
    const at = Array.from({ length: rawPath.length / 2 }, (_, i) => i).find((i) => rawPath[2 * i] === 10.5)!;
    return rawPath[2 * at + 1]!;
  };
  expect(crossing(fromOccupancy(free, 20, options))).toBeGreaterThan(8);
  expect(crossing(scene)).toBeLessThan(8);
});

const grid = (change: Partial<OccupancyGrid["info"]>, data: ArrayLike<number> = new Int8Array(4)): OccupancyGrid => ({
  info: { width: 2, height: 2, resolution: 1, origin: { position: { x: 0, y: 0 } }, ...change },
  data,
});

test.each<[string, () => unknown, string]>([
  ["no options", () => fromOccupancy([0], 1, undefined as never), "options: must be an object"],
  ["no cells", () => fromOccupancy(undefined as never, 1, MAP), "cells: must be an array of cells, got undefined"],
  ["text", () => fromOccupancy("0" as never, 1, MAP), 'cells: must be an array of cells, got "0"'],
  [
    "rows in rows",
    () => fromOccupancy([[0]] as never, 1, MAP),
    "cells: must be one flat list of cells, got a list of lists",
  ],
  [
    "no width",
    () => fromOccupancy([0], undefined as never, MAP),
    "width: must be a whole number from 1 to 4096, got undefined",
  ],
  ["a wide map", () => fromOccupancy([0], 5000, MAP), "width: must be a whole number from 1 to 4096, got 5000"],
  ["half a row", () => fromOccupancy([0, 0, 0], 2, MAP), "cells: must be 1 to 4096 whole rows of 2 cells, got 3 cells"],
  ["an empty map", () => fromOccupancy([], 2, MAP), "cells: must be 1 to 4096 whole rows of 2 cells, got 0 cells"],
  [
    "rows",
    () => fromOccupancy([0], 1, { ...MAP, rows: "up" as never }),
    'rows: must be "bottom-up" or "top-down", got "up"',
  ],
  [
    "unknown",
    () => fromOccupancy([0], 1, { ...MAP, unknown: 3 as never }),
    'unknown: must be "blocked" or "free", got 3',
  ],
  ["occupied", () => fromOccupancy([0], 1, { ...MAP, occupied: "1" as never }), 'occupied: must be a number, got "1"'],
  ["origin", () => fromOccupancy([0], 1, { ...MAP, origin: 3 as never }), "origin: must be [x, y] in metres, got 3"],
  ["obstacles", () => fromOccupancy([0], 1, { ...MAP, obstacles: 3 as never }), "obstacles: must be a list, got 3"],
  [
    "few costs",
    () => fromOccupancy([0, 0], 2, { ...MAP, costs: [1] }),
    "costs: must be 2 weights, one per cell, got 1",
  ],
  [
    "low costs",
    () => fromOccupancy([0, 0], 2, { ...MAP, costs: [1, 0] }),
    "costs[1]: must be a whole number from 1 to 10, got 0",
  ],
  ["no message", () => fromOccupancyGrid(null as never, ENDS), "message: must be an object, got null"],
  ["no info", () => fromOccupancyGrid({} as never, ENDS), "message.info: must be an object, got undefined"],
  ["few data", () => fromOccupancyGrid(grid({}, [0]), ENDS), "message.data: must be 2 × 2 cells, got 1"],
  [
    "a rotated map",
    () => fromOccupancyGrid(grid({ origin: { position: { x: 0, y: 0 }, orientation: { z: 0.1, w: 0.995 } } }), ENDS),
    "message.info.origin.orientation: must be without rotation",
  ],
  [
    "no position",
    () => fromOccupancyGrid(grid({ origin: { position: { x: "a" as never, y: 0 } } }), ENDS),
    'message.info.origin.position.x: must be a number, got "a"',
  ],
])("%s is refused in words", (_, asked, message) => {
  let error: unknown;
  try {
    asked();
  } catch (thrown) {
    error = thrown;
  }
  expect(error).toBeInstanceOf(ParkadeError);
  expect((error as ParkadeError).message).toContain(message);
  expect((error as ParkadeError).code).toBe("bad-input");
});
