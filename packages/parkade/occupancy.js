// @ts-check
// Scenes of other people's grids; in the complete module only.
import { ParkadeError, mismatch, number, object, shown } from "./runtime.js";

/** Cells a side of the largest map. */
const MOST = 4096;
/** Largest weight of a cell. */
const WEIGHTS = 10;

/** @type {typeof import("./index.js").fromOccupancy} */
export function fromOccupancy(cells, width, options) {
  const {
    resolution,
    origin = [0, 0],
    rows = "bottom-up",
    occupied = 1,
    unknown = "blocked",
    costs,
    obstacles = [],
    ...scene
  } = object(options, "options");
  const count = listOf(cells, "cells").length;
  for (let index = 0; index < count; index++) {
    const value = cells[index];
    if (typeof value !== "number" && typeof value !== "boolean")
      throw mismatch(value, `cells[${index}]`, "a number, true or false");
  }
  const height = rowsOf(count, width);
  if (!Array.isArray(origin) || origin.length !== 2) throw mismatch(origin, "origin", "[x, y] in metres");
  oneOf(rows, "rows", ["bottom-up", "top-down"]);
  oneOf(unknown, "unknown", ["blocked", "free"]);
  number(occupied, "occupied");
  if (!(number(resolution, "resolution") > 0)) throw mismatch(resolution, "resolution", "a number above 0");
  /** @param {number} x @param {number} y */
  const at = (x, y) => (rows === "top-down" ? height - 1 - y : y) * width + x;
  const isBlocked = (/** @type {number} */ index) => {
    const value = Number(cells[index]);
    return value >= 0 ? value >= occupied : unknown === "blocked";
  };
  const runs = runsOf(width, height, (x, y) => (isBlocked(at(x, y)) ? 1 : 0)).get(1);
  const areas = costs === undefined ? [] : weighed(costs, count, width, height, at);
  return /** @type {import("./index.js").Scenario} */ ({
    version: 1,
    map: { origin: [origin[0], origin[1]], width, height, resolution },
    obstacles: [...(runs ? [{ type: "cells", runs }] : []), ...listed(obstacles)],
    ...(areas.length > 0 && { costs: areas }),
    ...scene,
  });
}

/** @type {typeof import("./index.js").fromOccupancyGrid} */
export function fromOccupancyGrid(message, options) {
  const { info, data } = object(message, "message");
  const { width, height, resolution, origin } = object(info, "message.info");
  const { position, orientation } = object(origin, "message.info.origin");
  const part = (/** @type {"x" | "y" | "z" | "w"} */ axis, otherwise = 0) =>
    number(orientation?.[axis] ?? otherwise, `message.info.origin.orientation.${axis}`);
  const [x, y, z, w] = /** @type {const} */ ([part("x"), part("y"), part("z"), part("w", 1)]);
  // A scene's cells lie along its axes.
  if (Math.hypot(x, y, z) > 1e-6 * Math.hypot(x, y, z, w)) {
    throw new ParkadeError(
      "message.info.origin.orientation: must be without rotation; turn the start and the goal into the map's frame " +
        "instead",
      "bad-input",
      "message.info.origin.orientation",
    );
  }
  const count = listOf(data, "message.data").length;
  if (count !== number(width, "message.info.width") * number(height, "message.info.height")) {
    throw mismatch(data, "message.data", `${shown(width)} × ${shown(height)} cells`, `${count}`);
  }
  const at = object(position, "message.info.origin.position");
  return fromOccupancy(data, width, {
    occupied: 65,
    ...object(options, "options"),
    resolution,
    origin: [number(at.x, "message.info.origin.position.x"), number(at.y, "message.info.origin.position.y")],
  });
}

/** @param {unknown} obstacles @returns {any[]} */
function listed(obstacles) {
  if (Array.isArray(obstacles)) return obstacles;
  throw mismatch(obstacles, "obstacles", "a list");
}

/** @param {unknown} value @param {string} path @returns {ArrayLike<unknown>} */
function listOf(value, path) {
  if (Array.isArray(value) && Array.isArray(value[0]))
    throw mismatch(value, path, "one flat list of cells", "a list of lists");
  if (Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView))) {
    return /** @type {any} */ (value);
  }
  throw mismatch(value, path, "an array of cells");
}

/** @param {number} count @param {number} width */
function rowsOf(count, width) {
  if (!Number.isInteger(width) || width < 1 || width > MOST) {
    throw mismatch(width, "width", `a whole number from 1 to ${MOST}`);
  }
  const height = count / width;
  if (!Number.isInteger(height) || height < 1 || height > MOST) {
    throw mismatch(count, "cells", `1 to ${MOST} whole rows of ${width} cells`, `${count} cells`);
  }
  return height;
}

/** @param {unknown} value @param {string} path @param {readonly string[]} words */
function oneOf(value, path, words) {
  if (!words.some((word) => word === value)) {
    throw mismatch(value, path, words.map((word) => `"${word}"`).join(" or "));
  }
}

/**
 * The cells of each value but 0, as runs from west to east, row by row.
 * @param {number} width
 * @param {number} height
 * @param {(x: number, y: number) => number} valueAt
 */
function runsOf(width, height, valueAt) {
  /** @type {Map<number, import("./index.js").Run[]>} */
  const runs = new Map();
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; ) {
      const value = valueAt(x, y),
        from = x;
      while (x < width && valueAt(x, y) === value) x++;
      if (value === 0) continue;
      const list = runs.get(value);
      if (list) list.push([from, y, x - from]);
      else runs.set(value, [[from, y, x - from]]);
    }
  }
  return runs;
}

/**
 * @param {ArrayLike<number>} costs
 * @param {number} count
 * @param {number} width
 * @param {number} height
 * @param {(x: number, y: number) => number} at
 */
function weighed(costs, count, width, height, at) {
  if (listOf(costs, "costs").length !== count)
    throw mismatch(costs, "costs", `${count} weights, one per cell`, `${costs.length}`);
  const weights = Array.from(costs);
  const wrong = weights.findIndex((weight) => !Number.isInteger(weight) || weight < 1 || weight > WEIGHTS);
  if (wrong >= 0) {
    throw mismatch(weights[wrong], `costs[${wrong}]`, `a whole number from 1 to ${WEIGHTS}`);
  }
  // A weight of 1 is that of every cell.
  const runs = runsOf(width, height, (x, y) => ((weights[at(x, y)] ?? 1) === 1 ? 0 : (weights[at(x, y)] ?? 0)));
  return [...runs].sort(([a], [b]) => a - b).map(([weight, list]) => ({ weight, runs: list }));
}
