/** A page as blocks, written as Markdown or as HTML. Text in blocks is plain, but for `code`. */
export type Lang = "en" | "zh";

export interface Figure {
  /** Names the file of its picture. */
  id: string;
  scene: string;
  planners: readonly string[];
  /** What is drawn over the map besides paths. */
  draws?: "stages" | "potential" | "marks";
  caption: string;
  /** A picture that shows no scene. */
  svg?: string;
}

export type Block =
  | { kind: "heading"; level: 1 | 2 | 3; text: string }
  | { kind: "text"; text: string }
  | { kind: "list"; items: string[] }
  | { kind: "table"; head: string[]; rows: string[][] }
  | { kind: "figure"; figure: Figure };

export const heading = (level: 1 | 2 | 3, text: string): Block => ({ kind: "heading", level, text });
export const text = (words: string): Block => ({ kind: "text", text: words });
export const list = (items: string[]): Block => ({ kind: "list", items });
export const table = (head: string[], rows: (string | number)[][]): Block => ({
  kind: "table",
  head,
  rows: rows.map((row) => row.map(String)),
});
export const figure = (one: Figure): Block => ({ kind: "figure", figure: one });

const cell = (words: string): string => words.replaceAll("|", "\\|");

/** `show` writes a figure. */
export function markdown(blocks: readonly Block[], show: (figure: Figure) => string): string {
  return `${blocks
    .map((block) => {
      switch (block.kind) {
        case "heading":
          return `${"#".repeat(block.level)} ${block.text}`;
        case "text":
          return block.text;
        case "list":
          return block.items.map((item) => `* ${item}`).join("\n");
        case "table":
          return [block.head, block.head.map(() => "---"), ...block.rows]
            .map((row) => `| ${row.map(cell).join(" | ")} |`)
            .join("\n");
        case "figure":
          return show(block.figure);
      }
    })
    .join("\n\n")}\n`;
}

export const escaped = (words: string): string =>
  words.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
const inline = (words: string): string => escaped(words).replace(/`([^`]+)`/g, "<code>$1</code>");

/** `picture` gives a figure's SVG. */
export function html(blocks: readonly Block[], picture: (figure: Figure) => string): string {
  return blocks
    .map((block) => {
      switch (block.kind) {
        case "heading":
          return `<h${block.level}>${inline(block.text)}</h${block.level}>`;
        case "text":
          return `<p>${inline(block.text)}</p>`;
        case "list":
          return `<ul>${block.items.map((item) => `<li>${inline(item)}</li>`).join("")}</ul>`;
        case "table":
          return `<table><thead><tr>${block.head.map((one) => `<th>${inline(one)}</th>`).join("")}</tr></thead><tbody>${block.rows.map((row) => `<tr>${row.map((one) => `<td>${inline(one)}</td>`).join("")}</tr>`).join("")}</tbody></table>`;
        case "figure":
          return `<figure>${picture(block.figure)}<figcaption>${inline(block.figure.caption)}</figcaption></figure>`;
      }
    })
    .join("\n");
}
