/** The element's types name what the element has, and no more. */
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import { ATTRIBUTES, EVENTS, METHODS, READABLE, SETTABLE } from "../../www/src/element/public-api";
import { installed } from "./pack";

const here = (path: string) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const TYPES = readFileSync(here("packages/parkade/element.d.ts"), "utf8");
let folder = "";
beforeAll(() => {
  folder = installed();
}, 120_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** The names that stand first on an interface's lines. */
function namesIn(name: string): string[] {
  const body = new RegExp(`interface ${name}[^{]*\\{\n([^]*?)\n\\}`).exec(TYPES)![1]!;
  const names = [...body.matchAll(/^ {2}(?:readonly )?"?([\w-]+)"?\??(?:: |\()/gm)].map(([, one]) => one!);
  return [...new Set(names)].filter((one) => one !== "addEventListener").sort();
}

test("attributes, events, properties and methods are those of the element", () => {
  expect(namesIn("PlaygroundAttributes")).toEqual([...ATTRIBUTES, "poster", "alt", "loading", "reveal"].sort());
  expect(namesIn("PlaygroundEvents")).toEqual([...EVENTS].sort());
  const own = [...METHODS, ...READABLE, ...SETTABLE, "dismissPoster", "loaded", "ready"];
  expect(namesIn("ParkadePlayground")).toEqual(own.sort());
});

test("what editors read of the installed package names all of them", () => {
  const read = (name: string) => JSON.parse(readFileSync(join(folder, "node_modules/parkade", name), "utf8"));
  const names = (list: { name: string }[]) => list.map((one) => one.name).sort();
  const [{ declarations }] = read("custom-elements.json").modules;
  expect(names(declarations[0].attributes)).toEqual(namesIn("PlaygroundAttributes"));
  expect(names(declarations[0].events)).toEqual(namesIn("PlaygroundEvents"));
  expect(names(declarations[0].members)).toEqual(namesIn("ParkadePlayground"));
  const [element] = read("web-types.json").contributions.html.elements;
  expect(names(element.attributes)).toEqual(namesIn("PlaygroundAttributes"));
  expect(element.attributes.find((one: { name: string }) => one.name === "layout").value.type).toContain('"overlay"');
});

test("a strict program of the installed package uses them, and a wrong one does not compile", () => {
  const compile = (code: string): string => {
    writeFileSync(join(folder, "page.ts"), code);
    const options = [
      "--noEmit",
      "--strict",
      "--module",
      "nodenext",
      "--target",
      "es2022",
      "--lib",
      "es2023,dom,esnext.disposable",
    ];
    try {
      execFileSync(process.execPath, [here("node_modules/typescript/bin/tsc"), ...options, "page.ts"], {
        cwd: folder,
        encoding: "utf8",
      });
      return "";
    } catch (error) {
      return (error as { stdout: string }).stdout;
    }
  };
  const begin =
    'import type {} from "parkade/element";\nconst element = document.createElement("parkade-playground");\n';
  expect(
    compile(
      `${begin}element.addEventListener("plan-result", ({ detail }) => console.log(detail.plan?.hash));\nvoid ` +
        `element.seek(0.5).then(() => element.toSVG());\n`,
    ),
  ).toBe("");
  expect(compile(`${begin}element.sek(1);\n`)).toContain("'sek' does not exist");
  expect(compile(`${begin}element.playhead = "half";\n`)).toContain("not assignable to type 'number'");
});
