import { expect, test } from "@playwright/test";
import { PARTS } from "../../www/src/element/public-api";
import { watchShifts } from "./playground";
import { type Embed, ready, visit } from "./styled-host";

test("every part takes the page's style", async ({ page }) => {
  await visit(
    page,
    'controls="full" layout="grid"',
    PARTS.map((part, i) => `parkade-playground::part(${part}) { scroll-margin: ${i + 1}px }`).join(" "),
  );
  await ready(page);
  const found = () =>
    page.evaluate(() => {
      const margins = new Set<string>();
      const look = (root: ParentNode): void => {
        for (const element of root.querySelectorAll("*")) {
          margins.add(getComputedStyle(element).scrollMarginTop);
          if (element.shadowRoot) look(element.shadowRoot);
        }
      };
      look(document);
      return [...margins];
    });
  await expect.poll(found).toEqual(expect.arrayContaining(PARTS.map((_, i) => `${i + 1}px`)));
});

test("the poster's and the progress bar's parts and slots are there until the playground is", async ({ page }) => {
  await visit(
    page,
    'reveal="interaction" alt="A car"',
    "parkade-playground::part(poster) { scroll-margin: 5px } parkade-playground::part(progress) { scroll-margin: 6px }",
    '<b slot="poster">Before</b><i slot="toolbar-extra">Mine</i>',
  );
  await expect(page.getByText("Before")).toBeVisible();
  const root = page.locator("parkade-playground");
  expect(await root.locator(".poster").evaluate((element) => getComputedStyle(element).scrollMarginTop)).toBe("5px");
  const seen = await page.evaluate(async () => {
    const element = document.querySelector("parkade-playground") as Embed,
      margins: string[] = [];
    element.addEventListener("progress", () => {
      const bar = element.shadowRoot!.querySelector(".bar");
      if (bar) margins.push(getComputedStyle(bar).scrollMarginTop);
    });
    await element.dismissPoster();
    return margins;
  });
  expect(seen).toContain("6px");
  await expect(page.getByText("Before")).toBeHidden();
  await expect(page.getByText("Mine")).toBeVisible();
});

test("panels follow the map under the poster, where no press misses them; those without room are not built", async ({
  page,
}) => {
  const shifts = await watchShifts(page);
  await visit(
    page,
    'controls="full" layout="overlay" planners="eight hybrid" loading="lazy"',
    "parkade-playground { display: block; width: 720px; height: 420px }",
  );
  const seen = await page.evaluate(async () => {
    const element = document.querySelector("parkade-playground") as Embed,
      root = element.shadowRoot!;
    const built = () => {
      const inner = root.querySelector("parkade-embedded")!.shadowRoot!;
      const count = (piece: string) =>
        inner.querySelector(`parkade-${piece}`)?.shadowRoot?.querySelectorAll("button, td").length ?? 0;
      return {
        bar: count("toolbar") > 10,
        table: count("table") > 10,
        timeline: count("timeline") > 5,
        pressed: root.elementFromPoint(30, 30)!.className,
      };
    };
    Object.assign(window, { built });
    const first = new Promise((done) => element.addEventListener("ready", () => done(built()), { once: true }));
    const shown = new Promise((done) =>
      new MutationObserver(() => {
        if (!root.querySelector(".poster")) done(built());
      }).observe(root, { childList: true }),
    );
    return { first: await first, shown: await shown };
  });
  expect(seen).toMatchObject({
    first: { bar: false, table: false, timeline: false, pressed: "poster" },
    shown: { bar: true, table: false, timeline: true },
  });
  await page.getByRole("button", { name: "More", exact: true }).click();
  await expect(page.getByRole("checkbox", { name: "Swept area" })).toBeVisible();
  expect((await shifts()).reduce((a, b) => a + b, 0)).toBeLessThan(0.0005);
  await page.addStyleTag({ content: "parkade-playground { width: 1280px !important; height: 760px !important }" });
  const built = () => page.evaluate(() => (window as unknown as { built(): object }).built());
  await expect.poll(built).toMatchObject({ bar: true, table: true });
  await expect(page.locator("parkade-inspector parkade-vehicle")).toBeVisible();
});

for (const [width, height, attributes] of [
  [1280, 720, 'controls="full" layout="overlay"'],
  [1280, 720, 'controls="full" layout="grid"'],
  [720, 420, 'controls="full" layout="overlay"'],
  [390, 700, 'controls="full" layout="overlay"'],
  [390, 420, 'controls="full" layout="overlay"'],
  [390, 420, 'controls="minimal" layout="single"'],
] as const) {
  test(`the first map is already where it stays: ${attributes}, ${width} × ${height}`, async ({ page }) => {
    await page.addInitScript(() => {
      const looks: unknown[] = [];
      Object.assign(window, { looks });
      document.addEventListener(
        "plan-start",
        ({ target }) => {
          const root = (target as Element).shadowRoot!,
            stage = () => root.querySelector("parkade-embedded")!.shadowRoot!.querySelector("parkade-stage")!;
          const look = () => {
            const views = [stage(), ...stage().shadowRoot!.querySelectorAll("parkade-panel")].flatMap(
              ({ shadowRoot }) => [...shadowRoot!.querySelectorAll("parkade-scene-view")],
            );
            looks.push({
              maps: views.map((view) => view.getBoundingClientRect().toJSON()),
              covered: root.querySelector(".poster") !== null,
            });
          };
          requestAnimationFrame(() => look());
          new MutationObserver(() => {
            if (!root.querySelector(".poster")) look();
          }).observe(root, { childList: true });
        },
        { once: true },
      );
    });
    await visit(
      page,
      `${attributes} planners="four eight hybrid"`,
      `parkade-playground { width: ${width}px !important; height: ${height}px !important }`,
    );
    type Look = { maps: DOMRect[]; covered: boolean };
    const looks = () => page.evaluate(() => (window as unknown as { looks: Look[] }).looks);
    await expect.poll(async () => (await looks()).length, { timeout: 30_000 }).toBeGreaterThan(1);
    const [first, shown] = await looks();
    expect(first).toMatchObject({ covered: true });
    expect(first!.maps[0]!.width).toBeGreaterThan(200);
    expect(shown).toEqual({ maps: first!.maps, covered: false });
  });
}

test("a progress bar of the page's own stands in the slot", async ({ page }) => {
  await visit(page, 'reveal="interaction"', "", '<b slot="progress">Wait</b>');
  const visible = await page.evaluate(async () => {
    const element = document.querySelector("parkade-playground") as Embed,
      seen: boolean[] = [];
    element.addEventListener("progress", () => seen.push(element.querySelector("b")!.checkVisibility()));
    await element.dismissPoster();
    return seen;
  });
  expect(visible[0]).toBe(true);
  expect(visible.at(-1)).toBe(false);
});

test("every colour, the radius and the font are the page's", async ({ page }) => {
  const colours: Record<string, string> = {
    bg: "#fffbe6",
    obstacle: "#123456",
    "planner-1": "#ff0000",
    "planner-2": "#00aa00",
    "planner-3": "#0000ff",
    "planner-4": "#aa00aa",
    "planner-5": "#009999",
    "planner-6": "#664400",
    accent: "#ff8800",
    fg: "#220022",
  };
  await visit(
    page,
    'controls="full" layout="grid" planners="four eight risk-field hybrid hybrid-forward sixteen" layers="clean"',
    `parkade-playground { ${Object.entries(colours)
      .map(([name, value]) => `--parkade-${name}: ${value}`)
      .join("; ")}; --parkade-radius: 3; --parkade-font: monospace }`,
  );
  await ready(page);
  const drawn = () =>
    page.evaluate((wanted) => {
      const found = new Set<string>();
      const look = (root: ParentNode): void => {
        for (const element of root.querySelectorAll("*")) {
          if (element instanceof HTMLCanvasElement && element.width > 0) {
            const { data } = element.getContext("2d")!.getImageData(0, 0, element.width, element.height);
            for (let i = 0; i < data.length; i += 4)
              found.add(
                `#${[data[i]!, data[i + 1]!, data[i + 2]!].map((part) => part.toString(16).padStart(2, "0")).join("")}`,
              );
          }
          if (element.shadowRoot) look(element.shadowRoot);
        }
      };
      look(document);
      return wanted.filter((value) => !found.has(value));
    }, Object.values(colours));
  await expect.poll(drawn).toEqual([]);
  const title = page.locator("parkade-panel h2").first();
  expect(await title.evaluate((element) => getComputedStyle(element).fontFamily)).toBe("monospace");
  const radius = () =>
    page
      .locator("parkade-toolbar button")
      .first()
      .evaluate((element) => parseFloat(getComputedStyle(element).borderTopLeftRadius));
  const wide = await radius();
  await page.evaluate(() =>
    document.querySelector<HTMLElement>("parkade-playground")!.style.setProperty("--parkade-radius", "1"),
  );
  expect(wide).toBeGreaterThan(0);
  expect(await radius()).toBe(wide / 3);
});

test("workers and modules come from the folders that are named", async ({ page }) => {
  const asked: string[] = [];
  await page.route("**/host/copies/**", async (route) => {
    const name = new URL(route.request().url()).pathname.split("/").at(-1)!;
    asked.push(name);
    await route.fulfill({ response: await route.fetch({ url: new URL(`/sub/path/assets/${name}`, page.url()).href }) });
  });
  await visit(page, 'layout="single" controls="none" worker-url="copies" wasm-url="copies/"', "");
  await ready(page);
  expect(asked).toEqual(
    expect.arrayContaining([expect.stringMatching(/^engine-.*\.js$/), expect.stringMatching(/^parkade_bg-.*\.wasm$/)]),
  );
  // They are that element's alone.
  const before = asked.length;
  await page.evaluate(async () => {
    const other = document.createElement("parkade-playground") as Embed;
    for (const [name, value] of Object.entries({ layout: "single", controls: "none", loading: "eager" }))
      other.setAttribute(name, value);
    document.body.prepend(other);
    await other.settled();
  });
  expect(asked.slice(before)).toEqual([]);
  await page.unrouteAll({ behavior: "ignoreErrors" });
});

test("at every width the toolbar ends inside the playground, and what it has no room for is in its menu", async ({
  page,
}) => {
  await visit(page, 'controls="full" layout="focus"', "");
  await ready(page);
  await expect(page.getByRole("button", { name: "Focus" })).toHaveAttribute("aria-pressed", "true");
  await expect(page.locator("parkade-stage .focus")).toBeVisible();
  // The loader's bar, or one that has just been redrawn, is measured until it stays.
  const beyond = (width: number) =>
    page.evaluate(async (width) => {
      document.querySelector<HTMLElement>("parkade-playground")!.style.width = `${width}px`;
      const inner = document.querySelector("parkade-playground")!.shadowRoot!;
      const all = (root: ParentNode): Element[] =>
        [...root.querySelectorAll("*")].flatMap((one) => [one, ...(one.shadowRoot ? all(one.shadowRoot) : [])]);
      const bar = all(inner).find((one) => one.localName === "parkade-toolbar")!;
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      const right = bar.getBoundingClientRect().right;
      return {
        width: bar.getBoundingClientRect().width,
        beyond: [...bar.shadowRoot!.querySelectorAll("*")]
          .filter((one) => one.checkVisibility() && one.getBoundingClientRect().right > right + 0.5)
          .map((one) => one.getAttribute("aria-label") ?? one.className),
      };
    }, width);
  for (const lang of ["en", "zh"]) {
    await page.evaluate((lang) => document.querySelector("parkade-playground")!.setAttribute("lang", lang), lang);
    for (const width of [
      320, 480, 640, 641, 718, 800, 830, 831, 900, 925, 926, 1000, 1140, 1141, 1200, 1230, 1231, 1280, 1390, 1391, 1400,
    ]) {
      await expect.poll(() => beyond(width), `${lang}, ${width} px`).toEqual({ width, beyond: [] });
    }
  }
  await beyond(718);
  const menu = page.getByRole("button", { name: "更多", exact: true });
  await menu.click();
  await expect(page.getByRole("checkbox", { name: "跳点搜索" })).toBeVisible();
  await expect(page.getByRole("checkbox", { name: "扫掠包络" })).toHaveCount(1);
  await menu.click();
  await beyond(1000);
  await menu.click();
  await expect(page.getByRole("button", { name: "导出", exact: true })).toBeHidden();
  await expect(page.getByRole("checkbox", { name: "跳点搜索" })).toHaveCount(0);
});
