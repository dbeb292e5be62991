// @ts-check
// Site plans (DXF, SVG, GeoJSON, OpenStreetMap) as scenes, by what the names of their layers suggest.
import { readFile } from "node:fs/promises";
import { basename } from "node:path";
import { readSitePlan, sceneFromSitePlan, suggestedRole, suggestedUnit } from "../siteplan.js";
import { Refused, meant, reason } from "./refusal.js";

const ROLES = /** @type {const} */ (["none", "wall", "kerb", "column", "building", "bay", "ground"]);

/** True if it is a site plan. @param {string} place */
export const isSitePlan = (place) => /\.(dxf|svg|geojson|osm)$/i.test(place);

/**
 * @param {string} place
 * @param {{ role?: string[] | undefined, unit?: number | undefined }} [options] `LAYER=ROLE`, and metres per unit of
 * the file
 * @returns {Promise<import("../index.js").Scenario>}
 */
export async function sitePlan(place, { role = [], unit } = {}) {
  const content = await readFile(place).catch((error) => {
    throw new Refused(`${place}: ${reason(error)}`);
  });
  try {
    const plan = readSitePlan(basename(place), content),
      names = plan.layers.map(({ name }) => name);
    const { scene, notes } = sceneFromSitePlan(plan, {
      roles: { ...Object.fromEntries(names.map((name) => [name, suggestedRole(name)])), ...rolesOf(role, names) },
      metresPerUnit: unit ?? suggestedUnit(plan),
      name: basename(place),
    });
    for (const note of notes) process.stderr.write(`parkade: ${place}: ${note}\n`);
    return scene;
  } catch (error) {
    if (/** @type {{ code?: string }} */ (error).code !== "bad-import") throw error;
    const { line, message } = /** @type {import("../siteplan.js").SitePlanError} */ (error);
    throw new Refused(`${place}${line === undefined ? "" : `:${line}`}: ${message}`);
  }
}

/** @param {string[]} pairs @param {readonly string[]} layers */
function rolesOf(pairs, layers) {
  return Object.fromEntries(
    pairs.map((pair) => {
      const at = pair.lastIndexOf("="),
        [layer, word] = [pair.slice(0, at), pair.slice(at + 1)];
      if (at < 1) throw new Refused(`--role ${pair}: must be LAYER=ROLE`);
      if (!layers.includes(layer))
        throw new Refused(
          `--role ${pair}: there is no such layer${meant(layer, layers) || `; there are ${layers.join(", ")}`}`,
        );
      const role = ROLES.find((one) => one === word);
      if (!role) throw new Refused(`--role ${pair}: must be one of ${ROLES.join(", ")}${meant(word, ROLES)}`);
      return [layer, role];
    }),
  );
}
