import { expect, test, type Locator, type Page } from "@playwright/test";
import type { Scenario } from "parkade";
import { AxeBuilder } from "@axe-core/playwright";
import { complaintsOf, open, sceneOf, settled, type PlaygroundElement } from "./playground.js";

const dialog = (page: Page) => page.locator("parkade-new-lot dialog");
const planned = (page: Page) =>
  expect(dialog(page).getByRole("status")).toHaveText(/^Into bay 1: [\d.]+ m, \d+ gear changes?$/);

/** Where the page's own camera shows a point of the world, on the focused planner's map. */
function seenAt(page: Page, x: number, y: number): Promise<{ x: number; y: number }> {
  return page.evaluate(
    ([wx, wy]) => {
      type View = HTMLElement & {
        canvas: HTMLCanvasElement;
        view: { camera: { x: number; y: number; scale: number } };
      };
      const inner = (root: ParentNode): View | null => {
        for (const element of root.querySelectorAll("*")) {
          if (element.localName === "parkade-panel" && !element.hasAttribute("active")) continue;
          if (element.localName === "parkade-scene-view") return element as View;
          const found = element.shadowRoot ? inner(element.shadowRoot) : null;
          if (found) return found;
        }
        return null;
      };
      const {
          canvas,
          view: { camera },
        } = inner(document)!,
        box = canvas.getBoundingClientRect();
      return {
        x: box.left + box.width / 2 + (wx - camera.x) * camera.scale,
        y: box.top + box.height / 2 - (wy - camera.y) * camera.scale,
      };
    },
    [x, y] as const,
  );
}

/** The middle of slot 5 on the map, once it is drawn. */
async function fifthBay(page: Page): Promise<{ x: number; y: number }> {
  await settled(page);
  await page.evaluate(async () => {
    for (let frame = 0; frame < 6; frame++) await new Promise(requestAnimationFrame);
  });
  const slot = (await sceneOf(page)).slots![4]!;
  return seenAt(
    page,
    slot.x + (Math.cos(slot.heading) * slot.length) / 2,
    slot.y + (Math.sin(slot.heading) * slot.length) / 2,
  );
}

/** Width and depth of the ground. */
function groundOf({ map: { width, height, resolution, boundary } }: Scenario): [number, number] {
  return boundary
    ? [
        Math.max(...boundary.map((p) => p[0])) - Math.min(...boundary.map((p) => p[0])),
        Math.max(...boundary.map((p) => p[1])) - Math.min(...boundary.map((p) => p[1])),
      ]
    : [width * resolution, height * resolution];
}

const middleOf = async (one: Locator): Promise<{ x: number; y: number }> => {
  const box = (await one.boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};

async function expectParked(page: Page): Promise<void> {
  await expect.poll(async () => (await sceneOf(page)).goal).toEqual({ slot: "slot-5", entry: "reverse-in" });
  await settled(page);
  const scene = await sceneOf(page);
  expect(scene.slots!.map((slot) => slot.occupied ?? false)).toEqual([
    false,
    false,
    true,
    false,
    false,
    false,
    true,
    false,
  ]);
  expect(
    await page.evaluate(() => {
      const { hybrid } = document.querySelector<PlaygroundElement>("parkade-playground")!.results;
      return hybrid && { outcome: hybrid.outcome, drivable: hybrid.check.drivable };
    }),
  ).toEqual({ outcome: "found", drivable: true });
}

/** Keeps a picture of each step beside the test's results. */
function pictures(page: Page, name: string): () => Promise<unknown> {
  let step = 0;
  return () => page.screenshot({ path: test.info().outputPath(`${name}-${++step}.png`) });
}

test.describe("with a mouse", () => {
  test.use({ viewport: { width: 1400, height: 900 } });

  test("a newcomer's own lot is parked in within four clicks, and undone in two steps", async ({ page }) => {
    const complaints = complaintsOf(page),
      picture = pictures(page, "newcomer");
    await open(page);
    const before = await sceneOf(page);
    const steps = [
      () => page.locator("parkade-toolbar .scene").click(),
      () =>
        page
          .getByRole("button", { name: "New lot" })
          .click()
          .then(() => planned(page)),
      () => dialog(page).getByRole("button", { name: "Open" }).click(),
      async () => {
        const at = await fifthBay(page);
        await page.mouse.click(at.x, at.y);
        await expectParked(page);
      },
    ];
    await picture();
    for (const step of steps) {
      await step();
      await picture();
    }
    // The ground is made wider afterwards; the car still parks, and nothing else has changed.
    const { obstacles, slots, start, goal, ...lot } = await sceneOf(page),
      [width, depth] = groundOf(lot as Scenario);
    const at = await seenAt(page, width, depth / 2),
      to = await seenAt(page, width + 1.5, depth / 2);
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 6 });
    await picture();
    await page.mouse.up();
    await picture();
    await expectParked(page);
    const wider = await sceneOf(page);
    expect(groundOf(wider)[0]).toBeCloseTo(width + 1.5, 1);
    expect({ obstacles: wider.obstacles, slots: wider.slots, start: wider.start, goal: wider.goal }).toEqual({
      obstacles,
      slots,
      start,
      goal,
    });
    for (let i = 0; i < 3; i++) await page.keyboard.press("Control+z");
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
    const form = dialog(page),
      field = (name: string) => form.getByRole("textbox", { name, exact: true });
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
    const { violations } = await new AxeBuilder({ page })
      .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
      .analyze();
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

test.describe("the preview's border", () => {
  test.use({ viewport: { width: 1400, height: 900 } });

  test("follows the pointer while the picture rests, stops where the rows need it, and is given up by Escape", async ({
    page,
  }) => {
    const complaints = complaintsOf(page);
    await open(page);
    await page.locator("parkade-toolbar .scene").click();
    await page.getByRole("button", { name: "New lot" }).click();
    await planned(page);
    const form = dialog(page),
      width = form.getByRole("textbox", { name: "Width", exact: true }),
      depth = form.getByRole("textbox", { name: "Depth", exact: true });
    const side = (name: string): Locator => form.getByRole("slider", { name: `${name} side of the ground` });
    for (const [name, dx] of [
      ["Right", -40],
      ["Left", -30],
    ] as const) {
      const other = name === "Right" ? "Left" : "Right",
        at = await middleOf(side(name)),
        still = await middleOf(side(other));
      await page.mouse.move(at.x, at.y);
      await page.mouse.down();
      await page.mouse.move(at.x + dx, at.y + 9, { steps: 5 });
      await expect.poll(async () => Math.abs((await middleOf(side(name))).x - (at.x + dx))).toBeLessThan(2);
      const now = await middleOf(side(other));
      expect(Math.hypot(now.x - still.x, now.y - still.y)).toBeLessThan(1);
      expect(await side(name).getAttribute("aria-valuetext")).toBe(`${Number(await width.inputValue()).toFixed(1)} m`);
      await page.mouse.up();
    }
    await planned(page);
    const kept = await width.inputValue(),
      at = await middleOf(side("Right"));
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x - 400, at.y, { steps: 5 });
    await expect(width).toHaveValue("20");
    await expect(form.getByRole("status")).toHaveText(
      "Width of the ground must be at least 20 m for these rows. Widen it, or take fewer bays.",
    );
    await page.keyboard.press("Escape");
    await expect(width).toHaveValue(kept);
    await page.mouse.up();
    await expect(form).toBeVisible();
    await side("Upper").focus();
    await page.keyboard.press("ArrowUp");
    await expect(depth).toHaveValue("12.3");
    await page.keyboard.press("Shift+ArrowUp");
    await expect(depth).toHaveValue("13.3");
    await side("Lower").focus();
    await page.keyboard.press("ArrowUp");
    await expect(depth).toHaveValue("13.2");
    const { violations } = await new AxeBuilder({ page })
      .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
      .analyze();
    expect(violations.map((one) => one.id)).toEqual([]);
    await planned(page);
    await form.getByRole("button", { name: "Open" }).click();
    await expect(form).toBeHidden();
    const [wide, deep] = groundOf(await sceneOf(page));
    expect([wide.toFixed(1), deep.toFixed(1)]).toEqual([Number(kept).toFixed(1), "13.2"]);
    expect(complaints).toEqual([]);
  });
});

test.describe("with a finger", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("a newcomer's own lot is parked in within four taps", async ({ page }) => {
    const complaints = complaintsOf(page),
      picture = pictures(page, "newcomer-phone");
    await open(page);
    const steps = [
      () => page.locator("parkade-toolbar .scene").tap(),
      () =>
        page
          .getByRole("button", { name: "New lot" })
          .tap()
          .then(() => planned(page)),
      () => dialog(page).getByRole("button", { name: "Open" }).tap(),
      async () => {
        const at = await fifthBay(page);
        await page.touchscreen.tap(at.x, at.y);
        await expectParked(page);
      },
    ];
    await picture();
    for (const step of steps) {
      await step();
      await picture();
    }
    // A tap on free ground shows the border's handles.
    const { slots, ...lot } = await sceneOf(page),
      [width, depth] = groundOf(lot as Scenario),
      free = await seenAt(page, width - 2, depth - 1.5);
    await page.touchscreen.tap(free.x, free.y);
    await picture();
    const at = await seenAt(page, width / 2, depth),
      session = await page.context().newCDPSession(page);
    const send = (type: "touchStart" | "touchMove" | "touchEnd", y?: number) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: y === undefined ? [] : [{ x: at.x + 15, y }] });
    await send("touchStart", at.y - 15);
    for (let step = 1; step <= 6; step++) await send("touchMove", at.y - 15 - 5 * step);
    await picture();
    await send("touchEnd");
    await picture();
    await expectParked(page);
    expect(groundOf(await sceneOf(page))[1]).toBeGreaterThan(depth + 1);
    expect((await sceneOf(page)).slots).toEqual(slots);
    expect(complaints).toEqual([]);
  });

  test("a finger near a side of the preview drags it", async ({ page }) => {
    await open(page);
    await page.locator("parkade-toolbar .scene").tap();
    await page.getByRole("button", { name: "New lot" }).tap();
    await planned(page);
    const side = dialog(page).getByRole("slider", { name: "Lower side of the ground" }),
      box = (await side.boundingBox())!,
      session = await page.context().newCDPSession(page);
    expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(44);
    const send = (type: "touchStart" | "touchMove" | "touchEnd", y?: number) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: y === undefined ? [] : [{ x: box.x + 3, y }] });
    await send("touchStart", box.y + 3);
    for (let step = 1; step <= 6; step++) await send("touchMove", box.y + 3 + 8 * step);
    await send("touchEnd");
    await expect(dialog(page).getByRole("textbox", { name: "Depth" })).not.toHaveValue("12.2");
    expect(Number(await dialog(page).getByRole("textbox", { name: "Depth" }).inputValue())).toBeGreaterThan(14);
    await planned(page);
    await dialog(page).getByRole("button", { name: "Open" }).tap();
    await expect.poll(async () => groundOf(await sceneOf(page))[1]).toBeGreaterThan(14);
  });
});
