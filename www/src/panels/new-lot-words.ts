/** The words of the form for a new lot. */
import "../i18n/later";
import { translate, type Lang, type MessageKey, type Values } from "../i18n/index";
import { LIMITS, type LotFault, type NumberField } from "../scene/lot";

export type Word = MessageKey extends infer Key ? (Key extends `lot.${infer Name}` ? Name : never) : never;

export const say = (lang: Lang, word: Word, values?: Values): string => translate(lang, `lot.${word}`, values);

/** What to change, in one sentence. */
export function faultText(lang: Lang, { field, rule, least }: LotFault): string {
  const most = field in LIMITS ? LIMITS[field as NumberField][1] : least;
  if (rule === "least" && field === "width") return say(lang, "groundWidth", { least });
  if (rule === "least" && field === "depth") return say(lang, "groundDepth", { least });
  return say(lang, rule, { field: say(lang, field as NumberField), least, most });
}
