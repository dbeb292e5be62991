import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Minifiers leave template literals alone; the page's styles and markup are such. */
const squeezeTemplates: Plugin = {
  name: "squeeze-templates",
  enforce: "pre",
  transform(code, id) {
    if (!id.includes("/www/src/") || !id.endsWith(".ts")) return null;
    return code.replace(/\b(css|html|svg)`([^`\\]*)`/g, (_, tag: string, text: string) => {
      const lines = text.replace(/\n\s+/g, tag === "css" ? "\n" : " ");
      return `${tag}\`${tag === "css" ? lines.replace(/\s*([{};,])\s*/g, "$1") : lines}\``;
    });
  },
};

export default defineConfig({
  plugins: [squeezeTemplates],
  root: here("www"),
  base: "./",
  resolve: { alias: { parkade: here("pkg/index.js") } },
  worker: { format: "es" },
  build: {
    outDir: here("dist"),
    emptyOutDir: true,
    target: "es2022",
    // A data: URL for the wasm file would lose streaming compilation, and the page's policy forbids it.
    assetsInlineLimit: 0,
    // Two scripts need no preloading.
    modulePreload: false,
  },
});
