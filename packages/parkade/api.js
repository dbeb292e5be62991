// @ts-check
// The API over the raw wasm exports; `index.d.ts` documents it. Only what both modules have: the complete one and
// `core`.
import { packedScene } from "./cells.js";
import * as raw from "./parkade.js";
import { ParkadeError, call, isRunning, mismatch, number, numbers, optional, text } from "./runtime.js";

export { packRuns, unpackRuns } from "./cells.js";
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
export const sceneGeometry = (scene) => call(() => raw.sceneGeometry(packedScene(scene)));

/** @type {Api["checkPath"]} */
export const checkPath = (scene, path, directions) =>
  call(() =>
    raw.checkPath(
      packedScene(scene),
      numbers(Float64Array, path, "path"),
      directions === undefined ? undefined : numbers(Int8Array, directions, "directions"),
    ),
  );

export class Planner {
  /** @type {raw.RawPlanner | undefined} */
  #raw;
  /** The callback that is being called while it plans. */
  #told = "";

  /** @param {ConstructorParameters<Api["Planner"]>} args */
  constructor(...args) {
    const [planner, scene, config] = args;
    this.#raw = call(
      () => new raw.RawPlanner(text(planner, "planner"), packedScene(scene), optional(config, "config", "bad-config")),
    );
  }

  /** @type {import("./index.js").Planner["plan"]} */
  plan(options = {}) {
    /**
     * @type {Parameters<import("./index.js").Planner["plan"]>[0] & { onImproved?: (plan: any) => void,
     *   onExpanded?: (events: any) => void }}
     */
    const { onProgress, onImproved, onExpanded, ...others } = optional(options);
    /** @type {{ error: unknown } | undefined} */
    let thrown;
    /**
     * Nothing is thrown through the module.
     * @param {((value: any) => void) | undefined} callback
     * @param {string} name
     */
    const told = (callback, name) => {
      if (callback === undefined) return undefined;
      if (typeof callback !== "function") throw mismatch(callback, name, "a function");
      return (/** @type {unknown} */ value) => {
        this.#told = name;
        try {
          callback(value);
        } catch (error) {
          thrown = { error };
        }
        this.#told = "";
        return thrown === undefined;
      };
    };
    const improved = told(onImproved, "onImproved");
    const expanded = told(onExpanded, "onExpanded");
    // What the others throw ends the search where it tells its progress.
    const tell = told(onProgress === undefined && expanded ? () => {} : onProgress, "onProgress");
    const plan =
      improved || expanded
        ? this.#call(
            (planner) => planner.watched(others, tell, improved, expanded),
            "watched",
            "onImproved, onExpanded",
          )
        : this.#call((planner) => planner.plan(others, tell));
    if (thrown !== undefined) throw thrown.error;
    return plan;
  }

  /** @type {import("./index.js").Planner["search"]} */
  search(start, goal) {
    const found = this.#call((planner) => planner.search(...point(start, "start"), ...point(goal, "goal")), "search");
    const [outcome = 0, costMicro = 0, expanded = 0, generated = 0] = found;
    return {
      outcome: /** @type {import("./index.js").Outcome} */ (OUTCOMES[outcome]),
      path: found.subarray(4),
      costMicro,
      expanded,
      generated,
    };
  }

  /** @type {import("./index.js").Planner["anyAngleLength"]} */
  anyAngleLength() {
    return this.#call((planner) => planner.anyAngleLength() ?? null, "anyAngleLength");
  }

  /** @type {import("./index.js").Planner["continueFrom"]} */
  continueFrom(before) {
    const { path, directions, curvatures } = Object(before);
    if (path && directions && curvatures)
      return this.#call((planner) => planner.continueAlong(path, directions, curvatures), "continueFrom");
    if (!(before instanceof Planner) || before === this)
      throw mismatch(before, "before", "another planner or a plan", before === this ? "itself" : undefined);
    before.#call((last) => this.#call((planner) => planner.continueFrom(last), "continueFrom"));
  }

  /** @type {import("./index.js").Planner["brush"]} */
  brush(runs, blocked) {
    if (!Array.isArray(runs) || runs.some((run) => !Array.isArray(run) || run.length !== 3)) {
      throw mismatch(runs, "runs", "a list of [x, y, count]");
    }
    if (typeof blocked !== "boolean") {
      throw mismatch(blocked, "blocked", "true or false");
    }
    const cells = numbers(Uint32Array, runs.flat(), "runs");
    this.#call((planner) => planner.brush(cells, blocked), "brush");
  }

  /** @type {import("./index.js").Planner["layer"]} */
  layer(name, options) {
    return this.#call((planner) => planner.layer(text(name, "name"), optional(options)));
  }

  /** @type {import("./index.js").Planner["explain"]} */
  explain(at) {
    return this.#call((planner) => planner.explain(...point(at, "at")), "explain");
  }

  /** Gives the memory back; again, it does nothing. */
  free() {
    this.#rest();
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
   * @param {"search" | "anyAngleLength" | "brush" | "continueFrom" | "explain" | "watched"} [method] what only the
   * complete module has
   * @param {string} [name] what it is called here
   */
  #call(run, method, name = method) {
    this.#rest();
    const planner = this.#raw;
    if (planner === undefined) throw new ParkadeError("this planner has been freed", "freed");
    if (method && !planner[method]) throw new ParkadeError(`${name}: not in parkade/core, but in parkade`, "bad-input");
    return call(() => run(planner));
  }

  #rest() {
    if (this.#told) throw new ParkadeError(`this planner is planning: its ${this.#told} cannot use it`, "bad-input");
  }
}

/** In the module's order. @type {import("./index.js").Outcome[]} */
const OUTCOMES = ["found", "no-path", "budget-spent", "start-blocked", "goal-blocked", "start-outside", "goal-outside"];

/**
 * @param {{ x: number, y: number }} at
 * @param {string} name
 * @returns {[number, number]}
 */
const point = (at, name) => [number(at?.x, `${name}.x`), number(at?.y, `${name}.y`)];
