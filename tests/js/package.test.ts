import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import { build as esbuild } from "esbuild";
import { rolldown } from "rolldown";
import { rollup } from "rollup";
import { build as vite, createServer } from "vite";
import { Planner, generateScenario, init, scenarios, version, type Plan } from "parkade";
import { PACKAGE, installed, npm, parkade } from "./pack";

/** The README's only JavaScript; a comment behind `console.log` is what it prints. */
const SCRIPT = /```js\n([^]*?)```/.exec(readFileSync(new URL("../../README.md", import.meta.url), "utf8"))![1]!;
const PRINTED = [...SCRIPT.matchAll(/console\.log.*\/\/ (.*)/g)].map((match) => match[1]);
const HASHES: Record<string, Record<string, string>> = JSON.parse(
  readFileSync(new URL("../data/plan-hashes.json", import.meta.url), "utf8"),
);

let folder = "";
const run = (script: string, ...args: string[]) =>
  execFileSync(process.execPath, [script, ...args], { cwd: folder, encoding: "utf8" });
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
  write(
    "worker.mjs",
    `
    import { Worker, isMainThread, parentPort } from "node:worker_threads";
    import { init, Planner, scenario } from "parkade";
    if (isMainThread) new Worker(new URL(import.meta.url)).on("message", (hash) => console.log(hash));
    else {
      await init();
      parentPort.postMessage(new Planner("hybrid", scenario("perpendicular")).plan().hash);
    }`,
  );
  expect(run("worker.mjs").trim()).toBe(HASHES["perpendicular"]!["hybrid"]);
});

test("the installed command plans ten scenes as the library does", () => {
  const command = join(folder, "node_modules/.bin/parkade");
  expect(existsSync(command) || existsSync(`${command}.cmd`)).toBe(true);
  const presets = scenarios()
    .map(({ id }) => id)
    .filter((id) => HASHES[id]?.["eight"]);
  const drawn = Array.from({ length: 10 - presets.length }, (_, seed) =>
    generateScenario({ family: "random", size: 21, seed }),
  );
  drawn.forEach((scene, i) => write(`drawn-${i}.json`, JSON.stringify(scene)));
  const expected = [
    ...presets.map((id) => [id, HASHES[id]!["eight"]!] as const),
    ...drawn.map((scene, i) => [`drawn-${i}.json`, new Planner("eight", scene).plan().hash] as const),
  ];
  expect(expected).toHaveLength(10);
  for (const [place, hash] of expected) {
    const { status, out } = parkade(
      ["plan", place, "--planner", "eight"],
      folder,
      "",
      join(folder, "node_modules/parkade/cli/main.js"),
    );
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
  const { answer } = (await import(/* @vite-ignore */ pathToFileURL(bundle).href)) as {
    answer(wasm: Uint8Array): Promise<string>;
  };
  return answer(readFileSync(join(folder, "node_modules/parkade/parkade_bg.wasm")));
}

test("esbuild bundles the browser's entry, without anything of Node", async () => {
  write("entry.js", ENTRY);
  const outfile = join(folder, "esbuild/entry.mjs");
  await esbuild({
    absWorkingDir: folder,
    entryPoints: ["entry.js"],
    bundle: true,
    minify: true,
    format: "esm",
    platform: "browser",
    outfile,
    logLevel: "silent",
  });
  expect(readFileSync(outfile, "utf8")).not.toMatch(/node:|tinypool/);
  expect(await answerOf(outfile)).toBe(HASHES["perpendicular"]!["hybrid"]);
});

test("Vite bundles the browser's entry and takes the module along", async () => {
  write("entry.js", ENTRY);
  write(
    "index.html",
    '<script type="module">import { answer } from "./entry.js"; document.title = await answer();</script>',
  );
  await vite({ root: folder, configFile: false, logLevel: "silent", build: { outDir: "vite", target: "es2022" } });
  const assets = readdirSync(join(folder, "vite/assets"));
  expect(assets.filter((name) => name.endsWith(".wasm"))).toHaveLength(1);
  await vite({
    root: folder,
    configFile: false,
    logLevel: "silent",
    build: {
      outDir: "vite-lib",
      target: "es2022",
      assetsInlineLimit: 0,
      lib: { entry: "entry.js", formats: ["es"], fileName: () => "entry.mjs" },
    },
  });
  expect(await answerOf(join(folder, "vite-lib/entry.mjs"))).toBe(HASHES["perpendicular"]!["hybrid"]);
});

const INLINE = `import { init, Planner, scenario } from "parkade/inline";
export async function answer() {
  await init();
  return new Planner("hybrid", scenario("perpendicular")).plan().hash;
}`;

/** A bundle's answer in a process and a folder of its own, where nothing of the package is near. */
function alone(bundle: string): string {
  const place = mkdtempSync(join(tmpdir(), "parkade-bundle-")),
    name = basename(bundle);
  try {
    copyFileSync(bundle, join(place, name));
    writeFileSync(
      join(place, "run.mjs"),
      `const bundle = await import("./${name}"); console.log(await (bundle.answer ?? bundle.default.answer)());`,
    );
    return execFileSync(process.execPath, ["run.mjs"], { cwd: place, encoding: "utf8" }).trim();
  } finally {
    rmSync(place, { recursive: true });
  }
}

test.each([
  ["browser", "esm"],
  ["browser", "cjs"],
  ["node", "esm"],
  ["node", "cjs"],
  ["neutral", "esm"],
] as const)("esbuild's bundle of `parkade/inline` for %s as %s runs alone", async (platform, format) => {
  write("inline.js", INLINE);
  const outfile = join(folder, `inline-${platform}-${format}/entry.${format === "esm" ? "mjs" : "cjs"}`);
  const { warnings } = await esbuild({
    absWorkingDir: folder,
    entryPoints: ["inline.js"],
    bundle: true,
    minify: true,
    format,
    platform,
    outfile,
    logLevel: "silent",
  });
  expect([warnings, readFileSync(outfile, "utf8").includes("parkade_bg.wasm")]).toEqual([[], false]);
  expect(alone(outfile)).toBe(HASHES["perpendicular"]!["hybrid"]);
});

test("the bundles of `parkade/inline` by Rollup, Rolldown and Vite run alone", async () => {
  write("inline.js", INLINE);
  const input = join(folder, "inline.js");
  const parkadeOnly = {
    name: "parkade",
    resolveId: (id: string) => (id === "parkade/inline" ? join(folder, "node_modules/parkade/inline.js") : null),
  };
  const rolled = await rollup({ input, plugins: [parkadeOnly] });
  await rolled.write({ file: join(folder, "inline-rollup.mjs"), format: "es" });
  await (await rolldown({ input })).write({ file: join(folder, "inline-rolldown.mjs"), format: "es" });
  await vite({
    root: folder,
    configFile: false,
    logLevel: "silent",
    build: {
      outDir: "inline-vite",
      emptyOutDir: false,
      target: "es2022",
      lib: { entry: "inline.js", formats: ["es"], fileName: () => "entry.mjs" },
    },
  });
  await vite({
    root: folder,
    configFile: false,
    logLevel: "silent",
    ssr: { noExternal: true },
    build: { outDir: "inline-ssr", ssr: "inline.js", rolldownOptions: { output: { entryFileNames: "entry.mjs" } } },
  });
  for (const file of ["inline-rollup.mjs", "inline-rolldown.mjs", "inline-vite/entry.mjs", "inline-ssr/entry.mjs"]) {
    expect([file, alone(join(folder, file))]).toEqual([file, HASHES["perpendicular"]!["hybrid"]]);
  }
}, 60_000);

test("the module's address comes from Vite's `?url` and from esbuild's file loader", async () => {
  const addressed = (wasm: string) =>
    ENTRY.replace("answer(wasm) {", "answer() {").replace("import {", `import wasm from "${wasm}";\nimport {`);
  write("url.js", addressed("parkade/parkade_bg.wasm?url"));
  await vite({
    root: folder,
    configFile: false,
    logLevel: "silent",
    build: {
      outDir: "url-vite",
      target: "es2022",
      lib: { entry: "url.js", formats: ["es"], fileName: () => "entry.mjs" },
    },
  });
  expect(alone(join(folder, "url-vite/entry.mjs"))).toBe(HASHES["perpendicular"]!["hybrid"]);
  write("file.js", addressed("parkade/parkade_bg.wasm"));
  const outdir = join(folder, "url-esbuild");
  await esbuild({
    absWorkingDir: folder,
    entryPoints: ["file.js"],
    bundle: true,
    format: "esm",
    platform: "node",
    outdir,
    outExtension: { ".js": ".mjs" },
    loader: { ".wasm": "file" },
    publicPath: pathToFileURL(outdir).href,
    logLevel: "silent",
  });
  expect(alone(join(outdir, "file.mjs"))).toBe(HASHES["perpendicular"]!["hybrid"]);
});

test("Vite's development server hands out `parkade/inline`, optimised, with its module", async () => {
  write("inline.js", INLINE);
  const server = await createServer({
    root: folder,
    configFile: false,
    logLevel: "silent",
    cacheDir: join(folder, "inline-cache"),
    optimizeDeps: { include: ["parkade/inline"], noDiscovery: true },
    server: { middlewareMode: true, ws: false, watch: null },
  });
  try {
    await server.environments.client.depsOptimizer?.init();
    const { code } = (await server.transformRequest("/inline.js"))!;
    expect(code).toMatch(/inline-cache\/deps\/parkade_inline\.js/);
    write("optimised.mjs", INLINE.replace("parkade/inline", "./inline-cache/deps/parkade_inline.js"));
    write("run-optimised.mjs", 'import { answer } from "./optimised.mjs"; console.log(await answer());');
    expect(run("run-optimised.mjs").trim()).toBe(HASHES["perpendicular"]!["hybrid"]);
  } finally {
    await server.close();
  }
}, 60_000);

test("`parkade/inline` takes bytes and modules, and refuses other things", () => {
  write(
    "given.mjs",
    `import { readFileSync } from "node:fs";
    import { init, version } from "parkade/inline";
    await init({ wasm: "file.wasm" }).catch(({ code, path }) => console.log(code, path));
    await init({ wasm: readFileSync("node_modules/parkade/parkade_bg.wasm") });
    console.log(version());`,
  );
  expect(run("given.mjs").trim().split("\n")).toEqual(["bad-input wasm", version()]);
});

/** What `require` does in this Node.js, and in those of before 20.19, which cannot require modules. */
test.each([
  ["as it is", []],
  ["without `require` of modules", ["--no-experimental-require-module"]],
])("CommonJS plans with `require`, in Node %s", (_, flags) => {
  write(
    "plan.cjs",
    `const { init, Planner, ParkadeError, scenario } = require("parkade");
    init().then(async () => {
      console.log(new Planner("hybrid", scenario("perpendicular")).plan().hash);
      try { new Planner("hybird", scenario("perpendicular")); } catch (error) { console.log(error instanceof ` +
      `ParkadeError, error.code); }
    });`,
  );
  const known = process.allowedNodeEnvironmentFlags.has("--experimental-require-module");
  const printed = execFileSync(process.execPath, [...(known ? flags : []), "plan.cjs"], {
    cwd: folder,
    encoding: "utf8",
  });
  expect(printed.trim().split("\n")).toEqual([HASHES["perpendicular"]!["hybrid"], "true unknown-planner"]);
});

test("a bundle that uses no planner leaves them out", async () => {
  write("small.js", 'export { packRuns } from "parkade";');
  write("large.js", 'export * from "parkade";');
  const size = async (entry: string) => {
    const { outputFiles } = await esbuild({
      absWorkingDir: folder,
      entryPoints: [entry],
      bundle: true,
      minify: true,
      format: "esm",
      platform: "browser",
      write: false,
      logLevel: "silent",
    });
    return outputFiles[0]!.contents.length;
  };
  expect(await size("small.js")).toBeLessThan((await size("large.js")) / 4);
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
