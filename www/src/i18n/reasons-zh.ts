import type { Said } from "./said";

/**
 * Chinese for the reasons that the planners, importers and links give, and for the papers' claims: a catalogue by their
 * English templates. `{}` is a value.
 */
export interface Catalogue {
  reasons: Record<string, string>;
  /** Values that are words themselves, and what a rule is about where it is named before "must". */
  values: Record<string, string>;
}

type Say = (text: string) => string | undefined;

/** Translates a text that fits one of the templates into Chinese. */
function templates(table: Record<string, string>, valueOf: (text: string) => string): Say {
  const patterns = Object.entries(table).map(
    ([en, zh]) =>
      [
        new RegExp(
          `^${en
            .split("{}")
            .map((part) => part.replace(/[.*+?^$()[\]{}|\\]/g, "\\$&"))
            .join("(.*?)")}$`,
        ),
        zh,
      ] as const,
  );
  return (text) => {
    for (const [pattern, zh] of patterns) {
      const found = pattern.exec(text)?.slice(1).map(valueOf);
      let next = 0;
      if (found) return zh.replace(/\{(\d?)\}/g, (_, at: string) => found[at ? Number(at) : next++] ?? "");
    }
    return undefined;
  };
}

/** Translates a refusal into Chinese; one that the catalogue lacks stays as it is. */
export function chineseReasons({ reasons, values }: Catalogue): (reason: string | Said) => string {
  // What is quoted stays as it was written.
  const valueOf = (text: string): string => (/^["'[]/.test(text) ? text : (wordOf(text) ?? text));
  const wordOf = templates(values, valueOf),
    plainOf = templates(reasons, valueOf);
  const sentenceOf: Say = (body) => {
    const [, subject, rule] = /^(.+?):? (must .*)$/.exec(body) ?? [],
      said = plainOf(body);
    if (said || !subject) return said;
    const ruled = plainOf(rule!);
    return ruled && (wordOf(subject) ?? `${subject} `) + ruled;
  };
  const textOf = (text: string): string => {
    const whole = text.replace(/\.$/, ""),
      [, path = "", rest = whole] = /^([\w.[\]]+(?: and \w+)*: )?(.*)$/s.exec(whole) ?? [];
    const [, body = rest, got] = /^(.*?)(?:, got (.*?))?$/s.exec(rest) ?? [];
    const rule = sentenceOf(body);
    // A text may begin like a field, or have "got" of its own.
    const alone = path || rule === undefined ? plainOf(whole) : undefined;
    if (alone !== undefined) return `${alone}。`;
    return rule === undefined
      ? text
      : `${path.replaceAll(" and ", "、").replace(": ", "：")}${rule}${got === undefined ? "" : `，实际为 ${valueOf(got)}`}。`;
  };
  /** A rule's Chinese, once for all values: they stand in it by their numbers. */
  const ruleOf = remembered((template: string): string => {
    let count = 0;
    return textOf(template.replaceAll("{}", () => `⟨${count++}⟩`));
  });
  /** A value may be a whole scene. */
  const shownOf = (value: string): string => valueOf(value.replace(/^(["[{].{99}).+/s, "$1…"));
  return (reason) => {
    if (typeof reason === "string") return textOf(reason);
    const { path, template, values: given = [], message, sentence } = reason;
    if (sentence) return `${sentence("zh")}。`;
    if (!template?.replaceAll("{}", "").trim()) return textOf(message);
    const rule = ruleOf(template).replace(/⟨(\d+)⟩/g, (_, at: string) => shownOf(given[Number(at)] ?? ""));
    return path ? `${path.replaceAll(" and ", "、")}：${rule}` : rule;
  };
}

function remembered(make: (text: string) => string): (text: string) => string {
  const known = new Map<string, string>();
  return (text) => {
    let made = known.get(text);
    if (made === undefined) known.set(text, (made = make(text)));
    return made;
  };
}
