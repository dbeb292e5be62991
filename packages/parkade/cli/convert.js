// @ts-check
// `parkade scenario`, `parkade generate` and `parkade convert`: scenes as JSON.
import { generateScenario, importScene, sceneGeometry, scenario as builtIn, scenarios } from "../node.js";
import { choice, json, numeric, numerics, onlyOptions, text, withCompanions } from "./input.js";
import { toJSON, write } from "./output.js";
import { Refused, byOption, meant } from "./refusal.js";
import { isSitePlan, sitePlan } from "./site-plan.js";

/** @type {import("./commands.js").Run} */
export async function scenario([id, ...more], values) {
  const known = scenarios().map((one) => one.id);
  if (id === undefined) throw new Refused("which scene? `parkade scenarios` lists their ids");
  if (more.length > 0) throw new Refused(`one scene at a time, got also ${more.join(", ")}`);
  if (!known.includes(id))
    throw new Refused(`${id}: there is no such built-in scene${meant(id, known) || "; `parkade scenarios` lists all"}`);
  await write(toJSON(builtIn(id), 2), values.out);
  return 0;
}

/** Options that are numbers, and their names in the API. */
const NUMBERS = {
  size: "size",
  seed: "seed",
  density: "densityPermille",
  "block-min": "blockMin",
  "block-max": "blockMax",
};

/** @type {import("./commands.js").Run} */
export async function generate(places, values) {
  onlyOptions("generate", places);
  const family = choice("family", values.family, ["random", "regular", "trap"]);
  const asked = /** @type {any} */ ({ family, size: 60, seed: 1, ...numerics(NUMBERS, values) });
  await write(
    toJSON(
      byOption(NUMBERS, () => generateScenario(asked)),
      2,
    ),
    values.out,
  );
  return 0;
}

/** @type {import("./commands.js").Run} */
export async function convert(places, values) {
  if (places.length === 0)
    throw new Refused(
      "which files? MovingAI .map, ROS .yaml, TPCAP .csv, plans as .dxf, .svg, .geojson or .osm, lots or scenes as " +
        ".json",
    );
  const options = {
    ...(values.resolution !== undefined && { resolution: numeric("resolution", values.resolution) }),
    ...(values.query !== undefined && { query: numeric("query", values.query) }),
    ...(values.unknown !== undefined && { unknown: choice("unknown", values.unknown, ["blocked", "free"]) }),
  };
  const plans = {
    role: values.role,
    ...(values.unit !== undefined && { unit: numeric("unit", values.unit) }),
  };
  const scenes = [];
  for (const place of places) {
    const found =
      place === "-"
        ? [json("standard input", await text("-"))]
        : isSitePlan(place)
          ? [await sitePlan(place, plans)]
          : importScene(await withCompanions(place), options).scenes;
    for (const scene of found) {
      try {
        sceneGeometry(scene);
      } catch (error) {
        throw new Refused(`${place}: ${error instanceof Error ? error.message : error}`);
      }
    }
    scenes.push(...found);
  }
  const lines = choice("format", values.format, ["json", "jsonl"]) === "jsonl";
  if (!lines && scenes.length > 1)
    throw new Refused(`${scenes.length} scenes: JSON holds one; --format jsonl writes each on a line of its own`);
  await write(lines ? scenes.map((scene) => toJSON(scene)).join("") : toJSON(scenes[0], 2), values.out);
  return 0;
}
