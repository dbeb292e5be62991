/** Lines that people write fit side by side on a screen. Markdown, JSON and the one-line commands of YAML are free. */
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";

const ROOT = join(import.meta.dirname, "../.."),
  WIDEST = 120;

it(`no line of a source has more than ${WIDEST} columns`, () => {
  const sources = execFileSync("git", ["ls-files"], { cwd: ROOT, encoding: "utf8" })
    .split("\n")
    .filter((file) => /\.(rs|ts|js|mjs|css|html|toml|sh|py)$/.test(file) && existsSync(join(ROOT, file)));
  expect(sources.length).toBeGreaterThan(700);
  const wide = sources.flatMap((file) =>
    readFileSync(join(ROOT, file), "utf8")
      .split("\n")
      .flatMap((line, at) => (line.length > WIDEST ? [`${file}:${at + 1}`] : [])),
  );
  expect(wide).toEqual([]);
});
