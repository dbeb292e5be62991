import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The page's drawing as a module of the package: with its pieces at hand. */
export default defineConfig({
  publicDir: false,
  resolve: { alias: [{ find: /^.*\/lazy-layers$/, replacement: here("www/src/picture/lazy-layers.ts") }] },
  build: {
    outDir: here("pkg"),
    emptyOutDir: false,
    target: "es2022",
    minify: false,
    lib: { entry: here("www/src/picture/draw.ts"), formats: ["es"], fileName: () => "drawing.js" },
  },
});
