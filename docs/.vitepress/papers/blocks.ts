/** A page as blocks, written as Markdown or as HTML. Text in blocks is plain, but for `code`. */
export type Lang = "en" | "zh";

export interface Figure {
  /** Names the file of its picture. */
  id: string;
  scene: string;
  planners: readonly string[];
  /** What is drawn over the map besides paths, or in their place. */
  draws?: "pruned" | "tangents" | "smoothed" | "spaces" | "potential" | "marks";
  caption: string;
  /** What the printed figure shows, and what is different here. */
  printed?: string;
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

/** The heads of a table of claims. */
const VERDICTS: readonly (string | undefined)[] = ["verdict", "判定"];
export const isClaims = (block: Block): boolean => block.kind === "table" && VERDICTS.includes(block.head[1]);

const cell = (words: string): string => words.replaceAll("|", "\\|");

/** `show` writes a figure; `named` writes what stands as `code`, such as a scene's name. */
export function markdown(
  blocks: readonly Block[],
  show: (figure: Figure) => string,
  named: (code: string) => string = (code) => `\`${code}\``,
): string {
  const linked = (words: string): string => words.replace(/`([^`]+)`/g, (_, code: string) => named(code));
  return `${blocks
    .map((block) => {
      switch (block.kind) {
        case "heading":
          return `${"#".repeat(block.level)} ${block.text}`;
        case "text":
          return linked(block.text);
        case "list":
          return block.items.map((item) => `* ${linked(item)}`).join("\n");
        case "table":
          return [block.head, block.head.map(() => "---"), ...block.rows]
            .map((row) => `| ${row.map((one) => linked(cell(one))).join(" | ")} |`)
            .join("\n");
        case "figure":
          return [show(block.figure), ...(block.figure.printed ? [linked(block.figure.printed)] : [])].join("\n\n");
      }
    })
    .join("\n\n")}\n`;
}

export const escaped = (words: string): string =>
  words.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

/** Per scene the figure that leads to it: that of its name, or else the first that shows it. */
export function figuresOfScenes(blocks: readonly Block[]): Map<string, string> {
  const chosen = new Map<string, string>();
  for (const block of blocks)
    if (block.kind === "figure" && block.figure.scene) {
      const { scene, id } = block.figure;
      if (id === scene || !chosen.has(scene)) chosen.set(scene, id);
    }
  return chosen;
}

/** `picture` gives a figure's SVG; a scene's name leads to the scene's figure. Anchors begin with `prefix`. */
export function html(blocks: readonly Block[], picture: (figure: Figure) => string, prefix: string): string {
  const drawn = figuresOfScenes(blocks);
  const named = (code: string): string =>
    drawn.has(code) ? `<a href="#${prefix}${drawn.get(code)}"><code>${code}</code></a>` : `<code>${code}</code>`;
  const inline = (words: string): string => escaped(words).replace(/`([^`]+)`/g, (_, code: string) => named(code));
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
          return `<table><thead><tr>${block.head
            .map((one) => `<th>${inline(one)}</th>`)
            .join("")}</tr></thead><tbody>${block.rows
            .map((row) => `<tr>${row.map((one) => `<td>${inline(one)}</td>`).join("")}</tr>`)
            .join("")}</tbody></table>`;
        case "figure":
          return `<figure id="${prefix}${block.figure.id}">${picture(block.figure)}<figcaption>${inline(
            block.figure.caption,
          )}${block.figure.printed ? `<br>${inline(block.figure.printed)}` : ""}</figcaption></figure>`;
      }
    })
    .join("\n");
}
