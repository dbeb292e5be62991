/** Pictures as maps: what is dark, or light, is a wall. */
import type { Pose } from "parkade";
import type { Run } from "./cells";
import { towards } from "./geometry";
import type { Scenario } from "./scenario";
import { vehicleOf } from "./vehicle";

/** Red, green, blue, alpha, row by row from the top. */
export interface Pixels {
  width: number;
  height: number;
  data: Uint8ClampedArray;
}

export interface ImageOptions {
  /** 0 to 255: darker pixels are walls. */
  threshold: number;
  /** Lighter ones are walls instead. */
  invert: boolean;
  /** Pixels along the side of a cell. */
  perCell: number;
  /** Side of a pixel, metres. */
  metres: number;
}

/** Cells a side beyond which a picture must be made coarser. */
export const MOST_CELLS = 2048;

export interface ImageMap {
  scene: Scenario;
  blocked: number;
  cells: number /** True if the car has room where it stands. */;
  roomy: boolean;
}

/** A cell is blocked where any of its pixels is a wall; see-through pixels are free. */
export function imageMap(pixels: Pixels, { threshold, invert, perCell, metres }: ImageOptions, name: string): ImageMap {
  const width = Math.ceil(pixels.width / perCell),
    height = Math.ceil(pixels.height / perCell),
    resolution = metres * perCell;
  const grid = new Uint8Array(width * height);
  for (let y = 0; y < pixels.height; y++) {
    const row = (height - 1 - Math.floor(y / perCell)) * width;
    for (let x = 0; x < pixels.width; x++) {
      const i = 4 * (y * pixels.width + x),
        [r, g, b, a] = [pixels.data[i]!, pixels.data[i + 1]!, pixels.data[i + 2]!, pixels.data[i + 3]!];
      const light = 0.2126 * r + 0.7152 * g + 0.0722 * b;
      if (a >= 128 && light < threshold !== invert) grid[row + Math.floor(x / perCell)] = 1;
    }
  }
  const runs = runsOf(grid, width, height);
  const blocked = runs.reduce((sum, run) => sum + run[2], 0);
  const car = vehicleOf("sedan"),
    needed = Math.hypot(car.rearToFront, car.width / 2) / resolution;
  const { start, goal, room } = places(grid, width, height, needed),
    at = (cell: number): [number, number] => [
      ((cell % width) + 0.5) * resolution,
      (Math.floor(cell / width) + 0.5) * resolution,
    ];
  const [from, to] = [at(start), at(goal)],
    heading = start === goal ? 0 : towards(from, to);
  const pose = ([x, y]: [number, number]): Pose => ({ x, y, heading });
  return {
    blocked,
    cells: width * height,
    roomy: room > needed,
    scene: {
      version: 1,
      name,
      map: { origin: [0, 0], width, height, resolution },
      obstacles: runs.length > 0 ? [{ type: "cells", id: "cells-1", runs }] : [],
      slots: [],
      vehicle: "sedan",
      start: pose(from),
      goal: pose(to),
    },
  };
}

function runsOf(grid: Uint8Array, width: number, height: number): Run[] {
  const runs: Run[] = [];
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (grid[y * width + x] === 0) continue;
      const from = x;
      while (x < width && grid[y * width + x] === 1) x++;
      runs.push([from, y, x - from]);
    }
  }
  return runs;
}

/**
 * The roomiest free cell, and the farthest one from it with the room needed, if there is one; their least distance to a
 * wall. All in cells.
 */
function places(
  grid: Uint8Array,
  width: number,
  height: number,
  needed: number,
): { start: number; goal: number; room: number } {
  const room = distances(grid, width, height);
  let start = 0;
  room.forEach((value, cell) => {
    if (value > room[start]!) start = cell;
  });
  const enough = Math.min(room[start]!, Math.floor(needed) + 1);
  const seen = new Uint8Array(grid.length),
    queue = new Int32Array(grid.length);
  let end = 1,
    goal = start;
  queue[0] = start;
  seen[start] = 1;
  for (let at = 0; at < end; at++) {
    const cell = queue[at]!,
      x = cell % width;
    if (room[cell]! >= enough) goal = cell;
    for (const next of [x > 0 ? cell - 1 : -1, x + 1 < width ? cell + 1 : -1, cell - width, cell + width]) {
      if (next < 0 || next >= grid.length || seen[next] || grid[next]) continue;
      seen[next] = 1;
      queue[end++] = next;
    }
  }
  return { start, goal, room: Math.min(room[start]!, room[goal]!) };
}

/** Steps of king's moves to the nearest wall or the edge, in two passes. */
function distances(grid: Uint8Array, width: number, height: number): Float32Array {
  const far = new Float32Array(grid.length);
  const look = (x: number, y: number, steps: readonly (readonly [number, number])[]): void => {
    const cell = y * width + x;
    let least = grid[cell] ? 0 : Math.min(far[cell]!, x + 1, y + 1, width - x, height - y);
    for (const [dx, dy] of steps) {
      const nx = x + dx,
        ny = y + dy;
      if (nx >= 0 && ny >= 0 && nx < width && ny < height) least = Math.min(least, far[ny * width + nx]! + 1);
    }
    far[cell] = least;
  };
  far.fill(Infinity);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      look(x, y, [
        [-1, 0],
        [-1, -1],
        [0, -1],
        [1, -1],
      ]);
  for (let y = height - 1; y >= 0; y--)
    for (let x = width - 1; x >= 0; x--)
      look(x, y, [
        [1, 0],
        [1, 1],
        [0, 1],
        [-1, 1],
      ]);
  return far;
}
