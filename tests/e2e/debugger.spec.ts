import { readFileSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, open, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

async function openDebugger(page: Page, focus: string): Promise<void> {
  await open(page);
  await page.evaluate(
    (id) => document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ focus: id }),
    focus,
  );
  await page.getByRole("button", { name: "Layers" }).click();
  await page.getByRole("button", { name: "Search debugger" }).click();
}

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Pixels that two boxes share. */
const overlap = (a: Box, b: Box): number =>
  Math.max(0, Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x)) *
  Math.max(0, Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y));

const violations = async (page: Page): Promise<string[]> => {
  const found = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  return found.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.target.join(" ")).join("; ")}`);
};

test("a search is walked forward and back, with reasons, and ends as it began", async ({ page }) => {
  const complaints = complaintsOf(page);
  await openDebugger(page, "eight");
  const panel = page.locator("parkade-debugger"),
    event = panel.locator(".event");
  await expect(event).toContainText("Nothing is expanded yet");
  const next = panel.getByRole("button", { name: "Step", exact: true });
  await next.click();
  await expect(event).toContainText(/Expand \(\d+, \d+\): f [\d.]+ = g 0\.00 \+ h [\d.]+/);
  await expect(panel.getByText("new: into the open list").first()).toBeVisible();
  await expect(panel.locator(".code .now")).toHaveCount(1);
  for (let i = 0; i < 5; i++) await next.click();
  await expect(panel.getByText("closed: already expanded").first()).toBeVisible();
  await expect(panel.getByText("Counters equal the planner's")).toBeVisible();
  expect(await violations(page)).toEqual([]);
  // On every page the map lies beside it, and a zoomed map goes along.
  const stage = page.locator("parkade-stage");
  for (const [width, height] of [
    [844, 390],
    [390, 844],
    [800, 700],
    [1400, 900],
  ] as const) {
    await page.setViewportSize({ width, height });
    await expect.poll(async () => overlap((await stage.boundingBox())!, (await panel.boundingBox())!)).toBeLessThan(1);
  }
  const camera = () =>
    page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.camera);
  await panel.getByRole("button", { name: "Zoom to the cell" }).click();
  const before = await camera();
  await panel.getByRole("button", { name: "Last step" }).click();
  expect(await camera()).not.toEqual(before);
  await panel.getByRole("slider").fill("0");
  for (let i = 0; i < 6; i++) await next.click();
  for (let i = 0; i < 6; i++) await panel.getByRole("button", { name: "Back" }).click();
  await expect(event).toContainText("Nothing is expanded yet");
  await panel.getByRole("button", { name: "Close the debugger" }).click();
  await expect(panel).toHaveCount(0);
  expect(complaints).toEqual([]);
});

test("a run stops where a node is improved, and a planner of cars shows its connections", async ({ page }) => {
  await openDebugger(page, "eight");
  const panel = page.locator("parkade-debugger");
  await panel.getByLabel("when a node is improved").check();
  await panel.getByRole("button", { name: "Run" }).click();
  await expect(panel.locator(".event")).toContainText("Stopped at a breakpoint.");
  await expect(panel.getByText("improved: was").first()).toBeVisible();
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ focus: "hybrid" }),
  );
  await expect(panel.locator(".event")).toContainText("Nothing is expanded yet");
  await panel.getByLabel("Step by").selectOption("failure");
  await panel.getByRole("button", { name: "Step", exact: true }).click();
  await expect(panel.getByText(/The cheapest curve to the other end hits .+ after/)).toBeVisible();
  await expect(panel.getByText(/hits .+ after [\d.]+ m$/).first()).toBeVisible();
  await expect(panel.locator(".code .now")).toHaveText("n ← entry with least f, then oldest");
  expect(await violations(page)).toEqual([]);
});

test(
  "a car's search from both ends is walked with both open lists, and a run stops at a pose near a point of the " +
    "map",
  async ({ page }) => {
    await openDebugger(page, "hybrid-bidirectional");
    const panel = page.locator("parkade-debugger"),
      event = panel.locator(".event");
    await panel.getByRole("button", { name: "Step", exact: true }).click();
    await expect(event).toContainText(/From the (start|goal) · Expand \(.+°\): f [\d.]+ = g 0\.00 \+ h/);
    await expect(panel.getByRole("heading", { name: "From the goal" })).toBeVisible();
    await panel.getByRole("button", { name: "First step" }).click();
    await panel.getByRole("button", { name: "at a pose" }).click();
    // The start stands there.
    const place = await page.evaluate(() => {
      const { store } = document.querySelector<PlaygroundElement>("parkade-playground")!;
      return store.state.scene.start as { x: number; y: number };
    });
    await page.evaluate(
      (hover) => document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ hover }),
      place,
    );
    await page.locator("parkade-stage").dispatchEvent("pointerdown");
    await expect(panel.getByRole("button", { name: "Remove the breakpoint" })).toBeVisible();
    await panel.getByRole("button", { name: "Run" }).click();
    await expect(event).toContainText("Stopped at a breakpoint.");
    expect(await violations(page)).toEqual([]);
  },
);

test("the search is saved as a GIF", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Moving picture" }).click();
  const dialog = page.locator("parkade-movie dialog");
  await dialog.getByLabel("Duration, s").fill("1");
  await dialog.getByLabel("Width, px").selectOption("480");
  expect(await violations(page)).toEqual([]);
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    dialog.getByRole("button", { name: "Save" }).click(),
  ]);
  expect(file.suggestedFilename()).toBe("parkade-drive.gif");
  await expect(dialog.getByRole("status")).toContainText("Saved:");
  // Fifteen frames: fourteen fifteenths of a second, and the rest on the last.
  const bytes = readFileSync(await file.path());
  let hundredths = 0;
  for (let at = bytes.indexOf("21f904", 0, "hex"); at >= 0; at = bytes.indexOf("21f904", at + 1, "hex"))
    hundredths += bytes.readUInt16LE(at + 4);
  expect(hundredths).toBe(93 + 150);
});

test("a task's link opens its scene with hidden answers and the debugger at its step", async ({ page }) => {
  await open(page);
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ focus: "eight", mode: "focus" }),
  );
  const task = Buffer.from(JSON.stringify(["Which cell comes next?", 1, 20, 1])).toString("base64url");
  const link = await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL());
  await page.goto("about:blank");
  await page.goto(`${link}&t=${task}`);
  const card = page.locator("parkade-task");
  await expect(card).toContainText("Which cell comes next?");
  await expect(page.locator("parkade-debugger")).toHaveCount(1);
  await card.getByRole("button", { name: "Show the answers" }).click();
  await expect(card.getByRole("button", { name: "Show the answers" })).toHaveCount(0);
});

test("planners without an open list and the search of a road are walked through in their own words", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  await openDebugger(page, "rrt");
  const panel = page.locator("parkade-debugger"),
    event = panel.locator(".event"),
    next = panel.getByRole("button", { name: "Step", exact: true });
  const focus = (id: string): Promise<void> =>
    page.evaluate(
      (one) => document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ focus: one }),
      id,
    );
  await expect(event).toContainText("The tree has only the start.");
  await next.click();
  await expect(event).toContainText(/Draw \(\d+, \d+\): of the tree, \(\d+, \d+\) is nearest to it, [\d.]+ cells away/);
  await expect(panel.getByText("the cell drawn at random")).toBeVisible();
  await expect(panel.locator(".code .now")).toHaveText("n ← the cell of the tree nearest to r");
  await panel.getByRole("button", { name: "Last step" }).click();
  await expect(event).toContainText("completes the path");
  await expect(panel.getByText(/Tree: [\d,]+ cells/)).toBeVisible();
  expect(await violations(page)).toEqual([]);
  await focus("genetic");
  await expect(event).toContainText("No candidate is judged yet.");
  await next.click();
  await expect(event).toContainText(/Candidate 1: (fitness|a free path)/);
  await expect(panel.getByText(/a free leg|this leg crosses/).first()).toBeVisible();
  await focus("cost-map");
  await expect(event).toContainText("Nothing is expanded yet");
  await next.click();
  await expect(event).toContainText(/Expand \(\d+, \d+\): f [\d.]+ = g 0\.00 \+ h/);
  await expect(panel.getByText("new: into the open list").first()).toBeVisible();
  expect(complaints).toEqual([]);
});
