import { expect, test, type Page } from "@playwright/test";
import type { Scenario } from "parkade";
import { look, onScreen, open, sceneOf, settled, type PlaygroundElement, type Untyped } from "./playground.js";
import { drag, openLot } from "./hands.js";

test.use({ viewport: { width: 1400, height: 900 }, permissions: ["clipboard-read", "clipboard-write"] });

const store = <T>(read: (state: Record<string, Untyped>) => T): string =>
  `(${read.toString()})(document.querySelector("parkade-playground").store.state)`;

async function openPreset(page: Page, id: string): Promise<void> {
  await page.evaluate(async (scene) => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.scene = scene;
    await element.updateComplete;
    await element.settled();
  }, id);
}

test("the hybrid search's failed connections and the place where there is no way are drawn", async ({ page }) => {
  await open(page);
  await page.evaluate(() =>
    document
      .querySelector<PlaygroundElement>("parkade-playground")!
      .store.set({ mode: "focus", focus: "hybrid", camera: { x: 15, y: 15, scale: 16 } }),
  );
  await openPreset(page, "narrow-gap");
  const large = page.locator("parkade-panel.large");
  await expect(large.locator("parkade-failure p")).toContainText(
    "No way through: the gap is 2.50 m wide, the car needs 2.60 m.",
  );
  const gap = await page.evaluate(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.results["hybrid"]!.obstruction,
  );
  expect(gap).toMatchObject({ kind: "gap", needed: 2.6 });
  // The gap is marked where it is, in the colour of errors.
  const { x, y } = gap as { x: number; y: number };
  await page.evaluate(
    ([cx, cy]) =>
      document
        .querySelector<PlaygroundElement>("parkade-playground")!
        .store.set({ camera: { x: cx, y: cy, scale: 30 } }),
    [x, y],
  );
  const redness = () =>
    large.locator("canvas").evaluate((canvas: HTMLCanvasElement) => {
      const [r, , b] = canvas.getContext("2d")!.getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data;
      return r! - b!;
    });
  await expect.poll(redness).toBeGreaterThan(30);

  await openPreset(page, "par-8.0");
  const trace = await page.evaluate(() => {
    const { trace } = document.querySelector<PlaygroundElement>("parkade-playground")!.results["hybrid"]!;
    if (trace?.kind !== "arcs") return null;
    const gears = trace.arcs.filter((_, i) => i % 5 === 4);
    return {
      forward: gears.filter((length) => length > 0).length,
      reverse: gears.filter((length) => length < 0).length,
      failed: trace.failedExpansions.first.length,
    };
  });
  expect(trace!.forward).toBeGreaterThan(0);
  expect(trace!.reverse).toBeGreaterThan(0);
  expect(trace!.failed).toBeGreaterThan(0);
  const shot = () => large.locator("canvas").screenshot();
  const without = await shot();
  await page.getByRole("button", { name: "Layers" }).click();
  await page.getByLabel("Search tree").check();
  await page.keyboard.press("Escape");
  await expect(large.locator(".legend.tree")).toContainText("dotted: reverse");
  await expect.poll(async () => (await shot()).equals(without)).toBe(false);
});

test("charts and map point at the same place, and gear changes are marked on both", async ({ page }) => {
  await open(page);
  await openPreset(page, "reverse-in");
  const charts = page.locator("parkade-charts"),
    changes = await page.evaluate(
      () =>
        document.querySelector<PlaygroundElement>("parkade-playground")!.results["hybrid"]!.metrics.directionChanges,
    );
  await expect(charts.locator(".diamond")).toHaveCount(changes);
  await expect(charts.locator("rect.band")).not.toHaveCount(0);
  const box = (await charts.locator(".plots").boundingBox())!;
  // Polled: the trajectory may take the plan's place between the move and the look.
  const nearest = async () => {
    await page.mouse.move(box.x + box.width * 0.39, box.y + 30);
    await page.mouse.move(box.x + box.width * 0.4, box.y + 30);
    const hover = await page.evaluate<{ x: number; y: number }>(store((state) => state["hover"]));
    const path = await page.evaluate<number[]>(
      store((state) => [...(state["results"].hybrid.smoothed?.plan ?? state["results"].hybrid.plan).path]),
    );
    const apart = (i: number) => Math.hypot(path[3 * i]! - hover.x, path[3 * i + 1]! - hover.y);
    return Math.min(...Array.from({ length: path.length / 3 }, (_, i) => apart(i)));
  };
  await expect.poll(nearest).toBeLessThan(0.1);
  await expect(charts.locator(".dot")).toHaveCount(3);
  await expect(page.locator("parkade-panel[active] .readout")).toContainText("κ");
});

test("the charts keep their places while the car is dragged and has no speeds yet", async ({ page }) => {
  await open(page);
  const charts = page.locator("parkade-charts");
  await expect(charts.locator(".right div")).toHaveText([/Curvature/, /Clearance/, /Speed.*m\/s/]);
  const { x, y } = await page.evaluate(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.sceneData.start,
  );
  await look(page, x, y, 20);
  const at = await onScreen(page, x, y);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 20, at.y, { steps: 5 });
  await expect(charts.locator(".right div")).toHaveText([/Curvature/, /Clearance/, "Speed–"]);
  await page.mouse.up();
  await expect(charts.locator(".right div")).toHaveText([/Curvature/, /Clearance/, /Speed.*m\/s/]);
});

test("where paths differ is told apart, and other paths can stand behind", async ({ page }) => {
  await open(page);
  const panel = page.locator("parkade-panel[active] canvas");
  for (const name of ["Path differences", "Other paths (faint)"]) {
    const before = await panel.screenshot();
    await page.getByRole("button", { name: "Layers" }).click();
    await page.getByLabel(name).check();
    await page.keyboard.press("Escape");
    await expect.poll(async () => (await panel.screenshot()).equals(before)).toBe(false);
  }
});

test("a benchmark shows medians and their middle half; the table and the hash can be copied", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Benchmark 25×" }).click();
  await expect(page.locator("parkade-table tbody tr").first()).toContainText(/\[[\d.]+–[\d.]+\]/, { timeout: 30_000 });
  await expect(page.locator("parkade-table thead")).toContainText("n=25");
  const copied = async (name: string): Promise<string> => {
    await page.locator("parkade-table").getByRole("button", { name: "Copy" }).click();
    await page.getByRole("button", { name }).click();
    await expect(page.locator("parkade-table").getByRole("button", { name: "Copied" })).toBeVisible();
    const text = await page.evaluate(() => navigator.clipboard.readText());
    await page.waitForTimeout(2100);
    return text;
  };
  expect(await copied("As Markdown")).toMatch(/^\| Planner \| Status \|.*\n\| --- \|/);
  expect((await copied("As CSV")).split("\n")).toHaveLength(5);
  const rows = JSON.parse(await copied("As JSON")) as {
    planner: string;
    hash: string;
    samples: number[];
    drivable: boolean;
    best: string[];
  }[];
  expect(rows.map((row) => row.samples.length)).toEqual([25, 25, 25, 25]);
  expect(rows.filter((row) => !row.drivable).every((row) => row.best.length === 0)).toBe(true);
  await page.locator("parkade-table .hash").click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(
    rows.find((row) => row.planner === "hybrid")!.hash,
  );
});

test("searches are scrubbed by percent and by expansions, all at once", async ({ page }) => {
  await open(page);
  await page.locator("parkade-timeline").getByRole("button", { name: "Search" }).click();
  await page.locator("parkade-timeline input[type=range]").fill("0.5");
  await expect(page.locator("parkade-timeline .now")).toHaveText("50 %");
  await page.locator("parkade-timeline select.unit").selectOption("expansions");
  const most = await page.evaluate(() =>
    Math.max(
      ...Object.values(document.querySelector<PlaygroundElement>("parkade-playground")!.results).map(
        (plan) => plan!.stats.expanded,
      ),
    ),
  );
  await expect(page.locator("parkade-timeline .now")).toContainText(
    most.toLocaleString("en", { useGrouping: "min2" } as Intl.NumberFormatOptions),
  );
  await page.getByRole("button", { name: "Step forward" }).click();
  const fraction = await page.evaluate<number>(store((state) => state["playback"].fraction));
  expect(fraction * most).toBeCloseTo(0.5 * most + 1, 3);
  await page.getByRole("button", { name: "Step back" }).click({ modifiers: ["Shift"] });
  expect(await page.evaluate<number>(store((state) => state["playback"].fraction))).toBeCloseTo(fraction - 0.1, 6);
});

test("a shared link shows the scene as it was looked at", async ({ page }) => {
  await open(page);
  await page.waitForFunction(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
  );
  const looks = ({ mode, focus, planners, layers, playback, camera }: Record<string, Untyped>) => ({
    mode,
    focus,
    planners,
    layers,
    playback: { base: playback.base, fraction: playback.fraction },
    camera,
  });
  await page.evaluate(() => {
    const { store } = document.querySelector<PlaygroundElement>("parkade-playground")! as unknown as {
      store: { state: Record<string, Untyped>; set(patch: object): void };
    };
    store.set({
      mode: "overlay",
      planners: ["eight", "any-angle", "hybrid"],
      focus: "any-angle",
      camera: { x: 12.5, y: 9.25, scale: 31.5 },
      layers: { ...store.state["layers"], difference: true, risk: false },
      playback: { ...store.state["playback"], base: "search", fraction: 0.375 },
    });
  });
  await settled(page);
  const before = await page.evaluate<ReturnType<typeof looks>>(store(looks));
  await page.getByRole("button", { name: "Share" }).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain("&v=");
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link.length).toBeLessThan(1900);
  await page.goto("about:blank");
  await page.goto(link);
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  await settled(page);
  expect(await page.evaluate(store(looks))).toEqual(before);
  // What comes of a damaged view is only the scene.
  await page.goto("about:blank");
  await page.goto(link.replace(/&v=.*/, "&v=7~nobody~%%~~9~x~1"));
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  await settled(page);
  expect(await page.evaluate(store((state) => [state["mode"], state["planners"].length]))).toEqual(["grid", 4]);
});

test("panes are resized by pointer and by keys, and stay so", async ({ page }) => {
  await open(page);
  const inspector = page.locator("parkade-inspector"),
    bar = page.locator("parkade-splitter[pane=side]");
  const width = async () => (await inspector.boundingBox())!.width;
  const before = await width(),
    box = (await bar.boundingBox())!;
  await page.mouse.move(box.x + 4, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x - 76, box.y + 100, { steps: 3 });
  await page.mouse.up();
  expect(await width()).toBeCloseTo(before + 80, -1);
  await bar.press("ArrowRight");
  const now = await width();
  expect(now).toBeLessThan(before + 75);
  await page.reload();
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  await expect.poll(width).toBeCloseTo(now, -1);
  await page.locator("parkade-splitter[pane=side]").dblclick({ position: { x: 4, y: 200 } });
  await expect.poll(width).toBe(before);
});

test("every planner has a best and a worst case in the gallery, drawn with its path", async ({ page }) => {
  await open(page);
  await page.waitForFunction(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
  );
  await page.locator("parkade-toolbar .scene").click();
  const dialog = page.locator("parkade-presets");
  await dialog.getByRole("button", { name: "Best and worst" }).click();
  const planners = await page.evaluate(
    () =>
      (document.querySelector("parkade-playground") as unknown as { app: { catalog: { planners: unknown[] } } }).app
        .catalog.planners.length,
  );
  await expect(dialog.locator("h3")).toHaveCount(planners);
  await expect(dialog.locator("li")).toHaveCount(2 * planners);
  await expect
    .poll(
      () =>
        dialog
          .locator("parkade-thumbnail")
          .first()
          .evaluate((one) => (one as unknown as { plan?: { outcome: string } }).plan?.outcome),
      { timeout: 20_000 },
    )
    .toBe("found");
  await dialog.locator("li button", { hasText: "Two expansions for twenty metres?" }).click();
  await settled(page);
  await expect(page.locator("parkade-panel[active]")).toContainText("Jump point");
});

test("the drive plays and rests by its key, and what the car sweeps is drawn", async ({ page }) => {
  await open(page);
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ mode: "focus", focus: "hybrid" }),
  );
  const fraction = () => page.evaluate(store((state) => state["playback"].fraction as number));
  const playing = () => page.evaluate(store((state) => state["playback"].playing as boolean));
  await page.evaluate(() =>
    (document.querySelector("parkade-playground") as unknown as { seek(at: number, how: object): void }).seek(0, {
      base: "drive",
    }),
  );
  await page.locator("body").press("a");
  await expect.poll(fraction).toBeGreaterThan(0);
  await page.locator("body").press("a");
  await expect.poll(playing).toBe(false);
  const rest = await fraction();
  expect(rest).toBeLessThan(1);
  const canvas = page.locator("parkade-panel.large canvas");
  const picture = () => canvas.evaluate((element: HTMLCanvasElement) => element.toDataURL());
  const layer = (on: boolean) =>
    page.evaluate((sweep) => {
      const { store } = document.querySelector<PlaygroundElement>("parkade-playground")!;
      store.set({ layers: { ...(store.state as unknown as { layers: object }).layers, sweep } });
    }, on);
  await layer(false);
  await page.waitForFunction(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true)))),
  );
  const without = await picture();
  await layer(true);
  await expect.poll(picture).not.toBe(without);
  expect(await fraction()).toBe(rest);
});

test("a newcomer draws a wall and slots, parks in the third, and learns why the eight-neighbour path fails", async ({
  page,
}) => {
  const lot: Partial<Scenario> = { start: { x: 8, y: 20, heading: 0 }, goal: { x: 30, y: 20, heading: 0 } };
  await openLot(page, lot);
  await page.evaluate(() =>
    document
      .querySelector<PlaygroundElement>("parkade-playground")!
      .store.set({ planners: ["four", "eight", "risk-field", "hybrid"], focus: "hybrid" }),
  );
  await drag(page, [
    [31.5, 20],
    [31.5, 22],
  ]);
  await page.locator("parkade-toolbar .tool").nth(2).click();
  await drag(page, [
    [22, 16],
    [22, 22],
  ]);
  await page.locator("parkade-toolbar .tool").nth(6).click();
  await drag(page, [
    [14, 10],
    [25.5, 10],
  ]);
  await settled(page);
  const { slots } = await sceneOf(page);
  expect(slots).toHaveLength(4);
  const bay = slots![2]!,
    at = await onScreen(page, bay.x, bay.y - 3);
  await page.mouse.click(at.x, at.y);
  await settled(page);
  expect((await sceneOf(page)).goal).toMatchObject({ slot: bay.id });
  const rows = page.locator("parkade-table tbody tr");
  await expect(rows.filter({ hasText: "8-neighbour" }).locator("td").first()).toHaveText(
    /Turns in place|Hits at|Too tight|Starts/,
  );
  await page.getByRole("button", { name: "Share" }).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain("#s=1");
});
