import { expect, test, type Locator, type Page } from "@playwright/test";
import { complaintsOf, watchShifts, type PlaygroundElement } from "./playground";

const open = async (page: Page, path = "/"): Promise<void> => {
  await page.goto(path);
  await page.evaluate(async () => {
    const element = document.querySelector<PlaygroundElement>("[permalink]")!;
    await element.ready;
    await element.settled();
  });
};

const failing = (page: Page): Promise<string[]> =>
  page.evaluate(() =>
    Object.entries(document.querySelector<PlaygroundElement>("[permalink]")!.results)
      .filter(([, plan]) => plan?.outcome === "found" && plan.check.verdict === "collides")
      .map(([planner]) => planner),
  );
const camera = (page: Page) =>
  page.evaluate(
    () =>
      document.querySelector<PlaygroundElement>("[permalink]")!.store.state.camera as {
        x: number;
        y: number;
        scale: number;
      } | null,
  );
const set = (page: Page, patch: Record<string, unknown>) =>
  page.evaluate((given) => document.querySelector<PlaygroundElement>("[permalink]")!.store.set(given), patch);
const firstHit = (page: Page, planner: string) =>
  page.evaluate(
    (id) => document.querySelector<PlaygroundElement>("[permalink]")!.results[id]!.check.firstHit!.pose,
    planner,
  );

const SENTENCE = /^(Hits .+ after \d+\.\d m\.|Overlaps .+ at the start\.) .+/;

/** The line is inside the panel and wholly visible. */
async function expectWhole(line: Locator): Promise<void> {
  await expect(line.locator("p")).toHaveText(SENTENCE);
  const cut = await line
    .locator("p")
    .evaluate((p) => p.scrollHeight > p.clientHeight + 1 || p.scrollWidth > p.clientWidth + 1);
  // biome-ignore lint/performance/useDomNodeTextContent: only what is shown counts
  expect(cut, await line.locator("p").innerText()).toBe(false);
}

test("in a grid each panel that fails says what it hits, and one click zooms to it", async ({ page }) => {
  const complaints = complaintsOf(page),
    shifts = await watchShifts(page);
  await open(page);
  const [planner] = await failing(page),
    id = planner!;
  const order = await page.evaluate(() =>
    Object.keys(document.querySelector<PlaygroundElement>("[permalink]")!.results),
  );
  const panel = page.locator("parkade-panel").nth(order.indexOf(id)),
    line = panel.locator("parkade-failure");
  await expectWhole(line);
  const before = await panel.locator("canvas").boundingBox(),
    moved = (await shifts()).length;
  await line.getByRole("button").click();
  const hit = await firstHit(page, id);
  await expect
    .poll(async () => {
      const at = await camera(page);
      return at ? Math.hypot(at.x - hit.x, at.y - hit.y) : Infinity;
    })
    .toBeLessThan(6);
  await expect.poll(async () => (await camera(page))!.scale).toBeGreaterThan(12);
  expect(await panel.locator("canvas").boundingBox()).toEqual(before);
  expect((await shifts()).slice(moved).reduce((sum, one) => sum + one, 0)).toBeLessThan(0.005);
  expect(complaints).toEqual([]);
});

test("it flies to the same place that it jumps to with reduced motion", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await page.locator("parkade-failure button").first().click();
  const jumped = await camera(page);
  await page.waitForTimeout(300);
  expect(await camera(page)).toEqual(jumped);
  expect(jumped).not.toBeNull();
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await set(page, { camera: null });
  await page.locator("parkade-failure button").first().click();
  // How many steps it takes is the machine's business.
  await expect.poll(() => camera(page)).toEqual(jumped);
});

for (const mode of ["overlay", "focus"] as const) {
  test(`in ${mode} the chosen planner's line is over the map`, async ({ page }) => {
    await open(page);
    const [planner] = await failing(page);
    await set(page, { mode, focus: planner });
    const line = page.locator(
      mode === "focus" ? "parkade-panel.large parkade-failure" : "parkade-stage .one > parkade-failure",
    );
    await expectWhole(line);
    await line.getByRole("button").click();
    await expect.poll(() => camera(page)).not.toBeNull();
  });
}

test(
  "on a phone it stands on the map's lower edge, above the chips, and nothing moves when another planner is " +
    "chosen",
  async ({ page }) => {
    await page.setViewportSize({ width: 390, height: 844 });
    await open(page);
    const [planner] = await failing(page),
      map = page.locator("parkade-stage canvas"),
      line = page.locator(".layout-narrow > parkade-failure");
    const before = await map.boundingBox();
    await set(page, { focus: planner });
    await expectWhole(line);
    expect(await map.boundingBox()).toEqual(before);
    const at = (await line.boundingBox())!,
      chips = (await page.locator("parkade-chips button[aria-pressed]").first().boundingBox())!;
    expect(at.y).toBeGreaterThanOrEqual(before!.y + before!.height - 41);
    expect(at.y + at.height).toBeLessThanOrEqual(chips.y);
    await line.getByRole("button").click();
    await expect.poll(() => camera(page)).not.toBeNull();
  },
);

test("the live region says why, in the page's language", async ({ page }) => {
  await open(page);
  await expect(page.locator("parkade-notices output")).toContainText(/: (Hits|Overlaps) .+\. /);
  await page.evaluate(() => document.querySelector("[permalink]")!.setAttribute("lang", "zh"));
  await expect(page.locator("parkade-failure p").first()).toContainText(/[撞重]/);
});

test("the line lies on neither car at the cameras that fit", async ({ page }) => {
  await open(page);
  for (const scene of ["perpendicular", "angled", "parallel", "reverse-in"]) {
    await page.evaluate(async (id) => {
      const element = document.querySelector<PlaygroundElement>("[permalink]")!;
      element.scene = id;
      await element.updateComplete;
      await element.settled();
    }, scene);
    const covered = await page.evaluate(() => {
      const element = document.querySelector<PlaygroundElement>("[permalink]")!,
        { start } = element.sceneData;
      return [
        ...element.shadowRoot!.querySelector("parkade-stage")!.shadowRoot!.querySelectorAll("parkade-panel"),
      ].filter((panel) => {
        const view = (
          panel.shadowRoot!.querySelector("parkade-scene-view") as unknown as {
            view: { camera: { y: number; scale: number }; height: number };
          }
        ).view;
        const line = panel.shadowRoot!.querySelector("parkade-failure")!.getBoundingClientRect(),
          map = panel.shadowRoot!.querySelector(".body")!.getBoundingClientRect();
        const y = map.top + view.height / 2 - (start.y - view.camera.y) * view.camera.scale;
        return line.height > 0 && y > line.top && y < line.bottom;
      }).length;
    });
    expect(covered, scene).toBe(0);
  }
});
