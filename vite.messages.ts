import { readdirSync, readFileSync } from "node:fs";
import { basename, join } from "node:path";
import type { Plugin } from "vite";

type Messages = Record<string, [en: string, zh: string]>;

/**
 * Leaves the English of the page's messages where it is imported, and puts the Chinese of all into the file of reasons.
 */
export function messages(i18n: string): Plugin {
  const folder = join(i18n, "messages");
  const read = (file: string): Messages => JSON.parse(readFileSync(file, "utf8")) as Messages;
  const inLanguage = (table: Messages, at: 0 | 1) =>
    Object.fromEntries(Object.entries(table).map(([key, texts]) => [key, texts[at]]));
  return {
    name: "messages",
    apply: "build",
    enforce: "pre",
    load(id) {
      const [file = "", query] = id.split("?");
      if (file.startsWith(`${folder}/`) && !query) return JSON.stringify(inLanguage(read(file), 0));
      if (file !== join(i18n, "reasons-zh.json") || query !== "url") return null;
      const tables = readdirSync(folder).map((name) => inLanguage(read(join(folder, name)), 1));
      const source = JSON.stringify({ words: Object.assign({}, ...tables), ...read(file) });
      const reference = this.emitFile({ type: "asset", name: basename(file).replace("reasons-", ""), source });
      return { code: `export default "__VITE_ASSET__${reference}__"`, moduleType: "js" };
    },
  };
}
