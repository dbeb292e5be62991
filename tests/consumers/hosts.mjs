// Builds each example of a documentation host in an empty folder, with the page's files, and looks at it in Chromium
// and Firefox. `node tests/consumers/hosts.mjs [--into FOLDER] [name …]`; packages come from their registries.
import { execFileSync, spawn } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { delimiter, extname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const PORT = Number(process.env.PARKADE_TEST_PORT ?? 4126);
const WIDTHS = [320, 375, 768, 1400];
/** Layout shift that nobody sees, and its like in pixels for browsers that do not tell it. */
const SHIFT = 0.01,
  MOVED = 1;
const PATIENCE_MS = 90_000;
const TYPES = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".json": "application/json",
  ".mjs": "text/javascript",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};
const npm = (cwd) => [[["npm", "install", "--no-audit", "--no-fund"]], [["npm", "run", "build"]], cwd];
const venv = (cwd, ...build) => [
  [
    ["python3", "-m", "venv", ".venv"],
    [join(cwd, ".venv/bin/pip"), "install", "--quiet", "--requirement", "requirements.txt"],
  ],
  [[join(cwd, ".venv/bin", build[0]), ...build.slice(1)]],
];
/**
 * Of each host: where the page's files go, how it is built, what comes out, what switches its theme, and whose version
 * is told.
 */
const HOSTS = {
  docusaurus: {
    files: "static/parkade",
    made: npm,
    out: "build",
    own: "/own/",
    switches: Array(3).fill('[class*="colorModeToggle"] button'),
    version: "@docusaurus/core",
  },
  starlight: {
    files: "public/parkade",
    made: npm,
    out: "dist",
    own: "/own/",
    switches: Array(3).fill("starlight-theme-select select"),
    version: "@astrojs/starlight",
  },
  vitepress: {
    files: "public/parkade",
    made: npm,
    out: ".vitepress/dist",
    own: "/own.html",
    switches: Array(2).fill(".VPSwitchAppearance"),
    version: "vitepress",
  },
  mkdocs: {
    files: "docs/parkade",
    made: (cwd) => venv(cwd, "mkdocs", "build"),
    out: "site",
    own: "/own/",
    switches: Array(2).fill("label[for^=__palette]"),
    version: "requirements.txt",
  },
  sphinx: {
    files: "_static/parkade",
    made: (cwd) => venv(cwd, "sphinx-build", "-q", ".", "_build"),
    out: "_build",
    own: "/own.html",
    switches: Array(3).fill(".theme-toggle"),
    version: "requirements.txt",
  },
  mdbook: {
    files: "src/parkade",
    made: () => [[], [[process.env.MDBOOK ?? "mdbook", "build"]]],
    out: "book",
    own: "/own.html",
    first: "/parking.html",
    switches: ["#mdbook-theme-toggle, #theme-toggle", "#mdbook-theme-navy, #navy", "#mdbook-theme-rust, #rust"],
    version: "mdbook",
  },
};

/** Playgrounds that come, move and go in a page without a host. */
const MOUNTS = "mounts";

const installed = (names) =>
  names
    .flatMap((name) => (process.env.PATH ?? "").split(delimiter).map((folder) => join(folder, name)))
    .find((path) => existsSync(path));
const BROWSERS = {
  Chromium: {
    path: process.env.CHROME_PATH ?? installed(["chromium", "google-chrome"]),
    options: (profile) => [
      "--headless",
      "--no-sandbox",
      "--disable-gpu",
      "--no-first-run",
      "--window-size=1500,900",
      `--user-data-dir=${profile}`,
    ],
  },
  Firefox: {
    path: process.env.FIREFOX_PATH ?? installed(["firefox", "firefox-esr"]),
    options: (profile) => ["--headless", "--no-remote", "--profile", profile],
    env: { MOZ_HEADLESS_WIDTH: "1500", MOZ_HEADLESS_HEIGHT: "900" },
  },
};

const run = (command, cwd) =>
  execFileSync(command[0], command.slice(1), {
    cwd,
    encoding: "utf8",
    stdio: "pipe",
    env: { ...process.env, CI: "1" },
  });

/** The host's folder, built. */
function built(name, into) {
  const { files, made, out } = HOSTS[name],
    cwd = join(into, name);
  cpSync(here(`examples/${name}`), cwd, {
    recursive: true,
    filter: (path) => !/node_modules|\/book$|\/parkade$/.test(path),
  });
  rmSync(join(cwd, files), { recursive: true, force: true });
  cpSync(here("dist"), join(cwd, files), { recursive: true });
  const [install, build] = made(cwd);
  const isThere = existsSync(join(cwd, "node_modules")) || existsSync(join(cwd, ".venv"));
  for (const command of [...(isThere ? [] : install), ...build]) run(command, cwd);
  return join(cwd, out);
}

function versionOf(name, cwd) {
  const { version } = HOSTS[name];
  if (version === "requirements.txt") return readFileSync(join(cwd, version), "utf8").trim().replaceAll("\n", ", ");
  if (version === "mdbook") return run([process.env.MDBOOK ?? "mdbook", "--version"], cwd).trim();
  return JSON.parse(readFileSync(join(cwd, "node_modules", version, "package.json"), "utf8")).version;
}

/** Serves a folder, its pages with the probe in them, and waits for what the probe posts. */
async function served(folder, use) {
  let heard = () => {};
  const server = createServer(async (request, answer) => {
    const { pathname } = new URL(request.url, "http://x");
    if (pathname === "/__report") {
      let body = "";
      for await (const chunk of request) body += chunk;
      answer.end();
      return heard(JSON.parse(body));
    }
    const own = { "/__probe.js": "probe.js", "/__frame.html": "frame.html", "/__mounts.html": "mounts.html" }[pathname];
    const candidates = own
      ? [here(`tests/consumers/${own}`)]
      : ["", ".html", "/index.html"].map((end) => join(folder, decodeURIComponent(pathname).replace(/\/$/, "") + end));
    const path = candidates.find((one) => existsSync(one) && statSync(one).isFile());
    if (!path) return answer.writeHead(404).end();
    const type = TYPES[extname(path)] ?? "application/octet-stream";
    let content = readFileSync(path);
    if (extname(path) === ".html" && !own)
      content = content.toString("utf8").replace(/<head[^>]*>/, '$&<script type="module" src="/__probe.js"></script>');
    answer.writeHead(200, { "content-type": type }).end(content);
  });
  await new Promise((done) => server.listen(PORT, "127.0.0.1", done));
  try {
    return await use(
      (of) =>
        new Promise((done, failed) => {
          const timer = setTimeout(() => failed(new Error(`no report of ${of}`)), PATIENCE_MS);
          heard = (report) => {
            if (report.of !== of) return;
            clearTimeout(timer);
            done(report);
          };
        }),
    );
  } finally {
    server.closeAllConnections();
    await new Promise((done) => server.close(done));
  }
}

/** A browser of its own for each page: nothing is in a cache, and nothing is remembered. */
async function opened({ path, options, env }, query, report) {
  const profile = mkdtempSync(join(tmpdir(), "parkade-browser-"));
  const address = `http://127.0.0.1:${PORT}/__frame.html?${query}`;
  const browser = spawn(path, [...options(profile), address], {
    stdio: "ignore",
    detached: true,
    env: { ...process.env, ...env },
  });
  const ended = new Promise((done) => browser.once("exit", done));
  try {
    return await report;
  } finally {
    process.kill(-browser.pid);
    await ended;
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** What is wrong with a report, in words. */
function faults(report, asked) {
  if (report.error) return [report.error];
  const all = [];
  const isOwn = "direct" in asked || "follow" in asked;
  if (isOwn && String(report.own) !== "Own,found") all.push(`own scene: ${report.own}`);
  if ("direct" in asked) return all;
  if (asked.path === "/__mounts.html") {
    if (String(report.kept) !== "Kept,4,8,found") all.push(`the drawing that was moved: ${report.kept}`);
    const [workers, listeners] = report.after.map((count, i) => count - report.before[i]);
    if (workers > 0 || listeners > 0) all.push(`left behind: ${workers} workers, ${listeners} listeners`);
    return all;
  }
  if (String(report.outcomes) !== "found,found") all.push(`outcomes: ${report.outcomes}`);
  if (report.shifts > SHIFT) all.push(`layout shift ${report.shifts.toFixed(4)}`);
  if (report.moved > MOVED) all.push(`moves ${report.moved.toFixed(1)} px`);
  if (report.overflow > MOVED) all.push(`overflows by ${report.overflow.toFixed(1)} px`);
  if (report.themes.some(([host, element]) => host !== element)) all.push(`themes: ${JSON.stringify(report.themes)}`);
  if (asked.switch && new Set(report.themes.map(([host]) => host)).size < 2)
    all.push(`the switch does nothing: ${JSON.stringify(report.themes)}`);
  return all;
}

/** Looks at pages in each browser, and says what is wrong with them. */
async function looked(name, version, folder, pages) {
  for (const [browser, program] of Object.entries(BROWSERS)) {
    if (!program.path) {
      console.log(`${name} | ${version} | ${browser}: not installed`);
      continue;
    }
    const found = await served(folder, async (report) => {
      const all = [];
      for (const [i, page] of pages.entries()) {
        const of = `${browser} ${i}`;
        const told = await opened(program, new URLSearchParams({ of, ...page }), report(of)).catch((error) => ({
          error: String(error),
        }));
        all.push(...faults(told, page).map((fault) => `${page.path} at ${page.width} px: ${fault}`));
      }
      return all;
    });
    if (found.length > 0) process.exitCode = 1;
    console.log(
      `${name} | ${version} | ${browser}: ${found.length === 0 ? "as it should be" : `FAILS: ${found.join("; ")}`}`,
    );
  }
}

const args = process.argv.slice(2),
  into = args[0] === "--into" ? args.splice(0, 2)[1] : mkdtempSync(join(tmpdir(), "parkade-"));
mkdirSync(into, { recursive: true });
const isAsked = (name) => args.length === 0 || args.includes(name);
if (isAsked(MOUNTS)) {
  const folder = join(into, MOUNTS);
  cpSync(here("dist"), join(folder, "parkade"), { recursive: true });
  await looked(MOUNTS, "100", folder, [{ path: "/__mounts.html", width: 600 }]);
}
for (const name of Object.keys(HOSTS).filter(isAsked)) {
  const { switches, first = "/", own } = HOSTS[name];
  try {
    const folder = built(name, into);
    const widest = { switch: switches.join("|"), follow: "" };
    await looked(name, versionOf(name, join(into, name)), folder, [
      ...WIDTHS.map((width) => ({ path: first, width, ...(width === WIDTHS.at(-1) && widest) })),
      { path: own, width: 768, direct: "" },
    ]);
  } catch (error) {
    process.exitCode = 1;
    const words = String(error.stderr || error.stdout || error).trim();
    console.log(`${name} | FAILS: ${words.slice(-1500)}`);
  }
}
