import { expect, test } from "@playwright/test";
import type { GridStats } from "parkade";
import { complaintsOf, open, settled, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

test("closed space is drawn for the planner that closes it, with its counts", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await page.waitForFunction(
    () =>
      (document.querySelector("parkade-playground") as PlaygroundElement & { store: { state: { complete: boolean } } })
        .store.state.complete,
  );
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    const walls = [
      [20, 10, 4],
      [20, 11, 1],
      [23, 11, 1],
      [20, 12, 1],
      [23, 12, 1],
      [20, 13, 1],
      [23, 13, 1],
    ] as [number, number, number][];
    element.sceneData = {
      version: 1,
      map: { origin: [0, 0], width: 40, height: 30, resolution: 1 },
      obstacles: [{ type: "cells", runs: walls }],
      vehicle: { wheelbase: 1, width: 0.8, rearToFront: 1.25, rearToBack: 0.25, maxSteer: 0.6 },
      start: { x: 5.5, y: 15.5, heading: 0 },
      goal: { x: 35.5, y: 15.5, heading: 0 },
      planners: { eight: { minPassage: 3, trapMouth: 4 } },
    };
  });
  await settled(page);
  const panel = page.locator("parkade-panel").nth(1),
    legend = panel.locator(".legend").first();
  await expect(legend).not.toContainText("too narrow");
  const without = await panel.locator("canvas").screenshot();
  await page.getByRole("button", { name: "Layers" }).click();
  await page.getByLabel("Closed space").check();
  await page.keyboard.press("Escape");
  await settled(page);
  await expect(legend).toContainText(/\d+ too narrow, \d+ in pockets, \d+ restored/);
  const { narrow = 0, pocket = 0 }: GridStats = await page.evaluate(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.results["eight"]!.stats,
  );
  expect(narrow + pocket).toBeGreaterThan(0);
  await expect.poll(async () => (await panel.locator("canvas").screenshot()).equals(without)).toBe(false);
  await expect(page.locator("parkade-panel").first().locator(".legend")).not.toContainText("too narrow");
  expect(complaints).toEqual([]);
});

test("the shortest way at any angle is measured beside a grid planner's path", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = {
      version: 1,
      map: { origin: [0, 0], width: 40, height: 30, resolution: 1 },
      obstacles: [{ type: "cells", runs: [] }],
      vehicle: { wheelbase: 1, width: 0.8, rearToFront: 1.25, rearToBack: 0.25, maxSteer: 0.6 },
      start: { x: 5.5, y: 5.5, heading: 0 },
      goal: { x: 35.5, y: 20.5, heading: 0 },
      planners: { eight: { post: "none" } },
    };
    element.store.set({ focus: "eight" });
  });
  await settled(page);
  const yardstick = page.locator("parkade-any-angle");
  await yardstick.getByRole("button", { name: "Measure" }).click();
  // A straight line of 30 by 15 cells; eight neighbours take 15 steps straight and 15 diagonal.
  await expect(yardstick.locator("output")).toHaveText("33.54 m");
  await expect(yardstick).toContainText("+8.0 %");
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ focus: "hybrid" }),
  );
  await expect(yardstick).toBeHidden();
  expect(complaints).toEqual([]);
});

test("what becomes of a grid path, and the risk field's potential, are drawn in the search tree's layer", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  await open(page);
  await page.evaluate(async () => {
    const element = document.querySelector<
      PlaygroundElement & { app: { complete(): Promise<unknown>; openPreset(id: string): void } }
    >("parkade-playground")!;
    await element.app.complete();
    element.app.openPreset("fig8-30");
    element.store.set({ focus: "risk-field" });
  });
  await settled(page);
  const canvas = page.locator("parkade-panel").nth(2).locator("canvas"),
    without = await canvas.screenshot();
  await page.getByRole("button", { name: "Layers" }).click();
  await page.getByLabel("Search tree").check();
  await page.keyboard.press("Escape");
  await settled(page);
  const held = await page.evaluate(() => {
    const { results } = document.querySelector<
      PlaygroundElement & {
        store: {
          state: {
            results: Record<
              string,
              {
                plan: { stages?: { pruned: unknown[]; arcs: unknown[] } };
                layers: Record<string, { data: ArrayLike<number> }>;
              }
            >;
          };
        };
      }
    >("parkade-playground")!.store.state;
    const { plan, layers } = results["risk-field"]!;
    return {
      pruned: plan.stages!.pruned.length,
      arcs: plan.stages!.arcs.length,
      cells: layers["potential"]!.data.length,
      other: "potential" in results["eight"]!.layers,
    };
  });
  expect(held.pruned).toBeGreaterThan(2);
  expect(held.arcs).toBeGreaterThan(0);
  expect(held).toMatchObject({ cells: 900, other: false });
  await expect.poll(async () => (await canvas.screenshot()).equals(without)).toBe(false);
  expect(complaints).toEqual([]);
});
