/** The steps of a tab's undo and redo, kept for as long as the tab lives, so that a reload loses nothing. */
import { countRuns } from "../scene/large-scene";
import type { History, Scene, Store } from "../store";

export const HISTORY_KEY = "parkade.history";
/** Characters; browsers keep about five million for a tab. */
const LARGEST = 1_000_000;
/** Characters that a run takes at least. */
const RUN = 8;
/** Characters of a number that stands for a part. */
const REFERENCE = 5;

/** What has a history. */
export interface Keeper {
  readonly store: Store;
  /** Null before any planner is there. */
  readonly catalog: { checked(scene: Scene): Scene } | null;
  /** Every planner and kind of scene. */
  complete(): Promise<unknown>;
}

/** Scenes share most of their parts: each part once, and every scene as the numbers of its own. */
interface Kept {
  hash: string;
  at: number;
  scenes: Record<string, number | number[]>[];
  parts: unknown[];
}

/**
 * The history as text with as many of the nearest steps as fit; null where not even the scene does. `hash` is the
 * address it belongs to.
 */
export function encodeHistory({ past, scene, future }: History, hash: string): string | null {
  const numbers = new Map<unknown, number>(),
    texts: string[] = [];
  let room = LARGEST;
  const refer = (part: unknown): number => {
    const known = numbers.get(part);
    if (known !== undefined) return known;
    const text = JSON.stringify(part);
    room -= text.length + 1;
    texts.push(text);
    numbers.set(part, texts.length - 1);
    return texts.length - 1;
  };
  const add = (one: Scene): Kept["scenes"][number] | null => {
    const isKnown = (one.obstacles ?? []).every((obstacle) => obstacle.type !== "cells" || numbers.has(obstacle));
    // Making the text of a huge map would hold up the page for nothing.
    if (!isKnown && countRuns(one) * RUN > room) return null;
    const entries = Object.entries(one)
      .filter(([, value]) => value !== undefined)
      .map(([key, value]) => [key, Array.isArray(value) ? value.map(refer) : refer(value)] as const);
    room -= entries.reduce(
      (sum, [key, value]) => sum + key.length + REFERENCE * (Array.isArray(value) ? value.length + 1 : 1),
      0,
    );
    return room < 0 ? null : Object.fromEntries(entries);
  };
  const whileRoom = (some: readonly Scene[]): Kept["scenes"] => {
    const kept: Kept["scenes"] = [];
    for (const one of some) {
      const added = add(one);
      if (!added) break;
      kept.push(added);
    }
    return kept;
  };
  const now = add(scene);
  if (!now) return null;
  const before = whileRoom(past.toReversed()).reverse(),
    after = whileRoom(future.toReversed()).reverse();
  return `{"hash":${JSON.stringify(hash)},"at":${before.length},"scenes":${JSON.stringify([
    ...before,
    now,
    ...after,
  ])},"parts":[${texts.join()}]}`;
}

/** Throws where the text is damaged; `checked` throws what is wrong with a scene. */
export function decodeHistory(text: string, checked: (scene: Scene) => Scene): History & { hash: string } {
  const { hash, at, scenes, parts }: Kept = JSON.parse(text);
  const part = (number: number): unknown => {
    if (!Number.isInteger(number) || !(number in parts)) throw new RangeError(`parts: has no ${number}`);
    return parts[number];
  };
  // Equal lists are one list: what has not changed is not sent to the planners again.
  const lists = new Map<string, unknown[]>();
  const list = (some: number[]): unknown[] => {
    const name = some.join(),
      known = lists.get(name) ?? some.map(part);
    lists.set(name, known);
    return known;
  };
  const all = scenes.map((one) =>
    checked(
      Object.fromEntries(
        Object.entries(one).map(([key, value]) => [key, Array.isArray(value) ? list(value) : part(value)]),
      ) as unknown as Scene,
    ),
  );
  const scene = Number.isInteger(at) ? all[at] : undefined;
  if (typeof hash !== "string" || !scene) throw new RangeError(`at: must name one of ${all.length} scenes, got ${at}`);
  return { hash, past: all.slice(0, at), scene, future: all.slice(at + 1) };
}

/** Brings back what this tab had where it is at the same address still; a damaged rest is dropped. */
export async function restoreHistory(app: Keeper): Promise<Scene | null> {
  const text = sessionStorage.getItem(HISTORY_KEY);
  if (text === null) return null;
  try {
    const { hash, ...history } = decodeHistory(text, app.catalog!.checked);
    if (hash !== location.hash) return null;
    app.store.restore(history);
    return history.scene;
  } catch {
    // The first module knows no sets of goals.
    if (!app.store.state.complete) return app.complete().then(() => restoreHistory(app));
    sessionStorage.removeItem(HISTORY_KEY);
    return null;
  }
}

export function keepHistory({ store }: Keeper): void {
  const text = encodeHistory(store.history, location.hash);
  if (text === null) sessionStorage.removeItem(HISTORY_KEY);
  else sessionStorage.setItem(HISTORY_KEY, text);
}
