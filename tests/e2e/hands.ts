import type { Page } from "@playwright/test";
import type { Obstacle, Scenario } from "parkade";
import { look, onScreen, open, sceneOf, settled, type PlaygroundElement } from "./playground.js";

export type Spot = [x: number, y: number];

/** An empty lot with its cars out of the way; 20 px to the metre, (20, 15) in the middle. */
export const LOT: Scenario = {
  version: 1,
  map: { origin: [0, 0], width: 80, height: 60, resolution: 0.5 },
  obstacles: [],
  slots: [],
  vehicle: "sedan",
  start: { x: 4, y: 3, heading: 0 },
  goal: { x: 30, y: 3, heading: 0 },
};

export async function openLot(page: Page, scene: Partial<Scenario> = {}): Promise<void> {
  await open(page);
  await page.evaluate(() =>
    document
      .querySelector<PlaygroundElement>("parkade-playground")!
      .store.set({ mode: "overlay", planners: ["four", "eight"], focus: "four" }),
  );
  await fillLot(page, scene);
}

/** The lot again, with these things in it. */
export async function fillLot(page: Page, scene: Partial<Scenario> = {}): Promise<void> {
  await page.evaluate(
    (lot) => {
      document.querySelector<PlaygroundElement>("parkade-playground")!.sceneData = lot;
    },
    { ...LOT, ...scene },
  );
  await settled(page);
  await look(page, 20, 15, 20);
}

/** Presses, moves along the way, releases. */
export async function drag(
  page: Page,
  way: readonly Spot[],
  options: { button?: "left" | "right"; steps?: number } = {},
): Promise<void> {
  const [first, ...rest] = await Promise.all(way.map(([x, y]) => onScreen(page, x, y)));
  await page.mouse.move(first!.x, first!.y);
  await page.mouse.down({ button: options.button ?? "left" });
  for (const at of rest) await page.mouse.move(at.x, at.y, { steps: options.steps ?? 5 });
  await page.mouse.up({ button: options.button ?? "left" });
}

export async function click(page: Page, [x, y]: Spot): Promise<void> {
  const at = await onScreen(page, x, y);
  await page.mouse.click(at.x, at.y);
}

/** The fingers' own, seconds: a busy machine must not make them slow. */
let clock = 0;

/** Fingers that go down together (or after `gap` milliseconds), move together and leave. */
export async function fingers(
  page: Page,
  ways: readonly (readonly Spot[])[],
  options: { gap?: number; hold?: number } = {},
): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const points = await Promise.all(ways.map((way) => Promise.all(way.map(([x, y]) => onScreen(page, x, y)))));
  const at = (step: number, count = points.length): { x: number; y: number; id: number }[] =>
    points.slice(0, count).map((way, id) => ({ ...way[Math.min(step, way.length - 1)]!, id }));
  clock = Math.max(clock, Date.now() / 1000);
  const send = (type: "touchStart" | "touchMove" | "touchEnd", touchPoints: { x: number; y: number; id: number }[]) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints, timestamp: (clock += 0.016) });
  for (let count = 1; count <= points.length; count++) {
    await send("touchStart", at(0, count));
    if (options.gap && count === 1) {
      await send("touchMove", at(1, 1));
      clock += options.gap / 1000;
    }
  }
  if (options.hold) await page.waitForTimeout(options.hold);
  const steps = Math.max(...points.map((way) => way.length));
  for (let step = 1; step < steps; step++) {
    for (let part = 1; part <= 4; part++) {
      const before = at(step - 1),
        next = at(step);
      await send(
        "touchMove",
        next.map((p, i) => ({
          x: before[i]!.x + ((p.x - before[i]!.x) * part) / 4,
          y: before[i]!.y + ((p.y - before[i]!.y) * part) / 4,
          id: p.id,
        })),
      );
    }
  }
  await send("touchEnd", []);
  // Other input must not come from before.
  await page.waitForTimeout(Math.max(0, clock * 1000 - Date.now() + 20));
  await session.detach();
}

/** What a scene is, ids and order included. */
export async function fingerprint(page: Page): Promise<string> {
  return JSON.stringify(await sceneOf(page));
}

/** The painted cells of a scene, as "x,y". */
export const cells = (scene: Scenario): Set<string> =>
  new Set(
    (scene.obstacles ?? []).flatMap((one) =>
      one.type === "cells" ? one.runs.flatMap(([x, y, n]) => Array.from({ length: n }, (_, i) => `${x + i},${y}`)) : [],
    ),
  );
export const kinds = (scene: Scenario): string[] => (scene.obstacles ?? []).map((one) => one.type);
/** The first obstacle of a type, which must be there. */
export const only = <Type extends Obstacle["type"]>(scene: Scenario, type: Type): Extract<Obstacle, { type: Type }> =>
  scene.obstacles!.find((one): one is Extract<Obstacle, { type: Type }> => one.type === type)!;
/** What is selected on the page. */
export const selection = (page: Page): Promise<unknown> =>
  page.evaluate(
    () =>
      (
        document.querySelector<PlaygroundElement>("parkade-playground")!.store.state as unknown as {
          selection: unknown;
        }
      ).selection,
  );

/** An obstacle to edit. */
export const BOX: Obstacle = { type: "rectangle", id: "box", center: [20, 15], size: [2, 2], heading: 0 };
