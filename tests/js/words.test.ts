import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { init, planners } from "parkade";
import { describe, expect, it } from "vitest";
const ROOT = join(import.meta.dirname, "../../www/src");
const sources = new Map(
  readdirSync(ROOT, { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(".ts"))
    .map((name) => [join(ROOT, name), readFileSync(join(ROOT, name), "utf8")]),
);
const FOLDER = join(ROOT, "i18n/messages");
type Messages = Record<string, [en: string, zh: string]>;
const read = (name: string): Messages => JSON.parse(readFileSync(join(FOLDER, name), "utf8")) as Messages;
/** The catalogue, file by file. */
const files = new Map(readdirSync(FOLDER).map((name) => [name, read(name)]));
const all = [...files].flatMap(([name, table]) =>
  Object.entries(table).map(([key, [en, zh]]) => ({ name, key, en, zh })),
);
const known = new Set(all.map(({ key }) => key));

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

/** Keys that are put together from the names of verdicts, sides, tables and scenes. */
const MADE =
  /^(status|brief)\.|^lot\.\w+Side$|^papers\.\w+Lead$|^papersVolumes\.(aabb|obb|ball)$|^papersRoad\.(S3|inverse)$/;

describe("the page's words", () => {
  it("are none of those that read as translated", () => {
    expect(all.length).toBeGreaterThan(700);
    expect(all.filter(({ en }) => BANNED.some((word) => word.test(en)))).toEqual([]);
  });

  it("name every choice of the planners' settings", async () => {
    await init();
    const ids = planners().map(({ id }) => id as string),
      choices = new Set(planners().flatMap(({ parameters }) => parameters.flatMap((one) => one.choices ?? [])));
    expect(choices.size).toBeGreaterThan(30);
    expect([...choices].filter((choice) => !known.has(`choice.${choice}`) && !ids.includes(choice))).toEqual([]);
  });

  it("are Chinese in Chinese", () => {
    // Names, formats and units that Chinese engineers write in Latin letters.
    const names =
      "Parkade|English|Markdown|Node|PNG|SVG|DXF|CSV|JSON|MovingAI|ROS|Reeds|Shepp|TPCAP|NBA|RRT|Dijkstra|exp|Bd|" +
      "L_aa|Ctrl|kB|MB|ms|mm|cm|AABB|OBB|FITPACK|SciPy|splprep|Posthoc|GIF|MP4|WebM|px|Page Down|Page Up|" +
      "Felzenszwalb|Huttenlocher|Hu|auto|true|false|cargo xtask paper grid|\\{[^}]*\\}";
    const plain = (text: string): string => text.replaceAll(new RegExp(names, "g"), "");
    expect(all.filter(({ zh }) => /[A-Za-z]{2,}/.test(plain(zh))).map(({ key, zh }) => [key, zh])).toEqual([]);
    expect(all.filter(({ en, zh }) => en === zh && /[A-Za-z]{2,}/.test(plain(en))).map(({ key }) => key)).toEqual([]);
  });

  it("stand once in the catalogue, with the same values in both languages", () => {
    expect(known.size).toBe(all.length);
    const values = (text: string): string[] =>
      [...new Set([...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name!))].sort();
    for (const { key, en, zh } of all) expect(values(zh), key).toEqual(values(en));
  });

  it("stand nowhere else", () => {
    // The button that changes the language has both on it; in a citation one word is replaced; marks join a reason's
    // parts.
    const marks = ["panels/toolbar.ts", "panels/toolbar-menus.ts", "i18n/reasons-zh.ts"];
    const own = [...sources]
      .filter(([, source]) => /[\u4e00-\u9fff]/.test(source))
      .map(([file]) => file.slice(ROOT.length + 1));
    expect(own.sort()).toEqual(marks.sort());
  });

  it("come with the script that says them", () => {
    const modules = first(join(ROOT, "main.ts"));
    expect(modules.size).toBeGreaterThan(50);
    const text = [...modules].map((file) => sources.get(file)).join("\n");
    const others = all.filter(({ name }) => name !== "first.json");
    expect(others.filter(({ key }) => text.includes(`"${key}"`)).map(({ key }) => key)).toEqual([]);
    expect(
      [...modules].filter((file) => /messages\/(?!first)/.test(sources.get(file)!.replace(/import type.*/g, ""))),
    ).toEqual([]);
  });

  it("are all said", () => {
    const text = [...sources.values()].join("\n");
    const taken = (pattern: RegExp): Set<string> => new Set([...text.matchAll(pattern)].map(([, one]) => one!));
    const quoted = taken(/"([\w. +-]+)"/g),
      made = taken(/`(\w+)\.\$\{/g),
      spoken = taken(/\btranslator(?:At)?\("(\w+)"/g),
      plain = taken(/\b(\w+)\b/g);
    const said = (key: string): boolean => {
      const [prefix = "", ...rest] = key.split("."),
        name = rest.join(".");
      if (quoted.has(key) || made.has(prefix) || MADE.test(key)) return true;
      return spoken.has(prefix) && (prefix === "claim" || quoted.has(name) || plain.has(name));
    };
    expect(all.filter(({ key }) => !said(key)).map(({ key }) => key)).toEqual([]);
  });
});
