// @ts-check
// `parkade plan`.
import { Planner, planners, optimise, toCSV, toSVG, toTrajectoryCSV } from "../node.js";
import { Refused, choice, plannerIds, scene as read, settings } from "./input.js";
import { toJSON, write } from "./output.js";

/** @typedef {import("../index.js").Layer} Layer */

/** @type {import("./main.js").Run} */
export async function plan(places, values) {
  const format = choice("format", values.format, ["json", "csv", "svg", "trajectory"]);
  const theme = choice("theme", values.theme, ["auto", "light", "dark"]);
  const [width, height] = size(values.size);
  const element = values.layout !== undefined || values.controls !== undefined;
  const place = element
    ? {
        layout: choice("layout", values.layout, ["single", "overlay"]),
        controls: choice("controls", values.controls, ["none", "minimal"]),
      }
    : {};
  const scene = await read(places);
  const prefer =
    values.prefer === undefined
      ? undefined
      : choice("prefer", values.prefer, ["shortest", "fewest-changes", "widest", "fastest"]);
  const choices = { ...(prefer ? { prefer } : {}), ...(values.alternatives ? { alternatives: true } : {}) };
  const ids = plannerIds(values.planner, "hybrid");
  const config = settings(values.set, ids);
  if (ids.length > 1 && format !== "svg") throw new Refused("--planner: one planner at a time");
  /** @type {Partial<Record<import("../index.js").LayerName, Layer>>} */
  let layers = {};
  const plans = ids.map((planner) => {
    const prepared = new Planner(planner, scene, config);
    const found = prepared.plan({ trace: values.trace ?? format === "svg", ...choices });
    if (format === "svg" && planners().find(({ id }) => id === planner)?.hasRiskField)
      layers = Object.fromEntries(
        /** @type {const} */ (["safety", "clearance", "risk"]).map((name) => [name, prepared.layer(name)]),
      );
    prepared.free();
    return found;
  });
  const [first] = plans;
  if (!first) throw new Refused("--planner: needs a planner");
  const text =
    format === "json"
      ? toJSON(first)
      : format === "csv"
        ? toCSV(scene, first)
        : format === "trajectory"
          ? trajectory(scene, first)
          : toSVG(scene, plans, { width, height, theme, layers, ...place });
  await write(text, values.out);
  for (const { planner, goal } of plans)
    if (goal && format !== "json")
      process.stderr.write(`parkade: ${plans.length > 1 ? `${planner}: ` : ""}goal: ${named(goal)}\n`);
  const failed = plans.filter((one) => one.outcome !== "found");
  for (const { planner, outcome, reason } of failed)
    process.stderr.write(`parkade: ${plans.length > 1 ? `${planner}: ` : ""}${outcome}: ${reason ?? ""}\n`);
  return failed.length > 0 ? 1 : 0;
}

/** The trajectory that `optimise` makes of a plan; only the header if there is no path. @param {import("../index.js").Scenario} scene @param {import("../index.js").Plan} found */
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
