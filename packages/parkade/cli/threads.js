// @ts-check
import { Tinypool } from "tinypool";

/**
 * As many threads as jobs run at a time, each with the module compiled once for all.
 * @param {string} script of this folder
 * @param {number} jobs
 * @param {WebAssembly.Module} module
 */
export const startThreads = (script, jobs, module) =>
  new Tinypool({
    filename: new URL(script, import.meta.url).href,
    minThreads: jobs,
    maxThreads: jobs,
    workerData: { module },
    isolateWorkers: false,
  });
