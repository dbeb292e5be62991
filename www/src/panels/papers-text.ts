/** Names and texts of the papers' tables. */
import type { PaperTable, Spread } from "parkade";
import { number, type Lang } from "../i18n/index";
import type { Summary } from "../planning/paper-grid-runs";
import { plannerName } from "../styles/planner-style";
import { sentencesOf } from "./papers-claims";
import { say } from "./papers-messages";

/** Our columns that are compared with the printed ones. */
export const SHOWN = { nodes: "generated", length: "lengthPruned" } as const;

/** What a printed length may mean. */
export const READINGS = ["lengthRaw", "lengthPruned", "lengthDp", "lengthSmoothed"] as const;

/** A reading's median and its distance from the printed length. */
export function readingOf(
  lang: Lang,
  { figures, printedLength }: PaperTable["lines"][number],
  columns: readonly string[],
  name: string,
): string {
  const median = figures[columns.indexOf(name)]?.median ?? 0,
    percent = (median / (printedLength ?? 1) - 1) * 100;
  return `${number(lang, median, 2)} (${percent < 0 ? "−" : "+"}${number(lang, Math.abs(percent), 1)} %)`;
}

/** Variants of planners that only these tables have. */
const VARIANTS: Record<string, readonly [planner: string, name: (lang: Lang) => string]> = {
  "eight-octile": ["eight", (lang) => say(lang, "octile")],
  "eight-weighted": ["eight", (lang) => say(lang, "weighted")],
  "sixteen-nba": ["sixteen-bidirectional", () => "NBA*"],
};

export function lineName(lang: Lang, id: string): string {
  const variant = VARIANTS[id];
  if (!variant) return plannerName(lang, id as Parameters<typeof plannerName>[1]);
  return `${lineName(lang, variant[0])}, ${variant[1](lang)}`;
}

export function titleOf(lang: Lang, { row }: PaperTable): string {
  return say(lang, "tableOf", {
    table: row.table,
    size: row.size,
    family: say(lang, row.id.startsWith("random") ? "random" : "regular"),
  });
}

export const figureName = ({ figure, overFigure }: PaperTable["ratios"][number]): string =>
  figure === overFigure ? figure : `${figure} / ${overFigure}`;

export function papersMarkdown(lang: Lang, { tables, claims }: Summary, columns: readonly string[]): string {
  const row = (cells: readonly string[]): string => `| ${cells.join(" | ")} |`;
  const three = (spread: Spread | undefined, digits: number): string[] =>
    spread ? [spread.median, spread.p95, spread.worst].map((value) => number(lang, value, digits)) : ["–", "–", "–"];
  const heads = (name: string): string[] =>
    ["printed", "median", "p95", "worst"].map((key) => `${name}, ${say(lang, key as "printed")}`);
  const parts = [
    row([say(lang, "claims"), "", ""]),
    row(["---", "---", "---"]),
    ...claims.map((one) => {
      const [text, found] = sentencesOf(lang, one);
      return row([text, `**${say(lang, one.holds)}**`, found]);
    }),
    "",
  ];
  for (const table of tables) {
    const length = number(lang, table.straight, 2);
    parts.push(`### ${titleOf(lang, table)} (${say(lang, "maps", { n: table.maps })})`, "");
    parts.push(
      row([say(lang, "planner"), ...heads(say(lang, "nodes")), ...heads(say(lang, "length"))]),
      row(["---", ...Array.from({ length: 8 }, () => "---:")]),
    );
    for (const line of table.lines) {
      const printed = line.printedLength === null ? "–" : number(lang, line.printedLength, 2);
      parts.push(
        row([
          lineName(lang, line.planner),
          String(line.printedNodes ?? "–"),
          ...three(line.figures[columns.indexOf(SHOWN.nodes)], 0),
          line.impossible ? `${printed} (${say(lang, "impossible", { length })})` : printed,
          ...three(line.figures[columns.indexOf(SHOWN.length)], 2),
        ]),
      );
    }
    parts.push("", row([say(lang, "planner"), say(lang, "printed"), ...READINGS.map((name) => say(lang, name))]));
    parts.push(row(Array.from({ length: 2 + READINGS.length }, () => "---")));
    for (const line of table.lines.filter(({ printedLength }) => printedLength !== null)) {
      const cells = READINGS.map((name) => {
        const cell = readingOf(lang, line, columns, name);
        return line.closest === name ? `**${cell}**` : cell;
      });
      parts.push(row([lineName(lang, line.planner), number(lang, line.printedLength!, 2), ...cells]));
    }
    parts.push("");
  }
  return parts.join("\n");
}
