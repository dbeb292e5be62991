import { expect, test } from "@playwright/test";
import { NAMES, english, expectChinese, keepDrawn, set, textsOf, type Inside } from "./chinese";
import { answered, open, sceneOf, settled, type PlaygroundElement } from "./playground";

test.use({ locale: "zh-CN" });

test.beforeEach(({ page }) => keepDrawn(page));

test("the Chinese page is Chinese: tools, layouts, layers, settings and menus", async ({ page }) => {
  test.setTimeout(120_000);
  await open(page);
  await settled(page);
  // The Chinese texts are a file of their own, which may come after the first plans.
  await expect.poll(async () => english(await textsOf(page))).toEqual([]);
  await expectChinese(page, "first picture");
  for (const mode of ["overlay", "focus", "grid"]) {
    await set(page, { mode });
    await expectChinese(page, mode);
  }
  for (const tool of [
    "brush",
    "cost",
    "wall",
    "rectangle",
    "polygon",
    "car",
    "slot",
    "moving",
    "road",
    "eraser",
    "hand",
    "select",
  ]) {
    await set(page, { tool });
    await expectChinese(page, tool);
  }
  const scene = await sceneOf(page);
  for (const selection of [
    { kind: "start" },
    { kind: "goal" },
    { kind: "slot", id: scene.slots![0]!.id },
    ...scene.obstacles!.map(({ id }) => ({ kind: "obstacle", id })),
  ]) {
    await set(page, { selection });
    await expectChinese(page, JSON.stringify(selection));
  }
  await set(page, { selection: null });
  for (const name of ["规划器", "图层", "导出"]) {
    await page.locator("parkade-toolbar").getByRole("button", { name, exact: true }).first().click();
    await expectChinese(page, name);
    await page.keyboard.press("Escape");
  }
  await page.keyboard.press("Shift+Slash");
  await expectChinese(page, "keyboard shortcuts");
});

test("the Chinese page is Chinese: gallery and paper tables", async ({ page }) => {
  test.setTimeout(120_000);
  await open(page);
  await page.locator("parkade-toolbar .scene").click();
  const gallery = page.locator("parkade-presets dialog");
  await expect(gallery).toBeVisible();
  for (const group of await gallery.locator(".groups button").all()) {
    await group.click();
    // biome-ignore lint/performance/useDomNodeTextContent: only what is shown counts
    await expectChinese(page, await group.innerText());
  }
});

test("the Chinese page is Chinese: a new lot, block by block", async ({ page }) => {
  await open(page);
  await page.locator("parkade-toolbar .scene").click();
  await page.getByRole("button", { name: "新建停车场" }).click();
  const form = page.locator("parkade-new-lot dialog");
  await expect(form.getByRole("status")).toHaveText(/^驶入 1 号车位/);
  for (const block of ["场地", "车位", "障碍", "车辆"]) {
    const head = form.locator(".head", { hasText: block }).first();
    if ((await head.getAttribute("aria-expanded")) !== "true") await head.click();
    await expectChinese(page, block);
  }
  await form.getByRole("button", { name: "自定" }).click();
  await form.getByRole("textbox", { name: "轴距" }).fill("9");
  await expect(form.getByRole("status")).toHaveText("轴距须小于车长 4.7 m。");
  await expectChinese(page, "refused");
});

test("the Chinese page is Chinese: every scene, with its failures and waits", async ({ page }) => {
  test.setTimeout(180_000);
  await open(page);
  const ids = await page.evaluate(async () => {
    const { app } = document.querySelector<Inside>("parkade-playground")!;
    await app.complete();
    return app.catalog.scenarios.map(({ id }) => id);
  });
  for (const id of ids) {
    await page.evaluate((one) => document.querySelector<Inside>("parkade-playground")!.app.openPreset(one), id);
    await answered(page);
    await expectChinese(page, id);
  }
});

test("the Chinese page is Chinese: layers, cars' labels, the menu under the pointer, the ground, planners", async ({
  page,
}) => {
  test.setTimeout(120_000);
  await open(page);
  const planners = await page.evaluate(async () => {
    const { app } = document.querySelector<Inside>("parkade-playground")!;
    await app.complete();
    return app.catalog.planners.map(({ id }) => id);
  });
  for (const focus of planners) {
    await set(page, { planners: [focus, "four"], focus });
    await answered(page);
    for (const button of await page.locator("parkade-inspector").getByRole("button", { name: "更多设置" }).all())
      await button.click();
    await expectChinese(page, focus);
  }
  await set(page, { planners: ["four", "risk-field", "hybrid", "cost-map"], focus: "hybrid" });
  for (const key of [".", ".", ".", "."]) {
    await page.keyboard.press(key);
    await settled(page);
    await expectChinese(page, "layers");
  }
  const canvas = page.locator("parkade-panel[active] canvas").first(),
    box = (await canvas.boundingBox())!;
  for (const [x, y] of [
    [0.5, 0.5],
    [0.3, 0.3],
    // Beside the ground, where no chips come to lie.
    [0.05, 0.5],
  ] as const) {
    await page.mouse.move(box.x + box.width * x, box.y + box.height * y);
    await expectChinese(page, "under the pointer");
    await page.mouse.click(box.x + box.width * x, box.y + box.height * y, { button: "right" });
    await expect(page.locator("parkade-context .popover")).toBeVisible();
    await expectChinese(page, "menu under the pointer");
    await page.keyboard.press("Escape");
  }
  await set(page, {
    playback: {
      ...(await page.evaluate(
        () =>
          (document.querySelector<Inside>("parkade-playground")!.store.state as unknown as { playback: object })
            .playback,
      )),
      base: "search",
    },
  });
  await expectChinese(page, "search in the timeline");
});

test("the Chinese page is Chinese: the papers' tables, measured", async ({ page }) => {
  test.setTimeout(180_000);
  await open(page);
  await page.keyboard.press("y");
  const dialog = page.locator("parkade-papers dialog"),
    measure = dialog.getByRole("button", { name: "测量", exact: true });
  await expect(measure).toBeVisible({ timeout: 60_000 });
  await expectChinese(page, "grid");
  await dialog.getByLabel("起始种子").fill("300");
  await expectChinese(page, "grid, refused");
  for (const name of ["泊车", "道路"]) {
    await dialog.getByRole("tab", { name }).click();
    await expect(measure).toBeVisible({ timeout: 90_000 });
    await expectChinese(page, name);
  }
});

test("the Chinese page is Chinese: trajectories from files, and charts in time", async ({ page }) => {
  await open(page);
  const notice = page.locator("parkade-notices .notice"),
    card = page.locator("parkade-guest");
  const choose = (text: string) =>
    page
      .locator("parkade-playground input[type=file]")
      .setInputFiles({ name: "case.csv", mimeType: "text/csv", buffer: Buffer.from(text) });
  await page.locator("parkade-charts .axes button").nth(1).click();
  await expect(page.locator("parkade-charts")).toContainText("加速度");
  await choose("t,x,y,theta\n0,4,3,0\n2.5,7.125,3,0\n6.5,14,3,0\n");
  await expect(card.getByRole("status")).toContainText("未通过");
  await expectChinese(page, "judged");
  for (const text of [
    "t,x,y,theta\n0,4,3,0\n1,?,3,0\n",
    "t,x,y,?\n0,4,3,0\n1,5,3,0\n",
    "t,x,y\n0,4,3\n1,5,3\n",
    "t,x,y,theta,x\n0,4,3,0,1\n1,5,3,0,1\n",
    "x,y,theta,v\n0,4,3,0\n1,5,3,0\n",
    "x,y,theta,gear\n4,3,0,1\n5,3,0,2\n",
    "t,x,y,theta\n0,4,3,0\n",
    "t,x,y,theta\n0,4,3,0\n1,5,3\n",
    "t,x,y,theta\n1,4,3,0\n2,5,3,0\n",
    "t,x,y,theta\n0,4,3,0\n0,5,3,0\n",
    "t,x,y,theta\n0,4e12,3,0\n1,5,3,0\n",
  ]) {
    await page.evaluate(() =>
      document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ message: null }),
    );
    await choose(text);
    await expect(notice.last(), text).toContainText(/第 \d+ 行第 \d+ 列/);
    await expectChinese(page, text);
  }
});

test("the Chinese page is Chinese: maps and pictures from elsewhere", async ({ page }) => {
  await open(page);
  const input = page.locator("parkade-playground input[type=file]"),
    notice = page.locator("parkade-notices .notice");
  const file = (name: string, text: string | Buffer) => ({
    name,
    mimeType: "application/octet-stream",
    buffer: Buffer.from(text as string),
  });
  const room = `type octile\nheight 4\nwidth 4\nmap\n${"....\n".repeat(4)}`,
    query = (x: number) => `0\troom.map\t4\t4\t0\t0\t${x}\t0\t${x}`;
  await input.setInputFiles([
    file("room.map", room),
    file("room.map.scen", ["version 1", query(2), query(3)].join("\n")),
  ]);
  await expect(page.locator("parkade-import .bar")).toBeVisible();
  await expectChinese(page, "queries");
  const yaml = (more: string) =>
    `image: floor.pgm\nresolution: 0.5\norigin: [0, 0, 0.3]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: ${more}\n`;
  const pgm = Buffer.concat([Buffer.from("P5\n40 30\n255\n"), Buffer.alloc(600, 254), Buffer.alloc(600, 205)]);
  await input.setInputFiles([file("floor.yaml", yaml("0.1")), file("floor.pgm", pgm)]);
  await expect(notice).toContainText("未知格");
  await expectChinese(page, "notes");
  for (const [named, said] of [
    [[file("room.map", room.replace("....", "..x."))], "第 3 列"],
    [[file("room.map", room.replace("height 4", "height 0"))], "高度"],
    [[file("room.map.scen", "version 1")], ".map"],
    [[file("floor.yaml", yaml("0.9")), file("floor.pgm", pgm)], "free_thresh"],
    [[file("floor.yaml", yaml("0.1"))], "floor.pgm"],
    [[file("case.csv", "1,2,3,4,5,6,1,2")], "角点数"],
    [[file("note.txt", "?")], "文件名"],
    [[file("lot.png", "nothing")], "lot.png"],
  ] as const) {
    await input.setInputFiles([...named]);
    await expect(notice.last(), said).toContainText(said);
    await expectChinese(page, said);
  }
  const png = await page.evaluate(() => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 64, height: 48 });
    canvas.getContext("2d")!.fillRect(8, 8, 20, 20);
    return canvas.toDataURL("image/png").split(",")[1]!;
  });
  await input.setInputFiles({ name: "lot.png", mimeType: "image/png", buffer: Buffer.from(png, "base64") });
  await expect(page.locator("parkade-image dialog")).toBeVisible();
  await expectChinese(page, "picture");
});

for (const [width, height] of [
  [390, 844],
  [844, 390],
] as const) {
  test(`the Chinese page is Chinese at ${width} × ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await open(page);
    await settled(page);
    await page.waitForFunction(() => customElements.get("parkade-sheet"));
    await expectChinese(page, "first picture");
    const sheet = page.locator("parkade-sheet");
    if (width > height) await sheet.locator(".toggle").click();
    for (const tab of await sheet.getByRole("tab").all()) {
      await tab.click();
      // biome-ignore lint/performance/useDomNodeTextContent: only what is shown counts
      await expectChinese(page, await tab.innerText());
    }
    if (width > height) await sheet.locator(".toggle").click();
    await page.locator("parkade-toolbar").getByRole("button", { name: "更多" }).click();
    await expectChinese(page, "menu");
  });
}

test("an embedded playground is Chinese in Chinese", async ({ page }) => {
  for (const controls of ["none", "minimal", "full"]) {
    await page.goto(`./embed.html?${controls}#lang=zh&scene=narrow-gap&layout=overlay&controls=${controls}`);
    await page.waitForFunction(
      () => document.querySelector<HTMLElement & { loaded: boolean }>("parkade-playground")?.loaded,
    );
    await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.settled());
    const texts = await textsOf(page);
    expect
      .soft(
        texts.filter((text) => /[A-Za-z]{2,}/.test(text.replaceAll(NAMES, ""))),
        controls,
      )
      .toEqual([]);
  }
});

test("the page stays in sight when its language changes", async ({ page }) => {
  await open(page);
  for (const name of ["4-neighbour", "四邻域"]) {
    await page
      .locator("parkade-toolbar")
      .getByRole("button", { name: /English|中文/ })
      .click();
    await expect(page.locator("parkade-panel").first()).toBeVisible();
    await expect(page.locator("parkade-panel").first()).toContainText(name);
  }
});

test("the Chinese page is Chinese where something is wrong", async ({ page }) => {
  const notice = page.locator("parkade-notices .notice.err");
  await open(page, "#s=1nonsense");
  await expect(notice).toContainText("此链接已损坏或不完整。");
  await expectChinese(page, "broken link");
  const scene = await sceneOf(page),
    input = page.locator("parkade-playground input[type=file]");
  for (const [text, said] of [
    ["{", "JSON 语法错误"],
    ["[]", "须为"],
    [
      JSON.stringify({
        ...scene,
        vehicle: {
          ...(typeof scene.vehicle === "object" ? scene.vehicle : {}),
          wheelbase: -1,
          width: 2,
          rearToFront: 4,
          rearToBack: 1,
          maxSteer: 0.6,
        },
      }),
      "wheelbase",
    ],
  ] as const) {
    await input.setInputFiles({ name: "broken.json", mimeType: "application/json", buffer: Buffer.from(text) });
    await expect(notice).toContainText(said);
    await expectChinese(page, said);
  }
  await page.evaluate(() => {
    const playground = document.querySelector<PlaygroundElement>("parkade-playground")!;
    playground.sceneData = { ...playground.sceneData, start: { x: -50, y: 0, heading: 0 } };
  });
  await settled(page);
  await expectChinese(page, "start outside");
});
