/** Columns of the parking paper's tables, and their text. */
import type { ParkingFigures, ParkingTable } from "parkade";
import { number, type Lang } from "../i18n/index";
import { say } from "./papers-parking-messages";
import { nth } from "../scene/nth";

type Line = ParkingTable["lines"][number];

/** A figure; the paper prints those that `ParkingFigures` has. */
export interface Figure {
  key: keyof ParkingFigures | "exact" | "clearance" | "expanded" | "milliseconds";
  digits: number;
  printed: boolean;
}

export const FIGURES: readonly Figure[] = [
  { key: "length", digits: 1, printed: true },
  { key: "changes", digits: 0, printed: true },
  { key: "nodes", digits: 0, printed: true },
  { key: "time", digits: 2, printed: true },
  { key: "exact", digits: 2, printed: false },
  { key: "clearance", digits: 2, printed: false },
  { key: "expanded", digits: 0, printed: false },
  { key: "milliseconds", digits: 1, printed: false },
];

/** The abstract's claims: percent of driving time saved on some rows. */
const CLAIMS = [
  ["P1", "P2", "P3", "P4", 8.18],
  ["L1", "L2", "L3", "L4", 20.53],
] as const;

export function titleOf(
  lang: Lang,
  {
    row: {
      id,
      tables: [first, last],
      parallel,
    },
  }: ParkingTable,
): string {
  const where = first === last ? say(lang, "table", { table: first }) : say(lang, "tables", { first, last });
  return `${id}: ${say(lang, parallel ? "along" : "across")}, ${where}`;
}

export const lineName = (lang: Lang, { planner }: Line): string => say(lang, planner as "hybrid");

export function printedOf({ row }: ParkingTable, { key, printed }: Figure): [number, number] | null {
  return printed ? [row.traditional[key as "length"], row.improved[key as "length"]] : null;
}

/** Error of the printed row; the package has it in English only. */
export const noteOf = (lang: Lang, { row }: ParkingTable): string => (row.note ? say(lang, row.id as "P0") : "");

export const reachText = (
  lang: Lang,
  {
    row: {
      reach: [length, changes],
    },
    kept,
  }: ParkingTable,
): string =>
  `${say(lang, "reach", { length: number(lang, length, 2), changes })} – ${say(lang, kept ? "kept" : "broken")}`;

/** Rows, the abstract's percentage, the printed rows' and ours; of rows that are all there. */
export function savings(
  tables: readonly ParkingTable[],
): { rows: string; said: number; printed: number; ours: number; classic: number }[] {
  return CLAIMS.flatMap((claim) => {
    const said = claim[4],
      of = tables.filter(({ row }) => (claim as readonly unknown[]).includes(row.id));
    if (of.length < 4) return [];
    const mean = (at: 0 | 1): number => of.reduce((sum, { saved }) => sum + saved[at], 0) / of.length;
    const classic =
      of.reduce((sum, { lines }) => sum + 100 * (1 - nth(lines, 1).time / nth(lines, 3).time), 0) / of.length;
    return [{ rows: `${claim[0]}–${claim[3]}`, said, printed: mean(0), ours: mean(1), classic }];
  });
}

export function parkingMarkdown(lang: Lang, tables: readonly ParkingTable[]): string {
  const row = (cells: readonly string[]): string => `| ${cells.join(" | ")} |`;
  const parts: string[] = [];
  for (const table of tables) {
    const heads = table.lines.map((line) => lineName(lang, line));
    const flag = (at: 0 | 1): string =>
      table.impossible[at] ? ` ⚠ ${say(lang, "impossible", { bound: number(lang, table.bound, 2) })}` : "";
    parts.push(
      `### ${titleOf(lang, table)}`,
      "",
      row([
        say(lang, "figure"),
        ...(["traditional", "improved"] as const).map((one) => `${say(lang, "printedHead")}, ${say(lang, one)}`),
        ...heads,
      ]),
      row(["---", "---:", "---:", ...heads.map(() => "---:")]),
    );
    for (const figure of FIGURES) {
      const printed = printedOf(table, figure);
      const cell = (at: 0 | 1): string =>
        printed ? number(lang, printed[at], figure.digits) + (figure.key === "length" ? flag(at) : "") : "–";
      parts.push(
        row([
          say(lang, figure.key),
          cell(0),
          cell(1),
          ...table.lines.map((line) => number(lang, line[figure.key], figure.digits)),
        ]),
      );
    }
    parts.push(
      row([say(lang, "verdict"), "–", "–", ...table.lines.map(({ verdict }) => say(lang, verdict))]),
      "",
      `${noteOf(lang, table)} ${reachText(lang, table)}`.trim(),
      "",
    );
  }
  const percent = (value: number): string => `${number(lang, value, 2)} %`;
  parts.push(
    `### ${say(lang, "saved")}`,
    "",
    row([say(lang, "rows"), say(lang, "abstract"), say(lang, "ofRows"), say(lang, "ours"), say(lang, "overClassic")]),
    row(["---", "---:", "---:", "---:", "---:"]),
    ...savings(tables).map(({ rows, said, printed, ours, classic }) =>
      row([rows, percent(said), percent(printed), percent(ours), percent(classic)]),
    ),
    "",
    say(lang, "sameNote"),
    "",
  );
  return parts.join("\n");
}
