// @ts-check
// The option `--timeout`: the command in a thread that can be ended while it plans.
import { Worker } from "node:worker_threads";

/** The exit code of coreutils' `timeout`. */
const LATE = 124;

/** @param {string[]} args of the command @param {number} seconds @returns {Promise<number>} its exit code */
export function within(args, seconds) {
  const readsInput = args.includes("-");
  const worker = new Worker(new URL("./main.js", import.meta.url), { argv: args, stdin: readsInput });
  if (readsInput) process.stdin.pipe(/** @type {import("node:stream").Writable} */ (worker.stdin));
  let isLate = false;
  const timer = setTimeout(() => {
    isLate = true;
    process.stderr.write(`parkade: took longer than ${seconds} s (--timeout)\n`);
    void worker.terminate();
  }, seconds * 1000);
  return new Promise((done, fail) => {
    worker.once("error", fail).once("exit", (code) => {
      clearTimeout(timer);
      if (readsInput) process.stdin.destroy();
      done(isLate ? LATE : code);
    });
  });
}
