import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The package for `require` in Node.js versions that cannot require modules. */
export default defineConfig({
  publicDir: false,
  build: {
    ssr: here("pkg/node.js"),
    outDir: here("pkg"),
    emptyOutDir: false,
    target: "node20",
    minify: false,
    rolldownOptions: { output: { format: "cjs", entryFileNames: "node.cjs", codeSplitting: false } },
  },
});
