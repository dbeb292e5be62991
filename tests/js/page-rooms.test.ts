/** The page's folders import in one direction; `DESIGN.md` lists them in the same order. */
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { FIRST_PLANNERS } from "../../www/src/store";
import { ALL_LAYERS, LAYERS, LAYER_PRESETS, presetLayers, presetOf } from "../../www/src/store/layer-sets";

const SOURCES = fileURLToPath(new URL("../../www/src", import.meta.url));

/** Lowest first: a file imports from its own folder and from those before it. */
const ROOMS = [
  "i18n",
  "styles",
  "scene",
  "siteplan",
  "store",
  "planning",
  "view",
  "picture",
  "texts",
  "tools",
  "app",
  "panels",
  "element",
];

interface Import {
  file: string;
  target: string;
}

const roomOf = (path: string): string => path.split("/")[0]!;

/** Types and what is fetched later count as well. */
function importsOf(file: string): Import[] {
  const text = readFileSync(join(SOURCES, file), "utf8").replace(/\/\*[\s\S]*?\*\/|^\s*\/\/.*$/gm, "");
  return [...text.matchAll(/(?:\bfrom|^import|\bimport\()\s*"(\.[^"]*)"/gm)].map(([, path = ""]) => ({
    file,
    target: relative(SOURCES, join(SOURCES, dirname(file), path)).replaceAll("\\", "/"),
  }));
}

/** The files of one way round; empty where there is none. */
function roundIn(imports: readonly Import[]): string[] {
  const targets = new Map<string, Import[]>();
  for (const one of imports) targets.set(one.file, [...(targets.get(one.file) ?? []), one]);
  const done = new Set<string>(),
    way: string[] = [];
  const from = (file: string): string[] => {
    const at = way.indexOf(file);
    if (at >= 0) return [...way.slice(at), file];
    if (done.has(file)) return [];
    way.push(file);
    for (const { target } of targets.get(file) ?? []) {
      const round = [`${target}.ts`, `${target}/index.ts`].filter((name) => targets.has(name)).flatMap(from);
      if (round.length > 0) return round;
    }
    way.pop();
    done.add(file);
    return [];
  };
  for (const file of targets.keys()) {
    const round = from(file);
    if (round.length > 0) return round;
  }
  return [];
}

const files = readdirSync(SOURCES, { recursive: true, encoding: "utf8" })
  .map((file) => file.replaceAll("\\", "/"))
  .filter((file) => file.endsWith(".ts") && file.includes("/"));
const imports = files.flatMap(importsOf);

describe("the page's rooms", () => {
  it("are those that the order names", () => {
    expect(new Set(files.map(roomOf))).toEqual(new Set(ROOMS));
    expect(imports.length).toBeGreaterThan(500);
  });

  it("import from rooms before them only", () => {
    const isUpward = ({ file, target }: Import) =>
      ROOMS.includes(roomOf(target)) && ROOMS.indexOf(roomOf(target)) > ROOMS.indexOf(roomOf(file));
    expect(imports.filter(isUpward)).toEqual([]);
  });

  it("have no files that import each other, by whatever way round", () => {
    expect(roundIn(imports)).toEqual([]);
    // The search itself finds a way round, and none where ways only meet again.
    const chain = (...names: string[]) => names.slice(1).map((target, i) => ({ file: `${names[i]}.ts`, target }));
    expect(roundIn([...chain("a", "b", "d"), ...chain("a", "c", "d")])).toEqual([]);
    expect(roundIn([...chain("a", "b", "c", "d", "b"), ...chain("a", "c")])).toEqual(["b.ts", "c.ts", "d.ts", "b.ts"]);
  });

  it("stand in DESIGN.md in the same order", () => {
    const design = readFileSync(new URL("../../DESIGN.md", import.meta.url), "utf8");
    expect(design).toContain(`\`${ROOMS.join(" → ")}\``);
  });
});

describe("facts of planners", () => {
  it("come from the module, not from a comparison of ids", () => {
    const ids = FIRST_PLANNERS.concat("hybrid-forward", "hybrid-bidirectional", "hybrid-classic", "cost-map").join("|");
    const compared = new RegExp(`(?<!family )([!=]==|startsWith\\(|\\.test\\()\\s*["/^]*(${ids})\\b`);
    const found = files.filter((file) => compared.test(readFileSync(join(SOURCES, file), "utf8")));
    expect(found).toEqual([]);
  });
});

describe("layers", () => {
  it("have a bit each, the same for ever", () => {
    const bits = Object.fromEntries(ALL_LAYERS.map((key) => [LAYERS[key].bit, key]));
    expect(Object.values(bits).join(" ")).toBe(
      "slots obstacles safety redundant cost heat risk tree sweep path car ghosts grid difference",
    );
    expect(Object.keys(bits).length).toBe(ALL_LAYERS.length);
  });

  it("of a set are told from those of the others", () => {
    for (const preset of LAYER_PRESETS) expect(presetOf(presetLayers(preset))).toBe(preset);
  });
});
