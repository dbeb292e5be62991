/** The marks of a drawing as an SVG file; in two colour schemes where it follows the reader's. */
import { nameOf, type Canvas, type Mark } from "./canvas";
import { nth } from "../scene/nth";

/** `drawn`: the same drawing in the light scheme and, where there are two, in the dark one. */
export function svgOf(drawn: readonly Canvas[]): string {
  const rules = new Map<string, readonly string[]>(),
    shared = new Map<string, string>();
  const body = marksOf(drawn, rules, shared);
  const style = [0, 1].map((scheme) =>
    [...rules]
      .filter(([, texts]) => scheme === 0 || texts[1] !== texts[0])
      .map(([name, texts]) => `.${name}{${texts[scheme]}}`)
      .join(""),
  );
  const css = style[0] + (drawn.length > 1 ? `@media(prefers-color-scheme:dark){${style[1]}}` : "");
  return `<style>${css}</style><defs>${[...shared.values()].join("")}</defs>${body}`;
}

function marksOf(drawn: readonly Canvas[], rules: Map<string, readonly string[]>, shared: Map<string, string>): string {
  const [first, ...others] = drawn.map(({ pen }) => pen);
  for (const pen of [first!, ...others]) for (const [id, text] of pen.clips) shared.set(id, text);
  return first!.marks
    .map((mark, i) => {
      const both = [mark, ...others.map((pen) => nth(pen.marks, i))],
        texts = both.map(cssOf);
      const name = nameOf(texts.join("|"));
      if (texts[0]) rules.set(name, texts);
      const fill = mark.pattern ? ` fill="url(#${patternOf(both, rules, shared)})"` : "";
      return `<${mark.tag}${texts[0] ? ` class="${name}"` : ""}${mark.markup}${fill}${
        mark.inside ? `>${mark.inside}</${mark.tag}>` : "/>"
      }`;
    })
    .join("");
}

const cssOf = ({ style }: Mark): string =>
  Object.entries(style)
    .map(([key, value]) => `${key}:${value}`)
    .join(";");

function patternOf(marks: readonly Mark[], rules: Map<string, readonly string[]>, shared: Map<string, string>): string {
  const tiles = marks.map(({ pattern }) => pattern!.canvas),
    { width } = nth(tiles, 0);
  const inside = marksOf(tiles, rules, shared),
    text = ` patternUnits="userSpaceOnUse" width="${width}" height="${width}">${inside}</pattern>`;
  const id = nameOf(text);
  shared.set(id, `<pattern id="${id}"${text}`);
  return id;
}
