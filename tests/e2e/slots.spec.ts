import { expect, test, type Page } from "@playwright/test";
import { click, drag, openLot } from "./hands.js";
import { complaintsOf, sceneOf, settled } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 }, hasTouch: true });

const notice = (page: Page) => page.locator("parkade-notices .notice");

test("slots are drawn for the car of the scene; one that is too small offers to fit", async ({ page }) => {
  const complaints = complaintsOf(page);
  await openLot(page);
  await page.keyboard.press("p");
  await drag(page, [[14, 18], [25.5, 18]]);
  expect((await sceneOf(page)).slots).toHaveLength(4);
  expect((await sceneOf(page)).slots![0]).toMatchObject({ width: 2.5, length: 5.2 });
  await expect(notice(page)).toHaveCount(0);
  // The paper's car is longer and wider.
  await page.getByLabel("Vehicle", { exact: true }).selectOption("paper");
  await click(page, [15, 15]);
  await settled(page);
  await expect(notice(page)).toContainText("This slot is 0.3 m too short and 0.1 m too narrow for the car.");
  await notice(page).getByRole("button", { name: "Make it fit" }).click();
  await settled(page);
  const { slots, goal } = await sceneOf(page);
  for (const slot of slots!) expect(slot).toMatchObject({ width: 3.2, length: 6 });
  expect(goal).toEqual({ slot: "slot-1", entry: "reverse-in" });
  await page.keyboard.press("Control+z");
  expect((await sceneOf(page)).slots![0]).toMatchObject({ width: 2.5, length: 5.2 });
  // What is drawn next is made for this car; a length that was typed stays, and is told to be too short.
  await page.keyboard.press("p");
  await drag(page, [[8, 12], [12, 12]]);
  expect([(await sceneOf(page)).vehicle, (await sceneOf(page)).slots!.length, (await sceneOf(page)).slots!.at(-1)]).toMatchObject(["paper", 5, { width: 3.2, length: 6 }]);
  await page.keyboard.press("p");
  await page.locator("parkade-inspector parkade-options").getByLabel("Depth").fill("5.3");
  await page.keyboard.press("Tab");
  await drag(page, [[28, 18], [32, 18]]);
  await expect(notice(page)).toContainText("This slot is 0.2 m too short for the car.");
  expect(complaints).toEqual([]);
});
