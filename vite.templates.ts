import type { Plugin } from "vite";

/** Of a syntax tree, what is read here. */
interface Node {
  type: string;
  start: number;
  end: number;
  tag?: { name?: string };
  quasi?: { quasis: (Node & { value: { raw: string } })[] };
}

/** Minifiers leave template literals alone; the page's styles and markup are such. */
export const squeezeTemplates: Plugin = {
  name: "squeeze-templates",
  enforce: "pre",
  transform(code, id) {
    if (!id.includes("/www/src/") || !id.endsWith(".ts")) return null;
    let squeezed = "",
      done = 0;
    for (const { text, start, squeeze } of textsIn(this.parse(code, { lang: "ts" }))) {
      // A text's own ends lie before it or within it, by parser.
      const at = code.indexOf(text, start);
      squeezed += code.slice(done, at) + squeeze(text);
      done = at + text.length;
    }
    return squeezed + code.slice(done);
  },
};

interface Text {
  text: string;
  start: number;
  squeeze: (text: string) => string;
}

/** The texts between the values of all tagged templates, nested ones as well, in the order of the source. */
function textsIn(tree: unknown): Text[] {
  const found: Text[] = [];
  const walk = (node: unknown): void => {
    if (typeof node !== "object" || node === null) return;
    const { type, tag, quasi } = node as Node,
      squeeze = type === "TaggedTemplateExpression" && SQUEEZE[tag?.name ?? ""];
    if (squeeze)
      for (const { start, value } of quasi!.quasis) if (value.raw) found.push({ text: value.raw, start, squeeze });
    Object.values(node).forEach(walk);
  };
  walk(tree);
  return found.sort((a, b) => a.start - b.start);
}

/** A line's end and the indent after it are one space, as in a browser. */
const markup = (text: string): string => text.replace(/\n\s*/g, " ");

const styles = (text: string): string =>
  text
    .replace(/\/\*[^]*?\*\//g, "")
    .replace(/\n\s*/g, "\n")
    .replace(/\s*([{};,])\s*/g, "$1")
    .replace(/: /g, ":")
    .replace(/ ([>/]) /g, "$1")
    .replace(/#(.)\1(.)\2(.)\3\b/g, "#$1$2$3")
    .replace(/;}/g, "}")
    .replace(/([ :,(])0\./g, "$1.");

const SQUEEZE: Record<string, (text: string) => string> = { css: styles, html: markup, svg: markup };
