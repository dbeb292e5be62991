/** A small map that a reader draws on: cells, counted from the upper left corner. */
import type { Run, Scenario } from "parkade";

export interface GridMap {
  width: number;
  height: number;
  /** Per cell, row by row from the top: true if it is a wall. */
  walls: boolean[];
  /** Indices of cells. */
  start: number;
  goal: number;
}

/** Reads a map: `#` is a wall, `S` the start, `G` the goal, and anything else is free. */
export function mapOf(rows: readonly string[]): GridMap {
  const width = rows[0]!.length,
    letters = rows.join("");
  if (rows.some((row) => row.length !== width)) throw new Error("a map's rows must be equally long");
  return {
    width,
    height: rows.length,
    walls: [...letters].map((letter) => letter === "#"),
    start: letters.indexOf("S"),
    goal: letters.indexOf("G"),
  };
}

/** An empty map with its ends at these columns and rows. */
export function emptyMap(width: number, height: number, start: [number, number], goal: [number, number]): GridMap {
  return {
    width,
    height,
    walls: new Array<boolean>(width * height).fill(false),
    start: start[1] * width + start[0],
    goal: goal[1] * width + goal[0],
  };
}

/** Middle of a cell in metres; a cell's side is a metre, and y points up. */
export function middleOf({ width, height }: GridMap, cell: number): { x: number; y: number } {
  return { x: (cell % width) + 0.5, y: height - Math.floor(cell / width) - 0.5 };
}

/** The cell of this map for a cell of the scene, whose rows count from below. */
export function cellOf({ width, height }: GridMap, index: number): number {
  return (height - 1 - Math.floor(index / width)) * width + (index % width);
}

export function sceneOf(map: GridMap): Scenario & { obstacles: { type: "cells"; runs: Run[] }[] } {
  const runs: Run[] = [];
  map.walls.forEach((wall, cell) => {
    if (wall) runs.push([cell % map.width, map.height - 1 - Math.floor(cell / map.width), 1]);
  });
  return {
    version: 1,
    map: { origin: [0, 0], width: map.width, height: map.height, resolution: 1 },
    obstacles: runs.length > 0 ? [{ type: "cells", runs }] : [],
    start: { ...middleOf(map, map.start), heading: 0 },
    goal: { ...middleOf(map, map.goal), heading: 0 },
  };
}
