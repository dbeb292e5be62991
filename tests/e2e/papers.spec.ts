import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, open } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 }, permissions: ["clipboard-read", "clipboard-write"] });

const dialog = (page: Page) => page.locator("parkade-papers dialog");
const measured = (page: Page) =>
  expect(dialog(page).getByRole("button", { name: "Measure" })).toBeVisible({ timeout: 60_000 });

test("the papers' tables are measured beside the printed ones, and impossible rows are flagged", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await page.keyboard.press("y");
  await expect(dialog(page).getByRole("progressbar")).toBeVisible();
  await measured(page);
  await expect(dialog(page).locator("h3")).toHaveCount(7);
  await expect(dialog(page).locator("h3").last()).toContainText("20 maps");
  await expect(dialog(page).locator("td .chip.err")).toHaveCount(4);
  await expect(dialog(page).locator("td .chip.err").first()).toContainText("below the straight line, 140.01");
  await expect(dialog(page).locator(".claims li")).toHaveCount(9);
  await expect(dialog(page).locator("#H1 .chip")).toContainText("holds in part");
  await expect(dialog(page).locator("#Y4 .chip")).toContainText("holds");
  const row = dialog(page).locator("table").first().locator("tbody tr").filter({ hasText: "Risk field" }).first();
  await expect(row).toContainText("81");
  await expect(row).toContainText("42.29");
  const { violations } = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  expect(violations.map((one) => `${one.id} ${one.nodes.map((node) => node.target.join(" ")).join("; ")}`)).toEqual([]);

  await dialog(page).getByRole("button", { name: "Copy as Markdown" }).click();
  const markdown = await page.evaluate(() => navigator.clipboard.readText());
  expect(markdown).toContain("### Table 4: random obstacles, 100 × 100 (20 maps)");
  expect(markdown).toMatch(/\| 8-neighbour \| 599 \|.*135\.86 \(below the straight line, 140\.01\)/);
  await dialog(page).getByRole("button", { name: "Copy as JSON" }).click();
  const json = JSON.parse(await page.evaluate(() => navigator.clipboard.readText())) as {
    tables: { maps: number }[];
    claims: unknown[];
  };
  expect(json.tables.map((one) => one.maps)).toEqual([20, 20, 20, 20, 20, 20]);
  expect(complaints).toEqual([]);
});

test("the range can be chosen and extended, and measuring can be cancelled", async ({ page }) => {
  await open(page);
  await page.keyboard.press("y");
  await measured(page);
  const from = dialog(page).getByLabel("First seed"),
    to = dialog(page).getByLabel("Last seed");
  for (const [first, last] of [
    ["0", "20"],
    ["5", "4"],
    ["1", "201"],
    ["1", ""],
  ] as const) {
    await from.fill(first);
    await to.fill(last);
    await expect(dialog(page).getByRole("alert")).toContainText("whole numbers from 1 to 200");
    await expect(dialog(page).getByRole("button", { name: "Measure" })).toBeDisabled();
  }
  await from.fill("3");
  await to.fill("22");
  await dialog(page).getByRole("button", { name: "Measure" }).click();
  await expect(dialog(page).locator("h3").last()).toContainText("20 maps");
  await measured(page);
  await dialog(page).getByRole("button", { name: "1–200" }).click();
  await dialog(page).getByRole("button", { name: "Cancel" }).click();
  await expect(dialog(page).getByRole("alert")).toContainText("Cancelled");
  await expect(dialog(page).getByRole("button", { name: "Measure" })).toBeEnabled();
  await page.keyboard.press("Escape");
  await page.locator("parkade-toolbar .scene").click();
  await page.getByRole("button", { name: "Paper tables" }).click();
  await expect(dialog(page).locator("h3").first()).toBeVisible();
});

test("the parking paper's tables stand beside ours, and what no car can drive is flagged", async ({ page }) => {
  test.setTimeout(120_000);
  const complaints = complaintsOf(page);
  await open(page);
  await page.keyboard.press("y");
  await dialog(page).getByRole("tab", { name: "Parking" }).click();
  await measured(page);
  await expect(dialog(page).locator("h3")).toHaveText([
    /Claims/,
    /saved/,
    /Searched/,
    /^P0/,
    /^P1/,
    /^P2/,
    /^P3/,
    /^P4/,
    /^L0/,
    /^L1/,
    /^L2/,
    /^L3.*tables 8 to 11/,
    /^L4/,
    /Bounding volumes/,
  ]);
  await expect(dialog(page).locator("td .chip.err")).toHaveText([/below 22\.10/, /below 22\.10/, /below 26\.44/]);
  const nodes = dialog(page)
    .locator("table")
    .nth(5)
    .getByRole("row", { name: /^Nodes/ });
  await expect(nodes.getByRole("cell")).toHaveText(["256", "233", "233", "233", "233", "233"]);
  await expect(dialog(page).getByRole("img", { name: "kept" })).toHaveCount(10);
  const saved = dialog(page).locator(".saved");
  await expect(saved.first().getByRole("row", { name: /^P1–P4/ })).toContainText("8.18 %");
  // The tree from the slot is the smaller one; the counts are the same everywhere.
  await expect(saved.nth(1).getByRole("row", { name: /^L0/ }).getByRole("cell").nth(0)).toHaveText("1571");
  await expect(saved.nth(1).getByRole("row", { name: /^L0/ }).getByRole("cell").nth(1)).toHaveText("26");
  await expect(dialog(page).locator(".claims li")).toHaveCount(5);
  await expect(dialog(page).locator("#K3 .chip")).toContainText("holds");
  const { violations } = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  expect(violations.map((one) => `${one.id} ${one.nodes.map((node) => node.target.join(" ")).join("; ")}`)).toEqual([]);
  await dialog(page).getByRole("button", { name: "Copy as Markdown" }).click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toMatch(
    /\| Length, m \| 26\.7 \| 20\.2 ⚠ below 26\.44 \|/,
  );
  expect(complaints).toEqual([]);
});

test("the road manuscript's tables stand beside ours, with percentages and what cannot be", async ({ page }) => {
  test.setTimeout(180_000);
  const complaints = complaintsOf(page);
  await open(page);
  await page.keyboard.press("y");
  const tab = dialog(page).getByRole("tab", { name: "Grid" });
  await tab.press("ArrowLeft");
  const comparison = dialog(page).getByRole("tab", { name: "Comparison" });
  await expect(comparison).toBeFocused();
  await comparison.press("ArrowLeft");
  await expect(dialog(page).getByRole("tab", { name: "Road" })).toBeFocused();
  await expect(dialog(page).getByRole("progressbar")).toBeVisible();
  await dialog(page).getByRole("button", { name: "Cancel" }).click();
  await expect(dialog(page).getByRole("alert")).toContainText("Cancelled.");
  await dialog(page).getByRole("button", { name: "Measure" }).click();
  await expect(dialog(page).getByRole("button", { name: "Measure" })).toBeVisible({ timeout: 150_000 });
  await expect(dialog(page).locator("h3")).toHaveText([
    /Claims/,
    /^S1/,
    /^S2/,
    /^S3/,
    /^S4/,
    /^S1.*ship/,
    /^S2.*ship/,
    /^S3.*ship/,
    /^S4.*ship/,
    /Contradictions/,
  ]);
  const turns = dialog(page)
    .locator("table")
    .nth(3)
    .getByRole("row", { name: /^Turning points/ });
  await expect(turns.getByRole("cell")).toHaveText(["22", /^9\s*−59 %$/, "21", /^11\s*−48 %/, /^11/, /^4/]);
  await expect(turns.getByRole("img")).toHaveAttribute("aria-label", "Promised: ≤ 11 – kept");
  await expect(
    dialog(page)
      .locator("table")
      .nth(1)
      .getByRole("row", { name: /^Length/ }),
  ).toContainText("impossible");
  await expect(dialog(page).locator("table").nth(2).locator(".chip.err", { hasText: "collides" })).toHaveCount(2);
  await expect(dialog(page).locator(".flags li")).toHaveCount(11);
  const { violations } = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  expect(violations.map((one) => `${one.id} ${one.nodes.map((node) => node.target.join(" ")).join("; ")}`)).toEqual([]);
  await dialog(page).getByRole("button", { name: "Copy as Markdown" }).click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toMatch(
    /\| Turning points \| 22\.0 \| 9\.0 −59 % \| 21 \| 11 −48 %/,
  );
  // The ship's rows have their scenes, too.
  await expect(dialog(page).locator("parkade-paper-picture")).toHaveCount(16);
  await dialog(page).locator("#S2-ship").getByRole("button", { name: "Open the scene" }).click();
  await expect(page.locator("parkade-toolbar .scene")).toContainText("road-curve-ship");
  expect(complaints).toEqual([]);
});

test("a row opens its scene, and its paths are drawn beside it", async ({ page }) => {
  test.setTimeout(120_000);
  await open(page);
  await page.keyboard.press("y");
  await dialog(page).getByRole("tab", { name: "Parking" }).click();
  await measured(page);
  // Two planners on each of ten rows, and on the scenes of figures 12 and 13.
  await expect(dialog(page).locator("parkade-paper-picture")).toHaveCount(24);
  await expect(dialog(page).locator("parkade-papers-volumes tbody tr")).toHaveCount(9, { timeout: 60_000 });
  await dialog(page).locator("#L2").getByRole("button", { name: "Open the scene" }).click();
  await expect(dialog(page)).toBeHidden();
  await expect(page.locator("parkade-toolbar .scene")).toContainText("L2");
  // So do the rows of what both ends search, and those of the volumes.
  for (const [place, name] of [
    [".saved", "P4"],
    ["parkade-papers-volumes", "park-fig13"],
  ] as const) {
    await page.keyboard.press("y");
    await dialog(page).locator(place).getByRole("button", { name, exact: true }).first().click();
    await expect(dialog(page)).toBeHidden();
  }
  await expect(page.locator("parkade-toolbar .scene")).toContainText("13");
});

test("the comparison with other algorithms is measured, drawn and judged", async ({ page }) => {
  test.setTimeout(240_000);
  const complaints = complaintsOf(page);
  await open(page);
  await page.keyboard.press("y");
  await dialog(page).getByRole("tab", { name: "Comparison" }).click();
  await expect(dialog(page).getByRole("progressbar")).toBeVisible({ timeout: 30_000 });
  await expect(dialog(page).getByRole("button", { name: "Measure" })).toBeVisible({ timeout: 200_000 });
  await expect(dialog(page).locator(".claims li")).toHaveCount(3);
  await expect(dialog(page).locator("table.compared tbody tr")).toHaveCount(36);
  const dijkstra = dialog(page).locator("table.compared tbody tr", { hasText: "Dijkstra" });
  await expect(dijkstra).toHaveCount(6);
  // Eight settings by five figures, and the band on three roads.
  await expect(dialog(page).locator(".charts").first().locator("svg > g")).toHaveCount(40);
  await expect(dialog(page).locator(".charts svg")).toHaveCount(4);
  const { violations } = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  expect(violations.map((one) => `${one.id} ${one.nodes.map((node) => node.target.join(" ")).join("; ")}`)).toEqual([]);
  await dialog(page).getByRole("button", { name: "Copy as Markdown" }).click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toMatch(/\| road-narrow \| RRT \| \d \/ 5 \|/);
  await dialog(page).locator("table.compared").getByRole("button", { name: "road-narrow" }).first().click();
  await expect(dialog(page)).toBeHidden();
  expect(complaints).toEqual([]);
});
