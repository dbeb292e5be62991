// With the word "comparison" prints the comparison with other algorithms as Markdown, with "verdicts" every claim and
// how it is judged, without a figure that a clock measures; otherwise: Writes every paper's tables, claims and figures
// into one Markdown and one HTML file, in English and Chinese.
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";

const root = fileURLToPath(new URL("../../", import.meta.url)),
  out = process.argv[2] ?? join(root, "target/papers");
const {
  module: { compared, pages, verdicts, markdown, html, escaped, figuresOfScenes, picture },
} = await runnerImport(join(root, "docs/.vitepress/papers/index.ts"), { configFile: false, root, logLevel: "error" });
if (process.argv[2] === "comparison") {
  for (const lang of ["en", "zh"])
    console.log(markdown(await compared(lang), (/** @type {any} */ figure) => `*${figure.caption}*`));
  process.exit();
}
const seeds = Number(process.argv[3] ?? 20);
if (process.argv[2] === "verdicts") {
  for (const lang of ["en", "zh"]) console.log(markdown(await verdicts(lang, seeds), () => ""));
  process.exit();
}
const languages = [
  ["en", await pages("en", seeds)],
  ["zh", await pages("zh", seeds)],
];

mkdirSync(join(out, "figures"), { recursive: true });
/** @type {Map<string, string>} */
const drawn = new Map();
/** A figure's SVG; a scene's is the same in both languages. */
const svgOf = (/** @type {string} */ lang, /** @type {any} */ figure) => {
  const id = figure.svg === undefined ? figure.id : `${figure.id}-${lang}`;
  let svg = drawn.get(id);
  if (svg === undefined) {
    drawn.set(id, (svg = picture(figure)));
    writeFileSync(join(out, "figures", `${id}.svg`), svg);
  }
  return { id, svg };
};
const text = languages.flatMap(([lang, all]) =>
  all.map(({ blocks }) => {
    const first = figuresOfScenes(blocks);
    return markdown(
      blocks,
      (/** @type {any} */ figure) =>
        `![${figure.caption}](figures/${svgOf(lang, figure).id}.svg)\n\n*${figure.caption}*`,
      (code) => (first.has(code) ? `[\`${code}\`](figures/${first.get(code)}.svg)` : `\`${code}\``),
    );
  }),
);
writeFileSync(join(out, "papers.md"), text.join("\n"));
const style =
  "body{font:14px/21px system-ui,'PingFang SC','Microsoft YaHei','Noto Sans " +
  "SC',sans-serif;max-width:980px;margin:24px auto;padding:0 " +
  "16px;color:#1b1d20}table{border-collapse:collapse;font-size:12px;margin:8px 0 " +
  "16px;font-variant-numeric:tabular-nums}th,td{border-top:1px solid #e3e3df;padding:4px " +
  "8px;text-align:left;vertical-align:top}figure{margin:16px " +
  "0}figcaption{color:#565b62;font-size:12.5px}svg{max-width:100%;height:auto}h1{margin-top:48px}";
const bodies = languages.map(
  ([lang, all]) =>
    `<div lang="${lang}">${all
      .map(
        ({ blocks }) =>
          `<section>${html(blocks, (/** @type {any} */ figure) => svgOf(lang, figure).svg, `${lang}-`)}</section>`,
      )
      .join("\n")}</div>`,
);
writeFileSync(
  join(out, "papers.html"),
  `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" ` +
    `content="width=device-width"><title>${escaped(
      "The papers, measured again",
    )}</title><style>${style}</style></head><body>${bodies.join("\n")}</body></html>`,
);
console.log(`${join(out, "papers.md")}\n${join(out, "papers.html")}\n${drawn.size} figures`);
