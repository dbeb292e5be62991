// @ts-check
// Results in columns: `parkade columns`, and rows of results whatever file they are in.
import { stat } from "node:fs/promises";
import { asyncBufferFromFile, parquetMetadataAsync, parquetReadObjects } from "hyparquet";
import { ParquetWriter, fileWriter } from "hyparquet-writer";
import { Refused, reason, unwritten } from "./refusal.js";
import { read } from "./results.js";

/** Version of the columns; a new column keeps it, another meaning does not. */
const VERSION = 1;
/** Key of the version in a file's metadata. */
const MARK = "parkade.results";
/** The same of audits. */
const BAYS_MARK = "parkade.audits";
/** Rows that are in memory at a time. */
const GROUP = 50_000;

/** @typedef {import("./results.js").Result} Result */
/** @typedef {Record<string, any>} Row */

/**
 * Name, type and value.
 * @typedef {[name: string, type: "STRING" | "INT64" | "DOUBLE" | "BOOLEAN", of: (result: any) => unknown]} Column
 */

/** Of plans. @type {Column[]} */
const COLUMNS = [
  ["key", "STRING", ({ key }) => key],
  ["scene", "STRING", ({ scene }) => scene],
  ["scene_hash", "STRING", ({ sceneHash }) => sceneHash],
  ["seed", "INT64", () => null],
  ["planner", "STRING", ({ planner }) => planner],
  ["settings", "STRING", ({ settings }) => JSON.stringify(Object.fromEntries(Object.entries(settings ?? {}).sort()))],
  ["version", "STRING", ({ version }) => version ?? ""],
  ["outcome", "STRING", ({ outcome }) => outcome],
  ["detail", "STRING", ({ detail }) => detail],
  ["verdict", "STRING", ({ verdict }) => verdict],
  ["drivable", "BOOLEAN", ({ drivable }) => drivable],
  ["length", "DOUBLE", ({ metrics }) => metrics?.length],
  ["direction_changes", "INT64", ({ metrics }) => metrics?.directionChanges],
  ["max_curvature", "DOUBLE", ({ metrics }) => metrics?.maxCurvature],
  ["min_clearance", "DOUBLE", ({ metrics }) => metrics?.minClearance],
  ["mean_clearance", "DOUBLE", ({ metrics }) => metrics?.meanClearance],
  ["cost", "DOUBLE", ({ metrics }) => metrics?.cost],
  ["expanded", "INT64", ({ stats }) => stats?.expanded],
  ["generated", "INT64", ({ stats }) => stats?.generated],
  ["open_peak", "INT64", ({ stats }) => stats?.openPeak],
  ["collision_checks", "INT64", ({ stats }) => stats?.collisionChecks],
  ["memory_bytes", "INT64", ({ stats }) => stats?.memoryBytes],
  ["seconds", "DOUBLE", ({ seconds }) => seconds],
  ["hash", "STRING", ({ hash }) => hash],
  ["error_code", "STRING", ({ error }) => error?.code],
  ["error_path", "STRING", ({ error }) => error?.path],
  ["error_message", "STRING", ({ error }) => error?.message],
];

/** Where results have paths. @type {Column} */
const PATH = ["path", "STRING", ({ path }) => path && JSON.stringify(path)];

/** Of the ways of an audit, a row for each bay, vehicle, entrance and entry. @type {Column[]} */
const BAYS = [
  ...COLUMNS.filter(([name]) => ["key", "scene", "scene_hash", "planner", "settings", "version"].includes(name)),
  ["bay", "STRING", ({ bay }) => bay],
  ["vehicle", "STRING", ({ vehicle }) => vehicle],
  ["entrance", "STRING", ({ entrance }) => entrance],
  ["entry", "STRING", ({ entry }) => entry],
  ["overhang", "DOUBLE", ({ overhang }) => overhang],
  ...ways("", (row) => row),
  ...ways("out_", (row) => row.out),
  ...COLUMNS.filter(([name]) => name.startsWith("error_")),
];

/**
 * Columns of a way in or out.
 * @param {string} prefix
 * @param {(row: Row) => Row | null | undefined} way
 * @returns {Column[]}
 */
function ways(prefix, way) {
  return [
    [`${prefix}reachable`, "BOOLEAN", (row) => way(row)?.["reachable"]],
    [`${prefix}outcome`, "STRING", (row) => way(row)?.["outcome"]],
    [`${prefix}detail`, "STRING", (row) => way(row)?.["detail"]],
    [`${prefix}reason`, "STRING", (row) => way(row)?.["reason"]],
    [`${prefix}blocker`, "STRING", (row) => way(row)?.["blocker"]],
    [`${prefix}moves`, "INT64", (row) => way(row)?.["moves"]],
    [`${prefix}length`, "DOUBLE", (row) => way(row)?.["length"]],
    [`${prefix}drive_time`, "DOUBLE", (row) => way(row)?.["driveTime"]],
    [`${prefix}clearance`, "DOUBLE", (row) => way(row)?.["clearance"]],
    [`${prefix}hash`, "STRING", (row) => way(row)?.["hash"]],
  ];
}

/** Columns that every row has. */
const NEEDED = ["key", "scene", "planner", "settings", "version"];

/** @param {Result} result @returns {Row} */
const rowOf = (result) => valuesOf(result.path === undefined ? COLUMNS : [...COLUMNS, PATH], result);

/**
 * A row for each bay; one that tells its error for a scene that was refused.
 * @param {Result} result
 * @returns {Row[]}
 */
function baysOf(result) {
  const rows = /** @type {Row[]} */ (result["rows"] ?? [{}]);
  return rows.map((row) => valuesOf(BAYS, { ...result, ...row }));
}

/** @param {Column[]} columns @param {object} result @returns {Row} */
const valuesOf = (columns, result) => Object.fromEntries(columns.map(([name, , of]) => [name, of(result) ?? null]));

/**
 * What `of` makes of the newest result of each key in files of lines.
 * @template T
 * @param {string[]} files
 * @param {(result: Result) => T} of
 */
async function newest(files, of) {
  /** @type {Map<string, T>} */
  const rows = new Map();
  for (const file of files)
    for await (const result of read(file)) {
      if (result.superseded) rows.delete(result.key);
      else rows.set(result.key, of(result));
    }
  return rows;
}

/** The rows of files of lines or columns. @param {string[]} files @returns {Promise<Row[]>} */
export async function rowsOf(files) {
  await present(files);
  const inColumns = files.filter((file) => file.endsWith(".parquet"));
  const rows = await newest(
    files.filter((file) => !file.endsWith(".parquet")),
    rowOf,
  );
  for (const file of inColumns) for (const row of await columnsOf(file)) rows.set(row["key"], row);
  return [...rows.values()];
}

/** @param {string[]} files */
async function present(files) {
  if (files.length === 0) throw new Refused("which files? Results of `parkade batch` (.jsonl) or columns (.parquet)");
  for (const file of files)
    await stat(file).catch((error) => {
      throw new Refused(`${file}: ${reason(error)}`);
    });
}

/** @param {string} file @returns {Promise<Row[]>} */
async function columnsOf(file) {
  const buffer = await asyncBufferFromFile(file);
  const metadata = await parquetMetadataAsync(buffer).catch(() => {
    throw new Refused(`${file}: is no Parquet file`);
  });
  const version = metadata.key_value_metadata?.find(({ key }) => key === MARK)?.value;
  if (version === undefined || Number(version) > VERSION)
    throw new Refused(
      `${file}: must be results of version ${VERSION}, got ${version ? `version ${version}` : "others"}`,
    );
  const rows = await parquetReadObjects({ file: buffer, metadata }).catch((error) => {
    throw new Refused(`${file}: cannot be read: ${reason(error)}`);
  });
  for (const row of rows)
    for (const [name, type] of COLUMNS) if (type === "INT64" && row[name] !== null) row[name] = Number(row[name]);
  return rows;
}

/** @type {import("./commands.js").Run} */
export async function columns(files, values) {
  if (files.some((file) => file.endsWith(".parquet")))
    throw new Refused(`${files.find((file) => file.endsWith(".parquet"))}: is in columns already; which .jsonl files?`);
  await present(files);
  const results = await newest(files, (result) => (result.planner === "audit" ? baysOf(result) : rowOf(result)));
  const plans = [...results.values()].filter((result) => !Array.isArray(result));
  const isAudit = results.size > 0 && plans.length === 0;
  if (!isAudit && plans.length < results.size)
    throw new Refused("audits and plans have different columns; which of them? Give the files of one");
  const rows = isAudit ? [...results.values()].flat() : plans;
  const out = values.out ?? "results.parquet";
  try {
    const plain = rows.some((row) => "path" in row) ? [...COLUMNS, PATH] : COLUMNS;
    written(rows, isAudit ? BAYS : plain, isAudit ? BAYS_MARK : MARK, out);
  } catch (error) {
    throw unwritten(out, error);
  }
  process.stdout.write(`${out}: ${results.size} results${isAudit ? `, ${rows.length} rows` : ""}\n`);
  return 0;
}

/** @param {Row[]} rows @param {Column[]} columns @param {string} mark @param {string} out */
function written(rows, columns, mark, out) {
  const schema = /** @type {import("hyparquet").SchemaElement[]} */ ([
    { name: "root", num_children: columns.length },
    ...columns.map(([name, type]) => ({
      name,
      repetition_type: NEEDED.includes(name) ? "REQUIRED" : "OPTIONAL",
      ...(type === "STRING" ? { type: "BYTE_ARRAY", converted_type: "UTF8" } : { type }),
    })),
  ]);
  const writer = new ParquetWriter({
    writer: fileWriter(out),
    schema,
    kvMetadata: [{ key: mark, value: String(VERSION) }],
  });
  for (let at = 0; at < rows.length; at += GROUP) {
    const group = rows.slice(at, at + GROUP);
    const columnData = columns.map(([name, type]) => ({
      name,
      data: group.map((row) => (type === "INT64" && row[name] !== null ? BigInt(row[name]) : (row[name] ?? null))),
    }));
    writer.write({ columnData, rowGroupSize: GROUP });
  }
  writer.finish();
}
