// @ts-check
// Browsers, workers and bundlers.
import { initializer } from "./runtime.js";
import load from "./parkade.js";

export * from "./api.js";
export * from "./complete.js";

/** @type {typeof import("./index.js").init} */
export const init = initializer(async (wasm) =>
  load(wasm === undefined ? undefined : { module_or_path: /** @type {BufferSource} */ (wasm) }),
);
