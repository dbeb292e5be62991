import type { PlannerId } from "parkade";
import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import type { Camera, Scene, State } from "../store";
import { chip } from "../styles/chip";
import { controls } from "../styles/controls";
import { layout } from "../styles/layout";
import { LAYER_PRESETS, layerSet, presetLayers, type LayerPreset } from "../store/layer-sets";
import type { Beginning } from "../app/app";
import { sceneViews } from "./arrangement";
import { DEFAULTS } from "./defaults";
import { watchScheme, type Scheme } from "./host-scheme";
import { Playground } from "./playground";
import { plain, SceneOpening } from "./scene-opening";
import { check, faultOfAttribute, RULES, type Known } from "../app/schema";
import { nth } from "../scene/nth";
import { hostOf } from "../panels/beside";
import { keysOf } from "../scene/records";

export { colours } from "./colours";

type Layout = State["mode"] | "single";

/**
 * A playground in somebody else's page: looked at until somebody wants to edit, quiet out of sight, and never in the
 * way of the page's wheel and keys. `loader.ts` puts it into `<parkade-playground>` and passes its attributes on.
 */
export class Embedded extends SceneOpening {
  static override properties = {
    ...Playground.properties,
    src: { type: String },
    controls: { type: String, reflect: true },
    editable: { type: String },
    autoplay: { type: Boolean },
    speed: { type: Number },
    layers: { type: String },
    smooth: { type: String },
    wheel: { type: String },
    budgetMs: { type: Number, attribute: "budget-ms" },
    workerUrl: { type: String, attribute: "worker-url" },
    wasmUrl: { type: String, attribute: "wasm-url" },
    viewing: { type: Boolean, reflect: true },
  };
  /** The colours are the outer element's, where the page can change them. */
  static override styles = [controls, layout, chip];

  declare controls: "full" | "minimal" | "none";
  declare editable: string | null;
  declare autoplay: boolean;
  declare speed: number;
  declare layers: string;
  declare smooth: string | null;
  declare wheel: "ctrl" | "always" | "none";
  declare budgetMs: number | null;
  declare workerUrl: string | null;
  declare wasmUrl: string | null;
  declare viewing: boolean;
  onStep: (share: number) => void = () => {};
  onTheme: (theme: State["theme"]) => void = () => {};
  private run = 0;
  private running = false;
  private readonly sight = new IntersectionObserver(([entry]) => this.seen(entry?.isIntersecting ?? false));
  private wasPlaying = false;
  private scheme: Scheme = "light";
  private touch = (): void => {};
  /** Resolves where somebody does more than look at a bare picture. */
  private readonly touched = new Promise<void>((resolve) => {
    this.touch = resolve;
  });
  private unwatch = (): void => {};

  constructor() {
    super();
    this.editable = this.smooth = this.budgetMs = this.workerUrl = this.wasmUrl = null;
    this.controls = "full";
    this.layers = "";
    this.wheel = "ctrl";
    this.speed = 1;
    this.autoplay = false;
    this.viewing = this.bare = true;
  }

  override get alone(): boolean {
    return false;
  }

  override connectedCallback(): void {
    this.viewing = this.editable === null || this.editable === "false";
    this.app.folders = { worker: this.workerUrl || null, wasm: this.wasmUrl || null };
    this.unwatch = watchScheme(hostOf(this), (scheme) => {
      this.scheme = scheme;
      this.paint();
    });
    super.connectedCallback();
    this.sight.observe(this);
    this.addEventListener("wheel", this.onWheel, { capture: true });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.unwatch();
    this.sight.disconnect();
    this.removeEventListener("wheel", this.onWheel, { capture: true });
  }

  override get isFull(): boolean {
    return this.controls !== "minimal" && this.controls !== "none";
  }

  get params(): Scene["planners"] {
    return this.store.state.scene.planners ?? {};
  }

  set params(planners: Scene["planners"]) {
    this.later(async () => {
      const ids = keysOf(planners ?? {}),
        known = this.app.catalog!.planners;
      if (!ids.every((id) => known.some((info) => info.id === id))) await this.app.complete();
      check(planners ?? {}, RULES.params(this.known), "params");
      this.store.edit({ ...this.store.state.scene, planners: planners ?? {} }, { label: "params" });
    });
  }

  get playhead(): number {
    return this.store.state.playback.fraction;
  }

  set playhead(fraction: number) {
    this.later(() => this.app.player.seek(check(fraction, RULES.playhead(), "playhead")));
  }

  get camera(): Camera | null {
    return this.store.state.camera;
  }

  set camera(camera: Camera | null) {
    this.later(() => this.store.set({ camera: check<Camera | null>(camera, RULES.camera(this.known), "camera") }));
  }

  plan(): Promise<void> {
    if (this.loaded) this.app.planning?.again();
    return this.settled();
  }

  cancel(): void {
    this.app.planning?.cancel();
  }
  getScene(): Scene {
    return this.store.state.scene;
  }

  /** Rejects what is no scene. */
  async setScene(scene: Scene): Promise<void> {
    if (this.failure) this.retry(plain(scene));
    else await this.change(() => this.app.openForeign(plain(scene)));
    await this.settled();
  }

  /** Rejects what is no moment of the timeline. */
  override async seek(fraction: number, options: { base?: "search" | "drive" } = {}): Promise<void> {
    await this.change(() => {
      check(fraction, RULES.playhead(), "seek");
      check(options, RULES.seekOptions(), "seek.options");
      super.seek(fraction, options);
    });
  }

  /** Opens the scene of a share link, or of what follows its `#s=`. */
  async openLink(link: string): Promise<void> {
    await this.change(() => check(link, RULES.link(), "openLink"));
    const { decodeScene } = await import("../scene/link");
    return this.setScene(await decodeScene(link.slice(link.lastIndexOf("#s=") + (link.includes("#s=") ? 3 : 1))));
  }

  /** The scene on the page that comes with this element: the one around knows nothing of links. */
  override shareURL(): Promise<string | null> {
    return this.app.links.address(false, new URL(/* @vite-ignore */ "../index.html", import.meta.url).href);
  }

  /** The maps as on screen. */
  async toSVG(): Promise<string> {
    const [{ svgOf }] = await Promise.all([import("../panels/svg-csv"), this.app.complete()]);
    return svgOf(this, sceneViews(this.renderRoot), this.store.state, this.app.tokens());
  }

  /** The focused planner's path, once it is planned. */
  async toCSV(): Promise<string> {
    const [{ csvOf }] = await Promise.all([import("../panels/svg-csv"), this.app.complete()]);
    if (!this.store.state.results[this.store.state.focus]?.plan) await this.settled();
    return csvOf(this.store.state);
  }

  /** Resolves after a frame in which everything is drawn. */
  async drawn(): Promise<void> {
    await this.updateComplete;
    await frames(1);
    this.bare = false;
    await frames(2);
  }

  /** Pictures of a kind that browsers make. */
  override async toBlob(options: { type?: string } = {}): Promise<Blob | null> {
    await this.change(() => check(options, RULES.blobOptions(), "toBlob.options"));
    return super.toBlob(options);
  }

  protected override takeScene(scene: Scene): void {
    void this.change(() => this.app.openForeign(plain(scene))).catch(() => undefined);
  }

  protected override beginning(): Omit<Beginning, "loaded"> {
    this.onStep(0.6);
    // An element that was moved goes on with its drawing.
    const given = this.loaded ? Promise.resolve(this.store.state.scene) : this.given();
    given.catch(() => undefined);
    return {
      preset: this.scene,
      syncAddress: false,
      drives: this.autoplay && !this.loaded,
      given,
      wanted: this.touched,
    };
  }

  /** Writes the scheme where the colours are chosen by it. */
  private paint(): void {
    hostOf(this).dataset["scheme"] = this.theme === "auto" ? this.scheme : this.theme;
    this.themeChanged();
  }

  protected override adopt(): void {
    // A change of place changes no setting.
    if (this.loaded && !this.app.planning) return;
    super.adopt();
    const { playback } = this.store.state;
    this.store.set({
      ...(this.layers ? { layers: layersOf(this.layers) } : {}),
      ...(this.smooth ? { smooth: this.smooth !== "false" } : {}),
      playback: { ...playback, speed: this.speed },
    });
  }

  protected override arrange(): void {
    const asked = this.layout as Layout;
    if (asked !== "single") return super.arrange();
    const { planners } = this.store.state;
    const one: PlannerId[] = planners.includes("hybrid") ? ["hybrid"] : planners.slice(-1);
    this.store.set({ planners: one, focus: nth(one, 0), mode: "grid" });
  }

  /** An attribute that breaks its rule changes nothing. */
  override attributeChangedCallback(name: string, old: string | null, value: string | null): void {
    const broken = value !== null && faultOfAttribute(name, value);
    // The loader sets attributes before this element is in the page, where events are heard.
    if (broken) return void Promise.resolve().then(() => this.emitRefusal(broken));
    if (name === "planners" && value && this.loaded)
      void this.change(() => this.showPlanners(value)).catch(() => undefined);
    else this.take(name, old, value);
  }

  /** Shows these planners and no others. */
  private async showPlanners(names: string): Promise<void> {
    await this.app.complete();
    check(namesIn(names), RULES.planners(this.known), "planners");
    this.take("planners", null, names);
  }

  private take(name: string, old: string | null, value: string | null): void {
    const replaced = this.loaded && name === "scene";
    if (!replaced) super.attributeChangedCallback(name, old, value ?? DEFAULTS[name] ?? null);
    if (old === value || !this.isConnected) return;
    if (name === "planners" && !value) this.app.showFirstPlanners();
    if (["planners", "layers", "smooth", "speed"].includes(name)) this.adopt();
    else if (name === "editable") this.viewing = value === null || value === "false";
    else if (name === "theme") this.paint();
    else if (name === "src" || name === "scene") this.reopen(name, value ?? DEFAULTS[name] ?? null);
  }

  /** Opens the scene that an attribute names now, also where the one before could not be opened. */
  private reopen(name: "src" | "scene", value: string | null): void {
    if (value === null) return;
    if (!this.loaded) {
      if (name === "scene") this.src = null;
      if (this.failure) this.retry(null);
      return;
    }
    void this.change(async () => {
      if (name === "src") return this.app.openForeign((await this.given())!);
      await this.app.complete();
      const unknown = this.unknownScene(value);
      if (unknown) throw unknown;
      this.scene = value;
    }).catch(() => undefined);
  }

  protected override updated(changed: PropertyValues): void {
    super.updated(changed);
    if (this.app.planning) this.app.planning.budget = this.budgetMs;
    if (changed.has("controls")) this.fetchParts();
    if (this.isFull || !this.viewing) this.touch();
    if (changed.has("loaded") && this.loaded) this.onStep(0.8);
  }

  protected override render(): TemplateResult {
    return html`${super.render()}${
      this.viewing && this.loaded && this.editable !== "false" && this.controls !== "none"
        ? html`<button class="edit" part="chip" @click=${this.edit}>${this.app.t("embed.edit")}</button>`
        : nothing
    }`;
  }

  protected override onState(state: State, previous: State): void {
    const busy = state.planners.some((planner) => state.results[planner]?.status === "planning");
    this.begun(state, previous, busy);
    const { layers, hover, playback, canUndo } = state;
    if (canUndo || playback.playing || layers.tree || layers.redundant || (layers.risk && hover)) this.touch();
    super.onState(state, previous);
    if (state.theme !== previous.theme) this.onTheme(state.theme);
    if (state.playback.fraction !== previous.playback.fraction)
      this.emit("seek", { playhead: state.playback.fraction, base: state.playback.base });
    if (state.selection !== previous.selection) this.emit("select", { selection: state.selection });
    if (state.message !== previous.message && state.message?.tone === "err") {
      this.becomeDrawable();
      if (this.failure) this.emitRefusal(this.failure);
      else this.emit("error", { code: state.message.code ?? "", message: state.message.text });
    }
    if (this.running && !busy) this.emit("plan-complete", { results: this.results, id: this.run });
    this.running = busy;
  }

  /** Says that planning begins, and how far it is. */
  private begun(state: State, previous: State, busy: boolean): void {
    if (state.results === previous.results && state.progress === previous.progress) return;
    if (busy && (!this.running || state.scene !== previous.scene)) this.emit("plan-start", { id: ++this.run });
    for (const planner of state.planners) {
      const { plan, status } = state.results[planner] ?? {};
      // Answers to a scene that has changed since are no progress.
      const answered = status === "done" && plan && plan !== previous.results[planner]?.plan;
      const expansions = answered ? plan.stats.expanded : state.progress[planner];
      if (expansions !== undefined && expansions !== previous.progress[planner])
        this.emit("plan-progress", { planner, expansions });
    }
  }

  /** Under its poster nothing is drawn twice: first without a scene, then with it. */
  protected override async scheduleUpdate(): Promise<void> {
    if (!this.hasUpdated) await this.drawable;
    await super.scheduleUpdate();
  }

  private readonly edit = (): void => {
    this.viewing = false;
    void this.app.fetchPart(() => import("../panels/hints"));
    void this.updateComplete.then(() => sceneViews(this.renderRoot)[0]?.canvas?.focus());
  };

  /** The page's wheel stays the page's. */
  private readonly onWheel = (event: WheelEvent): void => {
    if (this.wheel === "none" || (this.wheel === "ctrl" && !event.ctrlKey && !event.metaKey)) event.stopPropagation();
  };

  private seen(visible: boolean): void {
    this.emit("visibility", { visible });
    if (visible) {
      this.app.planning?.resume();
      if (this.wasPlaying) this.app.player.play();
      this.wasPlaying = false;
      return;
    }
    this.wasPlaying = this.store.state.playback.playing;
    this.app.player.pause();
    this.app.planning?.suspend();
  }

  private get known(): Known {
    return { planners: this.app.catalog!.planners, map: this.store.state.scene.map };
  }
}

async function frames(count: number): Promise<void> {
  for (let i = 0; i < count; i++) await new Promise((done) => requestAnimationFrame(done));
}

const namesIn = (text: string): string[] => text.split(/\s+/).filter(Boolean);

/** A preset's name or the layers themselves. */
function layersOf(text: string): State["layers"] {
  const names = namesIn(text);
  const preset = LAYER_PRESETS.find((one) => names.length === 1 && one === names[0]) as LayerPreset | undefined;
  if (preset) return presetLayers(preset);
  return layerSet((key) => names.includes(key));
}

customElements.define("parkade-embedded", Embedded);
