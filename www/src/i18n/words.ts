/** The words of a piece that is fetched when it is opened; they come with it. */
import { fill, type Lang, type Values } from "./index";

export type Say<Key extends string> = (lang: Lang, key: Key, values?: Values) => string;

/** English and Chinese in pairs. */
export function words<Key extends string>(table: Record<Key, readonly [en: string, zh: string]>): Say<Key> {
  return (lang, key, values = {}) => fill(lang, table[key][lang === "zh" ? 1 : 0], values);
}
