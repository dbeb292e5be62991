import { expect, test } from "@playwright/test";
import type { Scenario } from "parkade";
import { init, Planner, scenario } from "../../pkg/node.js";
import type * as Workers from "../../packages/parkade/worker/index";

test("the package plans in workers of a page without a bundler, and a signal ends a search", async ({ page }) => {
  await init();
  const ids = ["perpendicular", "parallel", "angled"];
  const expected = ids.map((id) => new Planner("hybrid", scenario(id)).plan().hash);
  await page.goto("/package/package.json");
  const found = await page.evaluate(
    async (scenes: Scenario[]) => {
      const { createPool } = (await import(
        /* @vite-ignore */ `${location.origin}/package/worker/index.js`
      )) as typeof Workers;
      const pool = createPool({ size: 2 });
      const planners = await Promise.all(scenes.map((scene) => pool.createPlanner("hybrid", scene)));
      const controller = new AbortController();
      const ended = planners[0]!.plan({ signal: controller.signal }).catch((error: Error) => error.name);
      controller.abort();
      const name = await ended;
      const hashes = await Promise.all(planners.map(async (planner) => (await planner.plan()).hash));
      const refused = await pool
        .createPlanner("hybrid", { ...scenes[0]!, start: 1 as never })
        .catch((error: Workers.ParkadeError) => error.message);
      pool.close();
      return { name, hashes, refused };
    },
    ids.map((id) => scenario(id)),
  );
  expect(found).toEqual({ name: "AbortError", hashes: expected, refused: "start: must be an object, got 1" });
});
