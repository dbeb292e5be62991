import { execFileSync } from "node:child_process";
import { rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test, type Page } from "@playwright/test";
import type { Plan } from "parkade";
import { installed } from "../js/pack";
import { HOST, near, watch, type Embed } from "./embed";
import { open, type PlaygroundElement, sceneOf } from "./playground";

test("planners tell how far they are while they search, and nothing of a scene that is no longer there", async ({
  page,
}) => {
  await watch(page);
  await page.goto(HOST);
  const heard = await page.evaluate(async () => {
    type Told = { planner: string; expansions: number; plan?: Plan };
    const element = document.getElementById("two") as Embed;
    const call = <T>(name: string, ...args: unknown[]) =>
      (element[name] as (...given: unknown[]) => Promise<T>)(...args);
    element.setAttribute("planners", "four eight risk-field hybrid");
    element.scrollIntoView();
    await call("settled");
    // Brings the complete module, which plans again what the small one has planned, with counts of its own.
    await call("toSVG");
    await call("settled");
    // A way out of a dead end to a narrow slot beside a narrow aisle: long for grids and for cars.
    const slow = {
      version: 1,
      vehicle: "paper",
      start: { x: 0, y: 20, heading: Math.PI / 2 },
      goal: { x: -2.25, y: 3.5, heading: Math.PI },
      map: {
        origin: [-25, 0],
        width: 500,
        height: 400,
        resolution: 0.1,
        boundary: [
          [-25, 5],
          [-8, 5],
          [-8, 2],
          [0, 2],
          [0, 5],
          [25, 5],
          [25, 40],
          [-25, 40],
        ],
      },
      obstacles: [
        {
          type: "wall",
          points: [
            [-20, 34],
            [-20, 9],
            [20, 9],
            [20, 34],
          ],
          thickness: 0.2,
        },
      ],
      planners: { hybrid: { maxExpansions: 1500 } },
    };
    const quick = {
      version: 1,
      map: { origin: [0, 0], width: 40, height: 30, resolution: 0.5 },
      start: { x: 3, y: 7, heading: 0 },
      goal: { x: 15, y: 7, heading: 0 },
    };
    const told: Record<string, number[]> = {},
      expanded: Record<string, number> = {},
      late: Told[] = [];
    const note = (event: Event) => {
      const { planner, expansions, plan } = (event as CustomEvent<Told>).detail;
      if (plan) expanded[planner] = plan.stats.expanded;
      else if (expanded[planner] !== undefined) late.push({ planner, expansions });
      else (told[planner] ??= []).push(expansions);
    };
    for (const name of ["plan-progress", "plan-result"]) element.addEventListener(name, note);
    await call("setScene", slow);
    for (const name of ["plan-progress", "plan-result"]) element.removeEventListener(name, note);
    const begun = new Promise((done) => element.addEventListener("plan-progress", done, { once: true }));
    void call("setScene", { ...slow, start: { ...slow.start, x: 1 } });
    await begun;
    const after: number[] = [];
    element.addEventListener(
      "scene-change",
      () =>
        element.addEventListener("plan-progress", (event) =>
          after.push((event as CustomEvent<Told>).detail.expansions),
        ),
      { once: true },
    );
    await call("setScene", quick);
    return { told, expanded, late, after };
  });
  expect(Object.keys(heard.expanded).sort()).toEqual(["eight", "four", "hybrid", "risk-field"]);
  for (const [planner, expanded] of Object.entries(heard.expanded)) {
    // What a frame does not show is not told: some multiples, in their order, and the answer's own number.
    const every = planner === "hybrid" ? 256 : 16_384,
      told = heard.told[planner] ?? [];
    expect(expanded).toBeGreaterThan(2 * every);
    expect(told.at(-1)).toBe(expanded);
    expect(told).toEqual([...new Set(told)].sort((a, b) => a - b));
    expect(told.slice(0, -1).filter((count) => count % every !== 0)).toEqual([]);
  }
  expect(heard.late).toEqual([]);
  expect(heard.after.length).toBeGreaterThan(3);
  expect(Math.max(...heard.after)).toBeLessThan(16_384);
});

test("a plan that takes longer than its budget is given up, in words", async ({ page }) => {
  await watch(page);
  await page.goto(HOST);
  const message = await page.evaluate(async () => {
    const element = document.getElementById("one") as Embed;
    await (element["settled"] as () => Promise<void>)();
    element.setAttribute("budget-ms", "1");
    const stopped = new Promise<{ code: string; message: string }>((done) =>
      element.addEventListener("error", (event) => done((event as unknown as CustomEvent).detail)),
    );
    // The circle inside the car's fits round the corner, the car does not: the search looks everywhere, for seconds.
    const walls = [
      [47, 29.5, 14, 1],
      [45.4, 36.2, 10.8, 8],
      [53.5, 36, 1, 12],
      [52.4, 42.5, 3.2, 1],
    ];
    void (element["setScene"] as (scene: unknown) => Promise<void>)({
      version: 1,
      map: { origin: [0, 0], width: 120, height: 120, resolution: 0.5 },
      vehicle: "sedan",
      obstacles: walls.map(([x, y, ...size], k) => ({
        type: "rectangle",
        id: `wall-${k}`,
        center: [x, y],
        size,
        heading: 0,
      })),
      start: { x: 10, y: 10, heading: 0 },
      goal: { x: 51.9, y: 36, heading: Math.PI / 2 },
    });
    return stopped;
  });
  expect(message).toEqual({ code: "interrupted", message: expect.stringContaining("stopped after 1 ms") });
});

test("a playground out of sight rests, and goes on when it is back", async ({ page }) => {
  await watch(page);
  await page.goto(HOST);
  await near(page, "one");
  const at = () => page.evaluate(() => (document.getElementById("one") as Embed).playhead);
  await page.evaluate(async () => {
    const element = document.getElementById("one") as Embed;
    await (element["seek"] as (to: number) => Promise<void>)(0.01);
    await (element["play"] as () => Promise<void>)();
    scrollTo(0, document.body.scrollHeight);
  });
  await page.waitForTimeout(300);
  const rest = await at();
  await page.waitForTimeout(300);
  expect(await at()).toBe(rest);
  await near(page, "one");
  await expect.poll(at).toBeGreaterThan(rest);
});

test.describe("what the page copies to paste elsewhere", () => {
  const copied = async (page: Page, name: string): Promise<string> => {
    const read = () => page.evaluate(() => navigator.clipboard.readText());
    await page.evaluate(() => navigator.clipboard.writeText(""));
    await page.getByRole("button", { name: "Export" }).click();
    await page.getByRole("button", { name }).click();
    await expect.poll(read).not.toBe("");
    await expect(page.getByRole("alert")).toContainText("Copied");
    return read();
  };

  test("code to embed, a Markdown link and a Node test work where they are pasted", async ({ page, context }) => {
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    await open(page);
    const name = 'A "name" </script> [x]';
    await page.evaluate(async (given) => {
      const element = document.querySelector("parkade-playground") as Embed;
      element.sceneData = { ...element.sceneData, name: given };
      await (element["settled"] as () => Promise<void>)();
    }, name);
    const code = await copied(page, "Copy embed code"),
      link = await copied(page, "Copy Markdown link"),
      script = await copied(page, "Copy as Node test");
    // A better path may stand in the answer's place by then.
    const answer = await page.evaluate(() => {
      const { hybrid } = document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.results;
      return ((hybrid!.chosen && hybrid!.ordinary) ?? hybrid!.plan)!.hash;
    });

    const [, href] = /^\[A "name" <\/script> \\\[x\\\]\]\((.*)\)$/.exec(link)!;
    await page.goto(href!);
    await page.evaluate(() => (document.querySelector("parkade-playground") as Embed).ready);
    expect((await sceneOf(page)).name).toBe(name);

    await page.route("**/host/pasted.html", (route) =>
      route.fulfill({ contentType: "text/html", body: `<!doctype html><title>Pasted</title>${code}` }),
    );
    await page.goto("/host/pasted.html");
    await page.evaluate(() => (document.querySelector("parkade-playground") as Embed).ready);
    expect(await page.evaluate(() => (document.querySelector("parkade-playground") as Embed).sceneData.name)).toBe(
      name,
    );

    const folder = installed();
    writeFileSync(join(folder, "pasted.test.mjs"), script);
    const out = execFileSync(process.execPath, ["--test", "--test-reporter=tap", "pasted.test.mjs"], {
      cwd: folder,
      encoding: "utf8",
    });
    rmSync(folder, { recursive: true, force: true });
    expect(out).toMatch(/^# pass 1$/m);
    expect(script).toContain(answer);
  });
});
