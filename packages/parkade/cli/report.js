// @ts-check
// `parkade report`: what results say of planners and settings, counted here and drawn in `report-page.js`.
import { writeFile } from "node:fs/promises";
import { rowsOf } from "./parquet.js";
import { Refused, unwritten } from "./refusal.js";
import { page } from "./report-page.js";

/** @typedef {import("./parquet.js").Row} Row */
/**
 * @typedef {{ name: string, rows: Row[], by: Map<string, Row> }} Contender planners with their settings, their rows,
 * and these by scene
 */
/** @typedef {{ id: string, title: string, unit: string, digits: number }} Figure */

/** Figures whose quantiles are told. @type {Figure[]} */
const FIGURES = [
  { id: "length", title: "Length", unit: "m", digits: 2 },
  { id: "direction_changes", title: "Gear changes", unit: "", digits: 0 },
  { id: "min_clearance", title: "Smallest clearance", unit: "m", digits: 3 },
  { id: "expanded", title: "Expanded nodes", unit: "", digits: 0 },
  { id: "memory_bytes", title: "Memory", unit: "bytes", digits: 0 },
  { id: "seconds", title: "Time", unit: "s", digits: 5 },
];
/** Figures by which planners are compared; less is better. */
const COMPARED = ["length", "expanded", "seconds"];
const PARTS = [0, 0.05, 0.25, 0.5, 0.75, 0.95, 1];
/** Values that differ by less than this share are equal. */
const TIE = 1e-9;
/** Factors of the profiles. */
const FACTORS = Array.from({ length: 41 }, (_, i) => 10 ** (i / 40));
/** More would be no page to read. */
const MOST = 24;

/** @type {import("./commands.js").Run} */
export async function report(files, values) {
  const rows = await rowsOf(files);
  if (rows.length === 0) throw new Refused(`${files.join(", ")}: no results`);
  const contenders = contendersOf(rows);
  if (contenders.length > MOST)
    throw new Refused(`must have at most ${MOST} planners with settings, got ${contenders.length}; name fewer files`);
  const out = values.out ?? "report.html";
  const html = page({
    files,
    outcomes: contenders.map(outcomes),
    quantiles: FIGURES.map((figure) => ({ figure, rows: contenders.map((one) => quantiles(one, figure.id)) })).filter(
      (table) => table.rows.some(({ count }) => count > 0),
    ),
    parts: PARTS,
    comparisons: COMPARED.flatMap((id) =>
      comparison(contenders, /** @type {Figure} */ (FIGURES.find((f) => f.id === id))),
    ),
  });
  await writeFile(out, html).catch((error) => {
    throw unwritten(out, error);
  });
  process.stdout.write(`${out}: ${rows.length} results of ${contenders.length} planners with settings\n`);
  return 0;
}

/** @param {Row[]} rows @returns {Contender[]} */
function contendersOf(rows) {
  /** @type {Map<string, Contender>} */
  const all = new Map();
  for (const row of rows) {
    const settings = Object.entries(JSON.parse(row["settings"])).map(
      ([name, value]) => `${name}=${JSON.stringify(value)}`,
    );
    const name = [row["planner"], ...settings].join(" ");
    /** @type {Contender} */
    const one = all.get(name) ?? { name, rows: [], by: new Map() };
    one.rows.push(row);
    one.by.set(row["scene_hash"] ?? row["scene"], row);
    all.set(name, one);
  }
  return [...all.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
}

/** @param {Contender} contender */
function outcomes({ name, rows }) {
  const count = (/** @type {(row: Row) => unknown} */ is) => rows.filter(is).length;
  return {
    name,
    scenes: rows.length,
    found: count(({ outcome }) => outcome === "found"),
    drivable: count(({ outcome, drivable }) => outcome === "found" && drivable),
    none: count(({ outcome }) => outcome !== null && outcome !== "found"),
    refused: count(({ error_code }) => error_code !== null),
  };
}

/** @param {Row | undefined} row @param {string} id of a found path's figure */
const valueOf = (row, id) => (row?.["outcome"] === "found" && Number.isFinite(row[id]) ? Number(row[id]) : undefined);

/** @param {Contender} contender @param {string} id */
function quantiles({ name, rows }, id) {
  const values = Float64Array.from(rows.flatMap((row) => valueOf(row, id) ?? [])).sort();
  const at = (/** @type {number} */ part) => {
    const place = (values.length - 1) * part,
      low = values[Math.floor(place)] ?? Number.NaN;
    return low + ((values[Math.ceil(place)] ?? low) - low) * (place - Math.floor(place));
  };
  return { name, count: values.length, values: values.length > 0 ? PARTS.map(at) : [] };
}

/**
 * On the scenes that all have: shares within factors of the best, and who wins. A path wins against none.
 * @param {Contender[]} contenders @param {Figure} figure
 */
function comparison(contenders, figure) {
  const [first, ...others] = contenders;
  const scenes = [...(first?.by.keys() ?? [])].filter((scene) => others.every(({ by }) => by.has(scene)));
  const table = scenes.map((scene) => contenders.map(({ by }) => valueOf(by.get(scene), figure.id)));
  if (others.length === 0 || !table.some((values) => values.some((value) => value !== undefined))) return [];
  const ratios = contenders.map((_, at) =>
    table.flatMap((values) => {
      const best = Math.min(...values.map((value) => value ?? Infinity)),
        own = values[at];
      return own === undefined ? [] : [best > 0 ? own / best : own > 0 ? Infinity : 1];
    }),
  );
  const profiles = contenders.map(({ name }, at) => ({
    name,
    shares: FACTORS.map(
      (factor) => (ratios[at] ?? []).filter((ratio) => ratio <= factor * (1 + TIE)).length / Math.max(1, scenes.length),
    ),
  }));
  const matrix = contenders.map((_, row) => contenders.map((_, column) => duel(table, row, column)));
  return [{ figure, scenes: scenes.length, factors: FACTORS, profiles, matrix }];
}

/** @param {(number | undefined)[][]} table @param {number} row @param {number} column */
function duel(table, row, column) {
  let wins = 0,
    ties = 0,
    losses = 0;
  for (const values of table) {
    const a = values[row] ?? Infinity,
      b = values[column] ?? Infinity;
    if (a === b || Math.abs(a - b) <= TIE * Math.max(Math.abs(a), Math.abs(b))) ties++;
    else if (a < b) wins++;
    else losses++;
  }
  return { wins, ties, losses };
}
