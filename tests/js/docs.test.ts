import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import { chapter, pages } from "../../docs/.vitepress/planners";
import { PAGES, reference } from "../../docs/.vitepress/reference";
import { WORDS } from "../../docs/.vitepress/words";
import { declared } from "./declared.mjs";
import { installed, parkade } from "./pack";

const DOCS = fileURLToPath(new URL("../../docs/", import.meta.url));
let folder = "";
beforeAll(() => {
  folder = installed();
}, 120_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

interface Sample {
  where: string;
  language: string;
  code: string;
}

const samplesOf = (where: string, text: string): Sample[] =>
  [...text.matchAll(/```(\w+)\n([^]*?)```/g)].map(([, language, code]) => ({
    where,
    language: language!,
    code: code!,
  }));

/** Pages that the site's build writes; their scripts are run from what they are made of. */
const GENERATED = /^api\/js|^(zh\/)?(planners\/(?!how-tight)|papers\/(?!coverage))/;

const written = readdirSync(DOCS, { recursive: true, encoding: "utf8" })
  .filter((file) => file.endsWith(".md") && !file.includes(".vitepress") && !GENERATED.test(file))
  .flatMap((file) => samplesOf(file, readFileSync(join(DOCS, file), "utf8")));

/** Runs a script and gives what it prints, and what comments behind `console.log` say that it prints. */
function run(code: string): { printed: string[]; expected: string[] } {
  writeFileSync(join(folder, "sample.mjs"), code);
  const printed = execFileSync(process.execPath, ["sample.mjs"], { cwd: folder, encoding: "utf8" }).trim().split("\n");
  const logs = code.split("\n").filter((line) => line.includes("console.log"));
  return { printed, expected: logs.map((line, i) => /\/\/ (.*)$/.exec(line)?.[1] ?? printed[i]!) };
}

test.each(written.filter(({ language }) => language === "js").map(({ where, code }, i) => [`${where}, ${i}`, code]))(
  "the script in %s prints what it says",
  (_, code) => {
    const { printed, expected } = run(code!);
    expect(printed).toEqual(expected);
  },
);

/** A page without its words: headings' levels, figures' attributes but their language, code, and formulas. */
const skeletonOf = (text: string): string[] =>
  [...text.matchAll(/^#+ |<parkade-playground [^>]*>|```\w+\n[^]*?```|^\$\$\n[^]*?\n\$\$$/gm)].map(([one]) =>
    one.replace(/ (lang|alt)="[^"]*"/g, ""),
  );

test("the Chinese guide has the sections, figures and scripts of the English one", () => {
  const [en, zh] = ["guide.md", "zh/guide.md"].map((file) => skeletonOf(readFileSync(join(DOCS, file), "utf8")));
  expect(en!.length).toBeGreaterThan(10);
  expect(zh).toEqual(en);
});

test("every planner's Chinese page has the figure, formulas, script and settings of the English one", async () => {
  const [en, zh] = await Promise.all([pages("en"), pages("zh")]);
  const settings = (content: string) => [...content.matchAll(/^\| `(\w+)`/gm)].map(([, name]) => name);
  expect(zh.map(({ params }) => params.id)).toEqual(en.map(({ params }) => params.id));
  en.forEach(({ params, content }, i) => {
    const own = zh[i]!.content;
    expect([params.id, skeletonOf(own), settings(own)]).toEqual([params.id, skeletonOf(content), settings(content)]);
    expect(own.match(/[\u4e00-\u9fff]/g)!.length).toBeGreaterThan(250);
  });
});

/**
 * What a translation leaves as it is, sorted: code, numbers; and how many paragraphs, items and words in bold there
 * are.
 */
const fixedOf = (text: string) => ({
  kept: [/`[^`]+`/g, /\d+(\.\d+)?/g].map((what) => [...text.matchAll(what)].map(([one]) => one).sort()),
  parts: [/\n\n/g, /^\* /gm, /\*\*[^*]+\*\*/g].map((what) => [...text.matchAll(what)].length),
});

test.each(Object.keys(WORDS))("the Chinese chapter on %s has the code and the numbers of the English one", (id) => {
  expect(fixedOf(chapter(id, "zh"))).toEqual(fixedOf(chapter(id, "en")));
});

test("every planner's script finds a path", async () => {
  const scripts = (await pages("en")).flatMap(({ params, content }) =>
    samplesOf(params.id, content).filter(({ language }) => language === "js"),
  );
  expect(scripts.length).toBeGreaterThanOrEqual(15);
  for (const { where, code } of scripts)
    expect([where, run(code).printed[0]]).toEqual([where, expect.stringMatching(/^found \d/)]);
}, 120_000);

test.each(
  written
    .filter(({ language }) => language === "sh")
    .flatMap(({ code }) => code.trim().split("\n"))
    .filter((line) => line.startsWith("npx parkade")),
)("`%s` works", (line) => {
  const { status, err } = parkade(
    line.split(/\s+#/)[0]!.split(/\s+/).slice(2),
    folder,
    "",
    join(folder, "node_modules/parkade/cli/main.js"),
  );
  expect([status, err]).toEqual([0, ""]);
});

test("every sample is of a kind that is run or only shown", () => {
  const kinds = new Set(written.map(({ language }) => language));
  // html runs in the browser's tests, rust in cargo's; css is the example book's; sql and python in the
  // tests of Python; text, toml and yaml belong to other programs.
  expect(
    [...kinds].filter(
      (kind) => !["js", "sh", "html", "rust", "css", "text", "toml", "yaml", "python", "sql"].includes(kind),
    ),
  ).toEqual([]);
  expect(readFileSync(new URL("../../README.md", import.meta.url), "utf8")).toContain(
    written.find(({ language }) => language === "rust")!.code,
  );
  const book = readFileSync(new URL("../../examples/mdbook/parkade.css", import.meta.url), "utf8");
  expect(book.replace(/\s+/g, " ")).toContain(written.find(({ language }) => language === "css")!.code.trim());
});

test("the reference has a page for every exported name, with what the types say of it", () => {
  const names = new Set(
    ["index.d.ts", "settings.d.ts"].flatMap((file) => {
      const { types, values } = declared(fileURLToPath(new URL(`../../packages/parkade/${file}`, import.meta.url)));
      return [...types, ...values];
    }),
  );
  const listed = reference().flatMap(({ items }) => items!.map(({ text: name }) => name));
  expect(new Set(listed)).toEqual(names);
  const page = (path: string): string => readFileSync(join(PAGES, path), "utf8");
  expect(page("classes/Planner.md")).toContain("\\[dispose\\]()");
  expect(page("functions/toSVG.md")).toMatch(/A picture of a scene/);
  expect(page("functions/reedsShepp.md")).toMatch(/turning radius in metres/);
});
