/** Columns of the road manuscript's tables, and their text. */
import type { RoadTable } from "parkade";
import { number, type Lang } from "../i18n/index";
import { FLAGS, say } from "./papers-road-messages";
import { nth } from "../scene/nth";

type Line = RoadTable["lines"][number];
type Promised = RoadTable["promises"][number]["figure"];
type Printed = keyof RoadTable["row"]["printed"];
type Key = Parameters<typeof say>[1];

/** A row: its number decides the percentages, its text may say more. */
export interface Figure {
  key: Key;
  of(line: Line, table: RoadTable): number | null;
  digits: number;
  /** Beside the number. */
  more?(lang: Lang, line: Line): string;
  printed?: Printed;
  /** Factor from a printed number to our unit. */
  unit?: number;
  promised?: Promised;
  tip?: Key;
  /** No percentages. */
  plainly?: boolean;
}

export const FIGURES: readonly Figure[] = [
  { key: "length", of: (l) => l.metrics.middleLength, digits: 1, printed: "length", promised: "length" },
  { key: "turns", of: (l) => l.metrics.turnsPruned, digits: 0, printed: "turns", promised: "turns" },
  { key: "curvatureVariation", of: (l) => l.metrics.curvatureVariation, digits: 2, promised: "curvatureVariation" },
  { key: "curvature", of: (l) => l.metrics.middleCurvature, digits: 3, promised: "curvature", plainly: true },
  {
    key: "clearanceMean",
    of: (l) => l.metrics.bodyClearanceMean,
    digits: 2,
    printed: "safety",
  },
  {
    key: "clearanceCapped",
    of: (l) => l.metrics.bodyClearanceMeanCapped,
    digits: 2,
    promised: "clearanceMean",
    tip: "meanTip",
  },
  {
    key: "clearanceLeast",
    of: (l) => l.metrics.bodyClearanceMin,
    digits: 2,
    promised: "clearanceLeast",
    plainly: true,
  },
  { key: "sideLeast", of: (l) => l.metrics.sideClearanceMin, digits: 2, plainly: true },
  {
    key: "hits",
    of: (l) => l.risk.hits,
    digits: 0,
    more: (lang, l) => ` (${number(lang, l.risk.discHits, 0)})`,
    printed: "collisions",
    promised: "hits",
  },
  {
    key: "lane",
    of: (l) => l.metrics.laneDeviationMean,
    digits: 2,
    more: (lang, l) => ` / ${number(lang, l.metrics.laneDeviationMax ?? 0, 2)}`,
    promised: "laneDeviation",
    plainly: true,
  },
  { key: "laneLeft", of: (l) => 100 * (l.metrics.laneLeftShare ?? 0), digits: 1, plainly: true },
  { key: "memory", of: (l) => l.metrics.bytes / 1e6, digits: 2, printed: "memory" },
  {
    key: "bytesPerCell",
    of: (l, table) => l.metrics.bytes / table.cells,
    digits: 1,
    promised: "bytesPerCell",
    plainly: true,
  },
  { key: "time", of: (l) => l.milliseconds, digits: 1, printed: "time", unit: 1000 },
];

export function titleOf(lang: Lang, { row }: RoadTable): string {
  const scene = say(lang, row.id.slice(0, 2) as "S1");
  return row.ship ? `${scene}, ${say(lang, "ship")}` : scene;
}

export const lineName = (lang: Lang, { id }: Line): string =>
  say(lang, id === "paper-exponential" ? "paperExponential" : id);

export function cell(lang: Lang, figure: Figure, line: Line, table: RoadTable): string {
  const value = figure.of(line, table);
  return value === null ? "–" : number(lang, value, figure.digits) + (figure.more?.(lang, line) ?? "");
}

/** The change in percent; nothing where there was nothing before. */
export function change(lang: Lang, now: number | null | undefined, was: number | null | undefined): string {
  if (now == null || was == null || was === 0) return "";
  const percent = (now / was - 1) * 100;
  return `${percent > 0 ? "+" : ""}${number(
    lang,
    percent,
    Math.abs(percent) < 10 || (percent < -99 && percent > -100) ? 1 : 0,
  )} %`;
}

/** Ours against plain A*'s; none of what can be below zero there. */
export function changeOf(lang: Lang, figure: Figure, line: Line, table: RoadTable): string {
  const plain = figure.of(nth(table.lines, 0), table),
    value = figure.of(line, table);
  return figure.plainly || Math.min(plain ?? 0, value ?? 0) < 0 ? "" : change(lang, value, plain);
}

export function printedOf({ row }: RoadTable, { printed, unit = 1 }: Figure): [number, number] | null {
  return printed ? [row.printed[printed][0] * unit, row.printed[printed][1] * unit] : null;
}

/** Why the printed values of a row cannot be. */
export function flagOf(lang: Lang, table: RoadTable, figure: Figure): string | null {
  if (table.row.ship) return null;
  if (figure.printed === "safety") return say(lang, "safetyFlag");
  const road = nth(table.lines, 0).metrics.middleLength;
  return figure.printed === "length" && table.row.printed.length[0] > 1.03 * road
    ? say(lang, "lengthFlag", { length: { S2: "800", S4: "500" }[table.row.id] ?? number(lang, road, 0) })
    : null;
}

export function promiseOf(table: RoadTable, figure: Figure): RoadTable["promises"][number] | undefined {
  return table.promises.find((one) => one.figure === figure.promised);
}

export function promiseText(
  lang: Lang,
  figure: Figure,
  { atLeast, bound, kept }: RoadTable["promises"][number],
): string {
  return `${say(lang, "promised", {
    sign: atLeast ? "≥" : "≤",
    bound: number(lang, bound, figure.digits),
  })} – ${say(lang, kept ? "kept" : "broken")}`;
}

export function roadMarkdown(lang: Lang, tables: readonly RoadTable[]): string {
  const row = (cells: readonly string[]): string => `| ${cells.join(" | ")} |`;
  const parts: string[] = [];
  for (const table of tables) {
    const heads = table.lines.map((line, at) => lineName(lang, line) + (at > 0 ? " (%)" : ""));
    parts.push(
      `### ${titleOf(lang, table)}`,
      "",
      row([
        say(lang, "figure"),
        `${say(lang, "printedHead")}, ${say(lang, "plain")}`,
        `${say(lang, "improved")} (%)`,
        ...heads,
      ]),
      row(["---", ...heads.map(() => "---:"), "---:", "---:"]),
    );
    for (const figure of FIGURES) {
      const printed = printedOf(table, figure),
        flag = flagOf(lang, table, figure) ? " ⚠" : "";
      parts.push(
        row([
          say(lang, figure.key),
          printed ? `${number(lang, printed[0], 1)}${flag}` : "–",
          printed ? `${number(lang, printed[1], 1)} ${change(lang, printed[1], printed[0])}`.trim() + flag : "–",
          ...table.lines.map((line, at) =>
            `${cell(lang, figure, line, table)} ${at > 0 ? changeOf(lang, figure, line, table) : ""}`.trim(),
          ),
        ]),
      );
    }
    parts.push(row([say(lang, "verdict"), "–", "–", ...table.lines.map(({ verdict }) => say(lang, verdict))]), "");
  }
  return [...parts, `### ${say(lang, "flags")}`, "", ...FLAGS.map((flag) => `- ${say(lang, flag)}`), ""].join("\n");
}
