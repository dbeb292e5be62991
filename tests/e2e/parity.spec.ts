import { readFileSync } from "node:fs";
import { expect, test } from "@playwright/test";
import { init, scenario } from "../../pkg/node.js";
import { answered, open, settled, type PlaygroundElement } from "./playground";

const file = new URL("../data/plan-hashes.json", import.meta.url);
const expected = JSON.parse(readFileSync(file, "utf8")) as Record<string, Record<string, string>>;

test("every planner's plan on every preset has the native hash in the browser", async ({ page }) => {
  test.setTimeout(120_000);
  await init();
  await open(page);
  await settled(page);
  for (const [id, hashes] of Object.entries(expected)) {
    const scene = scenario(id);
    await page.evaluate(
      ([next, planners]) => {
        const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
        element.store.set({ planners });
        element.sceneData = next;
      },
      [scene, Object.keys(hashes)] as const,
    );
    await answered(page);
    const found = await page.evaluate(() => {
      const { results } = document.querySelector<PlaygroundElement>("parkade-playground")!;
      return Object.fromEntries(Object.entries(results).map(([planner, plan]) => [planner, plan?.hash]));
    });
    expect(found, id).toMatchObject(hashes);
  }
});
