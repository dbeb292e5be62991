import { expect, test, type Page } from "@playwright/test";
import {
  complaintsOf,
  dragWorld,
  hashesOf,
  look,
  open,
  sceneOf,
  settled,
  type PlaygroundElement,
  type Untyped,
} from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

const notice = (page: Page) => page.locator("parkade-notices .notice");

/** Reloads, and waits until the page has done what it does when it is idle. */
async function reload(page: Page): Promise<void> {
  await page.reload();
  await page.evaluate(async () => {
    await customElements.whenDefined("parkade-playground");
    await document.querySelector<PlaygroundElement>("parkade-playground")!.ready;
  });
  await page.waitForFunction(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
  );
  await page.waitForFunction(async () =>
    ((await navigator.locks.query()).held ?? []).some(({ name }) => name?.startsWith("parkade.tab.")),
  );
  await page.waitForTimeout(300);
}

/** A wall, a turned start and a moved goal, none of them on a whole centimetre or degree. */
async function draw(page: Page): Promise<void> {
  await look(page, 12, 10, 30);
  await page.evaluate(() => {
    const { store } = document.querySelector("parkade-playground") as unknown as {
      store: { state: { scene: Record<string, Untyped> }; edit(scene: object, options: object): void };
    };
    const { scene } = store.state;
    store.edit(
      { ...scene, start: { ...scene["start"], x: scene["start"].x + 0.0149, heading: 0.02345 } },
      { label: "start" },
    );
  });
  await page.keyboard.press("l");
  await dragWorld(page, [6, 10], [9, 10]);
  await page.keyboard.press("Escape");
  expect((await sceneOf(page)).obstacles?.at(-1)).toMatchObject({ type: "wall" });
  await page.evaluate(() => {
    const { store } = document.querySelector("parkade-playground") as unknown as {
      store: { state: { scene: Record<string, Untyped> }; edit(scene: object, options: object): void };
    };
    const { scene } = store.state;
    store.edit(
      {
        ...scene,
        name: "Mine",
        obstacles: [
          ...scene["obstacles"],
          { type: "rectangle", id: "mine", center: [3.1234, 3.4321], size: [1.005, 0.995] },
        ],
      },
      { label: "add" },
    );
  });
  await settled(page);
}

test("a reload brings back the scene to the last digit, the same plans, undo and redo, and offers nothing", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  await open(page);
  const first = await sceneOf(page);
  await draw(page);
  await page.keyboard.press("Control+z");
  await settled(page);
  const scene = await sceneOf(page),
    hashes = await hashesOf(page);
  await reload(page);
  expect(await sceneOf(page)).toEqual(scene);
  await settled(page);
  expect(await hashesOf(page)).toEqual(hashes);
  await expect(notice(page)).toHaveCount(0);
  await page.keyboard.press("Control+Shift+z");
  expect((await sceneOf(page)).name).toBe("Mine");
  // Twice in a row, and long enough for everything to be kept by its own clock.
  await page.waitForTimeout(1800);
  await reload(page);
  await expect(notice(page)).toHaveCount(0);
  while (
    await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.canUndo)
  )
    await page.keyboard.press("Control+z");
  expect(await sceneOf(page)).toEqual(first);
  await page.waitForTimeout(1800);
  await reload(page);
  await expect(notice(page)).toHaveCount(0);
  expect(await sceneOf(page)).toEqual(first);
  expect(
    await page.evaluate(
      () => (document.querySelector("parkade-playground") as unknown as { canRedo: boolean }).canRedo,
    ),
  ).toBe(true);
  expect(complaints).toEqual([]);
});

test("a reload that the server takes its time over brings back the scene as well", async ({ page }) => {
  await open(page);
  await draw(page);
  await page.waitForTimeout(1800);
  await page.route(
    (url) => url.pathname.endsWith("/"),
    async (route) => {
      await new Promise((resolve) => setTimeout(resolve, 2500));
      await route.continue();
    },
  );
  await page.keyboard.press("Control+z");
  const scene = await sceneOf(page);
  await reload(page);
  expect(await sceneOf(page)).toEqual(scene);
  await page.keyboard.press("Control+Shift+z");
  expect((await sceneOf(page)).name).toBe("Mine");
});

test("an edit before the page has done what it does when it is idle survives a reload", async ({ page }) => {
  await page.addInitScript(() => {
    window.requestIdleCallback = () => 0;
  });
  await open(page);
  const first = await sceneOf(page);
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = { ...element.sceneData, name: "Early" };
  });
  await page.waitForTimeout(1800);
  await page.reload();
  await page.evaluate(async () => {
    await customElements.whenDefined("parkade-playground");
    await document.querySelector<PlaygroundElement>("parkade-playground")!.ready;
  });
  expect((await sceneOf(page)).name).toBe("Early");
  await page.keyboard.press("Control+z");
  expect(await sceneOf(page)).toEqual(first);
});

test("another link in the same tab opens its own scene, and the drawing is offered", async ({ page }) => {
  await open(page);
  const first = new URL(
    (await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL()))!,
  ).hash;
  await draw(page);
  await page.waitForTimeout(1800);
  await page.goto("about:blank");
  await open(page, first);
  expect((await sceneOf(page)).name).not.toBe("Mine");
  await expect(notice(page)).toContainText("was kept", { timeout: 15_000 });
  await notice(page).getByRole("button", { name: "Restore" }).click();
  expect((await sceneOf(page)).name).toBe("Mine");
});

test("a new tab is offered what a closed one has left, but not what its link shows already", async ({
  page,
  context,
}) => {
  await open(page);
  await draw(page);
  await page.waitForTimeout(1800);
  const hash = new URL(page.url()).hash;
  await page.close();
  const same = await context.newPage();
  await open(same, hash);
  await reload(same);
  expect((await sceneOf(same)).name).toBe("Mine");
  await expect(notice(same)).toHaveCount(0);
});

test("damaged storage is dropped without a word, and the page is as on a first visit", async ({ page }) => {
  const complaints = complaintsOf(page);
  await page.addInitScript(() => {
    if (sessionStorage.getItem("prepared")) return;
    sessionStorage.setItem("prepared", "yes");
    sessionStorage.setItem("parkade.tab", "../../x");
    sessionStorage.setItem("parkade.history", '{"hash":"","at":0,"scenes":[{"version":0,"map":7}],"parts":[1]}');
    const kept: Record<string, string> = {
      "parkade.theme": "blue",
      "parkade.lang": "tlh",
      "parkade.pane.side": "NaN",
      "parkade.pane.bottom": "1e300",
      "parkade.pane.chart": "-5",
      "parkade.hint.drag": "no",
      "parkade.tab.a": "{",
      "parkade.tab.b": '{"at":1e300,"scene":{}}',
      "parkade.tab.c":
        '{"at":1,"scene":{"version":1,"map":{"origin":[0,0],"width":40,"height":30,"resolution":0.5},' +
        '"start":{"x":1,"y":1,"heading":0},"goal":{"x":2e300,"y":1,"heading":0},"obstacles":[null]}}',
    };
    for (const [key, value] of Object.entries(kept)) localStorage.setItem(key, value);
  });
  await open(page);
  await page.waitForFunction(async () =>
    ((await navigator.locks.query()).held ?? []).some(({ name }) => name?.startsWith("parkade.tab.")),
  );
  const kept = () =>
    page.evaluate(() =>
      Object.entries(localStorage)
        .filter(([key]) => key.startsWith("parkade."))
        .map(([key, value]) => `${key}=${value}`),
    );
  await expect.poll(kept, { timeout: 30_000 }).toEqual([]);
  await expect(notice(page)).toHaveCount(0);
  await draw(page);
  expect((await sceneOf(page)).name).toBe("Mine");
  await reload(page);
  expect((await sceneOf(page)).name).toBe("Mine");
  expect(complaints).toEqual([]);
});
