// @ts-check
// A thread of `parkade batch`.
import Tinypool from "tinypool";
import { ParkadeError, Planner, init } from "../node.js";

/**
 * @param {{ text: string, planner: import("../index.js").PlannerId, config: Record<string, unknown> }} task
 * @returns {Promise<Pick<import("./results.js").Result, "outcome" | "error">>}
 */
export default async function run({ text, planner, config }) {
  try {
    await init({ wasm: Tinypool.workerData });
    const prepared = new Planner(planner, parsed(text), config);
    try {
      const { outcome, detail, reason, metrics, stats, check, hash } = prepared.plan();
      const { verdict, drivable } = check;
      return /** @type {object} */ ({ outcome, detail, reason, verdict, drivable, metrics, stats, hash });
    } finally {
      prepared.free();
    }
  } catch (error) {
    const { code = "internal", path = "", message = String(error) } = /** @type {Partial<ParkadeError>} */ (error ?? {});
    return { error: { code, path, message } };
  }
}

/** @param {string} text */
function parsed(text) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new ParkadeError(`is not JSON: ${error instanceof Error ? error.message : error}`, "bad-scenario");
  }
}
