/** The page of consumers names tests that exist and versions that are installed. */
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";

const read = (path: string): string => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const rows = [...read("docs/consumers.md").matchAll(/^\| (.+?) \| (.+?) \| .+ \| `(tests\/[^`]+)`: (.+) \|$/gm)];
const { devDependencies, engines } = JSON.parse(read("package.json")) as {
  devDependencies: Record<string, string>;
  engines: { node: string };
};

test("there are rows", () => {
  expect(rows.length).toBeGreaterThan(15);
});

test.each(rows.map(([, consumer, version, file, title]) => [consumer!, version!, file!, title!]))(
  "%s",
  (consumer, version, file, title) => {
    expect(read(file)).toContain(title);
    const name = consumer.split(",")[0]!.toLowerCase();
    const installed = devDependencies[name];
    if (installed !== undefined) expect(version).toBe(installed);
    if (name === "node.js" && !consumer.includes("require")) expect(engines.node).toBe(`>=${version.split(" ")[0]}`);
  },
);
