import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { messages } from "./vite.messages";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The page's drawing as a module of the package. */
export default defineConfig({
  plugins: [messages(here("www/src/i18n"))],
  publicDir: false,
  build: {
    outDir: here("pkg"),
    emptyOutDir: false,
    target: "es2022",
    minify: false,
    lib: { entry: here("www/src/picture/draw.ts"), formats: ["es"], fileName: () => "drawing.js" },
  },
});
