import { gzipSync } from "node:zlib";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Locator, type Page } from "@playwright/test";
import { LESSONS } from "../../docs/.vitepress/lessons/contents";
import { complaintsOf, watchShifts } from "./playground";

const SIDE = 34;

/** A figure of the lesson, live. */
async function live(page: Page, id: string): Promise<Locator> {
  const figure = page.locator(`figure[data-lab="${id}"]`);
  await figure.scrollIntoViewIfNeeded();
  await expect(figure).toHaveAttribute("data-live", "yes");
  return figure;
}

/** Drags from cell to cell: columns and rows from the upper left corner. */
async function drag(page: Page, figure: Locator, cells: [number, number][], columns = SIDE): Promise<void> {
  const stage = figure.locator(".lab-stage");
  await stage.scrollIntoViewIfNeeded();
  const box = (await stage.boundingBox())!,
    side = box.width / columns;
  const at = ([x, y]: [number, number]) => [box.x + (x + 0.5) * side, box.y + (y + 0.5) * side] as const;
  await page.mouse.move(...at(cells[0]!));
  await page.mouse.down();
  for (const cell of cells.slice(1)) await page.mouse.move(...at(cell));
  await page.mouse.up();
}

const done = (figure: Locator) => expect(figure).toHaveAttribute("data-done", "yes");
const open = (figure: Locator) => expect(figure).not.toHaveAttribute("data-done", "yes");
const answer = (figure: Locator) => figure.locator(".lab-told");

for (const root of ["/docs/learn/", "/docs/zh/learn/"]) {
  test(`the tasks of ${root}flood are done by hand, and the page checks them`, async ({ page }) => {
    const complaints = complaintsOf(page);
    await page.goto(`${root}flood.html`);
    const order = await live(page, "flood-order");
    await expect(answer(order)).toBeHidden();
    await order.locator("[data-share]").fill("0.5");
    await open(order);
    await order.locator("[data-share]").fill("1");
    await done(order);
    await expect(answer(order)).toBeVisible();

    const estimate = await live(page, "flood-estimate");
    await drag(page, estimate, [[10, 9]]);
    await open(estimate);
    await drag(page, estimate, [[0, 0]]);
    await done(estimate);

    const trap = await live(page, "flood-trap");
    // A press on a wall erases.
    await drag(page, trap, [
      [15, 5],
      [15, 11],
    ]);
    await drag(page, trap, [
      [24, 9],
      [24, 1],
      [1, 1],
    ]);
    await open(trap);
    await drag(page, trap, [
      [24, 10],
      [24, 16],
      [1, 16],
    ]);
    await done(trap);

    const greedy = await live(page, "flood-greedy");
    await drag(page, greedy, [
      [15, 12],
      [15, 16],
      [4, 16],
    ]);
    await drag(page, greedy, [
      [20, 4],
      [20, 17],
    ]);
    await done(greedy);
    expect(complaints).toEqual([]);

    await page.reload();
    await done(page.locator('figure[data-lab="flood-trap"]'));
  });
}

test("cars are moved and turned by hand and by keys, and sliders steer them", async ({ page }) => {
  const complaints = complaintsOf(page);
  await page.goto("/docs/learn/car.html");
  /** The cell whose middle is at these metres. */
  const at = (x: number, y: number): [number, number] => [x - 0.5, 17.5 - y];
  const gap = await live(page, "body-gap");
  await drag(page, gap, [at(8.95, 14.16), at(11, 12)]);
  await expect(gap.locator(".lab-readout")).toContainText("clearance");
  await open(gap);
  await drag(page, gap, [at(6.5, 12), at(17, 9)]);
  await done(gap);

  const turn = await live(page, "body-turn");
  await turn.locator('[data-value="steer"]').fill("20");
  await expect(turn.locator(".lab-readout")).toContainText("hits");
  await open(turn);
  await turn.locator('[data-value="steer"]').fill("33");
  await done(turn);

  const curves = await live(page, "body-curves");
  const before = await curves.locator(".lab-readout").textContent();
  await curves.locator(".lab-stage").focus();
  for (let i = 0; i < 8; i++) await page.keyboard.press("ArrowUp");
  await expect(curves.locator(".lab-readout")).not.toHaveText(before!);
  expect(complaints).toEqual([]);
});

for (const { id } of LESSONS) {
  for (const root of ["/docs/learn/", "/docs/zh/learn/"]) {
    test(`${root}${id} is light, stays still, has stills and answers without scripts, and is accessible`, async ({
      page,
      browser,
    }) => {
      const shifts = await watchShifts(page);
      let bytes = 0;
      page.on("response", async (response) => {
        const body = await response.body().catch(() => Buffer.alloc(0));
        // The package that plans, and the playground of other pages, come when a figure is near.
        const planner =
          response.url().endsWith(".wasm") || body.includes("parkade_bg") || !response.url().includes("/docs/");
        if (!planner) bytes += gzipSync(body).length;
      });
      await page.goto(`${root}${id}.html`, { waitUntil: "networkidle" });
      // Bodies are read after the network is at rest.
      await expect.poll(() => bytes).toBeGreaterThan(40_000);
      expect(bytes).toBeLessThan(150_000);
      for (const figure of await page.locator("figure[data-lab]").all()) {
        await figure.scrollIntoViewIfNeeded();
        await expect(figure).toHaveAttribute("data-live", "yes");
      }
      expect((await shifts()).reduce((sum, one) => sum + one, 0)).toBeLessThan(0.01);
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(violations.map(({ id: rule, nodes }) => [rule, nodes.map(({ html }) => html)])).toEqual([]);

      await page.setViewportSize({ width: 375, height: 800 });
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(375);

      const bare = await browser.newContext({ javaScriptEnabled: false });
      const reader = await bare.newPage();
      await reader.goto(page.url());
      for (const told of await reader.locator(".lab-told").all()) await expect(told).toBeVisible();
      expect(await reader.locator(".lab-stage path").count()).toBeGreaterThan(0);
      await bare.close();
    });
  }
}
