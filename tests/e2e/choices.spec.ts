import { expect, test } from "@playwright/test";
import { complaintsOf, open, settled, type PlaygroundElement } from "./playground.js";

const chips = "parkade-panel[data-planner=hybrid] parkade-choices button";
const shown = (element: PlaygroundElement): [number, number] => {
  const { length, directionChanges } = (element.store as any).state.results.hybrid.plan.metrics;
  return [length, directionChanges];
};

test("chips under hybrid's title show other paths and choose them; the link keeps the choice", async ({ page, context }) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  const complaints = complaintsOf(page);
  await open(page);
  const playground = page.locator("parkade-playground");
  await playground.evaluate((element: PlaygroundElement) => { element.scene = "L2"; });
  await settled(page);
  const ordinary = await playground.evaluate(shown);
  await expect(page.locator(chips).first()).toBeVisible({ timeout: 20_000 });
  const fewest = page.locator(chips, { hasText: /· 0$/ });
  await expect(page.locator(chips).and(page.locator("[aria-pressed=true]"))).toHaveText(/23\.3 m · 1/);
  // Pointed at, a path is only looked at.
  await fewest.hover();
  await expect.poll(() => playground.evaluate((element: PlaygroundElement) => (element.store as any).state.preview?.plan.metrics.directionChanges)).toBe(0);
  expect(await playground.evaluate(shown)).toEqual(ordinary);
  await fewest.click();
  await expect.poll(async () => (await playground.evaluate(shown))[1]).toBe(0);
  await expect(fewest).toHaveAttribute("aria-pressed", "true");
  await expect(page.locator("parkade-table tr[data-planner=hybrid]")).toContainText("52.8");
  const chosen = await playground.evaluate(shown);
  const link = await playground.evaluate((element: PlaygroundElement) => (element as any).app.links.address(true) as Promise<string>);
  const other = await context.newPage();
  await other.goto(link);
  await settled(other);
  await expect.poll(() => other.locator("parkade-playground").evaluate(shown)).toEqual(chosen);
  // And back to what is planned without a choice.
  await page.locator(chips).first().click();
  await expect.poll(() => playground.evaluate(shown)).toEqual(ordinary);
  expect(complaints).toEqual([]);
});

test("a drag and another scene end the search for alternatives, and old chips go", async ({ page }) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  await open(page);
  await expect(page.locator(chips).first()).toBeVisible({ timeout: 20_000 });
  const playground = page.locator("parkade-playground");
  await playground.evaluate((element: PlaygroundElement) => {
    const store = element.store as any, { scene } = store.state;
    store.edit({ ...scene, start: { ...scene.start, x: scene.start.x + 0.3 } }, { transient: true });
  });
  await expect(page.locator(chips)).toHaveCount(0);
  await playground.evaluate((element: PlaygroundElement) => { element.scene = "reverse-in"; });
  await settled(page);
  await expect.poll(() => playground.evaluate((element: PlaygroundElement) => (element.store as any).state.preview)).toBe(null);
});

test("on a phone chips are there for the focused planner, without covering its name", async ({ browser }) => {
  const page = await browser.newPage({ viewport: { width: 390, height: 844 }, hasTouch: true });
  await open(page);
  const chip = page.locator("parkade-choices button").first();
  await expect(chip).toBeVisible({ timeout: 20_000 });
  const box = (await chip.boundingBox())!;
  expect(box.height).toBeGreaterThanOrEqual(34);
  expect(box.y).toBeGreaterThan(80);
  await page.close();
});
