// @ts-check
// `parkade batch`.
import { appendFileSync } from "node:fs";
import { stat } from "node:fs/promises";
import { availableParallelism } from "node:os";
import { version } from "../node.js";
import { auditOptions } from "./audit-options.js";
import { choice, count, plannerIds, seconds, settings, sweep } from "./input.js";
import { Refused, explained, reason, unwritten } from "./refusal.js";
import { digest, hashOf, isFinal, isShort, mend, outline, questionOf, read } from "./results.js";
import { scenes } from "./scenes.js";
import { startThreads } from "./threads.js";

/** @typedef {import("tinypool").Tinypool} Tinypool */
/** @typedef {import("./results.js").Result} Result */
/** @typedef {import("./results.js").Extras} Extras */
/**
 * @typedef {{ key: string, scene: import("./scenes.js").Scene, content: string,
 *   planner: import("../index.js").PlannerId | "audit", config: Record<string, unknown>, extras: Extras }} Task
 */

/** The name of audits among planners. @type {"audit"} */
const AUDIT = "audit";

/**
 * Time a thread should be away with a group of tasks: far above what a message costs, and no result waits long to be
 * written.
 */
const GROUP_MS = 50;
/** Tasks in a group at most. */
const GROUP = 256;
const TICK_MS = 200;

/** @type {import("./commands.js").Run} */
export async function batch(places, values, module) {
  if (places.length === 0) throw new Refused("which scenes? Folders, .json or .jsonl files");
  const jobs = count("jobs", values.jobs, availableParallelism(), 1024);
  const shard = shardOf(values.shard);
  const out = values.out ?? (shard.of === 1 ? "results.jsonl" : `results-${shard.at}-of-${shard.of}.jsonl`);
  const isAudit = choice("task", values.task, ["plan", "audit"]) === "audit";
  if (isAudit && values.planner !== undefined) throw new Refused("--planner: audits use hybrid; leave the option out");
  if (isAudit && values.paths)
    throw new Refused("--paths: rows of audits have no paths; `parkade audit --format json` has");
  if (isAudit && values.sweep !== undefined)
    throw new Refused("--sweep: audits have one set of settings; `--set` changes them");
  // In results, an audit stands where planners do, and its options where settings do.
  const planners = plannerIds(values.planner, "hybrid");
  /** @type {readonly Task["planner"][]} */
  const ids = isAudit ? [AUDIT] : planners,
    configs = isAudit
      ? [/** @type {Record<string, unknown>} */ (auditOptions(values))]
      : sweep(values.sweep, settings(values.set, planners), planners),
    timeout = seconds(values.timeout),
    extras = { paths: values.paths === true, times: values.times === true };
  for (const place of places)
    if (!(await stat(place).catch(() => null))) throw new Refused(`${place}: no such file or folder`);

  // Threads start while the scenes are listed.
  const pool = startThreads("./worker.js", jobs, module);
  try {
    await mend(out).catch((error) => {
      throw new Refused(`${out}: ${reason(error)}`);
    });
    /** @type {Map<string, Result>} */
    const done = new Map();
    const before = await stat(out).catch(() => null);
    if (before?.isFile()) for await (const result of read(out)) done.set(result.key, outline(result));
    const { tasks, keys } = await listed(places, ids, configs, shard, extras);
    const isDone = (/** @type {Result | undefined} */ result) => isFinal(result) && !isShort(result, extras);
    const open = tasks.filter(({ key }) => !isDone(done.get(key)));
    const results = tasks.flatMap(({ key }) => done.get(key) ?? []).filter(isDone);
    const append = (/** @type {string} */ lines) => {
      try {
        appendFileSync(out, lines);
      } catch (error) {
        throw unwritten(out, error);
      }
    };
    append(superseded(done.values(), keys, extras));
    const progress = new Progress(tasks.length, results.length, values.quiet === true);
    const each = (/** @type {string} */ lines, /** @type {Result[]} */ more) => {
      append(lines);
      results.push(...more);
      progress.step(more.length);
    };
    const stopped = await planned(pool, open, jobs, each, timeout);
    progress.end();
    return told(results, { of: tasks.length, now: open.length, isAudit }, out, stopped);
  } finally {
    await pool.destroy();
  }
}

/** What the two numbers of the last line count: scenes with a path and without, or lots. */
const COUNTED = {
  plan: ["planned", "found", "without a path"],
  audit: ["audited", "with all bays in reach", "without"],
};

/**
 * Says what became of the batch.
 * @param {Result[]} all
 * @param {{ of: number, now: number, isAudit: boolean }} tasks
 * @param {string} out
 * @param {boolean} stopped
 */
function told(all, { of, now, isAudit }, out, stopped) {
  const found = all.filter(({ outcome }) => outcome === "found").length,
    failed = all.filter(({ error }) => error !== undefined),
    [done, good, bad] = COUNTED[isAudit ? "audit" : "plan"];
  process.stdout.write(
    `${all.length} of ${of} ${done} (${now - (of - all.length)} now): ${found} ${good}, ${
      all.length - found - failed.length
    } ${bad}, ${failed.length} refused; digest ${digest(all)}\n`,
  );
  for (const { scene, planner, error } of failed.slice(0, 10))
    process.stderr.write(`parkade: ${scene} (${planner}): ${error && explained(error)}\n`);
  if (failed.length > 10) process.stderr.write(`parkade: … and ${failed.length - 10} more in ${out}\n`);
  if (stopped) process.stderr.write(`parkade: stopped; run the same command to continue\n`);
  return stopped ? 130 : failed.length > 0 ? 1 : 0;
}

/** @param {string} [text] */
function shardOf(text = "1/1") {
  const match = /^(\d{1,6})\/(\d{1,6})$/.exec(text);
  const at = Number(match?.[1]),
    of = Number(match?.[2]);
  if (!match || at < 1 || of < 1 || at > of) throw new Refused(`--shard ${text}: must be I/N with I from 1 to N`);
  return { at, of };
}

/**
 * Lines that end those results whose scene holds something else by now, and those that are planned again for more.
 * @param {Iterable<Result>} results
 * @param {Map<string, Set<string>>} keys
 * @param {Extras} extras
 */
function superseded(results, keys, extras) {
  const current = new Set([...keys.values()].flatMap((some) => [...some]));
  return [...results]
    .filter((one) => !one.superseded && keys.has(questionOf(one)))
    .filter((one) => !current.has(one.key) || isShort(one, extras))
    .map(
      ({ key, scene, planner, settings }) => `${JSON.stringify({ key, scene, planner, settings, superseded: true })}\n`,
    )
    .join("");
}

/**
 * The tasks, each once: the same scene in two files is one task. `keys` are those of all shards, by question.
 * @param {string[]} places
 * @param {readonly Task["planner"][]} ids
 * @param {Record<string, unknown>[]} configs
 * @param {{ at: number, of: number }} shard
 * @param {Extras} extras
 */
async function listed(places, ids, configs, { at, of }, extras) {
  /** @type {Map<string, Task>} */
  const tasks = new Map();
  /** @type {Map<string, Set<string>>} */
  const keys = new Map();
  const by = version(),
    asked = ids.flatMap((planner) =>
      configs.map((config) => ({ planner, config, under: JSON.stringify(Object.entries(config).sort()) })),
    );
  for (const place of places) {
    let empty = true;
    for await (const { scene, content } of scenes(place)) {
      empty = false;
      const isMine = parseInt(content.slice(0, 8), 16) % of === at - 1;
      for (const { planner, config, under } of asked) {
        const key = hashOf([by, planner, under, content].join("\n"));
        if (isMine && !tasks.has(key)) tasks.set(key, { key, scene, content, planner, config, extras });
        const question = questionOf({ scene: scene.name, planner, settings: config });
        keys.set(question, (keys.get(question) ?? new Set()).add(key));
      }
    }
    if (empty) throw new Refused(`${place}: no .json scenes here`);
  }
  return { tasks: [...tasks.values()], keys };
}

/**
 * Plans in groups, which grow and shrink with the time they take. Returns whether it was interrupted.
 * @param {Pick<Tinypool, "run" | "recycleWorkers">} pool
 * @param {Task[]} tasks
 * @param {number} jobs
 * @param {(lines: string, results: Result[]) => void} each
 * @param {number} [limit] of one task's time, seconds
 */
export async function planned(pool, tasks, jobs, each, limit) {
  let stopped = false;
  const stop = () => {
    stopped = true;
  };
  process.once("SIGINT", stop).once("SIGTERM", stop);
  /** Tasks in progress when a thread's module trapped; each is tried once more in a new thread. @type {Set<Task>} */
  const again = new Set();
  /** Tasks of a group that took too long; each is planned alone. @type {Set<Task | undefined>} */
  const alone = new Set();
  const left = tasks.toReversed();
  let size = 1;
  const lane = async () => {
    while (left.length > 0 && !stopped) {
      const most = alone.has(left.at(-1)) ? 1 : Math.min(size, Math.ceil(left.length / (4 * jobs)));
      const group = left.splice(-most).reverse(),
        [first] = group;
      const ended = await inTime(pool, group, limit);
      if (ended === "late") {
        if (group.length === 1 && first && limit) each(...late(first, limit));
        else {
          for (const task of group.reverse()) {
            left.push(task);
            alone.add(task);
          }
        }
        continue;
      }
      const { done, ms } = ended;
      const failed = done.at(-1)?.result.error?.code === "internal" ? group[done.length - 1] : undefined;
      if (failed !== undefined && !again.has(failed)) {
        again.add(failed);
        done.pop();
      }
      if (done.length > 0)
        each(
          done.map(({ line }) => line).join(""),
          done.map(({ result }) => result),
        );
      left.push(...group.slice(done.length).reverse());
      if (failed !== undefined) await pool.recycleWorkers();
      else if (done.length > 0)
        size = Math.max(1, Math.min(GROUP, 2 * size, Math.floor((GROUP_MS * done.length) / ms)));
    }
  };
  try {
    // Two groups per thread keep it busy; under a limit of time none may wait for a thread.
    await Promise.all(Array.from({ length: Math.min(tasks.length, limit ? jobs : 2 * jobs) }, lane));
  } finally {
    process.off("SIGINT", stop).off("SIGTERM", stop);
  }
  return stopped;
}

/**
 * @param {Pick<Tinypool, "run">} pool
 * @param {Task[]} group
 * @param {number} [most] seconds, after which its thread is replaced
 * @returns {Promise<Awaited<ReturnType<typeof import("./worker.js").default>> | "late">}
 */
async function inTime(pool, group, most) {
  if (most === undefined) return pool.run(group);
  const abort = new AbortController(),
    timer = setTimeout(() => abort.abort(), most * 1000);
  try {
    return await pool.run(group, { signal: abort.signal });
  } catch (error) {
    if (abort.signal.aborted) return "late";
    throw error;
  } finally {
    clearTimeout(timer);
  }
}

/** @param {Task} task @param {number} seconds @returns {[string, Result[]]} */
function late({ key, scene, planner, content, config }, seconds) {
  const error = { code: "timeout", path: "", message: `took longer than ${seconds} s` };
  const result = { key, scene: scene.name, sceneHash: content, planner, settings: config, error };
  return [`${JSON.stringify(result)}\n`, [result]];
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
    if (done > 0 && !quiet) process.stderr.write(`${done} of ${total} are already done\n`);
  }

  /** @param {number} more */
  step(more) {
    const before = this.done;
    this.done += more;
    if (this.quiet) return;
    const now = performance.now(),
      tenth = (/** @type {number} */ done) => Math.floor((done * 10) / this.total);
    if (this.live ? now - this.last < TICK_MS : tenth(this.done) === tenth(before)) return;
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
    const part = this.done / Math.max(1, this.total),
      rate = ((this.done - this.before) * 1000) / Math.max(1, now - this.from);
    const left = rate > 0 ? Math.ceil((this.total - this.done) / rate) : 0;
    const bar = "█".repeat(Math.round(part * 30)).padEnd(30, "·");
    const words = `${this.done}/${this.total} · ${rate.toFixed(1)}/s · ${left} s left`;
    process.stderr.write(this.live ? `\r${bar} ${words}\x1b[K` : `${words}\n`);
  }
}
