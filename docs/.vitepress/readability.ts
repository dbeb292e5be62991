/** How easy a page's prose is to read: Flesch's reading ease, 0 to 100, by the packages `flesch` and `syllable`. */
import { flesch } from "flesch";
import { syllable } from "syllable";

const WORDS = new Intl.Segmenter("en", { granularity: "word" });

/**
 * The prose of a Markdown page: without code, formulas, numbers, tables, tags and frontmatter; with the texts of
 * figures.
 */
export function proseOf(markdown: string): string[] {
  const texts = [...markdown.matchAll(/ (?:task|answer)="([^"]*)"/g)].map(([, text]) => text!);
  const plain = markdown
    .replace(/^---\n[^]*?\n---\n/, "")
    .replace(/```[^]*?```/g, "")
    .replace(/\$\$[^]*?\$\$/g, "")
    .replace(/^\|.*$/gm, "")
    .replace(/<[^>]*>/g, "")
    .replace(/\[([^\]]*)\]\([^)]*\)/g, "$1")
    .replace(/\$[^$\n]*\$|`[^`]*`/g, "")
    .replace(/[*_#\\]/g, "");
  // A heading, an item and a paragraph each end a sentence.
  return [...plain.split(/\n\s*\n|\n(?=\s*[*\d]+[.\s])/), ...texts].map((one) => one.replace(/\s+/g, " ").trim());
}

/**
 * Sentences end with a full stop, a question mark or an exclamation mark before a space; dots of numbers and files end
 * none.
 */
function sentencesOf(paragraph: string): string[] {
  return paragraph.split(/(?<=[.?!]["”)]?)\s+/).filter((one) => /\p{L}{2}/u.test(one));
}

export function readingEase(markdown: string): number {
  const sentences = proseOf(markdown).flatMap(sentencesOf);
  const words = sentences.flatMap((one) =>
    [...WORDS.segment(one)].map(({ segment }) => segment).filter((word) => /\p{L}/u.test(word)),
  );
  return flesch({
    sentence: sentences.length,
    word: words.length,
    syllable: words.reduce((sum, word) => sum + Math.max(1, syllable(word)), 0),
  });
}
