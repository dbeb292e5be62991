// @ts-check
// A thread of `parkade audit`: audits some bays.
import Tinypool from "tinypool";
import { audit, init } from "../node.js";

await init({ wasm: Tinypool.workerData.module });

/** @param {{ scene: import("../index.js").Scenario, options: import("../index.js").AuditOptions }} part */
export default function run({ scene, options }) {
  return audit(scene, options);
}
