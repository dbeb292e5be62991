/** What a screen reader is told of the planners' answers: status, and figures of the table. */
import { translate } from "../i18n/index";
import type { State } from "../store";
import { whyOf } from "../texts/failure";
import { rowsOf, type Row } from "./metrics";

const FIGURES = ["length", "gears", "plan"] as const;
const MARKS = { en: { space: " ", comma: ", ", stop: "." }, zh: { space: "", comma: "，", stop: "。" } };

export function spokenOf(state: State): string {
  const rows = rowsOf(state).filter((row) => !row.hidden);
  return rows.map((row) => sentencesOf(state, row)).join(MARKS[state.lang].space);
}

function sentencesOf(state: State, { planner, name, status, cells }: Row): string {
  const { lang } = state,
    { space, comma, stop } = MARKS[lang];
  const why = whyOf(state, planner) ?? status.chip;
  const said = translate(lang, "say.planner", { planner: name, status: why.replace(/[.。]$/, "") });
  if (cells.length.value === null) return said;
  const figures = FIGURES.filter((column) => cells[column].value !== null).map((column) =>
    translate(lang, `say.${column}`, { n: cells[column].text }),
  );
  return said + space + figures.join(comma) + stop;
}
