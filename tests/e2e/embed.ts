import { expect, type Page } from "@playwright/test";
import type { Plan, Scenario } from "parkade";
import { watchShifts } from "./playground";

/** What the tests use of an embedded playground. */
export interface Embed extends HTMLElement {
  ready: Promise<void>;
  loaded: boolean;
  results: Record<string, Plan | null>;
  sceneData: Scenario;
  params: Record<string, Record<string, unknown>>;
  playhead: number;
  camera: { x: number; y: number; scale: number } | null;
  canUndo: boolean;
  canRedo: boolean;
  poster: string;
  [method: string]: unknown;
}

/** A shift is told to three decimals; a digit more in a label is 0.000003. */
export const UNSEEN = 0.0005;
export const HOST = "/host/three.html";

/** What the page asked for, and how far it moved by itself. */
export async function watch(page: Page): Promise<{ urls: string[]; shifted(): Promise<number> }> {
  const urls: string[] = [];
  page.on("request", (request) => urls.push(request.url()));
  await page.emulateMedia({ reducedMotion: "reduce" });
  const shifts = await watchShifts(page);
  return { urls, shifted: async () => (await shifts()).reduce((a, b) => a + b, 0) };
}

/** Waits until a second has passed without a request: pages load parts when they have nothing else to do. */
export const quiet = async (urls: string[]) => {
  let seen = -1;
  await expect.poll(() => seen === (seen = urls.length), { intervals: [1000], timeout: 30_000 }).toBe(true);
};

export const near = (page: Page, id: string) =>
  page.evaluate(async (name) => {
    const element = document.getElementById(name) as Embed;
    element.scrollIntoView({ block: "center" });
    await element.ready;
  }, id);
