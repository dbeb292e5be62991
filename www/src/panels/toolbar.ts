import { css, html, nothing, type TemplateResult } from "lit";
import { ariaKeys, shownChord, tooltip } from "../app/chord-text";
import { refusal } from "../app/app";
import type { Command } from "../app/command";
import { commands, isEnabled, TOOLS, type CommandId } from "../app/commands";
import "../i18n/later";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { piece } from "../view/piece";
import { AppElement } from "./base";
import { icon, logo, type IconName } from "../styles/icons";
import { Menus } from "./popover-controller";
import { nth } from "../scene/nth";
import type { On } from "./inputs";
import { sceneTitle } from "../app/scene-title";

const MODES: readonly { id: State["mode"]; icon: IconName }[] = [
  { id: "grid", icon: "grid" },
  { id: "overlay", icon: "overlay" },
  { id: "focus", icon: "focus" },
];

/** Contents of the menus. */
const menus = piece(() => import("./toolbar-menus"));
type MenuName = "planners" | "layers" | "exports" | "more";

/** The bar at the top: scene, history, tools, layers, layout, export, theme, language, share. */
export class Toolbar extends AppElement {
  static override properties = {
    ...AppElement.properties,
    compact: { type: Boolean, reflect: true },
    rail: { type: Boolean, reflect: true },
    inspecting: { type: Boolean },
    ready: { type: Boolean },
    shared: { state: true },
  };
  static override styles = [
    controls,
    css`
    :host {
      display: block; container-type: inline-size; background: var(--parkade-panel);
      border-bottom: 1px solid var(--parkade-hair); position: relative; z-index: 20;
    }
    .bar { display: flex; align-items: center; height: 48px; padding: 0 12px; gap: 5px; }
    .brand {
      display: flex; align-items: center; gap: 8px; font-size: 14px; line-height: 18px; font-weight: 650;
      margin: 0 8px 0 0;
    }
    .scene { flex: none; min-width: 140px; max-width: 240px; justify-content: space-between; }
    .scene span { overflow: hidden; text-overflow: ellipsis; font-weight: 500; }
    .scene svg, .menu svg:last-child { color: var(--parkade-t2); }
    .rule { width: 1px; height: 20px; background: var(--parkade-hair); margin: 0 3px; flex: none; }
    .tools { display: flex; gap: 2px; }
    .tool { position: relative; width: 32px; height: 34px; color: var(--parkade-t1); padding-right: 5px; }
    .tool kbd {
      position: absolute; right: 3px; bottom: 1px; font: inherit; font-size: 12px; line-height: 14px;
      color: var(--parkade-t3);
    }
    .tool:hover { background: var(--parkade-hover); }
    .tool:active { background: var(--parkade-press); }
    .tool[aria-pressed="true"] {
      background: var(--parkade-accent-soft); color: var(--parkade-accent);
      box-shadow: inset 0 0 0 1px var(--parkade-accent);
    }
    .tool[aria-pressed="true"] kbd { color: var(--parkade-accent); }
    .end { margin-left: auto; display: flex; align-items: center; gap: 4px; flex: none; }
    .modes button { padding: 0 8px; }
    .anchor { display: flex; }
    .popover { max-height: min(100vh - 72px, 100cqh - 54px); overflow-y: auto; }
    .popover .segmented { display: flex; margin: 2px 4px 6px; }
    .popover .segmented button { flex: 1; }
    .check {
      display: flex; align-items: center; gap: 10px; min-height: 28px; padding: 0 10px;
      border-radius: calc(6px * var(--parkade-radius)); cursor: pointer;
    }
    .check:hover { background: var(--parkade-hover); }
    .check input { accent-color: var(--parkade-accent); margin: 0; width: 14px; height: 14px; }
    .lang { padding: 0 8px; color: var(--parkade-t3); font-weight: 400; }
    .lang b { font-weight: 600; color: var(--parkade-t1); }
    .collapsed-1, .inspect { display: none; }
    .inspect[aria-expanded="true"] { background: var(--parkade-accent-soft); color: var(--parkade-accent); }
    /* Each stands where what is above would no longer fit in English; below 1280 a long scene's title gives way. */
    @container (max-width: 1580px) { .collapse-1 .label { display: none; } .tools { gap: 0; } }
    @container (max-width: 1490px) { .menu .label { display: none; } .menu { padding: 0 8px; } }
    @container (max-width: 1370px) { .tool { width: 30px; padding-right: 6px; } .tools { gap: 0; } }
    @container (max-width: 1330px) { .label { display: none; } }
    @container (max-width: 1300px) { .bays { display: none; } }
    @container (max-width: 1279px) {
      .scene { flex: 0 1 140px; min-width: 64px; }
      .tools { gap: 2px; }
      .tool { width: 32px; }
    }
    @container (max-width: 1230px) {
      .tool { padding: 0; }
      .tool kbd, .brand span { display: none; }
      .bar { gap: 4px; padding: 0 10px; }
      .rule { margin: 0 2px; }
    }
    @container (max-width: 1140px) {
      .collapse-1 { display: none; }
      .collapsed-1 { display: flex; }
      .tool { width: 28px; }
    }
    @container (max-width: 960px) { .inspect { display: inline-flex; } }
    @container (max-width: 925px) { .collapse-2 { display: none; } }
    @container (max-width: 830px) {
      .brand, .rule { display: none; }
      .tools { gap: 0; }
      .tool { width: 25px; }
      .modes button { padding: 0 5px; }
    }
    @container (max-width: 700px) {
      .tool { width: 24px; }
      .modes button { padding: 0 4px; }
      .bar { gap: 2px; }
      .icon { flex: none; }
    }
    :host([compact]) .bar { height: 44px; padding: 0 4px 0 6px; gap: 0; }
    :host([rail]) { border: 0; border-right: 1px solid var(--parkade-hair); container-type: normal; }
    :host([rail]) :is(.bar, .tools) { flex-direction: column; gap: 0; padding: 0; }
    :host([rail]) .bar { position: absolute; inset: 0; height: auto; }
    :host([rail]) .tools { flex: 1; min-height: 0; width: 100%; overflow-y: auto; scrollbar-width: none; }
    :host([rail]) .tool { flex: none; width: 48px; height: 44px; padding: 0; } :host([rail]) kbd { display: none; }
    :host([rail]) .popover { max-height: calc(100cqh - 8px); }
    :host([compact]) .scene {
      border: 0; background: none; font-weight: 600; flex: none; max-width: 230px; height: 44px;
    }
  `,
  ];
  declare compact: boolean;
  /** A column at the left, with the rest in a menu. */
  declare rail: boolean;
  /** True if the inspector lies over the map of a narrow window. */
  declare inspecting: boolean;
  declare ready: boolean;
  declare shared: boolean;
  protected override redrawMs = 100;
  readonly menus = new Menus<MenuName>(this);

  constructor() {
    super();
    this.compact = this.rail = this.inspecting = false;
    this.ready = false;
    this.shared = false;
  }

  protected watches(): readonly (keyof State)[] {
    return ["scene", "tool", "canUndo", "canRedo", "mode", "layers", "theme", "planners", "complete"];
  }

  protected override render(): unknown {
    return html`<div class="bar" role="toolbar" aria-label=${this.t("bar.label")}>${
      this.rail ? html`${this.moreMenu("")}${this.tools()}` : this.compact ? this.small() : this.full()
    }</div>`;
  }

  private full(): TemplateResult {
    return html`
      <h1 class="brand">${logo()}<span>${this.t("app.name")}</span></h1>
      ${this.scenePicker()}
      <span class="rule"></span>${this.history()}<span class="rule"></span>
      ${this.tools()}
      <span class="rule"></span>
      ${this.plannersMenu()}
      ${this.layersMenu()}
      <div class="segmented modes" role="group" aria-label=${this.t("bar.mode")}>${MODES.map((mode) =>
        this.mode(mode),
      )}</div>
      ${this.button("check", this.t("bar.checkBays"), this.checkBays, "bays")}
      <span class="end"><slot></slot>
        <span class="anchor collapse-1">
          <button class="button menu" popovertarget="exports" aria-expanded=${this.menus.open === "exports"}
            aria-label=${this.t("bar.export")} @click=${(e: On<HTMLElement>) => this.toggle("exports", e)}>
            ${icon("export")}<span class="label">${this.t("bar.export")}</span>${icon("down", 14)}</button>
          ${this.menus.open === "exports" ? this.menu("exports", "right") : nothing}
        </span>
        ${this.button("theme", this.themeName(), this.nextTheme, "collapse-1")}
        <button class="button lang collapse-1" aria-label=${this.t("bar.language")} title=${this.t("bar.language")}
          @click=${this.nextLang}>
          <span>${this.state.lang === "zh" ? html`<b>中</b> / EN` : html`中 / <b>EN</b>`}</span></button>
        ${this.command("keys", "collapse-1")}
        <button class="icon inspect" aria-expanded=${this.inspecting} aria-label=${this.t("bar.inspector")}
          title=${this.t("bar.inspector")} @click=${() => this.app.ask("inspect")}>${icon("sliders")}</button>
        ${this.moreMenu("collapsed-1")}
        <button class="button solid" @click=${this.share}>${icon(
          this.shared ? "check" : "share",
        )}<span class="label">${this.t(
          this.shared ? "bar.shared" : "bar.share",
        )}</span><span class="visually-hidden">${this.t("bar.share")}</span></button>
      </span>`;
  }

  private small(): TemplateResult {
    return html`${this.scenePicker()}<span class="end">${this.history()}${this.moreMenu("")}</span>`;
  }

  private scenePicker(): TemplateResult {
    const title = sceneTitle(this.app);
    return html`<button class="button outline scene" aria-label="${this.t("bar.scene")}: ${title || this.t("bar.own")}"
      ?disabled=${!this.ready} @click=${() => this.app.ask("presets")}>
      <span>${title || this.t("bar.own")}</span>${icon("down", 14)}</button>`;
  }

  private history(): TemplateResult {
    return html`${this.command("undo")}${this.command("redo")}`;
  }

  /** A command's icon as a button. */
  private command(id: CommandId, kind = ""): TemplateResult | typeof nothing {
    const command = commands[id];
    if (!command) return nothing;
    return html`<button class="icon ${kind}" ?disabled=${!isEnabled(this.state, command)}
      aria-label=${this.t(command.title)} aria-keyshortcuts=${ariaKeys(command)}
      title=${tooltip(this.state.lang, command)}
      @click=${() => command.run(this.app)}>${icon(command.icon!)}</button>`;
  }

  private tools(): TemplateResult {
    return html`<div class="tools" role="group" aria-label=${this.t("tools.label")}>${Object.entries(TOOLS).map(
      ([id, tool]) => this.tool(id, tool),
    )}</div>`;
  }

  private tool(id: string, tool: Command): TemplateResult {
    return html`<button class="tool" data-tool=${id} aria-pressed=${this.state.tool === id}
      aria-label=${this.t(tool.title)} aria-keyshortcuts=${ariaKeys(tool)} title=${tooltip(this.state.lang, tool)}
      @click=${() => tool.run(this.app)}>${icon(tool.icon!, 18)}<kbd aria-hidden="true">${tool.keys[0]}</kbd></button>`;
  }

  private mode(mode: (typeof MODES)[number]): TemplateResult {
    const name = this.t(`mode.${mode.id}`);
    return html`<button aria-pressed=${this.state.mode === mode.id} aria-label=${name}
      title="${name} · ${keysOf("nextLayout")}"
      @click=${() => this.app.store.set({ mode: mode.id, camera: null })}>${icon(mode.icon)}</button>`;
  }

  private plannersMenu(): TemplateResult {
    const open = (event: On<HTMLElement>): void => {
      void this.app.complete().catch((error: unknown) => this.app.refuse("error.load", { reason: refusal(error) }));
      this.toggle("planners", event);
    };
    return html`<span class="anchor collapse-2">
      <button class="button menu" popovertarget="planners" aria-expanded=${this.menus.open === "planners"}
        aria-label=${this.t("bar.planners")} title=${this.t("bar.planners")} ?disabled=${!this.ready} @click=${open}>
        ${icon("planners")}<span class="label">${this.t("bar.planners")}</span>${icon("down", 14)}</button>
      ${this.menus.open === "planners" ? this.menu("planners", "planners") : nothing}</span>`;
  }

  private layersMenu(): TemplateResult {
    return html`<span class="anchor collapse-2">
      <button class="button menu" popovertarget="layers" aria-expanded=${this.menus.open === "layers"}
        aria-label=${this.t("bar.layers")} title="${this.t("bar.layers")} · ${keysOf("previousLayers", "nextLayers")}"
        @click=${(e: On<HTMLElement>) => this.toggle("layers", e)}>
        ${icon("layers")}<span class="label">${this.t("bar.layers")}</span>${icon("down", 14)}</button>
      ${this.menus.open === "layers" ? this.menu("layers", "") : nothing}</span>`;
  }

  private moreMenu(name: string): TemplateResult {
    return html`<span class="anchor ${name}">
      <button class="icon" popovertarget="more" aria-expanded=${this.menus.open === "more"}
        aria-label=${this.t("bar.more")} title=${this.t("bar.more")}
        @click=${(e: On<HTMLElement>) => this.toggle("more", e)}>${icon("more")}</button>
      ${this.menus.open === "more" ? this.menu("more", this.rail ? "beside" : "right") : nothing}</span>`;
  }

  private menu(name: MenuName, kind: string): TemplateResult {
    return html`<div class="popover ${kind}" id=${name} popover>${menus()?.[name](this)}</div>`;
  }

  /** Menu contents are fetched after the first picture. */
  private toggle(name: MenuName, { currentTarget: opener }: On<HTMLElement>): void {
    void menus.load().then(
      () => this.menus.toggle(name, opener),
      (error: unknown) => this.app.refuse("error.load", { reason: refusal(error) }),
    );
  }

  private button(name: IconName, label: string, run: () => void, kind: string): TemplateResult {
    return html`<button class="icon ${kind}" aria-label=${label} title=${label} @click=${run}>${icon(name)}</button>`;
  }

  themeName(): string {
    return this.t("bar.theme", { theme: this.t(`theme.${this.state.theme}`) });
  }

  readonly nextTheme = (): void => {
    const order = ["auto", "light", "dark"] as const;
    this.app.store.set({ theme: nth(order, (order.indexOf(this.state.theme) + 1) % 3) });
  };

  readonly nextLang = (): void => void this.app.setLang(this.state.lang === "en" ? "zh" : "en");

  readonly checkBays = (): void =>
    void this.app.fetchPart(async () => (await import("./bay-panel")).toggleBays(this.app, this));

  readonly share = (): void => {
    void this.app.share().then((copied) => {
      this.shared = copied;
      if (copied)
        setTimeout(() => {
          this.shared = false;
        }, 2000);
    });
  };
}

const keysOf = (...ids: CommandId[]): string =>
  ids.map((id) => (commands[id]?.keys ?? []).map(shownChord).join(" / ")).join(" ");

customElements.define("parkade-toolbar", Toolbar);
