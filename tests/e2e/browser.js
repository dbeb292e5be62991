// @ts-check
// A Chromium, and how it is started. As a program: prints its path, or nothing.
import { accessSync, constants, existsSync, statSync } from "node:fs";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "@playwright/test";
import { serve } from "./server.js";

/** The first has no user interface: the tests take a third less processor time. */
const COMMANDS = [
  "chromium-headless-shell",
  "chromium",
  "chromium-browser",
  "google-chrome-stable",
  "google-chrome",
];

/** Where the installers of Chrome and Edge put them, when they are not on PATH. */
const INSTALLED = {
  darwin: [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
  ],
  win32: ["ProgramFiles", "ProgramFiles(x86)", "LocalAppData"].flatMap((variable) => {
    const folder = process.env[variable];
    return folder === undefined
      ? []
      : [join(folder, "Google/Chrome/Application/chrome.exe"), join(folder, "Microsoft/Edge/Application/msedge.exe")];
  }),
};

/**
 * CHROME_PATH, Playwright's own, then what is installed. A CHROME_PATH that names no file is an error.
 * @returns {string | undefined}
 */
export function findBrowser() {
  const named = process.env["CHROME_PATH"];
  if (named) {
    if (!existsSync(named)) throw new Error(`CHROME_PATH names no file: ${named}`);
    return named;
  }
  const onPath = (process.env["PATH"] ?? "")
    .split(delimiter)
    .flatMap((folder) => COMMANDS.map((command) => join(folder, command)));
  const platform = process.platform === "darwin" || process.platform === "win32" ? INSTALLED[process.platform] : [];
  return [chromium.executablePath(), ...onPath, ...platform].find(isExecutable);
}

/**
 * @param {string[]} more
 * @returns {import("@playwright/test").LaunchOptions}
 */
export function launchOptions(...more) {
  // Chromium's sandbox needs a user other than root; containers on build servers often have neither.
  const unsandboxed = process.getuid?.() === 0 || process.env["CI"] !== undefined;
  return {
    executablePath: findBrowser(),
    args: [
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      ...(unsandboxed ? ["--no-sandbox"] : []),
      ...more,
    ],
  };
}

/**
 * Calls `use` with a browser and the address of what dist/ serves to it; closes both after it.
 * @template T
 * @param {(browser: import("@playwright/test").Browser, url: string) => Promise<T>} use
 * @param {string[]} more arguments of the browser
 */
export async function withBrowser(use, ...more) {
  const server = await serve(0);
  try {
    const browser = await chromium.launch(launchOptions(...more));
    try {
      return await use(browser, server.url);
    } finally {
      await browser.close();
    }
  } finally {
    server.close();
  }
}

/** @param {string} path */
function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

if (process.argv[1] !== undefined && import.meta.url === pathToFileURL(process.argv[1]).href) {
  console.log(findBrowser() ?? "");
}
