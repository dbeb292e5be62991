/** Texts of the tools. */
import { translate, type MessageKey } from "../i18n/index";
import type { State } from "../store";

type Named<Key> = Key extends `draw.${infer Name}` ? Name : never;

export const word = ({ lang }: State, key: Named<MessageKey>): string => translate(lang, `draw.${key}`);
