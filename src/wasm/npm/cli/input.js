// @ts-check
// What the command line is given: scenes, settings, choices.
import { readFile, stat } from "node:fs/promises";
import { buffer } from "node:stream/consumers";
import { basename, dirname, extname, join } from "node:path";
import { importScene, planners, scenario, scenarios } from "../node.js";

/** Bad input, in words for people. */
export class Refused extends Error {}

/** @param {string} path */
export async function text(path) {
  return (await bytes(path)).toString("utf8");
}

/** @param {string} path */
async function bytes(path) {
  try {
    return path === "-" ? await buffer(process.stdin) : await readFile(path);
  } catch (error) {
    throw new Refused(`${path}: ${reason(error)}`);
  }
}

/** @param {unknown} error */
export function reason(error) {
  const { code, message } = /** @type {NodeJS.ErrnoException} */ (error);
  return code === "ENOENT" ? "there is no such file" : code === "EISDIR" ? "is a folder" : message;
}

/** @param {string} path @param {string} content */
export function json(path, content) {
  try {
    return JSON.parse(content);
  } catch (error) {
    throw new Refused(`${path}: is not JSON: ${reason(error)}`);
  }
}

/**
 * A scene by file, by the id of a built-in one, or from standard input.
 * @param {string[]} places
 * @returns {Promise<import("../index.js").Scenario>}
 */
export async function scene([place, ...more]) {
  if (place === undefined) throw new Refused("which scene? A file, the id of a built-in scene, or -");
  if (more.length > 0) throw new Refused(`one scene at a time, got also ${more.join(", ")}`);
  if (place === "-") return json("standard input", await text("-"));
  const isFile = await stat(place).then(() => true, () => false);
  if (!isFile && scenarios().some(({ id }) => id === place)) return scenario(place);
  if (!isFile && extname(place) === "") throw new Refused(`${place}: neither a file nor a built-in scene; \`parkade scenarios\` lists those`);
  if (extname(place) === ".json") return json(place, await text(place));
  return importScene(await withCompanions(place)).scene;
}

/** A map's questions, or the picture that a ROS map names. @param {string} place */
async function withCompanions(place) {
  const files = { [basename(place)]: await bytes(place) };
  const content = files[basename(place)]?.toString("utf8") ?? "";
  const image = /^image:\s*['"]?([^'"\n]+?)['"]?\s*$/m.exec(content)?.[1];
  if (/\.ya?ml$/.test(place) && image) files[basename(image)] = await bytes(join(dirname(place), image));
  if (place.endsWith(".map")) {
    const questions = await readFile(`${place}.scen`).catch(() => readFile(place.replace(/\.map$/, ".scen"))).catch(() => null);
    if (questions) files[`${basename(place)}.scen`] = questions;
  }
  return files;
}

/** @param {string[]} [pairs] `name=value`, the value as JSON or else as a word */
export function settings(pairs = []) {
  /** @type {Record<string, unknown>} */
  const config = {};
  for (const pair of pairs) {
    const [name = "", ...value] = pair.split("=");
    if (name === "" || value.length === 0) throw new Refused(`--set ${pair}: must be NAME=VALUE`);
    const word = value.join("=");
    try {
      config[name] = JSON.parse(word);
    } catch {
      config[name] = word;
    }
  }
  return config;
}

/**
 * @template {string} T
 * @param {string} option
 * @param {string | undefined} value
 * @param {readonly [T, ...T[]]} choices the first is the default
 * @returns {T}
 */
export function choice(option, value, choices) {
  const found = value === undefined ? choices[0] : choices.find((one) => one === value);
  if (found === undefined) throw new Refused(`--${option} ${value}: must be one of ${choices.join(", ")}`);
  return found;
}

/** @param {string} option @param {string | undefined} value @param {number} otherwise @param {number} most */
export function count(option, value, otherwise, most) {
  if (value === undefined) return otherwise;
  const number = Number(value);
  if (!/^\d+$/.test(value) || number < 1 || number > most) throw new Refused(`--${option} ${value}: must be a whole number from 1 to ${most}`);
  return number;
}

/** @param {string | undefined} value @param {string} otherwise @returns {import("../index.js").PlannerId[]} */
export function plannerIds(value, otherwise) {
  const known = planners().map(({ id }) => id);
  return (value ?? otherwise).split(",").map((word) => {
    const id = known.find((one) => one === word.trim());
    if (id === undefined) throw new Refused(`--planner ${word}: there is no such planner; there are ${known.join(", ")}`);
    return id;
  });
}
