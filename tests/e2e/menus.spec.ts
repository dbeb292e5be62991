import { expect, test } from "@playwright/test";
import { open } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

test("the menu at the pointer is over everything, and closes at Escape or a press elsewhere", async ({ page }) => {
  await open(page);
  const canvas = page.locator("parkade-panel[active] canvas"),
    shown = page.locator("parkade-context .popover:popover-open"),
    box = (await canvas.boundingBox())!;
  const [x, y] = [box.x + box.width - 8, box.y + box.height - 8];
  await canvas.focus();
  await page.mouse.click(x, y, { button: "right" });
  await expect(shown.getByRole("menuitem").first()).toBeFocused();
  const menu = (await shown.boundingBox())!;
  expect(menu.x + menu.width).toBeLessThanOrEqual(1400);
  expect(menu.y + menu.height).toBeLessThanOrEqual(900);
  // Every corner of it is what is pressed there.
  const isOnTop = await shown.evaluate((element) => {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const root = element.getRootNode() as ShadowRoot;
    return [left + 12, right - 12].every((at) =>
      [top + 12, bottom - 12].every((down) => element.contains(root.elementFromPoint(at, down))),
    );
  });
  expect(isOnTop).toBe(true);
  await page.keyboard.press("Escape");
  await expect(shown).toHaveCount(0);
  await expect(canvas).toBeFocused();
  await page.mouse.click(x, y, { button: "right" });
  await expect(shown).toHaveCount(1);
  await page.mouse.click(box.x + 20, box.y + 60);
  await expect(shown).toHaveCount(0);
});

test("a menu closes at Escape, a second press and a press elsewhere; by keys the focus goes back", async ({ page }) => {
  await open(page);
  const bar = page.locator("parkade-toolbar"),
    layers = bar.getByRole("button", { name: "Layers", exact: true }),
    shown = bar.locator(".popover:popover-open");
  await layers.click();
  await expect(shown.getByRole("button", { name: "Clean" })).toBeFocused();
  await page.keyboard.press("ArrowDown");
  await expect(shown.getByRole("button", { name: "Search", exact: true })).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(shown).toHaveCount(0);
  await expect(layers).toBeFocused();
  await layers.click();
  await expect(shown).toHaveCount(1);
  await layers.click();
  await expect(shown).toHaveCount(0);
  await expect(layers).toHaveAttribute("aria-expanded", "false");
  await layers.click();
  await bar.getByRole("button", { name: "Export" }).click();
  await expect(shown.getByRole("button", { name: "Save scene" })).toBeVisible();
  await expect(shown).toHaveCount(1);
  const map = (await page.locator("parkade-stage").boundingBox())!;
  await page.mouse.click(map.x + 20, map.y + map.height - 20);
  await expect(shown).toHaveCount(0);
});
