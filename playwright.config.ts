import { defineConfig } from "@playwright/test";
import { launchOptions } from "./tests/e2e/browser.js";

// Two checkouts can test at the same time, each on a port of its own.
const port = process.env["PARKADE_TEST_PORT"] ?? "4179";
const url = `http://127.0.0.1:${port}/sub/path/`;

export default defineConfig({
  testDir: "tests/e2e",
  outputDir: "test-results",
  forbidOnly: process.env["CI"] !== undefined,
  timeout: 60_000,
  expect: { timeout: 10_000 },
  workers: 2,
  retries: 1,
  use: {
    baseURL: url,
    trace: "on-first-retry",
    // Its installation loads every file once more; what it does is tested where it is allowed.
    serviceWorkers: "block",
    launchOptions: launchOptions(),
  },
  webServer: { command: `node tests/e2e/server.js ${port}`, url, reuseExistingServer: false },
});
