// Pictures of docs/lots.md: a plan is opened, its bays are checked, a column is moved, the report is printed.
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL("../../docs/public/lots/", import.meta.url));
const SIZE = { width: 1400, height: 860 };

/** Two rows of nine bays, 2.5 × 5 m, at an aisle of 6 m, in metres, by layers. */
const BAYS = Array.from({ length: 18 }, (_, i) => box(4 + 2.5 * (i % 9), i < 9 ? 0 : 11, 2.5, 5));
const PLAN = [
  ["WALLS", box(0, 0, 30.5, 16)],
  ...BAYS.map((bay) => ["BAYS", bay]),
  ["COLUMNS", box(27.5, 7.8, 0.4, 0.4)],
];

function box(x, y, width, height) {
  return [
    [x, y],
    [x + width, y],
    [x + width, y + height],
    [x, y + height],
  ];
}

function dxf() {
  const outline = ([layer, points]) => [
    0,
    "LWPOLYLINE",
    8,
    layer,
    90,
    4,
    70,
    1,
    ...points.flatMap(([x, y]) => [10, x, 20, y]),
  ];
  const header = [0, "SECTION", 2, "HEADER", 9, "$INSUNITS", 70, 6, 0, "ENDSEC"];
  const entities = [0, "SECTION", 2, "ENTITIES", ...PLAN.flatMap(outline), 0, "ENDSEC", 0, "EOF"];
  return [...header, ...entities].join("\n");
}

/** Photographs the steps of a check of all bays, in order, on one page. */
export async function photographLots(browser, url) {
  const page = await browser.newPage({ viewport: SIZE, colorScheme: "light", reducedMotion: "reduce" });
  const shoot = async (name) => {
    await page.mouse.move(0, 0);
    await page.screenshot({ path: `${FOLDER}${name}.png` });
    console.log(`${FOLDER}${name}.png`);
  };
  await page.goto(url);
  await page.evaluate(() => document.querySelector("parkade-playground").settled());
  await page
    .locator("parkade-playground input[type=file]")
    .setInputFiles([{ name: "lot.dxf", mimeType: "application/dxf", buffer: Buffer.from(dxf()) }]);
  const dialog = page.locator("parkade-site-plan dialog[open]");
  await dialog.getByRole("combobox").first().waitFor();
  await shoot("plan");
  await dialog.getByRole("button", { name: "Open", exact: true }).click();
  await page.evaluate(() => document.querySelector("parkade-playground").settled());
  await page.getByRole("button", { name: "Check all bays" }).click();
  await page.waitForFunction(isChecked);
  // Nobody who reads of bays needs the hints of a first visit.
  const hint = page.locator("parkade-hints button");
  if (await hint.isVisible()) await hint.click();
  await shoot("bays");
  await page.evaluate(moveColumn);
  await page.waitForFunction(isChecked);
  await shoot("column");
  const [report] = await Promise.all([
    page.waitForEvent("download"),
    page.locator("parkade-bays").getByRole("button", { name: "Report" }).click(),
  ]);
  await page.setContent(await readFile(await report.path(), "utf8"));
  await page.setViewportSize({ width: 1123, height: 794 });
  await shoot("report");
  await page.close();
}

/** Runs in the page: every bay has its answer. */
function isChecked() {
  const { bays } = document.querySelector("parkade-playground").store.state;
  return bays && bays.of > 0 && bays.done === bays.of;
}

/** Runs in the page: the column at the end of the aisle moves in front of the bays in the middle. */
function moveColumn() {
  const { store } = document.querySelector("parkade-playground"),
    { scene } = store.state;
  const moved = (one) => ({ ...one, points: one.points.map(([x, y]) => [x - 13, y + 1.5]) });
  const obstacles = scene.obstacles.map((one) => (one.type === "polygon" ? moved(one) : one));
  store.edit({ ...scene, obstacles });
}
