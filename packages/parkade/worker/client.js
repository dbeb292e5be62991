// @ts-check
// Planners in workers, as their user sees them: `index.d.ts` documents it.
import { ParkadeError, mismatch, said, text } from "../runtime.js";
import { packedScene } from "../cells.js";
import { WorkerPool } from "./pool.js";

/**
 * Of the place where it runs: how a worker is started, how the module is compiled from an address (by default the file
 * of the package), and how many workers run at the same time.
 * @typedef {{ spawn(): any, compile(wasm?: URL | string): Promise<WebAssembly.Module>, most(): number }} Host
 * @typedef {import("./protocol.js").Job} Job
 * @typedef {{ signal?: AbortSignal, onProgress?: (expansions: number) => void, onImproved?: (plan: any) => void,
 *   onExpanded?: (events: any) => void }} Ears
 * @typedef {Ears & { fields: any, transfer?: ArrayBuffer[], done(result: any): void, failed(error: unknown): void,
 *   detach(): void }} Task
 * @typedef {{ task: Task, id: number, stop: SharedArrayBuffer | undefined,
 *   grace?: ReturnType<typeof setTimeout> }} Running
 */

/** Milliseconds after which a search that was asked to end is ended with its worker. */
const GRACE_MS = 250;

/** @param {Host} host */
export function entry(host) {
  /** @type {Pool | undefined} */
  let common;
  /** @param {{ size?: number, wasm?: any, spawn?: () => any }} [options] */
  const createPool = (options = {}) => new Pool(host, options);
  return {
    createPool: /** @type {typeof import("./index.js").createPool} */ (/** @type {unknown} */ (createPool)),
    createPlanner: /** @type {typeof import("./index.js").createPlanner} */ (
      /** @type {unknown} */
      (
        (/** @type {any[]} */ ...[planner, scene, settings]) => {
          common ??= createPool();
          return common.createPlanner(planner, scene, settings);
        }
      )
    ),
  };
}

/** Workers for as many planners as one likes. */
class Pool {
  #host;
  #wasm;
  /** @type {Promise<WebAssembly.Module> | undefined} */
  #module;
  /** @type {Set<WorkerPlanner>} */
  planners = new Set();

  /** @param {Host} host @param {{ size?: number, wasm?: any, spawn?: () => any }} options */
  constructor(host, { size = host.most(), wasm, spawn = host.spawn }) {
    if (!Number.isInteger(size) || size < 1 || size > 256) {
      throw mismatch(size, "size", "a whole number from 1 to 256", String(size));
    }
    if (typeof spawn !== "function") throw mismatch(spawn, "spawn", "a function that gives a worker");
    this.#host = host;
    this.#wasm = wasm;
    this.workers = new WorkerPool(spawn, size);
  }

  /** The compiled module, of all workers of this pool. */
  module() {
    this.#module ??= this.#compiled().catch((cause) => {
      this.#module = undefined;
      const message = `cannot load the wasm module: ${cause instanceof Error ? cause.message : cause}`;
      const given = this.#wasm !== undefined;
      throw new ParkadeError(message, given ? "bad-input" : "internal", given ? "wasm" : "", { cause });
    });
    return this.#module;
  }

  async #compiled() {
    const wasm = this.#wasm;
    if (wasm instanceof WebAssembly.Module) return wasm;
    if (wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm))
      return WebAssembly.compile(/** @type {BufferSource} */ (wasm));
    if (wasm === undefined || wasm instanceof URL || typeof wasm === "string") return this.#host.compile(wasm);
    throw mismatch(wasm, "wasm", "bytes, a module or an address");
  }

  /** @param {any} planner @param {any} scene @param {any} [settings] */
  async createPlanner(planner, scene, settings = {}) {
    const made = new WorkerPlanner(
      this,
      text(planner, "planner"),
      sendable(scene, "scene"),
      sendable(settings, "settings"),
    );
    this.planners.add(made);
    try {
      await made.prepare();
    } catch (error) {
      made.free();
      throw error;
    }
    return made;
  }

  close() {
    for (const planner of this.planners) planner.free();
    this.workers.retire();
  }
}

/**
 * A value as the worker shall have it, whatever becomes of it here. Proxies of frameworks cannot be cloned, but they
 * can be read.
 * @param {any} value
 * @param {string} path
 */
function sendable(value, path) {
  try {
    const plain = path === "scene" ? packedScene(value) : value;
    try {
      return structuredClone(plain);
    } catch {
      return JSON.parse(JSON.stringify(plain));
    }
  } catch (cause) {
    if (cause instanceof ParkadeError) throw cause;
    const message = `${path}: must be plain data: ${cause instanceof Error ? cause.message : cause}`;
    throw new ParkadeError(message, "bad-input", path, { cause });
  }
}

let jobs = 0;

/** One planner, whose jobs run one after the other in a worker that it keeps while no other planner needs it. */
class WorkerPlanner {
  #pool;
  #held;
  /** @type {Task[]} */
  #queue = [];
  /** @type {Running | undefined} */
  #running;
  /** @type {any} */
  #worker;
  #known = false;
  #freed = false;
  #sticky = false;
  /** @type {any} */
  #last;

  /** @param {Pool} pool @param {string} planner @param {any} scene @param {any} settings */
  constructor(pool, planner, scene, settings) {
    this.#pool = pool;
    this.#held = { planner, scene, settings };
  }

  // What the pool asks of a holder.
  get busy() {
    return this.#running !== undefined || this.#queue.length > 0;
  }

  get of() {
    return this.#pool;
  }

  revoked() {
    if (this.#worker) this.#worker.onmessage = this.#worker.onerror = null;
    this.#worker = undefined;
    this.#known = false;
  }

  prepare() {
    return this.#ask({ kind: "prepare" }, {});
  }

  /** @param {any} options */
  async plan(options = {}) {
    const { signal, onProgress, onImproved, onExpanded, layers = [], ...others } = plainObject(options, "options");
    if (!Array.isArray(layers)) throw mismatch(layers, "layers", "a list of names");
    const tells = {
      progress: !!ear(onProgress, "onProgress"),
      improved: !!ear(onImproved, "onImproved"),
      expanded: !!ear(onExpanded, "onExpanded"),
    };
    const sent = sendable(others, "options");
    this.#sticky ||= others.stickiness !== undefined;
    const plan = await this.#ask(
      { kind: "plan", options: sent, layers: [...layers], tells },
      { signal, onProgress, onImproved, onExpanded },
    );
    // Where another planner takes the worker its last path is lost with it.
    if (this.#sticky)
      this.#last = sendable({ path: plan.path, directions: plan.directions, curvatures: plan.curvatures }, "plan");
    return plan;
  }

  /** @param {any} plan @param {any} [options] */
  async optimise(plan, options = {}) {
    const { signal, ...others } = plainObject(options, "options");
    const { path, directions, curvatures } = plainObject(plan, "plan");
    const columns = sendable({ path, ...(directions && { directions }), ...(curvatures && { curvatures }) }, "plan");
    return this.#ask({ kind: "optimise", path: columns, options: sendable(others, "options") }, { signal });
  }

  /** @param {any} scene @param {any} [settings] */
  async update(scene, settings = this.#held.settings) {
    const before = this.#held;
    const next = { ...before, scene: sendable(scene, "scene"), settings: sendable(settings, "settings") };
    this.#held = next;
    this.#known = false;
    try {
      await this.prepare();
    } catch (error) {
      // What was refused leaves the planner as it was.
      if (this.#held === next) this.#held = before;
      throw error;
    }
  }

  free() {
    if (this.#freed) return;
    this.#freed = true;
    this.#pool.planners.delete(this);
    const { busy } = this;
    for (const task of this.#queue.splice(0)) this.#fail(task, freed());
    const running = this.#running;
    this.#running = undefined;
    if (running) {
      clearTimeout(running.grace);
      this.#fail(running.task, freed());
    }
    this.revoked();
    if (busy) this.#pool.workers.drop(this);
    else this.#pool.workers.release(this);
  }

  [Symbol.dispose ?? Symbol.for("Symbol.dispose")]() {
    this.free();
  }

  /** @param {object} fields @param {Ears} ears @returns {Promise<any>} */
  #ask(fields, ears) {
    const { signal } = ears;
    if (signal !== undefined && !(signal instanceof AbortSignal)) {
      return Promise.reject(mismatch(signal, "signal", "an AbortSignal"));
    }
    if (this.#freed) return Promise.reject(freed());
    if (signal?.aborted) return Promise.reject(signal.reason);
    return new Promise((done, failed) => {
      /** @type {Task} */
      const task = { ...ears, fields, done, failed, detach: () => signal?.removeEventListener("abort", abort) };
      const abort = () => this.#abort(task, signal?.reason);
      signal?.addEventListener("abort", abort);
      this.#queue.push(task);
      if (!this.#running) void this.#next();
    });
  }

  async #next() {
    const task = this.#queue.shift();
    if (!task) return this.#pool.workers.rested(this);
    const running = { task, id: ++jobs, stop: shared() };
    this.#running = running;
    try {
      const module = await this.#pool.module();
      if (this.#running === running) this.#withWorker(module, () => this.#post(running));
    } catch (error) {
      if (this.#running === running) this.#finish(() => this.#fail(task, error));
    }
  }

  /** @param {WebAssembly.Module} module @param {() => void} use */
  #withWorker(module, use) {
    if (this.#worker) return use();
    this.#pool.workers.lease(this, (worker) => {
      this.#worker = worker;
      worker.onmessage = (/** @type {any} */ { data }) => this.#receive(data);
      worker.onerror = (/** @type {any} */ event) => {
        event.preventDefault?.();
        this.#died(event.message || "its script could not be loaded");
      };
      if (!STARTED.has(worker)) worker.postMessage({ kind: "start", module });
      STARTED.add(worker);
      use();
    });
  }

  /** @param {Running} running */
  #post({ task, id, stop }) {
    // Given up while it waited for a worker.
    if (this.#running?.task !== task) return;
    const prepare = this.#known ? undefined : { ...this.#held, before: this.#last };
    this.#known = true;
    this.#worker.ref?.();
    this.#worker.postMessage({ ...task.fields, id, prepare, ...(task.fields.kind === "plan" && { stop }) });
  }

  /** @param {import("./protocol.js").Reply} reply */
  #receive(reply) {
    const { task, id } = this.#running ?? {};
    if (!task || reply.id !== id) return;
    if (reply.kind === "progress") return this.#tell(task, () => task.onProgress?.(reply.expansions));
    if (reply.kind === "improved") return this.#tell(task, () => task.onImproved?.(reply.plan));
    if (reply.kind === "expanded") return this.#tell(task, () => task.onExpanded?.(reply.events));
    if (reply.kind === "failed") {
      // Where scene or settings were refused, the worker has no planner.
      this.#known = false;
      const { message, code, path, template, values } = reply.error;
      // After a trap the module's memory is in an unknown state.
      if (code === "internal") return this.#died(message);
      return this.#finish(() => this.#fail(task, said(new ParkadeError(message, code, path), template, values)));
    }
    this.#finish(() => {
      task.detach();
      if (reply.kind === "done") task.done(reply.result);
    });
  }

  /**
   * What a callback throws ends the search, as it does without a worker.
   * @param {Task} task
   * @param {() => void} told
   */
  #tell(task, told) {
    try {
      told();
    } catch (error) {
      this.#abort(task, error);
    }
  }

  /** @param {Task} task @param {unknown} reason */
  #abort(task, reason) {
    this.#fail(task, reason);
    const { stop, task: now } = this.#running ?? {};
    if (now !== task) {
      this.#queue = this.#queue.filter((one) => one !== task);
      return;
    }
    if (stop && task.fields.kind === "plan" && this.#worker) {
      Atomics.store(new Int32Array(stop), 0, 1);
      const running = this.#running;
      if (running) running.grace = setTimeout(() => this.#renew(), GRACE_MS);
    } else this.#renew();
  }

  /** @param {string} message */
  #died(message) {
    const task = this.#running?.task;
    if (task) this.#fail(task, new ParkadeError(`the worker stopped: ${message}`, "internal"));
    this.#renew();
  }

  /** Ends the worker, and goes on with another. */
  #renew() {
    this.#finish(() => {
      this.revoked();
      this.#pool.workers.drop(this);
    });
  }

  /** @param {() => void} settle */
  #finish(settle) {
    clearTimeout(this.#running?.grace);
    this.#running = undefined;
    this.#worker?.unref?.();
    settle();
    if (!this.#running && !this.#freed) void this.#next();
  }

  /** @param {Task} task @param {unknown} error */
  #fail(task, error) {
    task.detach();
    task.failed(error);
  }
}

/** Workers that have the module. @type {WeakSet<object>} */
const STARTED = new WeakSet();

const freed = () => new ParkadeError("this planner has been freed", "freed");

/** Pages share memory with their workers only where the server isolates them. */
const shared = () =>
  typeof SharedArrayBuffer === "function" && globalThis.crossOriginIsolated !== false
    ? new SharedArrayBuffer(4)
    : undefined;

/** @param {unknown} callback @param {string} name */
function ear(callback, name) {
  if (callback === undefined || typeof callback === "function") return callback;
  throw mismatch(callback, name, "a function");
}

/** @param {any} value @param {string} path */
function plainObject(value, path) {
  if (typeof value === "object" && value !== null && !Array.isArray(value)) return value;
  throw mismatch(value, path, "an object", Array.isArray(value) ? "a list" : undefined);
}
