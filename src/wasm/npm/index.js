// @ts-check
// Browsers, workers and bundlers.
import { initializer } from "./core.js";
import load from "./parkade.js";

export * from "./api.js";

/** @type {typeof import("./index.js").init} */
export const init = initializer(async (wasm) =>
  load(wasm === undefined ? undefined : { module_or_path: /** @type {BufferSource} */ (wasm) }),
);
