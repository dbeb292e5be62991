/**
 * The papers' pages: their tables beside ours, computed anew while the site is built, with figures that can be played
 * with.
 */
import { init, scenarios } from "../../../pkg/node.js";
import { escaped, figuresOfScenes, heading, isClaims, markdown, type Block, type Figure, type Lang } from "./blocks";
import { comparison, comparisonBlocks } from "./comparison";
import { picture } from "./figures";
import { measure, type Measured } from "./measure";
import { parking } from "./parking";
import { riskField, sixteen } from "./grid";
import { road } from "./road";

/** Maps of each kind and size; `cargo xtask paper grid` takes 200. */
const SEEDS = 20;

export interface Page {
  id: string;
  title: string;
  blocks: Block[];
}

export { escaped, figuresOfScenes, html, markdown } from "./blocks";
export { picture };

let kept: Measured | null = null;

/** All pages of a language, from one measurement. */
export async function pages(lang: Lang, seeds = SEEDS): Promise<Page[]> {
  await init();
  const measured = kept?.seeds === seeds ? kept : (kept = measure(seeds));
  return [riskField(lang, measured), sixteen(lang, measured), parking(lang, measured), road(lang, measured)];
}

/** The claims of all pages alone, each with its verdict and what it is judged by. */
export async function verdicts(lang: Lang, seeds = SEEDS): Promise<Block[]> {
  return (await pages(lang, seeds)).flatMap(({ title, blocks }) => [heading(2, title), ...blocks.filter(isClaims)]);
}

/** The road manuscript's comparison with other algorithms alone. */
export async function compared(lang: Lang): Promise<Block[]> {
  await init();
  return comparisonBlocks(lang, comparison());
}

/** Layers of the playground that show what a figure draws. */
const LAYERS: Readonly<Partial<Record<NonNullable<Figure["draws"]>, string>>> = {
  potential: "slots obstacles path tree grid",
  spaces: "slots obstacles path redundant grid",
};
/** What a live picture beside the coloured one shows of its spaces. */
const LIVE: Readonly<Record<Lang, string>> = {
  en: "Live, the necessary space hatched densely and the redundant one widely:",
  zh: "实时图，必要安全空间为密斜线，冗余安全空间为疏斜线：",
};
/** Figures whose points and letters no layer has: their pictures, as images, since a template may hold no style. */
const STILL: readonly Figure["draws"][] = ["pruned", "tangents", "smoothed"];
const still = (figure: Figure): string =>
  `<figure class="drawn"><img alt="${figure.caption.replaceAll('"', "")}" width="440" height="440" ` +
  `src="data:image/svg+xml;base64,${Buffer.from(picture(figure)).toString(
    "base64",
  )}"><figcaption>${escaped(figure.caption)}</figcaption></figure>`;

/** A scene's name opens the scene in a playground of its own; other code stays. */
const linked =
  (lang: Lang, known: ReadonlySet<string>) =>
  (code: string): string =>
    known.has(code)
      ? `<a href="${
          lang === "zh" ? "../" : ""
        }../../embed.html#scene=${code}&amp;controls=full&amp;lang=${lang}" target="_self"><code>${code}</code></a>`
      : `\`${code}\``;

const playground =
  (lang: Lang) =>
  (figure: Figure): string => {
    const { scene, planners, draws, caption, svg } = figure;
    if (svg !== undefined) return `<figure class="drawn">${svg}<figcaption>${escaped(caption)}</figcaption></figure>`;
    if (STILL.includes(draws)) return still(figure);
    const layers = draws && LAYERS[draws] ? ` layers="${LAYERS[draws]}"` : "";
    const live =
      `<parkade-playground ` +
      `scene="${scene}" planners="${planners.join(" ")}" layout="${
        planners.length > 1 ? "grid" : "single"
      }" controls="minimal" editable ` +
      `lang="${lang}"${layers} alt="${caption.replaceAll('"', "")}"></parkade-playground>`;
    return draws === "spaces" ? `${still(figure)}\n\n${LIVE[lang]}\n\n${live}` : `${live}\n\n*${caption}*`;
  };

/** For the site. */
export async function papers(
  lang: Lang = "en",
  seeds = SEEDS,
): Promise<{ params: { id: string; title: string }; content: string }[]> {
  const all = await pages(lang, seeds),
    drawn = all.flatMap(({ blocks }) => [...figuresOfScenes(blocks).keys()]),
    known = new Set([...scenarios().map(({ id }) => id), ...drawn]);
  return all.map(({ id, title, blocks }) => ({
    params: { id, title },
    content: markdown(blocks, playground(lang), linked(lang, known)).replaceAll("{{", "{ {"),
  }));
}
