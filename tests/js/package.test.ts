import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import { init, version } from "parkade";

const PACKAGE = fileURLToPath(new URL("../../pkg/", import.meta.url));

/** The README's only JavaScript; a comment behind `console.log` is what it prints. */
const SCRIPT = /```js\n([^]*?)```/.exec(readFileSync(new URL("../../README.md", import.meta.url), "utf8"))![1]!;
const PRINTED = [...SCRIPT.matchAll(/console\.log.*\/\/ (.*)/g)].map((match) => match[1]);

let folder = "";

function npm(args: string[], cwd: string) {
  const quiet = ["--offline", "--no-audit", "--no-fund", "--loglevel=error"];
  const [program, first] = process.platform === "win32" ? ["cmd", ["/C", "npm"]] : (["npm", []] as const);
  return execFileSync(program, [...first, ...args, ...quiet], { cwd, encoding: "utf8" });
}

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "parkade-"));
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

test("the packed package, installed into an empty folder, runs the README's lines in Node", () => {
  const [packed] = JSON.parse(npm(["pack", "--json", "--pack-destination", folder], PACKAGE));
  writeFileSync(join(folder, "package.json"), "{}");
  npm(["install", `./${packed.filename}`], folder);
  writeFileSync(join(folder, "plan.mjs"), SCRIPT);
  const printed = execFileSync(process.execPath, ["plan.mjs"], { cwd: folder, encoding: "utf8" });
  expect(PRINTED.length).toBeGreaterThan(0);
  expect(printed.trim().split("\n")).toEqual(PRINTED);
});

test("the package and the module in it are of one version", async () => {
  await init();
  const manifest = JSON.parse(readFileSync(join(PACKAGE, "package.json"), "utf8"));
  expect(version()).toBe(manifest.version);
});

test("the package holds every file that it names", () => {
  const manifest = JSON.parse(readFileSync(join(PACKAGE, "package.json"), "utf8"));
  const [packed] = JSON.parse(npm(["pack", "--json", "--dry-run"], PACKAGE));
  const paths: string[] = packed.files.map((file: { path: string }) => file.path);
  expect(paths.sort()).toEqual(["package.json", ...manifest.files].sort());
});
