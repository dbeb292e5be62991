import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import { build as esbuild } from "esbuild";
import { build as vite } from "vite";
import { Planner, generateScenario, init, scenarios, version, type Plan } from "parkade";
import { PACKAGE, installed, npm, parkade } from "./pack";

/** The README's only JavaScript; a comment behind `console.log` is what it prints. */
const SCRIPT = /```js\n([^]*?)```/.exec(readFileSync(new URL("../../README.md", import.meta.url), "utf8"))![1]!;
const PRINTED = [...SCRIPT.matchAll(/console\.log.*\/\/ (.*)/g)].map((match) => match[1]);
const HASHES: Record<string, Record<string, string>> = JSON.parse(readFileSync(new URL("../data/plan-hashes.json", import.meta.url), "utf8"));

let folder = "";
const run = (script: string, ...args: string[]) => execFileSync(process.execPath, [script, ...args], { cwd: folder, encoding: "utf8" });
const write = (name: string, text: string) => writeFileSync(join(folder, name), text);

beforeAll(async () => {
  await init();
  folder = installed();
}, 120_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

test("the packed package, installed into an empty folder, runs the README's lines in Node", () => {
  write("plan.mjs", SCRIPT);
  expect(PRINTED.length).toBeGreaterThan(0);
  expect(run("plan.mjs").trim().split("\n")).toEqual(PRINTED);
});

test("a worker thread plans with the installed package", () => {
  write("worker.mjs", `
    import { Worker, isMainThread, parentPort } from "node:worker_threads";
    import { init, Planner, scenario } from "parkade";
    if (isMainThread) new Worker(new URL(import.meta.url)).on("message", (hash) => console.log(hash));
    else {
      await init();
      parentPort.postMessage(new Planner("hybrid", scenario("perpendicular")).plan().hash);
    }`);
  expect(run("worker.mjs").trim()).toBe(HASHES["perpendicular"]!["hybrid"]);
});

test("the installed command plans ten scenes as the library does", () => {
  const command = join(folder, "node_modules/.bin/parkade");
  expect(existsSync(command) || existsSync(`${command}.cmd`)).toBe(true);
  const presets = scenarios().map(({ id }) => id).filter((id) => HASHES[id]?.["eight"]);
  const drawn = Array.from({ length: 10 - presets.length }, (_, seed) => generateScenario({ family: "random", size: 21, seed }));
  drawn.forEach((scene, i) => write(`drawn-${i}.json`, JSON.stringify(scene)));
  const expected = [
    ...presets.map((id) => [id, HASHES[id]!["eight"]!] as const),
    ...drawn.map((scene, i) => [`drawn-${i}.json`, new Planner("eight", scene).plan().hash] as const),
  ];
  expect(expected).toHaveLength(10);
  for (const [place, hash] of expected) {
    const { status, out } = parkade(["plan", place, "--planner", "eight"], folder, "", join(folder, "node_modules/parkade/cli/main.js"));
    const plan: Plan = JSON.parse(out);
    expect([place, plan.hash, status]).toEqual([place, hash, plan.outcome === "found" ? 0 : 1]);
  }
});

/** A page's code: what it leaves in `answer` is what the bundle computed. */
const ENTRY = `import { init, Planner, scenario } from "parkade";
export async function answer(wasm) {
  await init({ wasm });
  return new Planner("hybrid", scenario("perpendicular")).plan().hash;
}`;

async function answerOf(bundle: string): Promise<string> {
  const { answer } = (await import(/* @vite-ignore */ pathToFileURL(bundle).href)) as { answer(wasm: Uint8Array): Promise<string> };
  return answer(readFileSync(join(folder, "node_modules/parkade/parkade_bg.wasm")));
}

test("esbuild bundles the browser's entry, without anything of Node", async () => {
  write("entry.js", ENTRY);
  const outfile = join(folder, "esbuild/entry.mjs");
  await esbuild({ absWorkingDir: folder, entryPoints: ["entry.js"], bundle: true, minify: true, format: "esm", platform: "browser", outfile, logLevel: "silent" });
  expect(readFileSync(outfile, "utf8")).not.toMatch(/node:|tinypool/);
  expect(await answerOf(outfile)).toBe(HASHES["perpendicular"]!["hybrid"]);
});

test("Vite bundles the browser's entry and takes the module along", async () => {
  write("entry.js", ENTRY);
  write("index.html", '<script type="module">import { answer } from "./entry.js"; document.title = await answer();</script>');
  await vite({ root: folder, configFile: false, logLevel: "silent", build: { outDir: "vite", target: "es2022" } });
  const assets = readdirSync(join(folder, "vite/assets"));
  expect(assets.filter((name) => name.endsWith(".wasm"))).toHaveLength(1);
  await vite({ root: folder, configFile: false, logLevel: "silent", build: { outDir: "vite-lib", target: "es2022", assetsInlineLimit: 0, lib: { entry: "entry.js", formats: ["es"], fileName: () => "entry.mjs" } } });
  expect(await answerOf(join(folder, "vite-lib/entry.mjs"))).toBe(HASHES["perpendicular"]!["hybrid"]);
});

test("a bundle that uses no planner leaves them out", async () => {
  write("small.js", 'export { packRuns } from "parkade";');
  write("large.js", 'export * from "parkade";');
  const size = async (entry: string) => {
    const { outputFiles } = await esbuild({ absWorkingDir: folder, entryPoints: [entry], bundle: true, minify: true, format: "esm", platform: "browser", write: false, logLevel: "silent" });
    return outputFiles[0]!.contents.length;
  };
  expect(await size("small.js")).toBeLessThan((await size("large.js")) / 4);
});

test("strict TypeScript accepts good use of the types and refuses bad", () => {
  const tsc = fileURLToPath(new URL("../../node_modules/typescript/bin/tsc", import.meta.url));
  const check = (name: string, text: string) => {
    write(name, text);
    const flags = ["--strict", "--noEmit", "--target", "es2022", "--lib", "es2023,esnext.disposable,dom", "--module", "nodenext", "--moduleResolution", "nodenext", "--types", "", "--exactOptionalPropertyTypes", "--noUncheckedIndexedAccess"];
    try {
      return execFileSync(process.execPath, [tsc, ...flags, name], { cwd: folder, encoding: "utf8" });
    } catch (error) {
      return String((error as { stdout: string }).stdout);
    }
  };
  expect(check("good.ts", `import { init, Planner, scenario, toSVG, type Plan, type Scenario } from "parkade";
    await init();
    const scene: Scenario = scenario("perpendicular");
    const plan: Plan = new Planner("hybrid", scene, { reverseCost: 1.5 }).plan({ trace: false });
    const svg: string = toSVG(scene, [plan], { width: 300, height: 200 });
    export const x: number | undefined = plan.path[0] ?? svg.length;`)).toBe("");
  const refused = check("bad.ts", 'import { Planner, scenario } from "parkade";\nexport const plan = new Planner("hybird", scenario(3)).plan().lenght;');
  expect(refused).toMatch(/hybird/);
  expect(refused).toMatch(/lenght/);
});

test("the package and the module in it are of one version", () => {
  const manifest = JSON.parse(readFileSync(join(PACKAGE, "package.json"), "utf8"));
  expect(version()).toBe(manifest.version);
});

test("the package holds every file that it names", () => {
  const manifest = JSON.parse(readFileSync(join(PACKAGE, "package.json"), "utf8"));
  const [packed] = JSON.parse(npm(["pack", "--json", "--dry-run"], PACKAGE));
  const paths: string[] = packed.files.map((file: { path: string }) => file.path);
  expect(paths.sort()).toEqual(["package.json", ...manifest.files].sort());
});
