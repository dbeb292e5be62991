// @ts-check
// The results of `parkade batch`: a JSON object a line, appended only.
import { createHash } from "node:crypto";
import { createReadStream } from "node:fs";
import { open, stat } from "node:fs/promises";
import { createInterface } from "node:readline";
import { Refused, reason } from "./refusal.js";

/**
 * A scene planned by a planner, or why it could not be. `superseded` ends a result: its scene is another one by now.
 * @typedef {{ key: string, scene: string, planner: string, settings: Record<string, unknown>, superseded?: true,
 *   outcome?: string, verdict?: string, hash?: string, path?: unknown, seconds?: number,
 *   error?: { code: string, path: string, message: string }, [figure: string]: unknown }} Result
 */

/** The part of a written result that is kept in memory. @param {Result} result @returns {Result} */
export const outline = ({ key, scene, planner, settings, superseded, outcome, hash, path, seconds, error }) => ({
  key,
  scene,
  planner,
  settings,
  superseded,
  outcome,
  hash,
  path: path === undefined ? undefined : true,
  seconds,
  error,
});

/** What `--paths` and `--times` add to results. @typedef {{ paths: boolean, times: boolean }} Extras */

/** True if a plan was made without what is asked for now. @param {Result | undefined} result @param {Extras} extras */
export const isShort = (result, { paths, times }) =>
  result?.outcome !== undefined && ((paths && result.path === undefined) || (times && result.seconds === undefined));

/** The key of a result: scene, planner and settings. @param {Pick<Result, "scene" | "planner" | "settings">} result */
export const questionOf = ({ scene, planner, settings }) =>
  JSON.stringify([scene, planner, Object.entries(settings ?? {}).sort()]);

/**
 * True if a result stays when its scene is planned again: one that ran out of time does not.
 * @param {Result | undefined} result
 */
export const isFinal = (result) =>
  result !== undefined && result.superseded !== true && result.error?.code !== "timeout";

/** @param {string | Uint8Array} text */
export const hashOf = (text) => createHash("sha256").update(text).digest("hex").slice(0, 32);

/** @param {string} file @returns {AsyncGenerator<Result>} */
export async function* read(file) {
  let at = 0;
  for await (const line of createInterface({ input: createReadStream(file), crlfDelay: Infinity })) {
    at++;
    if (line === "") continue;
    /** @type {any} */
    let value;
    try {
      value = JSON.parse(line);
    } catch {
      value = null;
    }
    if (typeof value?.key !== "string" || typeof value?.planner !== "string")
      throw new Refused(`${file}:${at}: is no result of \`parkade batch\``);
    yield value;
  }
}

/** How a line of results begins. */
const BEGINNING = '{"key":"';

/**
 * Removes the partial last line of a run that was stopped while writing; other text is somebody else's.
 * @param {string} file
 */
export async function mend(file) {
  const size = await stat(file).then(
    (one) => one.size,
    () => 0,
  );
  if (size === 0) return;
  const handle = await open(file, "r+");
  try {
    const block = Buffer.alloc(65_536);
    for (let end = size; end > 0; ) {
      const from = Math.max(0, end - block.length);
      await handle.read(block, 0, end - from, from);
      const last = block.subarray(0, end - from).lastIndexOf(10);
      end = from;
      if (last < 0 && from > 0) continue;
      const start = from + last + 1;
      if (start === size) return;
      const { buffer, bytesRead } = await handle.read(Buffer.alloc(BEGINNING.length), 0, BEGINNING.length, start);
      if (!BEGINNING.startsWith(buffer.toString("utf8", 0, bytesRead)))
        throw new Error("is no file of results of `parkade batch`");
      return await handle.truncate(start);
    }
  } finally {
    await handle.close();
  }
}

/** One hash over results in whatever order. @param {Iterable<Result>} results */
export function digest(results) {
  const lines = [...results].map(({ key, hash, error }) => `${key} ${hash ?? error?.message ?? ""}`).sort();
  return hashOf(lines.join("\n"));
}

/** @type {import("./commands.js").Run} */
export async function digestFiles(files) {
  if (files.length === 0) throw new Refused("which files? Results of `parkade batch` (.jsonl)");
  /** @type {Map<string, Result>} */
  const all = new Map();
  let repeated = 0;
  for (const file of files) {
    await stat(file).catch((error) => {
      throw new Refused(`${file}: ${reason(error)}`);
    });
    for await (const result of read(file)) {
      if (isFinal(all.get(result.key)) && !result.superseded) repeated++;
      all.set(result.key, outline(result));
    }
  }
  for (const { key, superseded } of all.values()) if (superseded) all.delete(key);
  process.stdout.write(`${digest(all.values())}  ${all.size} results${repeated > 0 ? `, ${repeated} repeated` : ""}\n`);
  return repeated > 0 ? 1 : 0;
}
