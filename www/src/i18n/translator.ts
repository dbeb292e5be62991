/** The words of a piece, which come with it. */
import "./later";
import { addMessages, textOf, type Lang, type MessageKey, type Messages, type Values } from "./index";

export type Say<Key extends string> = (lang: Lang, key: Key, values?: Values) => string;

/** The rest of the keys that begin with a prefix and a dot. */
type Named<Key, Prefix extends string> = Key extends `${Prefix}.${infer Name}` ? Name : never;

/** Adds a file of the catalogue, all of whose keys begin with the prefix; what it lacks is asked of `others`. */
export function translator<Prefix extends string, Table extends Messages, Other extends string = never>(
  prefix: Prefix,
  table: Table,
  others?: Say<Other>,
): Say<Named<keyof Table, Prefix> | Other> {
  addMessages(table);
  return (lang, key, values) =>
    others && !(`${prefix}.${key}` in table)
      ? others(lang, key as Other, values)
      : textOf(lang, `${prefix}.${key}`, values);
}

/** The words of a piece that most visits fetch: they stand with those of others. */
export const translatorAt =
  <Prefix extends string>(prefix: Prefix): Say<Named<MessageKey, Prefix>> =>
  (lang, key, values) =>
    textOf(lang, `${prefix}.${key}`, values);
