// @ts-check
// A thread of `parkade batch`: reads scenes, plans them, and writes what comes of it as lines.
import { closeSync, openSync, readSync } from "node:fs";
import Tinypool from "tinypool";
import { ParkadeError, Planner, audit, init, version } from "../node.js";
import { MAX_BYTES, tooLarge } from "./input.js";
import { reason } from "./refusal.js";
import { hashOf, outline } from "./results.js";

/** @typedef {import("./results.js").Result} Result */
/** @typedef {import("./scenes.js").Scene} Scene */

const { module } = Tinypool.workerData;
await init({ wasm: module });

/** True if the module has trapped, after which this thread is of no more use. */
let stopped = false;

/** The scene read last: each is planned by one planner after another. @type {{ of?: string, scene?: unknown }} */
let last = {};

/**
 * Plans one after another, up to a trap.
 * @param {import("./batch.js").Task[]} tasks
 */
export default function run(tasks) {
  const from = performance.now();
  /** @type {{ line: string, result: Result }[]} */
  const done = [];
  for (const task of tasks) {
    if (stopped) break;
    const { key, scene, content, planner, config, extras } = task,
      start = performance.now();
    const result = {
      key,
      scene: scene.name,
      sceneHash: content,
      planner,
      settings: config,
      version: version(),
      ...planned(task),
      ...(extras.times && { seconds: (performance.now() - start) / 1000 }),
    };
    stopped = result.error?.code === "internal";
    done.push({ line: `${JSON.stringify(result)}\n`, result: outline(result) });
  }
  return { done, ms: performance.now() - from };
}

/** @param {import("./batch.js").Task} task @returns {Pick<Result, "outcome" | "error">} */
function planned({ scene, planner, content, config, extras }) {
  try {
    if (scene.length > MAX_BYTES) throw new ParkadeError(tooLarge(scene.length), "bad-scenario");
    if (last.of !== content) last = { of: content, scene: parsed(scene, content) };
    if (planner === "audit") return audited(/** @type {any} */ (last.scene), config);
    const prepared = new Planner(planner, /** @type {any} */ (last.scene), config);
    try {
      const { outcome, detail, reason, goal, metrics, stats, check, hash, path, directions } = prepared.plan();
      const { verdict, drivable } = check;
      const way = extras.paths ? { path: [...path], directions: [...directions] } : {};
      return /** @type {object} */ ({ outcome, detail, reason, goal, verdict, drivable, metrics, stats, hash, ...way });
    } finally {
      prepared.free();
    }
  } catch (error) {
    const {
      code = "internal",
      path = "",
      message = String(error),
    } = /** @type {Partial<ParkadeError>} */ (error ?? {});
    return { error: { code, path, message } };
  }
}

/**
 * The rows of an audit, without poses.
 * @param {import("../index.js").Scenario} scene
 * @param {import("../index.js").AuditOptions} options
 */
function audited(scene, options) {
  const rows = audit(scene, options).map(({ swept: _, out, ...row }) => {
    if (out === null) return { ...row, out };
    const { swept: __, ...way } = out;
    return { ...row, out: way };
  });
  const reachable = rows.filter((row) => row.reachable).length,
    undecided = rows.filter(({ outcome, out }) => [outcome, out?.outcome].includes("budget-spent")).length;
  const hash = hashOf(rows.map((row) => `${row.hash} ${row.out?.hash ?? ""}`).join("\n"));
  return /** @type {object} */ ({
    outcome: reachable === rows.length ? "found" : "no-path",
    asked: rows.length,
    reachable,
    undecided,
    rows,
    hash,
  });
}

/** @param {Scene} scene @param {string} content */
function parsed(scene, content) {
  const bytes = read(scene);
  if (hashOf(bytes) !== content) throw new ParkadeError("was changed while the batch ran", "bad-input");
  try {
    return JSON.parse(bytes.toString("utf8"));
  } catch (error) {
    throw new ParkadeError(`is not JSON: ${reason(error)}`, "bad-scenario");
  }
}

/** @param {Scene} scene */
function read({ file, from, length }) {
  const bytes = Buffer.allocUnsafe(length);
  try {
    const handle = openSync(file, "r");
    try {
      for (let at = 0, read = 1; at < length && read > 0; at += read)
        read = readSync(handle, bytes, at, length - at, from + at);
    } finally {
      closeSync(handle);
    }
  } catch (error) {
    throw new ParkadeError(reason(error), "bad-input");
  }
  return bytes;
}
