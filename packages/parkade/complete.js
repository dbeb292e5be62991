// @ts-check
// What the complete module has and `core` lacks.
import { packedScene, unpackedScene } from "./cells.js";
import * as raw from "./parkade.js";
import { ParkadeError, call, mismatch, number, numbers, object, optional, text } from "./runtime.js";

export * from "./audit.js";
export * from "./columns.js";
export * from "./drive.js";
export * from "./occupancy.js";
export * from "./picture.js";

/** No file of a map that fits is larger. */
const MAX_BYTES = 80_000_000;

/** @type {typeof import("./index.js").importScene} */
export function importScene(files, options) {
  if (typeof files !== "object" || files === null || Array.isArray(files)) {
    throw mismatch(files, "files", "contents by name");
  }
  const names = Object.keys(files);
  const contents = names.map((name) => bytes(name, files[name]));
  return call(() => {
    const imported = raw.importScene(names, contents, optional(options));
    const scenes = imported.scenes.map(unpackedScene);
    return { ...imported, scene: scenes[0], scenes };
  });
}

/** @type {typeof import("./index.js").generateScenario} */
export const generateScenario = (family) => call(() => unpackedScene(raw.generateScenario(object(family, "family"))));

/** @type {typeof import("./index.js").reedsShepp} */
export function reedsShepp(from, to, radius) {
  const [first, last] = [pose(from, "from"), pose(to, "to")];
  if (!(number(radius, "radius") > 0 && radius <= 1e5)) {
    throw mismatch(radius, "radius", "from just above 0 to 100000 metres");
  }
  return call(() => raw.reedsShepp(first, last, radius));
}

/**
 * @param {unknown} value
 * @param {string} path
 */
function pose(value, path) {
  const fields = /** @type {Record<string, unknown>} */ (object(value, path));
  const [x, y, heading] = ["x", "y", "heading"].map((name) => number(fields[name], `${path}.${name}`));
  for (const [name, one] of Object.entries({ x, y, heading })) {
    if (!(Math.abs(/** @type {number} */ (one)) <= 1e6)) {
      throw mismatch(one, `${path}.${name}`, "a number from -1000000 to 1000000");
    }
  }
  return Float64Array.of(/** @type {number} */ (x), /** @type {number} */ (y), /** @type {number} */ (heading));
}

/** @type {typeof import("./index.js").roadFigures} */
export const roadFigures = (scene, plan) => call(() => raw.roadFigures(packedScene(scene), line(plan)));

/** @type {typeof import("./index.js").collisionRisk} */
export const collisionRisk = (scene, plan, options) =>
  call(() => raw.collisionRisk(packedScene(scene), line(plan), optional(options)));

/** @type {typeof import("./index.js").driveEnvelope} */
export const driveEnvelope = (scene, plan, options) =>
  call(() => raw.driveEnvelope(packedScene(scene), line(plan), optional(options)));

/** @type {typeof import("./index.js").paperGridRows} */
export const paperGridRows = () => call(() => raw.paperGridRows());

/** @type {typeof import("./index.js").paperGrid} */
export const paperGrid = (slice) => {
  const { row, from, to } = object(slice, "slice");
  return call(() => raw.paperGrid(text(row, "row"), number(from, "from"), number(to, "to"), () => performance.now()));
};

/** @type {typeof import("./index.js").paperParkingRows} */
export const paperParkingRows = () => call(() => raw.paperParkingRows());

/** @type {typeof import("./index.js").paperParking} */
export const paperParking = (options) => {
  const { row, rounds = 1 } = object(options, "options");
  return call(() => raw.paperParking(text(row, "row"), number(rounds, "rounds"), () => performance.now()));
};

/** @type {typeof import("./index.js").paperGridSummary} */
export function paperGridSummary(measured) {
  const rows = Object.keys(object(measured, "measured"));
  const figures = rows.map((row) => {
    const values = measured[row];
    if (values instanceof Float64Array) return values;
    throw mismatch(values, row, "a Float64Array");
  });
  return call(() => raw.paperGridSummary(rows, figures));
}

/** @type {typeof import("./index.js").paperRoadRows} */
export const paperRoadRows = () => call(() => raw.paperRoadRows());

/** @type {typeof import("./index.js").paperRoad} */
export const paperRoad = (options) => {
  const { row, rounds = 1 } = object(options, "options");
  return call(() => raw.paperRoad(text(row, "row"), number(rounds, "rounds"), () => performance.now()));
};

/** @type {typeof import("./index.js").paperVerdicts} */
export const paperVerdicts = (tables) => {
  const { parking = [], road = [] } = object(tables, "tables");
  return call(() => raw.paperVerdicts(parking, road));
};

/** @type {typeof import("./index.js").paperIncomplete} */
export const paperIncomplete = (slice) => {
  const { row, from, to } = object(slice, "slice");
  return call(() => raw.paperIncomplete(text(row, "row"), number(from, "from"), number(to, "to")));
};

/** @type {typeof import("./index.js").paperVolumes} */
export const paperVolumes = (options) => {
  const { scene, poses = 10000, seed = 1, rounds = 1 } = object(options, "options");
  return call(() =>
    raw.paperVolumes(text(scene, "scene"), number(poses, "poses"), number(seed, "seed"), number(rounds, "rounds"), () =>
      performance.now(),
    ),
  );
};

/**
 * A plan's path.
 * @param {{ path: Float64Array | number[] }} plan
 */
function line(plan) {
  return numbers(Float64Array, object(plan, "plan").path, "plan.path");
}

/**
 * A file's bytes; too many are refused before the module makes room for them.
 * @param {string} name
 * @param {unknown} content
 */
function bytes(name, content) {
  const view = content instanceof ArrayBuffer ? new Uint8Array(content) : content;
  const whole = view instanceof Uint8Array ? view : text(view, `files[${JSON.stringify(name)}]`);
  const size = whole.length;
  if (size > MAX_BYTES) {
    /** @param {number} from */
    const lineEnd = (from) => (typeof whole === "string" ? whole.indexOf("\n", from) : whole.indexOf(10, from));
    let line = 1;
    for (let end = lineEnd(0); end >= 0 && end < MAX_BYTES; end = lineEnd(end + 1)) line++;
    throw new ParkadeError(
      `${name}:${line}: must end the file, which may have ${MAX_BYTES} bytes and has ${size}`,
      "bad-import",
      `${name}:${line}`,
    );
  }
  return typeof whole === "string" ? new TextEncoder().encode(whole) : whole;
}
