import en from "./en.json";
import type later from "./en-later.json";
import type { Catalogue } from "./reasons-zh";
import zhUrl from "./zh.json?url";
import zhReasonsUrl from "./reasons-zh.json?url";

export type Lang = "en" | "zh";
export type MessageKey = keyof typeof en | keyof typeof later;
export type Values = Record<string, string | number>;
export type Translate = (key: MessageKey, values?: Values) => string;

type Table = Record<string, string>;

/** English is part of the page and of its pieces; other languages are fetched when they are wanted. */
const english: Table = { ...en };
const tables: Partial<Record<Lang, Table>> = { en: english };
const urls: Partial<Record<Lang, readonly [words: string, reasons: string]>> = { zh: [zhUrl, zhReasonsUrl] };
const plurals: Record<Lang, Intl.PluralRules> = { en: new Intl.PluralRules("en"), zh: new Intl.PluralRules("zh") };
const formats = new Map<string, Intl.NumberFormat>();

/** Reasons come in English; a language's catalogue of them comes with its words. */
const reasons: Partial<Record<Lang, (english: string) => string>> = {};

/** `{name}` is a value; `{n|pose|poses}` picks a word by the number `n`. */
export const translate = (lang: Lang, key: MessageKey, values: Values = {}): string =>
  fill(lang, (tables[lang] ?? english)[key] ?? "", values);

/** Words that come with a piece of the page. */
export const addEnglish = (words: Table): void => void Object.assign(english, words);

/** Translations of the planners' English texts. */
export const reasonIn = (lang: Lang, english: string): string => reasons[lang]?.(english) ?? english;

/** A text with its values in their places; a value named `reason` is said in the text's language. */
export function fill(lang: Lang, text: string, values: Values): string {
  return text.replace(/\{(\w+)(?:\|([^|}]*)\|([^}]*))?\}/g, (_, name: string, one?: string, other?: string) => {
    const value = values[name] ?? "";
    if (one === undefined) return name === "reason" ? reasonIn(lang, String(value)) : String(value);
    return (plurals[lang].select(Number(value)) === "one" ? one : other) ?? "";
  });
}

/** Fetches a language's words; without them the page stays English. */
export async function loadLang(lang: Lang): Promise<Lang> {
  const files = urls[lang];
  if (tables[lang] || !files) return lang;
  const read = async (url: string): Promise<unknown> => (await fetch(new URL(url, import.meta.url))).json();
  try {
    const [table, catalogue, { chineseReasons }] = await Promise.all([
      read(files[0]),
      read(files[1]),
      import("./reasons-zh"),
    ]);
    tables[lang] = table as Table;
    reasons[lang] = chineseReasons(catalogue as Catalogue);
    return lang;
  } catch {
    return "en";
  }
}

export function isMessage(key: string): key is MessageKey {
  return key in english;
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
  return number(lang, value, value < 1 ? 2 : value < 10 ? 2 : value < 100 ? 1 : 0);
}

export function pickLang(attribute: string | null): Lang {
  const wanted = attribute ? [attribute] : [...navigator.languages, "en"];
  for (const tag of wanted) {
    const base = tag.toLowerCase().split("-")[0];
    if (base === "zh" || base === "en") return base;
  }
  return "en";
}
