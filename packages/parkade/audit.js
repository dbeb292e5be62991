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
