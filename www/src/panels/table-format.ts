/** The metrics table as text. */
import { translate, type MessageKey } from "../i18n/index";
import type { State } from "../store";
import { COLUMNS, rowsOf, unitValues, type Cell, type Row } from "./metrics";

export type TableFormat = "markdown" | "csv" | "json";

export function formatTable(state: State, format: TableFormat): string {
  const rows = rowsOf(state);
  if (format === "json") return JSON.stringify(rows.map((row) => plain(row, state)), null, 2);
  const heads = ["table.planner", "table.status", ...COLUMNS.map((column) => `table.${column}`)]
    .map((key) => translate(state.lang, key as MessageKey));
  const units = COLUMNS.map((column) => translate(state.lang, `unit.${column}`, unitValues(state)));
  const titles = heads.map((head, i) => (i < 2 ? head : `${head} (${units[i - 2]})`));
  if (format === "csv") return csv(rows, titles);
  const lines = rows.map((row) => [row.name, row.status.brief, ...COLUMNS.map((column) => markdownCell(row.cells[column]))]);
  const rule = titles.map((_, i) => (i < 2 ? "---" : "---:"));
  return [titles.map((title) => title.replaceAll("|", "\\|")), rule, ...lines].map((line) => `| ${line.join(" | ")} |`).join("\n");
}

const markdownCell = ({ text, best }: Cell): string => (best ? `★ **${text}**` : text);

function csv(rows: Row[], titles: string[]): string {
  const quote = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const lines = rows.map((row) => [row.name, row.status.brief, ...COLUMNS.map((column) => String(row.cells[column].value ?? ""))]);
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
    samples: state.results[row.planner]?.samples ?? [],
    best: COLUMNS.filter((column) => row.cells[column].best),
  };
}
