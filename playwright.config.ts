import { defineConfig } from "@playwright/test";
import { findBrowser } from "./tests/e2e/browser.js";

const url = "http://127.0.0.1:4179/sub/path/";

// Chromium's sandbox needs a user other than root; containers on build servers often have neither.
const unsandboxed = process.getuid?.() === 0 || process.env["CI"] !== undefined;

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
    launchOptions: {
      executablePath: findBrowser(),
      args: [
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        ...(unsandboxed ? ["--no-sandbox"] : []),
      ],
    },
  },
  webServer: { command: "node tests/e2e/server.js", url, reuseExistingServer: false },
});
