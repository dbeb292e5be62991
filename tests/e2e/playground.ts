import { expect, type Page } from "@playwright/test";
import type { Plan, Scenario } from "parkade";

/** What the tests use of the page's element. */
export interface PlaygroundElement extends HTMLElement {
  ready: Promise<void>;
  scene: string;
  sceneData: Scenario;
  updateComplete: Promise<boolean>;
  results: Record<string, Plan | null>;
  settled(): Promise<void>;
  shareURL(): Promise<string | null>;
  store: {
    state: {
      scene: Scenario;
      canUndo: boolean;
      planners: string[];
      message: { tone: string; text: string } | null;
      camera: unknown;
      mode: string;
      lang: string;
      complete: boolean;
      results: Record<string, { status: string; plan: Plan | null; chosen?: Plan | null; ordinary?: Plan | null }>;
    };
    set(patch: Record<string, unknown>): void;
    subscribe(listener: () => void): () => void;
  };
}

/** Insides of the page that a test reads as they are. */
// biome-ignore lint/suspicious/noExplicitAny: a type for what one test reads once would say nothing
export type Untyped = any;

/** What the test tool itself says where it lets no service worker in. */
const BLOCKED = "Service Worker registration blocked by Playwright";

/** Collects everything the page complains about. */
export function complaintsOf(page: Page): string[] {
  const complaints: string[] = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && message.text() !== BLOCKED) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  return complaints;
}

/** Keeps how far the page's contents move by themselves, from its next load on; read by what this returns. */
export async function watchShifts(page: Page): Promise<() => Promise<number[]>> {
  await page.addInitScript(() => {
    const shifts: number[] = [];
    Object.assign(window, { shifts });
    new PerformanceObserver((list) => {
      // As cumulative layout shift is defined: what follows a press is no surprise.
      for (const entry of list.getEntries() as unknown as { value: number; hadRecentInput: boolean }[])
        if (!entry.hadRecentInput) shifts.push(entry.value);
    }).observe({ type: "layout-shift", buffered: true });
  });
  return () => page.evaluate(() => (window as unknown as { shifts: number[] }).shifts);
}

export async function open(page: Page, hash = ""): Promise<void> {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto(`./${hash}`);
  await page.evaluate(async () => {
    await customElements.whenDefined("parkade-playground");
    await document.querySelector<PlaygroundElement>("parkade-playground")!.ready;
  });
}

export function settled(page: Page): Promise<void> {
  return page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.settled());
}

/**
 * Waits until every planner in sight has answered what the store holds now; `settled` waits until each has been timed
 * as well.
 */
export function answered(page: Page): Promise<void> {
  return page.evaluate(
    () =>
      new Promise<void>((resolve) => {
        const { store } = document.querySelector<PlaygroundElement>("parkade-playground")!;
        const stop = store.subscribe(look);
        function look(): void {
          const { planners, results } = store.state;
          if (!planners.every((one) => ["done", "error"].includes(results[one]?.status ?? ""))) return;
          stop();
          resolve();
        }
        look();
      }),
  );
}

export function sceneOf(page: Page): Promise<Scenario> {
  return page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.sceneData);
}

export function hashesOf(page: Page): Promise<Record<string, string | undefined>> {
  return page.evaluate(() => {
    const { results } = document.querySelector<PlaygroundElement>("parkade-playground")!;
    return Object.fromEntries(Object.entries(results).map(([planner, plan]) => [planner, plan?.hash]));
  });
}

/** Where a world point is in the window, in the panel of the focused planner. */
export function onScreen(page: Page, x: number, y: number): Promise<{ x: number; y: number }> {
  return page.evaluate(
    ([wx, wy]) => {
      const inner = (root: ParentNode): HTMLCanvasElement | null => {
        for (const element of root.querySelectorAll("*")) {
          if (element.localName === "parkade-panel" && !element.hasAttribute("active")) continue;
          if (element.localName === "parkade-scene-view") return element.shadowRoot!.querySelector("canvas");
          const found = element.shadowRoot ? inner(element.shadowRoot) : null;
          if (found) return found;
        }
        return null;
      };
      const box = inner(document)!.getBoundingClientRect();
      const camera = document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.camera as {
        x: number;
        y: number;
        scale: number;
      };
      return {
        x: box.left + box.width / 2 + (wx - camera.x) * camera.scale,
        y: box.top + box.height / 2 - (wy - camera.y) * camera.scale,
      };
    },
    [x, y] as const,
  );
}

/**
 * Fixes the camera, so that world points can be aimed at: when the canvases have their sizes and are drawn, some frames
 * later.
 */
export async function look(page: Page, x: number, y: number, scale: number): Promise<void> {
  await page.evaluate(
    async (camera) => {
      document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ camera });
      for (let frame = 0; frame < 6; frame++) await new Promise(requestAnimationFrame);
    },
    { x, y, scale },
  );
}

export async function dragWorld(page: Page, from: [number, number], to: [number, number], steps = 6): Promise<void> {
  const a = await onScreen(page, ...from),
    b = await onScreen(page, ...to);
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move(b.x, b.y, { steps });
  await page.mouse.up();
  await settled(page);
}

export async function expectFourAnswers(page: Page): Promise<void> {
  const outcomes = await page.evaluate(() => {
    const { results } = document.querySelector<PlaygroundElement>("parkade-playground")!;
    return Object.values(results).map((plan) => plan?.outcome);
  });
  expect(outcomes).toEqual(["found", "found", "found", "found"]);
}
