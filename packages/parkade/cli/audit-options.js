// @ts-check
// The options of audits, for `parkade audit` and `parkade batch --task audit`.
import { vehicles } from "../node.js";
import { choice, settings } from "./input.js";
import { Refused, meant } from "./refusal.js";

/** @type {import("node:util").ParseArgsConfig["options"]} */
export const AUDIT_OPTIONS = {
  vehicle: { type: "string" },
  entry: { type: "string" },
  "what-if": { type: "string" },
  entrance: { type: "string", multiple: true },
};

export const AUDIT_ABOUT =
  `  --vehicle ID,ID…     vehicles of the library, or paper, sedan, ship; default: the ` +
  `scene's. \`parkade vehicles\` lists them
  --entry both|head-in|reverse-in  default: both
  --what-if each-free|as-is  ask each occupied bay as if it were free (default), or leave it out
  --entrance ID=X,Y,HEADING[/X,Y,HEADING]  where vehicles come in and, after the slash, leave; metres, radians; may ` +
  `be repeated;
                       default: the scene's start
  --set NAME=VALUE     a setting of hybrid; may be repeated`;

/** @param {Record<string, any>} values @returns {import("../index.js").AuditOptions} */
export function auditOptions(values) {
  const entry = choice("entry", values["entry"], ["both", "head-in", "reverse-in"]);
  const known = ["paper", "sedan", "ship", ...vehicles().map(({ id }) => id)];
  const ids = values["vehicle"]?.split(",").map((/** @type {string} */ word) => word.trim());
  for (const id of ids ?? [])
    if (!known.includes(id))
      throw new Refused(
        `--vehicle ${id}: there is no such vehicle${meant(id, known) || `; there are ${known.join(", ")}`}`,
      );
  const entrances = values["entrance"]?.map(entrance);
  const config = settings(values["set"], ["hybrid"]);
  return {
    ...(ids && { vehicles: ids }),
    entries: entry === "both" ? ["head-in", "reverse-in"] : [entry],
    whatIf: choice("what-if", values["what-if"], ["each-free", "as-is"]),
    ...(entrances && { entrances }),
    ...(Object.keys(config).length > 0 && { settings: config }),
  };
}

/** @param {string} given @returns {import("../index.js").Entrance} */
function entrance(given) {
  const [, id = "", poses = ""] = /^([^=]+)=(.+)$/.exec(given) ?? [];
  const [pose, exit, ...more] = poses.split("/").map((text) => {
    const [x = Number.NaN, y = Number.NaN, heading = Number.NaN, ...rest] = text.split(",").map(Number);
    return [x, y, heading].every(Number.isFinite) && rest.length === 0 ? { x, y, heading } : undefined;
  });
  if (!pose || (poses.includes("/") && !exit) || more.length > 0)
    throw new Refused(`--entrance ${given}: must be ID=X,Y,HEADING or ID=X,Y,HEADING/X,Y,HEADING`);
  return { id, pose, ...(exit && { exit }) };
}
