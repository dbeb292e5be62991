// @ts-check
// `parkade batch`.
import { createReadStream } from "node:fs";
import { open, readFile, readdir, stat } from "node:fs/promises";
import { availableParallelism } from "node:os";
import { join, relative } from "node:path";
import { createInterface } from "node:readline";
import { Tinypool } from "tinypool";
import { version } from "../node.js";
import { Refused, count, plannerIds, reason, settings } from "./input.js";
import { digest, hashOf, mend, read } from "./results.js";

/** @typedef {import("./results.js").Result} Result */
/** @typedef {{ key: string, scene: string, text: string, planner: import("../index.js").PlannerId, config: Record<string, unknown> }} Task */

/** Tasks read ahead for each thread. */
const AHEAD = 8;
const TICK_MS = 200;

/** @type {import("./main.js").Run} */
export async function batch([place, ...more], values) {
  if (place === undefined || more.length > 0) throw new Refused("which folder of scenes? One folder, or one .jsonl file");
  const jobs = count("jobs", values.jobs, availableParallelism(), 1024);
  const shard = shardOf(values.shard);
  const out = values.out ?? (shard.of === 1 ? "results.jsonl" : `results-${shard.at}-of-${shard.of}.jsonl`);
  const ids = plannerIds(values.planner, "hybrid"), config = settings(values.set);
  if (!(await stat(place).catch(() => null))) throw new Refused(`${place}: there is no such folder`);

  await mend(out);
  /** @type {Map<string, Result>} */
  const done = new Map();
  if (await stat(out).catch(() => null)) for await (const result of read(out)) done.set(result.key, result);

  const tasks = await listed(place, ids, config, shard);
  const open_ = tasks.filter(({ key }) => !done.has(key));
  const results = new Map(tasks.flatMap(({ key }) => (done.has(key) ? [[key, /** @type {Result} */ (done.get(key))]] : [])));
  const progress = new Progress(tasks.length, tasks.length - open_.length, values.quiet === true);
  const stopped = await planned(open_, jobs, out, (result) => {
    results.set(result.key, result);
    progress.step();
  });
  progress.end();
  const all = [...results.values()];
  const found = all.filter(({ outcome }) => outcome === "found").length, failed = all.filter(({ error }) => error !== undefined);
  process.stdout.write(`${all.length} of ${tasks.length} planned (${open_.length - (tasks.length - all.length)} now): ${found} found, ${all.length - found - failed.length} without a path, ${failed.length} refused; digest ${digest(all)}\n`);
  for (const { scene, planner, error } of failed.slice(0, 10)) process.stderr.write(`parkade: ${scene} (${planner}): ${error?.message}\n`);
  if (failed.length > 10) process.stderr.write(`parkade: … and ${failed.length - 10} more in ${out}\n`);
  if (stopped) process.stderr.write(`parkade: stopped; the same command goes on from here\n`);
  return stopped ? 130 : failed.length > 0 ? 1 : 0;
}

/** @param {string} [text] */
function shardOf(text = "1/1") {
  const match = /^(\d{1,6})\/(\d{1,6})$/.exec(text);
  const at = Number(match?.[1]), of = Number(match?.[2]);
  if (!match || at < 1 || of < 1 || at > of) throw new Refused(`--shard ${text}: must be I/N with I from 1 to N`);
  return { at, of };
}

/**
 * What is to be planned, each once: the same scene in two files is the same task.
 * @param {string} place
 * @param {import("../index.js").PlannerId[]} ids
 * @param {Record<string, unknown>} config
 * @param {{ at: number, of: number }} shard
 */
async function listed(place, ids, config, { at, of }) {
  /** @type {Map<string, Task>} */
  const tasks = new Map();
  for await (const { scene, text } of scenes(place)) {
    const content = hashOf(text);
    if (parseInt(content.slice(0, 8), 16) % of !== at - 1) continue;
    for (const planner of ids) {
      const key = hashOf([version(), planner, JSON.stringify(Object.entries(config).sort()), content].join("\n"));
      if (!tasks.has(key)) tasks.set(key, { key, scene, text, planner, config });
    }
  }
  if (tasks.size === 0 && of === 1) throw new Refused(`${place}: holds no .json scenes`);
  return [...tasks.values()];
}

/** @param {string} place @returns {AsyncGenerator<{ scene: string, text: string }>} */
async function* scenes(place) {
  if (place.endsWith(".jsonl")) {
    let at = 0;
    for await (const line of createInterface({ input: createReadStream(place), crlfDelay: Infinity })) {
      at++;
      if (line.trim() !== "") yield { scene: `${place}:${at}`, text: line };
    }
    return;
  }
  const entries = await readdir(place, { recursive: true, withFileTypes: true }).catch((error) => {
    throw new Refused(`${place}: ${reason(error)}`);
  });
  const files = entries.filter((entry) => entry.isFile() && entry.name.endsWith(".json")).map((entry) => join(entry.parentPath ?? entry.path, entry.name)).sort();
  for (const file of files) yield { scene: relative(place, file).replaceAll("\\", "/"), text: await readFile(file, "utf8") };
}

/**
 * Plans on as many threads, appending each result as one write. Returns whether it was interrupted.
 * @param {Task[]} tasks
 * @param {number} jobs
 * @param {string} out
 * @param {(result: Result) => void} each
 */
async function planned(tasks, jobs, out, each) {
  if (tasks.length === 0) return false;
  const module = await WebAssembly.compile(await readFile(new URL("../parkade_bg.wasm", import.meta.url)));
  const pool = new Tinypool({ filename: new URL("./worker.js", import.meta.url).href, minThreads: jobs, maxThreads: jobs, workerData: module, isolateWorkers: false });
  const file = await open(out, "a");
  let stopped = false;
  const stop = () => {
    stopped = true;
  };
  process.once("SIGINT", stop).once("SIGTERM", stop);
  try {
    let next = 0;
    const lane = async () => {
      while (next < tasks.length && !stopped) {
        const { key, scene, ...task } = /** @type {Task} */ (tasks[next++]);
        const result = { key, scene, planner: task.planner, ...(await run(pool, task)) };
        await file.appendFile(`${JSON.stringify(result)}\n`);
        each(result);
      }
    };
    await Promise.all(Array.from({ length: Math.min(tasks.length, jobs + AHEAD) }, lane));
  } finally {
    process.off("SIGINT", stop).off("SIGTERM", stop);
    await file.close();
    await pool.destroy();
  }
  return stopped;
}

/** After a trap a thread's module is of no more use: all threads are replaced, and what failed with it is tried once more. @param {Tinypool} pool @param {object} task */
async function run(pool, task) {
  const first = await pool.run(task);
  if (first.error?.code !== "internal") return first;
  await pool.recycleWorkers();
  return pool.run(task);
}

/** A bar on a terminal; elsewhere a line at every tenth. */
class Progress {
  /** @param {number} total @param {number} done @param {boolean} quiet */
  constructor(total, done, quiet) {
    this.total = total;
    this.done = this.before = done;
    this.quiet = quiet;
    this.live = process.stderr.isTTY === true;
    this.from = performance.now();
    this.last = 0;
    if (done > 0 && !quiet) process.stderr.write(`${done} of ${total} are there already\n`);
  }

  step() {
    this.done++;
    if (this.quiet) return;
    const now = performance.now(), tenth = Math.floor((this.done * 10) / this.total);
    if (this.live ? now - this.last < TICK_MS : tenth === Math.floor(((this.done - 1) * 10) / this.total)) return;
    this.last = now;
    this.show(now);
  }

  end() {
    if (this.live && !this.quiet) {
      this.show(performance.now());
      process.stderr.write("\n");
    }
  }

  /** @param {number} now */
  show(now) {
    const part = this.done / Math.max(1, this.total), rate = ((this.done - this.before) * 1000) / Math.max(1, now - this.from);
    const left = rate > 0 ? Math.ceil((this.total - this.done) / rate) : 0;
    const bar = "█".repeat(Math.round(part * 30)).padEnd(30, "·");
    const words = `${this.done}/${this.total} · ${rate.toFixed(1)}/s · ${left} s left`;
    process.stderr.write(this.live ? `\r${bar} ${words}\x1b[K` : `${words}\n`);
  }
}
