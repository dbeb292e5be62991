/**
 * Markdown of the lessons: formulas become MathML, and `<lab-figure>` becomes a figure with its still. Both while the
 * site is built.
 */
import { tex } from "@mdit/plugin-tex";
import temml from "temml";
import type { MarkdownRenderer } from "vitepress";
import * as parkade from "../../../pkg/node.js";
import { figureOf } from "./figures";
import { escaped } from "./grid-text";
import type { Engine } from "./metric-state";
import { stillOf } from "./stills";
import { word, type Lang } from "./words";

const FIGURE = /^<lab-figure ([^>]*)><\/lab-figure>\s*$/;

export async function lessons(): Promise<(md: MarkdownRenderer) => void> {
  await parkade.init();
  return (md) => {
    md.use(tex as never, {
      render: (formula: string, displayMode: boolean) => temml.renderToString(formula, { displayMode, xml: true }),
    });
    // An unknown tag on a line of its own is a token of either kind.
    for (const kind of ["html_block", "html_inline"] as const) {
      const before = md.renderer.rules[kind]!;
      md.renderer.rules[kind] = (tokens, i, options, env, self) => {
        const [, attributes] = FIGURE.exec(tokens[i]!.content) ?? [];
        if (attributes === undefined) return before(tokens, i, options, env, self);
        const lang: Lang = String((env as { relativePath?: string }).relativePath).startsWith("zh/") ? "zh" : "en";
        return figureHtml(md, attributes, lang);
      };
    }
  };
}

function attribute(attributes: string, name: string): string {
  const [, value] = new RegExp(`${name}="([^"]*)"`).exec(attributes) ?? [];
  if (!value) throw new Error(`a <lab-figure> has no ${name}: ${attributes}`);
  return value;
}

const engine = parkade as unknown as Engine;

/**
 * The task, the still, the controls, the numbers and the answer; places for all of them, so that nothing moves later.
 */
function figureHtml(md: MarkdownRenderer, attributes: string, lang: Lang): string {
  const id = attribute(attributes, "id"),
    figure = figureOf(id);
  const task = md.renderInline(attribute(attributes, "task")),
    answer = md.renderInline(attribute(attributes, "answer"));
  const still = stillOf(figure, engine, lang);
  return (
    `<figure class="lab" ` +
    `data-lab="${id}" data-lang="${lang}"><figcaption>${task}</figcaption>${still}<div class="lab-answer" ` +
    `role="status"><p ` +
    `class="lab-todo">${escaped(word("todo", lang))}</p><p class="lab-told">${answer}</p></div></figure>\n`
  );
}
