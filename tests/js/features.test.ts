import { existsSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";

const root = new URL("../../", import.meta.url);
const rows = readFileSync(new URL("docs/features.md", root), "utf8")
  .split("\n")
  .filter((line) => /^\| (?!Feature|---)/.test(line))
  .map((line) => line.split("|").map((cell) => cell.trim()));

test("every feature that is there names a test that is there", () => {
  expect(rows.length).toBeGreaterThan(70);
  for (const [, feature, verdict, shown] of rows) {
    expect(verdict, feature).toBe("yes");
    const [file, ...name] = shown!.split(": ");
    const path = [`tests/e2e/${file}.spec.ts`, `tests/js/${file}.test.ts`].find((one) =>
      existsSync(new URL(one, root)),
    );
    expect(path, feature).toBeDefined();
    expect(wholeTexts(readFileSync(new URL(path!, root), "utf8")), feature).toContain(`"${name.join(": ")}"`);
  }
});

/** The source with texts that are put together of parts as wholes. */
function wholeTexts(source: string): string {
  return source.replace(/"\s*\+\s*"/g, "");
}
