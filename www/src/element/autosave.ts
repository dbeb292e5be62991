/** Keeps each tab's drawing in the browser, and offers what a closed tab has left behind. */
import { words } from "../i18n/words";
import { checkScene } from "../scene/files";
import { ensureIds } from "../scene/model";
import { countRuns } from "../scene/vast";
import type { Scene } from "../store";
import type { App } from "./app";

const say = words({
  found: ["The drawing you left at {time} is still here.", "您在 {time} 离开的绘图仍在。"],
  open: ["Bring it back", "恢复"],
});

const KEY = "parkade.tab.";
const SETTLE_MS = 1000;
/** Characters; browsers keep about five million for all tabs together. */
const LARGEST = 1_500_000;
/** Characters that a run takes at least. */
const RUN = 8;
const MOST_KEPT = 5;

interface Kept { at: number; scene: Scene }

/** Starts keeping this tab's drawing. */
export async function startAutosave(app: App): Promise<() => void> {
  const own = await nameOf();
  let timer: ReturnType<typeof setTimeout> | undefined;
  const save = (): void => {
    clearTimeout(timer);
    timer = undefined;
    const { scene, canUndo } = app.store.state;
    if (canUndo) keep(own, scene);
  };
  const leaving = (): void => { if (timer) save(); };
  addEventListener("pagehide", leaving);
  const unsubscribe = app.store.subscribe((state, previous) => {
    if (state.scene === previous.scene || state.transient) return;
    clearTimeout(timer);
    timer = setTimeout(save, SETTLE_MS);
  });
  await offer(app, own);
  return () => {
    leaving();
    removeEventListener("pagehide", leaving);
    unsubscribe();
  };
}

/** This tab's name, locked for as long as it is open: a copied tab has its own. */
async function nameOf(): Promise<string> {
  const taken = await openTabs();
  let name = sessionStorage.getItem("parkade.tab");
  if (!name || taken.has(KEY + name)) name = crypto.randomUUID();
  sessionStorage.setItem("parkade.tab", name);
  void navigator.locks?.request(KEY + name, () => new Promise<never>(() => {}));
  return KEY + name;
}

async function openTabs(): Promise<Set<string>> {
  const { held = [] } = (await navigator.locks?.query()) ?? {};
  return new Set(held.flatMap(({ name }) => name ?? []));
}

function keep(key: string, scene: Scene): void {
  // Making the text of a huge map would hold up the page for nothing.
  if (countRuns(scene) * RUN > LARGEST) return;
  const text = JSON.stringify({ at: Date.now(), scene } satisfies Kept);
  if (text.length > LARGEST) return;
  try {
    localStorage.setItem(key, text);
  } catch {
    // Full, or refused: the address and files still keep scenes.
  }
}

/** Drawings of tabs that are closed; a tab that was only reloaded finds its own. */
async function offer(app: App, own: string): Promise<void> {
  const open = await openTabs();
  const left = Object.keys(localStorage).filter((key) => key.startsWith(KEY) && (key === own || !open.has(key)))
    .flatMap((key) => {
      const kept = read(key);
      if (!kept) localStorage.removeItem(key);
      return kept ? [{ key, ...kept }] : [];
    })
    .sort((a, b) => b.at - a.at);
  for (const { key } of left.slice(MOST_KEPT)) localStorage.removeItem(key);
  const [last] = left, { scene, lang, canUndo } = app.store.state;
  if (!last || canUndo || alike(last.scene, scene)) return;
  const time = new Intl.DateTimeFormat(lang === "zh" ? "zh-CN" : "en", { dateStyle: "medium", timeStyle: "short" }).format(last.at);
  app.store.set({
    message: {
      tone: "info", text: say(lang, "found", { time }),
      action: {
        name: say(lang, "open"),
        run: () => {
          app.preset = null;
          app.openScene(ensureIds(last.scene));
          if (last.key !== own) localStorage.removeItem(last.key);
        },
      },
    },
  });
}

function read(key: string): Kept | null {
  try {
    const { at, scene } = JSON.parse(localStorage.getItem(key) ?? "") as Kept;
    return typeof at === "number" ? { at, scene: checkScene(scene) } : null;
  } catch {
    return null;
  }
}

/** Links round to a centimetre, so the same drawing may differ a little. */
const alike = (a: Scene, b: Scene): boolean => rounded(a) === rounded(b);
const rounded = (scene: Scene): string =>
  JSON.stringify(scene, (name, value: unknown) => (name === "id" || (Array.isArray(value) && value.length === 0) ? undefined : typeof value === "number" ? Math.round(value * 50) : value));
