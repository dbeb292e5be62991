import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, test } from "@playwright/test";
import type { Scenario } from "parkade";
import { HOST, near, quiet, UNSEEN, watch, type Embed } from "./embed";
import { complaintsOf } from "./playground";

const wasm = (urls: string[]) => urls.filter((url) => url.endsWith(".wasm"));

test(
  "nothing but the loader is fetched before a playground is near; then it moves nothing, and the second costs no " +
    "byte",
  async ({ page }) => {
    const complaints = complaintsOf(page);
    const { urls, shifted } = await watch(page);
    await page.goto(HOST);
    await page.waitForLoadState("networkidle");
    expect(urls.filter((url) => url.includes("/sub/path/"))).toEqual([
      expect.stringMatching(/parkade-playground\.js$/),
    ]);

    await near(page, "one");
    await expect(page.locator("#one").locator("canvas")).toHaveCount(1);
    await expect(page.locator("#one").locator(".poster")).toHaveCount(0);
    expect(await shifted()).toBeLessThan(UNSEEN);

    await quiet(urls);
    // Who only looks needs the small module alone.
    expect(wasm(urls)).toHaveLength(1);
    const before = urls.length;
    await near(page, "two");
    await quiet(urls);
    // A worker's script comes from the cache; nothing is new.
    expect(urls.slice(before).filter((url) => !urls.slice(0, before).includes(url))).toEqual([]);
    const answers = () =>
      page.evaluate(() =>
        Object.values((document.getElementById("two") as Embed).results).map((plan) => plan?.outcome),
      );
    await expect.poll(answers).toEqual(["found", "found"]);
    expect(await shifted()).toBeLessThan(UNSEEN);
    await page.evaluate(() => (document.getElementById("two") as unknown as { play(): Promise<void> }).play());
    await expect.poll(() => wasm(urls).length).toBe(2);
    expect(complaints).toEqual([]);
  },
);

test("a playground shows its first plans once, and the next one begins on the module that is there", async ({
  page,
}) => {
  await watch(page);
  await page.addInitScript(() => {
    const counts = { modules: new Set<unknown>(), heard: [] as string[] };
    Object.assign(window, { counts });
    window.Worker = class extends Worker {
      override postMessage(message: { kind: string; module?: unknown }): void {
        if (message.kind === "start") counts.modules.add(message.module);
        super.postMessage(message);
      }
    };
    for (const name of ["plan-start", "plan-result"])
      document.addEventListener(name, (event) => counts.heard.push(`${(event.target as Element).id} ${name}`));
  });
  const counts = () =>
    page.evaluate(() => {
      const { modules, heard } = (window as unknown as { counts: { modules: Set<unknown>; heard: string[] } }).counts;
      return { modules: modules.size, heard: heard.sort() };
    });
  await page.goto(HOST);
  await near(page, "one");
  await near(page, "two");
  for (const id of ["one", "two"])
    await page.evaluate(
      (name) => (document.getElementById(name) as unknown as { settled(): Promise<void> }).settled(),
      id,
    );
  expect((await counts()).modules).toBe(1);
  expect((await counts()).heard).toEqual([
    "one plan-result",
    "one plan-start",
    "two plan-result",
    "two plan-result",
    "two plan-start",
  ]);
  await page.evaluate(async () => {
    const third = document.getElementById("three") as Embed & { load(): Promise<unknown>; toCSV(): Promise<string> };
    third.setAttribute("planners", "eight hybrid");
    third.scrollIntoView();
    await third.load();
    await third.toCSV();
  });
  const after = await counts();
  // Another module for a planner that has it all, which the others take over without a word.
  expect(after.modules).toBe(2);
  expect(after.heard.filter((one) => one.startsWith("three"))).toEqual([
    "three plan-result",
    "three plan-result",
    "three plan-start",
  ]);
});

test("another playground plans with the workers that rest at those before it, and starts none", async ({ page }) => {
  const { urls } = await watch(page);
  let started = 0;
  page.on("worker", () => started++);
  await page.goto(HOST);
  for (const id of ["one", "two"]) await near(page, id);
  // The whole module, which a table of the path asks for.
  await page.evaluate(() =>
    Promise.all(
      ["one", "two"].map((id) => (document.getElementById(id) as unknown as { toCSV(): Promise<string> }).toCSV()),
    ),
  );
  await quiet(urls);
  const again = () =>
    page.evaluate(() =>
      Promise.all(
        ["one", "two"].map((id) => (document.getElementById(id) as unknown as { plan(): Promise<void> }).plan()),
      ),
    );
  await again();
  const before = started;
  expect(before).toBeGreaterThanOrEqual(3);
  const hashes = () =>
    page.evaluate(async () => {
      const other = document.createElement("parkade-playground") as Embed;
      for (const [name, value] of [
        ["planners", "four eight hybrid"],
        ["layout", "overlay"],
        ["loading", "eager"],
      ])
        other.setAttribute(name!, value!);
      document.getElementById("two")!.before(other);
      await other.ready;
      return Object.values(other.results).map((plan) => plan?.hash);
    });
  expect((await hashes()).filter((hash) => hash?.length === 33)).toHaveLength(3);
  expect(started).toBe(before);
  await quiet(urls);
  // What was lent comes back.
  await again();
  expect(started).toBe(before);
});

test("playgrounds share the workers of one pool, and keep none of the first picture's module", async ({ page }) => {
  await watch(page);
  await page.goto(HOST);
  for (const id of ["one", "two"]) await near(page, id);
  // A promise that nothing in the page refers to may be collected before its answer is told.
  await page.evaluate(async () => {
    await (document.getElementById("three") as unknown as { load(): Promise<unknown> }).load();
  });
  await near(page, "three");
  const most = await page.evaluate(() => Math.min(8, Math.max(6, navigator.hardwareConcurrency)));
  await expect.poll(() => page.workers().length).toBeLessThanOrEqual(most);
  for (const id of ["one", "two", "three"])
    await page.evaluate(
      (name) => (document.getElementById(name) as unknown as { settled(): Promise<void> }).settled(),
      id,
    );
  expect(page.workers().length).toBeLessThanOrEqual(most);
});

test(
  "what waits for a press fetches nothing until it is pressed, also by the keyboard, and then speaks its own " +
    "language and colours",
  async ({ page }) => {
    const { urls, shifted } = await watch(page);
    await page.goto(HOST);
    await page.evaluate(() => document.getElementById("three")!.scrollIntoView({ block: "center" }));
    await page.waitForTimeout(300);
    expect(urls.filter((url) => url.includes("/sub/path/"))).toEqual([
      expect.stringMatching(/parkade-playground\.js$/),
    ]);
    const poster = page.locator("#three").getByRole("button", { name: "A scene of its own" });
    await poster.focus();
    await page.keyboard.press("Enter");
    await page.evaluate(() => (document.getElementById("three") as Embed).ready);
    const scene = await page.evaluate(() => (document.getElementById("three") as Embed).sceneData);
    expect([scene.name, scene.goal]).toEqual(["Own", { x: 15, y: 7, heading: 0 }]);
    await expect(page.locator("#three").getByRole("button", { name: "撤销" }).first()).toBeAttached();
    expect(
      await page
        .locator("#three")
        .locator("parkade-embedded")
        .evaluate((element) => getComputedStyle(element).colorScheme),
    ).toBe("dark");
    expect(await shifted()).toBeLessThan(UNSEEN);
  },
);

test("the page's colours, parts and slots reach into the playground", async ({ page }) => {
  await watch(page);
  await page.goto(HOST);
  await near(page, "one");
  expect(
    await page
      .locator("#one")
      .locator("parkade-stage")
      .evaluate((element) => getComputedStyle(element).getPropertyValue("--parkade-accent").trim()),
  ).toBe("rgb(1, 2, 3)");
  expect(
    await page
      .locator("#one")
      .locator("parkade-timeline")
      .evaluate((element) => getComputedStyle(element).opacity),
  ).toBe("0.9");
});

test("the page keeps its wheel and its keys; a press on the chip begins editing, Ctrl and the wheel zoom", async ({
  page,
}) => {
  await watch(page);
  await page.goto(HOST);
  await near(page, "one");
  const camera = () => page.evaluate(() => (document.getElementById("one") as Embed).camera);
  const box = (await page.locator("#one").boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const from = await page.evaluate(() => scrollY);
  await page.mouse.wheel(0, 120);
  await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(from);
  const scene = await page.evaluate(() => JSON.stringify((document.getElementById("one") as Embed).sceneData));
  await page.keyboard.press("Delete");
  await page.keyboard.press("b");
  await page.mouse.move(box.x + 200, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 300, box.y + 150, { steps: 4 });
  await page.mouse.up();
  expect(await page.evaluate(() => JSON.stringify((document.getElementById("one") as Embed).sceneData))).toBe(scene);

  await page.locator("#one").getByRole("button", { name: "Tap to edit" }).click();
  await expect(page.locator("#one").getByRole("button", { name: "Tap to edit" })).toHaveCount(0);
  const now = await page.evaluate(() => scrollY);
  const again = (await page.locator("#one").boundingBox())!;
  await page.mouse.move(again.x + again.width / 2, again.y + again.height / 2);
  await page.mouse.wheel(0, -60);
  await expect.poll(() => page.evaluate(() => scrollY)).toBeLessThan(now);
  expect(await camera()).toBeNull();
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -60);
  await page.keyboard.up("Control");
  await expect.poll(camera).not.toBeNull();
});

test("the example page says what its playground found, also after an edit", async ({ page }) => {
  const complaints: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  await page.route("**/examples/html/**", async (route) => {
    const path = new URL(route.request().url()).pathname.slice("/examples/html/".length);
    if (path.startsWith("parkade/"))
      return route.fulfill({
        response: await route.fetch({ url: new URL(`/sub/path/${path.slice("parkade/".length)}`, page.url()).href }),
      });
    return route.fulfill({
      path: fileURLToPath(new URL(`../../examples/html/${path || "index.html"}`, import.meta.url)),
    });
  });
  await page.goto("/host/three.html");
  await page.goto("/examples/html/");
  await expect(page.locator("#answer")).toHaveText(/^\d+\.\d\d$/, { timeout: 20_000 });
  const before = await page.locator("#answer").textContent();
  await page.evaluate(async () => {
    const element = document.querySelector<Embed>("parkade-playground")!;
    const scene = await (element["getScene"] as () => Promise<Scenario>)();
    await (element["setScene"] as (next: Scenario) => Promise<void>)({
      ...scene,
      start: { ...scene.start, x: scene.start.x + 1 },
    });
  });
  await expect(page.locator("#answer")).not.toHaveText(before!);
  expect(complaints).toEqual([]);
  // Workers may still be on their way.
  await page.unrouteAll({ behavior: "ignoreErrors" });
});

test("the documentation's lines of HTML show a playground", async ({ page }) => {
  const samples = [
    ...readFileSync(new URL("../../docs/embed.md", import.meta.url), "utf8").matchAll(/```html\n([^]*?)```/g),
  ].map((match) => match[1]!);
  expect(samples.length).toBeGreaterThanOrEqual(4);
  for (const sample of samples) {
    await page.route("**/host/sample.html", (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><title>Sample</title>${sample.replaceAll("parkade/", "/sub/path/")}`,
      }),
    );
    await page.goto("/host/sample.html");
    const frame = sample.includes("<iframe") ? page.frameLocator("iframe") : page;
    await frame.locator("parkade-playground .poster").first().waitFor({ state: "attached" });
    if (sample.includes("interaction")) await frame.getByRole("button", { name: "A car beside a gap" }).click();
    await frame.locator("parkade-playground canvas").first().waitFor();
    await page.unroute("**/host/sample.html");
  }
});

test.describe("in a frame of another origin", () => {
  interface Host {
    heard: { type: string; [key: string]: unknown }[];
    ask(name: string, rest?: object): Promise<{ result?: unknown; error?: string }>;
  }

  test(
    "the same methods and events pass as messages, the frame tells its height, nothing moves, strangers are not " +
      "heard",
    async ({ page }) => {
      const { shifted } = await watch(page);
      await page.goto("/host/frame.html");
      const heard = () => page.evaluate(() => (window as unknown as Host).heard.map(({ type }) => type));
      await expect.poll(heard, { timeout: 30_000 }).toContain("parkade:plan-complete");
      await expect
        .poll(heard)
        .toEqual(
          expect.arrayContaining(["parkade:height", "parkade:progress", "parkade:ready", "parkade:plan-result"]),
        );
      expect(await page.locator("iframe").getAttribute("height")).toBe("420");
      const inside = await page
        .frames()[1]!
        .evaluate(() => (window as unknown as { shifts: number[] }).shifts.reduce((a, b) => a + b, 0));
      expect(Math.max(await shifted(), inside)).toBeLessThan(UNSEEN);
      const talked = await page.evaluate(async () => {
        const { ask } = window as unknown as Host;
        const scene = (await ask("getScene")).result as Scenario;
        const set = await ask("setScene", { args: [{ ...scene, name: "From outside" }] });
        const after = (await ask("getScene")).result as Scenario;
        return {
          set,
          name: after.name,
          svg: String((await ask("toSVG")).result).slice(0, 4),
          bad: (await ask("setScene", { args: [{}] })).error,
          unknown: (await ask("constructor")).error,
        };
      });
      expect(talked).toMatchObject({ name: "From outside", svg: "<svg", unknown: "there is no parkade:constructor" });
      expect(talked.bad).toContain("version");
    },
  );

  test("with an allow-list of others this page hears nothing", async ({ page }) => {
    await page.goto(
      `/host/frame.html?hash=${encodeURIComponent("layout=single&controls=none&origins=https://example.org")}`,
    );
    await page.locator("iframe").scrollIntoViewIfNeeded();
    await page.frameLocator("iframe").locator("parkade-playground canvas").waitFor();
    await page.frames()[1]!.evaluate(() => (document.querySelector("parkade-playground") as Embed).ready);
    const state = await page.evaluate(async () => {
      const { ask, heard } = window as unknown as Host;
      const answered = await Promise.race([
        ask("getScene").then(() => true),
        new Promise((done) => setTimeout(() => done(false), 500)),
      ]);
      return { answered, heard: heard.length };
    });
    expect(state).toEqual({ answered: false, heard: 0 });
  });
});
