// Builds the packed package with each bundler in an empty folder, runs the bundle, and compares the plan's hash.
// `node tests/consumers/run.mjs [--into FOLDER] [name …]`; packages come from the registry, Chromium opens the pages.
import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { dirname, extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";

const here = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const HASH = JSON.parse(readFileSync(here("tests/data/plan-hashes.json"), "utf8")).perpendicular.hybrid;
const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".wasm": "application/wasm",
};
const PORT = Number(process.env.PARKADE_TEST_PORT ?? 4125);

const planned = (entry, init = "init()") =>
  `import { init, Planner, scenario } from "${entry}";
  export const answer = ${init}.then(() => new Planner("hybrid", scenario("perpendicular")).plan().hash);`;
const shown = (entry) =>
  `${planned(entry)}\nanswer.then((hash) => (document.title = hash), (error) => (document.title = error));`;
const asWorker = `import { createPlanner } from "parkade/worker";
  import { init, scenario as built } from "parkade";
  init().then(() => createPlanner("hybrid", built("perpendicular"))).then((planner) => planner.plan())
    .then((plan) => (document.title = plan.hash), (error) => (document.title = error));`;
const printedByWorker = `import { init, scenario as built } from "parkade";
  import { createPlanner } from "parkade/worker";
  await init();
  const planner = await createPlanner("hybrid", built("perpendicular"));
  console.log((await planner.plan()).hash);
  process.exit();`;
const printed = (entry) => `${planned(entry)}\nanswer.then((hash) => console.log(hash));`;
const html = (script) => `<!doctype html><title>wait</title><script type="module" src="${script}"></script>`;
const page = (text) => ({ "index.html": html("./main.js"), "main.js": text });

const vite = (major) => [
  `vite ${major}, build`,
  {
    folder: `vite${major}`,
    packages: [`vite@${major}`],
    files: page(shown("parkade")),
    run: ["vite", "build", "--outDir", "out"],
    open: "out",
  },
  `vite ${major}, worker`,
  {
    folder: `vite${major}`,
    packages: [`vite@${major}`],
    files: page(asWorker),
    run: ["vite", "build", "--outDir", "out"],
    open: "out",
  },
  `vite ${major}, development server`,
  {
    folder: `vite${major}`,
    packages: [`vite@${major}`],
    files: page(shown("parkade/inline")),
    serve: ["vite", "--port", `${PORT}`, "--strictPort", "--host", "127.0.0.1"],
  },
  `vite ${major}, development server, worker`,
  {
    folder: `vite${major}-worker`,
    packages: [`vite@${major}`],
    files: { ...page(asWorker), "vite.config.js": 'export default { optimizeDeps: { exclude: ["parkade"] } };' },
    serve: ["vite", "--port", `${PORT}`, "--strictPort", "--host", "127.0.0.1"],
  },
];
const webpack = {
  folder: "webpack",
  packages: ["webpack@5", "webpack-cli"],
  run: ["webpack", "--mode", "production", "--entry", "./main.js", "--output-path", "./out"],
  open: "out",
};
const next = (folder, version) => ({
  folder,
  packages: [`next@${version}`, "react@19", "react-dom@19"],
  files: {
    "app/layout.js": "export default ({ children }) => <html><body>{children}</body></html>;",
    "app/page.js": `import { init, Planner, scenario } from "parkade/inline";
      import Client from "./client";
      export const dynamic = "force-dynamic";
      export default async function Page() {
        await init();
        return <><p id="server">{new Planner("hybrid", scenario("perpendicular")).plan().hash}</p><Client /></>;
      }`,
    "app/client.js":
      `"use client";
      import { useEffect } from "react";
      export default function Client() {
        useEffect(() => {
          Promise.all([import("parkade/inline"), import("parkade/worker")]).then(async ([{ init, Planner, scenario ` +
      `}, { createPlanner }]) => {
            await init();
            const hash = new Planner("hybrid", scenario("perpendicular")).plan().hash;
            const inWorker = (await (await createPlanner("hybrid", scenario("perpendicular"))).plan()).hash;
            const isSame = document.getElementById("server").textContent === hash && inWorker === hash;
            document.title = isSame ? hash : "the plan of the server or the worker differs";
          }).catch((error) => (document.title = error));
        }, []);
        return null;
      }`,
  },
  run: ["next", "build"],
  serve: ["next", "start", "-p", `${PORT}`],
});
/** JSX of a framework: what is right compiles, and a layout that does not exist does not. */
const types = (name, packages, tag, source = name) => ({
  folder: "types",
  packages: [...packages, "typescript@5", "react@19", "@types/react@19", "preact", "solid-js", "vue"],
  files: { [`${name}.tsx`]: `import type {} from "parkade/element/${name}";\n${tag}` },
  run: [
    "tsc",
    "--noEmit",
    "--strict",
    "--jsx",
    "react-jsx",
    "--jsxImportSource",
    source,
    "--module",
    "nodenext",
    "--target",
    "es2022",
    "--lib",
    "es2023,dom,dom.iterable,esnext.disposable",
    `${name}.tsx`,
  ],
});
const JSX = `export const good = <parkade-playground scene="parallel" layout="single" speed={2} id="own" />;
  // @ts-expect-error
  export const bad = <parkade-playground layout="gird" />;`;
const TEMPLATE = `import type { GlobalComponents } from "vue";
  type Props = InstanceType<GlobalComponents["parkade-playground"]>["$props"];
  export const good: Props = { layout: "single", scene: "parallel" };
  // @ts-expect-error
  export const bad: Props = { layout: "gird" };`;
const rows = [
  ...[5, 6, 7, 8].flatMap(vite),
  "webpack 5",
  { ...webpack, files: { "main.js": shown("parkade"), "out/index.html": html("./main.js") } },
  "webpack 5, worker",
  { ...webpack, files: { "main.js": asWorker, "out/index.html": html("./main.js") } },
  "parcel",
  {
    folder: "parcel",
    packages: ["parcel"],
    files: page(shown("parkade/inline")),
    run: ["parcel", "build", "index.html", "--dist-dir", "out", "--public-url", "./"],
    open: "out",
  },
  "parcel, package exports",
  {
    folder: "parcel",
    packages: ["parcel"],
    files: page(shown("parkade")),
    run: ["parcel", "build", "index.html", "--dist-dir", "out", "--public-url", "./"],
    open: "out",
  },
  "parcel, worker",
  {
    // Parcel's cache of another page at the same place makes a page that asks for a module by its number.
    folder: "parcel-worker",
    packages: ["parcel"],
    files: page(asWorker),
    run: ["parcel", "build", "index.html", "--dist-dir", "out", "--public-url", "./"],
    open: "out",
  },
  "esbuild",
  {
    folder: "esbuild",
    packages: ["esbuild"],
    files: { "main.js": printed("parkade/inline") },
    run: ["esbuild", "main.js", "--bundle", "--format=esm", "--outfile=out/main.mjs"],
    print: ["node", "out/main.mjs"],
  },
  "rollup",
  {
    folder: "rollup",
    packages: ["rollup", "@rollup/plugin-node-resolve"],
    files: { "main.js": printed("parkade/inline") },
    run: ["rollup", "main.js", "-p", "node-resolve", "-f", "es", "-o", "out/main.mjs"],
    print: ["node", "out/main.mjs"],
  },
  "bun, bundle",
  {
    folder: "bun",
    packages: ["bun"],
    files: { "main.js": printed("parkade/inline") },
    run: ["bun", "build", "main.js", "--outfile", "out/main.mjs"],
    print: ["node", "out/main.mjs"],
  },
  "bun, run",
  {
    folder: "bun",
    packages: ["bun"],
    files: { "main.js": printed("parkade") },
    print: ["node_modules/.bin/bun", "main.js"],
  },
  "bun, worker",
  {
    folder: "bun",
    packages: ["bun"],
    files: { "main.js": printedByWorker },
    print: ["node_modules/.bin/bun", "main.js"],
  },
  "react, types",
  types("react", ["react@19"], JSX),
  "preact, types",
  types("preact", ["preact"], JSX),
  "solid, types",
  types("solid", ["solid-js"], JSX, "solid-js"),
  "vue, types",
  types("vue", ["vue"], TEMPLATE),
  "next 15, server, client and worker",
  next("next15", 15),
  "next, server, client and worker",
  next("next", "latest"),
];

const args = process.argv.slice(2),
  into = args[0] === "--into" ? args.splice(0, 2)[1] : mkdtempSync(join(tmpdir(), "parkade-"));
const run = (command, cwd) =>
  execFileSync(command[0], command.slice(1), {
    cwd,
    encoding: "utf8",
    stdio: "pipe",
    env: { ...process.env, CI: "1" },
  });
mkdirSync(into, { recursive: true });
const packed = join(
  into,
  JSON.parse(run(["npm", "pack", "--json", "--ignore-scripts", "--pack-destination", into], here("pkg/")))[0].filename,
);

/** A folder's files over HTTP. */
function serveFolder(folder) {
  const server = createServer((request, answer) => {
    const path = join(folder, request.url === "/" ? "index.html" : new URL(request.url, "http://x").pathname);
    if (!existsSync(path) || !statSync(path).isFile()) return answer.writeHead(404).end();
    answer
      .writeHead(200, { "content-type": TYPES[extname(path)] ?? "application/octet-stream" })
      .end(readFileSync(path));
  }).listen(PORT, "127.0.0.1");
  return () => new Promise((done) => server.close(done));
}

/** A server of the bundler's own; it ends with its group. */
function serveBy(command, cwd) {
  const server = spawn(join(cwd, "node_modules/.bin", command[0]), command.slice(1), {
    cwd,
    stdio: "ignore",
    detached: true,
  });
  return () => new Promise((done) => server.once("exit", done) && process.kill(-server.pid));
}

async function title(browser) {
  const tab = await browser.newPage();
  try {
    const address = `http://127.0.0.1:${PORT}/`;
    for (let tries = 0; tries < 120; tries++) {
      if (await tab.goto(address).catch(() => null)) break;
      await new Promise((done) => setTimeout(done, 500));
    }
    await tab.waitForFunction(() => !["", "wait"].includes(document.title), null, { timeout: 60_000 });
    return await tab.title();
  } finally {
    await tab.close();
  }
}

async function result(row, browser) {
  const cwd = join(into, row.folder);
  for (const [name, text] of Object.entries(row.files)) {
    mkdirSync(dirname(join(cwd, name)), { recursive: true });
    writeFileSync(join(cwd, name), text);
  }
  if (row.run) run([join(cwd, "node_modules/.bin", row.run[0]), ...row.run.slice(1)], cwd);
  if (row.folder === "types") return HASH;
  if (row.print) return run(row.print, cwd).trim();
  const stop = row.open ? serveFolder(join(cwd, row.open)) : serveBy(row.serve, cwd);
  try {
    return await title(browser);
  } finally {
    await stop();
  }
}

const browser = await chromium.launch({ executablePath: process.env.CHROME_PATH, args: ["--no-sandbox"] });
for (let i = 0; i < rows.length; i += 2) {
  const name = rows[i],
    row = rows[i + 1],
    cwd = join(into, row.folder);
  if (args.length && !args.some((one) => name.startsWith(one))) continue;
  if (!existsSync(join(cwd, "node_modules/parkade"))) {
    mkdirSync(cwd, { recursive: true });
    writeFileSync(join(cwd, "package.json"), JSON.stringify({ private: true, type: "module" }));
    run(["npm", "install", "--no-audit", "--no-fund", packed, ...row.packages], cwd);
  }
  const tool = row.packages[0].replace(/@.*/, "");
  const { version } = JSON.parse(readFileSync(join(cwd, `node_modules/${tool}/package.json`), "utf8"));
  const got = await result(row, browser).catch((error) =>
    String(error.stderr || error.stdout || error)
      .trim()
      .slice(0, 600),
  );
  if (got !== HASH) process.exitCode = 1;
  console.log(
    `${name} | ${version} | ${
      got === HASH ? (row.folder === "types" ? "compiles" : "plans, same hash") : `FAILS: ${got}`
    }`,
  );
}
await browser.close();
