import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, open, settled, watchShifts, type PlaygroundElement } from "./playground";

interface Rect {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/**
 * Every map that is shown: its box, and in the window's pixels the box of the lot and of the cars at start and goal.
 */
const maps = (page: Page) =>
  page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    const { scene, geometry } = element.store.state as unknown as {
      scene: { map: { boundary: [number, number][] } };
      geometry: { start: Pose; goal: Pose; vehicle: Car };
    };
    interface Pose {
      x: number;
      y: number;
      heading: number;
    }
    interface Car {
      rearToFront: number;
      rearToBack: number;
      width: number;
    }
    const found: (HTMLElement & {
      view: { camera: { x: number; y: number; scale: number }; width: number; height: number };
    })[] = [];
    const search = (root: ParentNode): void => {
      for (const one of root.querySelectorAll<HTMLElement>("*")) {
        if (one.localName === "parkade-scene-view") found.push(one as never);
        if (one.shadowRoot) search(one.shadowRoot);
      }
    };
    search(document);
    const {
      vehicle: { rearToFront, rearToBack, width: wide },
    } = geometry;
    const body = ({ x, y, heading }: Pose): [number, number][] =>
      [rearToFront, -rearToBack].flatMap((along) =>
        [wide / 2, -wide / 2].map((across): [number, number] => [
          x + along * Math.cos(heading) - across * Math.sin(heading),
          y + along * Math.sin(heading) + across * Math.cos(heading),
        ]),
      );
    return found
      .filter(({ view }) => view)
      .map((view) => {
        const box = view.getBoundingClientRect(),
          { camera, width, height } = view.view;
        const rect = (points: [number, number][]) => {
          const at = points.map(
            ([x, y]) =>
              [
                box.left + width / 2 + (x - camera.x) * camera.scale,
                box.top + height / 2 - (y - camera.y) * camera.scale,
              ] as const,
          );
          const xs = at.map(([x]) => x),
            ys = at.map(([, y]) => y);
          return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
        };
        return {
          box: { left: box.left, top: box.top, right: box.right, bottom: box.bottom },
          lot: rect(scene.map.boundary),
          cars: [rect(body(geometry.start)), rect(body(geometry.goal))],
          scale: camera.scale,
        };
      });
  });

const overlap = (a: Rect, b: Rect): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
const boxOf = (page: Page, selector: string) =>
  page
    .locator(selector)
    .first()
    .evaluate((one) => {
      const { left, top, right, bottom } = one.getBoundingClientRect();
      return { left, top, right, bottom };
    });

for (const [name, width, height, mode, count] of [
  ["desk", 1400, 900, "grid", 4],
  ["overlay", 1400, 900, "overlay", 1],
  ["focus", 1024, 768, "focus", 4],
  ["phone", 390, 844, "grid", 1],
] as const) {
  test(`the whole lot stands in every map, and nothing over its cars: ${name}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await open(page);
    await page.evaluate(
      (to) => document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ mode: to }),
      mode,
    );
    await settled(page);
    await expect(page.locator("parkade-view-controls button")).toHaveCount(3);
    await expect.poll(async () => (await maps(page)).length).toBe(count);
    const buttons = await boxOf(page, "parkade-view-controls [role=group]");
    for (const { box, lot, cars } of await maps(page)) {
      // The margin is of what the line above the map and what stands on its lower edge leave.
      const across = 0.055 * (box.right - box.left),
        up = 0.055 * (box.bottom - box.top - 28);
      if (box.right - box.left < 300) continue; // A thumbnail of the focus layout.
      expect(Math.min(lot.left - box.left, box.right - lot.right)).toBeGreaterThan(across);
      expect(Math.min(lot.top - box.top, box.bottom - lot.bottom)).toBeGreaterThan(up);
      for (const car of cars) expect(overlap(car, buttons)).toBe(false);
    }
  });
}

test("buttons and keys zoom all maps, and a path that leaves the view has a way back", async ({ page }) => {
  const complaints = complaintsOf(page);
  await page.setViewportSize({ width: 1400, height: 900 });
  await open(page);
  await settled(page);
  const scale = async () => (await maps(page)).map((map) => map.scale);
  const before = await scale(),
    bar = page.locator("parkade-panel[active] .scale");
  await expect(bar).toHaveText("5 m");
  expect((await bar.evaluate((one) => parseFloat(getComputedStyle(one, "::before").width))) / before[0]!).toBeCloseTo(
    5,
    1,
  );
  const pill = page.getByRole("button", { name: "Path leaves the view" });
  await expect(pill).toHaveCount(0);
  for (let i = 0; i < 4; i++) await page.getByRole("button", { name: "Zoom in" }).click();
  await expect.poll(async () => (await scale())[3]! / before[3]!).toBeCloseTo(1.4 ** 4, 1);
  await expect(bar).toHaveText("2 m");
  await pill.click();
  await expect.poll(scale).toEqual(before);
  await expect(pill).toHaveCount(0);
  await page.keyboard.press("-");
  await expect.poll(async () => (await scale())[0]! / before[0]!).toBeCloseTo(1 / 1.4, 2);
  await page.getByRole("button", { name: "Fit to view" }).click();
  await expect.poll(scale).toEqual(before);
  expect(complaints).toEqual([]);
});

test("an embed has the view's buttons with every control only", async ({ page }) => {
  for (const [controls, buttons, bars] of [
    ["full", 3, true],
    ["minimal", 0, true],
    ["none", 0, false],
  ] as const) {
    await page.goto(`./embed.html?${controls}#controls=${controls}&layout=single`);
    const bar = page.locator("parkade-panel .scale");
    await (bars ? expect(bar).toBeVisible() : expect(page.locator("parkade-panel canvas")).toBeVisible());
    await expect(bar).toBeVisible({ visible: bars });
    await expect(page.locator("parkade-view-controls button")).toHaveCount(buttons);
  }
});

const posterLots = (page: Page) =>
  page.locator("#poster svg").evaluateAll((all) =>
    all.map((svg) => {
      const { left, right, top } = svg.getBoundingClientRect(),
        box = (svg as SVGSVGElement).viewBox.baseVal,
        { height } = svg.getBoundingClientRect();
      const scale = Math.min((right - left) / box.width, height / box.height);
      return {
        left: (left + right - scale * box.width) / 2,
        right: (left + right + scale * box.width) / 2,
        top: top + (height - scale * box.height) / 2,
      };
    }),
  );

for (const [name, width, height, colorScheme] of [
  ["desk", 1400, 900, "light"],
  ["narrow desk", 900, 620, "dark"],
  ["phone", 390, 844, "dark"],
  ["phone on its side", 844, 390, "light"],
] as const) {
  test(`the opening picture is there before the planners, and the live one takes its place: ${name}`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
    await page.setViewportSize({ width, height });
    const shifts = await watchShifts(page);
    let letGo = (): void => {};
    const held = new Promise<void>((resolve) => {
      letGo = resolve;
    });
    await page.route("**/*.wasm", async (route) => {
      await held;
      await route.continue();
    });
    await page.goto("./");
    await expect(page.locator("#poster svg")).toHaveCount(4);
    await expect(page.locator('#poster path[fill="url(#hatch)"]')).toHaveCount(2);
    await expect(page.locator("#poster path[fill-opacity]")).toHaveCount(2);
    await page.waitForFunction(() =>
      document.querySelector("parkade-playground")?.shadowRoot?.querySelector("parkade-stage"),
    );
    const lots = await posterLots(page);
    letGo();
    await expect(page.locator("#poster")).toHaveCount(0);
    await expect.poll(async () => (await maps(page)).length).toBe(width > 640 && height >= 480 ? 4 : 1);
    for (const [i, { lot }] of (await maps(page)).entries()) {
      expect(Math.abs(lot.left - lots[i]!.left), "left").toBeLessThan(1.5);
      expect(Math.abs(lot.right - lots[i]!.right), "right").toBeLessThan(1.5);
      expect(Math.abs(lot.top - lots[i]!.top), "top").toBeLessThan(1.5);
    }
    expect((await shifts()).reduce((a, b) => a + b, 0)).toBeLessThan(0.0001);
  });
}

test("a shared scene shows no other one before it", async ({ page }) => {
  await open(page);
  const link = (await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL(),
  ))!;
  await page.route("**/*.wasm", () => {});
  await page.goto("about:blank");
  await page.goto(link);
  await expect(page.locator("#poster")).toBeHidden();
});

for (const [files, locale, button] of [
  ["**/assets/index-*.js", "en-GB", "Try again"],
  ["**/*.wasm", "zh-CN", "重试"],
] as const) {
  test(`a page that fails to load says so and tries again: ${files}`, async ({ browser, baseURL }) => {
    const page = await (await browser.newContext({ locale, viewport: { width: 1400, height: 900 } })).newPage();
    await page.route(files, (route) => route.abort());
    await page.goto(baseURL!);
    const again = page.locator("#poster").getByRole("button", { name: button });
    await expect(again).toBeVisible();
    await page.unroute(files);
    await again.click();
    await expect(page.locator("#poster")).toHaveCount(0);
    await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
    await page.context().close();
  });
}
