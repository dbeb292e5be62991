// @ts-check
// `parkade audit`, `parkade vehicles` and `parkade lot`.
import { availableParallelism } from "node:os";
import { extname } from "node:path";
import { auditInParts, generateLot, lotPresets, sceneGeometry, toSVG, vehicles as library } from "../node.js";
import { auditOptions } from "./audit-options.js";
import { choice, count, numerics, onlyOptions, scene as read } from "./input.js";
import { table, toJSON, write } from "./output.js";
import { Refused, byOption } from "./refusal.js";
import { startThreads } from "./threads.js";

/** @typedef {import("../index.js").AuditRow} AuditRow */

/** @type {import("./commands.js").Run} */
export async function audit(places, values, module) {
  const format = choice("format", values.format, ["markdown", "csv", "json"]);
  const jobs = count("jobs", values.jobs, availableParallelism(), 1024);
  const options = auditOptions(values),
    scene = await read(places);
  sceneGeometry(scene);
  if (!scene.slots?.length) throw new Refused("has no slots: there is no bay to ask");
  const rows = await inThreads(scene, options, jobs, module, values.quiet !== true);
  if (values.csv !== undefined) await write(csv(rows), values.csv);
  if (values.svg !== undefined)
    for (const id of new Set(rows.map(({ vehicle }) => vehicle)))
      await write(
        picture(
          scene,
          rows.filter(({ vehicle }) => vehicle === id),
        ),
        named(values.svg, id, rows),
      );
  const text = format === "json" ? toJSON(rows, 2) : format === "csv" ? csv(rows) : summary(rows);
  await write(text, values.out);
  return rows.every(({ reachable }) => reachable) ? 0 : 1;
}

/**
 * @param {import("../index.js").Scenario} scene
 * @param {import("../index.js").AuditOptions} options
 * @param {number} jobs
 * @param {WebAssembly.Module} module
 * @param {boolean} tells
 */
async function inThreads(scene, options, jobs, module, tells) {
  const pool = startThreads("./audit-worker.js", jobs, module);
  const isLive = tells && process.stderr.isTTY === true;
  try {
    return await auditInParts(scene, options, (scene, options) => pool.run({ scene, options }), {
      workers: jobs,
      onProgress: ({ done, total }) => {
        if (isLive) process.stderr.write(`\r${done} of ${total} bays\x1b[K${done === total ? "\n" : ""}`);
      },
    });
  } finally {
    await pool.destroy();
  }
}

const COLUMNS = /** @type {const} */ ([
  "reachable",
  "moves",
  "length",
  "driveTime",
  "clearance",
  "outcome",
  "detail",
  "reason",
  "x",
  "y",
  "blocker",
  "hash",
]);

/** @param {import("../index.js").AuditWay | null} way */
function cells(way) {
  const [x, y] = way?.place ?? [];
  return COLUMNS.map((name) => quoted(name === "x" ? x : name === "y" ? y : way?.[name]));
}

/** A cell of CSV. @param {unknown} value */
function quoted(value) {
  const text = typeof value === "number" ? String(Number(value.toFixed(3))) : String(value ?? "");
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** @param {readonly AuditRow[]} rows */
export function csv(rows) {
  const head = ["bay", "vehicle", "entrance", "entry", "overhang", ...COLUMNS, ...COLUMNS.map((name) => `out_${name}`)];
  const lines = rows.map((row) => [
    ...[row.bay, row.vehicle, row.entrance, row.entry, row.overhang].map(quoted),
    ...cells(row),
    ...cells(row.out),
  ]);
  return table(head, lines, "csv");
}

/** @template T @param {readonly AuditRow[]} rows @param {(row: AuditRow) => T} key @returns {Map<T, AuditRow[]>} */
function groups(rows, key) {
  const all = new Map();
  for (const row of rows) all.set(key(row), [...(all.get(key(row)) ?? []), row]);
  return all;
}

/** One line a vehicle and entry, and the bays that are out of reach. @param {readonly AuditRow[]} rows */
function summary(rows) {
  const all = groups(rows, ({ vehicle, entrance, entry }) => [vehicle, entrance, entry].join("\n"));
  const lines = [...all].map(([key, some]) => {
    const of = (/** @type {(row: AuditRow) => boolean} */ is) => some.filter(is).length;
    return [
      ...key.split("\n"),
      some.length,
      of(({ reachable }) => reachable),
      ...[1, 2, 3].map((moves) => of((row) => row.moves === moves)),
      of(({ moves }) => moves > 3),
      of(({ out }) => out?.reachable === false),
      of(({ outcome, out }) => outcome === "budget-spent" || out?.outcome === "budget-spent"),
    ];
  });
  const head = [
    "vehicle",
    "entrance",
    "entry",
    "bays",
    "reachable",
    "1 move",
    "2",
    "3",
    "> 3",
    "no way out",
    "not decided",
  ];
  const failed = rows.filter(({ reachable }) => !reachable);
  const words = failed.map(
    ({ bay, vehicle, entry, reason, blocker }) =>
      `${bay} (${vehicle}, ${entry}): ${reason ?? ""}${blocker ? ` In the way: ${blocker}.` : ""}\n`,
  );
  return [table(head, lines, "markdown"), ...(words.length > 0 ? ["\n"] : []), ...words].join("");
}

/**
 * With several vehicles, each has a picture of its own.
 * @param {string} file
 * @param {string} id
 * @param {readonly AuditRow[]} rows
 */
function named(file, id, rows) {
  if (rows.every(({ vehicle }) => vehicle === id)) return file;
  const extension = extname(file);
  return `${file.slice(0, file.length - extension.length)}-${id}${extension}`;
}

/** Fills by moves, light to dark, told apart without colours by the number written in them. */
const FILLS = ["#cfe3f1", "#8fbbdd", "#4a90c4", "#1f5e93"];
const HATCH =
  `<pattern id="out-of-reach" width="8" height="8" patternUnits="userSpaceOnUse" ` +
  `patternTransform="rotate(45)"><rect width="8" height="8" fill="#fbe9e7"/><rect width="2" height="8" ` +
  `fill="#c0392b"/></pattern>`;
const WIDTH = 1200,
  RIM = 24;

/**
 * The scene with each bay filled by the fewest moves.
 * @param {import("../index.js").Scenario} scene
 * @param {readonly AuditRow[]} rows
 */
function picture(scene, rows) {
  const { boundary, slots } = sceneGeometry(scene);
  const [xs, ys] = [boundary.map(([x]) => x), boundary.map(([, y]) => y)];
  const [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = (WIDTH - 2 * RIM) / Math.max(right - left, (top - bottom) / 4);
  const height = Math.min(8192, Math.max(64, Math.round((top - bottom) * scale + 2 * RIM)));
  const camera = { x: (left + right) / 2, y: (bottom + top) / 2, scale };
  const at = (/** @type {readonly [number, number]} */ [x, y]) =>
    `${((x - camera.x) * scale + WIDTH / 2).toFixed(1)},${((camera.y - y) * scale + height / 2).toFixed(1)}`;
  const bays = [...groups(rows, ({ index }) => index)].map(([index, some]) => {
    const moves = Math.min(...some.filter(({ reachable }) => reachable).map((row) => row.moves)),
      outline = slots[index] ?? [],
      isReached = Number.isFinite(moves);
    const middle = /** @type {[number, number]} */ (
      [0, 1].map((k) => outline.reduce((sum, p) => sum + (p[k] ?? 0), 0) / 4)
    );
    const [x = 0, y = 0] = at(middle).split(",").map(Number);
    const fill = isReached ? FILLS[Math.min(moves, FILLS.length) - 1] : "url(#out-of-reach)";
    const word = (/** @type {string | number} */ text, /** @type {string} */ ink) =>
      `<text x="${x}" y="${y + 4}" fill="${ink}">${text}</text>`;
    const mark = isReached
      ? word(moves, moves > 3 ? "#fff" : "#16202a")
      : `<circle cx="${x}" cy="${y}" r="9" fill="#fff"/>${word("✕", "#b3261e")}`;
    return `<polygon points="${outline.map(at).join(" ")}" fill="${fill}" fill-opacity="0.85" stroke="#fff"/>${mark}`;
  });
  const svg = toSVG(scene, [], { width: WIDTH, height, theme: "light", camera });
  const layer =
    `<g font-family="sans-serif" font-size="12" font-weight="600" ` +
    `text-anchor="middle"><defs>${HATCH}</defs>${bays.join("")}</g>`;
  return svg.replace(/<\/svg>\s*$/, `${layer}</svg>\n`);
}

/** @type {import("./commands.js").Run} */
export async function vehicles(places, values) {
  onlyOptions("vehicles", places);
  const all = library();
  if (choice("format", values.format, ["text", "json"]) === "json") return write(toJSON(all, 2)).then(() => 0);
  const head = ["id", "title", "length", "width", "wheelbase", "kerb circle", "wall circle", "source"];
  const circle = (/** @type {number | null} */ radius) => (radius === null ? "" : (2 * radius).toFixed(2));
  const lines = all.map((one) => [
    one.id,
    one.title.en,
    (one.wheelbase + one.frontOverhang + one.rearOverhang).toFixed(2),
    one.width.toFixed(2),
    one.wheelbase.toFixed(2),
    circle(one.kerbRadius),
    circle(one.wallRadius),
    one.source,
  ]);
  await write(table(head, lines, "markdown"));
  return 0;
}

/** Options of `parkade lot` that are numbers, and their names in the API. */
const NUMBERS = {
  seed: "seed",
  rows: "rows",
  bays: "bays",
  angle: "angle",
  "bay-width": "bayWidth",
  "bay-length": "bayLength",
  aisle: "aisle",
  columns: "columns",
  occupancy: "occupancy",
  entrances: "entrances",
  ramp: "ramp",
};

/** @type {import("./commands.js").Run} */
export async function lot(places, values) {
  onlyOptions("lot", places);
  if (values.list === true) {
    const lines = lotPresets().map(({ id, title, bays }) => [id, title.en, bays]);
    await write(table(["id", "title", "bays"], lines, "markdown"));
    return 0;
  }
  const { preset } = values,
    options = { ...(preset !== undefined && { preset }), ...numerics(NUMBERS, values) };
  const { scene } = byOption({ preset: "preset", ...NUMBERS }, () => generateLot(options));
  await write(toJSON(scene), values.out);
  return 0;
}
