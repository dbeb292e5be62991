// @ts-check
// Serves dist/ below /sub/path/, as a project page of a static host would, and at the top; pages that embed it below
// /host/; the documentation and the example book, where they are built, below /docs/ and /book/; the package below
// /package/.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

const PREFIX = "/sub/path/";
const DIST = new URL("../../dist/", import.meta.url);
/** @type {[string, URL][]} */
const FOLDERS = [
  [PREFIX, DIST],
  ["/host/", new URL("pages/", import.meta.url)],
  ["/docs/", new URL("../../docs/.vitepress/dist/", import.meta.url)],
  ["/book/", new URL("../../examples/mdbook/book/", import.meta.url)],
  ["/package/", new URL("../../pkg/", import.meta.url)],
  ["/", DIST],
];
/** @type {Record<string, string>} */
const TYPES = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".woff2": "font/woff2",
};

/**
 * Port 0 takes any that is free; compressed, as static hosts send what they serve, where that is asked for.
 * @param {number} port
 * @param {{ gzip?: boolean }} [options]
 * @returns {Promise<{ url: string, close(): void }>}
 */
export async function serve(port, { gzip = false } = {}) {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://localhost");
    const [prefix, folder] = FOLDERS.find(([start]) => pathname.startsWith(start)) ?? ["/", DIST];
    const file = new URL(pathname.slice(prefix.length).replace(/(^|\/)$/, "$1index.html"), folder);
    try {
      if (!file.href.startsWith(folder.href)) throw new Error("outside");
      const body = await readFile(file);
      const type = { "content-type": TYPES[extname(file.pathname)] ?? "application/octet-stream" };
      if (gzip) response.writeHead(200, { ...type, "content-encoding": "gzip" }).end(gzipSync(body));
      else response.writeHead(200, type).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve, reject) => server.once("error", reject).listen(port, "127.0.0.1", () => resolve(null)));
  const address = server.address();
  const taken = typeof address === "object" && address ? address.port : port;
  return { url: `http://127.0.0.1:${taken}${PREFIX}`, close: () => server.close() };
}

const [, started, port] = process.argv;
if (started !== undefined && import.meta.url === pathToFileURL(started).href) await serve(Number(port ?? 4179));
