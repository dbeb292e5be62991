import { expect, test } from "@playwright/test";
import type { Obstacle } from "parkade";
import { BOX, cells, click, drag, fingers, fingerprint, only, openLot, selection, type Spot } from "./hands.js";
import { onScreen, sceneOf, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 }, hasTouch: true });

test("a frame chooses what lies in it, Shift adds, arrows move the group, Alt copies it, Delete removes it", async ({
  page,
}) => {
  const box = (id: string, x: number): Obstacle => ({
    type: "rectangle",
    id,
    center: [x, 15],
    size: [1, 1],
    heading: 0,
  });
  await openLot(page, { obstacles: [box("a", 15), box("b", 18), box("c", 25)] });
  await drag(page, [
    [14, 13],
    [19.5, 17],
  ]);
  expect(await selection(page)).toEqual({ kind: "group", ids: ["a", "b"] });
  await page.keyboard.down("Shift");
  await click(page, [25, 15]);
  await page.keyboard.up("Shift");
  expect(await selection(page)).toEqual({ kind: "group", ids: ["a", "b", "c"] });
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Shift+ArrowRight");
  expect((await sceneOf(page)).obstacles!.map((one) => (one as typeof BOX & { center: Spot }).center)).toEqual([
    [16, 15.5],
    [19, 15.5],
    [26, 15.5],
  ]);
  await page.keyboard.down("Alt");
  await drag(page, [
    [16, 15.5],
    [16, 20.5],
  ]);
  await page.keyboard.up("Alt");
  const { obstacles } = await sceneOf(page);
  expect(obstacles).toHaveLength(6);
  expect(obstacles!.slice(3).map((one) => (one as { center: Spot }).center[1])).toEqual([20.5, 20.5, 20.5]);
  await page.keyboard.press("Delete");
  expect((await sceneOf(page)).obstacles).toHaveLength(3);
});

test("what is dragged falls in line with other things, and Ctrl leaves it alone", async ({ page }) => {
  await openLot(page, {
    obstacles: [BOX, { type: "rectangle", id: "free", center: [12.13, 22], size: [1.3, 1.3], heading: 0 }],
  });
  await drag(page, [
    [12.13, 22],
    [19.95, 22.1],
  ]);
  expect(
    only({ ...(await sceneOf(page)), obstacles: (await sceneOf(page)).obstacles!.slice(1) }, "rectangle").center[0],
  ).toBeCloseTo(20, 6);
  await page.keyboard.press("Control+z");
  await page.keyboard.down("Control");
  await drag(page, [
    [12.13, 22],
    [19.93, 22.13],
  ]);
  await page.keyboard.up("Control");
  const center = only(
    { ...(await sceneOf(page)), obstacles: (await sceneOf(page)).obstacles!.slice(1) },
    "rectangle",
  ).center;
  expect(center[0]).toBeCloseTo(19.93, 1);
  expect(center[0]).not.toBeCloseTo(20, 2);
});

test("a double click on a polygon's edge adds a corner, on a corner takes it away", async ({ page }) => {
  await openLot(page, {
    obstacles: [
      {
        type: "polygon",
        id: "shape",
        points: [
          [15, 12],
          [25, 12],
          [20, 18],
        ],
      },
    ],
  });
  await click(page, [20, 14]);
  const edge = await onScreen(page, 18, 12);
  await page.mouse.dblclick(edge.x, edge.y);
  expect(only(await sceneOf(page), "polygon").points).toHaveLength(4);
  await page.mouse.dblclick(edge.x, edge.y);
  expect(only(await sceneOf(page), "polygon").points).toHaveLength(3);
});

test("a pose's label takes numbers", async ({ page }) => {
  await openLot(page);
  await click(page, [5, 3]);
  await page.waitForTimeout(100);
  await page.keyboard.press("Enter");
  const field = page.locator("parkade-scene-view input.pose");
  await expect(field).toBeFocused();
  await field.fill("nonsense");
  await field.press("Enter");
  await expect(field).toHaveAttribute("aria-invalid", "true");
  await field.fill("12.4, 8.1, −87.5°");
  await field.press("Enter");
  await expect(field).toHaveCount(0);
  const { start } = await sceneOf(page);
  expect(start.x).toBeCloseTo(12.4, 6);
  expect(start.y).toBeCloseTo(8.1, 6);
  expect((start.heading * 180) / Math.PI).toBeCloseTo(-87.5, 6);
});

test("a second finger takes back a stray stroke, three fingers take back an edit", async ({ page }) => {
  await openLot(page);
  await page.keyboard.press("b");
  const before = await fingerprint(page);
  const camera = () =>
    page.evaluate(
      () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.camera as { scale: number },
    );
  await fingers(
    page,
    [
      [
        [16, 12],
        [17, 12],
        [14, 12],
      ],
      [
        [22, 16],
        [22, 16],
        [26, 16],
      ],
    ],
    { gap: 20 },
  );
  expect(await fingerprint(page)).toBe(before);
  expect((await camera()).scale).toBeGreaterThan(20);
  await fingers(page, [
    [
      [16, 12],
      [20, 12],
    ],
  ]);
  expect(await fingerprint(page)).not.toBe(before);
  await fingers(page, [[[16, 12]], [[18, 12]], [[20, 13]]]);
  await expect.poll(() => fingerprint(page)).toBe(before);
});

test("a finger that rests opens the menu, and so does the right button", async ({ page }) => {
  await openLot(page, { obstacles: [BOX] });
  await fingers(page, [[[20, 15]]], { hold: 700 });
  await expect(page.getByRole("menuitem", { name: "Duplicate" })).toBeVisible();
  await page.getByRole("menuitem", { name: "Duplicate" }).click();
  expect((await sceneOf(page)).obstacles).toHaveLength(2);
  const at = await onScreen(page, 10, 20);
  await page.mouse.click(at.x, at.y, { button: "right" });
  await page.getByRole("menuitem", { name: "Set start here" }).click();
  const { start } = await sceneOf(page);
  expect(Math.hypot(start.x - 10, start.y - 20)).toBeLessThan(0.1);
});

test("with a pen in use, fingers move the view", async ({ page }) => {
  await openLot(page);
  await page.keyboard.press("b");
  const session = await page.context().newCDPSession(page);
  const pen = async (type: "mousePressed" | "mouseMoved" | "mouseReleased", x: number, y: number) => {
    const at = await onScreen(page, x, y);
    await session.send("Input.dispatchMouseEvent", {
      type,
      ...at,
      button: "left",
      buttons: 1,
      clickCount: 1,
      pointerType: "pen",
    });
  };
  await pen("mousePressed", 16, 12);
  await pen("mouseMoved", 20, 12);
  await pen("mouseReleased", 20, 12);
  const drawn = await fingerprint(page);
  expect(cells(await sceneOf(page)).size).toBeGreaterThan(5);
  await fingers(page, [
    [
      [16, 20],
      [20, 20],
    ],
  ]);
  expect(await fingerprint(page)).toBe(drawn);
});

test("100 mixed edits are taken back to the very scene, and made again", async ({ page }) => {
  test.setTimeout(180_000);
  await openLot(page);
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ planners: ["four"] }),
  );
  const seen = [await fingerprint(page)];
  let seed = 7;
  const random = (low: number, high: number): number => {
    seed = (seed * 48271) % 2147483647;
    return low + ((high - low) * seed) / 2147483647;
  };
  const spot = (): Spot => [random(8, 32), random(8, 22)];
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random(0, list.length))]!;
  while (seen.length <= 100) {
    const how = random(0, 1);
    if (how < 0.2) {
      await page.keyboard.press(pick(["b", "r", "m", "p", "e", "v", "k", "k"]));
      await drag(page, [spot(), spot()], { steps: 1 });
    } else if (how < 0.3) {
      await page.keyboard.press("c");
      await click(page, spot());
    } else
      await page.keyboard.press(
        pick([
          "ArrowUp",
          "ArrowRight",
          "Shift+ArrowDown",
          "Control+ArrowLeft",
          "Control+d",
          "Control+a",
          "x",
          "Delete",
          "}",
          "{",
        ]),
      );
    await page.keyboard.press("v");
    const now = await fingerprint(page);
    if (now !== seen.at(-1)) seen.push(now);
  }
  for (const wanted of seen.slice(0, -1).reverse()) {
    await page.keyboard.press("Control+z");
    expect(await fingerprint(page)).toBe(wanted);
  }
  for (let i = 1; i < seen.length; i++) await page.keyboard.press("Control+Shift+z");
  expect(await fingerprint(page)).toBe(seen.at(-1));
});
