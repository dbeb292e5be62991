import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, open, settled, type PlaygroundElement, type Untyped } from "./playground.js";

const chips = "parkade-panel[data-planner=hybrid] parkade-choices button";
const shown = (element: PlaygroundElement): [number, number] => {
  const { length, directionChanges } = (element.store as Untyped).state.results.hybrid.plan.metrics;
  return [length, directionChanges];
};

test("chips under hybrid's title show other paths and choose them; the link keeps the choice", async ({
  page,
  context,
}) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  const complaints = complaintsOf(page);
  await open(page);
  const playground = page.locator("parkade-playground");
  await playground.evaluate((element: PlaygroundElement) => {
    element.scene = "L2";
  });
  await settled(page);
  await expect(page.locator(chips).first()).toBeVisible({ timeout: 20_000 });
  // The search for other paths may have bettered the first answer.
  const ordinary = await playground.evaluate(shown);
  const fewest = page.locator(chips, { hasText: /· 0$/ });
  const pressed = page.locator(chips).and(page.locator("[aria-pressed=true]"));
  await expect(pressed).toHaveText(new RegExp(`${ordinary[0].toFixed(1)} m · ${ordinary[1]}`));
  // Pointed at, a path is only looked at.
  await fewest.hover();
  await expect
    .poll(() =>
      playground.evaluate(
        (element: PlaygroundElement) => (element.store as Untyped).state.preview?.plan.metrics.directionChanges,
      ),
    )
    .toBe(0);
  expect(await playground.evaluate(shown)).toEqual(ordinary);
  await fewest.click();
  await expect.poll(async () => (await playground.evaluate(shown))[1]).toBe(0);
  await expect(fewest).toHaveAttribute("aria-pressed", "true");
  const chosen = await playground.evaluate(shown);
  await expect(pressed).toHaveText(new RegExp(`${chosen[0].toFixed(1)} m · 0`));
  const link = await playground.evaluate(
    (element: PlaygroundElement) => (element as Untyped).app.links.address(true) as Promise<string>,
  );
  const other = await context.newPage();
  await other.goto(link);
  await settled(other);
  await expect.poll(() => other.locator("parkade-playground").evaluate(shown)).toEqual(chosen);
  // And back to what is planned without a choice.
  await page.locator(chips).first().click();
  await expect.poll(() => playground.evaluate(shown)).toEqual(ordinary);
  expect(complaints).toEqual([]);
});

/** Everything that hybrid's panel showed: its path's cost and gear changes, and whether better ones were looked for. */
const watch = (element: PlaygroundElement): void => {
  const seen: unknown[] = [];
  Object.assign(window, { seen });
  (element.store as Untyped).subscribe(({ results, improving, transient }: Untyped) => {
    const { cost, directionChanges } = results.hybrid?.plan?.metrics ?? {},
      next = JSON.stringify([cost, directionChanges, improving ?? null, transient]);
    if (seen.at(-1) !== next) seen.push(next);
  });
};
const seen = (page: Page): Promise<[number, number, string | null, boolean][]> =>
  page.evaluate(() => (window as Untyped).seen.map((text: string) => JSON.parse(text)));

test(
  "the first answer is drawn at once, cheaper ones replace it while a line runs, and a drag goes on from what is " +
    "shown",
  async ({ page }) => {
    await page.setViewportSize({ width: 1400, height: 900 });
    const complaints = complaintsOf(page);
    await open(page);
    const playground = page.locator("parkade-playground"),
      choices = page.locator("parkade-panel[data-planner=hybrid] parkade-choices");
    await expect(page.locator(chips).first()).toBeVisible({ timeout: 20_000 });
    await playground.evaluate(watch);
    // The line may be gone before anybody looks.
    await choices.evaluate((element) => {
      const lines: string[] = ((window as Untyped).lines = []);
      new MutationObserver(() => {
        if (element.hasAttribute("searching")) lines.push(getComputedStyle(element, "::before").height);
      }).observe(element, { attributes: true });
    });
    await playground.evaluate((element: PlaygroundElement) => {
      element.scene = "perp-nose-3.6";
    });
    await settled(page);
    await expect.poll(() => page.evaluate(() => (window as Untyped).lines[0]), { timeout: 20_000 }).toBe("2px");
    await expect(page.locator(chips).first()).toBeVisible({ timeout: 20_000 });
    await expect(choices).not.toHaveAttribute("searching");
    // Those of the scene before cost 18.
    const steps = (await seen(page)).filter(([cost]) => cost > 20),
      costs = steps.map(([cost]) => cost);
    expect(costs).toEqual([...costs].sort((a, b) => b - a));
    expect(costs.at(-1)).toBeLessThan(costs[0]!);
    expect(steps.some(([, , improving]) => improving === "hybrid")).toBe(true);
    // As the package says it, whose first answer costs 24.5 and the better one 23.5.
    expect(costs[0]).toBeGreaterThan(24);
    expect(costs.at(-1)).toBeLessThan(24);
    expect(steps.at(-1)!.slice(1)).toEqual([1, null, false]);
    for (const title of await page.locator(chips).evaluateAll((all) => all.map((one) => (one as HTMLElement).title)))
      expect(title).toMatch(/shortest|No path can be shorter than 17\.3 m/);
    // A drag's first step keeps the path that is shown, not the planner's first answer.
    await playground.evaluate((element: PlaygroundElement) => {
      const store = element.store as Untyped,
        { scene } = store.state;
      store.edit({ ...scene, start: { ...scene.start, x: scene.start.x + 0.02 } }, { transient: true });
    });
    await expect(page.locator(chips)).toHaveCount(0);
    await expect
      .poll(
        async () =>
          await playground.evaluate(
            (element: PlaygroundElement) => (element.store as Untyped).state.results.hybrid.status,
          ),
      )
      .toBe("done");
    expect((await playground.evaluate(shown))[0]).toBeLessThan(23);
    expect(complaints).toEqual([]);
  },
);

test("a path that cannot be shorter is said to be proven, and nothing runs for it", async ({ page }) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  await open(page);
  await expect(page.locator(chips).first()).toBeVisible({ timeout: 20_000 });
  const playground = page.locator("parkade-playground");
  await playground.evaluate((element: PlaygroundElement) => {
    element.scene = "P2";
  });
  await settled(page);
  await playground.evaluate(watch);
  await expect(page.locator(chips).first()).toBeVisible({ timeout: 20_000 });
  await playground.evaluate((element: PlaygroundElement) =>
    (element.store as Untyped).set({ prefer: { hybrid: "shortest" } }),
  );
  const { gapPercent, rsBound, length } = await playground.evaluate(
    (element: PlaygroundElement) => (element.store as Untyped).state.results.hybrid.plan.metrics,
  );
  expect(gapPercent).toBeCloseTo((length / rsBound - 1) * 100, 9);
  const title = await page.locator(chips).and(page.locator("[aria-pressed=true]")).getAttribute("title");
  expect(title).toContain(
    gapPercent < 1e-4
      ? "Proven shortest."
      : `Within ${(Math.ceil(gapPercent * 10) / 10).toFixed(1)} % of the shortest possible.`,
  );
});

test("a drag and another scene end the search for alternatives, and old chips go", async ({ page }) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  await open(page);
  await expect(page.locator(chips).first()).toBeVisible({ timeout: 20_000 });
  const playground = page.locator("parkade-playground");
  await playground.evaluate((element: PlaygroundElement) => {
    const store = element.store as Untyped,
      { scene } = store.state;
    store.edit({ ...scene, start: { ...scene.start, x: scene.start.x + 0.3 } }, { transient: true });
  });
  await expect(page.locator(chips)).toHaveCount(0);
  await playground.evaluate((element: PlaygroundElement) => {
    element.scene = "reverse-in";
  });
  await settled(page);
  await expect
    .poll(() => playground.evaluate((element: PlaygroundElement) => (element.store as Untyped).state.preview))
    .toBe(null);
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
