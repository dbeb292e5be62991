import { expect, test, type Page } from "@playwright/test";
import { click, drag, openLot } from "./hands.js";
import { complaintsOf, sceneOf, settled } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 }, hasTouch: true });

const notice = (page: Page) => page.locator("parkade-notices .notice");

test("slots are drawn for the car of the scene; one that is too small offers to fit", async ({ page }) => {
  const complaints = complaintsOf(page);
  await openLot(page);
  await page.keyboard.press("p");
  await drag(page, [
    [14, 18],
    [25.5, 18],
  ]);
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
  await drag(page, [
    [8, 12],
    [12, 12],
  ]);
  expect([
    (await sceneOf(page)).vehicle,
    (await sceneOf(page)).slots!.length,
    (await sceneOf(page)).slots!.at(-1),
  ]).toMatchObject(["paper", 5, { width: 3.2, length: 6 }]);
  await page.keyboard.press("p");
  await page.locator("parkade-inspector parkade-options").getByLabel("Depth").fill("5.3");
  await page.keyboard.press("Tab");
  await drag(page, [
    [28, 18],
    [32, 18],
  ]);
  await expect(notice(page)).toContainText("This slot is 0.2 m too short for the car.");
  expect(complaints).toEqual([]);
});

const goalOf = async (page: Page) => (await sceneOf(page)).goal;
const entry = (page: Page) => page.locator("parkade-entry button");

/** Pixels of a place in metres on the focused map. */
const pixelOf = (page: Page, at: { x: number; y: number }) =>
  page.evaluate(({ x, y }) => {
    const stage = document.querySelector("parkade-playground")!.shadowRoot!.querySelector("parkade-stage")!.shadowRoot!;
    const map = (stage.querySelector("parkade-panel[active]")?.shadowRoot ?? stage).querySelector(
      "parkade-scene-view",
    ) as unknown as HTMLElement & {
      view: { camera: { x: number; y: number; scale: number }; width: number; height: number };
    };
    const box = map.getBoundingClientRect(),
      { camera, width, height } = map.view;
    return [
      box.left + width / 2 + (x - camera.x) * camera.scale,
      box.top + height / 2 - (y - camera.y) * camera.scale,
    ] as [number, number];
  }, at);

for (const [name, width, height, touch] of [
  ["mouse", 1400, 900, false],
  ["phone", 390, 844, true],
  ["phone on its side", 844, 390, true],
] as const) {
  test(`a switch at the goal car changes how it enters its slot: ${name}`, async ({ browser }) => {
    const page = await browser.newPage({ viewport: { width, height }, hasTouch: touch, reducedMotion: "reduce" });
    const complaints = complaintsOf(page);
    await page.goto("./");
    await settled(page);
    const first = (await goalOf(page)) as { slot: string; entry: string };
    expect(first.entry).toBe("head-in");
    await page.locator("parkade-hints button").click();
    await expect(entry(page)).toHaveText("Head in");
    const box = (await entry(page).boundingBox())!;
    expect(box.height).toBeGreaterThanOrEqual(touch ? 44 : 28);
    expect(box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height).toBe(true);
    await (touch ? entry(page).tap() : entry(page).click());
    await settled(page);
    expect(await goalOf(page)).toEqual({ ...first, entry: "reverse-in" });
    await expect(entry(page)).toHaveText("Reverse in");
    // By keyboard, and back by undo.
    await entry(page).focus();
    await page.keyboard.press("Enter");
    expect(await goalOf(page)).toEqual(first);
    await page.keyboard.press("Control+z");
    expect(await goalOf(page)).toEqual({ ...first, entry: "reverse-in" });
    expect(complaints).toEqual([]);
    await page.close();
  });
}

test("a goal dragged near a free slot takes it, never an occupied one, and the switch goes where it goes", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./");
  await settled(page);
  await page.locator("parkade-hints button").click();
  const { slots = [] } = await sceneOf(page),
    goal = await page.evaluate(
      () =>
        (
          document.querySelector("parkade-playground") as unknown as {
            store: { state: { geometry: { goal: { x: number; y: number; heading: number } } } };
          }
        ).store.state.geometry.goal,
    );
  const own = ((await goalOf(page)) as { slot: string }).slot,
    from = slots.find(({ id }) => id === own)!;
  const middle = { x: goal.x + 1.75 * Math.cos(goal.heading), y: goal.y + 1.75 * Math.sin(goal.heading) };
  const grip = await pixelOf(page, middle);
  const dragTo = async (dx: number, dy: number): Promise<void> => {
    const to = await pixelOf(page, { x: middle.x + dx, y: middle.y + dy });
    await page.mouse.move(...grip);
    await page.mouse.down();
    await page.mouse.move(...to, { steps: 12 });
  };
  for (const slot of slots.filter(({ id }) => id !== own)) {
    await dragTo(slot.x - from.x + 0.3, slot.y - from.y + 0.6);
    await expect(entry(page)).toBeHidden();
    await page.mouse.up();
    await settled(page);
    const taken = await goalOf(page);
    if (slot.occupied) expect(taken).not.toHaveProperty("slot");
    else {
      expect(taken).toEqual({ slot: slot.id, entry: "head-in" });
      await expect(entry(page)).toBeVisible();
    }
    await page.keyboard.press("Control+z");
    await settled(page);
  }
  // Out into the aisle there is no slot, and no switch.
  await dragTo(0, 7);
  await page.mouse.up();
  await expect(entry(page)).toBeHidden();
  expect(complaints).toEqual([]);
});
