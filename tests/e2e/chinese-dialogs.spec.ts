/** No English in any dialog of the Chinese page, nor in the panels that stand in its place. */
import { readdirSync, readFileSync } from "node:fs";
import { expect, test, type Page } from "@playwright/test";
import { expectChinese, keepDrawn, set } from "./chinese";
import { open, settled } from "./playground";
import { FILES } from "../js/site-plan-files.js";

test.use({ locale: "zh-CN", viewport: { width: 1400, height: 900 } });
test.beforeEach(({ page }) => keepDrawn(page));

const scenes = (page: Page) => page.locator("parkade-toolbar .scene").click();

async function fromMenu(page: Page, menu: string, entry: string): Promise<void> {
  await page.locator("parkade-toolbar").getByRole("button", { name: menu, exact: true }).first().click();
  await page.locator("parkade-toolbar .popover .item", { hasText: entry }).first().click();
}

async function choose(page: Page, name: string, text: string | Buffer): Promise<void> {
  const buffer = Buffer.from(text as string);
  await page
    .locator("parkade-playground input[type=file]")
    .setInputFiles([{ name, mimeType: "application/octet-stream", buffer }]);
}

/** A square of one colour. */
const PICTURE = Buffer.from(
  "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mNk+A8AAQUBAScY42YAAAAASUVORK5CYII=",
  "base64",
);

/** The site plan as a Chinese office names its layers. */
const PLAN = ["WALLS", "BAYS", "COLUMNS", "KERB"].reduce(
  (text, name, i) => text.replaceAll(name, ["墙", "车位", "柱", "路缘"][i]!),
  String(FILES["lot.dxf"]),
);

/** How each dialog is opened, by its class. */
const DIALOGS: Record<string, [element: string, open: (page: Page) => Promise<void>]> = {
  KeysDialog: ["parkade-keys", (page) => page.keyboard.press("Shift+Slash")],
  Presets: ["parkade-presets", scenes],
  PapersDialog: ["parkade-papers", (page) => page.keyboard.press("y")],
  NewLot: ["parkade-new-lot", (page) => fromMenu(page, "导出", "新建停车场")],
  MovieDialog: ["parkade-movie", (page) => fromMenu(page, "导出", "动态图片…")],
  SheetDialog: ["parkade-sheet-dialog", (page) => fromMenu(page, "导出", "按比例出图、DXF…")],
  TaskDialog: ["parkade-task-dialog", (page) => fromMenu(page, "导出", "学生任务…")],
  VehicleEditor: ["parkade-vehicle-editor", (page) => page.locator("parkade-vehicle .edit").click()],
  SitePlanDialog: ["parkade-site-plan", (page) => choose(page, "lot.dxf", PLAN)],
  ImageDialog: ["parkade-image", (page) => choose(page, "lot.png", PICTURE)],
};

test("each dialog of the page is looked at", () => {
  const folder = new URL("../../www/src/panels/", import.meta.url),
    classes = readdirSync(folder).flatMap((name) =>
      [...readFileSync(new URL(name, folder), "utf8").matchAll(/class (\w+) extends DialogElement/g)].map(
        ([, one]) => one!,
      ),
    );
  expect(Object.keys(DIALOGS).sort()).toEqual(classes.sort());
});

test("each Chinese dialog is Chinese", async ({ page }) => {
  test.setTimeout(180_000);
  await open(page);
  await settled(page);
  for (const [name, [element, show]] of Object.entries(DIALOGS))
    await test.step(name, async () => {
      await show(page);
      const dialog = page.locator(`${element} dialog[open]`);
      await expect(dialog).toBeVisible({ timeout: 15_000 });
      await expect(dialog.getByRole("progressbar")).toHaveCount(0, { timeout: 60_000 });
      await expectChinese(page, name);
      await page.keyboard.press("Escape");
      await expect(dialog).toHaveCount(0);
    });
});

test("the Chinese page is Chinese: all bays and the search debugger", async ({ page }) => {
  await open(page, "#scene=lot");
  await settled(page);
  await fromMenu(page, "导出", "检查全部车位");
  const bays = page.locator("parkade-bays");
  await expect(bays.locator(".summary")).toBeVisible({ timeout: 30_000 });
  await expectChinese(page, "bays");
  await page.keyboard.press("Escape");
  for (const focus of ["eight", "hybrid", "risk-field"]) {
    await set(page, { planners: ["four", focus], focus });
    await settled(page);
    await fromMenu(page, "图层", "搜索调试器");
    const steps = page.locator("parkade-debugger");
    await expect(steps.locator(".event")).toBeVisible({ timeout: 15_000 });
    await expectChinese(page, `${focus}, before the first step`);
    await page.keyboard.press("ArrowRight");
    await expectChinese(page, `${focus}, at a step`);
    await fromMenu(page, "图层", "搜索调试器");
    await expect(steps).toHaveCount(0);
  }
});
