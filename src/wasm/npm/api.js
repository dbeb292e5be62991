// @ts-check
// The API over the raw wasm exports; `index.d.ts` documents it.
import { ParkadeError, call, isRunning } from "./core.js";
import * as raw from "./parkade.js";

export { ParkadeError };

/** @typedef {typeof import("./index.js")} Api */

/** @type {typeof Symbol.dispose} */
const dispose = Symbol.dispose ?? Symbol.for("Symbol.dispose");

/** @type {Api["version"]} */
export const version = () => call(() => raw.version());

/** @type {Api["planners"]} */
export const planners = () => call(() => raw.planners());

/** @type {Api["defaultConfig"]} */
export const defaultConfig = (planner) => call(() => raw.defaultConfig(text(planner, "planner")));

/** @type {Api["scenarios"]} */
export const scenarios = () => call(() => raw.scenarios());

/** @type {Api["scenario"]} */
export const scenario = (id) => call(() => raw.scenario(text(id, "id")));

/** @type {Api["sceneGeometry"]} */
export const sceneGeometry = (scene) => call(() => raw.sceneGeometry(scene));

/** @type {Api["checkPath"]} */
export const checkPath = (scene, path, directions) =>
  call(() =>
    raw.checkPath(
      scene,
      numbers(Float64Array, path, "path"),
      directions === undefined ? undefined : numbers(Int8Array, directions, "directions"),
    ),
  );

export class Planner {
  /** @type {raw.RawPlanner | undefined} */
  #raw;

  /** @param {ConstructorParameters<Api["Planner"]>} args */
  constructor(...args) {
    const [planner, scene, config = {}] = args;
    this.#raw = call(() => new raw.RawPlanner(text(planner, "planner"), scene, config));
  }

  /** @type {import("./index.js").Planner["plan"]} */
  plan(options = {}) {
    return this.#call((planner) => planner.plan(options));
  }

  /** @type {import("./index.js").Planner["layer"]} */
  layer(name) {
    return this.#call((planner) => planner.layer(text(name, "name")));
  }

  /** Gives the memory back; again, it does nothing. */
  free() {
    const planner = this.#raw;
    this.#raw = undefined;
    if (planner !== undefined && isRunning()) call(() => planner.free());
  }

  [dispose]() {
    this.free();
  }

  /**
   * @template T
   * @param {(planner: raw.RawPlanner) => T} run
   */
  #call(run) {
    const planner = this.#raw;
    if (planner === undefined) throw new ParkadeError("this planner has been freed", "freed");
    return call(() => run(planner));
  }
}

/**
 * wasm-bindgen does not check what it takes for a string.
 * @param {unknown} value
 * @param {string} path
 */
function text(value, path) {
  if (typeof value === "string") return value;
  throw new ParkadeError(`${path}: must be a string, got ${kind(value)}`, "bad-input", path);
}

/**
 * The typed array itself, or an array's numbers in one; never another number than the given one.
 * @template {Float64Array | Int8Array} T
 * @param {{ new (values: number[]): T }} Numbers
 * @param {unknown} values
 * @param {string} path
 */
function numbers(Numbers, values, path) {
  if (values instanceof Numbers) return values;
  if (!Array.isArray(values)) {
    throw new ParkadeError(`${path}: must be an array of numbers, got ${kind(values)}`, "bad-input", path);
  }
  const typed = new Numbers(values.map((value) => (typeof value === "number" ? value : Number.NaN)));
  const changed = typed.findIndex((value, index) => value !== values[index] && !Number.isNaN(values[index]));
  if (changed >= 0) {
    const at = `${path}[${changed}]`;
    throw new ParkadeError(`${at}: must be a number that fits, got ${String(values[changed])}`, "bad-input", at);
  }
  return typed;
}

/** @param {unknown} value */
function kind(value) {
  return value === null ? "null" : typeof value;
}
