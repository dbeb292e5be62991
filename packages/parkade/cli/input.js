// @ts-check
// What the command line is given: scenes, settings, choices.
import { readFile, stat } from "node:fs/promises";
import { buffer } from "node:stream/consumers";
import { basename, dirname, extname, join } from "node:path";
import { ParkadeError, defaultConfig, importScene, planners, scenario, scenarios } from "../node.js";
import { Refused, explained, given, meant, reason } from "./refusal.js";

/** @param {string} path */
export async function text(path) {
  return (await bytes(path)).toString("utf8");
}

/** @param {string} path */
async function bytes(path) {
  if (path === "-") return small("standard input", await buffer(process.stdin));
  try {
    const { size } = await stat(path);
    if (size <= MAX_BYTES) return small(path, await readFile(path));
    throw new Refused(tooLarge(size));
  } catch (error) {
    throw new Refused(`${path}: ${reason(error)}`);
  }
}

/** No scene that a planner takes is larger. */
export const MAX_BYTES = 80_000_000;

/** @param {number} size */
export const tooLarge = (size) => `must have at most ${MAX_BYTES} bytes, has ${size}`;

/** A pipe has no size before it is read. @param {string} path @param {Buffer} content */
function small(path, content) {
  if (content.length > MAX_BYTES) throw new Refused(`${path}: ${tooLarge(content.length)}`);
  return content;
}

/**
 * What is wrong with a scene, with the place that it is read from.
 * @template T
 * @param {string} place
 * @param {() => T} use
 * @returns {T}
 */
export function of(place, use) {
  try {
    return use();
  } catch (error) {
    if (error instanceof ParkadeError && ["bad-scenario", "bad-vehicle"].includes(error.code))
      throw new Refused(`${place === "-" ? "standard input" : place}: ${explained(error).replace(/^scene: /, "")}`);
    throw error;
  }
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
  if (more.length > 0) throw new Refused(`one scene at a time, got also ${more.join(", ")}`);
  return sceneAt(place);
}

/** Scenes with the places that they are read from; one at least. @param {string[]} places */
export async function scenesAt(places) {
  if (new Set(places).size < places.length) {
    const twice = places.find((place, i) => places.indexOf(place) < i);
    throw new Refused(`${twice}: is given twice`);
  }
  const given = places.length > 0 ? places : [undefined];
  return Promise.all(given.map(async (place = "") => ({ place, scene: await sceneAt(place || undefined) })));
}

/** @param {string} [place] @returns {Promise<import("../index.js").Scenario>} */
async function sceneAt(place) {
  if (place === undefined) throw new Refused("which scene? A file, the id of a built-in scene, or -");
  if (place === "-") return json("standard input", await text("-"));
  const isFile = await stat(place).then(
    () => true,
    () => false,
  );
  if (!isFile && scenarios().some(({ id }) => id === place)) return scenario(place);
  if (!isFile && extname(place) === "")
    throw new Refused(
      `${place}: neither a file nor a built-in scene${
        meant(
          place,
          scenarios().map(({ id }) => id),
        ) || "; `parkade scenarios` lists those"
      }`,
    );
  if (extname(place) === ".json") return json(place, await text(place));
  const { isSitePlan, sitePlan } = await import("./site-plan.js");
  if (isSitePlan(place)) return sitePlan(place);
  return importScene(await withCompanions(place)).scene;
}

/** Refuses words beside the options. @param {string} command @param {string[]} places */
export function onlyOptions(command, places) {
  if (places.length > 0) throw new Refused(`${command} takes options only, got ${places.join(", ")}`);
}

/** True if it is a grid of another program. @param {string} [place] */
export const isMap = (place = "") => /\.(map|ya?ml)$/.test(place);

/** Ends of the names of files that scenes are read from; site plans are read elsewhere. */
const SCENES = /\.(json|map|scen|ya?ml|pgm|csv)$/i;

/** A map's questions, or the picture that a ROS map names. @param {string} place */
export async function withCompanions(place) {
  const files = { [basename(place)]: await bytes(place) };
  if (!SCENES.test(place))
    throw new Refused(`${place}: must end in .json, .map, .yaml, .csv, .dxf, .svg, .geojson or .osm`);
  const content = files[basename(place)]?.toString("utf8") ?? "";
  const image = /^image:\s*['"]?([^'"\n]+?)['"]?\s*$/m.exec(content)?.[1];
  if (/\.ya?ml$/.test(place) && image) files[basename(image)] = await bytes(join(dirname(place), image));
  if (place.endsWith(".map")) {
    const questions = await readFile(`${place}.scen`)
      .catch(() => readFile(place.replace(/\.map$/, ".scen")))
      .catch(() => null);
    if (questions) files[`${basename(place)}.scen`] = questions;
  }
  return files;
}

/**
 * @param {string[] | undefined} pairs `name=value`, the value as JSON or else as a word
 * @param {readonly import("../index.js").PlannerId[]} ids the planners that must have them
 * @param {string} [option] its name
 */
export function settings(pairs = [], ids, option = "set") {
  /** @type {Record<string, unknown>} */
  const config = {};
  for (const pair of pairs) {
    const [name = "", ...value] = pair.split("=");
    if (name === "" || value.length === 0) throw new Refused(`${given(option, pair)}: must be NAME=VALUE`);
    for (const id of ids) {
      const known = Object.keys(defaultConfig(id));
      if (!known.includes(name))
        throw new Refused(
          `--${option} ${pair}: ${id} has no such setting${
            meant(name, known) || `; \`parkade planners --planner ${id}\` lists its settings`
          }`,
        );
    }
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
 * All combinations of the option `--sweep`'s values, each with the settings of `--set`.
 * @param {string[] | undefined} pairs `name=value,value…`
 * @param {Record<string, unknown>} base
 * @param {readonly import("../index.js").PlannerId[]} ids
 */
export function sweep(pairs = [], base, ids) {
  let all = [base];
  for (const pair of pairs) {
    const [name = "", ...value] = pair.split("=");
    if (name === "" || value.length === 0) throw new Refused(`${given("sweep", pair)}: must be NAME=VALUE,VALUE…`);
    if (all.some((one) => Object.hasOwn(one, name))) throw new Refused(`--sweep ${pair}: ${name} is set already`);
    const words = value.join("=").split(",");
    const each = words.map((word) => settings([`${name}=${word}`], ids, "sweep"));
    if (new Set(each.map((one) => JSON.stringify(one))).size < each.length)
      throw new Refused(`--sweep ${pair}: has a value twice`);
    all = all.flatMap((one) => each.map((more) => ({ ...one, ...more })));
    if (all.length > MAX_SWEEP) throw new Refused(`--sweep: must have at most ${MAX_SWEEP} combinations`);
  }
  return all;
}

/** More are a mistake: each is planned on every scene. */
const MAX_SWEEP = 10_000;

/**
 * @template {string} T
 * @param {string} option
 * @param {string | undefined} value
 * @param {readonly [T, ...T[]]} choices the first is the default
 * @returns {T}
 */
export function choice(option, value, choices) {
  const found = value === undefined ? choices[0] : choices.find((one) => one === value);
  if (found === undefined) throw new Refused(`${given(option, value)}: must be one of ${choices.join(", ")}`);
  return found;
}

/** @param {string} option @param {string | undefined} value @param {number} otherwise @param {number} most */
export function count(option, value, otherwise, most) {
  if (value === undefined) return otherwise;
  const number = Number(value);
  if (!/^\d+$/.test(value) || number < 1 || number > most)
    throw new Refused(`${given(option, value)}: must be a whole number from 1 to ${most}`);
  return number;
}

/** A number in an option. @param {string} option @param {string} value */
export function numeric(option, value) {
  const number = Number(value);
  if (value.trim() === "" || !Number.isFinite(number)) throw new Refused(`${given(option, value)}: must be a number`);
  return number;
}

/**
 * Numbers by their names in the API.
 * @param {Record<string, string>} names of options, and of the same in the API
 * @param {Record<string, string | undefined>} values
 */
export function numerics(names, values) {
  const all = Object.entries(names).flatMap(([option, name]) => {
    const value = values[option];
    return value === undefined ? [] : [[name, numeric(option, value)]];
  });
  return /** @type {Record<string, number>} */ (Object.fromEntries(all));
}

/** The option `--timeout`. @param {string} [value] */
export const seconds = (value) => (value === undefined ? undefined : count("timeout", value, 1, 1_000_000));

/** @param {string | undefined} value @param {string} otherwise @returns {import("../index.js").PlannerId[]} */
export function plannerIds(value, otherwise) {
  const known = planners().map(({ id }) => id);
  return (value ?? otherwise).split(",").map((word) => {
    const id = known.find((one) => one === word.trim());
    if (id === undefined)
      throw new Refused(
        `${given("planner", word)}: there is no such planner${meant(word, known) || `; there are ${known.join(", ")}`}`,
      );
    return id;
  });
}
