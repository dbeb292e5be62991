import { expect, test, type Page } from "@playwright/test";
import type { Scenario } from "parkade";
import { FILES } from "../js/site-plan-files.js";
import { complaintsOf, open, sceneOf, settled } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

async function drop(page: Page, name: string, text: string | Buffer): Promise<void> {
  await page
    .locator("parkade-playground input[type=file]")
    .setInputFiles([{ name, mimeType: "application/octet-stream", buffer: Buffer.from(text as string) }]);
}

const dialogOf = (page: Page) => page.locator("parkade-site-plan dialog[open]");

for (const [name, text] of Object.entries(FILES))
  test(`a site plan opens by its layers: ${name}`, async ({ page }) => {
    const complaints = complaintsOf(page);
    await open(page);
    await drop(page, name, text);
    const dialog = dialogOf(page);
    await expect(dialog.getByRole("combobox")).toHaveCount(4, { timeout: 15_000 });
    if (name.endsWith(".svg")) await dialog.getByRole("spinbutton", { name: "One unit of the file" }).fill("0.1");
    if (name.endsWith(".svg")) await dialog.getByRole("spinbutton", { name: "One unit of the file" }).press("Tab");
    await expect(dialog).toContainText("10 bays, 1 wall, 1 kerb");
    await dialog.getByRole("button", { name: "Open", exact: true }).click();
    await expect.poll(async () => (await sceneOf(page)).slots?.length).toBe(10);
    expect(complaints).toEqual([]);
  });

test("a layer that is left out is not in the scene", async ({ page }) => {
  await open(page);
  await drop(page, "lot.dxf", FILES["lot.dxf"]!);
  await dialogOf(page).getByRole("combobox", { name: "COLUMNS" }).selectOption("none");
  await expect(dialogOf(page)).toContainText("0 columns");
  await dialogOf(page).getByRole("button", { name: "Open", exact: true }).click();
  await expect.poll(async () => (await sceneOf(page)).obstacles!.map(({ id }) => id)).toEqual(["wall-1", "kerb-1"]);
});

test("damaged site plans are refused in words, and the drawing stays", async ({ page }) => {
  await open(page);
  const before = await sceneOf(page);
  for (const [name, text] of Object.entries(FILES)) {
    await drop(page, name, text.slice(0, Math.floor(text.length * 0.7)));
    const notice = page.locator("parkade-notices .notice.err");
    await expect(notice).toContainText(`${name} could not be read`);
    await expect(notice).toContainText("Your scene is unchanged.");
    expect(await sceneOf(page)).toEqual(before);
  }
});

test("a newcomer's path: plan, bays, column, report", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await drop(page, "lot.dxf", FILES["lot.dxf"]!);
  await dialogOf(page).getByRole("button", { name: "Open", exact: true }).click();
  await settled(page);
  await page.getByRole("button", { name: "Check all bays" }).click();
  const panel = page.locator("parkade-bays");
  await expect(panel.locator(".summary")).toContainText("10 of 10 reachable");
  await expect(panel.locator("tbody tr")).toHaveCount(10);
  const checked = () =>
    page.waitForFunction(() => {
      const { bays } = document.querySelector<
        HTMLElement & { store: { state: { bays?: { done: number; of: number } } } }
      >("parkade-playground")!.store.state;
      return bays && bays.of > 0 && bays.done === bays.of;
    });
  await checked();
  const movesOf = () => panel.locator("tbody td:nth-child(2)").allTextContents();
  await panel.getByRole("button", { name: "Bay", exact: true }).click();
  const before = await movesOf();
  // The column in the middle of the aisle.
  await page.evaluate(() => {
    interface Editable extends HTMLElement {
      store: { state: { scene: Scenario }; edit(scene: Scenario): void };
    }
    const { store } = document.querySelector<Editable>("parkade-playground")!,
      { scene } = store.state;
    const obstacles = scene.obstacles!.map((one) =>
      one.type === "polygon" ? { ...one, points: one.points.map(([x, y]): [number, number] => [x - 8, y + 2]) } : one,
    );
    store.edit({ ...scene, obstacles });
  });
  await checked();
  await expect.poll(movesOf).not.toEqual(before);
  const [report] = await Promise.all([
    page.waitForEvent("download"),
    panel.getByRole("button", { name: "Report" }).click(),
  ]);
  expect(report.suggestedFilename()).toBe("lot-bays.html");
  await panel.locator("tbody tr").first().click();
  await settled(page);
  await panel.getByRole("button", { name: "Back to all bays" }).click();
  await expect(panel.locator("tbody tr")).toHaveCount(10);
  await panel.getByRole("button", { name: "Close" }).click();
  await expect(panel.locator("tbody")).toHaveCount(0);
  expect(complaints).toEqual([]);
});

test("a drawing to scale is saved as SVG, page, DXF and CSV", async ({ page }) => {
  await open(page);
  await settled(page);
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Drawing to scale, DXF…" }).click();
  const dialog = page.locator("parkade-sheet-dialog dialog[open]");
  await expect(dialog.locator(".sheet svg")).toBeVisible();
  for (const [button, end] of [
    ["Page to print", ".html"],
    ["SVG", ".svg"],
    ["DXF", ".dxf"],
    ["CSV of the way", "-way.csv"],
  ] as const) {
    const [file] = await Promise.all([
      page.waitForEvent("download"),
      dialog.getByRole("button", { name: button, exact: true }).click(),
    ]);
    expect(file.suggestedFilename().endsWith(end), button).toBe(true);
  }
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 } });

  test("the whole lot stands above the table of bays", async ({ page }) => {
    await open(page);
    await drop(page, "lot.dxf", FILES["lot.dxf"]!);
    await dialogOf(page).getByRole("button", { name: "Open", exact: true }).click();
    await settled(page);
    await page.getByRole("button", { name: "More" }).click();
    await page.getByText("Check all bays").click();
    await expect(page.locator("parkade-bays .summary")).toContainText("reachable");
    const { map, panel, lot } = await page.evaluate(() => {
      interface Viewed extends HTMLElement {
        store: { state: { camera: { x: number; y: number; scale: number }; scene: Scenario } };
      }
      const host = document.querySelector<Viewed>("parkade-playground")!,
        { camera, scene } = host.store.state,
        map = host.shadowRoot!.querySelector("parkade-stage")!.getBoundingClientRect(),
        panel = host.shadowRoot!.querySelector("parkade-bays")!.getBoundingClientRect(),
        { origin, width, height, resolution } = scene.map,
        [left, bottom] = origin!;
      const across = (x: number): number => map.left + map.width / 2 + (x - camera.x) * camera.scale,
        up = (y: number): number => map.top + map.height / 2 - (y - camera.y) * camera.scale;
      const lot = {
        left: across(left),
        right: across(left + width * resolution!),
        top: up(bottom + height * resolution!),
        bottom: up(bottom),
      };
      return { map: map.toJSON() as DOMRect, panel: panel.toJSON() as DOMRect, lot };
    });
    expect(lot.left).toBeGreaterThanOrEqual(map.left);
    expect(lot.right).toBeLessThanOrEqual(map.right);
    expect(lot.top).toBeGreaterThanOrEqual(map.top);
    expect(lot.bottom).toBeLessThanOrEqual(panel.top);
    expect(lot.right - lot.left > map.width / 2 || lot.bottom - lot.top > (panel.top - map.top) / 2).toBe(true);
  });
});
