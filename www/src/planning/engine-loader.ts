import type { PlannerId } from "parkade";
import { refused } from "../i18n/refusal";
import { WorkerPool, type PlanWorkers, type WorkerLike } from "./pool";
import coreUrl from "../../../pkg/core/parkade_bg.wasm?url";
import completeUrl from "../../../pkg/parkade_bg.wasm?url";

/** The small module is asked for no more than it has: its planners, and scenes without sets of goals. */
type Api = typeof import("./engine-complete");

/**
 * The planners' functions, ready to be called, their compiled module for the workers, and these; of all playgrounds of
 * a page from the same folders.
 */
export interface Engine {
  extent: Extent;
  api: Api;
  module: WebAssembly.Module;
  pool: PlanWorkers;
  script: string;
}

/**
 * Folders of worker scripts and modules that are not beside this script: pages that embed another host's element need
 * their own copies.
 */
export interface Folders {
  worker: string | null;
  wasm: string | null;
}

/**
 * `core` plans the first picture; `complete` has every planner and format and comes later, or at once where it is
 * needed.
 */
export type Extent = "core" | "complete";

const SOURCES = {
  core: { url: coreUrl, script: () => import("./engine-core") },
  complete: { url: completeUrl, script: () => import("./engine-complete") },
};
const CORE: readonly PlannerId[] = ["four", "eight", "risk-field", "hybrid", "hybrid-forward"];

/** The engines of playgrounds that load from the same folders. */
interface Loaded {
  loading: Partial<Record<Extent, Promise<Engine>>>;
  whole: Engine | null;
  /** Resolves when every planner is there, whoever asked for it. */
  isWhole: Promise<void>;
  becomeWhole(): void;
}
const loadedFrom = new Map<string, Loaded>();

function loadedIn(folders: Folders): Loaded {
  const place = JSON.stringify([folders.worker, folders.wasm]);
  let loaded = loadedFrom.get(place);
  if (!loaded) {
    let becomeWhole = (): void => {};
    const isWhole = new Promise<void>((resolve) => (becomeWhole = resolve));
    loadedFrom.set(place, (loaded = { loading: {}, whole: null, isWhole, becomeWhole }));
  }
  return loaded;
}

/** Resolves when every planner is there, so that another playground has them at no cost. */
export const whenWhole = (folders: Folders): Promise<void> => loadedIn(folders).isWhole;

/** The functions of this document take the first module that is compiled; workers plan with that of their folder. */
const initialised: Partial<Record<Extent, Promise<void>>> = {};

/** The engine that these planners need; those of the first picture are in both. */
export const extentFor = (planners: readonly PlannerId[]): Extent =>
  planners.every((planner) => CORE.includes(planner)) ? "core" : "complete";

/**
 * Loads and compiles the planners once, however many playgrounds there are; where all of them are there, nobody begins
 * with fewer.
 */
export function loadEngine(extent: Extent, folders: Folders): Promise<Engine> {
  const loaded = loadedIn(folders);
  if (loaded.whole) return Promise.resolve(loaded.whole);
  return (loaded.loading[extent] ??= load(extent, folders, loaded).catch((error: unknown) => {
    delete loaded.loading[extent];
    throw error;
  }));
}

async function load(extent: Extent, folders: Folders, loaded: Loaded): Promise<Engine> {
  const { url, script } = SOURCES[extent];
  const [api, module] = await Promise.all([
    script() as Promise<unknown> as Promise<Api>,
    compile(beside(folders.wasm, url)),
  ]);
  await (initialised[extent] ??= api.init({ wasm: module }).catch((error: unknown) => {
    delete initialised[extent];
    throw error;
  }));
  const source = beside(folders.worker, api.script);
  const pool = new WorkerPool(() => new Worker(source, { type: "module", name: "parkade" }) as WorkerLike);
  const engine = { extent, api, module, pool, script: source };
  if (extent === "complete") {
    loaded.whole = engine;
    loaded.becomeWhole();
    void loaded.loading.core?.then(
      (first) => first.pool.retire(),
      () => undefined,
    );
  }
  return engine;
}

/** The file of the same name in another folder. */
const beside = (folder: string | null, url: string): string =>
  folder === null
    ? new URL(url, import.meta.url).href
    : new URL(url.slice(url.lastIndexOf("/") + 1), new URL(folder.replace(/\/?$/, "/"), document.baseURI)).href;

async function compile(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw refused`the server answered ${response.status} for the planners' module.`;
  const isWasm = response.headers.get("content-type")?.startsWith("application/wasm") ?? false;
  return isWasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
