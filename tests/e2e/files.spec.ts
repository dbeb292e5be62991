import { readFile } from "node:fs/promises";
import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, hashesOf, open, sceneOf, settled, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

async function exported(page: Page, item: string): Promise<{ name: string; bytes: Buffer }> {
  await page.getByRole("button", { name: "Export" }).click();
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: item }).click()]);
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

test("the path is saved as a table of its poses", async ({ page }) => {
  await open(page);
  // A trajectory's path has other poses than the plan.
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ smooth: false }),
  );
  // A better path may come in between.
  await expect(async () => {
    const { name, bytes } = await exported(page, "CSV path");
    expect(name).toMatch(/-hybrid\.csv$/);
    const [head, ...rows] = bytes.toString().trim().split("\n");
    expect(head).toBe("s,x,y,theta,kappa,clearance,v,direction,t");
    const plan = await page.evaluate(() => {
      const { path, metrics } = document.querySelector<PlaygroundElement>("parkade-playground")!.results["hybrid"]!;
      return { poses: path.length / 3, length: metrics.length };
    });
    expect(rows).toHaveLength(plan.poses);
    expect(Number(rows.at(-1)!.split(",")[0])).toBeCloseTo(plan.length, 1);
  }).toPass({ timeout: 20_000 });
});

test("pictures come at one and two pixels for each on the screen", async ({ page }) => {
  await open(page);
  const width = ({ bytes }: { bytes: Buffer }): number => bytes.readUInt32BE(16);
  const one = await exported(page, "PNG image, 1×"),
    two = await exported(page, "PNG image, 2×");
  expect(width(two)).toBe(2 * width(one));
});

test("a saved drawing opens again as the scene it shows", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  const before = await sceneOf(page),
    hashes = await hashesOf(page);
  const { name, bytes } = await exported(page, "SVG drawing (can be reopened)");
  expect(name).toMatch(/\.svg$/);
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = { ...element.sceneData, slots: [], obstacles: [], goal: { x: 20, y: 20, heading: 0 } };
  });
  await settled(page);
  await page
    .locator("parkade-playground input[type=file]")
    .setInputFiles({ name, mimeType: "image/svg+xml", buffer: bytes });
  await expect(page.locator("parkade-notices .notice.info")).toContainText("Opened");
  await settled(page);
  expect(await sceneOf(page)).toEqual(before);
  expect(await hashesOf(page)).toEqual(hashes);
  await page.locator("parkade-playground input[type=file]").setInputFiles({
    name: "other.svg",
    mimeType: "image/svg+xml",
    buffer: Buffer.from("<svg xmlns='http://www.w3.org/2000/svg'/>"),
  });
  await expect(page.locator("parkade-notices .notice.err")).toContainText("holds no lines that can be read");
  expect(complaints).toEqual([]);
});

test("a picture becomes a map by threshold and scale", async ({ page }) => {
  await open(page);
  // 60 × 40 pixels: white, a black wall from below with a grey one beside it.
  const png = await page.evaluate(() => {
    const canvas = document.createElement("canvas");
    canvas.width = 60;
    canvas.height = 40;
    const ctx = canvas.getContext("2d")!;
    for (const [colour, ...box] of [
      ["#fff", 0, 0, 60, 40],
      ["#000", 28, 10, 3, 30],
      ["#999", 44, 0, 3, 30],
    ] as [string, number, number, number, number][]) {
      ctx.fillStyle = colour;
      ctx.fillRect(...box);
    }
    return canvas.toDataURL("image/png").split(",")[1]!;
  });
  const before = await sceneOf(page),
    input = page.locator("parkade-playground input[type=file]");
  await input.setInputFiles({ name: "lot.png", mimeType: "image/png", buffer: Buffer.from(png, "base64") });
  const dialog = page.locator("parkade-image dialog");
  await expect(dialog).toContainText("60 × 40 cells");
  await dialog.getByLabel("Metres per pixel").fill("0.5");
  await expect(dialog).toContainText("30.0 × 20.0 m, 4 % wall");
  await dialog.getByRole("slider").fill("200");
  await expect(dialog).toContainText("8 % wall");
  await dialog.getByRole("button", { name: "Open" }).click();
  await expect.poll(async () => (await sceneOf(page)).map).toMatchObject({ width: 60, height: 40, resolution: 0.5 });
  const { obstacles } = await sceneOf(page);
  expect((obstacles![0] as { runs: number[][] }).runs.reduce((sum, run) => sum + run[2]!, 0)).toBe(180);
  await page.keyboard.press("Control+z");
  expect(await sceneOf(page)).toEqual(before);
  await input.setInputFiles({ name: "broken.png", mimeType: "image/png", buffer: Buffer.from("nothing") });
  await expect(page.locator("parkade-notices .notice.err")).toContainText("broken.png could not be read as an image");
});

test("a drawing is offered again after its tab is closed, and each open tab keeps its own", async ({
  context,
  baseURL,
}) => {
  const visit = async (): Promise<Page> => {
    const page = await context.newPage();
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.goto(baseURL!);
    await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
    return page;
  };
  const draw = async (page: Page, x: number): Promise<void> => {
    await page.waitForFunction(() => sessionStorage.getItem("parkade.tab") !== null);
    await page.evaluate((at) => {
      const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
      element.sceneData = { ...element.sceneData, start: { ...element.sceneData.start, x: at } };
    }, x);
    await page.waitForFunction(
      (at) =>
        Object.keys(localStorage).some(
          (key) => key.startsWith("parkade.tab.") && localStorage.getItem(key)!.includes(`"x":${at},`),
        ),
      x,
    );
  };
  const first = await visit();
  await draw(first, 17.25);
  const second = await visit();
  await second.waitForFunction(() => sessionStorage.getItem("parkade.tab") !== null);
  await expect(second.locator("parkade-notices .notice")).toHaveCount(0);
  await draw(second, 16.75);
  await Promise.all([first.waitForEvent("close"), first.close({ runBeforeUnload: true })]);
  await second.waitForFunction(async () => {
    const { held = [] } = await navigator.locks.query();
    return held.filter(({ name }) => name?.startsWith("parkade.tab.")).length === 1;
  });
  const third = await visit();
  await third.getByRole("button", { name: "Restore" }).click();
  expect((await sceneOf(third)).start.x).toBe(17.25);
  await third.close();
  await second.close();
});
