import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, open, sceneOf, settled, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

type Named = [name: string, text: string | Buffer];

const files = (...named: Named[]) =>
  named.map(([name, text]) => ({ name, mimeType: "application/octet-stream", buffer: Buffer.from(text as string) }));

async function choose(page: Page, ...named: Named[]): Promise<void> {
  await page.locator("parkade-playground input[type=file]").setInputFiles(files(...named));
}

const room = (n: number): string => {
  const rows = Array.from({ length: n }, (_, y) =>
    Array.from({ length: n }, (_, x) => (y === n >> 1 && x < n - 4 ? "@" : ".")).join(""),
  );
  return `type octile\nheight ${n}\nwidth ${n}\nmap\n${rows.join("\n")}\n`;
};

const questions = (n: number): string =>
  [
    "version 1",
    ...[
      [0, 4],
      [1, 8],
      [2, 14],
    ].map(([bucket, x]) => [bucket, "room.map", n, n, 2, 2, 2 + x!, 2, x].join("\t")),
  ].join("\n");

test("a map with its questions opens, and another question sets start and goal", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await choose(page, ["room.map", room(24)], ["room.map.scen", questions(24)]);
  await expect(page.locator("parkade-notices .notice")).toContainText("24 × 24 cells of 1 m");
  await settled(page);
  const bar = page.locator("parkade-import .bar");
  await expect(bar).toContainText("of 3");
  const before = await sceneOf(page);
  await bar.getByRole("button", { name: "Next" }).click();
  await settled(page);
  const { start, goal } = await sceneOf(page);
  expect(start).toMatchObject({ x: 2, y: 21 });
  expect(goal).toMatchObject({ x: 16, y: 21 });
  await bar.getByRole("combobox").selectOption({ index: 0 });
  expect((await sceneOf(page)).goal).toMatchObject({ x: 6 });
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await settled(page);
  expect(await sceneOf(page)).toEqual(before);
  await page.keyboard.press("Control+z");
  await expect(bar).toHaveCount(0);
  expect(complaints).toEqual([]);
});

test("a ROS map and a parking case open by dropping them", async ({ page }) => {
  await open(page);
  const pgm = Buffer.concat([Buffer.from("P5\n40 30\n255\n"), Buffer.alloc(1200, 254)]);
  pgm.fill(0, pgm.length - 40);
  const drop = (named: [string, number[]][]) =>
    page.evaluate((list) => {
      const data = new DataTransfer();
      for (const [name, bytes] of list) data.items.add(new File([new Uint8Array(bytes)], name));
      const target = document.querySelector("parkade-playground")!.shadowRoot!.querySelector(".layout-wide")!;
      target.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    }, named);
  await drop([
    [
      "floor.yaml",
      [
        ...Buffer.from(
          "image: floor.pgm\nresolution: 0.5\norigin: [-10.0, -5.0, 0.0]\nnegate: 0\noccupied_thresh: " +
            "0.65\nfree_thresh: 0.196\n",
        ),
      ],
    ],
    ["floor.pgm", [...pgm]],
  ]);
  await expect(page.locator("parkade-notices .notice.info")).toContainText("40 × 30 cells of 0.5 m");
  expect((await sceneOf(page)).map).toMatchObject({ origin: [-10, -5], width: 40, height: 30, resolution: 0.5 });
  const { obstacles, map } = await sceneOf(page);
  const png = (clear: boolean): Promise<number[]> =>
    page.evaluate(async (clear) => {
      const canvas = new OffscreenCanvas(40, 30),
        ctx = canvas.getContext("2d")!;
      for (const [light, y, rows] of [
        [254, 0, 29],
        [0, 29, 1],
      ] as const) {
        ctx.fillStyle = `rgb(${light} ${light} ${light})`;
        ctx.fillRect(0, y, clear ? 20 : 40, rows);
      }
      return [...new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())];
    }, clear);
  const yaml = [
    ...Buffer.from(
      "image: yard.png\nresolution: 0.5\norigin: [-10.0, -5.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: " +
        "0.196\n",
    ),
  ];
  await drop([
    ["yard.yaml", yaml],
    ["yard.png", await png(false)],
  ]);
  await expect(page.locator("parkade-notices .notice.info")).toContainText("Opened yard.yaml, yard.png");
  expect(await sceneOf(page)).toMatchObject({ name: "yard", obstacles, map });
  await drop([
    ["yard.yaml", yaml],
    ["yard.png", await png(true)],
  ]);
  await expect(page.locator("parkade-notices .notice.err")).toContainText("yard.png has transparent pixels");
  expect((await sceneOf(page)).name).toBe("yard");
  const tpcap = [-8, 2, 0, 8, 2, 0, 1, 4, -2, -8, 2, -8, 2, -3, -2, -3];
  await drop([["Case.csv", [...Buffer.from(tpcap.join(","))]]]);
  await expect(page.locator("parkade-notices .notice.info")).toContainText("Opened Case.csv");
  expect((await sceneOf(page)).obstacles?.map((one) => one.type)).toEqual(["polygon"]);
});

test("a bad file says its line, and the scene stays", async ({ page }) => {
  await open(page);
  const before = await sceneOf(page);
  const lines = room(12).split("\n");
  lines[7] = "...";
  await choose(page, ["room.map", lines.join("\n")]);
  await expect(page.locator("parkade-notices .notice.err")).toContainText(
    "room.map could not be read. Line 8: must have 12 characters, got 3. Your scene is unchanged.",
  );
  await choose(page, ["notes.txt", "hello"]);
  await expect(page.locator("parkade-notices .notice.err")).toContainText("notes.txt");
  await page.locator("parkade-playground").evaluate((playground) => playground.setAttribute("lang", "zh"));
  await expect(page.getByRole("toolbar", { name: "场景与工具" })).toBeVisible();
  await choose(page, ["room.map", lines.join("\n")]);
  await expect(page.locator("parkade-notices .notice.err")).toContainText("第 8 行");
  expect(await sceneOf(page)).toEqual(before);
});

/** Milliseconds that half of the frames take at most while the view moves, near and far. */
const frameOf = (page: Page): Promise<number> =>
  page.evaluate(async () => {
    const { store } = document.querySelector<PlaygroundElement>("parkade-playground")!;
    const times: number[] = [];
    for (const scale of [0.3, 1, 8]) {
      for (let i = 0; i < 10; i++) {
        store.set({ camera: { x: 200 + i, y: 1800 + i, scale } });
        await new Promise(requestAnimationFrame);
        const from = performance.now();
        await new Promise((done) => setTimeout(done));
        times.push(performance.now() - from);
      }
    }
    return times.sort((a, b) => a - b)[times.length >> 1]!;
  });

test("a map of 2048 × 2048 cells opens, moves smoothly, takes a brush stroke and is too long for a link", async ({
  page,
}) => {
  test.slow();
  const complaints = complaintsOf(page);
  await open(page);
  await settled(page);
  const small = await frameOf(page);
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ camera: null }),
  );
  const n = 2048;
  let seed = 1;
  const random = (): number => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const rows = Array.from({ length: n }, (_, y) =>
    Array.from({ length: n }, (_, x) => (Math.abs(x - y) > 6 && random() < 0.2 ? "@" : ".")).join(""),
  );
  const scen = `version 1\n0\tbig.map\t${n}\t${n}\t10\t10\t400\t400\t551.5433`;
  const hash = new URL(page.url()).hash;
  await choose(
    page,
    ["big.map", `type octile\nheight ${n}\nwidth ${n}\nmap\n${rows.join("\n")}\n`],
    ["big.map.scen", scen],
  );
  await expect(page.locator("parkade-notices .notice.info")).toContainText("2048 × 2048", { timeout: 30_000 });
  await settled(page);
  const runs = (): Promise<number> =>
    page.evaluate(() => {
      const { obstacles = [] } = document.querySelector<PlaygroundElement>("parkade-playground")!.sceneData;
      return obstacles.reduce((sum, one) => sum + (one.type === "cells" ? one.runs.length : 0), 0);
    });
  const opened = await runs();
  expect(opened).toBeGreaterThan(500_000);
  // On a busy machine every frame takes long: those of a small scene say how long. It may have become busy since.
  await expect.poll(() => frameOf(page), { timeout: 30_000 }).toBeLessThan(3 * small + 20);
  await page.evaluate(() =>
    document
      .querySelector<PlaygroundElement>("parkade-playground")!
      .store.set({ camera: { x: 1000.5, y: 800.5, scale: 20 }, tool: "brush" }),
  );
  await page.mouse.move(250, 200);
  await page.mouse.down();
  await page.mouse.move(350, 220, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  await page.waitForTimeout(700);
  expect(new URL(page.url()).hash).toBe(hash);
  expect(await runs()).not.toBe(opened);
  await page.keyboard.press("Control+z");
  expect(await runs()).toBe(opened);
  expect(complaints).toEqual([]);
});
