// @ts-check
// The worker's script in browsers.
import { Planner, init, optimise } from "../index.js";
import { serve } from "./serve.js";

const scope = /** @type {any} */ (globalThis);

serve(/** @type {any} */ ({ Planner, init, optimise }), {
  send: (reply, transfer) => scope.postMessage(reply, transfer),
  listen: (take) => {
    scope.onmessage = (/** @type {MessageEvent} */ { data }) => take(data);
  },
});
