// @ts-check
/**
 * Prints the TypeScript types of the planners' ids and settings, from the registry of a built module:
 * `node settings-types.mjs <the package's node.js>`.
 */
import { pathToFileURL } from "node:url";

/** @typedef {import("parkade").PlannerInfo} PlannerInfo */
/** @typedef {import("parkade").ParameterInfo} ParameterInfo */

/** Longer lines are divided. */
const WIDEST = 120;

/** @param {PlannerInfo[]} all */
function declarations(all) {
  const families = [...new Set(all.map(({ family }) => family))];
  return [
    "/** The planners' ids and settings: written by `cargo xtask build` from the planners' registry. */",
    families
      .map((family) =>
        union(
          `${pascal(family)}PlannerId`,
          all.filter((one) => one.family === family).map(({ id }) => id),
        ),
      )
      .join("\n"),
    `export type PlannerId = ${families.map((family) => `${pascal(family)}PlannerId`).join(" | ")};`,
    ...families.flatMap((family) =>
      familySettings(
        family,
        all.filter((one) => one.family === family),
      ),
    ),
    `/** The settings of each planner, all of them optional. */\nexport interface PlannerSettings ` +
      `{\n${all.map((one) => `  ${key(one.id)}: ${settingsName(one, all)};`).join("\n")}\n}`,
    "",
  ]
    .join("\n\n")
    .replace(/\n+$/, "\n");
}

/** @param {string} name @param {string[]} words */
function union(name, words) {
  const members = words.map((word) => JSON.stringify(word)),
    line = `export type ${name} = ${members.join(" | ")};`;
  return line.length > WIDEST ? `export type ${name} =\n  | ${members.join("\n  | ")};` : line;
}

/** A comment before a field, in as many lines as it needs. @param {string} text */
function comment(text) {
  const line = `  /** ${text} */`;
  if (line.length <= WIDEST) return line;
  const lines = [""];
  for (const word of text.split(" ")) {
    const last = `${lines.at(-1)} ${word}`;
    if (`   *${last}`.length > WIDEST) lines.push(` ${word}`);
    else lines[lines.length - 1] = last;
  }
  return ["  /**", ...lines.map((one) => `   *${one}`), "   */"].join("\n");
}

/**
 * What all planners of a family have, and what groups of them have besides.
 * @param {string} family
 * @param {PlannerInfo[]} members
 */
function familySettings(family, members) {
  const texts = new Map(members.map((one) => [one, fields(one, members)]));
  const [first = []] = texts.values();
  const shared = first.filter((text) => [...texts.values()].every((others) => others.includes(text)));
  const base = `${pascal(family)}Settings`;
  const blocks = [
    `/** Settings of ${members.length > 1 ? `every ${family} planner` : key(members[0]?.id ?? "")}. */\nexport ` +
      `interface ${base} {\n${shared.join("\n")}\n}`,
  ];
  for (const one of members) {
    const own = (texts.get(one) ?? []).filter((text) => !shared.includes(text));
    if (own.length > 0 && settingsName(one, members) === `${pascal(one.id)}Settings`) {
      blocks.push(`export interface ${pascal(one.id)}Settings extends ${base} {\n${own.join("\n")}\n}`);
    }
  }
  return blocks;
}

/**
 * The name of a planner's settings: its family's where they are all the same, else the first planner's with the same
 * ones.
 * @param {PlannerInfo} planner
 * @param {PlannerInfo[]} all
 */
function settingsName(planner, all) {
  const family = all.filter((one) => one.family === planner.family);
  /** @param {PlannerInfo} one */
  const text = (one) => fields(one, family).sort().join();
  const alike = family.filter((one) => text(one) === text(planner));
  return `${pascal(alike.length === family.length ? planner.family : (alike[0] ?? planner).id)}Settings`;
}

/**
 * A planner's settings; what this module knows but cannot do is held to its default.
 * @param {PlannerInfo} planner
 * @param {PlannerInfo[]} family
 */
function fields({ id, parameters }, family) {
  const fixed = Object.entries(defaultConfig(id)).filter(([name]) => parameters.every((one) => one.name !== name));
  return [
    ...parameters.map((parameter) => field(parameter, family)),
    ...fixed.map(([name, value]) => `  /** Nothing else in this module. */\n  ${name}?: ${JSON.stringify(value)};`),
  ];
}

/**
 * One setting; where planners that share it differ in the default, it is `defaultConfig` that tells.
 * @param {ParameterInfo} parameter
 * @param {PlannerInfo[]} family
 */
function field(parameter, family) {
  const alike = family
    .flatMap(({ parameters }) => parameters)
    .filter((one) => one.name === parameter.name && kind(one) === kind(parameter));
  const isNullable = alike.some((one) => one.default === null);
  const defaults = new Set(alike.map((one) => JSON.stringify(one.default)));
  const range =
    parameter.min === undefined
      ? ""
      : ` Usual range: ${parameter.min} to ${parameter.max}${parameter.unit === "1" ? "" : ` ${parameter.unit}`}.`;
  const standard = defaults.size > 1 ? "" : ` Default: ${[...defaults][0]}.`;
  return `${comment(`${parameter.doc.en}${range}${standard}`)}\n  ${parameter.name}?: ${kind(parameter)}${
    isNullable ? " | null" : ""
  };`;
}

/** @param {ParameterInfo} parameter */
function kind({ type, choices = [] }) {
  const words = choices.map((word) => JSON.stringify(word));
  if (type === "choice") return words.join(" | ");
  return [type === "integer" ? "number" : type, ...words].join(" | ");
}

/** @param {string} id */
const key = (id) => (/^\w+$/.test(id) ? id : JSON.stringify(id));

/** @param {string} id */
const pascal = (id) => id.replace(/(?:^|-)(\w)/g, (_, letter) => letter.toUpperCase());

const { init, defaultConfig, planners } = await import(pathToFileURL(process.argv[2] ?? "").href);
await init();
process.stdout.write(declarations(planners()));
