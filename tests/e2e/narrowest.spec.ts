import { expect, test } from "@playwright/test";
import { complaintsOf, open, settled, type PlaygroundElement, type Untyped } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

const sentence = "parkade-parameters .narrow";

test("a path that keeps less than the margin asked for says how much, and where; pointed at, the map shows it", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  await open(page);
  await expect
    .poll(() =>
      page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete),
    )
    .toBe(true);
  await settled(page);
  await expect(page.locator(sentence)).toHaveCount(0);
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = { ...element.sceneData, planners: { hybrid: { margin: 0.45 } } };
  });
  await settled(page);
  const { clearance, along } = await page.evaluate(() => {
    const { path, clearances, metrics } =
      document.querySelector<PlaygroundElement>("parkade-playground")!.results["hybrid"]!;
    let driven = 0,
      best = 0;
    for (let i = 1, so = 0; i < clearances.length; i++) {
      so += Math.hypot(path[3 * i]! - path[3 * i - 3]!, path[3 * i + 1]! - path[3 * i - 2]!);
      if (clearances[i]! < clearances[best]!) [best, driven] = [i, so];
    }
    return { clearance: metrics.minClearance.toFixed(2), along: driven.toFixed(1) };
  });
  await expect(page.locator(sentence)).toHaveText(
    new RegExp(`^Keeps ${clearance} m of the 0\\.45 m asked for\\. Narrowest after ${along} m, at .+\\.$`),
  );
  const place = () =>
    page.evaluate(
      () =>
        (document.querySelector<PlaygroundElement>("parkade-playground")!.store as Untyped).state.preview?.place ??
        null,
    );
  await page.locator(sentence).hover();
  expect(await place()).toMatchObject({ body: [expect.any(Number), expect.any(Number)] });
  await page.mouse.move(700, 5);
  expect(await place()).toBeNull();
  expect(complaints).toEqual([]);
});
