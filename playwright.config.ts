import { defineConfig } from "@playwright/test";
import { launchOptions } from "./tests/e2e/browser.js";

const url = "http://127.0.0.1:4179/sub/path/";

export default defineConfig({
  testDir: "tests/e2e",
  outputDir: "test-results",
  forbidOnly: process.env["CI"] !== undefined,
  timeout: 60_000,
  workers: 1,
  retries: 1,
  use: {
    baseURL: url,
    trace: "on-first-retry",
    launchOptions: launchOptions(),
  },
  webServer: { command: "node tests/e2e/server.js", url, reuseExistingServer: false },
});
