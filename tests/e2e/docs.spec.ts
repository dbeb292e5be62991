import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, test } from "@playwright/test";
import { WORDS } from "../../docs/.vitepress/words";
import { init, scenario } from "../../pkg/node.js";
import { complaintsOf } from "./playground";

const SITE = fileURLToPath(new URL("../../docs/.vitepress/dist/", import.meta.url));
const BASE = "/docs/";
/** Beside the documentation's folder: the page, and the same for other people's pages with a scene by name. */
const PLAYGROUND = "/index.html",
  EMBEDDED = "/embed.html";

test.beforeAll(() => {
  test.setTimeout(240_000);
  // `cargo xtask test` has built it already.
  if (!existsSync(SITE))
    execFileSync(process.execPath, ["node_modules/vitepress/bin/vitepress.js", "build", "docs"], { stdio: "ignore" });
});

const pages = () =>
  readdirSync(SITE, { recursive: true, encoding: "utf8" })
    .map((file) => file.replaceAll("\\", "/"))
    .filter((file) => file.endsWith(".html") && file !== "404.html");

test("every internal link leads to a page, every fragment to a heading, every scene's name to a scene", async () => {
  await init();
  const scenes = new Set<string>();
  const all = new Set(pages()),
    text = (file: string) => readFileSync(SITE + file, "utf8");
  expect(all.size).toBeGreaterThan(35);
  const dead: string[] = [];
  for (const file of all) {
    for (const [, href] of text(file).matchAll(/<a [^>]*href="([^"]+)"/g)) {
      const url = new URL(href!.replaceAll("&amp;", "&"), `http://site${BASE}${file}`);
      if (url.host !== "site" || url.pathname === PLAYGROUND) continue;
      if (url.pathname === EMBEDDED) {
        scenes.add(new URLSearchParams(url.hash.slice(1)).get("scene") ?? href!);
        continue;
      }
      const target = url.pathname.slice(BASE.length).replace(/(^|\/)$/, "$1index.html");
      const found = all.has(target) ? target : all.has(`${target}.html`) ? `${target}.html` : null;
      const fragment = decodeURIComponent(url.hash.slice(1));
      if (!found || (fragment && !text(found).includes(`id="${fragment}"`))) dead.push(`${file}: ${href}`);
    }
  }
  expect(dead).toEqual([]);
  expect(scenes.size).toBeGreaterThan(5);
  for (const id of scenes) expect(() => scenario(id), id).not.toThrow();
});

test("each page's title is words, and no two pages of a language share one", () => {
  const titles = pages().map(
    (file) => [file, /<title>([^<]*)<\/title>/.exec(readFileSync(SITE + file, "utf8"))?.[1] ?? ""] as const,
  );
  expect(titles.filter(([, title]) => !title || /[{}$]|params/.test(title))).toEqual([]);
  for (const chinese of [true, false]) {
    const own = titles.filter(([file]) => file.startsWith("zh/") === chinese).map(([, title]) => title);
    expect(new Set(own).size, String(own)).toBe(own.length);
  }
  expect(Object.fromEntries(titles)["planners/hybrid.html"]).toContain("ybrid A*");
});

for (const home of ["", "zh/"]) {
  test(`the home page /docs/${home} opens the playground`, async ({ page }) => {
    await page.goto(BASE + home);
    await page.locator(".VPHero a[href$='index.html']").click();
    await expect(page).toHaveURL((url) => url.pathname === PLAYGROUND || url.pathname === "/");
    await expect(page.locator("parkade-panel").first()).toBeVisible();
  });
}

for (const { home, button, query, heading } of [
  { home: "", button: "Search", query: "universal search Levin", heading: /Hybrid A/ },
  { home: "zh/", button: "搜索", query: "障碍物", heading: /[\u4e00-\u9fff]/ },
]) {
  test(`a search on /docs/${home} for "${query}" lands on the section that says it`, async ({ page }) => {
    await page.goto(BASE + home);
    await page.getByRole("button", { name: button }).click();
    await page.getByRole("searchbox").fill(query);
    const first = page.locator(".VPLocalSearchBox a.result").first();
    await expect(first).toBeVisible();
    await first.click();
    await expect(page.locator(".VPLocalSearchBox")).toHaveCount(0);
    await expect(page.locator("h1")).toHaveText(heading);
    await expect(page.locator(".vp-doc")).toContainText(query.split(" ")[0]!, { ignoreCase: true });
    expect(new URL(page.url()).pathname.startsWith(`${BASE}${home}`)).toBe(true);
  });
}

for (const file of [
  "planners/hybrid.html",
  "planners/risk-field.html",
  "planners/jump-point.html",
  "papers/road.html",
  "papers/sixteen.html",
  "zh/planners/hybrid.html",
  "zh/guide.html",
]) {
  test(`the figures of ${file} come alive when they are near, without a complaint`, async ({ page }) => {
    const complaints = complaintsOf(page);
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.goto(BASE + file);
    const outcomes = await page.evaluate(async () => {
      await customElements.whenDefined("parkade-playground");
      const found = [];
      for (const figure of document.querySelectorAll<
        HTMLElement & { ready: Promise<void>; results: Record<string, { outcome: string } | null> }
      >("parkade-playground")) {
        figure.scrollIntoView({ block: "center" });
        await figure.ready;
        found.push(...Object.values(figure.results).map((plan) => plan?.outcome));
      }
      return found;
    });
    expect(outcomes.length).toBeGreaterThan(0);
    expect(new Set(outcomes)).toEqual(new Set(["found"]));
    expect(complaints).toEqual([]);
  });
}

test("every planner has a page in both languages, with its settings", () => {
  const planners = Object.keys(WORDS);
  expect(planners.length).toBeGreaterThanOrEqual(15);
  for (const id of planners) {
    for (const lang of ["", "zh/"]) {
      const text = readFileSync(`${SITE}${lang}planners/${id}.html`, "utf8");
      expect(text).toContain("<parkade-playground");
      expect(text).toMatch(/<td><code>(maxExpansions|heuristic)<\/code><\/td>/);
    }
  }
});

test("the figures of how tight it can be are there, and follow the page's scheme", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "light" });
  await page.goto(`${BASE}planners/hybrid.html`);
  await page.locator(".vp-doc a[href$='how-tight.html']").click();
  const figures = page.locator(".measured img");
  await expect(figures).toHaveCount(6);
  for (const figure of await figures.all()) {
    await figure.scrollIntoViewIfNeeded();
    await expect.poll(() => figure.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(0);
  }
  // A ground that stays: what changes is the figure.
  await page.addStyleTag({ content: ".measured img { background: #888 }" });
  const light = await figures.first().screenshot();
  await page.evaluate(() => document.documentElement.classList.add("dark"));
  await expect.poll(async () => (await figures.first().screenshot()).equals(light)).toBe(false);
});
