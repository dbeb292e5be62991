// @ts-check
// `parkade planners` and `parkade scenarios`.
import { planners as allPlanners, scenarios as allScenarios } from "../node.js";
import { choice, onlyOptions, plannerIds } from "./input.js";
import { toJSON, write } from "./output.js";

/** @type {import("./commands.js").Run} */
export async function planners(places, values) {
  onlyOptions("planners", places);
  const asJSON = choice("format", values.format, ["text", "json"]) === "json";
  const one = values.planner === undefined ? undefined : plannerIds(values.planner, "")[0];
  const infos = allPlanners().filter(({ id }) => one === undefined || id === one);
  if (asJSON) await write(toJSON(infos, 2));
  else if (one === undefined) await write(infos.map(({ id, title }) => `${id.padEnd(24)}${title.en}\n`).join(""));
  else
    await write(
      (infos[0]?.parameters ?? [])
        .map((info) => `${info.name.padEnd(24)}${JSON.stringify(info.default)}${range(info)}  ${info.doc.en}\n`)
        .join(""),
    );
  return 0;
}

/** @param {import("../index.js").ParameterInfo} info */
function range({ unit, min, max, choices }) {
  const words = [
    unit !== "1" && unit,
    choices?.join("|"),
    (min !== undefined || max !== undefined) && `${min ?? ""}…${max ?? ""}`,
  ];
  const said = words.filter(Boolean).join(", ");
  return said ? ` (${said})` : "";
}

/** @type {import("./commands.js").Run} */
export async function scenarios(places, values) {
  onlyOptions("scenarios", places);
  const infos = allScenarios();
  await write(
    choice("format", values.format, ["text", "json"]) === "json"
      ? toJSON(infos, 2)
      : infos.map(({ id, title }) => `${id.padEnd(24)}${title.en}\n`).join(""),
  );
  return 0;
}
