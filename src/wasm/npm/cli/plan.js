// @ts-check
// `parkade plan`.
import { Planner, toCSV, toSVG } from "../node.js";
import { Refused, choice, plannerIds, scene as read, settings } from "./input.js";
import { toJSON, write } from "./output.js";

/** @type {import("./main.js").Run} */
export async function plan(places, values) {
  const format = choice("format", values.format, ["json", "csv", "svg"]);
  const theme = choice("theme", values.theme, ["auto", "light", "dark"]);
  const [width, height] = size(values.size);
  const scene = await read(places);
  const [planner, ...more] = plannerIds(values.planner, "hybrid");
  if (planner === undefined || more.length > 0) throw new Refused("--planner: one planner at a time");
  const prepared = new Planner(planner, scene, settings(values.set));
  const found = prepared.plan({ trace: values.trace ?? false });
  prepared.free();
  const text = format === "json" ? toJSON(found) : format === "csv" ? toCSV(scene, found) : toSVG(scene, found, { width, height, theme });
  await write(text, values.out);
  if (found.outcome === "found") return 0;
  process.stderr.write(`parkade: ${found.outcome}: ${found.reason ?? ""}\n`);
  return 1;
}

/** @param {string} [text] @returns {[number, number]} */
function size(text = "720x420") {
  const match = /^(\d{1,5})x(\d{1,5})$/.exec(text);
  if (!match) throw new Refused(`--size ${text}: must be WIDTHxHEIGHT in pixels`);
  return [Number(match[1]), Number(match[2])];
}
