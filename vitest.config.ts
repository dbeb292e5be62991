import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  resolve: { alias: { "parkade/core": here("pkg/core/node.js"), parkade: here("pkg/node.js") } },
  test: { include: ["tests/js/**/*.test.ts"], testTimeout: 60_000 },
});
