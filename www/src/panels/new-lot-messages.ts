/** The words of the form for a new lot. */
import type { Lang } from "../i18n/index";
import { translatorAt } from "../i18n/translator";
import { LIMITS, type LotFault, type NumberField } from "../scene/lot";

export const say = translatorAt("lot");

export type Word = Parameters<typeof say>[1];

/** Advice on what to change, in one sentence. */
export function faultText(lang: Lang, { field, rule, least }: LotFault): string {
  const most = field in LIMITS ? LIMITS[field as NumberField][1] : least;
  if (rule === "least" && field === "width") return say(lang, "groundWidth", { least });
  if (rule === "least" && field === "depth") return say(lang, "groundDepth", { least });
  return say(lang, rule, { field: say(lang, field as NumberField), least, most });
}
