import type { Plan, PlannerId } from "parkade";
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { pickLang } from "../i18n/index";
import type { Scene, State, Store } from "../store";
import { controls } from "../styles/controls";
import { tokens } from "../styles/tokens";
import { layout } from "../styles/layout";
import type { MenuRequest } from "../tools/controller";
import { App, download, refusal, type Beginning, type Request } from "../app/app";
import { recall, remember } from "../store/preferences";
import { narrow, roomOf, sceneViews, wide } from "./arrangement";
import { follow, PARTS } from "./parts";
import "../panels/notices";
import "../panels/stage";
import "../panels/timeline";
import type { On } from "../panels/inputs";
import { messageOf } from "../i18n/said";

export const FIRST_SCENE = "perpendicular";
/**
 * Draws a scene and plans it with several planners at once: the page. What other pages embed is `Embedded`.
 *
 * Attributes: `scene` (a preset's id), `planners` (ids, spaced), `layout` (grid, overlay, focus), `theme` (auto, light,
 * dark), `lang` (en, zh), `permalink` (keeps the scene in the page's address). Events: `ready`, `scene-change` { scene,
 * reason, transient }, `plan-result` { planner, plan }.
 */
export class Playground extends LitElement {
  static override properties = {
    scene: { type: String },
    planners: { type: String },
    layout: { type: String },
    theme: { type: String, reflect: true },
    permalink: { type: Boolean },
    compact: { type: Boolean, reflect: true },
    rails: { type: Boolean, reflect: true },
    short: { type: Boolean, reflect: true },
    loaded: { state: true },
    folded: { type: Boolean, reflect: true },
    inspecting: { type: Boolean, reflect: true },
    dropping: { state: true },
    bare: { state: true },
  };
  static override styles = [tokens, controls, layout];
  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, "lang"];
  }

  declare scene: string;
  declare planners: string;
  declare layout: State["mode"];
  declare theme: State["theme"];
  declare permalink: boolean;
  declare compact: boolean;
  /** True if the controls stand in columns at both sides of the map. */
  declare rails: boolean;
  declare short: boolean;
  declare loaded: boolean;
  declare folded: boolean;
  /** True if the inspector lies over the map, where it has no column of its own. */
  declare inspecting: boolean;
  declare dropping: boolean;
  /** True if everything but the maps is still to come, into the boxes that are kept for it. */
  declare bare: boolean;

  /** Resolves when the first scene is solved. */
  ready: Promise<void>;
  /** True if nothing is edited by pointer or keys. */
  declare viewing: boolean;
  protected readonly app = new App(this, (request, scale) => this.answer(request, scale));
  /** Resolves when there is a scene to draw, or something to say in its place. */
  protected readonly drawable: Promise<void>;
  protected becomeDrawable: () => void = () => {};
  protected becomeReady: () => void = () => {};
  private detach: (() => void)[] = [];
  private words: Promise<void> = Promise.resolve();
  private hasParts = false;

  constructor() {
    super();
    this.ready = new Promise((resolve) => {
      this.becomeReady = resolve;
    });
    this.drawable = new Promise((resolve) => {
      this.becomeDrawable = resolve;
    });
    this.scene = FIRST_SCENE;
    this.planners = "";
    this.layout = "grid";
    this.theme = "auto";
    this.viewing = this.permalink = this.compact = this.rails = this.short = false;
    this.loaded = this.folded = this.inspecting = this.dropping = this.bare = false;
    // A value set before this element was defined hides the accessor.
    const early = Object.getOwnPropertyDescriptor(this, "sceneData")?.value as Scene | undefined;
    delete (this as { sceneData?: Scene }).sceneData;
    if (early) this.sceneData = early;
  }

  get store(): Store {
    return this.app.store;
  }

  /** Alone on its page. */
  get alone(): boolean {
    return this.permalink;
  }

  get results(): Record<string, Plan | null> {
    return Object.fromEntries(
      Object.entries(this.store.state.results).map(([planner, result]) => [planner, result.plan]),
    );
  }

  get sceneData(): Scene {
    return this.store.state.scene;
  }

  set sceneData(scene: Scene) {
    if (this.loaded) this.takeScene(scene);
    else void this.ready.then(() => this.takeScene(scene));
  }

  /** Opens a scene of the page around, or says what is wrong with it. */
  protected takeScene(scene: Scene): void {
    this.app.openForeign(scene).catch((error: unknown) => this.app.refuse("error.scene", { reason: refusal(error) }));
  }

  get canUndo(): boolean {
    return this.store.state.canUndo;
  }

  get canRedo(): boolean {
    return this.store.state.canRedo;
  }

  undo(): void {
    this.store.undo();
  }
  redo(): void {
    this.store.redo();
  }
  reset(): void {
    this.app.reset();
  }
  fit(): void {
    this.app.controller.fit();
  }
  play(): void {
    this.app.player.play();
  }
  pause(): void {
    this.app.player.pause();
  }
  seek(fraction: number, options: { base?: "search" | "drive" } = {}): void {
    if (options.base) this.app.player.set({ base: options.base });
    this.app.player.seek(fraction);
  }

  /** Resolves when every planner has answered for the present scene. */
  async settled(): Promise<void> {
    await this.ready;
    await this.app.planning?.whenSettled();
  }

  shareURL(): Promise<string | null> {
    return this.app.links.address();
  }

  async toBlob({ type = "image/png" }: { type?: string } = {}): Promise<Blob | null> {
    const { picture } = await import("./screenshot");
    return picture(this.app, sceneViews(this.renderRoot), { type });
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.adopt();
    const resize = new ResizeObserver(([entry]) => {
      if (entry) this.measure(entry.contentRect);
    });
    resize.observe(this);
    const scheme = matchMedia("(prefers-color-scheme: dark)");
    const onScheme = (): void => this.themeChanged();
    scheme.addEventListener("change", onScheme);
    this.detach = [
      () => resize.disconnect(),
      () => scheme.removeEventListener("change", onScheme),
      this.store.subscribe((state, previous) => this.onState(state, previous)),
    ];
    void this.app.fetchPart(() => this.takeKeys(this.detach));
    this.measure(this.getBoundingClientRect());
    void this.begin();
    this.fetchParts();
  }

  /** Keys come after the first picture; `detach` is another list once the element has left its page. */
  private async takeKeys(detach: (() => void)[]): Promise<void> {
    const { listenToKeys } = await import("../app/keyboard");
    if (this.detach === detach) detach.push(listenToKeys(this, this.app));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const stop of this.detach) stop();
    this.detach = [];
    this.app.stop();
  }

  override attributeChangedCallback(name: string, old: string | null, value: string | null): void {
    super.attributeChangedCallback(name, old, value);
    if (name === "lang" && this.isConnected && value && value !== this.store.state.lang)
      void this.app.setLang(pickLang(value));
  }

  /** True if there is more than the map and the timeline. */
  get isFull(): boolean {
    return true;
  }

  /** Fetches what the first picture does without, where it is going to be shown. */
  protected fetchParts(): void {
    if (!this.isFull || this.hasParts) return;
    this.hasParts = true;
    for (const part of PARTS) void this.app.fetchPart(part);
  }

  protected override willUpdate(changed: PropertyValues): void {
    if (changed.has("theme")) this.store.set({ theme: this.theme });
    if (changed.has("layout") && this.hasUpdated) this.arrange();
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has("theme")) this.themeChanged();
    // The first update may come after the first scene, which need not be a preset.
    if (changed.get("scene") !== undefined && this.loaded) this.app.openPreset(this.scene);
  }

  protected override render(): TemplateResult {
    const { app, compact, rails, bare } = this;
    return html`<div class="layout-${compact ? "narrow" : "wide"} ${rails ? "rails" : ""} ${bare ? "bare" : ""}"
        role="region" aria-label=${app.t("app.label")} @parkade-menu=${this.onMenu} @dragover=${this.onDragOver}
        @dragleave=${() => (this.dropping = false)} @drop=${this.onDrop}>
      ${
        this.isFull && !bare
          ? html`<parkade-toolbar part="toolbar" .app=${app} .ready=${this.loaded} ?compact=${compact} ?rail=${rails}
            .inspecting=${this.inspecting}><slot name="toolbar-extra"></slot></parkade-toolbar>`
          : nothing
      }
      <parkade-stage exportparts="panel, canvas" .app=${app} ?compact=${compact} .bare=${bare}></parkade-stage>
      ${bare ? nothing : this.rest()}
    </div>`;
  }

  /** The controls around and over the maps. */
  private rest(): TemplateResult {
    return html`${this.compact ? narrow(this, this.app) : wide(this, this.app)}
      <parkade-entry .app=${this.app}></parkade-entry> <parkade-hints .app=${this.app}></parkade-hints>
      <parkade-notices .app=${this.app}></parkade-notices>
      ${this.dropping ? html`<div class="dropping">${this.app.t("drop.here")}</div>` : nothing}
      <parkade-presets .app=${this.app}></parkade-presets> <parkade-keys .app=${this.app}></parkade-keys>
      <parkade-papers .app=${this.app}></parkade-papers> <parkade-image .app=${this.app}></parkade-image>
      <parkade-context .app=${this.app}></parkade-context> <parkade-import .app=${this.app}></parkade-import>
      <input class="file" type="file" hidden multiple
        accept=".json,.map,.scen,.yaml,.yml,.pgm,.csv,.dxf,.osm,.geojson,image/*" aria-label=${this.app.t("bar.open")}
        @change=${this.onFile}>`;
  }

  /** Takes language, theme, layout and planners from attributes and from the last visit. */
  protected adopt(): void {
    const remembered = this.permalink ? recall("theme") : null;
    if (remembered === "light" || remembered === "dark") this.theme = remembered;
    // Ids that no planner has are dropped, with a word, when the planners are there.
    const ids = [...new Set(this.planners.split(/\s+/).filter(Boolean))] as PlannerId[];
    this.store.set({
      theme: this.theme,
      ...(ids.length > 0 ? { planners: ids, focus: ids.includes("hybrid") ? "hybrid" : ids.at(-1)! } : {}),
    });
    this.arrange();
    this.words = this.app
      .setLang(pickLang((this.permalink ? recall("lang") : null) ?? this.getAttribute("lang")))
      .then(() => this.setAttribute("lang", this.store.state.lang));
  }

  protected arrange(): void {
    this.store.set({ mode: this.layout });
  }

  /** Nothing is drawn before its words are there. */
  protected override async scheduleUpdate(): Promise<void> {
    await this.words;
    super.scheduleUpdate();
  }

  private measure(size: { width: number; height: number }): void {
    Object.assign(this, roomOf(size, this.alone));
    if (this.compact) void this.app.fetchPart(() => import("../panels/mobile-sheet"));
  }

  protected async begin(): Promise<void> {
    try {
      await this.app.start({ ...this.beginning(), loaded: () => this.becomeLoaded() });
      if (!this.loaded) return;
      if (this.permalink) requestAnimationFrame(() => document.getElementById("poster")?.remove());
      this.becomeReady();
      this.emit("ready", {});
    } catch (error) {
      this.app.refuse("app.unsupported", { reason: messageOf(error) });
    }
  }

  /** There is a scene to draw and to edit. */
  protected becomeLoaded(): void {
    this.loaded = true;
    this.becomeDrawable();
    void follow(this.app);
  }

  /** The first view. */
  protected beginning(): Omit<Beginning, "loaded"> {
    return { preset: this.scene, syncAddress: this.permalink, drives: true, given: Promise.resolve(null) };
  }

  protected onState(state: State, previous: State): void {
    if (state.theme !== previous.theme) {
      this.theme = state.theme;
      if (this.permalink) remember("theme", state.theme);
    }
    if (state.lang !== previous.lang) {
      this.setAttribute("lang", state.lang);
      if (this.permalink) remember("lang", state.lang);
      this.requestUpdate();
    }
    if (state.scene !== previous.scene || state.transient !== previous.transient) {
      this.emit("scene-change", { scene: state.scene, reason: state.reason, transient: state.transient });
    }
    if (state.results === previous.results) return;
    for (const planner of state.planners) {
      const plan = state.results[planner]?.plan;
      if (plan && plan !== previous.results[planner]?.plan) this.emit("plan-result", { planner, plan });
    }
  }

  protected themeChanged(): void {
    this.app.themeChanged();
    // A new object makes every canvas draw again, in the new colours.
    this.store.set({ layers: { ...this.store.state.layers } });
  }

  private answer(request: Request, scale = 1): void {
    if (request === "fold") this.folded = !this.folded;
    else if (request === "inspect") this.inspecting = !this.inspecting;
    else if (request === "open") this.renderRoot.querySelector<HTMLElement>(".file")?.click();
    else if (request === "hints") void import("../panels/hints");
    else
      void (request === "png"
        ? this.savePicture(scale)
        : this.ask(({ openDialog }) => openDialog(this.renderRoot, request)));
  }

  private async savePicture(scale: number): Promise<void> {
    const { picture } = await import("./screenshot");
    const blob = await picture(this.app, sceneViews(this.renderRoot), { scale });
    if (blob) download(blob, `parkade${scale > 1 ? `@${scale}x` : ""}.png`);
  }

  private ask(what: (dialogs: typeof import("./dialogs")) => Promise<void>): Promise<void> {
    return this.app.fetchPart(async () => what(await import("./dialogs")));
  }

  private openFiles(files: Iterable<File> | null | undefined): void {
    const list = [...(files ?? [])];
    void this.ask(({ openFiles }) => openFiles(this.renderRoot, list));
  }

  private readonly onFile = ({ currentTarget: input }: On<HTMLInputElement>): void => {
    this.openFiles(input.files);
    input.value = "";
  };

  private readonly onMenu = ({ detail }: CustomEvent<MenuRequest>): void =>
    void this.ask(({ showMenu }) => showMenu(this.renderRoot, detail));

  private readonly onDragOver = (event: DragEvent): void => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    this.dropping = true;
  };

  private readonly onDrop = (event: DragEvent): void => {
    event.preventDefault();
    this.dropping = false;
    this.openFiles(event.dataTransfer?.files);
  };

  protected emit(name: string, detail: object): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
  }
}
