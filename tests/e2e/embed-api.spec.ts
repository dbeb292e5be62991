import { expect, test } from "@playwright/test";
import type { Scenario } from "parkade";
import { HOST, near, watch, type Embed } from "./embed";

test("keys that the playground uses do not reach the page's own", async ({ page }) => {
  await watch(page);
  await page.goto(HOST);
  await near(page, "one");
  await page.locator("#one").getByRole("button", { name: "Tap to edit" }).click();
  await page.evaluate(() => {
    const heard: string[] = [];
    (window as unknown as { heard: string[] }).heard = heard;
    document.addEventListener("keydown", (event) => heard.push(event.key));
  });
  const heard = () => page.evaluate(() => (window as unknown as { heard: string[] }).heard.splice(0));
  const slider = page.locator("#one").locator("parkade-timeline").getByRole("slider").first();
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  expect(await heard()).toEqual([]);
  await page.keyboard.press("j");
  expect(await heard()).toEqual(["j"]);
  await page
    .locator("#one")
    .locator("canvas")
    .first()
    .click({ position: { x: 40, y: 40 } });
  await page.keyboard.press("b");
  expect(await heard()).toEqual([]);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press("b");
  expect(await heard()).toEqual(["b"]);
});

test("properties set before the element is there are kept", async ({ page }) => {
  await watch(page);
  await page.route("**/parkade-playground.js", async (route) => {
    await page.evaluate(() => {
      const element = document.getElementById("one") as Embed;
      element.sceneData = {
        version: 1,
        name: "Early",
        map: { origin: [0, 0], width: 40, height: 30, resolution: 0.5 },
        start: { x: 3, y: 7, heading: 0 },
        goal: { x: 15, y: 7, heading: 0 },
      };
    });
    await route.continue();
  });
  await page.goto(HOST);
  await near(page, "one");
  await expect.poll(() => page.evaluate(() => (document.getElementById("one") as Embed).sceneData.name)).toBe("Early");
});

test("every method and event of the element does what it says", async ({ page }) => {
  await watch(page);
  await page.goto(HOST);
  const said = await page.evaluate(async () => {
    const element = document.getElementById("two") as Embed;
    const heard: Record<string, unknown[]> = {};
    const names = [
      "ready",
      "scene-change",
      "plan-start",
      "plan-progress",
      "plan-result",
      "plan-complete",
      "seek",
      "select",
      "error",
      "progress",
      "visibility",
    ];
    for (const name of names)
      element.addEventListener(name, (event) => (heard[name] ??= []).push((event as CustomEvent).detail));
    const call = <T>(name: string, ...args: unknown[]) =>
      (element[name] as (...given: unknown[]) => Promise<T>)(...args);
    await call("settled");
    element.scrollIntoView();
    const first = await call<Scenario>("getScene");
    const moved = { ...first, name: "Moved", start: { ...first.start, x: first.start.x + 0.5 } };
    await call("setScene", moved);
    const undone = element.canUndo;
    await call("undo");
    const back = (await call<Scenario>("getScene")).start.x === first.start.x && element.canRedo;
    await call("redo");
    element.params = { hybrid: { reverseCost: 3 } };
    await call("plan");
    const params = (await call<Scenario>("getScene")).planners?.hybrid;
    await call("reset");
    element.playhead = 0.25;
    const playhead = element.playhead;
    await call("seek", 0.5, { base: "drive" });
    await call("play");
    await call("pause");
    element.camera = { x: 5, y: 5, scale: 20 };
    const camera = element.camera;
    await call("fit");
    const svg = await call<string>("toSVG"),
      csv = await call<string>("toCSV"),
      blob = await call<Blob>("toBlob", { type: "image/webp" }),
      url = await call<string>("shareURL");
    await call("cancel");
    const refused = await call("setScene", { version: 1 }).then(
      () => "taken",
      (error: Error) => error.message,
    );
    const undrivable = await call("setScene", { ...moved, vehicle: { wheelbase: -1 } }).then(
      () => "taken",
      (error: Error) => error.message,
    );
    return {
      heard,
      undone,
      back,
      params,
      playhead,
      camera,
      fitted: element.camera,
      svg: svg.slice(0, 4),
      csv: csv.split("\n")[0],
      blob: blob.type,
      url,
      refused,
      undrivable,
      after: (await call<Scenario>("getScene")).vehicle,
      before: moved.vehicle,
      loaded: element.loaded,
      moved: moved.start.x,
    };
  });
  const { heard } = said;
  expect(said).toMatchObject({
    undone: true,
    back: true,
    params: { reverseCost: 3 },
    playhead: 0.25,
    camera: { x: 5, y: 5, scale: 20 },
    svg: "<svg",
    csv: "s,x,y,theta,kappa,clearance,v,direction,t",
    blob: "image/webp",
    loaded: true,
  });
  expect(said.url).toMatch(/\/sub\/path\/index\.html#s=/);
  expect([said.refused, said.undrivable]).toEqual([
    expect.stringContaining("map: missing field"),
    expect.stringContaining("vehicle.width: missing field"),
  ]);
  expect(said.after).toEqual(said.before);
  expect(Object.keys(heard).sort()).toEqual([
    "error",
    "plan-complete",
    "plan-progress",
    "plan-result",
    "plan-start",
    "progress",
    "ready",
    "scene-change",
    "seek",
    "visibility",
  ]);
  expect(heard["progress"]!.at(-1)).toEqual({ totalProgress: 1 });
  expect((heard["scene-change"] as { reason: string; transient: boolean }[]).map(({ reason }) => reason)).toEqual(
    expect.arrayContaining(["open", "undo", "redo", "params"]),
  );
  expect((heard["plan-result"] as { planner: string }[]).map(({ planner }) => planner)).toEqual(
    expect.arrayContaining(["eight", "hybrid"]),
  );
  expect((heard["plan-progress"] as { expansions: number }[])[0]!.expansions).toBeGreaterThan(0);
  expect(heard["plan-complete"]!.at(-1)).toMatchObject({
    id: expect.any(Number),
    results: { hybrid: { outcome: "found" } },
  });
  expect(await page.evaluate(() => [...document.styleSheets].map(({ href }) => href))).toEqual([
    expect.stringMatching(/\/host\/page\.css$/),
  ]);
  expect(heard["error"]!.at(-1)).toMatchObject({
    code: "bad-scenario",
    field: "vehicle.width",
    message: expect.stringContaining("vehicle.width: missing field"),
  });
});
