import { expect, test } from "@playwright/test";
import type { Plan } from "parkade";
import { complaintsOf, watchShifts } from "./playground";

interface Embed extends HTMLElement {
  ready: Promise<void>;
  results: Record<string, Plan | null>;
}

test("in the example book playgrounds come alive, move nothing, and leave the book its keys", async ({ page }) => {
  const complaints = complaintsOf(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  const shifts = await watchShifts(page);
  await page.goto("/book/parking.html");
  const outcomes = () =>
    page.evaluate(async () => {
      const found: (string | undefined)[] = [];
      for (const element of document.querySelectorAll<Embed>("parkade-playground")) {
        element.scrollIntoView({ block: "center" });
        await element.ready;
        found.push(...Object.values(element.results).map((plan) => plan?.outcome));
      }
      return found;
    });
  await expect.poll(outcomes).toEqual(["found", "found"]);
  const shown = await page.locator("parkade-playground").boundingBox();
  expect(shown!.width).toBeGreaterThan(400);

  await page.getByRole("button", { name: "Tap to edit" }).click();
  await page
    .locator("parkade-playground canvas")
    .first()
    .click({ position: { x: 30, y: 30 } });
  await expect.poll(() => page.evaluate(() => document.activeElement?.localName)).toBe("parkade-playground");
  await page.keyboard.press("ArrowRight");
  // Were the page turned, it would be gone by then.
  await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 500)));
  expect(page.url()).toContain("parking.html");
  await page.locator("main h1").click();
  await page.keyboard.press("ArrowRight");
  await page.waitForURL("**/grids.html");
  await expect.poll(outcomes).toEqual(["found", "found", "found", "found", "no-path"]);
  expect(Math.max(0, ...(await shifts()))).toBeLessThan(0.01);
  expect(complaints).toEqual([]);
});
