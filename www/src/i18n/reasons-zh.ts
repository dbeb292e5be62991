/** Chinese for the reasons that the planners, importers and links give: a catalogue by their English templates. `{}` is a value. */
export interface Catalogue {
  reasons: Record<string, string>;
  /** Values that are words themselves. */
  values: Record<string, string>;
}

/** What says a reason in Chinese; one that the catalogue does not have stays as it is. */
export function chineseReasons({ reasons, values }: Catalogue): (english: string) => string {
  const patterns = Object.entries(reasons).map(([en, zh]) =>
    [new RegExp(`^${en.split("{}").map((part) => part.replace(/[.*+?^$()[\]{}|\\]/g, "\\$&")).join("(.*?)")}$`), zh] as const);
  const valueOf = (text: string): string =>
    values[text] ?? text.replace(/^(\d+) numbers$/, "$1 个数").replace(/^(\d+) cells at /, "$1 格，位于 ").replace(/,? or (?=\S+$)/, " 或 ");
  const sentenceOf = (body: string): string | undefined => {
    for (const [pattern, zh] of patterns) {
      const found = pattern.exec(body)?.slice(1).map(valueOf);
      let next = 0;
      if (found) return zh.replace(/\{(\d?)\}/g, (_, at: string) => found[at ? Number(at) : next++] ?? "");
    }
    return undefined;
  };
  return (text) => {
    const [, path = "", rest = text] = /^([\w.[\]]+: )?(.*)$/s.exec(text) ?? [];
    const [, body = rest, got] = /^(.*?)(?:, got (.*?))?[.]?$/s.exec(rest) ?? [];
    const said = sentenceOf(body);
    if (said === undefined) return path && text !== rest ? text : sentenceOf(text.replace(/\.$/, "")) ?? text;
    return `${path.replace(": ", "：")}${said}${got === undefined ? "" : `，实际为 ${valueOf(got)}`}。`;
  };
}
