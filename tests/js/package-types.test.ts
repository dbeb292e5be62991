import { execFileSync } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import { installed } from "./pack";

let folder = "";
const write = (name: string, text: string) => writeFileSync(join(folder, name), text);

beforeAll(() => {
  folder = installed();
}, 120_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const TSC = fileURLToPath(new URL("../../node_modules/typescript/bin/tsc", import.meta.url));

/** What the compiler complains about in a file. */
function check(name: string, text: string, module = "nodenext", resolution = module): string {
  write(name, text);
  const flags = [
    "--strict",
    "--noEmit",
    "--target",
    "es2022",
    "--lib",
    "es2023,esnext.disposable,dom",
    "--module",
    module,
    "--moduleResolution",
    resolution,
    "--types",
    "",
    "--exactOptionalPropertyTypes",
    "--noUncheckedIndexedAccess",
  ];
  try {
    return execFileSync(process.execPath, [TSC, ...flags, name], { cwd: folder, encoding: "utf8" });
  } catch (error) {
    return String((error as { stdout: string }).stdout);
  }
}

test("the types are found by modules and by CommonJS, as old and new compilers resolve them", () => {
  const text =
    'import { init, Planner, type Scenario } from "parkade";\nexport const plan = (scene: Scenario) => ' +
    'init().then(() => new Planner("hybrid", scene).plan());';
  for (const module of ["node16", "node18", "nodenext"]) {
    for (const name of ["types.cts", "types.mts"])
      expect([module, name, check(name, text, module, module === "node18" ? "node16" : module)]).toEqual([
        module,
        name,
        "",
      ]);
  }
  expect(check("types.ts", text, "esnext", "bundler")).toBe("");
  expect(check("inline.ts", text.replace('"parkade"', '"parkade/inline"'))).toBe("");
});

test.each(["guide.md", "zh/guide.md"])("the scripts of %s are strict TypeScript as they stand", (file) => {
  const guide = readFileSync(new URL(`../../docs/${file}`, import.meta.url), "utf8");
  const scripts = [...guide.matchAll(/```js\n([^]*?)```/g)].map(([, code]) => code!);
  expect(scripts.length).toBeGreaterThan(3);
  scripts.forEach((code, i) => expect([i, check(`guide-${i}.mts`, code)]).toEqual([i, ""]));
});

test("`parkade/core` has types of its own: what it lacks does not compile", () => {
  expect(
    check(
      "core.ts",
      `import { Planner, init, scenario, type Scenario } from "parkade/core";
    await init();
    const scene: Scenario = { ...scenario("perpendicular"), vehicle: "sedan" };
    export const plan = new Planner("hybrid", scene, { reverseCost: 2 }).plan({ trace: true });`,
    ),
  ).toBe("");
  const refused = check(
    "core-bad.ts",
    `import { Planner, scenario, toSVG, type Scenario } from "parkade/core";
    export const plan = new Planner("cost-map", scenario("a")), scene: Scenario = { ...scenario("a"), vehicle: "ship" };
    export const eight = new Planner("eight", scenario("a"), { stop: "nba" });
    export const layer = eight.layer("cost"), found = eight.search({ x: 0, y: 0 }, { x: 1, y: 1 });
    export const best = eight.plan({ prefer: "widest" });`,
  );
  for (const what of ["toSVG", "cost-map", "ship", "stop", '"cost"', "search", "prefer"])
    expect(refused).toContain(what);
});

test("settings are typed by planner, figures by family, and errors by code", () => {
  expect(
    check(
      "typed.ts",
      `import { defaultConfig, ParkadeError, Planner, type Plan, type Scenario } from "parkade";
    declare const scene: Scenario, any: Plan, error: ParkadeError;
    export const clearance: number | undefined = new Planner("eight", scene, { post: "smooth", minRadius: "vehicle" ` +
        `}).plan().metrics.lengthRaw;
    export const gap: number | undefined = new Planner("hybrid", scene, { margin: 0.2, xyResolution: null ` +
        `}).plan().metrics.gapPercent;
    export const moved = any.planner === "cost-map" ? any.metrics.startMoved : any.metrics.length;
    export const factor: number = defaultConfig("cost-map").factor, weight: "none" | "distance" = ` +
        `defaultConfig("four").weight;
    export const isMine = error.code === "bad-config";`,
    ),
  ).toBe("");
  const refused = check(
    "typed-bad.ts",
    `import { Planner, ParkadeError, type Plan, type Scenario } from "parkade";
    declare const scene: Scenario, any: Plan, error: ParkadeError;
    new Planner("eight", scene, { reverseCost: 1 });
    new Planner("hybrid", scene, { profile: "sporty" });
    export const raw = any.metrics.lengthRaw, gap = new Planner("four", scene).plan().metrics.gapPercent;
    export const wrong = error.code === "bad-luck", never = any.outcome === "interrupted";`,
  );
  for (const what of ["reverseCost", "sporty", "lengthRaw", "gapPercent", "bad-luck", "interrupted"])
    expect(refused).toContain(what);
});

test("strict TypeScript accepts good use of the types and refuses bad", () => {
  expect(
    check(
      "good.ts",
      `import { init, Planner, scenario, toSVG, type Plan, type Scenario } from "parkade";
    await init();
    const scene: Scenario = scenario("perpendicular");
    const plan: Plan = new Planner("hybrid", scene, { reverseCost: 1.5 }).plan({ trace: false });
    const svg: string = toSVG(scene, [plan], { width: 300, height: 200 });
    export const x: number | undefined = plan.path[0] ?? svg.length;`,
    ),
  ).toBe("");
  const refused = check(
    "bad.ts",
    'import { Planner, scenario } from "parkade";\nexport const plan = new Planner("hybird", ' +
      "scenario(3)).plan().lenght;",
  );
  expect(refused).toMatch(/hybird/);
  expect(refused).toMatch(/lenght/);
});
