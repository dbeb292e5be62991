import { expect, test, type Page } from "@playwright/test";
import { AxeBuilder } from "@axe-core/playwright";
import { complaintsOf, look, onScreen, open, sceneOf, settled, type PlaygroundElement } from "./playground.js";

const dialog = (page: Page) => page.locator("parkade-new-lot dialog");
const planned = (page: Page) => expect(dialog(page).getByRole("status")).toHaveText(/^Into bay 1: [\d.]+ m, \d+ gear changes?$/);

/** The middle of slot 5 on the map, once the camera shows the whole lot at so many pixels to the metre. */
async function fifthBay(page: Page, scale: number): Promise<{ x: number; y: number }> {
  await settled(page);
  const { map, slots } = await sceneOf(page), slot = slots![4]!;
  await look(page, map.width * map.resolution / 2, map.height * map.resolution / 2, scale);
  return onScreen(page, slot.x + Math.cos(slot.heading) * slot.length / 2, slot.y + Math.sin(slot.heading) * slot.length / 2);
}

async function expectParked(page: Page): Promise<void> {
  await expect.poll(async () => (await sceneOf(page)).goal).toEqual({ slot: "slot-5", entry: "reverse-in" });
  await settled(page);
  const scene = await sceneOf(page);
  expect(scene.slots!.map((slot) => slot.occupied ?? false)).toEqual([false, false, true, false, false, false, true, false]);
  expect(await page.evaluate(() => {
    const { hybrid } = document.querySelector<PlaygroundElement>("parkade-playground")!.results;
    return hybrid && { outcome: hybrid.outcome, drivable: hybrid.check.drivable };
  })).toEqual({ outcome: "found", drivable: true });
}

/** Keeps a picture of each step where a folder for them is given. */
function pictures(page: Page, name: string): () => Promise<unknown> {
  const folder = process.env.PARKADE_TEST_PICTURES;
  let step = 0;
  return async () => folder && page.screenshot({ path: `${folder}/${name}-${++step}.png` });
}

test.describe("with a mouse", () => {
  test.use({ viewport: { width: 1400, height: 900 } });

  test("a newcomer's own lot is parked in within four clicks, and undone in two steps", async ({ page }) => {
    const complaints = complaintsOf(page), picture = pictures(page, "newcomer");
    await open(page);
    const before = await sceneOf(page);
    const steps = [
      () => page.locator("parkade-toolbar .scene").click(),
      () => page.getByRole("button", { name: "New lot" }).click().then(() => planned(page)),
      () => dialog(page).getByRole("button", { name: "Open" }).click(),
      async () => {
        const at = await fifthBay(page, 16);
        await page.mouse.click(at.x, at.y);
        await expectParked(page);
      },
    ];
    await picture();
    for (const step of steps) {
      await step();
      await picture();
    }
    for (let i = 0; i < 2; i++) await page.keyboard.press("Control+z");
    expect(await sceneOf(page)).toEqual(before);
    expect(complaints).toEqual([]);
  });

  test("numbers are typed, stepped and dragged; what makes no lot is refused by name", async ({ page }) => {
    const complaints = complaintsOf(page);
    await open(page);
    const before = await sceneOf(page);
    await page.locator("parkade-toolbar").getByRole("button", { name: "Export" }).click();
    await page.getByRole("button", { name: "New lot…" }).click();
    await planned(page);
    const form = dialog(page), field = (name: string) => form.getByRole("textbox", { name, exact: true });
    await field("Bay width").press("ArrowUp");
    await expect(field("Bay width")).toHaveValue("2.6");
    await form.getByRole("slider", { name: "Bays in a row", exact: true }).fill("12");
    await expect(field("Bays in a row")).toHaveValue("12");
    await planned(page);
    await field("Aisle width").fill("2");
    await expect(form.getByRole("status")).toHaveText("Aisle width must be at least 2.7 m here.");
    await expect(form.locator("[aria-invalid=true]")).toHaveCount(1);
    await expect(form.getByRole("button", { name: "Open" })).toBeDisabled();
    await field("Aisle width").fill("7");
    const { violations } = await new AxeBuilder({ page }).withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]).analyze();
    expect(violations.map((one) => one.id)).toEqual([]);
    await page.keyboard.press("Escape");
    await expect(form).toBeHidden();
    expect(await sceneOf(page)).toEqual(before);
    // The numbers are kept, and Enter opens them.
    await page.locator("parkade-toolbar").getByRole("button", { name: "Export" }).click();
    await page.getByRole("button", { name: "New lot…" }).click();
    await planned(page);
    await page.keyboard.press("Enter");
    await expect(form).toBeHidden();
    expect((await sceneOf(page)).slots).toHaveLength(12);
    expect((await sceneOf(page)).slots![0]!.width).toBe(2.6);
    expect(complaints).toEqual([]);
  });
});

test.describe("with a finger", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("a newcomer's own lot is parked in within four taps", async ({ page }) => {
    const complaints = complaintsOf(page), picture = pictures(page, "newcomer-phone");
    await open(page);
    const steps = [
      () => page.locator("parkade-toolbar .scene").tap(),
      () => page.getByRole("button", { name: "New lot" }).tap().then(() => planned(page)),
      () => dialog(page).getByRole("button", { name: "Open" }).tap(),
      async () => {
        const at = await fifthBay(page, 12);
        await page.touchscreen.tap(at.x, at.y);
        await expectParked(page);
      },
    ];
    await picture();
    for (const step of steps) {
      await step();
      await picture();
    }
    expect(complaints).toEqual([]);
  });
});
