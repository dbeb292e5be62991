// @ts-check
// Browsers and bundlers, which find the worker's script and the module by the form of these lines.
import { entry } from "./client.js";
import { mostWorkers } from "./pool.js";

export { ParkadeError } from "../runtime.js";
export { latest } from "./latest.js";
export { transferables } from "./transfer.js";

export const { createPlanner, createPool } = entry({
  spawn: () => new Worker(new URL("./script.js", import.meta.url), { type: "module", name: "parkade" }),
  compile: async (wasm = new URL("../parkade_bg.wasm", import.meta.url)) => {
    const response = await fetch(/** @type {URL | string} */ (wasm));
    if (!response.ok) throw new Error(`the server answered ${response.status}`);
    const isWasm = response.headers.get("content-type")?.startsWith("application/wasm") ?? false;
    return isWasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
  },
  most: () => mostWorkers(navigator.hardwareConcurrency || 1),
});
