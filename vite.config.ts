import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
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
