import { expect, test } from "@playwright/test";
import { AxeBuilder } from "@axe-core/playwright";
import { complaintsOf, open, sceneOf, settled } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

test("the gallery draws a map by numbers, the next one by the next seed", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  const before = await sceneOf(page);
  await page.locator("parkade-toolbar .scene").click();
  await page.getByRole("button", { name: "Generate" }).click();
  const form = page.locator("parkade-generate form");
  await expect(form.locator("parkade-thumbnail")).toHaveCount(1);
  const picture = () => form.locator("parkade-thumbnail").screenshot();
  await page.waitForTimeout(300);
  const first = await picture();
  await form.getByRole("button", { name: "Next seed" }).click();
  await expect(form.getByLabel("Seed", { exact: true })).toHaveValue("2");
  await expect.poll(async () => (await picture()).equals(first)).toBe(false);
  const { violations } = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  expect(violations.map((one) => one.id)).toEqual([]);
  await form.getByLabel("Cells per side").fill("60");
  await form.getByRole("button", { name: "Open" }).click();
  await expect.poll(async () => (await sceneOf(page)).map.width).toBe(60);
  await settled(page);
  await page.keyboard.press("Control+z");
  await settled(page);
  expect(await sceneOf(page)).toEqual(before);
  expect(complaints).toEqual([]);
});

test("numbers that make no map are refused by field, and nothing opens", async ({ page }) => {
  await open(page);
  const before = await sceneOf(page);
  await page.locator("parkade-toolbar .scene").click();
  await page.getByRole("button", { name: "Generate" }).click();
  const form = page.locator("parkade-generate form");
  for (const [label, value] of [
    ["Cells per side", "3"],
    ["Seed", "-1"],
    ["Blocked cells", "two"],
    ["Block size from", "9"],
  ] as const) {
    const input = form.getByLabel(label, { exact: false }).first();
    const good = await input.inputValue();
    await input.fill(value);
    await form.getByRole("button", { name: "Open" }).click();
    await expect(form.getByRole("alert")).toContainText("must be");
    await expect(form.locator("[aria-invalid=true]")).toHaveCount(1);
    await input.fill(good);
    await expect(form.getByRole("alert")).toHaveText("");
  }
  expect(await sceneOf(page)).toEqual(before);
});
