// How tight it can be, as figures and as a table: what `cargo xtask bench tight` writes into the documentation.
// @ts-check
import { heatMap } from "./heat_map.mjs";

/**
 * Of the scenes of a cell: how many are solved, how many end with neither path nor proof, and the median of gear
 * changes.
 * @typedef {[solved: number, undecided: number, changes: number | null]} Cell
 * @typedef {{ family: string, vehicle: string, length: number, width: number, x: number[], y: number[],
 *   cells: Cell[][] }} TightMap
 * @typedef {{ kind: string, vehicle: string, scenes: number, solved: number, undecided: number, changes: number | null,
 *   margin: number | null }} TightKind
 * @typedef {{ count: number, maps: TightMap[], kinds: TightKind[] }} Tight
 */

/** @type {Record<string, { title: string, x: string, y: string }>} */
const FAMILIES = {
  kerb: { title: "Kerb slots", x: "Slot length minus car length, m", y: "Street width, m" },
  bay: { title: "Perpendicular slots", x: "Slot width minus car width, m", y: "Aisle width, m" },
  corner: {
    title: "Right-angle corners",
    x: "Width of the lane before the corner, m",
    y: "Width of the lane after it, m",
  },
};
/** @type {Record<string, string>} */
const VEHICLES = { sedan: "sedan", paper: "the parking paper’s car" };

/** Where the colours change: shares solved, and gear changes. */
const SHARES = [0.001, 0.25, 0.5, 0.75, 1],
  CHANGES = [2, 4, 7, 11, 21];

const step = (/** @type {number[]} */ bounds, /** @type {number} */ value) =>
  bounds.filter((bound) => value >= bound).length;
const of = (/** @type {TightMap} */ { family, vehicle }) =>
  /** @type {const} */ ([FAMILIES[family], VEHICLES[vehicle]]);

export const fileOf = (/** @type {TightMap} */ { family, vehicle }) => `tight-${family}-${vehicle}.svg`;

/** @param {TightMap} map @param {number} count */
export function figureOf(map, count) {
  const [family, vehicle] = of(map);
  const percent = (/** @type {number} */ solved) => Math.round((solved / count) * 100);
  return heatMap({
    title: `${family?.title}, ${vehicle} (${map.length.toFixed(1)} m × ${map.width.toFixed(1)} m)`,
    along: { title: family?.x ?? "", sizes: map.x },
    up: { title: family?.y ?? "", sizes: map.y },
    panels: [
      {
        title: `Solved, % of ${count} scenes`,
        scale: "good",
        cells: map.cells.map((row) =>
          row.map(([solved, undecided]) => ({
            text: String(percent(solved)),
            step: step(SHARES, solved / count),
            isMarked: undecided > 0,
          })),
        ),
      },
      {
        title: "Gear changes, median of the solved",
        scale: "bad",
        cells: map.cells.map((row) =>
          row.map(([, , changes]) =>
            changes === null ? null : { text: String(changes), step: step(CHANGES, changes) },
          ),
        ),
      },
    ],
    note: "at least one scene has neither a path nor a proof that there is none",
  });
}

/**
 * The least size from which on all scenes are solved: along the row of this size, or where both sizes are equal.
 * @param {TightMap} map @param {number} count @param {number | null} up
 */
export function leastSolved({ x, y, cells }, count, up) {
  const row = y.indexOf(up ?? NaN);
  const open = x.findLastIndex((_, i) => cells[up === null ? i : row]?.[i]?.[0] !== count);
  return x[open + 1] ?? null;
}

/** What is typical, and how the size from which on all is solved is said. */
const TYPICAL = [
  { family: "kerb", up: 5, what: "kerb slot on a street of 5 m: longer than the car by" },
  { family: "bay", up: 6, what: "perpendicular slot on an aisle of 6 m: wider than the car by" },
  { family: "corner", up: null, what: "right-angle corner between two equal lanes: each wide" },
];

/** @param {TightMap} map @param {number} count @param {number | null} up */
function leastInWords(map, count, up) {
  const least = leastSolved(map, count, up);
  if (least === null) return `more than ${map.x.at(-1)?.toFixed(1)} m`;
  return `${least.toFixed(1)} m${least === map.x[0] ? " or less" : ""}`;
}

/** From which sizes on every scene is solved. @param {Tight} tight */
export const shortTable = ({ count, maps }) =>
  table([
    ["all scenes are solved from", ...Object.keys(VEHICLES)],
    ...TYPICAL.map(({ family, up, what }) => [
      what,
      ...maps.filter((map) => map.family === family).map((map) => leastInWords(map, count, up)),
    ]),
  ]);

const sum = (/** @type {number[]} */ values) => values.reduce((total, value) => total + value, 0);

/** @param {(string | number)[][]} rows */
const table = (rows) =>
  rows.map((row, i) => `| ${row.join(" | ")} |${i === 0 ? `\n|${" --- |".repeat(row.length)}` : ""}`).join("\n");

/** Solved, proven impossible and neither, of so many scenes. */
const outcomes = (/** @type {number} */ scenes, /** @type {number} */ solved, /** @type {number} */ undecided) => [
  scenes,
  solved,
  scenes - solved - undecided,
  undecided,
];

const OUTCOMES = ["scenes", "solved", "no way, proven", "neither"];

/**
 * Outcomes over all cells of each map, with what `time` says of it.
 * @param {Tight} tight
 * @param {(map: TightMap) => string} time
 */
export const mapTable = ({ count, maps }, time) =>
  table([
    ["", "car", ...OUTCOMES, "median time"],
    ...maps.map((map) => {
      const cells = map.cells.flat(),
        [family] = of(map);
      const total = (/** @type {0 | 1} */ at) => sum(cells.map((cell) => cell[at]));
      return [family?.title ?? "", map.vehicle, ...outcomes(cells.length * count, total(0), total(1)), time(map)];
    }),
  ]);

/** @param {Tight} tight */
export const kindTable = ({ kinds }) =>
  table([
    ["", "car", ...OUTCOMES, "gear changes", "margin, cm"],
    ...kinds.map(({ kind, vehicle, scenes, solved, undecided, changes, margin }) => [
      kind,
      vehicle,
      ...outcomes(scenes, solved, undecided),
      changes ?? "–",
      margin === null ? "–" : (margin * 100).toFixed(1),
    ]),
  ]);

/** 10 ms, 100 ms, 1 s. @param {number} milliseconds */
export function magnitude(milliseconds) {
  const power = 10 ** Math.max(0, Math.round(Math.log10(milliseconds)));
  return power < 1000 ? `about ${power} ms` : `about ${power / 1000} s`;
}

/**
 * The text with what stands between the marks of a block replaced.
 * @param {string} text
 * @param {string} name
 * @param {string} block
 */
export function withBlock(text, name, block) {
  const [head, tail] = [`<!-- ${name} -->\n`, `\n<!-- /${name} -->`];
  const from = text.indexOf(head),
    to = text.indexOf(tail);
  if (from < 0 || to < from) throw new Error(`the page has no block ${name}`);
  return text.slice(0, from + head.length) + block + text.slice(to);
}
