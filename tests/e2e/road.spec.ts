import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import type { Scenario } from "parkade";
import { complaintsOf, look, onScreen, open, sceneOf, settled, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

const FLOOR: Scenario = {
  version: 1,
  name: "floor",
  map: { origin: [0, 0], width: 240, height: 160, resolution: 0.5 },
  obstacles: [],
  slots: [],
  vehicle: "sedan",
  start: { x: 12, y: 18.25, heading: 0 },
  goal: { x: 61.75, y: 60, heading: Math.PI / 2 },
};

/** An empty floor under the cost map. */
async function floor(page: Page): Promise<void> {
  await open(page);
  await page.evaluate((scene) => {
    const playground = document.querySelector<PlaygroundElement>("parkade-playground")!;
    playground.sceneData = scene;
    playground.store.set({ planners: ["eight", "cost-map"], focus: "cost-map", mode: "overlay" });
  }, FLOOR);
  await settled(page);
  await look(page, 45, 48, 6);
}

/** A built-in road of so many columns under the cost map. */
async function road(page: Page, id: string, width: number): Promise<void> {
  await open(page);
  await page.evaluate((scene) => {
    const playground = document.querySelector<PlaygroundElement>("parkade-playground")!;
    playground.scene = scene;
    playground.store.set({ planners: ["eight", "cost-map"], focus: "cost-map" });
  }, id);
  await expect.poll(async () => (await sceneOf(page)).map.width).toBe(width);
}

async function press(page: Page, x: number, y: number): Promise<void> {
  const at = await onScreen(page, x, y);
  await page.mouse.move(at.x, at.y);
  await page.mouse.click(at.x, at.y);
  await page.waitForTimeout(350);
}

const obstacles = async (page: Page) => (await sceneOf(page)).obstacles ?? [];
const verdict = (page: Page) =>
  page.evaluate(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.results["cost-map"]?.check.verdict,
  );

test("a road is drawn, edited and coned off with the mouse, and its risk is told", async ({ page }) => {
  const complaints = complaintsOf(page);
  await floor(page);
  await page.keyboard.press("d");
  for (const [x, y] of [
    [4, 20],
    [60, 20],
    [60, 74],
  ] as const)
    await press(page, x, y);
  await page.keyboard.press("Enter");
  await settled(page);
  expect(await obstacles(page)).toMatchObject([
    {
      type: "road",
      id: "road-1",
      points: [
        [4, 20],
        [60, 20],
        [60, 74],
      ],
      lanes: [1, 1],
      laneWidth: 3.5,
      kerbs: true,
    },
  ]);
  expect(await verdict(page)).toBe("ok");

  await page.keyboard.press("c");
  await page.getByRole("button", { name: "Cone" }).click();
  await page.keyboard.press("q");
  for (const [x, y] of [
    [30, 17],
    [33, 17],
  ] as const)
    await press(page, x, y);
  await page.keyboard.press("Escape");
  await page.keyboard.press("v");
  await settled(page);
  expect((await obstacles(page)).map(({ id, type }) => [id, type])).toEqual([
    ["road-1", "road"],
    ["cone-1", "polygon"],
    ["cone-2", "polygon"],
  ]);
  expect(await verdict(page)).toBe("ok");

  await expect(page.locator("parkade-objects").getByRole("button", { name: "Cone 2" })).toContainText("33.00, 17.00");
  const card = page.locator("parkade-road-card");
  await expect(card.locator("dd").first()).toContainText(/\d\.\d\d \/ \d\.\d\d m/);
  // The drives may be over before a loaded machine looks for their progress.
  const progressed = card.evaluate(
    (host) =>
      new Promise<boolean>((resolve) => {
        const root = host.shadowRoot ?? host;
        const look = (): void => {
          if (root.querySelector("progress, [role=progressbar]")) resolve(true);
        };
        new MutationObserver(look).observe(root, { childList: true, subtree: true });
      }),
  );
  await card.getByRole("button", { name: "Simulate 1,000 drives" }).click();
  expect(await progressed).toBe(true);
  await expect(card.getByRole("status")).toContainText(/of 1000 drives collide/, { timeout: 30_000 });
  const { violations } = await new AxeBuilder({ page })
    .include("parkade-playground")
    .withTags(["wcag2a", "wcag2aa"])
    .analyze();
  expect(violations.map((one) => `${one.id} ${one.nodes.map((node) => node.target.join(" ")).join("; ")}`)).toEqual([]);

  // The corner of the selected road is dragged, its lanes are typed, and both are taken back.
  await page.getByRole("button", { name: /^Road 1/ }).click();
  const from = await onScreen(page, 60, 20),
    to = await onScreen(page, 64, 22);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await page.mouse.up();
  await settled(page);
  const dragged = (await obstacles(page))[0];
  expect(dragged?.type === "road" && dragged.points[1]).toEqual([64, 22]);
  await page.getByLabel("Lanes forward").fill("2");
  await page.getByLabel("Lanes forward").press("Enter");
  expect((await obstacles(page))[0]).toMatchObject({ lanes: [2, 1] });
  await page.getByLabel("Lanes forward").blur();
  for (let i = 0; i < 2; i++) await page.getByRole("button", { name: "Undo" }).first().click();
  expect((await obstacles(page))[0]).toMatchObject({
    points: [
      [4, 20],
      [60, 20],
      [60, 74],
    ],
    lanes: [1, 1],
  });
  expect(complaints).toEqual([]);
});

test("a road is drawn with keys, travels in a link, and is refused where it cannot turn", async ({ page }) => {
  await floor(page);
  await page.keyboard.press("d");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  for (let i = 0; i < 12; i++) await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await settled(page);
  const [road] = await obstacles(page);
  expect(road?.type).toBe("road");
  const link = (await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL(),
  ))!;
  await page.goto(link);
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  expect((await obstacles(page))[0]).toMatchObject({ type: "road", lanes: [1, 1], radius: 20 });

  await floor(page);
  await page.keyboard.press("d");
  for (const [x, y] of [
    [10, 40],
    [30, 40],
    [14, 41],
  ] as const)
    await press(page, x, y);
  await page.keyboard.press("Enter");
  await expect(page.getByText("The road is too wide to turn here")).toBeVisible();
  expect(await obstacles(page)).toEqual([]);
  await page.keyboard.press("Escape");
});

test.describe("by touch", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("a finger drags a road, and the sheet's list removes it", async ({ page }) => {
    await floor(page);
    await look(page, 30, 30, 5);
    await page.getByRole("button", { name: "Road", exact: true }).click();
    const client = await page.context().newCDPSession(page),
      a = await onScreen(page, 10, 30),
      b = await onScreen(page, 50, 30);
    await client.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [a] });
    for (let k = 1; k <= 5; k++)
      await client.send("Input.dispatchTouchEvent", {
        type: "touchMove",
        touchPoints: [{ x: a.x + ((b.x - a.x) * k) / 5, y: a.y }],
      });
    await client.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await settled(page);
    const [road] = await obstacles(page);
    expect(road?.type === "road" && Math.round(road.points[1]![0] - road.points[0]![0])).toBe(40);
    // What the path is worth stands below the results.
    await page.getByRole("tab", { name: "Results" }).click();
    await expect(page.locator("parkade-road-card").locator("dd").first()).toContainText(/\d\.\d\d \/ \d\.\d\d m/);
  });
});

test("every term of the costs follows its slider at once", async ({ page }) => {
  await road(page, "road-turn-ban", 312);
  await settled(page);
  const hash = () =>
    page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.results["cost-map"]?.hash);
  for (const [name, value] of [
    ["Kerb β", "3"],
    ["K", "2"],
    ["Lane α", "0"],
    ["Speed γ", "0"],
  ] as const) {
    const before = await hash();
    // A drag that has not ended: input, no change.
    await page.getByRole("slider", { name, exact: true }).evaluate((slider: HTMLInputElement, to) => {
      slider.value = to;
      slider.dispatchEvent(new InputEvent("input", { bubbles: true, composed: true }));
    }, value);
    await expect.poll(hash, { message: name }).not.toBe(before);
  }
});

test("cars drive on roads, and do not creep", async ({ page }) => {
  await road(page, "road-narrow", 1021);
  // 500 m at 10 m/s at most, from rest to rest.
  const seconds = () =>
    page.evaluate(() => {
      const { results } = document.querySelector<PlaygroundElement>("parkade-playground")!.store.state as unknown as {
        results: Record<string, { drive: { t: Float64Array } | null }>;
      };
      return results["cost-map"]?.drive?.t.at(-1) ?? 0;
    });
  await expect.poll(seconds).toBeGreaterThan(50);
  expect(await seconds()).toBeLessThan(70);
});

test("what fails when the manuscript is taken literally is explained beside the plan", async ({ page }) => {
  await road(page, "road-narrow", 1021);
  await settled(page);
  await expect(page.locator("parkade-road-card")).not.toContainText("a metre");
  await page.evaluate(() => {
    const playground = document.querySelector<PlaygroundElement>("parkade-playground")!;
    playground.sceneData = {
      ...playground.sceneData,
      planners: { "cost-map": { costs: "paper", pruning: "los", smoothing: "paper" } },
    };
  });
  await settled(page);
  expect(await verdict(page)).toBe("collides");
  await expect(page.locator("parkade-panel[active]")).toContainText("may leave its control points by a metre");
});
