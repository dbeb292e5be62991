import { expect, test, type Page } from "@playwright/test";
import type { PlaygroundElement } from "./playground";

/** Where the first map's camera is, and how much it shows (metres). */
const seen = (page: Page) =>
  page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("[permalink]")!,
      stage = element.shadowRoot!.querySelector("parkade-stage")!.shadowRoot!;
    const map = (stage.querySelector("parkade-panel")?.shadowRoot ?? stage).querySelector(
      "parkade-scene-view",
    ) as unknown as { view: { camera: { x: number; y: number; scale: number }; width: number } };
    const { camera, width } = map.view;
    return { x: camera.x, metres: width / camera.scale };
  });
const state = (page: Page) =>
  page.evaluate(() => {
    const { planners, focus, follow } = document.querySelector<PlaygroundElement>("[permalink]")!.store
      .state as unknown as { planners: string[]; focus: string; follow: boolean };
    return { planners, focus, follow };
  });
const seek = (page: Page, to: number) =>
  page.evaluate(
    (fraction) => (document.querySelector("[permalink]") as unknown as { seek(f: number): void }).seek(fraction),
    to,
  );

/** Where the road planner's car is in its own drive: the clock of all ends with the slowest of them. */
const carAt = (page: Page, fraction: number): Promise<number> =>
  page.evaluate((part) => {
    const { results } = document.querySelector<PlaygroundElement>("[permalink]")!.store.state as unknown as {
      results: Record<string, { drive: { t: Float64Array; path: Float64Array } | null }>;
    };
    const end = Math.max(...Object.values(results).map(({ drive }) => drive?.t.at(-1) ?? 0));
    const { t, path } = results["cost-map"]!.drive!;
    const row = t.findIndex((one) => one >= part * end);
    return path.at(row < 0 ? -3 : 3 * row)!;
  }, fraction);

async function open(page: Page, scene: string): Promise<void> {
  await page.goto("/");
  await page.evaluate(async (id) => {
    const element = document.querySelector<PlaygroundElement>("[permalink]")!;
    await element.ready;
    element.scene = id;
  }, scene);
  await expect
    .poll(
      () => page.evaluate(() => document.querySelector<PlaygroundElement>("[permalink]")!.results["cost-map"]?.outcome),
      { timeout: 20_000 },
    )
    .toBe("found");
}

test("a road opens on its planner's car, the camera follows the drive, and the whole map is one click away", async ({
  page,
}) => {
  await open(page, "road-narrow");
  expect(await state(page)).toMatchObject({ focus: "cost-map", follow: true });
  expect((await state(page)).planners[0]).toBe("cost-map");
  await expect(page.locator("parkade-panel").first()).toContainText("Cost map");
  await expect.poll(async () => (await seen(page)).metres).toBeLessThan(100);
  for (const fraction of [0, 0.25, 0.5]) {
    await seek(page, fraction);
    await expect.poll(async () => Math.abs((await seen(page)).x - (await carAt(page, fraction)))).toBeLessThan(25);
  }
  const follow = page.locator("parkade-timeline button[aria-label='Follow the car']");
  await follow.click();
  await expect.poll(async () => (await seen(page)).metres).toBeGreaterThan(400);
  await follow.click();
  await expect.poll(async () => (await seen(page)).metres).toBeLessThan(100);
});

test("another scene is fitted, with the planners of before", async ({ page }) => {
  await open(page, "road-straight");
  await page.evaluate(() => {
    document.querySelector<PlaygroundElement>("[permalink]")!.scene = "angled";
  });
  await expect.poll(async () => (await state(page)).planners).toEqual(["four", "eight", "risk-field", "hybrid"]);
  expect((await state(page)).follow).toBe(false);
  await expect(page.locator("parkade-timeline button[aria-label='Follow the car']")).toHaveCount(0);
});
