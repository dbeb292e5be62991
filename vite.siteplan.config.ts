import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The page's reader of site plans as a module of the package. */
export default defineConfig({
  publicDir: false,
  build: {
    outDir: here("pkg"),
    emptyOutDir: false,
    target: "es2022",
    minify: false,
    lib: { entry: here("www/src/siteplan/index.ts"), formats: ["es"], fileName: () => "siteplan.js" },
  },
});
