// @ts-check
// Serves dist/ below /sub/path/, as a project page of a static host would.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname } from "node:path";

const PREFIX = "/sub/path/";
const DIST = new URL("../../dist/", import.meta.url);
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

createServer(async (request, response) => {
  const { pathname } = new URL(request.url ?? "/", "http://localhost");
  const file = new URL(pathname.slice(PREFIX.length) || "index.html", DIST);
  try {
    if (!pathname.startsWith(PREFIX) || !file.href.startsWith(DIST.href)) throw new Error("outside");
    const body = await readFile(file);
    response.writeHead(200, { "content-type": TYPES[extname(file.pathname)] ?? "application/octet-stream" }).end(body);
  } catch {
    response.writeHead(404).end();
  }
}).listen(4179, "127.0.0.1");
