// @ts-check
// Which bays of a lot can be reached; in the complete module only.
import { packedScene } from "./cells.js";
import * as raw from "./parkade.js";
import { call, mismatch, object } from "./runtime.js";

/** @type {typeof import("./index.js").vehicles} */
export const vehicles = () => call(() => raw.vehicles());

/** @type {typeof import("./index.js").audit} */
export function audit(scene, options = {}) {
  const { onRow, ...others } = object(options, "options");
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
export function affectedRows(before, after, rows, options = {}) {
  const names = (options.vehicles ?? []).map((one) => (typeof one === "string" ? one : one.id));
  const heads = rows.map(({ index, vehicle, reachable, swept, out }) => [
    index,
    Math.max(0, names.indexOf(vehicle)),
    reachable && (out?.reachable ?? true) ? 1 : 0,
    swept.length + (out?.swept.length ?? 0),
  ]);
  const swept = rows.flatMap((row) => [row.swept, row.out?.swept ?? []].flatMap((one) => Array.from(one)));
  const touched = call(() =>
    raw.affectedRows(
      packedScene(before),
      packedScene(after),
      options,
      new Uint32Array(heads.flat()),
      new Float64Array(swept),
    ),
  );
  return rows.filter((_, at) => touched[at] === 1);
}

/** @type {typeof import("./index.js").generateLot} */
export const generateLot = (options = {}) => call(() => raw.generateLot(options));

/** @type {typeof import("./index.js").lotPresets} */
export const lotPresets = () => call(() => raw.lotPresets());

/** Bays of a part, by default: few enough that workers end together, and enough to share the obstacles. */
const PART = 4;

/** @type {typeof import("./index.js").auditInParts} */
export async function auditInParts(scene, options, run, { workers = 2, bays = PART, signal, onProgress } = {}) {
  if (typeof run !== "function") throw mismatch(run, "run", "a function");
  for (const [name, value] of Object.entries({ workers, bays }))
    if (!Number.isInteger(value) || value < 1) throw mismatch(value, name, "a whole number from 1", String(value));
  const slots = object(scene, "scene").slots ?? [];
  const asked = options.bays ?? slots.map((_, index) => index);
  const indices = asked.map((bay) => (typeof bay === "number" ? bay : slots.findIndex(({ id }) => id === bay)));
  const unknown = indices.findIndex((index) => !(index in slots));
  if (unknown >= 0)
    throw mismatch(asked[unknown], `bays[${unknown}]`, "the id or index of a slot", String(asked[unknown]));
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
