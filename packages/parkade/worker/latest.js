// @ts-check
import { mismatch } from "../runtime.js";

/** @type {typeof import("./index.js").latest} */
export function latest(run, { giveUpAfter = 1000 } = {}) {
  if (typeof run !== "function") throw mismatch(run, "run", "a function");
  if (typeof giveUpAfter !== "number" || !(giveUpAfter >= 0)) {
    throw mismatch(giveUpAfter, "giveUpAfter", "milliseconds, 0 or more");
  }
  /** @typedef {{ args: any, done: (value: any) => void, failed: (error: unknown) => void }} Call */
  /** @type {AbortController | undefined} */
  let running;
  /** @type {Call | undefined} */
  let waiting;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** @param {Call} call */
  async function begin({ args, done, failed }) {
    const controller = new AbortController();
    running = controller;
    try {
      done(await run(controller.signal, ...args));
    } catch (error) {
      // The one that was given up for a newer one is superseded; nothing went wrong.
      if (controller.signal.aborted) done(undefined);
      else failed(error);
    }
    clearTimeout(timer);
    timer = running = undefined;
    const next = waiting;
    waiting = undefined;
    if (next) void begin(next);
  }

  return (...args) =>
    new Promise((done, failed) => {
      const call = { args, done, failed };
      if (!running) return void begin(call);
      waiting?.done(undefined);
      waiting = call;
      timer ??= setTimeout(() => running?.abort(), giveUpAfter);
    });
}
