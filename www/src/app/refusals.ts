import type { Said } from "../i18n/said";
import { refusal } from "./app";

/** A refusal as its field and the rule alone, for where the field is named in another way. */
export function apart(error: unknown): { path: string; rule: Said } {
  const { path = "", message, ...rest } = refusal(error);
  return {
    path,
    rule: { ...rest, message: message.startsWith(`${path}: `) ? message.slice(path.length + 2) : message },
  };
}

/** A rule with the field before it. */
export const withField = (path: string, rule: Said): Said =>
  path ? { ...rule, path, message: `${path}: ${rule.message}` } : rule;
