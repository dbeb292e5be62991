import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, hashesOf, open, sceneOf, settled, type PlaygroundElement } from "./playground";

const outcomes = (page: Page) =>
  page.evaluate(() =>
    Object.values(document.querySelector<PlaygroundElement>("parkade-playground")!.results).map(
      (plan) => plan?.outcome,
    ),
  );
const gate = () => {
  let open = (): void => undefined;
  const opened = new Promise<void>((done) => {
    open = done;
  });
  return { open, opened };
};
const FOUND = ["found", "found", "found", "found"];

for (const [state, prepare] of [
  [
    "refused",
    () => {
      for (const name of ["localStorage", "sessionStorage", "indexedDB", "caches"]) {
        Object.defineProperty(window, name, {
          get() {
            throw new DOMException("denied", "SecurityError");
          },
        });
      }
    },
  ],
  [
    "full",
    () => {
      Storage.prototype.setItem = IDBObjectStore.prototype.put = () => {
        throw new DOMException("full", "QuotaExceededError");
      };
    },
  ],
] as const) {
  test(`with its storage ${state} the page plans, edits and takes back as ever`, async ({ page }) => {
    const complaints = complaintsOf(page);
    await page.addInitScript(prepare);
    await open(page);
    await settled(page);
    expect(await outcomes(page)).toEqual(FOUND);
    const before = await sceneOf(page);
    await page.evaluate(() => {
      const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
      element.sceneData = { ...element.sceneData, start: { ...element.sceneData.start, x: 19 } };
    });
    await settled(page);
    await page.keyboard.press("Control+z");
    await settled(page);
    expect(await sceneOf(page)).toEqual(before);
    expect(complaints.filter((text) => !text.startsWith("Service Worker registration blocked"))).toEqual([]);
  });
}

test("where modules are forbidden the page says so", async ({ page }) => {
  await page.addInitScript(() => {
    const refuse = () => Promise.reject(new WebAssembly.CompileError("forbidden by the policy"));
    Object.assign(WebAssembly, {
      instantiate: refuse,
      instantiateStreaming: refuse,
      compile: refuse,
      compileStreaming: refuse,
    });
  });
  await page.goto("./");
  await expect(page.locator("parkade-notices").getByRole("alert")).toContainText(
    "The planners failed to load: forbidden by the policy",
  );
});

test("where workers are forbidden the page says so", async ({ page }) => {
  await page.addInitScript(() => {
    window.Worker = class {
      constructor() {
        throw new DOMException("workers are forbidden", "SecurityError");
      }
    } as unknown as typeof Worker;
  });
  await page.goto("./");
  await expect(page.locator("parkade-notices").getByRole("alert")).toContainText(
    "The planners failed to load: workers are forbidden",
  );
});

test("a network that goes while the page loads is said, and the page goes on by itself when it is back", async ({
  page,
}) => {
  let down = true;
  await page.route("**/*.wasm", (route) => (down ? route.abort() : route.continue()));
  await page.goto("./");
  await expect(page.locator("parkade-notices").getByRole("alert")).toContainText("The planners failed to load");
  down = false;
  await page.evaluate(() => dispatchEvent(new Event("online")));
  await expect.poll(() => outcomes(page), { timeout: 30_000 }).toEqual(FOUND);
  await expect(page.locator("parkade-notices").getByRole("alert")).not.toContainText("loaded");
});

test("an inspector whose code comes late, and its room later still, shows the scene of now", async ({ page }) => {
  // First the page without its inspector's code, then that code, then the planners, then room.
  const code = gate(),
    planners = gate();
  await page.route("**/inspector-*.js", (route) => code.opened.then(() => route.continue()));
  await page.route("**/*.wasm", (route) => planners.opened.then(() => route.continue()));
  await page.setViewportSize({ width: 900, height: 800 });
  await page.goto("./", { waitUntil: "commit" });
  await page.locator("parkade-inspector").waitFor({ state: "attached" });
  expect(await page.evaluate(() => customElements.get("parkade-inspector") === undefined)).toBe(true);
  code.open();
  await page.evaluate(() => customElements.whenDefined("parkade-inspector").then(() => undefined));
  expect(
    await page.locator("parkade-inspector").evaluate((element) => (element as HTMLElement & { ready: boolean }).ready),
  ).toBe(false);
  planners.open();
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  await expect(page.locator("parkade-inspector section")).toHaveCount(0);
  await page.setViewportSize({ width: 1400, height: 900 });
  await expect(page.locator("parkade-inspector").getByText("Wheelbase")).toBeVisible();
});

test("an embedded playground without its module says so in place of its poster, and goes on by itself", async ({
  page,
}) => {
  let down = true;
  await page.route("**/*.wasm", (route) => (down ? route.abort() : route.continue()));
  const figure = `<script type="module" src="./parkade-playground.js"></script>
    <parkade-playground poster="data:," alt="a car park" style="width: 720px; height: 420px"></parkade-playground>`;
  await page.route("**/figure.html", (route) =>
    route.fulfill({ contentType: "text/html", body: `<!doctype html>${figure}` }),
  );
  await page.goto("./figure.html");
  await expect(page.locator("parkade-notices").getByRole("alert")).toContainText("The planners failed to load");
  await expect(page.locator("parkade-playground .poster")).toHaveCount(0);
  await expect(page.locator("parkade-notices").getByRole("alert")).toBeVisible();
  down = false;
  await page.evaluate(() => dispatchEvent(new Event("online")));
  await expect.poll(() => outcomes(page), { timeout: 30_000 }).toEqual(FOUND);
  await expect(page.locator("parkade-notices").getByRole("alert")).not.toContainText("loaded");
});

test("a part of the page that does not arrive is said; everything else works", async ({ page }) => {
  await page.route("**/assets/inspector-*.js", (route) => route.abort());
  await open(page);
  await expect(page.locator("parkade-notices").getByRole("alert")).toContainText("Part of the page failed to load.");
  await expect.poll(() => outcomes(page)).toEqual(FOUND);
});

test("a trap inside a planner is said, and a new worker answers; the scene stays", async ({ page }) => {
  let asked = 0;
  await page.route("**/assets/engine-*.js", async (route) => {
    const mine = ++asked,
      response = await route.fetch(),
      text = await response.text();
    // The page's own copy comes first, then that of each worker: the first worker's planners trap.
    const trap =
      mine === 2
        ? `
      const real = WebAssembly.instantiate;
      WebAssembly.instantiate = async (module, imports) => {
        const { exports } = await real(module, imports), trap = () => { throw new ` +
          `WebAssembly.RuntimeError("unreachable"); };
        return { module, instance: { exports: { ...exports, ` +
          `...Object.fromEntries(Object.keys(exports).filter((name) => /plan$/.test(name)).map((name) => [name, ` +
          `trap])) } } };
      };`
        : "";
    await route.fulfill({ response, body: trap + text });
  });
  await open(page);
  const scene = await sceneOf(page);
  await expect.poll(() => outcomes(page), { timeout: 30_000 }).toEqual(FOUND);
  expect(asked).toBeGreaterThan(2);
  expect(await sceneOf(page)).toEqual(scene);
  const hashes = await hashesOf(page);
  await page.reload();
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  await settled(page);
  expect(await hashesOf(page)).toEqual(hashes);
  // The whole module's workers may still be coming.
  await page.unrouteAll({ behavior: "ignoreErrors" });
});
