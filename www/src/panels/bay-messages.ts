import type { Lang } from "../i18n/index";
import messages from "../i18n/messages/bay-check.json";
import { translator } from "../i18n/translator";
import { UNITS, type BayColumn } from "./bay-rows";

export const say = translator("bayCheck", messages);

/** A column's name, with its unit where it has one. */
export function heading(lang: Lang, column: BayColumn): string {
  const name = say(lang, column),
    unit = UNITS[column];
  return unit ? say(lang, "inUnit", { name, unit }) : name;
}
