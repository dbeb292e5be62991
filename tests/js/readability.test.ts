import { readdirSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { readingEase } from "../../docs/.vitepress/readability";

const DOCS = new URL("../../docs/", import.meta.url);
const LESSONS = readdirSync(new URL("learn/", DOCS)).map((file) => `learn/${file}`);
/** Flesch's own name for 50 and more is "fairly difficult" and easier. */
const LEAST = 50;

test("plain sentences read more easily than stiff ones", () => {
  const plain = readingEase("The car stops. It waits for the bus. Then it drives on.");
  const stiff = readingEase(
    "Subsequently the automobile's deceleration necessitates consideration of the approaching vehicle's anticipated " +
      "trajectory.",
  );
  expect(plain).toBeGreaterThan(90);
  expect(stiff).toBeLessThan(10);
});

test.each(["guide.md", ...LESSONS])("%s reads easily", (file) => {
  const ease = readingEase(readFileSync(new URL(file, DOCS), "utf8"));
  console.log(`${file}: reading ease ${ease.toFixed(1)}`);
  expect(ease).toBeGreaterThanOrEqual(LEAST);
});
