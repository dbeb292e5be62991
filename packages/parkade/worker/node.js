// @ts-check
// Node.js, whose workers have events of another form.
import { readFile } from "node:fs/promises";
import { availableParallelism } from "node:os";
import { fileURLToPath } from "node:url";
import { Worker } from "node:worker_threads";
import { entry } from "./client.js";

export { ParkadeError } from "../runtime.js";
export { latest } from "./latest.js";
export { transferables } from "./transfer.js";

export const { createPlanner, createPool } = entry({
  spawn: () => new Thread(new URL("script-node.js", import.meta.url)),
  compile: async (wasm = new URL("../parkade_bg.wasm", import.meta.url)) => {
    const place = String(wasm);
    if (/^(https?|data|blob):/.test(place)) {
      const response = await fetch(place);
      if (!response.ok) throw new Error(`the server answered ${response.status}`);
      return WebAssembly.compile(await response.arrayBuffer());
    }
    return WebAssembly.compile(await readFile(place.startsWith("file:") ? fileURLToPath(place) : place));
  },
  most: () => availableParallelism(),
});

/** A worker thread with the interface of a browser's worker. */
class Thread {
  /** @type {((event: { data: any }) => void) | null} */
  onmessage = null;
  /** @type {((event: { message: string }) => void) | null} */
  onerror = null;
  #thread;

  /** @param {URL} script */
  constructor(script) {
    this.#thread = new Worker(script, { name: "parkade" });
    this.#thread.on("message", (data) => this.onmessage?.({ data }));
    this.#thread.on("error", ({ message }) => this.onerror?.({ message }));
    this.unref();
  }

  /** @param {unknown} message @param {any[]} [transfer] */
  postMessage(message, transfer) {
    this.#thread.postMessage(message, transfer);
  }

  terminate() {
    void this.#thread.terminate();
  }

  ref() {
    this.#thread.ref();
  }

  /** A thread at rest does not keep the process alive. */
  unref() {
    this.#thread.unref();
  }
}
