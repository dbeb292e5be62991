import { expect, test, type Page } from "@playwright/test";
import type { Scenario } from "parkade";
import { BOX, cells, click, drag, fillLot, fingers, kinds, only, openLot, type Spot } from "./hands.js";
import { complaintsOf, onScreen, sceneOf, settled, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 }, hasTouch: true });

/** Each tool: its key, the way it is drawn, and what must be there then. */
interface Tool {
  key: string;
  way: Spot[];
  corners?: boolean;
  before?: Partial<Scenario>;
  made(scene: Scenario): void;
}

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

test("painted cells cost what is painted, for every planner; erased, undone and by a link they are as before", async ({
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
