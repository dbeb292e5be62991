// @ts-check
// `parkade plan`.
import { Planner, planners, optimise, toCSV, toSVG, toTrajectoryCSV } from "../node.js";
import { choice, of, plannerIds, scenesAt, settings } from "./input.js";
import { toJSON, write } from "./output.js";
import { Refused } from "./refusal.js";

/** @typedef {import("../index.js").Layer} Layer */
/** @typedef {{ place: string, scene: import("../index.js").Scenario }} Asked */

/** @type {import("./commands.js").Run} */
export async function plan(places, values) {
  const format = choice("format", values.format, ["json", "csv", "svg", "trajectory"]);
  const theme = choice("theme", values.theme, ["auto", "light", "dark"]);
  const [width, height] = size(values.size);
  const element = values.layout !== undefined || values.controls !== undefined;
  const poster = element
    ? {
        layout: choice("layout", values.layout, ["single", "overlay"]),
        controls: choice("controls", values.controls, ["none", "minimal"]),
      }
    : {};
  const scenes = await scenesAt(places);
  const prefer =
    values.prefer === undefined
      ? undefined
      : choice("prefer", values.prefer, ["shortest", "fewest-changes", "widest", "fastest"]);
  const choices = { ...(prefer ? { prefer } : {}), ...(values.alternatives ? { alternatives: true } : {}) };
  const ids = plannerIds(values.planner, "hybrid");
  const config = settings(values.set, ids);
  const [{ scene }] = /** @type {[Asked]} */ (scenes);
  if (scenes.length > 1 && format !== "json")
    throw new Refused(`--format ${format}: holds one scene; json has a line for each`);
  if (ids.length > 1 && !["json", "svg"].includes(format))
    throw new Refused(`--planner: one planner at a time with --format ${format}`);
  /** @type {Partial<Record<import("../index.js").LayerName, Layer>>} */
  let layers = {};
  const plans = scenes.flatMap((asked) =>
    ids.map((planner) => {
      const prepared = of(asked.place, () => new Planner(planner, asked.scene, config));
      const found = prepared.plan({ trace: values.trace ?? format === "svg", ...choices });
      if (format === "svg" && planners().find(({ id }) => id === planner)?.hasRiskField)
        layers = Object.fromEntries(
          /** @type {const} */ (["safety", "clearance", "risk"]).map((name) => [name, prepared.layer(name)]),
        );
      prepared.free();
      return { place: asked.place, found };
    }),
  );
  const first = /** @type {import("../index.js").Plan} */ (plans[0]?.found);
  const text =
    format === "json"
      ? plans.map(({ place, found }) => toJSON(plans.length > 1 ? { scene: place, ...found } : found)).join("")
      : format === "csv"
        ? toCSV(scene, first)
        : format === "trajectory"
          ? trajectory(scene, first)
          : toSVG(
              scene,
              plans.map(({ found }) => found),
              { width, height, theme, layers, ...poster },
            );
  await write(text, values.out);
  const say = (
    /** @type {{ place: string, found: import("../index.js").Plan }} */ { place, found },
    /** @type {string} */ words,
  ) => {
    const about = [scenes.length > 1 && place, ids.length > 1 && found.planner].filter(Boolean).join(", ");
    process.stderr.write(`parkade: ${about}${about && ": "}${words}\n`);
  };
  if (format !== "json") for (const one of plans) if (one.found.goal) say(one, `goal: ${named(one.found.goal)}`);
  const failed = plans.filter(({ found }) => found.outcome !== "found");
  for (const one of failed) say(one, `${one.found.outcome}: ${one.found.reason ?? ""}`);
  return failed.length > 0 ? 1 : 0;
}

/**
 * The trajectory that `optimise` makes of a plan; only the header if there is no path.
 * @param {import("../index.js").Scenario} scene
 * @param {import("../index.js").Plan} found
 */
function trajectory(scene, found) {
  return found.outcome === "found" ? toTrajectoryCSV(optimise(scene, found)) : "t,x,y,theta,v,phi,a,omega\n";
}

/** @param {import("../index.js").TakenGoal} goal */
function named({ slot, entry, pose: { x, y, heading } }) {
  const place = `x ${x.toFixed(2)} m, y ${y.toFixed(2)} m, heading ${heading.toFixed(3)} rad`;
  return [slot, entry, place].filter(Boolean).join(", ");
}

/** @param {string} [text] @returns {[number, number]} */
function size(text = "720x420") {
  const match = /^(\d{1,5})x(\d{1,5})$/.exec(text);
  if (!match) throw new Refused(`--size ${text}: must be WIDTHxHEIGHT in pixels`);
  return [Number(match[1]), Number(match[2])];
}
