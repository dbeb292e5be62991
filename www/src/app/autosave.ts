/** Keeps each tab's drawing in the browser, and offers what a closed tab has left behind. */
import messages from "../i18n/messages/autosave.json";
import { translator } from "../i18n/translator";
import { pack } from "../scene/link-codec";
import { countRuns } from "../scene/large-scene";
import type { Scene } from "../store";
import { keepHistory, type Keeper } from "./history";
import { keepsRule } from "./schema";

const say = translator("autosave", messages);

const KEY = "parkade.tab.";
const SETTLE_MS = 1000;
/** Characters; browsers keep about five million for all tabs together. */
const LARGEST = 1_500_000;
/** Characters that a run takes at least. */
const RUN = 8;
const MOST_KEPT = 5;
/** Milliseconds; `Date` knows no later one. */
const LAST_DATE = 8.64e15;

/** Whose drawing is kept. */
interface Drawn extends Keeper {
  openForeign(scene: Scene): Promise<void>;
}

interface Kept {
  at: number;
  scene: Scene;
}

/** Starts keeping this tab's drawing. */
export async function startAutosave(app: Drawn): Promise<() => void> {
  const own = await nameOf();
  let timer: ReturnType<typeof setTimeout> | undefined,
    hash: string | null = null;
  dropDamaged();
  const save = (): void => {
    clearTimeout(timer);
    timer = undefined;
    const { scene, canUndo, canRedo } = app.store.state;
    if (canUndo || canRedo) keep(own, scene);
    quietly(() => keepHistory(app));
    hash = location.hash;
  };
  // The address may have been written since.
  const leaving = (): void => {
    if (timer || (hash !== null && hash !== location.hash)) save();
  };
  addEventListener("pagehide", leaving);
  const saveSoon = (): void => {
    clearTimeout(timer);
    timer = setTimeout(save, SETTLE_MS);
  };
  const unsubscribe = app.store.subscribe((state, previous) => {
    if (state.scene !== previous.scene && !state.transient) saveSoon();
  });
  // Edits may have come before this was there.
  if (app.store.state.canUndo) saveSoon();
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
  if (!name || !/^[\w-]{36}$/.test(name) || taken.has(KEY + name)) name = crypto.randomUUID();
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
  quietly(() => localStorage.setItem(key, text));
}

function quietly(store: () => void): void {
  try {
    store();
  } catch {
    // Full, or refused: the address and files still keep scenes.
  }
}

/** Settings that somebody else has written, or another version. */
function dropDamaged(): void {
  for (const [key, text] of Object.entries(localStorage))
    if (!keepsRule(key, String(text))) localStorage.removeItem(key);
}

/** Drawings of tabs that are closed; a tab that was only reloaded finds its own. */
async function offer(app: Drawn, own: string): Promise<void> {
  const open = await openTabs();
  const keys = Object.keys(localStorage).filter((key) => key.startsWith(KEY) && (key === own || !open.has(key)));
  // The first module knows no sets of goals.
  if (keys.length === 0 || !(await app.complete().catch(() => null))) return;
  const left = keys
    .flatMap((key) => {
      const kept = read(key, app);
      if (!kept) localStorage.removeItem(key);
      return kept ? [{ key, ...kept }] : [];
    })
    .sort((a, b) => b.at - a.at);
  for (const { key } of left.slice(MOST_KEPT)) localStorage.removeItem(key);
  const [last] = left,
    { scene, lang, canUndo } = app.store.state;
  if (!last || canUndo || alike(last.scene, scene)) return;
  const time = new Intl.DateTimeFormat(lang === "zh" ? "zh-CN" : "en", {
    dateStyle: "medium",
    timeStyle: "short",
  }).format(last.at);
  app.store.set({
    message: {
      tone: "info",
      text: say(lang, "found", { time }),
      action: {
        name: say(lang, "open"),
        run: () => {
          void app.openForeign(last.scene);
          if (last.key !== own) localStorage.removeItem(last.key);
        },
      },
    },
  });
}

function read(key: string, { catalog }: Drawn): Kept | null {
  try {
    const { at, scene }: Kept = JSON.parse(localStorage.getItem(key) ?? "");
    return Math.abs(at) <= LAST_DATE ? { at, scene: catalog!.checked(scene) } : null;
  } catch {
    return null;
  }
}

/** True if a link of the one would be a link of the other. */
const alike = (a: Scene, b: Scene): boolean => JSON.stringify(pack(a)) === JSON.stringify(pack(b));
