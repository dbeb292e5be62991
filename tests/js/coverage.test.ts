import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const root = fileURLToPath(new URL("../../", import.meta.url));
const text = readFileSync(join(root, "docs/papers/coverage.md"), "utf8");
const rows = text
  .split("\n")
  .filter((line) => /^\| \d/.test(line))
  .map((line) =>
    line
      .split(/(?<!\\)\|/)
      .map((cell) => cell.trim())
      .slice(1, -1),
  );

const rust = ["src", "tests"]
  .flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true, encoding: "utf8" })
      .filter((name) => name.endsWith(".rs"))
      .map((name) => readFileSync(join(root, folder, name), "utf8")),
  )
  .join("\n");

/**
 * True if a test of this name is there: a Rust function that is marked as one, or a title of a file of `tests/js` or
 * `tests/e2e`.
 */
function exists(name: string): boolean {
  if (/^\w+$/.test(name))
    return new RegExp(`#\\[(cfg_attr\\([^\\n]*)?test[^\\n]*\\n(#\\[[^\\n]*\\n|\\s)*fn ${name}\\(`).test(rust);
  const [file, ...title] = name.split(": ");
  const path = [`tests/e2e/${file}.spec.ts`, `tests/js/${file}.test.ts`]
    .map((one) => join(root, one))
    .find((one) => existsSync(one));
  return path !== undefined && readFileSync(path, "utf8").includes(`"${title.join(": ")}"`);
}

test("the papers have 83 items, numbered, and none is missing", () => {
  expect(rows.map(([number]) => Number(number))).toEqual(Array.from({ length: 83 }, (_, i) => i + 1));
  for (const row of rows) {
    expect(row.length, row[0]).toBe(6);
    for (const cell of row) expect(cell, row.join(" | ")).not.toBe("");
    expect(row.join(" "), row[0]).not.toMatch(/\bmissing\b|\bTODO\b/i);
  }
});

test("every item names a test that is there", () => {
  expect(["no_such_test", "papers: no such title", "nowhere: x"].map(exists)).toEqual([false, false, false]);
  for (const [number, item, , , shown] of rows) {
    const names = [...shown!.matchAll(/`([^`]+)`/g)].map(([, name]) => name!);
    expect(names.length, `${number} ${item}`).toBeGreaterThan(0);
    for (const name of names) expect(exists(name), `${number} ${item}: ${name}`).toBe(true);
  }
});

test("every deviation has its reason, in a sentence", () => {
  for (const [number, item, , , , deviation] of rows) {
    if (deviation !== "–") expect(deviation, `${number} ${item}`).toMatch(/^["A-Z0-9].{30,}[.]$/);
  }
});
