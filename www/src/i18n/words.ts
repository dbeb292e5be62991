/** The words of a piece that is fetched when it is opened; they come with it. */
import "./later";
import { fill, translate, type Lang, type MessageKey, type Values } from "./index";

export type Say<Key extends string> = (lang: Lang, key: Key, values?: Values) => string;

/** English and Chinese in pairs. */
export function words<Key extends string>(table: Record<Key, readonly [en: string, zh: string]>): Say<Key> {
  return (lang, key, values = {}) => fill(lang, table[key][lang === "zh" ? 1 : 0], values);
}

type KeyAt<Prefix extends string> = MessageKey extends infer Key
  ? Key extends `${Prefix}.${infer Name}`
    ? Name
    : never
  : never;

/** The words of a piece that most visits fetch: they stand in the tables. */
export const wordsAt =
  <Prefix extends string>(prefix: Prefix): Say<KeyAt<Prefix>> =>
  (lang, key, values) =>
    translate(lang, `${prefix}.${key}` as MessageKey, values);
