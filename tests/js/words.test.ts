import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { init, planners } from "parkade";
import { describe, expect, it } from "vitest";
import en from "../../www/src/i18n/en.json";
import later from "../../www/src/i18n/en-later.json";
import zh from "../../www/src/i18n/zh.json";

const ROOT = join(import.meta.dirname, "../../www/src");
const sources = new Map(
  readdirSync(ROOT, { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(".ts"))
    .map((name) => [join(ROOT, name), readFileSync(join(ROOT, name), "utf8")]),
);
const english: Record<string, string> = { ...en, ...later };

/** The modules that come with the page's first script. */
function first(file: string, seen = new Set<string>()): Set<string> {
  if (seen.has(file)) return seen;
  seen.add(file);
  for (const [, name] of sources.get(file)!.matchAll(/^(?:import|export) (?!type)(?:[^"';]*? from )?"(\.[^"]+)"/gm)) {
    const next = join(dirname(file), `${name}.ts`);
    if (sources.has(next)) first(next, seen);
  }
  return seen;
}

/** Every English text of the page: the tables and the pairs of its pieces. */
const texts: [where: string, text: string][] = [
  ...Object.entries(english),
  ...[...sources].flatMap(([file, source]) =>
    [...source.matchAll(/\["((?:[^"\\]|\\.)*)", "((?:[^"\\]|\\.)*[\u4e00-\u9fff][^"]*)"\]/g)].map(
      ([, text]): [string, string] => [file.slice(ROOT.length + 1), text!],
    ),
  ),
];

/** What the page once said, and words that no control is called by. */
const BANNED = [
  /arrangement/i,
  /one over another/i,
  /one large/i,
  /as the system/i,
  /^keys$/i,
  /stopped working/i,
  /either one/i,
  /touches something/i,
  /did not arrive/i,
  /the scene stays/i,
  /on one step/i,
  /what the timeline/i,
  /count the search/i,
  /\bone switch is worth/i,
  /by chance/i,
  /less half the width/i,
  /on the spot/i,
  /for ever/i,
  /hardly/i,
  /fold the table/i,
  /see-through/i,
  /bring it back/i,
  /\bshall\b/i,
  /gave up/i,
  /things and cells/i,
  /!$/,
];

describe("the page's words", () => {
  it("are none of those that read as translated", () => {
    expect(texts.length).toBeGreaterThan(500);
    expect(texts.filter(([, text]) => BANNED.some((word) => word.test(text)))).toEqual([]);
  });

  it("name every choice of the planners' settings", async () => {
    await init();
    const ids = planners().map(({ id }) => id as string),
      choices = new Set(planners().flatMap(({ parameters }) => parameters.flatMap((one) => one.choices ?? [])));
    expect(choices.size).toBeGreaterThan(30);
    expect([...choices].filter((choice) => !(`choice.${choice}` in english) && !ids.includes(choice))).toEqual([]);
  });

  it("are Chinese in Chinese", () => {
    // Names, formats and units that Chinese engineers write in Latin letters.
    const names =
      /Parkade|English|Markdown|Node|PNG|SVG|CSV|JSON|MovingAI|ROS|Reeds|Shepp|TPCAP|NBA|exp|Bd|L_aa|Ctrl|kB|ms|\{[^}]*\}/g;
    expect(Object.entries(zh).filter(([, text]) => /[A-Za-z]{2,}/.test(text.replaceAll(names, "")))).toEqual([]);
  });

  it("are all there in Chinese, with the same values", () => {
    expect(Object.keys(zh).sort()).toEqual(Object.keys(english).sort());
    const values = (text: string): string[] =>
      [...new Set([...text.matchAll(/\{(\w+)/g)].map(([, name]) => name!))].sort();
    for (const [key, text] of Object.entries(zh)) expect(values(text), key).toEqual(values(english[key]!));
    expect(Object.keys(later).filter((key) => key in en)).toEqual([]);
  });

  it("come with the script that says them", () => {
    const files = first(join(ROOT, "main.ts"));
    expect(files.size).toBeGreaterThan(50);
    const text = [...files].map((file) => sources.get(file)).join("\n");
    expect(Object.keys(later).filter((key) => text.includes(`"${key}"`))).toEqual([]);
  });

  it("are all said", () => {
    const text = [...sources.values()].join("\n");
    const said = (key: string): boolean =>
      text.includes(`"${key}"`) ||
      /^(status|brief)\./.test(key) ||
      [`\`${key.split(".")[0]}.\${`, `wordsAt("${key.split(".")[0]}")`].some((made) => text.includes(made));
    expect(Object.keys(english).filter((key) => !said(key))).toEqual([]);
  });
});
