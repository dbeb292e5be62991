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

/** Chunks that a lower room fetches when somebody opens them; each stands for a piece of the page above it. */
const FETCHED = ["app/app.ts > panels/hints"];

interface Import {
  file: string;
  target: string;
  isFetched: boolean;
}

const roomOf = (path: string): string => path.split("/")[0]!;

function importsOf(file: string): Import[] {
  const text = readFileSync(join(SOURCES, file), "utf8").replace(/\/\*[\s\S]*?\*\/|^\s*\/\/.*$/gm, "");
  return [...text.matchAll(/(?:\bfrom|^import)\s*"(\.[^"]+)"|(?<!typeof )\bimport\(\s*"(\.[^"]+)"/gm)].map(
    ([, named, fetched]) => ({
      file,
      target: relative(SOURCES, join(SOURCES, dirname(file), (named ?? fetched)!)),
      isFetched: named === undefined,
    }),
  );
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
    const upward = imports.filter(isUpward);
    expect(upward.filter(({ isFetched }) => !isFetched)).toEqual([]);
    expect(upward.map(({ file, target }) => `${file} > ${target}`).sort()).toEqual(FETCHED);
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
