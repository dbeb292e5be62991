import { expect, test } from "@playwright/test";
import {
  complaintsOf,
  damagedLinks,
  damagedMessages,
  damagedStores,
  ready,
  watchTurns,
} from "../endurance/damaged-page.mjs";
import { monkey } from "../endurance/monkey-page.mjs";
import { random } from "../endurance/random.mjs";

// A little of what `cargo xtask endurance damaged` and `cargo xtask endurance monkey` do for long.
const SEED = 20261123;

test.use({ viewport: { width: 1400, height: 900 } });

test.beforeEach(async ({ page }) => {
  test.setTimeout(180_000);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.addInitScript(watchTurns);
});

test("damaged links and stored states: nothing is thrown, no frame is held, and the page plans afterwards", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  await page.goto("./");
  await ready(page);
  expect((await damagedLinks(page, random(SEED), 60, false)).lost).toEqual([]);
  expect((await damagedLinks(page, random(SEED + 1), 60, true)).lost).toEqual([]);
  expect((await damagedStores(page, random(SEED + 2), 8)).lost).toEqual([]);
  expect(complaints).toEqual([]);
});

test("damaged messages to a frame: nothing is thrown, no frame is held, and it plans afterwards", async ({ page }) => {
  const complaints = complaintsOf(page);
  await page.goto("/host/frame.html");
  const { tried, lost } = await damagedMessages(page, random(SEED), 200);
  expect([tried, lost]).toEqual([200, []]);
  expect(complaints).toEqual([]);
});

for (const [name, address] of [
  ["the page", "./"],
  ["a frame", `/host/frame.html?hash=${encodeURIComponent("layout=grid&controls=full&editable")}`],
] as const) {
  test(
    `120 random clicks, keys and touches on ${name}: nothing is said on the console, no text reads NaN, and it ` +
      `plans afterwards`,
    async ({ page }) => {
      await page.goto(address);
      await page.waitForTimeout(1500);
      const found = await monkey(page, random(SEED), {
        frame: () => page.frames().at(-1),
        enough: (actions: number) => actions >= 120,
      });
      expect(found.complaints).toEqual([]);
      expect(found.usable).toBe(true);
    },
  );
}

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("120 random touches: nothing is said on the console, no text reads NaN, and the page plans afterwards", async ({
    page,
  }) => {
    await page.goto("./");
    await page.waitForTimeout(1500);
    const found = await monkey(page, random(SEED), {
      frame: () => page.frames().at(-1),
      touch: true,
      enough: (actions: number) => actions >= 120,
    });
    expect(found.complaints).toEqual([]);
    expect(found.usable).toBe(true);
  });
});
