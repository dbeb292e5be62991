/** The page of consumers names tests that exist and versions that are installed. */
import { readFileSync, readdirSync } from "node:fs";
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

test("the package ships every file of the command and of its workers", () => {
  const { files } = JSON.parse(read("packages/parkade/package.json")) as { files: string[] };
  for (const folder of ["cli", "worker"])
    for (const name of readdirSync(new URL(`../../packages/parkade/${folder}`, import.meta.url)))
      if (name !== "protocol.d.ts") expect(files).toContain(`${folder}/${name}`);
});
