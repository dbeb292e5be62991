// @ts-check
// The worker's script in Node.js.
import { parentPort } from "node:worker_threads";
import { Planner, init, optimise } from "../node.js";
import { serve } from "./serve.js";

const port = parentPort;
if (!port) throw new Error("parkade/worker/script: must run in a worker");

serve(/** @type {any} */ ({ Planner, init, optimise }), {
  send: (reply, transfer) => port.postMessage(reply, transfer),
  listen: (take) => void port.on("message", take),
});
