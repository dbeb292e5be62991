import { expect, test, type Page } from "@playwright/test";
import type { Scenario } from "parkade";
import { drag, fillLot, fingers, openLot, type Spot } from "./hands.js";
import { complaintsOf, hashesOf, onScreen, open, sceneOf, settled, type PlaygroundElement } from "./playground.js";

/** Both cars well inside, so that every side has room. */
const YARD: Partial<Scenario> = { start: { x: 12, y: 12, heading: 0 }, goal: { x: 24, y: 18, heading: 0 } };
const RIGHT: Spot = [40, 15],
  LEFT: Spot = [0, 15];

const sizeOf = ({ map: { origin, width, height, resolution, boundary } }: Scenario): number[] => {
  const [xs, ys] = boundary
    ? [boundary.map((p) => p[0]), boundary.map((p) => p[1])]
    : [
        [origin[0], origin[0] + width * resolution],
        [origin[1], origin[1] + height * resolution],
      ];
  return [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)].map(
    (value) => Math.round(value * 1e4) / 1e4,
  );
};
const ground = async (page: Page): Promise<number[]> => sizeOf(await sceneOf(page));
const message = (page: Page): Promise<string | undefined> =>
  page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.message?.text);

/** Where the focused map looks. */
const cameraOf = (page: Page): Promise<unknown> =>
  page.evaluate(() => {
    const inner = (root: ParentNode): { view: { camera: unknown } } | null => {
      for (const element of root.querySelectorAll("*")) {
        if (element.localName === "parkade-scene-view") return element as unknown as { view: { camera: unknown } };
        const found = element.shadowRoot ? inner(element.shadowRoot) : null;
        if (found) return found;
      }
      return null;
    };
    return inner(document)!.view.camera;
  });

/** The map's middle and 10 px to the metre, for all of the ground. */
async function lookAtAll(page: Page): Promise<void> {
  await page.evaluate(async () => {
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ camera: { x: 20, y: 15, scale: 10 } });
    for (let frame = 0; frame < 6; frame++) await new Promise(requestAnimationFrame);
  });
}

async function openYard(page: Page, scene: Partial<Scenario> = {}): Promise<void> {
  await openLot(page, { ...YARD, ...scene });
  await lookAtAll(page);
}

test.describe("with a mouse", () => {
  test.use({ viewport: { width: 1400, height: 900 } });

  test("each side is dragged, outward and inward, in one step each", async ({ page }) => {
    const complaints = complaintsOf(page);
    await openYard(page);
    const before = await sceneOf(page);
    await drag(page, [RIGHT, [43.04, 17]]);
    expect(await ground(page)).toEqual([0, 43, 0, 30]);
    await drag(page, [
      [21.5, 30],
      [20, 26.68],
    ]);
    expect(await ground(page)).toEqual([0, 43, 0, 26.7]);
    await drag(page, [
      [0, 13.35],
      [-2.5, 13],
    ]);
    expect(await ground(page)).toEqual([-2.5, 43, 0, 26.7]);
    await drag(page, [
      [20.25, 0],
      [20, 4],
    ]);
    expect(await ground(page)).toEqual([-2.5, 43, 4, 26.7]);
    const { start, goal, obstacles } = await sceneOf(page);
    expect({ start, goal, obstacles }).toEqual({ start: before.start, goal: before.goal, obstacles: before.obstacles });
    for (let i = 0; i < 4; i++) await page.keyboard.press("Control+z");
    expect(await sceneOf(page)).toEqual(before);
    expect(complaints).toEqual([]);
  });

  test("planners follow the drag, Escape gives it up, and the camera rests", async ({ page }) => {
    await openYard(page);
    await page.evaluate(() =>
      document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ camera: null }),
    );
    await settled(page);
    await page.evaluate(() => new Promise(requestAnimationFrame));
    const before = await sceneOf(page),
      hashes = await hashesOf(page),
      camera = (await cameraOf(page)) as { x: number; y: number; scale: number };
    const box = (await page.locator("canvas").first().boundingBox())!,
      at = (x: number, y: number): Spot => [
        box.x + box.width / 2 + (x - camera.x) * camera.scale,
        box.y + box.height / 2 - (y - camera.y) * camera.scale,
      ];
    await page.mouse.move(...at(...RIGHT));
    await page.mouse.down();
    await page.mouse.move(...at(37, 15), { steps: 4 });
    expect((await ground(page))[1]).toBe(37);
    expect(await cameraOf(page)).toEqual(camera);
    await expect.poll(() => hashesOf(page)).not.toEqual(hashes);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    expect(await sceneOf(page)).toEqual(before);
    await settled(page);
    expect(await hashesOf(page)).toEqual(hashes);
    // Inside the view the map stays where it is; beyond it the whole ground is shown.
    await drag2(page, at(...RIGHT), at(38, 15));
    expect(await cameraOf(page)).toEqual(camera);
    await drag2(page, at(38, 15), at(80, 15));
    await expect.poll(async () => ((await cameraOf(page)) as { scale: number }).scale).toBeLessThan(camera.scale);
  });

  test("while planners work on other ground their paths stay, and what they tell of its cells goes", async ({
    page,
  }) => {
    await openYard(page);
    await page.evaluate(() => {
      const { store } = document.querySelector<PlaygroundElement>("parkade-playground")!;
      store.set({ layers: { ...(store.state as unknown as { layers: object }).layers, heat: true } });
    });
    await settled(page);
    const told = await page.evaluate(() => {
      type Result = { plan: { path: Float64Array; trace: unknown } | null; layers: object };
      const store = document.querySelector<PlaygroundElement>("parkade-playground")!.store as unknown as {
        state: { scene: Scenario; results: Record<string, Result> };
        edit(scene: Scenario, options: { transient: boolean }): void;
        undo(): void;
      };
      const tell = () => {
        const { plan, layers } = store.state.results["four"]!;
        return {
          path: (plan?.path.length ?? 0) > 3,
          trace: plan?.trace !== null,
          layers: Object.keys(layers).length > 0,
        };
      };
      const before = tell(),
        { scene } = store.state;
      store.edit({ ...scene, map: { ...scene.map, width: scene.map.width + 7 } }, { transient: true });
      const during = tell();
      store.undo();
      return { before, during };
    });
    expect(told).toEqual({
      before: { path: true, trace: true, layers: true },
      during: { path: true, trace: false, layers: false },
    });
  });

  test("Ctrl leaves the decimetres, painted cells are its lattice", async ({ page }) => {
    await openYard(page);
    await page.keyboard.down("Control");
    await drag(page, [RIGHT, [42.347, 15]]);
    await page.keyboard.up("Control");
    const free = (await ground(page))[1]!;
    expect(Math.abs(free - 42.347)).toBeLessThan(0.06);
    const cells = {
      ...YARD,
      obstacles: [{ type: "cells" as const, id: "cells-1", runs: [[4, 40, 3]] as [number, number, number][] }],
    };
    await fillLot(page, cells);
    await lookAtAll(page);
    await drag(page, [LEFT, [-1.7, 15]]);
    const { map, obstacles } = await sceneOf(page);
    expect(map).toEqual({ origin: [-1.5, 0], width: 83, height: 60, resolution: 0.5 });
    expect(obstacles).toEqual([{ ...cells.obstacles[0], runs: [[7, 40, 3]] }]);
    await drag(page, [
      [-1.5, 15],
      [9, 15],
    ]);
    expect((await sceneOf(page)).map).toEqual({ origin: [2, 0], width: 76, height: 60, resolution: 0.5 });
    expect(await message(page)).toBe("The ground ends at the blocked cells. Move or delete what stands there.");
  });

  test("what stands in the way is named, and stays", async ({ page }) => {
    await openYard(page, {
      obstacles: [
        {
          type: "wall",
          id: "wall-1",
          points: [
            [30, 5],
            [33, 5],
          ],
          thickness: 0.2,
        },
      ],
    });
    const before = await sceneOf(page);
    await drag(page, [RIGHT, [25, 15]]);
    expect(await ground(page)).toEqual([0, 33.1, 0, 30]);
    expect(await message(page)).toBe("The ground ends at the wall. Move or delete what stands there.");
    expect((await sceneOf(page)).obstacles).toEqual(before.obstacles);
    await drag(page, [
      [16.55, 0],
      [16, 20],
    ]);
    expect((await ground(page))[2]).toBe(4.9);
    await page.keyboard.press("Control+a");
    await page.keyboard.press("Delete");
    await drag(page, [
      [16.55, 4.9],
      [16.5, 20],
    ]);
    expect(await message(page)).toBe("The ground ends at the car’s start. Move the car first.");
    await settled(page);
    // A car at the border does not overlap it.
    expect(
      await page.evaluate(
        () => document.querySelector<PlaygroundElement>("parkade-playground")!.results["four"]?.outcome,
      ),
    ).toBe("found");
  });

  test("cars and their grips come before the border, and its handles keep off them", async ({ page }) => {
    await openYard(page, { start: { x: 36.6, y: 15, heading: 0 } });
    await drag(page, [
      [39, 15],
      [35, 15],
    ]);
    expect(await ground(page)).toEqual([0, 40, 0, 30]);
    expect((await sceneOf(page)).start.x).toBeLessThan(34);
    await openYard(page, { start: { x: 36.6, y: 15, heading: 0 } });
    // The handle stands a tenth of the side above or below the middle.
    await drag(page, [
      [40, 12],
      [42, 12],
    ]);
    expect(await ground(page)).toEqual([0, 42, 0, 30]);
  });

  test("the inspector has the ground's size, by keys too, and says what is wrong with a number", async ({ page }) => {
    const complaints = complaintsOf(page);
    await openYard(page, { obstacles: [{ type: "rectangle", id: "rectangle-1", center: [33, 24], size: [4, 2] }] });
    const before = await sceneOf(page),
      card = page.locator("parkade-inspector parkade-ground"),
      width = card.getByRole("spinbutton", { name: "Width" }),
      depth = card.getByRole("spinbutton", { name: "Depth" });
    await expect(width).toHaveValue("40");
    await width.press("ArrowUp");
    await expect.poll(() => ground(page)).toEqual([0, 40.1, 0, 30]);
    await depth.fill("26.35");
    await depth.press("Enter");
    await expect.poll(() => ground(page)).toEqual([0, 40.1, 0, 26.35]);
    for (const [typed, told] of [
      [
        "20",
        "Width must be between 35.00 and 2048.00 m, got “20”. The ground ends at the rectangle. Move or delete what " +
          "stands there.",
      ],
      [
        "9000",
        /^Width must be between 35.00 and [\d,.]+ m, got “9000”\. A map can have 4096 cells a side, here 2048\.0 m\.$/,
      ],
      ["", /^Width must be between .* got “”\.$/],
    ] as const) {
      await width.fill(typed);
      await width.press("Enter");
      await expect(card.getByRole("alert")).toHaveText(told);
      await expect(width).toHaveValue(typed);
      await expect(width).toHaveAttribute("aria-invalid", "true");
      expect(await ground(page)).toEqual([0, 40.1, 0, 26.35]);
    }
    await width.fill("36");
    await width.press("Enter");
    await expect(card.getByRole("alert")).toHaveCount(0);
    expect(await ground(page)).toEqual([0, 36, 0, 26.35]);
    await page.locator("canvas").first().focus();
    for (let i = 0; i < 3; i++) await page.keyboard.press("Control+z");
    expect(await sceneOf(page)).toEqual(before);
    await expect(width).toHaveValue("40");
    expect(complaints).toEqual([]);
  });
});

async function drag2(page: Page, from: Spot, to: Spot): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 5 });
  await page.mouse.up();
  await settled(page);
}

test.describe("with a finger", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("a tap on free ground shows the handles, a finger 20 px beside one drags it", async ({ page }) => {
    const complaints = complaintsOf(page);
    await openLot(page, YARD);
    await page.evaluate(async () => {
      document
        .querySelector<PlaygroundElement>("parkade-playground")!
        .store.set({ camera: { x: 20, y: 15, scale: 8 }, tool: "select" });
      for (let frame = 0; frame < 6; frame++) await new Promise(requestAnimationFrame);
    });
    // What is not shown is not dragged by accident.
    await fingers(page, [
      [
        [38, 16.5],
        [41, 16.5],
      ],
    ]);
    expect(await ground(page)).toEqual([0, 40, 0, 30]);
    const tap = await onScreen(page, 30, 8);
    await page.touchscreen.tap(tap.x, tap.y);
    await fingers(page, [
      [
        [38, 16.5],
        [41, 16.5],
      ],
    ]);
    expect(await ground(page)).toEqual([0, 43, 0, 30]);
    // The handles stay for the next drag.
    await fingers(page, [
      [
        [23, 29],
        [23, 26],
      ],
    ]);
    expect(await ground(page)).toEqual([0, 43, 0, 27]);
    expect(complaints).toEqual([]);
  });
});

test("an embedded playground that is looked at has no handles", async ({ page }) => {
  await open(page);
  await page.goto(new URL("./embed.html#scene=perpendicular", page.url()).href);
  await page.evaluate(() => customElements.whenDefined("parkade-playground"));
  await page.waitForFunction(
    () => (document.querySelector("parkade-playground") as unknown as { ready?: Promise<void> })?.ready,
  );
  const before = await sceneOf(page),
    box = (await page.locator("parkade-playground").boundingBox())!;
  for (let x = 4; x < box.width; x += 12) {
    await page.mouse.move(box.x + x, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + x + 9, box.y + box.height / 2, { steps: 2 });
    await page.mouse.up();
  }
  expect((await sceneOf(page)).map).toEqual(before.map);
});
