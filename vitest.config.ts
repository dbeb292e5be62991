import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  resolve: {
    alias: [
      { find: "parkade/core", replacement: here("pkg/core/node.js") },
      { find: /^parkade\/worker\/(pool|transfer)$/, replacement: here("pkg/worker/$1.js") },
      { find: "parkade/worker", replacement: here("pkg/worker/node.js") },
      { find: "parkade", replacement: here("pkg/node.js") },
    ],
  },
  test: { include: ["tests/js/**/*.test.ts"], setupFiles: ["tests/js/animation-frames.ts"], testTimeout: 60_000 },
});
