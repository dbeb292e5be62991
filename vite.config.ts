import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { readdir, readFile, writeFile } from "node:fs/promises";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { messages } from "./vite.messages";
import { poster } from "./vite.poster";
import { squeezeTemplates } from "./vite.templates";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Writes the service worker with the names of all files and a version that changes with any of them. */
const serviceWorker: Plugin = {
  name: "service-worker",
  // The files are on the disk then, also those that other plugins make last.
  async closeBundle() {
    const dist = here("dist"),
      hash = createHash("sha256");
    const files = (await readdir(dist, { recursive: true, withFileTypes: true }))
      .filter((file) => file.isFile() && file.name !== "sw.js")
      .map((file) => relative(dist, join(file.parentPath, file.name)).replaceAll("\\", "/"))
      .filter((file) => !file.startsWith(".vite/"))
      .sort();
    for (const file of files) hash.update(file).update(await readFile(join(dist, file)));
    const text = await readFile(here("www/sw.js"), "utf8");
    await writeFile(
      join(dist, "sw.js"),
      text
        .replace("const FILES = [];", `const FILES = ${JSON.stringify(files)};`)
        .replace('const VERSION = "";', `const VERSION = "${hash.digest("hex").slice(0, 16)}";`),
    );
  },
};

/** The loader imports by a name of its own: Vite's way would first fetch a helper, and the whole page with it. */
const nameEmbedded: Plugin = {
  name: "name-embedded",
  writeBundle({ dir = "" }, bundle) {
    const file = (name: string) =>
      Object.values(bundle).find((one) => one.type === "chunk" && one.name === name)?.fileName ?? "";
    const path = join(dir, file("parkade-playground")),
      code = readFileSync(path, "utf8");
    if (!file("parkade-embedded") || code.split(EMBEDDED).length !== 2)
      throw new Error("the loader does not name what it loads, once");
    writeFileSync(path, code.replace(EMBEDDED, `./${file("parkade-embedded")}`));
  },
};
/** What stands in `loader.ts` for the file's name. */
const EMBEDDED = "./embedded";

/** Our pages link their stylesheets themselves: a part fetched later must not bring them into other people's. */
const keepStylesheets: Plugin = {
  name: "keep-stylesheets",
  writeBundle({ dir = "" }, bundle) {
    for (const { fileName } of Object.values(bundle).filter((one) => one.type === "chunk")) {
      const path = join(dir, fileName),
        code = readFileSync(path, "utf8");
      const kept = code.replace(/^const __vite__mapDeps=.*?\["[^\]]*\.css"\].*?;\n/m, "");
      if (kept !== code) writeFileSync(path, kept.replace(/__vite__mapDeps\(\[\d+\]\)/g, "[]"));
    }
  },
};

/** Whether the page's entry imports a module before anything is asked for. */
function isFirst(id: string, graph: Graph, seen = new Set<string>()): boolean {
  if (seen.has(id)) return false;
  seen.add(id);
  const info = graph.getModuleInfo(id);
  return (
    info !== null && (id.endsWith("/index.html") || info.importers.some((importer) => isFirst(importer, graph, seen)))
  );
}

/** The engines' files are also the workers' scripts, where the page's own code would not run. */
const workersAlone: Plugin = {
  name: "workers-alone",
  generateBundle(_, bundle) {
    const chunkOf = (file: string) => {
      const chunk = bundle[file];
      return chunk?.type === "chunk" ? chunk : undefined;
    };
    const pageIn = (file: string, seen = new Set<string>()): string | undefined => {
      if (seen.has(file)) return undefined;
      seen.add(file);
      return chunkOf(file)?.isEntry
        ? file
        : chunkOf(file)
            ?.imports.map((next) => pageIn(next, seen))
            .find(Boolean);
    };
    for (const { fileName, facadeModuleId } of Object.keys(bundle).flatMap((file) => chunkOf(file) ?? [])) {
      const page = /\/planning\/engine-(core|complete)\.ts$/.test(facadeModuleId ?? "") && pageIn(fileName);
      if (page)
        this.error(
          `${fileName} imports the page's ${page}, by itself or through others: a module that the page and the ` +
            `workers share must not be imported by both.`,
        );
    }
  },
};

type Graph = { getModuleInfo(id: string): { importers: readonly string[] } | null };

export default defineConfig({
  plugins: [
    messages(here("www/src/i18n")),
    poster(here("pkg/node.js")),
    squeezeTemplates,
    workersAlone,
    nameEmbedded,
    keepStylesheets,
    serviceWorker,
  ],
  root: here("www"),
  base: "./",
  resolve: {
    alias: [
      { find: "parkade/core", replacement: here("pkg/core/index.js") },
      { find: /^parkade\/worker\/(pool|transfer)$/, replacement: here("pkg/worker/$1.js") },
      { find: "parkade", replacement: here("pkg/index.js") },
      // The package brings the page's drawing, which is here.
      { find: "./drawing.js", replacement: here("www/src/picture/draw.ts") },
    ],
  },
  worker: { format: "es" },
  build: {
    outDir: here("dist"),
    emptyOutDir: true,
    manifest: true,
    target: "es2022",
    // A data: URL for the wasm file would lose streaming compilation, and the page's policy forbids it.
    assetsInlineLimit: 0,
    // What the page opens with is one file, also where a part fetched later uses it too: every request costs a
    // round trip.
    rolldownOptions: {
      input: {
        index: here("www/index.html"),
        embed: here("www/embed.html"),
        "parkade-playground": here("www/src/element/loader.ts"),
        "parkade-embedded": here("www/src/element/embedded.ts"),
      },
      preserveEntrySignatures: "allow-extension",
      output: {
        // Other people's pages name this file.
        entryFileNames: ({ name }) => (name === "parkade-playground" ? "[name].js" : "assets/[name]-[hash].js"),
        codeSplitting: { groups: [{ name: (id: string, graph: Graph) => (isFirst(id, graph) ? "page" : null) }] },
      },
    },
    // Two scripts need no preloading.
    modulePreload: false,
  },
});
