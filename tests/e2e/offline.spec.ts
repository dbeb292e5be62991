import { expect, test } from "@playwright/test";
import { expectFourAnswers, open, settled, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 }, serviceWorkers: "allow" });

test("after the first visit the page works without a network, below its sub-path", async ({
  page,
  context,
  baseURL,
}) => {
  await open(page);
  const scope = await page.evaluate(async () => (await navigator.serviceWorker.ready).scope);
  expect(scope).toBe(baseURL);
  await context.setOffline(true);
  await page.reload();
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  await settled(page);
  await expectFourAnswers(page);
  await page.waitForFunction(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
  );
  await page.locator("parkade-toolbar .scene").click();
  await expect(page.locator("parkade-presets li button").first()).toBeVisible();
});
