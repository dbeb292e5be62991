import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import { Planner, init, optimise, scenario, toTrajectoryCSV } from "../../pkg/node.js";
import {
  complaintsOf,
  dragWorld,
  look,
  onScreen,
  open,
  sceneOf,
  settled,
  type PlaygroundElement,
  type Untyped,
} from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 }, permissions: ["clipboard-read", "clipboard-write"] });

interface Driven {
  stage: string | null;
  seconds: number;
  /** Metres of the shown path. */
  length: number;
  planned: number;
}

/** How the focused planner's path is driven; null until its trajectory is there. */
const driven = (page: Page): Promise<Driven | null> =>
  page.evaluate(() => {
    const { state } = document.querySelector<PlaygroundElement>("parkade-playground")!.store as unknown as {
      state: { focus: string; results: Record<string, Untyped> };
    };
    const result = state.results[state.focus];
    if (!result?.smoothed || result.smoothed.of !== result.plan) return null;
    const { trajectory, drive } = result.smoothed;
    return {
      stage: trajectory?.stage ?? null,
      seconds: drive.t.at(-1),
      length: drive.stations.at(-1),
      planned: result.drive.t.at(-1),
    };
  });

/** The hash of the focused planner's trajectory, and the plan that it was made of. */
const made = (page: Page) =>
  page.evaluate(() => {
    const { state } = document.querySelector<PlaygroundElement>("parkade-playground")!.store as unknown as {
      state: { focus: string; results: Record<string, Untyped> };
    };
    const { path, directions, curvatures, metrics } = state.results[state.focus].plan,
      { hash } = state.results[state.focus].smoothed.trajectory;
    const columns = { path: [...path], directions: [...directions], curvatures: [...curvatures] } as Record<
      string,
      number[]
    >;
    return { ...columns, hash, margin: metrics.margin } as { path: number[]; hash: string; margin: number };
  });

/** Better paths have been looked for, and none takes the place of what is shown any more. */
const rested = (page: Page): Promise<unknown> =>
  page.waitForFunction(() => {
    const { state } = document.querySelector<PlaygroundElement>("parkade-playground")!.store as unknown as {
      state: { focus: string; choices?: Record<string, unknown>; improving?: string };
    };
    return state.choices?.[state.focus] && !state.improving;
  });

async function smoothed(page: Page): Promise<Driven> {
  await expect.poll(() => driven(page), { timeout: 15_000 }).not.toBeNull();
  return (await driven(page))!;
}

/** The table's seconds of a planner, the clock's total, and the last second of the chart. */
const cell = (page: Page, name: string) =>
  page.locator("parkade-table tbody tr", { hasText: name }).locator("td").nth(2);
const total = (page: Page) => page.locator("parkade-timeline .now");
const smooth = (page: Page) => page.locator("parkade-panel[active] parkade-smooth").getByRole("switch");

const csv = (text: string, name = "theirs.csv") => ({ name, mimeType: "text/csv", buffer: Buffer.from(text) });
const choose = (page: Page, text: string, name?: string) =>
  page.locator("parkade-playground input[type=file]").setInputFiles(csv(text, name));

async function alone(page: Page, planner = "hybrid"): Promise<void> {
  await page.evaluate((id) => {
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ planners: [id], focus: id });
  }, planner);
  await settled(page);
}

async function downloaded(page: Page, name: string): Promise<string> {
  await page.getByRole("button", { name: "Export" }).click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name }).click()]);
  const parts: Buffer[] = [];
  for await (const part of await download.createReadStream()) parts.push(part as Buffer);
  return Buffer.concat(parts).toString();
}

test("paths are driven as trajectories, and everything tells their seconds", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await alone(page);
  await rested(page);
  const { stage, seconds, planned } = await smoothed(page);
  expect(stage).toBe("optimised");
  expect(seconds).toBeLessThan(planned);
  const { hash, margin, ...plan } = await made(page);
  await init();
  expect(optimise(scenario("perpendicular"), plan, { margin }).hash, "as in Node").toBe(hash);
  const text = seconds.toFixed(1);
  await expect(cell(page, "Hybrid")).toContainText(text);
  await expect(total(page)).toHaveText(`${text} / ${text} s`);
  const card = page.locator("parkade-trajectory");
  await expect(card.locator(".stage")).toContainText("Optimised");
  await expect(card.locator("dd").first()).toContainText(text);
  const charts = page.locator("parkade-charts");
  await charts.getByRole("button", { name: "Time" }).click();
  await expect(charts.locator(".right div")).toHaveText([
    /Speed.*m\/s$/,
    /Acceleration.*m\/s²$/,
    /Steering.*°$/,
    /Steering rate.*°\/s$/,
  ]);
  const path = await downloaded(page, "CSV path"),
    timed = await downloaded(page, "CSV trajectory");
  expect(Number(path.trim().split("\n").at(-1)!.split(",").at(-1))).toBeCloseTo(seconds, 4);
  expect(Number(timed.trim().split("\n").at(-1)!.split(",")[0])).toBe(seconds);

  await smooth(page).click();
  await expect(cell(page, "Hybrid")).toContainText(planned.toFixed(1));
  await expect(total(page)).toContainText(`/ ${planned.toFixed(1)} s`);
  await expect(card).toContainText("drives the planned path");
  expect(
    await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.canUndo),
  ).toBe(false);
  expect(complaints).toEqual([]);
});

test("the planned path stays visible, thinner, under the trajectory", async ({ page }) => {
  await open(page);
  await alone(page);
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ mode: "focus" }),
  );
  await smoothed(page);
  const picture = () => page.locator("parkade-panel[active] canvas").screenshot();
  const withGhost = await picture();
  // Without the plan that it was made of nothing else changes.
  await page.evaluate(() => {
    const { store } = document.querySelector<PlaygroundElement>("parkade-playground")! as unknown as {
      store: { state: { results: Record<string, Untyped> }; set(patch: object): void };
    };
    const { hybrid } = store.state.results;
    hybrid.smoothed.of.path = new Float64Array(6);
    store.set({ results: { ...store.state.results } });
  });
  await expect.poll(async () => (await picture()).equals(withGhost)).toBe(false);
});

test("the switch is remembered, kept in the link, and worked by keys", async ({ page }) => {
  await open(page);
  await smoothed(page);
  await expect(smooth(page)).toHaveAttribute("aria-checked", "true");
  await smooth(page).focus();
  await page.keyboard.press("Space");
  await expect(smooth(page)).toHaveAttribute("aria-checked", "false");
  await page.getByRole("button", { name: "Share" }).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain("&v=");
  const off = await page.evaluate(() => navigator.clipboard.readText());
  await open(page);
  await expect(smooth(page)).toHaveAttribute("aria-checked", "false");
  await page.locator("parkade-trajectory").getByRole("switch").check();
  await smoothed(page);
  // The link's choice goes before the remembered one, and does not change it.
  await open(page, new URL(off).hash);
  await page.reload();
  await expect(smooth(page)).toHaveAttribute("aria-checked", "false");
  expect(await page.evaluate(() => localStorage.getItem("parkade.smooth"))).toBe("on");
});

test("a drag shows the planned path, and the trajectory follows when it ends", async ({ page }) => {
  await open(page);
  await alone(page);
  await smoothed(page);
  const { start } = await sceneOf(page);
  await look(page, start.x + 3, start.y, 20);
  const from = await onScreen(page, start.x, start.y);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 15, from.y, { steps: 6 });
  await expect(cell(page, "Hybrid")).toHaveText("…");
  await expect.poll(() => driven(page)).toBeNull();
  await page.mouse.up();
  const { stage } = await smoothed(page);
  expect(stage).not.toBeNull();
  await page.keyboard.press("Control+z");
  await settled(page);
  await smoothed(page);
  expect((await sceneOf(page)).start).toEqual(start);
});

test("a trajectory from a file is judged and driven beside ours, and goes when it is removed", async ({ page }) => {
  const complaints = complaintsOf(page);
  await init();
  const scene = scenario("perpendicular"),
    planner = new Planner("hybrid", scene),
    made = optimise(scene, planner.plan(), { speed: 1.2 });
  planner.free();
  await open(page);
  await rested(page);
  const ours = await smoothed(page);
  await choose(page, toTrajectoryCSV(made));
  const card = page.locator("parkade-guest");
  await expect(card.getByRole("status")).toContainText("Passes.");
  await expect(page.locator("parkade-notices .notice")).toContainText(
    `theirs.csv passes: ${made.duration.toFixed(1)} s`,
  );
  const row = (name: string) => card.locator("tbody tr", { hasText: name }).locator("td");
  await expect(row("Duration")).toHaveText([made.duration.toFixed(1), ours.seconds.toFixed(1)]);
  await expect(row("Frames that touch")).toHaveText(["0", "0"]);
  await expect(row("Goal attained")).toHaveText(["yes", "yes"]);
  // The clock goes on until the slower of the two has arrived.
  await expect(total(page)).toContainText(`/ ${made.duration.toFixed(1)} s`);
  await expect(page.locator("parkade-charts path.line")).not.toHaveCount(0);

  // An edit has it judged again; another scene opens without it.
  const { start } = await sceneOf(page);
  await look(page, start.x + 3, start.y, 20);
  await dragWorld(page, [start.x, start.y], [start.x + 0.6, start.y]);
  await expect(card.getByRole("status")).toContainText("Fails.");
  await expect(row("Goal attained").first()).toHaveText("no");
  await card.getByRole("button", { name: "Remove theirs.csv" }).click();
  await expect(card.locator("table")).toHaveCount(0);
  await choose(page, toTrajectoryCSV(made));
  await expect(card.locator("table")).toHaveCount(1);
  await page.evaluate(async () => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.scene = "reverse-in";
    await element.updateComplete;
    await element.settled();
  });
  await expect(card.locator("table")).toHaveCount(0);
  expect(complaints).toEqual([]);
});

test("a trajectory opens by dropping it, and one that touches something says what, and when", async ({ page }) => {
  await open(page);
  const text = "t,x,y,theta\n0,4,3,0\n4,12,3,0\n12,60,3,0\n";
  await page.evaluate((content) => {
    const data = new DataTransfer();
    data.items.add(new File([content], "through.csv"));
    const root = document.querySelector("parkade-playground")!.shadowRoot!.querySelector("[role=region]")!;
    root.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, text);
  const card = page.locator("parkade-guest");
  await expect(card.getByRole("status")).toContainText(/Fails\. Touches .+ after \d+\.\d s\./);
});

test("mistakes in a file are told by line and column, in both languages, and change nothing", async ({ page }) => {
  await open(page);
  const before = await sceneOf(page);
  const notice = page.locator("parkade-notices .notice");
  await choose(page, "t,x,y,theta\n0,4,3,0\n1,four,3,0\n");
  await expect(notice).toContainText(
    'theirs.csv was not judged. Line 3, column 3: x must be a finite number, got "four". Nothing has changed.',
  );
  await choose(page, "t,x,y,yaw\n0,4,3,0\n1,5,3,0\n");
  await expect(notice).toContainText("Line 1, column 7: must be one of t, x, y, theta");
  await page.locator("parkade-toolbar .lang").click();
  await choose(page, "t,x,y,theta\n0,4,3,0\n0,5,3,0\n");
  await expect(notice).toContainText("未能评判 theirs.csv。第 3 行第 1 列：");
  await expect(notice).not.toContainText("must");
  expect(await sceneOf(page)).toEqual(before);
  await expect(page.locator("parkade-guest table")).toHaveCount(0);
});

for (const [name, viewport] of [
  ["a phone", { width: 390, height: 844 }],
  ["a phone on its side", { width: 844, height: 390 }],
] as const) {
  test(`${name} has the switch and the figures with the settings`, async ({ page }) => {
    await page.setViewportSize(viewport);
    await open(page);
    await settled(page);
    if (viewport.height < 480) await page.locator("parkade-sheet .toggle").click();
    await page.locator("parkade-sheet").getByRole("tab").nth(2).click();
    await smoothed(page);
    const card = page.locator("parkade-trajectory");
    await expect(card.locator(".stage")).toBeVisible();
    await card.getByRole("switch").click();
    await expect(card).toContainText("drives the planned path");
    const box = (await card.locator("label").boundingBox())!;
    expect(box.x + box.width).toBeLessThanOrEqual(viewport.width);
  });
}

for (const colorScheme of ["light", "dark"] as const) {
  test(`charts in time, the switch and a judged file satisfy axe in ${colorScheme} colours`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page);
    await smoothed(page);
    await choose(page, "t,x,y,theta\n0,4,3,0\n2.5,7.125,3,0\n6.5,14,3,0\n");
    await expect(page.locator("parkade-guest table")).toHaveCount(1);
    await page.locator("parkade-charts").getByRole("button", { name: "Time" }).click();
    const { violations } = await new AxeBuilder({ page })
      .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
      .analyze();
    expect(
      violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(" ")).join("; ")}`),
    ).toEqual([]);
  });
}
