import first from "./messages/first.json";
import type later from "./messages/later.json";
import type { Catalogue } from "./reasons-zh";
import chineseUrl from "./reasons-zh.json?url";
import type { Said } from "./said";

export type { Said };

export type Lang = "en" | "zh";
export type MessageKey = keyof typeof first | keyof typeof later;
export type Values = Record<string, string | number | Said>;
export type Translate = (key: MessageKey, values?: Values) => string;
/**
 * English and Chinese of each key. The build leaves the English in its place, and puts the Chinese of all files into
 * one.
 */
export type Messages = Record<string, string | string[]>;

type Table = Record<string, string>;

/** English comes with the page and its pieces; other languages are fetched when they are wanted. */
const tables: Record<Lang, Table> = { en: {}, zh: {} };
const plurals: Record<Lang, Intl.PluralRules> = { en: new Intl.PluralRules("en"), zh: new Intl.PluralRules("zh") };
const formats = new Map<string, Intl.NumberFormat>();

/** Rules come in English; a language's catalogue of them comes with its words. */
const reasons: Partial<Record<Lang, (reason: string | Said) => string>> = {};

/** `{name}` is a value; `{n|pose|poses}` picks a word by the number `n`. */
export const textOf = (lang: Lang, key: string, values: Values = {}): string =>
  fill(lang, templateOf(lang, key), values);

/** A text with its places for values. */
export const templateOf = (lang: Lang, key: string): string => tables[lang][key] ?? tables.en[key] ?? "";

/** The same, of the words of the page and of most pieces. */
export const translate: (lang: Lang, key: MessageKey, values?: Values) => string = textOf;

/** Words that come with a piece of the page. */
export function addMessages(messages: Messages): void {
  for (const key in messages) {
    const [en, zh] = [messages[key]].flat();
    tables.en[key] = en!;
    if (zh) tables.zh[key] = zh;
  }
}

addMessages(first);

/** The planners' and readers' refusals in the page's language. */
export const reasonIn = (lang: Lang, reason: string | Said): string =>
  reasons[lang]?.(reason) ?? (reason as Said).message ?? reason;

/** A text with its values in their places; a value named `reason` is said in the text's language. */
export function fill(lang: Lang, text: string, values: Values): string {
  return text.replace(/\{(\w+)(?:\|([^|}]*)\|([^}]*))?\}/g, (_, name: string, one?: string, other?: string) => {
    const value = values[name] ?? "";
    if (one === undefined) return name === "reason" ? reasonIn(lang, value as string) : String(value);
    return (plurals[lang].select(Number(value)) === "one" ? one : other) ?? "";
  });
}

/** Fetches a language's words; without them the page stays English. */
export async function loadLang(lang: Lang): Promise<Lang> {
  if (lang === "en" || reasons[lang]) return lang;
  try {
    const [{ words, ...catalogue }, { chineseReasons }] = await Promise.all([
      fetch(new URL(chineseUrl, import.meta.url)).then(
        (answer) => answer.json() as Promise<Catalogue & { words?: Table }>,
      ),
      import("./reasons-zh"),
    ]);
    Object.assign(tables[lang], words);
    reasons[lang] = chineseReasons(catalogue);
    return lang;
  } catch {
    return "en";
  }
}

export function isMessage(key: string): key is MessageKey {
  return key in tables.en;
}

export function number(lang: Lang, value: number, digits: number): string {
  const id = `${lang}${digits}`;
  let format = formats.get(id);
  if (!format) {
    format = new Intl.NumberFormat(lang === "zh" ? "zh-CN" : "en", {
      minimumFractionDigits: digits,
      maximumFractionDigits: digits,
      signDisplay: "negative",
      useGrouping: "min2",
    } as Intl.NumberFormatOptions);
    formats.set(id, format);
  }
  return format.format(value).replace("-", "−");
}

/** Three significant figures, as times are read. */
export function millis(lang: Lang, value: number): string {
  return number(lang, value, value < 10 ? 2 : value < 100 ? 1 : 0);
}

export function pickLang(attribute: string | null): Lang {
  const wanted = attribute ? [attribute] : [...navigator.languages, "en"];
  for (const tag of wanted) {
    const base = tag.toLowerCase().split("-")[0];
    if (base === "zh" || base === "en") return base;
  }
  return "en";
}
