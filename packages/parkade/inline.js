// @ts-check
// Wherever a file beside this one may get lost: bundles, servers' components. The module is text in `bytes.js`.
import { base64 } from "./bytes.js";
import { initSync } from "./parkade.js";
import { initializer } from "./runtime.js";

export * from "./api.js";
export * from "./complete.js";

/** @type {typeof import("./index.js").init} */
export const init = initializer(async (wasm = decoded()) => {
  const isModule = wasm instanceof WebAssembly.Module;
  return initSync({ module: isModule ? wasm : await WebAssembly.compile(/** @type {BufferSource} */ (wasm)) });
});

function decoded() {
  const text = atob(base64),
    bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}
