// @ts-check
// Node.js, which cannot fetch files: the module is read from disk.
import { readFile } from "node:fs/promises";
import { initializer } from "./runtime.js";
import load, { initSync } from "./parkade.js";

export * from "./api.js";
export * from "./complete.js";

const BESIDE = new URL("parkade_bg.wasm", import.meta.url);

/** @type {typeof import("./index.js").init} */
export const init = initializer(async (wasm = BESIDE) => {
  const given = await source(wasm);
  const isBytes = given instanceof ArrayBuffer || ArrayBuffer.isView(given);
  const module = isBytes ? await WebAssembly.compile(/** @type {BufferSource} */ (given)) : given;
  // `load` asks whether it was given a `Response`, for which Node.js reads in its HTTP client: tens of milliseconds.
  return module instanceof WebAssembly.Module
    ? initSync({ module })
    : load({ module_or_path: /** @type {any} */ (module) });
});

/** @param {unknown} wasm bytes, a module, a URL or a path */
async function source(wasm) {
  const isUrl = wasm instanceof URL || (typeof wasm === "string" && /^(https?|data|blob|file):/.test(wasm));
  if (isUrl) {
    const url = new URL(wasm);
    return url.protocol === "file:" ? readFile(url) : url;
  }
  return typeof wasm === "string" ? readFile(wasm) : wasm;
}
