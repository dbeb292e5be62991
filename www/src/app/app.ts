import type { PlannerId, PlannerInfo, ScenarioInfo, SceneGeometry } from "parkade";
import { loadLang, translate, type Lang, type MessageKey, type Said, type Values } from "../i18n/index";
import { introduce } from "../styles/planner-style";
import { LAYER_PRESETS, presetLayers, presetOf } from "../store/layer-sets";
import { extentFor, loadEngine, whenWhole, type Engine, type Folders } from "../planning/engine-loader";
import { Planning } from "../planning/planning";
import { checkedScene, geometryOf } from "../scene/foreign";
import { ensureIds, isOneGoal } from "../scene/model";
import { forPlanners } from "../scene/large-scene";
import { createStore, FIRST_PLANNERS, type Scene, type State, type Store } from "../store";
import { ToolController } from "../tools/controller";
import { readTokens, type Tokens } from "../view/tokens";
import { LinkSync, type LinkView } from "./link-sync";
import { persistently } from "./retry";
import { Player } from "./player";
import type { ValueError } from "./schema";
import { messageOf } from "../i18n/said";

/** Planners shown for a road, the road planner first. */
const ROAD_PLANNERS: State["planners"] = ["cost-map", "eight", "risk-field", "hybrid"];

/** The contents of the loaded planners' module. */
export interface Catalog {
  planners: PlannerInfo[];
  scenarios: ScenarioInfo[];
  scenario(id: string): Scene;
  /** Throws what is wrong with a scene. */
  geometry(scene: Scene): SceneGeometry;
  /** A scene from outside as the page keeps it; throws what is wrong with it. */
  checked(scene: Scene): Scene;
}

/** What the element around does. */
export type Request = "presets" | "keys" | "papers" | "inspect" | "fold" | "open" | "png" | "hints";

export interface Beginning {
  preset: string;
  syncAddress: boolean;
  drives: boolean;
  given: Promise<Scene | null>;
  /** When the planners and formats that the first picture does without are worth their bytes. */
  wanted?: Promise<void>;
  loaded(): void;
}

/** Everything behind one playground: the store, its planners, its tools, and what the bar's buttons do. */
export class App {
  readonly store: Store = createStore();
  readonly controller = new ToolController(this.store);
  readonly player = new Player(this.store);
  folders: Folders = { worker: null, wasm: null };
  readonly links = new LinkSync(
    this.store,
    (scene, view) => this.openLink(scene, view),
    (error) => this.refuse("error.link", { reason: refusal(error) }),
  );
  catalog: Catalog | null = null;
  planning: Planning | null = null;
  /** Id of the catalogue's scene last opened. */
  preset: string | null = null;
  private remembering: Promise<void> | null = null;
  private stopSaving: (() => void) | null = null;
  private starting = new AbortController();
  private origin: Scene | null = null;
  private cachedTokens: Tokens | null = null;

  constructor(
    private readonly host: HTMLElement,
    /** Asks the element for a dialog, or for what only it can do; `scale` is a picture's. */
    readonly ask: (request: Request, scale?: number) => void,
  ) {}

  /**
   * Loads the planners and the first scene, the address's or else the given one or the preset's, and plans it; `loaded`
   * comes before the plans. `drives`: the car then parks once.
   */
  async start({ preset, syncAddress, drives, given, wanted, loaded }: Beginning): Promise<void> {
    const { signal } = (this.starting = new AbortController());
    const view = syncAddress ? await this.links.view() : null;
    let missed = false;
    const engine = await persistently(
      () => loadEngine(extentFor(view?.planners ?? this.store.state.planners), this.folders),
      (error) => {
        missed = true;
        if (syncAddress) document.documentElement.classList.add("failed");
        this.refuse("app.unsupported", { reason: refusal(error) });
      },
      signal,
    );
    if (!engine) return;
    if (missed) this.store.set({ message: null });
    this.catalog = catalogOf(engine);
    this.dropUnknownPlanners();
    const outside = await given,
      first = outside ? await this.checked(outside) : await this.firstScene(preset, syncAddress);
    this.origin = first;
    const looks = this.preset === null ? this.looksOf(view, first) : {};
    this.store.set({ scene: first, ...looks });
    if (syncAddress) {
      this.links.start();
      this.rememberFirstEdit();
    }
    this.planning = new Planning(this.store, await loadEngine("core", this.folders), () => this.complete());
    this.planning.start();
    loaded();
    void this.controller.fetchTools();
    await this.planning.whenSettled();
    if (drives && !looks.playback) this.player.driveIn();
    void Promise.race([wanted, whenWhole(this.folders)]).then(() =>
      requestIdle(() => void this.complete().catch(() => undefined)),
    );
    if (syncAddress) requestIdle(() => void this.writeAddress());
  }

  /** Every planner and format, which the first picture does not wait for. */
  async complete(): Promise<Engine> {
    const engine = await loadEngine("complete", this.folders);
    if (!this.store.state.complete) {
      this.catalog = catalogOf(engine);
      this.planning?.use(engine);
      this.store.set({ complete: true });
    }
    return engine;
  }

  /** Services of the full page only: drawings survive, and the page works offline. */
  private rememberFirstEdit(): void {
    const stop = this.store.subscribe((state, previous) => {
      if (!state.canUndo || state.scene === previous.scene) return;
      stop();
      void this.writeAddress();
    });
  }

  private writeAddress(): Promise<void> {
    return (this.remembering ??= this.keepDrawing());
  }

  private async keepDrawing(): Promise<void> {
    const [{ startAutosave }, { workOffline }] = await Promise.all([import("./autosave"), import("./offline")]);
    void workOffline();
    this.ask("hints");
    // Storage may be refused; nothing depends on it.
    this.stopSaving = await startAutosave(this).catch(() => null);
  }

  /**
   * Fetches code that the first picture does without. Browsers remember which scripts did not come: only another visit
   * fetches them.
   */
  async fetchPart(part: () => Promise<unknown>): Promise<void> {
    await part().catch(() => this.refuse("error.part", {}));
  }

  stop(): void {
    this.starting.abort();
    this.stopSaving?.();
    this.remembering = null;
    this.player.pause();
    this.links.stop();
    this.planning?.stop();
    this.planning = null;
  }

  /** The drawing's colours as they are now. */
  tokens(): Tokens {
    return (this.cachedTokens ??= readTokens(this.host));
  }

  themeChanged(): void {
    this.cachedTokens = null;
  }

  async setLang(lang: Lang): Promise<void> {
    this.store.set({ lang: await loadLang(lang) });
  }

  t(key: MessageKey, values?: Values): string {
    return translate(this.store.state.lang, key, values);
  }

  notify(tone: "err" | "warn" | "info", key: MessageKey, values?: Values): void {
    this.store.set({ message: { tone, text: this.t(key, values), code: key } });
  }

  private dropUnknownPlanners(): void {
    const { planners } = this.store.state;
    const known = planners.filter((id) => this.catalog?.planners.some((info) => info.id === id));
    if (known.length === planners.length) return;
    const unknown = planners.filter((id) => !known.includes(id));
    this.refuse("error.planners", { unknown: unknown.join(", ") });
    if (known.length > 0) this.store.set({ planners: known, focus: known.at(-1)! });
    else this.showFirstPlanners();
  }

  /** Shows or hides a planner's map; the last one stays. */
  togglePlanner(id: PlannerId): void {
    const { planners, focus } = this.store.state;
    const order = this.catalog?.planners.map((info) => info.id) ?? planners;
    const next = order.filter((one) => planners.includes(one) !== (one === id));
    if (next.length > 0) this.store.set({ planners: next, focus: next.includes(focus) ? focus : next.at(-1)! });
  }

  /** The four planners of the first picture. */
  showFirstPlanners(): void {
    this.store.set({ planners: FIRST_PLANNERS, focus: "hybrid" });
  }

  openPreset(id: string): void {
    if (!this.catalog) return;
    let scene: Scene;
    try {
      scene = this.catalog.scenario(id);
    } catch (error) {
      // The module of the first picture knows the first scenes only.
      if (this.store.state.complete) this.refuse("error.load", { reason: refusal(error) });
      else
        void this.complete().then(
          () => this.openPreset(id),
          (cause: unknown) => this.refuse("error.load", { reason: refusal(cause) }),
        );
      return;
    }
    void this.links.mark();
    this.preset = id;
    this.openScene(scene);
    this.show(!!scene.lanes?.length);
  }

  /** Roads are shown by the planner made for them, from its car at the start; others as they were before. */
  private show(road: boolean): void {
    const { planners } = this.store.state;
    if (road) {
      this.store.set({ planners: ROAD_PLANNERS, focus: "cost-map", follow: true });
      this.player.seek(0);
    } else if (planners === ROAD_PLANNERS) this.showFirstPlanners();
  }

  /** Replaces the whole scene in one undoable step. */
  openScene(scene: Scene): void {
    this.origin = scene;
    this.store.set({ camera: null, follow: false, selection: null, message: null });
    this.store.edit(scene, { label: "open" });
  }

  /** Throws what is wrong with the scene; it then stays as it was. */
  async openForeign(scene: Scene): Promise<void> {
    const checked = this.needsComplete(scene) ? await this.checked(scene) : this.catalog!.checked(scene);
    this.preset = null;
    this.openScene(checked);
  }

  /** The module of the first picture knows no sets of goals. */
  private needsComplete(scene: Scene): boolean {
    return !this.store.state.complete && !isOneGoal(Object(scene?.goal));
  }

  private async checked(scene: Scene): Promise<Scene> {
    if (this.needsComplete(scene)) await this.complete();
    return this.catalog!.checked(scene);
  }

  private async openLink(scene: Scene, view: LinkView | null): Promise<void> {
    if (view) await this.complete();
    await this.openForeign(scene);
    this.store.set(this.looksOf(view, scene));
  }

  /** How a link wants its scene looked at; nothing, and a sentence, where that makes no sense. */
  private looksOf(view: LinkView | null, { map }: Scene): Partial<State> {
    try {
      return view?.read({ planners: this.catalog!.planners, map }) ?? {};
    } catch (error) {
      this.refuse("error.view", { reason: (error as ValueError).sentence(this.store.state.lang) });
      return {};
    }
  }

  reset(): void {
    if (this.origin) this.openScene(this.origin);
  }

  async saveFile(): Promise<void> {
    const { fileName, sceneToFile } = await import("../scene/files");
    const { scene } = this.store.state;
    download(sceneToFile(forPlanners(scene, (await this.complete()).api.packRuns)), `${fileName(scene)}.json`);
  }

  async share(): Promise<boolean> {
    await this.links.write();
    const href = await this.links.address(true);
    if (!href) {
      this.notify("warn", "error.longLink");
      return false;
    }
    return this.copy(href);
  }

  async copy(text: string): Promise<boolean> {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      this.notify("warn", "error.copy");
      return false;
    }
  }

  cycleMode(): void {
    const order = ["grid", "overlay", "focus"] as const;
    const at = order.indexOf(this.store.state.mode);
    this.store.set({ mode: order[(at + 1) % order.length]!, camera: null });
  }

  cycleLayers(sign: 1 | -1): void {
    const now = presetOf(this.store.state.layers);
    const at = now ? LAYER_PRESETS.indexOf(now) : sign > 0 ? -1 : 0;
    const next = LAYER_PRESETS[(at + sign + LAYER_PRESETS.length) % LAYER_PRESETS.length]!;
    this.store.set({ layers: presetLayers(next) });
  }

  refuse(key: MessageKey, values: Values): void {
    this.notify("err", key, values);
  }

  /** The scene that this tab showed at this address, with its history. */
  private async beforeReload(): Promise<Scene | null> {
    try {
      return sessionStorage.length > 0 ? (await import("./history")).restoreHistory(this) : null;
    } catch {
      // Storage may be refused; nothing depends on it.
      return null;
    }
  }

  private async firstScene(preset: string, syncAddress: boolean): Promise<Scene> {
    try {
      const kept = syncAddress ? await this.beforeReload() : null;
      if (kept) return kept;
      const linked = syncAddress ? await this.links.read() : null;
      if (linked) return await this.checked(linked);
    } catch (error) {
      this.refuse("error.link", { reason: refusal(error) });
    }
    this.preset = preset;
    return this.catalog!.scenario(preset);
  }
}

/** Told once, however many playgrounds there are. */
const catalogs = new WeakMap<Engine, Catalog>();

function catalogOf(engine: Engine): Catalog {
  let catalog = catalogs.get(engine);
  if (!catalog) {
    const { api } = engine,
      opened = new Map<string, Scene>();
    catalog = {
      planners: api.planners(),
      scenarios: api.scenarios(),
      scenario: (id) => {
        const scene = opened.get(id) ?? ensureIds(api.scenario(id));
        opened.set(id, scene);
        return structuredClone(scene);
      },
      geometry: (scene) => geometryOf(scene, api),
      checked: (scene) => checkedScene(scene, api),
    };
    introduce(catalog.planners);
    catalogs.set(engine, catalog);
  }
  return catalog;
}

/** Safari has no requestIdleCallback. */
const requestIdle = (run: () => void): unknown =>
  typeof requestIdleCallback === "function" ? requestIdleCallback(run, { timeout: 5000 }) : setTimeout(run, 500);

/** The error's words, closed by a full stop so that more can follow. */
export function sentence(error: unknown): string {
  const text = messageOf(error).trim();
  return /[.!?。]$/.test(text) ? text : `${text}.`;
}

/** The same, with what a translation is made of. */
export const refusal = (error: unknown): Said => ({ ...(error instanceof Error && error), message: sentence(error) });

export function download(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
