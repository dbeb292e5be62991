/** The papers' pages: their tables beside ours, computed anew while the site is built, with figures that can be played with. */
import { init } from "../../../pkg/node.js";
import { escaped, markdown, type Block, type Figure, type Lang } from "./blocks";
import { comparison, comparisonBlocks } from "./comparison";
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

export { escaped, html, markdown } from "./blocks";
export { picture } from "./figures";

let kept: Measured | null = null;

/** All pages of a language, from one measurement. */
export async function pages(lang: Lang, seeds = SEEDS): Promise<Page[]> {
  await init();
  const measured = kept?.seeds === seeds ? kept : (kept = measure(seeds));
  return [riskField(lang, measured), sixteen(lang, measured), parking(lang, measured), road(lang, measured)];
}

/** The road manuscript's comparison with other algorithms alone. */
export async function compared(lang: Lang): Promise<Block[]> {
  await init();
  return comparisonBlocks(lang, comparison());
}

const playground =
  (lang: Lang) =>
  ({ scene, planners, draws, caption, svg }: Figure): string =>
    svg !== undefined
      ? `<figure class="drawn">${svg}<figcaption>${escaped(caption)}</figcaption></figure>`
      : `<parkade-playground scene="${scene}" planners="${planners.join(" ")}" layout="${planners.length > 1 ? "grid" : "single"}" controls="minimal" editable lang="${lang}"${draws === "stages" || draws === "potential" ? ' layers="slots obstacles path tree grid"' : ""} alt="${caption.replaceAll('"', "")}"></parkade-playground>\n\n*${caption}*`;

/** For the site. */
export async function papers(lang: Lang = "en"): Promise<{ params: { id: string; title: string }; content: string }[]> {
  return (await pages(lang)).map(({ id, title, blocks }) => ({
    params: { id, title },
    content: markdown(blocks, playground(lang)).replaceAll("{{", "{ {"),
  }));
}
