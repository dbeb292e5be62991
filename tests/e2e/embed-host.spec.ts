/** An embedded playground in pages that have a theme, change its scene, move it and listen to events. */
import { expect, test, type Page } from "@playwright/test";
import { HOST, type Embed } from "./embed";

type Told = { code: string; field?: string; message: string; value?: unknown; rule?: string };

/** A playground with these attributes, loaded at once, whose errors are kept. */
const add = async (page: Page, attributes: Record<string, string>) => {
  await page.goto(HOST);
  await page.evaluate((given) => {
    const element = document.createElement("parkade-playground");
    for (const [name, value] of Object.entries({
      id: "own",
      loading: "eager",
      controls: "none",
      layout: "single",
      ...given,
    }))
      element.setAttribute(name, value);
    const told: unknown[] = [];
    Object.assign(window, { told });
    element.addEventListener("error", (event) => told.push((event as Event as CustomEvent).detail));
    document.body.prepend(element);
  }, attributes);
};
const own = <T>(page: Page, run: (element: Embed) => T | Promise<T>) =>
  page.evaluate(
    (text) => (new Function(`return (${text})(document.getElementById("own"))`) as () => unknown)(),
    run.toString(),
  ) as Promise<T>;
const told = (page: Page) => page.evaluate(() => (window as unknown as { told: unknown[] }).told) as Promise<Told[]>;
const outcome = (page: Page, call: "ready" | "settled" | "plan") =>
  page.evaluate(async (name) => {
    const element = document.getElementById("own") as Embed;
    const value = element[name];
    return Promise.race([
      Promise.resolve(typeof value === "function" ? (value as () => unknown).call(element) : value).then(
        () => "resolved",
        (error: Error) => error.message,
      ),
      new Promise((done) => setTimeout(done, 20_000, "pending")),
    ]);
  }, call);

test.beforeEach(async ({ page }) => {
  // The pages' policy allows no `eval`, which the helpers use.
  await page.route("**/host/three.html", async (route) => {
    const answer = await route.fetch();
    await route.fulfill({ response: answer, body: (await answer.text()).replace(/<meta http-equiv[^>]*>/, "") });
  });
});

for (const [attribute, value] of [
  ["scene", "perpendiclar"],
  ["src", "nowhere.json"],
] as const) {
  test(`a wrong ${attribute} settles every promise with one error, and a valid one takes its place`, async ({
    page,
  }) => {
    await add(page, { [attribute]: value });
    const message = await outcome(page, "ready");
    expect(message).toMatch(new RegExp(`^${attribute}: must be .*got "${value}"$`));
    expect(await outcome(page, "settled")).toBe(message);
    expect(await outcome(page, "plan")).toBe(message);
    expect(await told(page)).toEqual([
      { code: "value", field: attribute, value, rule: expect.stringMatching(/^must be/), message },
    ]);
    await own(page, (element) => element.setAttribute("scene", "parallel"));
    expect(await outcome(page, "settled")).toBe("resolved");
    expect(await own(page, (element) => element.sceneData.name)).toMatch(/parallel/i);
    expect(await told(page)).toHaveLength(1);
    await own(page, (element) => element.setAttribute("scene", "nope"));
    await expect
      .poll(async () => (await told(page)).slice(1))
      .toEqual([expect.objectContaining({ code: "value", field: "scene", value: "nope" })]);
  });
}

test("a scene that is set mends a wrong one", async ({ page }) => {
  await add(page, { scene: "nope" });
  await outcome(page, "ready");
  await page.evaluate(async () => {
    const element = document.getElementById("own") as Embed;
    const scene = {
      version: 1,
      name: "Mine",
      map: { origin: [0, 0], width: 40, height: 30, resolution: 0.5 },
      start: { x: 3, y: 7, heading: 0 },
      goal: { x: 15, y: 7, heading: 0 },
    };
    // As Vue wraps what is reactive.
    const wrap = (value: object): object =>
      new Proxy(value, {
        get: (target, key) => {
          const one = Reflect.get(target, key) as unknown;
          return typeof one === "object" && one !== null ? wrap(one) : one;
        },
      });
    await (element["setScene"] as (scene: object) => Promise<void>)(wrap(scene));
  });
  expect(await own(page, (element) => Object.values(element.results).map((plan) => plan?.outcome))).toEqual(["found"]);
  expect(await own(page, (element) => element.sceneData.name)).toBe("Mine");
});

test("an element that is moved keeps its drawing, and undefined attributes are those that are not there", async ({
  page,
}) => {
  await add(page, {});
  await outcome(page, "settled");
  const start = await own(page, async (element) => {
    await (element["setScene"] as (scene: object) => Promise<void>)({
      ...element.sceneData,
      start: { x: 4, y: 8, heading: 0 },
      name: "Moved",
    });
    document.querySelector("h1")!.after(element);
    const box = document.createElement("div");
    document.body.append(box);
    box.append(element);
    (element as unknown as { planners: unknown }).planners = undefined;
    (element as unknown as { layout: unknown }).layout = undefined;
    await (element["plan"] as () => Promise<void>)();
    return [element.sceneData.name, element.sceneData.start.x];
  });
  expect(start).toEqual(["Moved", 4]);
  expect(await told(page)).toEqual([]);
});

test("events with names of others stay at the element", async ({ page }) => {
  await page.addInitScript(() => {
    const heard: string[] = [];
    Object.assign(window, { heard });
    window.onerror = () => void heard.push("onerror");
    for (const name of ["error", "select", "progress"])
      addEventListener(name, (event) => {
        if (event instanceof CustomEvent) heard.push(name);
      });
  });
  await add(page, { layout: "gird", controls: "non" });
  await outcome(page, "ready");
  expect((await told(page)).map(({ code, field, value }) => [code, field, value])).toEqual([
    ["value", "layout", "gird"],
    ["value", "controls", "non"],
  ]);
  expect(await page.evaluate(() => (window as unknown as { heard: string[] }).heard)).toEqual([]);
});

for (const [host, dark, light] of [
  [
    "VitePress",
    'document.documentElement.className = "dark"',
    'document.documentElement.className = ""; document.body.style.background = "white"',
  ],
  [
    "Docusaurus and Starlight",
    'document.documentElement.dataset.theme = "dark"',
    'document.documentElement.dataset.theme = "light"',
  ],
  [
    "Material for MkDocs",
    'document.body.dataset.mdColorScheme = "slate"',
    'document.body.dataset.mdColorScheme = "default"',
  ],
  ["mdBook", 'document.documentElement.className = "navy"', 'document.documentElement.className = "rust"'],
  [
    "color-scheme",
    'document.documentElement.style.colorScheme = "dark"',
    'document.documentElement.style.colorScheme = "light"',
  ],
] as const) {
  test(`theme="auto" follows the switch of ${host}`, async ({ page }) => {
    const scheme = () => own(page, (element) => getComputedStyle(element).colorScheme);
    for (const system of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme: system });
      await add(page, { theme: "auto" });
      await outcome(page, "ready");
      for (const [code, expected] of [
        [dark, "dark"],
        [light, "light"],
        [dark, "dark"],
      ] as const) {
        await page.evaluate(code);
        await expect.poll(scheme).toBe(expected);
      }
      await own(page, (element) => element.setAttribute("theme", "light"));
      await expect.poll(scheme).toBe("light");
    }
  });
}

test("an element is as wide as its place on a phone, and a height alone leaves it so", async ({ page }) => {
  for (const width of [320, 375, 768]) {
    await page.setViewportSize({ width, height: 700 });
    await add(page, {});
    await page.evaluate(() => {
      document.body.style.cssText = "display: flex; flex-direction: column; align-items: start";
    });
    const box = () =>
      own(page, (element) => {
        const { width: w, height: h } = element.getBoundingClientRect();
        return [Math.round(w), Math.round(h)];
      });
    const inside = await page.evaluate(() => document.body.clientWidth);
    expect(await box()).toEqual([inside, Math.max(280, Math.round((inside * 7) / 12))]);
    await own(page, (element) => {
      element.style.height = "300px";
    });
    expect(await box()).toEqual([inside, 300]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  }
});

for (const holder of ["script", "template", "pre"] as const) {
  test(`a scene of the page's own stands in a ${holder}`, async ({ page }) => {
    await page.goto(HOST);
    const name = await page.evaluate(async (tag) => {
      const map = { origin: [0, 0], width: 40, height: 30, resolution: 0.5 };
      const scene = {
        version: 1,
        name: `In a ${tag}`,
        map,
        start: { x: 3, y: 7, heading: 0 },
        goal: { x: 15, y: 7, heading: 0 },
      };
      const type = tag === "script" ? ' type="application/json"' : "";
      const host = document.createElement("div");
      host.innerHTML =
        `<parkade-playground loading="eager" controls="none" ` +
        `layout="single"><${tag}${type} slot="scene" hidden>${JSON.stringify(scene)}</${tag}></parkade-playground>`;
      document.body.prepend(host);
      const element = host.firstElementChild as Embed;
      await element.ready;
      return element.sceneData.name;
    }, holder);
    expect(name).toBe(`In a ${holder}`);
  });
}
