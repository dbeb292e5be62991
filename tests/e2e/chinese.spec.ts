import { expect, test, type Page } from "@playwright/test";
import { open, sceneOf, settled, type PlaygroundElement } from "./playground";

test.use({ locale: "zh-CN" });

/** What Chinese engineers write in Latin letters: names, formats, units, fields of the scene, values of settings and keys. */
const NAMES = new RegExp([
  "Parkade", "English", "EN", "[0-9a-f]{16}", "Markdown", "Node", "PNG", "SVG", "CSV", "JSON", "MovingAI", "ROS", "TPCAP", "Theta", "NBA", "Reeds", "Shepp", "Dubins", "Voronoi", "RMS",
  "Ctrl", "Shift", "Alt", "Cmd", "Enter", "Esc(ape)?", "Del(ete)?", "Backspace", "Tab", "kB", "MB", "ms", "rad", "exp", "Bd", "id", "los", "auto", "comfort", "classic",
  "vehicle", "max", "none", "first", "best", "nba", "spline", "paper", "octile", "L_aa", "steps", "cargo xtask paper \\w+", "slot-\\d+", "obstacle-\\d+",
  "start\\.\\w+", "vehicle\\.\\w+", "broken\\.[\\w.]+",
].map((name) => `(?<![A-Za-z])${name}(?![A-Za-z])`).join("|"), "g");

/** Papers as they are cited: their authors and the year. */
const CITED = /(?:[A-Z][a-z]+, )*[A-Z][a-z]+(?: 等)? \d{4}/g;

/** Every visible text and every name for those who cannot see it, shadow trees included. */
function textsOf(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const texts = new Set<string>();
    const visit = (node: Node): void => {
      if (node instanceof HTMLElement || node instanceof SVGElement) {
        if (["style", "script", "noscript", "kbd"].includes(node.localName)) return;
        if (node instanceof HTMLElement && !node.checkVisibility() && node.localName !== "option") return;
        for (const name of ["aria-label", "title", "placeholder", "aria-valuetext", "aria-description", "alt"]) {
          const text = node.getAttribute(name);
          if (text) texts.add(text.trim());
        }
        if (node.shadowRoot) visit(node.shadowRoot);
      }
      if (node.nodeType === Node.TEXT_NODE && node.textContent!.trim()) texts.add(node.textContent!.trim());
      node.childNodes.forEach(visit);
    };
    visit(document.body);
    return [...texts];
  });
}

async function expectChinese(page: Page, where: string): Promise<void> {
  const texts = await textsOf(page);
  expect(texts.length, where).toBeGreaterThan(20);
  expect.soft(texts.filter((text) => /[A-Za-z]{2,}/.test(text.replaceAll(NAMES, "").replace(CITED, ""))), where).toEqual([]);
}

const set = (page: Page, patch: Record<string, unknown>): Promise<void> =>
  page.evaluate((given) => document.querySelector<PlaygroundElement>("parkade-playground")!.store.set(given), patch);

test("the Chinese page is Chinese: tools, layouts, layers, settings and menus", async ({ page }) => {
  test.setTimeout(120_000);
  await open(page);
  await settled(page);
  await expectChinese(page, "first picture");
  for (const mode of ["overlay", "focus", "grid"]) {
    await set(page, { mode });
    await expectChinese(page, mode);
  }
  for (const tool of ["brush", "cost", "wall", "rectangle", "polygon", "car", "slot", "moving", "road", "eraser", "hand", "select"]) {
    await set(page, { tool });
    await expectChinese(page, tool);
  }
  const scene = await sceneOf(page);
  for (const selection of [{ kind: "start" }, { kind: "goal" }, { kind: "slot", id: scene.slots![0]!.id }, ...scene.obstacles!.map(({ id }) => ({ kind: "obstacle", id }))]) {
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
    if (await head.getAttribute("aria-expanded") !== "true") await head.click();
    await expectChinese(page, block);
  }
  await form.getByRole("button", { name: "自定" }).click();
  await form.getByRole("textbox", { name: "轴距" }).fill("9");
  await expect(form.getByRole("status")).toHaveText("轴距须小于车长 4.7 m。");
  await expectChinese(page, "refused");
});

test("the page stays in sight when its language changes", async ({ page }) => {
  await open(page);
  for (const name of ["4-neighbour", "四邻域"]) {
    await page.locator("parkade-toolbar").getByRole("button", { name: /English|中文/ }).click();
    await expect(page.locator("parkade-panel").first()).toBeVisible();
    await expect(page.locator("parkade-panel").first()).toContainText(name);
  }
});

test("the Chinese page is Chinese where something is wrong", async ({ page }) => {
  const notice = page.locator("parkade-notices .notice.err");
  await open(page, "#s=1nonsense");
  await expect(notice).toContainText("此链接已损坏或不完整。");
  await expectChinese(page, "broken link");
  const scene = await sceneOf(page), input = page.locator("parkade-playground input[type=file]");
  for (const [text, said] of [["{", "JSON 语法错误"], ["[]", "须为"], [JSON.stringify({ ...scene, vehicle: { ...(typeof scene.vehicle === "object" ? scene.vehicle : {}), wheelbase: -1, width: 2, rearToFront: 4, rearToBack: 1, maxSteer: 0.6 } }), "wheelbase"]] as const) {
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
