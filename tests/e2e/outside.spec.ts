import { expect, test, type Page } from "@playwright/test";
import type { Scenario } from "parkade";
import type { Embed } from "./embed";
import {
  complaintsOf,
  expectFourAnswers,
  open,
  sceneOf,
  settled,
  type PlaygroundElement,
  type Untyped,
} from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

/** However busy the machine is. */
const told = expect.configure({ timeout: 30_000 });

const linkOf = async (page: Page): Promise<string> =>
  new URL((await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL()))!)
    .hash;

const looksOf = (page: Page) =>
  page.evaluate(() => {
    const { mode, focus, planners, layers, playback, camera } = (
      document.querySelector<PlaygroundElement>("parkade-playground")! as unknown as {
        store: { state: Record<string, Untyped> };
      }
    ).store.state;
    return { mode, focus, planners, layers, base: playback.base, fraction: playback.fraction, camera };
  });

/** Every field of a link's view, broken in turn. */
const DAMAGED: [view: string, field: string][] = [
  ["0~hybrid~four~4mf~0~10000~1e22~0~2000", "focus"],
  ["0~four~four~4mf~0~10000~1e22~0~2000", "camera.x"],
  ["0~four~four~4mf~0~10000~0~-1e30~2000", "camera.y"],
  ["0~four~four~4mf~0~10000~0~0~1", "camera.scale"],
  ["0~four~four~4mf~0~10000~0~0~1e9", "camera.scale"],
  ["0~four~four~4mf~0~10000~0~0", "camera"],
  ["0~hybrid~four.constructor~4mf~0~10000", "planners[1]"],
  ["0~four~four.__proto__~4mf~0~10000", "planners[1]"],
  ["0~four~four.four~4mf~0~10000", "planners"],
  ["0~~~4mf~0~10000", "planners[0]"],
  ["3~four~four~4mf~0~10000", "mode"],
  ["0~four~four~zzzzzz~0~10000", "layers"],
  ["0~four~four~4mf~7~10000", "base"],
  ["0~four~four~4mf~0~10001", "playhead"],
  ["0~four~four~4mf~0~NaN", "playhead"],
  ["0", "planners[0]"],
];

test("a link whose view makes no sense opens its scene with its own view and says so in one sentence", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  await open(page);
  const own = await looksOf(page),
    hash = await linkOf(page);
  for (const [view, field] of DAMAGED.filter((_, i) => i % 3 === 1 || i === 6)) {
    await page.goto("about:blank");
    await open(page, `${hash}&v=${view}`);
    await settled(page);
    const notice = page.locator("parkade-notices .notice.err");
    await told(notice, view).toContainText(`The view in this link is damaged (${field}: must be `);
    await told(notice, view).toContainText("so the scene opens with its own view.");
    expect(await looksOf(page), view).toEqual(own);
    await expectFourAnswers(page);
  }
  expect(complaints).toEqual([]);
});

test("a damaged view that comes while the page is open leaves planners, layers and camera as they are", async ({
  page,
}) => {
  test.setTimeout(180_000);
  const complaints = complaintsOf(page);
  await open(page);
  const own = await looksOf(page),
    hash = await linkOf(page);
  const scene = await sceneOf(page);
  for (const [view, field] of DAMAGED) {
    await page.evaluate((next) => {
      location.hash = next;
    }, `${hash}&v=${view}`);
    await told(page.locator("parkade-notices .notice.err"), view).toContainText(
      `The view in this link is damaged (${field}: must be `,
    );
    await settled(page);
    expect(await looksOf(page), view).toEqual(own);
    await page.locator("parkade-notices").getByRole("button", { name: "Dismiss" }).click();
  }
  expect((await sceneOf(page)).map).toEqual(scene.map);
  await expectFourAnswers(page);
  expect(complaints).toEqual([]);
});

test("a link to a scene that no planner can take is refused, and the scene stays", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  const before = await sceneOf(page);
  const bad = await page.evaluate(async () => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")! as unknown as {
      store: { state: { scene: Scenario }; set(patch: object): void };
      app: { links: { address(): Promise<string> } };
    };
    const { scene } = element.store.state;
    element.store.set({ scene: { ...scene, start: { ...scene.start, x: 3e13 } } });
    const href = await element.app.links.address();
    element.store.set({ scene });
    return new URL(href).hash;
  });
  await page.evaluate((hash) => {
    location.hash = hash;
  }, bad);
  await told(page.locator("parkade-notices .notice.err")).toContainText(
    "The link could not be opened: start.x: must be finite, within ±1e11 m",
  );
  expect(await sceneOf(page)).toEqual(before);
  expect(complaints).toEqual([]);
});

test("whatever a camera is set to, the page draws, and a fit comes back", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  for (const camera of [
    { x: NaN, y: 1e308, scale: -1 },
    { x: 1e20, y: 0, scale: 20 },
    { x: 0, y: 0, scale: 1e-300 },
    { x: 0, y: 0, scale: Infinity },
    { x: -Infinity, y: 0, scale: 0 },
  ]) {
    const drawn = await page.evaluate(async (wanted) => {
      document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ camera: wanted });
      for (let frame = 0; frame < 4; frame++) await new Promise(requestAnimationFrame);
      return true;
    }, camera);
    expect(drawn).toBe(true);
  }
  const moved = page.evaluate(() =>
    document.querySelector<PlaygroundElement & { seek(to: unknown): void }>("parkade-playground")!.seek("x"),
  );
  await expect(moved).rejects.toThrow("playhead: must be a number from 0 to 1, got x");
  expect((await looksOf(page)).fraction).toBe(1);
  expect(complaints).toEqual([]);
});

test("a context menu that is closed before it is drawn throws nothing", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  const canvas = page.locator("parkade-panel[active] parkade-scene-view canvas");
  await canvas.click({ button: "right" });
  await expect(page.locator("parkade-context .popover")).toBeVisible();
  await page.evaluate(() => {
    const menu = document
      .querySelector("parkade-playground")!
      .shadowRoot!.querySelector("parkade-context") as unknown as { show(request: object): Promise<void> };
    const shown = menu.show({ x: 300, y: 300, at: [1, 1] });
    document.dispatchEvent(new PointerEvent("pointerdown"));
    return shown;
  });
  await expect(page.locator("parkade-context .popover")).toHaveCount(0);
  expect(complaints).toEqual([]);
});

test.describe("in a frame", () => {
  interface Host {
    heard: { type: string; [key: string]: unknown }[];
    ask(name: string, rest?: object): Promise<{ result?: unknown; error?: string }>;
  }

  /** Values that break a rule, the field that is named, and the rule's beginning. */
  const REFUSED: [message: string, rest: Record<string, unknown>, field: string, rule: string][] = [
    ["camera", { value: { x: NaN, y: 1e308, scale: -1 } }, "camera.x", "must be a number from"],
    ["camera", { value: { x: 0, y: 0, scale: 4000 } }, "camera.scale", "must be a number from 1 to 400"],
    ["camera", { value: { x: 0, y: 0, scale: 20, z: 1 } }, "camera.z", "must be one of x, y, scale"],
    ["camera", { value: "here" }, "camera", "must be an object of x, y, scale"],
    ["playhead", { value: "x" }, "playhead", "must be a number from 0 to 1"],
    ["playhead", { value: Infinity }, "playhead", "must be a number from 0 to 1"],
    ["seek", { args: [NaN] }, "seek", "must be a number from 0 to 1"],
    ["seek", { args: [0.5, { base: "walk" }] }, "seek.options.base", "must be one of drive, search"],
    ["params", { value: { constructor: {} } }, "params.constructor", "must be one of four,"],
    [
      "params",
      { value: { hybrid: { maxExpansions: -1 } } },
      "params.hybrid.maxExpansions",
      "must be a whole number from",
    ],
    ["params", { value: { hybrid: null } }, "params.hybrid", "must be an object of"],
    ["toBlob", { args: [{ type: 5 }] }, "toBlob.options.type", "must be one of image/png"],
    ["openLink", { args: [5] }, "openLink", "must be a text of at most"],
  ];

  test(
    "a message with a value that makes no sense is answered by an error that names field, value and rule, and " +
      "changes nothing",
    async ({ page }) => {
      const complaints = complaintsOf(page);
      await page.goto("/host/frame.html");
      await expect
        .poll(() => page.evaluate(() => (window as unknown as Host).heard.map(({ type }) => type)), { timeout: 30_000 })
        .toContain("parkade:plan-complete");
      const inside = page.frames()[1]!;
      const state = () =>
        inside.evaluate(() => {
          const { camera, playhead, params, sceneData } = document.querySelector("parkade-playground") as Embed;
          return JSON.stringify({ camera, playhead, params, sceneData });
        });
      const before = await state();
      for (const [message, rest, field, rule] of REFUSED) {
        const error = await page.evaluate(
          async ([name, more]) => {
            const { ask, heard } = window as unknown as Host;
            heard.length = 0;
            await ask(name, more);
            const told = () => heard.find(({ type }) => type === "parkade:error");
            for (let tries = 0; tries < 200 && !told(); tries++) await new Promise((done) => setTimeout(done, 20));
            return told();
          },
          [message, rest] as const,
        );
        expect(error, `${message} ${JSON.stringify(rest)}`).toMatchObject({
          field,
          code: "value",
          rule: expect.stringMatching(`^${rule}`),
          message: expect.stringContaining(`${field}: ${rule}`) as unknown,
        });
        expect(await state()).toBe(before);
      }
      const scene = await page.evaluate(async () => {
        const { ask, heard } = window as unknown as Host;
        const now = (await ask("getScene")).result as Scenario;
        heard.length = 0;
        const { error } = await ask("setScene", { args: [{ ...now, map: { ...now.map, width: 1e9 } }] });
        return { error, told: heard.find(({ type }) => type === "parkade:error") };
      });
      expect(scene.error).toContain("map.width: must be 1 to 4096 cells");
      expect(scene.told).toMatchObject({ field: "map.width", code: "bad-scenario" });
      expect(await state()).toBe(before);
      // What makes sense is taken.
      expect(
        await page.evaluate(async () => {
          const { ask } = window as unknown as Host;
          await ask("playhead", { value: 0.25 });
          await ask("params", { value: { sixteen: {} } });
          return ask("camera", { value: { x: 10, y: 8, scale: 30 } });
        }),
      ).toMatchObject({ result: undefined });
      await expect.poll(state).toContain('"camera":{"x":10,"y":8,"scale":30},"playhead":0.25,"params":{"sixteen":{}}');
      expect(complaints).toEqual([]);
    },
  );

  test("an attribute that breaks its rule is told and changes nothing", async ({ page }) => {
    const complaints = complaintsOf(page);
    await page.goto(
      `/host/frame.html?hash=${encodeURIComponent(
        "layout=sideways&controls=full&speed=Infinity&layers=clean+constructor&theme=blue" +
          "&planners=four+four+eight&wheel=never&budget-ms=-5",
      )}`,
    );
    const heard = () => page.evaluate(() => (window as unknown as Host).heard);
    await expect
      .poll(async () => (await heard()).map(({ type }) => type), { timeout: 30_000 })
      .toContain("parkade:plan-complete");
    const fields = (await heard()).filter(({ type }) => type === "parkade:error").map(({ field }) => field);
    expect(fields.sort()).toEqual(["budget-ms", "layers[1]", "layout", "speed", "theme", "wheel"]);
    const { planners, mode, theme, speed } = await page.frames()[1]!.evaluate(() => {
      const inner = document
        .querySelector("parkade-playground")!
        .shadowRoot!.querySelector("parkade-embedded") as unknown as { store: { state: Record<string, Untyped> } };
      const { state } = inner.store;
      return {
        planners: state["planners"],
        mode: state["mode"],
        theme: state["theme"],
        speed: state["playback"].speed,
      };
    });
    expect({ planners, mode, theme, speed }).toEqual({
      planners: ["four", "eight"],
      mode: "grid",
      theme: "auto",
      speed: 1,
    });
    await page
      .frames()[1]!
      .evaluate(() => document.querySelector("parkade-playground")!.setAttribute("planners", "four toString"));
    await expect
      .poll(async () => (await heard()).filter(({ type }) => type === "parkade:error").map(({ field }) => field))
      .toContain("planners[1]");
    expect(complaints).toEqual([]);
  });
});
