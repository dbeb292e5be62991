import { expect, test, type Page } from "@playwright/test";
import type { Goal, GoalSet, Plan, Scenario } from "parkade";
import {
  complaintsOf,
  look,
  onScreen,
  open,
  sceneOf,
  settled,
  type PlaygroundElement,
  type Untyped,
} from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

/** A row of slots of which `a` is taken. */
const lot = (goal: Goal | GoalSet): Scenario => ({
  version: 1,
  map: { origin: [0, 0], width: 88, height: 36, resolution: 0.5 },
  vehicle: "sedan",
  obstacles: [],
  slots: ["a", "b", "c", "d"].map((id, i) => ({
    id,
    kind: "perpendicular",
    x: 10 + 8 * i,
    y: 6,
    heading: -Math.PI / 2,
    width: 3,
    length: 5.5,
    occupied: id === "a",
  })),
  start: { x: 4, y: 9, heading: 0 },
  goal,
});
const FREE: GoalSet = { slots: "free", entry: "either" };

const taken = (page: Page): Promise<Record<string, Plan["goal"]>> =>
  page.evaluate(() => {
    const { results } = document.querySelector<PlaygroundElement>("parkade-playground")!;
    return Object.fromEntries(Object.entries(results).map(([planner, plan]) => [planner, plan?.goal]));
  });

async function show(page: Page, scene: Scenario): Promise<void> {
  await page.evaluate(async (given) => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = given;
    // The first module is exchanged for the complete one where that has not come yet.
    while (JSON.stringify(element.sceneData.goal) !== JSON.stringify(given.goal))
      await new Promise(requestAnimationFrame);
  }, scene);
  await settled(page);
}

/** What a map shows at a place, of the planner in front. */
async function colourAt(page: Page, x: number, y: number): Promise<string> {
  const at = await onScreen(page, x, y),
    side = 4;
  return (
    await page.screenshot({ clip: { x: at.x - side / 2, y: at.y - side / 2, width: side, height: side } })
  ).toString("base64");
}

const chooseGoal = (page: Page): Promise<void> =>
  page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ selection: { kind: "goal" } }),
  );

test("any free slot is led to by every planner, its slot is coloured, and undo and redo know it", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await show(page, lot(FREE));
  for (const [planner, goal] of Object.entries(await taken(page))) expect(goal?.slot, planner).toBe("b");
  await look(page, 22, 9, 12);
  // Beside the car, within the slot: coloured there, not in another one.
  const [inTaken, inOther] = [await colourAt(page, 16.8, 5.6), await colourAt(page, 32.8, 5.6)];
  expect(inTaken).not.toBe(inOther);
  await page.evaluate(() => {
    const { store } = document.querySelector<PlaygroundElement>("parkade-playground")! as Untyped,
      { scene } = store.state;
    store.edit({
      ...scene,
      slots: scene.slots.map((slot: { id: string }) => (slot.id === "b" ? { ...slot, occupied: true } : slot)),
    });
  });
  await settled(page);
  expect((await taken(page))["hybrid"]?.slot).toBe("c");
  expect(await colourAt(page, 32.8, 5.6)).toBe(inOther);
  await page.keyboard.press("Control+z");
  await settled(page);
  expect([(await sceneOf(page)).goal, (await taken(page))["hybrid"]?.slot]).toEqual([FREE, "b"]);
  expect(complaints).toEqual([]);
});

test("sets of goals come by link, by file and over a reload, before all planners are there", async ({
  page,
  context,
}) => {
  await open(page);
  const region: GoalSet = {
    region: [
      [20, 7],
      [40, 7],
      [40, 17],
      [20, 17],
    ],
    heading: 0,
  };
  for (const goal of [
    FREE,
    region,
    [
      { x: 40, y: 9, heading: 0 },
      { x: 20, y: 9, heading: 0 },
    ],
  ]) {
    await show(page, lot(goal));
    const link = (await page.evaluate(() =>
      document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL(),
    ))!;
    const other = await context.newPage(),
      complaints = complaintsOf(other);
    await other.goto(link);
    await settled(other);
    expect((await sceneOf(other)).goal).toEqual(goal);
    expect((await taken(other))["hybrid"]).toEqual((await taken(page))["hybrid"]);
    expect(complaints).toEqual([]);
    await other.close();
  }
  await page
    .locator("parkade-playground input[type=file]")
    .setInputFiles({ name: "lot.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(lot(FREE))) });
  await expect.poll(async () => (await sceneOf(page)).goal).toEqual(FREE);
  // The tab has kept this very scene, not only one before it.
  const kept = () =>
    page.evaluate(() => {
      const { hash, at, scenes, parts } = JSON.parse(sessionStorage.getItem("parkade.history") ?? "{}");
      return hash === location.hash && parts[scenes[at].goal];
    });
  await expect.poll(kept).toEqual(FREE);
  await page.reload();
  await settled(page);
  expect((await sceneOf(page)).goal).toEqual(FREE);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => Array.isArray((await sceneOf(page)).goal)).toBe(true);
});

test("the goal's card asks for one place, any free slot or a region", async ({ page }) => {
  await open(page);
  await show(page, lot({ slot: "c", entry: "head-in" }));
  await chooseGoal(page);
  const card = page.locator("parkade-goal"),
    goal = async (): Promise<unknown> => (await sceneOf(page)).goal;
  await card.getByRole("button", { name: "Any free slot" }).click();
  expect(await goal()).toEqual(FREE);
  await settled(page);
  await card.getByRole("button", { name: "Head-in" }).click();
  expect(await goal()).toEqual({ slots: "free", entry: "head-in" });
  await settled(page);
  await card.getByRole("button", { name: "One", exact: true }).click();
  expect(await goal()).toEqual({ slot: "b", entry: "head-in" });
  await card.getByRole("button", { name: "Region" }).click();
  const region = (await goal()) as { region: unknown[] };
  expect(region.region).toHaveLength(4);
  await settled(page);
  await card.getByLabel("Nose as shown").check();
  expect(Object.keys((await goal()) as object)).toEqual(["region", "heading"]);
  await settled(page);
  expect((await taken(page))["hybrid"]).toBeDefined();
  // The goal car is grabbed where it is shown, and is one goal again where it is dragged to.
  const { pose } = (await taken(page))["hybrid"]!;
  await look(page, 22, 9, 12);
  const [from, to] = [await onScreen(page, pose.x, pose.y), await onScreen(page, pose.x + 1, pose.y + 6)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
  expect(Object.keys((await goal()) as object).sort()).toEqual(["heading", "x", "y"]);
});

test("the menu on the map makes sets of slots, of places and of regions, and leads out of a slot", async ({ page }) => {
  await open(page);
  await show(page, {
    ...lot({ slot: "b", entry: "reverse-in" }),
    obstacles: [{ type: "rectangle", id: "r", center: [38, 14], size: [8, 6], heading: 0 }],
    start: { x: 26, y: 1.5, heading: Math.PI / 2 },
  });
  await look(page, 22, 9, 12);
  const menu = async (x: number, y: number, name: string): Promise<Scenario["goal"]> => {
    const at = await onScreen(page, x, y);
    await page.mouse.click(at.x, at.y, { button: "right" });
    await page.getByRole("menuitem", { name, exact: true }).click();
    await settled(page);
    return (await sceneOf(page)).goal;
  };
  expect(await menu(34, 3, "Or this slot")).toEqual({ slots: ["b", "d"], entry: "either" });
  expect(await menu(38, 14, "Make it the goal region")).toEqual({
    region: [
      [34, 11],
      [42, 11],
      [42, 17],
      [34, 17],
    ],
  });
  expect((await sceneOf(page)).obstacles).toEqual([]);
  const places = (await menu(10, 12, "Or goal here")) as Pose[];
  expect([places.length, Math.round(places[1]!.x), Math.round(places[1]!.y)]).toEqual([2, 10, 12]);
  expect(await menu(26, 3, "Leave the slot")).toHaveProperty("region");
  expect((await taken(page))["hybrid"]).toBeDefined();
});

interface Pose {
  x: number;
  y: number;
  heading: number;
}

test("the words of sets of goals are Chinese where the page is", async ({ browser }) => {
  const page = await browser.newPage({ locale: "zh-CN", viewport: { width: 1400, height: 900 } });
  await open(page);
  await show(page, lot(FREE));
  await chooseGoal(page);
  await expect(page.locator("parkade-goal button[aria-pressed=true]")).toHaveText(["任意空车位", "皆可"]);
  await page.close();
});
