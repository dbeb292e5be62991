// @ts-check
// Plans the questions of a file in Node, with vector instructions and without, in Chromium and Firefox, and compares
// with the native answers in it.
import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { delimiter, extname, join } from "node:path";
import { existsSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { ask } from "./ask.js";

const ROOT = new URL("../../", import.meta.url);
const SERVED = ["pkg/", "tests/engines/"];
const TYPES = /** @type {Record<string, string>} */ ({
  ".html": "text/html",
  ".js": "text/javascript",
  ".wasm": "application/wasm",
});
const PATIENCE_MS = 30 * 60_000;

const [file, vectorised] = process.argv.slice(2);
if (!file || !vectorised)
  throw new Error("usage: run.js questions.jsonl FOLDER, of the package compiled to vector instructions");
const questions = await readFile(file, "utf8");

/** @typedef {{ asked: number, different: string[], agent: string }} Answers */

/** @param {string[]} names */
const installed = (names) =>
  names
    .flatMap((name) => (process.env["PATH"] ?? "").split(delimiter).map((folder) => join(folder, name)))
    .find((path) => existsSync(path));

const BROWSERS = [
  {
    name: "Chromium",
    path: process.env["CHROME_PATH"] || installed(["chromium", "google-chrome"]),
    /** @param {string} profile */
    options: (profile) => [
      "--headless", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
      `--user-data-dir=${profile}`,
    ],
  },
  {
    name: "Firefox",
    path: process.env["FIREFOX_PATH"] || installed(["firefox", "firefox-esr"]),
    /** @param {string} profile */
    options: (profile) => ["--headless", "--no-remote", "--profile", profile],
  },
];

/**
 * @param {string} path
 * @param {(profile: string) => string[]} options
 * @returns {Promise<Answers>}
 */
async function inBrowser(path, options) {
  /** @type {(answers: Answers) => void} */
  let answered = () => {};
  /** @type {Promise<Answers>} */
  const answers = new Promise((resolve) => { answered = resolve; });
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://localhost");
    if (pathname === "/questions") return void response.end(questions);
    if (pathname === "/answers") {
      let body = "";
      for await (const chunk of request) body += chunk;
      response.end();
      return answered(JSON.parse(body));
    }
    const wanted = new URL(`.${pathname}`, ROOT);
    const allowed = SERVED.some((folder) => wanted.href.startsWith(new URL(folder, ROOT).href));
    const content = allowed ? await readFile(wanted).catch(() => null) : null;
    if (content === null) return void response.writeHead(404).end();
    response.writeHead(200, { "content-type": TYPES[extname(pathname)] ?? "application/octet-stream" }).end(content);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(null)));
  const address = server.address();
  const port = typeof address === "object" && address ? address.port : 0;
  const profile = await mkdtemp(join(tmpdir(), "parkade-engines-"));
  const page = `http://127.0.0.1:${port}/tests/engines/page.html`;
  const browser = spawn(path, [...options(profile), page], { stdio: "ignore" });
  try {
    return await Promise.race([
      answers,
      new Promise((_, reject) => {
        browser.once("error", reject);
        browser.once("exit", (code) => reject(new Error(`${path} ended with ${code} before it answered`)));
        setTimeout(() => reject(new Error(`${path} did not answer`)), PATIENCE_MS).unref();
      }),
    ]);
  } finally {
    const ended = new Promise((resolve) => browser.once("exit", resolve));
    if (browser.exitCode === null && browser.kill()) await ended;
    server.closeAllConnections();
    server.close();
    await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

let wrong = 0;
/** @param {string} where @param {Answers} answers */
function report(where, { asked, different, agent }) {
  const ok = asked > 0 && different.length === 0;
  const same = asked - different.length;
  console.log(`${where.padEnd(10)} ${same} of ${asked} as natively${ok ? "" : ": DIFFERENT"}   ${agent}`);
  for (const line of different.slice(0, 20)) console.log(`  ${line}`);
  if (!ok) wrong++;
}

/** @param {string} where @param {string | URL} folder of a package */
async function inNode(where, folder) {
  const api = await import(new URL("node.js", folder).href);
  await api.init();
  report(where, { ...ask(api, questions), agent: `Node ${process.version}` });
}

await inNode("Node", new URL("pkg/", ROOT));
await inNode("Node, simd", pathToFileURL(`${vectorised}/`));
for (const { name, path, options } of BROWSERS) {
  if (path) report(name, await inBrowser(path, options));
  else {
    const variable = name === "Firefox" ? "FIREFOX_PATH" : "CHROME_PATH";
    console.log(`${name.padEnd(10)} skipped: not found; install it, or name it in ${variable}`);
  }
}
process.exit(wrong > 0 ? 1 : 0);
