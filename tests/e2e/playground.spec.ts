import { expect, test } from "@playwright/test";
import type { Obstacle } from "parkade";
import {
  complaintsOf,
  dragWorld,
  expectFourAnswers,
  hashesOf,
  look,
  onScreen,
  open,
  sceneOf,
  settled,
  watchShifts,
  type PlaygroundElement,
} from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

test("the page opens solved by four planners, without a complaint", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await expectFourAnswers(page);
  await expect(page.locator("parkade-panel")).toHaveCount(4);
  const rows = page.locator("parkade-table tbody tr");
  await expect(rows).toHaveCount(4);
  await expect(rows.filter({ hasText: "Hybrid A*" })).toContainText("OK");
  await expect(page.locator("parkade-table tr.grey td.best")).toHaveCount(0);
  expect(complaints).toEqual([]);
});

for (const [name, size] of [
  ["desk", { width: 1400, height: 900 }],
  ["phone", { width: 390, height: 844 }],
  ["phone on its side", { width: 844, height: 390 }],
] as const) {
  test(`what comes while the page loads moves nothing that is there: ${name}`, async ({ page }) => {
    await page.setViewportSize(size);
    const shifts = await watchShifts(page);
    await open(page);
    await settled(page);
    await page.waitForFunction(
      () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
    );
    if (size.height > 480) await expect(page.locator("parkade-table tbody tr").first()).toContainText("15.00");
    expect((await shifts()).reduce((a, b) => a + b, 0)).toBeLessThan(0.0001);
  });
}

test("a planner chosen before its module is there is planned when it comes", async ({ page }) => {
  let modules = 0,
    letGo = (): void => {};
  const held = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  await page.route("**/*.wasm", async (route) => {
    if (++modules > 1) await held;
    await route.continue();
  });
  await open(page);
  await page.evaluate(() =>
    document
      .querySelector<PlaygroundElement>("parkade-playground")!
      .store.set({ planners: ["eight", "jump-point"], focus: "eight" }),
  );
  let done = false;
  const answered = settled(page).then(() => {
    done = true;
  });
  await expect(page.locator("parkade-panel")).toHaveCount(2);
  await page.waitForTimeout(300);
  expect(done).toBe(false);
  letGo();
  await answered;
  const hashes = await hashesOf(page);
  expect(
    Object.values(hashes).every((hash) => hash !== undefined),
    JSON.stringify(hashes),
  ).toBe(true);
});

test("a planner whose module cannot be loaded says so, and the others stay", async ({ page }) => {
  let modules = 0;
  await page.route("**/*.wasm", (route) => (++modules > 1 ? route.abort() : route.continue()));
  await open(page);
  const before = await hashesOf(page);
  await page.evaluate(() =>
    document
      .querySelector<PlaygroundElement>("parkade-playground")!
      .store.set({ planners: ["eight", "jump-point"], focus: "eight" }),
  );
  await settled(page);
  expect((await hashesOf(page))["eight"]).toBe(before["eight"]);
  await expect(page.getByText("Could not finish loading")).toBeVisible();
});

test("dragging the goal changes every planner's answer, and undo brings them back", async ({ page }) => {
  await open(page);
  const before = await hashesOf(page);
  const scene = await sceneOf(page);
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = {
      ...element.sceneData,
      slots: [],
      obstacles: [],
      start: { x: -8, y: 9, heading: 0 },
      goal: { x: 4, y: 9, heading: 0 },
    };
  });
  await settled(page);
  const opened = await hashesOf(page);
  await look(page, 0, 9, 20);
  await dragWorld(page, [4.5, 9], [7, 11]);
  const after = await hashesOf(page);
  for (const planner of Object.keys(opened)) expect(after[planner], planner).not.toBe(opened[planner]);

  await page.keyboard.press("Control+z");
  await settled(page);
  expect(await hashesOf(page)).toEqual(opened);
  await page.keyboard.press("Control+Shift+z");
  await settled(page);
  expect(await hashesOf(page)).toEqual(after);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await settled(page);
  expect(await sceneOf(page)).toEqual(scene);
  expect(await hashesOf(page)).toEqual(before);
});

test("a fast brush stroke leaves no holes", async ({ page }) => {
  await open(page);
  const { map } = await sceneOf(page);
  const middle: [number, number] = [
    map.origin[0] + (map.width * map.resolution) / 2,
    map.origin[1] + map.height * map.resolution * 0.75,
  ];
  await look(page, middle[0], middle[1], 16);
  await page.keyboard.press("b");
  const from: [number, number] = [middle[0] - 6, middle[1] - 2],
    to: [number, number] = [middle[0] + 6, middle[1] + 2];
  await dragWorld(page, from, to, 2);
  const cells = (await sceneOf(page)).obstacles!.find(
    (one): one is Extract<Obstacle, { type: "cells" }> => one.type === "cells",
  )!;
  const painted = new Set(
    cells.runs.flatMap(([x, y, count]) => Array.from({ length: count }, (_, i) => `${x + i},${y}`)),
  );
  for (let i = 0; i <= 400; i++) {
    const x = from[0] + ((to[0] - from[0]) * i) / 400,
      y = from[1] + ((to[1] - from[1]) * i) / 400;
    const cell = [
      Math.floor((x - map.origin[0]) / map.resolution),
      Math.floor((y - map.origin[1]) / map.resolution),
    ].join();
    expect(painted.has(cell), `${x} ${y}`).toBe(true);
  }
});

test("a shared link opens the same scene with the same answers", async ({ page }) => {
  await open(page);
  const { start } = await sceneOf(page);
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    const { sceneData } = element;
    element.sceneData = { ...sceneData, start: { ...sceneData.start, x: sceneData.start.x + 1 } };
  });
  await settled(page);
  await page.waitForURL(/#s=/);
  const again = async () => {
    await page.reload();
    await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
    return { scene: await sceneOf(page), hashes: await hashesOf(page) };
  };
  const first = await again();
  expect(first.scene.start.x).toBeCloseTo(start.x + 1, 2);
  await expectFourAnswers(page);
  // Links round to a centimetre and a tenth of a degree, once.
  expect(await again()).toEqual(first);
  await expect(page.locator("parkade-toolbar .scene")).toHaveText("Perpendicular");
});

test("a broken link opens the first scene and says why", async ({ page }) => {
  await open(page, "#s=1nonsense");
  await expectFourAnswers(page);
  await expect(page.locator("parkade-notices .notice.err")).toContainText("The link could not be opened");
});

test("a broken file leaves the scene and says why; a good one opens", async ({ page }) => {
  await open(page);
  const before = await sceneOf(page);
  const input = page.locator("parkade-playground input[type=file]");
  for (const text of ["{", "[]", JSON.stringify({ ...before, start: { x: "left" } })]) {
    await input.setInputFiles({ name: "broken.json", mimeType: "application/json", buffer: Buffer.from(text) });
    await expect(page.locator("parkade-notices .notice.err")).toContainText("broken.json could not be read");
    expect(await sceneOf(page)).toEqual(before);
    await page.locator("parkade-notices button").click();
  }
  const moved = { ...before, name: "Moved", start: { ...before.start, x: before.start.x - 2 } };
  await input.setInputFiles({
    name: "good.json",
    mimeType: "application/json",
    buffer: Buffer.from(JSON.stringify(moved)),
  });
  await expect(page.locator("parkade-notices .notice.info")).toContainText("Opened good.json");
  expect((await sceneOf(page)).start.x).toBeCloseTo(before.start.x - 2, 6);
});

test("a scene no planner can take keeps the last plans and says what is wrong", async ({ page }) => {
  await open(page);
  const before = await hashesOf(page);
  await page.evaluate(() => {
    const { store } = document.querySelector("parkade-playground") as unknown as {
      store: { state: { scene: object }; edit(scene: object): void };
    };
    store.edit({
      ...store.state.scene,
      vehicle: { wheelbase: -1, width: 2, rearToFront: 4, rearToBack: 1, maxSteer: 0.6 },
    });
  });
  await expect(page.locator("parkade-notices .notice.err")).toContainText("vehicle");
  expect(await hashesOf(page)).toEqual(before);
  await page.keyboard.press("Control+z");
  await settled(page);
  await expect(page.locator("parkade-notices .notice")).toHaveCount(0);
  // From outside it is not even opened.
  const scene = await sceneOf(page);
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = {
      ...element.sceneData,
      vehicle: { wheelbase: -1, width: 2, rearToFront: 4, rearToBack: 1, maxSteer: 0.6 },
    };
  });
  await expect(page.locator("parkade-notices .notice.err")).toContainText("vehicle.wheelbase: ");
  expect(await sceneOf(page)).toEqual(scene);
});

test("arrangements change by key, and any panel can be edited", async ({ page }) => {
  await open(page);
  await page.keyboard.press("\\");
  await expect(page.locator("parkade-stage parkade-scene-view")).toHaveCount(1);
  await page.keyboard.press("\\");
  await expect(page.locator("parkade-panel[thumb]")).toHaveCount(3);
  await page.keyboard.press("\\");
  await expect(page.locator("parkade-panel:not([thumb])")).toHaveCount(4);
  await page.locator("parkade-panel header").first().dblclick();
  await expect(page.locator("parkade-panel[thumb]")).toHaveCount(3);
});

test("a parameter's slider plans again and can be reset", async ({ page }) => {
  await open(page);
  const before = await hashesOf(page);
  const slider = page.locator("parkade-parameters input[type=range]").first();
  await slider.focus();
  for (let i = 0; i < 4; i++) await page.keyboard.press("ArrowRight");
  await settled(page);
  expect(Object.keys((await sceneOf(page)).planners?.hybrid ?? {})).toHaveLength(1);
  expect((await hashesOf(page))["hybrid"]).not.toBe(before["hybrid"]);
  await page.locator("parkade-parameters .head button").click();
  await settled(page);
  expect(await hashesOf(page)).toEqual(before);
});

test("a preset opens from the gallery, and undo brings the drawing back", async ({ page }) => {
  await open(page);
  const before = await sceneOf(page);
  await page.locator("parkade-toolbar .scene").click();
  const cards = page.locator("parkade-presets li button");
  await expect(cards.nth(5)).toBeVisible();
  await cards.nth(2).click();
  await settled(page);
  expect(await sceneOf(page)).not.toEqual(before);
  await page.keyboard.press("Control+z");
  await settled(page);
  expect(await sceneOf(page)).toEqual(before);
});

test("the browser's way back leads through the presets opened", async ({ page }) => {
  await open(page);
  const { name } = await sceneOf(page);
  await page.locator("parkade-toolbar .scene").click();
  await page.locator("parkade-presets li button").nth(2).click();
  await settled(page);
  const second = (await sceneOf(page)).name;
  expect(second).not.toBe(name);
  await page.waitForURL(/#s=/);
  await page.waitForTimeout(700);
  await page.goBack();
  await expect.poll(async () => (await sceneOf(page)).name).toBe(name);
});

test("hovering one map shows the pointer's place on all of them", async ({ page }) => {
  await open(page);
  await look(page, 12, 12, 16);
  const at = await onScreen(page, 12, 12);
  await page.mouse.move(at.x, at.y);
  await expect(page.locator("parkade-panel .readout")).toHaveCount(4);
});

test("a moving obstacle is drawn, waited for, and kept by a link", async ({ page }) => {
  await open(page);
  await page.waitForFunction(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
  );
  await page.evaluate(async () => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.scene = "fig16-conflict";
    await element.updateComplete;
    await element.settled();
    // The optimised trajectory comes at other moments than the planned path, and is not hit.
    element.store.set({ smooth: false });
  });
  const panel = page.locator("parkade-panel").filter({ hasText: "Hybrid A*" });
  await expect(panel.getByText(/waits \d/).first()).toBeVisible();
  await page.getByLabel("How cars wait for moving obstacles").selectOption("reactive");
  await expect(panel.getByText(/hit after \d/).first()).toBeVisible();

  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = { ...element.sceneData, moving: [] };
  });
  await settled(page);
  await expect(panel.getByText(/hit after/)).toHaveCount(0);
  await look(page, 14, 16, 20);
  await page.keyboard.press("m");
  await dragWorld(page, [16, 16], [12, 16]);
  const card = page.locator("parkade-selection");
  for (const label of ["Speed", "Starts at", "Length", "Width"]) await expect(card.getByLabel(label)).toBeVisible();
  const drawn = (await sceneOf(page)).moving ?? [];
  expect(drawn).toHaveLength(1);
  expect(drawn[0]!.points).toHaveLength(2);
  const link = await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL());
  await page.goto(link!);
  await settled(page);
  const kept = (await sceneOf(page)).moving ?? [];
  expect(kept).toHaveLength(1);
  expect(kept[0]!.points[0]![0]).toBeCloseTo(drawn[0]!.points[0]![0], 1);
  expect(kept[0]!.speed).toBeCloseTo(drawn[0]!.speed, 2);
  await page.keyboard.press("Control+z");
});

test("a dragged goal sends the planners nothing else, and they answer as for the whole scene", async ({ page }) => {
  await page.addInitScript(() => {
    const sent: boolean[] = [],
      post = Worker.prototype.postMessage;
    Object.assign(window, { sent });
    Worker.prototype.postMessage = function (this: Worker, ...args: unknown[]) {
      const request = args[0] as { kind: string; scene?: unknown };
      if (request.kind === "plan") sent.push(request.scene !== null);
      return (post as (...all: unknown[]) => void).apply(this, args);
    };
  });
  const sent = (): Promise<boolean[]> => page.evaluate(() => (window as unknown as { sent: boolean[] }).sent.splice(0));
  await open(page);
  await page.evaluate(() => {
    document.querySelector<PlaygroundElement>("parkade-playground")!.scene = "random-60";
  });
  await page.waitForFunction(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
  );
  const again = () =>
    page.evaluate(() => {
      const playground = document.querySelector<PlaygroundElement>("parkade-playground")!;
      playground.sceneData = structuredClone(playground.sceneData);
    });
  // The complete module's workers have the scene only when they have planned it; one that is at work on the first
  // module ends that first.
  await settled(page);
  await again();
  await settled(page);
  const { x, y } = (await sceneOf(page)).goal as { x: number; y: number };
  await look(page, x, y, 12);
  await sent();
  await dragWorld(page, [x, y], [x - 6, y - 3]);
  await settled(page);
  const messages = await sent();
  expect(messages.length).toBeGreaterThan(4);
  expect(messages).not.toContain(true);
  expect((await sceneOf(page)).goal).not.toMatchObject({ x, y });
  const hashes = await hashesOf(page);
  await again();
  await settled(page);
  expect(await sent()).toContain(true);
  expect(await hashesOf(page)).toEqual(hashes);
});
