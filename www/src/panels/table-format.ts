/** The metrics table as text. */
import { millis, translate, type MessageKey } from "../i18n/index";
import type { State } from "../store";
import { COLUMNS, rowsOf, unitValues, type Cell, type Row } from "./metrics";

export type TableFormat = "markdown" | "csv" | "json";

export function formatTable(state: State, format: TableFormat): string {
  const rows = rowsOf(state);
  if (format === "json")
    return JSON.stringify(
      rows.map((row) => plain(row, state)),
      null,
      2,
    );
  const heads = ["table.planner", "table.status", ...COLUMNS.map((column) => `table.${column}`)].map((key) =>
    translate(state.lang, key as MessageKey),
  );
  const units = COLUMNS.map((column) => translate(state.lang, `unit.${column}`, unitValues(state)));
  const titles = [
    ...heads.map((head, i) => (i < 2 ? head : `${head} (${units[i - 2]})`)),
    translate(state.lang, "table.total"),
  ];
  const totals = rows.map((row) => totalOf(row, state));
  if (format === "csv") return csv(rows, titles, totals);
  const lines = rows.map((row, i) => [
    row.name,
    row.status.brief,
    ...COLUMNS.map((column) => markdownCell(row.cells[column])),
    totals[i] === null ? "–" : millis(state.lang, totals[i]!),
  ]);
  const rule = titles.map((_, i) => (i < 2 ? "---" : "---:"));
  return [titles.map((title) => title.replaceAll("|", "\\|")), rule, ...lines]
    .map((line) => `| ${line.join(" | ")} |`)
    .join("\n");
}

const markdownCell = ({ text, best }: Cell): string => (best ? `★ **${text}**` : text);

/** Milliseconds of search, check and measurement. */
const totalOf = (row: Row, state: State): number | null => state.results[row.planner]?.time?.total ?? null;

function csv(rows: Row[], titles: string[], totals: (number | null)[]): string {
  const quote = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const lines = rows.map((row, i) => [
    row.name,
    row.status.brief,
    ...[...COLUMNS.map((column) => row.cells[column].value), totals[i]].map((value) => String(value ?? "")),
  ]);
  return [titles, ...lines].map((line) => line.map(quote).join(",")).join("\n");
}

function plain(row: Row, state: State): Record<string, unknown> {
  const plan = state.results[row.planner]?.plan;
  return {
    planner: row.planner,
    outcome: plan?.outcome ?? null,
    verdict: plan?.check.verdict ?? null,
    drivable: row.drivable,
    hash: plan?.hash ?? null,
    ...Object.fromEntries(COLUMNS.map((column) => [column, row.cells[column].value])),
    total: totalOf(row, state),
    samples: state.results[row.planner]?.samples ?? [],
    best: COLUMNS.filter((column) => row.cells[column].best),
  };
}
