import { expect, test, type Page } from "@playwright/test";
import type { Obstacle, Scenario } from "parkade";
import { click, drag, fillLot, fingers, fingerprint, openLot, type Spot } from "./hands.js";
import { complaintsOf, onScreen, sceneOf, settled, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 }, hasTouch: true });

const cells = (scene: Scenario): Set<string> =>
  new Set(
    (scene.obstacles ?? []).flatMap((one) =>
      one.type === "cells" ? one.runs.flatMap(([x, y, n]) => Array.from({ length: n }, (_, i) => `${x + i},${y}`)) : [],
    ),
  );
const kinds = (scene: Scenario): string[] => (scene.obstacles ?? []).map((one) => one.type);
const only = <Type extends Obstacle["type"]>(scene: Scenario, type: Type): Extract<Obstacle, { type: Type }> =>
  scene.obstacles!.find((one): one is Extract<Obstacle, { type: Type }> => one.type === type)!;
const selection = (page: Page): Promise<unknown> =>
  page.evaluate(
    () =>
      (
        document.querySelector<PlaygroundElement>("parkade-playground")!.store.state as unknown as {
          selection: unknown;
        }
      ).selection,
  );

/** Each tool: its key, the way it is drawn, and what must be there then. */
interface Tool {
  key: string;
  way: Spot[];
  corners?: boolean;
  before?: Partial<Scenario>;
  made(scene: Scenario): void;
}

const BOX: Obstacle = { type: "rectangle", id: "box", center: [20, 15], size: [2, 2], heading: 0 };
const TOOLS: Record<string, Tool> = {
  brush: {
    key: "b",
    way: [
      [16, 12],
      [24, 18],
    ],
    made: (scene) => expect(cells(scene).size).toBeGreaterThan(30),
  },
  wall: {
    key: "l",
    way: [
      [15, 15],
      [25, 15],
      [25, 20],
    ],
    corners: true,
    made: (scene) =>
      expect(only(scene, "wall").points).toEqual([
        [15, 15],
        [25, 15],
        [25, 20],
      ]),
  },
  rectangle: {
    key: "r",
    way: [
      [16, 13],
      [22, 17],
    ],
    made: (scene) => expect(only(scene, "rectangle")).toMatchObject({ center: [19, 15], size: [6, 4] }),
  },
  polygon: {
    key: "g",
    way: [
      [16, 13],
      [24, 13],
      [20, 18],
    ],
    corners: true,
    made: (scene) => expect(only(scene, "polygon").points).toHaveLength(3),
  },
  car: { key: "c", way: [[20, 15]], made: (scene) => expect(only(scene, "car").vehicle).toBe("sedan") },
  slot: {
    key: "p",
    way: [
      [14, 18],
      [25.5, 18],
    ],
    made: (scene) => expect(scene.slots).toHaveLength(4),
  },
  moving: {
    key: "m",
    way: [
      [14, 12],
      [26, 12],
    ],
    made: (scene) =>
      expect(scene.moving![0]!.points).toEqual([
        [14, 12],
        [26, 12],
      ]),
  },
  road: {
    key: "d",
    corners: true,
    way: [
      [14, 12],
      [26, 12],
    ],
    made: (scene) => expect(kinds(scene)).toEqual(["road"]),
  },
  cost: {
    key: "k",
    way: [
      [16, 12],
      [24, 18],
    ],
    made: (scene) => {
      expect(scene.costs).toHaveLength(1);
      expect(scene.costs![0]!.weight).toBe(5);
      expect(scene.costs![0]!.runs.reduce((sum, run) => sum + run[2], 0)).toBeGreaterThan(30);
      expect(scene.obstacles).toEqual([]);
    },
  },
  eraser: {
    key: "e",
    way: [
      [17, 15],
      [23, 15],
    ],
    before: { obstacles: [BOX] },
    made: (scene) => expect(kinds(scene)).toEqual([]),
  },
};

/** Draws with each tool in a fresh lot. */
async function withEach(page: Page, draw: (name: string, tool: Tool) => Promise<void>): Promise<void> {
  const complaints = complaintsOf(page);
  await openLot(page);
  for (const [name, tool] of Object.entries(TOOLS)) {
    await test.step(name, async () => {
      await fillLot(page, tool.before);
      await draw(name, tool);
      await settled(page);
      tool.made(await sceneOf(page));
    });
  }
  expect(complaints).toEqual([]);
}

test("each tool draws by mouse", async ({ page }) => {
  await withEach(page, async (_, tool) => {
    await page.keyboard.press(tool.key);
    if (tool.corners) {
      for (const spot of tool.way) await click(page, spot);
      await page.keyboard.press("Enter");
    } else if (tool.way.length === 1) await click(page, tool.way[0]!);
    else await drag(page, tool.way);
  });
});

test("each tool draws by touch", async ({ page }) => {
  const order = ["v", "b", "l", "r", "g", "c", "p", "m", "d", "k", "e"];
  await withEach(page, async (_, tool) => {
    await page.locator("parkade-toolbar .tool").nth(order.indexOf(tool.key)).click();
    if (!tool.corners) return fingers(page, [tool.way]);
    // A wall ends on its last corner, a polygon on its first one.
    for (const spot of [...tool.way, tool.key === "g" ? tool.way[0]! : tool.way.at(-1)!]) await fingers(page, [[spot]]);
  });
});

test("each tool draws by keys", async ({ page }) => {
  // The first arrow takes the pointer from the middle of the view, later ones from where it is.
  let at: Spot = [20, 15];
  await withEach(page, async (name, tool) => {
    await page.keyboard.press(tool.key);
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowLeft");
    for (const spot of tool.way) {
      for (const [axis, more, less] of [
        [0, "ArrowRight", "ArrowLeft"],
        [1, "ArrowUp", "ArrowDown"],
      ] as const) {
        const steps = Math.round((spot[axis] - at[axis]) / 0.5);
        for (let n = 0; n < Math.abs(steps); n++) await page.keyboard.press(steps > 0 ? more : less);
      }
      at = spot;
      await page.keyboard.press("Enter");
    }
    if (tool.corners || name === "moving") await page.keyboard.press("Enter");
  });
});

test("painted cells cost what is painted, in every planner's answer; erased, undone and by a link they are as they were", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  await openLot(page, { start: { x: 6, y: 15.25, heading: 0 }, goal: { x: 34, y: 15.25, heading: 0 } });
  const plans = (): Promise<{ outcome: string; length: number; weighted: number | undefined }[]> =>
    page.evaluate(() => {
      const { results } = document.querySelector<PlaygroundElement>("parkade-playground")!;
      return Object.values(results).map((plan) => ({
        outcome: plan!.outcome,
        length: plan!.metrics.length,
        weighted: plan!.metrics.weightedLength,
      }));
    });
  for (const { length } of await plans()) expect(length).toBeCloseTo(28, 1);
  await page.keyboard.press("k");
  for (let n = 0; n < 5; n++) await page.keyboard.press("}");
  await drag(page, [
    [20, 13],
    [20, 20],
  ]);
  await settled(page);
  const painted = await sceneOf(page);
  expect(painted.costs!.map(({ weight }) => weight)).toEqual([10]);
  for (const { outcome, length, weighted } of await plans()) {
    expect(outcome).toBe("found");
    expect(length).toBeGreaterThan(28.2);
    expect(weighted).toBeLessThan(28 + 9);
  }
  await expect(page.locator("parkade-objects li", { hasText: "Painted cost ×10" })).toHaveCount(1);

  // The eraser and a weight of 1 take paint away.
  await page.keyboard.press("e");
  await drag(page, [
    [20, 12],
    [20, 14],
  ]);
  await page.keyboard.press("k");
  for (let n = 0; n < 9; n++) await page.keyboard.press("{");
  await drag(page, [
    [20, 16],
    [20, 21],
  ]);
  await settled(page);
  const left = (scene: Scenario): number =>
    (scene.costs ?? []).reduce((sum, { runs }) => sum + runs.reduce((all, run) => all + run[2], 0), 0);
  expect(left(await sceneOf(page))).toBeLessThan(left(painted));
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  expect(await sceneOf(page)).toEqual(painted);

  const link = await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL());
  await page.goto("about:blank");
  await page.goto(link!);
  await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.ready);
  expect((await sceneOf(page)).costs).toEqual(painted.costs);

  // A planner for which all cells cost the same says so; the others go on.
  await page.evaluate(() =>
    document
      .querySelector<PlaygroundElement>("parkade-playground")!
      .store.set({ planners: ["eight", "jump-point"], focus: "jump-point", mode: "grid" }),
  );
  await expect(page.locator("parkade-panel", { hasText: "cannot plan this scene" })).toContainText(
    "all free cells cost the same",
  );
  expect(complaints).toEqual([]);
});

test("a stroke at 3000 px/s leaves no holes", async ({ page }) => {
  await openLot(page);
  await page.keyboard.press("b");
  const from: Spot = [6, 8],
    to: Spot = [34, 22];
  const session = await page.context().newCDPSession(page);
  const a = await onScreen(page, ...from),
    b = await onScreen(page, ...to);
  const length = Math.hypot(b.x - a.x, b.y - a.y);
  // 60 events a second at 3000 px/s are 50 px apart.
  const steps = Math.ceil(length / 50);
  await session.send("Input.dispatchMouseEvent", { type: "mousePressed", ...a, button: "left", clickCount: 1 });
  for (let i = 1; i <= steps; i++) {
    await session.send("Input.dispatchMouseEvent", {
      type: "mouseMoved",
      x: a.x + ((b.x - a.x) * i) / steps,
      y: a.y + ((b.y - a.y) * i) / steps,
      button: "left",
      buttons: 1,
    });
  }
  await session.send("Input.dispatchMouseEvent", { type: "mouseReleased", ...b, button: "left", clickCount: 1 });
  await settled(page);
  const painted = cells(await sceneOf(page));
  for (let i = 0; i <= 1000; i++) {
    const x = from[0] + ((to[0] - from[0]) * i) / 1000,
      y = from[1] + ((to[1] - from[1]) * i) / 1000;
    expect(painted.has(`${Math.floor(x / 0.5)},${Math.floor(y / 0.5)}`), `${x} ${y}`).toBe(true);
  }
});

test("the right button erases while a drawing tool is in hand", async ({ page }) => {
  await openLot(page, { obstacles: [BOX] });
  await page.keyboard.press("b");
  await drag(
    page,
    [
      [17, 15],
      [23, 15],
    ],
    { button: "right" },
  );
  await settled(page);
  expect(kinds(await sceneOf(page))).toEqual([]);
});

test("a frame chooses what lies in it, Shift adds, arrows move the group, Alt copies it, Delete removes it", async ({
  page,
}) => {
  const box = (id: string, x: number): Obstacle => ({
    type: "rectangle",
    id,
    center: [x, 15],
    size: [1, 1],
    heading: 0,
  });
  await openLot(page, { obstacles: [box("a", 15), box("b", 18), box("c", 25)] });
  await drag(page, [
    [14, 13],
    [19.5, 17],
  ]);
  expect(await selection(page)).toEqual({ kind: "group", ids: ["a", "b"] });
  await page.keyboard.down("Shift");
  await click(page, [25, 15]);
  await page.keyboard.up("Shift");
  expect(await selection(page)).toEqual({ kind: "group", ids: ["a", "b", "c"] });
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Shift+ArrowRight");
  expect((await sceneOf(page)).obstacles!.map((one) => (one as typeof BOX & { center: Spot }).center)).toEqual([
    [16, 15.5],
    [19, 15.5],
    [26, 15.5],
  ]);
  await page.keyboard.down("Alt");
  await drag(page, [
    [16, 15.5],
    [16, 20.5],
  ]);
  await page.keyboard.up("Alt");
  const { obstacles } = await sceneOf(page);
  expect(obstacles).toHaveLength(6);
  expect(obstacles!.slice(3).map((one) => (one as { center: Spot }).center[1])).toEqual([20.5, 20.5, 20.5]);
  await page.keyboard.press("Delete");
  expect((await sceneOf(page)).obstacles).toHaveLength(3);
});

test("what is dragged falls in line with other things, and Ctrl leaves it alone", async ({ page }) => {
  await openLot(page, {
    obstacles: [BOX, { type: "rectangle", id: "free", center: [12.13, 22], size: [1.3, 1.3], heading: 0 }],
  });
  await drag(page, [
    [12.13, 22],
    [19.95, 22.1],
  ]);
  expect(
    only({ ...(await sceneOf(page)), obstacles: (await sceneOf(page)).obstacles!.slice(1) }, "rectangle").center[0],
  ).toBeCloseTo(20, 6);
  await page.keyboard.press("Control+z");
  await page.keyboard.down("Control");
  await drag(page, [
    [12.13, 22],
    [19.93, 22.13],
  ]);
  await page.keyboard.up("Control");
  const center = only(
    { ...(await sceneOf(page)), obstacles: (await sceneOf(page)).obstacles!.slice(1) },
    "rectangle",
  ).center;
  expect(center[0]).toBeCloseTo(19.93, 1);
  expect(center[0]).not.toBeCloseTo(20, 2);
});

test("a double click on a polygon's edge adds a corner, on a corner takes it away", async ({ page }) => {
  await openLot(page, {
    obstacles: [
      {
        type: "polygon",
        id: "shape",
        points: [
          [15, 12],
          [25, 12],
          [20, 18],
        ],
      },
    ],
  });
  await click(page, [20, 14]);
  const edge = await onScreen(page, 18, 12);
  await page.mouse.dblclick(edge.x, edge.y);
  expect(only(await sceneOf(page), "polygon").points).toHaveLength(4);
  await page.mouse.dblclick(edge.x, edge.y);
  expect(only(await sceneOf(page), "polygon").points).toHaveLength(3);
});

test("a locked tool stays in hand", async ({ page }) => {
  await openLot(page);
  await page.keyboard.press("r");
  await page.keyboard.press("q");
  await drag(page, [
    [10, 10],
    [12, 12],
  ]);
  await drag(page, [
    [14, 10],
    [16, 12],
  ]);
  expect(kinds(await sceneOf(page))).toEqual(["rectangle", "rectangle"]);
});

test("a pose's label takes numbers", async ({ page }) => {
  await openLot(page);
  await click(page, [5, 3]);
  await page.waitForTimeout(100);
  await page.keyboard.press("Enter");
  const field = page.locator("parkade-scene-view input.pose");
  await expect(field).toBeFocused();
  await field.fill("nonsense");
  await field.press("Enter");
  await expect(field).toHaveAttribute("aria-invalid", "true");
  await field.fill("12.4, 8.1, −87.5°");
  await field.press("Enter");
  await expect(field).toHaveCount(0);
  const { start } = await sceneOf(page);
  expect(start.x).toBeCloseTo(12.4, 6);
  expect(start.y).toBeCloseTo(8.1, 6);
  expect((start.heading * 180) / Math.PI).toBeCloseTo(-87.5, 6);
});

test("a second finger takes back a stray stroke, three fingers take back an edit", async ({ page }) => {
  await openLot(page);
  await page.keyboard.press("b");
  const before = await fingerprint(page);
  const camera = () =>
    page.evaluate(
      () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.camera as { scale: number },
    );
  await fingers(
    page,
    [
      [
        [16, 12],
        [17, 12],
        [14, 12],
      ],
      [
        [22, 16],
        [22, 16],
        [26, 16],
      ],
    ],
    { gap: 20 },
  );
  expect(await fingerprint(page)).toBe(before);
  expect((await camera()).scale).toBeGreaterThan(20);
  await fingers(page, [
    [
      [16, 12],
      [20, 12],
    ],
  ]);
  expect(await fingerprint(page)).not.toBe(before);
  await fingers(page, [[[16, 12]], [[18, 12]], [[20, 13]]]);
  await expect.poll(() => fingerprint(page)).toBe(before);
});

test("a finger that rests opens the menu, and so does the right button", async ({ page }) => {
  await openLot(page, { obstacles: [BOX] });
  await fingers(page, [[[20, 15]]], { hold: 700 });
  await expect(page.getByRole("menuitem", { name: "Duplicate" })).toBeVisible();
  await page.getByRole("menuitem", { name: "Duplicate" }).click();
  expect((await sceneOf(page)).obstacles).toHaveLength(2);
  const at = await onScreen(page, 10, 20);
  await page.mouse.click(at.x, at.y, { button: "right" });
  await page.getByRole("menuitem", { name: "Set start here" }).click();
  const { start } = await sceneOf(page);
  expect(Math.hypot(start.x - 10, start.y - 20)).toBeLessThan(0.1);
});

test("with a pen in use, fingers move the view", async ({ page }) => {
  await openLot(page);
  await page.keyboard.press("b");
  const session = await page.context().newCDPSession(page);
  const pen = async (type: "mousePressed" | "mouseMoved" | "mouseReleased", x: number, y: number) => {
    const at = await onScreen(page, x, y);
    await session.send("Input.dispatchMouseEvent", {
      type,
      ...at,
      button: "left",
      buttons: 1,
      clickCount: 1,
      pointerType: "pen",
    });
  };
  await pen("mousePressed", 16, 12);
  await pen("mouseMoved", 20, 12);
  await pen("mouseReleased", 20, 12);
  const drawn = await fingerprint(page);
  expect(cells(await sceneOf(page)).size).toBeGreaterThan(5);
  await fingers(page, [
    [
      [16, 20],
      [20, 20],
    ],
  ]);
  expect(await fingerprint(page)).toBe(drawn);
});

test("100 mixed edits are taken back to the very scene, and made again", async ({ page }) => {
  test.setTimeout(180_000);
  await openLot(page);
  await page.evaluate(() =>
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ planners: ["four"] }),
  );
  const seen = [await fingerprint(page)];
  let seed = 7;
  const random = (low: number, high: number): number => {
    seed = (seed * 48271) % 2147483647;
    return low + ((high - low) * seed) / 2147483647;
  };
  const spot = (): Spot => [random(8, 32), random(8, 22)];
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random(0, list.length))]!;
  while (seen.length <= 100) {
    const how = random(0, 1);
    if (how < 0.2) {
      await page.keyboard.press(pick(["b", "r", "m", "p", "e", "v", "k", "k"]));
      await drag(page, [spot(), spot()], { steps: 1 });
    } else if (how < 0.3) {
      await page.keyboard.press("c");
      await click(page, spot());
    } else
      await page.keyboard.press(
        pick([
          "ArrowUp",
          "ArrowRight",
          "Shift+ArrowDown",
          "Control+ArrowLeft",
          "Control+d",
          "Control+a",
          "x",
          "Delete",
          "}",
          "{",
        ]),
      );
    await page.keyboard.press("v");
    const now = await fingerprint(page);
    if (now !== seen.at(-1)) seen.push(now);
  }
  for (const wanted of seen.slice(0, -1).reverse()) {
    await page.keyboard.press("Control+z");
    expect(await fingerprint(page)).toBe(wanted);
  }
  for (let i = 1; i < seen.length; i++) await page.keyboard.press("Control+Shift+z");
  expect(await fingerprint(page)).toBe(seen.at(-1));
});
