// @ts-check
// Which bays of a lot can be reached; in the complete module only.
import { packedScene } from "./cells.js";
import * as raw from "./parkade.js";
import { call, mismatch, object, optional } from "./runtime.js";

/** @type {typeof import("./index.js").vehicles} */
export const vehicles = () => call(() => raw.vehicles());

/** @type {typeof import("./index.js").audit} */
export function audit(scene, options) {
  const { onRow, ...others } = optional(options);
  if (onRow !== undefined && typeof onRow !== "function") throw mismatch(onRow, "onRow", "a function");
  /** @type {{ error: unknown } | undefined} */
  let thrown;
  // Nothing is thrown through the module.
  const told =
    onRow &&
    ((/** @type {import("./index.js").AuditRow} */ row) => {
      try {
        return onRow(row) !== false;
      } catch (error) {
        thrown = { error };
        return false;
      }
    });
  const rows = call(() => raw.audit(packedScene(scene), others, told));
  if (thrown !== undefined) throw thrown.error;
  return rows;
}

/** @type {typeof import("./index.js").affectedRows} */
export function affectedRows(before, after, rows, options) {
  const { vehicles } = optional(options);
  if (vehicles !== undefined && !Array.isArray(vehicles)) throw mismatch(vehicles, "vehicles", "a list");
  const names = (vehicles ?? []).map((one) => (typeof one === "string" ? one : one?.id));
  const read = listed(rows, "rows").map((row, at) => rowOf(row, `rows[${at}]`, names));
  const heads = read.flatMap(({ head }) => head),
    swept = read.flatMap(({ swept }) => swept);
  const touched = call(() =>
    raw.affectedRows(packedScene(before), packedScene(after), options, new Uint32Array(heads), new Float64Array(swept)),
  );
  return rows.filter((_, at) => touched[at] === 1);
}

/**
 * What the module has to know of a row.
 * @param {any} row @param {string} path @param {readonly unknown[]} vehicles
 */
function rowOf(row, path, vehicles) {
  const { index, vehicle, reachable, swept, out } = object(row, path);
  if (!Number.isInteger(index) || index < 0 || index > 0xffff_ffff)
    throw mismatch(index, `${path}.index`, "a slot's index");
  const ways = [{ reachable, swept, path }];
  if (out !== null && out !== undefined) ways.push({ ...object(out, `${path}.out`), path: `${path}.out` });
  const boxes = ways.flatMap((way) => {
    const numbers = Array.from(listed(way.swept, `${way.path}.swept`), Number);
    const wrong = numbers.findIndex((value) => !Number.isFinite(value));
    if (wrong >= 0) throw mismatch(way.swept[wrong], `${way.path}.swept[${wrong}]`, "a finite number");
    return numbers;
  });
  const isReached = ways.every((way) => way.reachable === true);
  return { head: [index, Math.max(0, vehicles.indexOf(vehicle)), isReached ? 1 : 0, boxes.length], swept: boxes };
}

/** @param {any} value @param {string} path @returns {any[]} */
function listed(value, path) {
  if (!Array.isArray(value) && !ArrayBuffer.isView(value)) throw mismatch(value, path, "a list");
  return /** @type {any} */ (value);
}

/** @type {typeof import("./index.js").generateLot} */
export const generateLot = (options) => call(() => raw.generateLot(optional(options)));

/** @type {typeof import("./index.js").lotPresets} */
export const lotPresets = () => call(() => raw.lotPresets());

/** Bays of a part, by default: few enough that workers end together, and enough to share the obstacles. */
const PART = 4;

/** @type {typeof import("./index.js").auditInParts} */
export async function auditInParts(scene, options, run, how = {}) {
  const { workers = 2, bays = PART, signal, onProgress } = object(how, "how");
  if (signal !== undefined && !(signal instanceof AbortSignal)) throw mismatch(signal, "how.signal", "an AbortSignal");
  if (onProgress !== undefined && typeof onProgress !== "function")
    throw mismatch(onProgress, "how.onProgress", "a function");
  if (typeof run !== "function") throw mismatch(run, "run", "a function");
  for (const [name, value] of Object.entries({ workers, bays }))
    if (!Number.isInteger(value) || value < 1) throw mismatch(value, `how.${name}`, "a whole number from 1");
  const slots = listed(object(scene, "scene").slots ?? [], "slots");
  const asked = listed(object(options, "options").bays ?? slots.map((_, index) => index), "bays");
  const indices = asked.map((bay) => (typeof bay === "number" ? bay : slots.findIndex((slot) => slot?.id === bay)));
  const unknown = indices.findIndex((index) => !(index in slots));
  if (unknown >= 0) throw mismatch(asked[unknown], `bays[${unknown}]`, "the id or index of a slot");
  const all = [...new Set(indices)].sort((a, b) => a - b);
  const parts = Array.from({ length: Math.ceil(all.length / bays) }, (_, at) => all.slice(at * bays, (at + 1) * bays));
  /** @type {import("./index.js").AuditRow[][]} */
  const answers = [];
  let next = 0,
    done = 0;
  const lane = async () => {
    while (next < parts.length) {
      signal?.throwIfAborted();
      const at = next++,
        part = parts[at] ?? [];
      const rows = await run(scene, { ...options, bays: part }, signal);
      signal?.throwIfAborted();
      answers[at] = rows;
      done += part.length;
      onProgress?.({ done, total: all.length, rows });
    }
  };
  await Promise.all(Array.from({ length: Math.min(workers, parts.length) }, lane));
  return answers.flat();
}
