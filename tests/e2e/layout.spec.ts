import { expect, test, type Locator, type Page } from "@playwright/test";
import { complaintsOf, open, settled, type PlaygroundElement, type Untyped } from "./playground.js";

const DESKTOPS = [
  [1024, 768],
  [1280, 800],
  [1400, 900],
  [1440, 900],
  [1920, 1080],
] as const;
const PHONES = [
  [320, 480],
  [390, 844],
] as const;
const ON_SIDE = [
  [640, 400],
  [667, 375],
  [844, 390],
] as const;
const TOOLS = [
  "select",
  "brush",
  "wall",
  "rectangle",
  "polygon",
  "car",
  "slot",
  "moving",
  "road",
  "cost",
  "eraser",
  "hand",
];

/** Scrolled to, a person could press it: it is in the window, and nothing lies over its middle. */
async function expectReachable(target: Locator, name: string): Promise<void> {
  // What has just been opened may be drawn anew meanwhile.
  await expect(async () => {
    await target.scrollIntoViewIfNeeded({ timeout: 2000 });
    const reached = await target.evaluate((element) => {
      const { left, right, top, bottom, width, height } = element.getBoundingClientRect(),
        x = (left + right) / 2,
        y = (top + bottom) / 2;
      let hit = document.elementFromPoint(x, y);
      while (hit?.shadowRoot) {
        const inner = hit.shadowRoot.elementFromPoint(x, y);
        if (!inner || inner === hit) break;
        hit = inner;
      }
      return {
        shown:
          width > 0 && height > 0 && left >= 0 && top >= 0 && right <= innerWidth + 0.5 && bottom <= innerHeight + 0.5,
        over: element.contains(hit) || hit === element,
      };
    });
    expect(reached, name).toEqual({ shown: true, over: true });
  }).toPass({ timeout: 10_000 });
}

async function showPlanners(page: Page, count: number): Promise<void> {
  await page.evaluate(async (wanted) => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")! as Untyped;
    await element.app.complete();
    element.store.set({
      planners: element.app.catalog.planners.slice(0, wanted).map(({ id }: { id: string }) => id),
      focus: "hybrid" in element.results ? "hybrid" : "four",
    });
  }, count);
  await settled(page);
}

test("a phone, upright or on its side, has every tool, its sheet and the menu within two taps", async ({ browser }) => {
  test.setTimeout(180_000);
  for (const [width, height] of [...PHONES, ...ON_SIDE]) {
    const page = await browser.newPage({ viewport: { width, height }, hasTouch: true });
    const complaints = complaintsOf(page),
      size = `${width}x${height}`,
      side = width > height;
    await open(page);
    await page.waitForFunction(() => customElements.get("parkade-sheet"));
    const bar = page.locator("parkade-toolbar"),
      sheet = page.locator("parkade-sheet");
    for (const tool of TOOLS)
      await expectReachable((side ? bar : sheet).locator(`[data-tool="${tool}"]`), `${size} ${tool}`);
    for (const planner of ["four", "eight", "risk-field", "hybrid"])
      await expectReachable(page.locator(`parkade-chips [data-planner="${planner}"]`), `${size} ${planner}`);
    await expectReachable(page.locator("parkade-timeline .slider"), `${size} timeline`);
    // One tap opens the drawer; the sheet's tabs are there.
    if (side) await sheet.locator(".toggle").click();
    for (const [tab, content] of [
      ["Results", "parkade-table tr[data-planner] th, parkade-table tr[data-planner] td"],
      ["Settings", "parkade-parameters input"],
      ["Draw", "parkade-objects button"],
    ] as const) {
      await sheet.getByRole("tab", { name: tab }).click();
      await expectReachable(sheet.locator(content).first(), `${size} ${tab}`);
    }
    if (side) await sheet.locator(".toggle").click();
    await bar.getByRole("button", { name: "More" }).click();
    const items = bar.locator(".popover button.item");
    await items.first().waitFor();
    expect(
      (await items.allTextContents()).slice(0, 2).map((text) => text.trim()),
      size,
    ).toEqual(["Share", expect.stringMatching(/^Fit/)]);
    for (const item of await items.all())
      if (await item.isEnabled()) await expectReachable(item, `${size} ${await item.textContent()}`);
    await page.keyboard.press("Escape");
    // A tool's settings come with it.
    await (side ? bar : sheet).locator('[data-tool="slot"]').click();
    await expectReachable(
      page.locator("parkade-options").getByRole("button", { name: "Angled" }).locator("visible=true").first(),
      `${size} options`,
    );
    const map = (await page.locator("parkade-stage").boundingBox())!;
    expect(map.height, `${size} map`).toBeGreaterThanOrEqual(height * 0.2);
    expect(complaints).toEqual([]);
    await page.close();
  }
});

test("a narrow window has every button, and its inspector one click away", async ({ browser }) => {
  for (const [width, height] of [
    [641, 800],
    [768, 1024],
    [900, 600],
    [960, 700],
  ] as const) {
    const page = await browser.newPage({ viewport: { width, height } }),
      size = `${width}x${height}`;
    const complaints = complaintsOf(page);
    await open(page);
    await settled(page);
    const bar = page.locator("parkade-toolbar"),
      inspector = page.locator("parkade-inspector");
    const buttons = bar.locator(".bar button:visible");
    expect(await buttons.count(), size).toBeGreaterThan(TOOLS.length + 6);
    for (const button of await buttons.all()) {
      const box = (await button.boundingBox())!;
      expect(
        [box.x >= 0, box.x + box.width <= width, box.width >= 24],
        `${size} ${await button.getAttribute("aria-label")}`,
      ).toEqual([true, true, true]);
    }
    await expect(inspector).toBeHidden();
    const toggle = bar.getByRole("button", { name: "Properties and parameters" });
    await toggle.click();
    await expect(toggle).toHaveAttribute("aria-expanded", "true");
    await expectReachable(inspector.locator("parkade-parameters input").first(), `${size} parameters`);
    await expectReachable(inspector.locator("parkade-objects button").last(), `${size} objects`);
    await toggle.click();
    await expect(inspector).toBeHidden();
    expect(complaints).toEqual([]);
    await page.close();
  }
});

test("titles stay in their cells, and the list of planners off the cars, with any number of planners", async ({
  page,
}) => {
  test.setTimeout(180_000);
  await open(page);
  for (const [width, height] of DESKTOPS) {
    await page.setViewportSize({ width, height });
    for (const count of [2, 4, 9, 14]) {
      await page.evaluate(() =>
        document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ mode: "grid" }),
      );
      await showPlanners(page, count);
      const crossing = await page.locator("parkade-panel header").evaluateAll((headers) =>
        headers.flatMap((header) => {
          const cell = header.getBoundingClientRect();
          return [...header.children]
            .filter((part) => {
              const { left, right, width: own } = part.getBoundingClientRect();
              return own > 0 && (left < cell.left - 0.5 || right > cell.right + 0.5);
            })
            .map((part) => `${header.textContent} ${part.className || part.localName}`);
        }),
      );
      expect(crossing, `${width} px, ${count} planners`).toEqual([]);
      await page.evaluate(() =>
        document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ mode: "overlay", camera: null }),
      );
      await page.waitForFunction(
        () =>
          (document.querySelector("parkade-playground") as Untyped).shadowRoot
            .querySelector("parkade-stage")
            .shadowRoot.querySelector("parkade-scene-view")?.view,
      );
      expect(await carsUnder(page, ".legend"), `${width} px, ${count} planners`).toEqual([]);
    }
  }
});

/** Which of the two cars an element of the stage covers, by their outlines' corners and middles. */
function carsUnder(page: Page, query: string): Promise<string[]> {
  return page.evaluate((selector) => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")! as Untyped;
    const stage = element.shadowRoot.querySelector("parkade-stage").shadowRoot,
      list = stage.querySelector(selector).getBoundingClientRect();
    const map = stage.querySelector("parkade-scene-view"),
      box = map.getBoundingClientRect(),
      { geometry } = element.store.state,
      { camera } = map.view;
    const { rearToFront, rearToBack, width } = geometry.vehicle;
    return (["start", "goal"] as const).filter((end) => {
      const { x, y, heading } = geometry[end];
      return [
        [rearToFront, 1],
        [rearToFront, -1],
        [-rearToBack, 1],
        [-rearToBack, -1],
        [(rearToFront - rearToBack) / 2, 0],
      ].some(([along, side]) => {
        const dx = along!,
          dy = (side! * width) / 2;
        const wx = x + dx * Math.cos(heading) - dy * Math.sin(heading),
          wy = y + dx * Math.sin(heading) + dy * Math.cos(heading);
        const px = box.left + box.width / 2 + (wx - camera.x) * camera.scale,
          py = box.top + box.height / 2 - (wy - camera.y) * camera.scale;
        return px > list.left && px < list.right && py > list.top && py < list.bottom;
      });
    });
  }, query);
}

test("a tool's settings lie over no map, and the scene's name is whole from 1280 px on", async ({ page }) => {
  await open(page);
  for (const [width, height] of DESKTOPS) {
    await page.setViewportSize({ width, height });
    for (const tool of ["slot", "road", "cost", "wall"]) {
      await page.locator(`parkade-toolbar [data-tool="${tool}"]`).click();
      if (tool === "slot")
        await page
          .locator("parkade-options")
          .getByRole("button", { name: "Angled" })
          .locator("visible=true")
          .first()
          .click();
      const options = (await page.locator("parkade-options").locator("visible=true").first().boundingBox())!;
      const maps = (await page.locator("parkade-stage").boundingBox())!;
      const apart = options.y + options.height <= maps.y + 1 || options.x >= maps.x + maps.width - 1;
      expect(apart, `${width} px, ${tool}`).toBe(true);
    }
    if (width < 1280) continue;
    const ids = await page.evaluate(
      () =>
        (document.querySelector<PlaygroundElement>("parkade-playground")! as Untyped).app.catalog.scenarios.map(
          ({ id }: { id: string }) => id,
        ) as string[],
    );
    const cut = await page.evaluate(async (all) => {
      const element = document.querySelector<PlaygroundElement>("parkade-playground")! as Untyped,
        bar = element.shadowRoot.querySelector("parkade-toolbar");
      const wrong: string[] = [];
      for (const id of all) {
        element.app.preset = id;
        bar.requestUpdate();
        await bar.updateComplete;
        const name = bar.shadowRoot.querySelector(".scene span"),
          row = bar.shadowRoot.querySelector(".bar");
        if (name.scrollWidth > name.clientWidth || row.scrollWidth > row.clientWidth) wrong.push(id);
      }
      return wrong;
    }, ids);
    expect(cut, `${width} px`).toEqual([]);
  }
});

test("with forced colours sliders keep their track and thumb", async ({ page }) => {
  await page.emulateMedia({ forcedColors: "active", reducedMotion: "reduce" });
  await page.goto("./");
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  const slider = page.locator("parkade-parameters .slider").first();
  await expect(slider).toBeVisible();
  const [track, thumb] = await slider.evaluate((element) => [
    getComputedStyle(element, "::-webkit-slider-runnable-track").backgroundColor,
    getComputedStyle(element, "::-webkit-slider-thumb").borderTopColor,
  ]);
  const canvas = await slider.evaluate(() => {
    const probe = document.body.appendChild(document.createElement("i"));
    probe.style.backgroundColor = "Canvas";
    const colour = getComputedStyle(probe).backgroundColor;
    probe.remove();
    return colour;
  });
  expect(track).not.toBe(canvas);
  expect(thumb).not.toBe(canvas);
});
