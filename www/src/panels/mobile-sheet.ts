import type { PlannerId } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import "../i18n/later";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { shortName } from "../styles/planner-style";
import { icon, marker } from "../styles/icons";
import { statusOf } from "../texts/status";
import "./charts";
import "./inspector";
import "./options";
import "./table";
import type { Command } from "../app/command";
import { TOOLS } from "../app/commands";
import { hostOf } from "./beside";
import type { On } from "./inputs";

const TABS = ["draw", "results", "params"] as const;
/** Of the sheet: closed, with the map above, with little of the map. Low pages keep some of the map. */
const HEIGHTS = ["0px", "min(148px, max(64px, 100cqh - 400px))", "min(340px, max(64px, 100cqh - 320px))"] as const;
/** A page lower than this begins with its sheet closed. */
const LOW = 560;
const LONG_PRESS_MS = 500;
/** Of the table, kept for it until it is there, CSS pixels. */
const TABLE = { head: 27, row: 29.25 };
const DRAG_PX = 6;

/** Planner chips of the phone, in a row or a column: a tap brings one to the front, a long press hides it. */
export class Chips extends AppElement {
  static override properties = { ...AppElement.properties, rail: { type: Boolean, reflect: true } };
  static override styles = [
    controls,
    css`
    :host { display: block; background: var(--parkade-panel); border-top: 1px solid var(--parkade-hair); }
    .chips {
      display: grid; grid-auto-flow: column; grid-auto-columns: minmax(76px, 1fr); gap: 6px; padding: 6px 10px;
      overflow: auto; scrollbar-width: none;
    }
    button {
      display: grid; grid-template-columns: 12px 1fr; gap: 0 6px; padding: 4px 8px; min-width: 0; min-height: 44px;
      text-align: left; align-items: center; font-size: 12px; line-height: 15px; border: 1px solid var(--parkade-hair2);
      border-radius: calc(10px * var(--parkade-radius)); touch-action: manipulation; user-select: none;
      -webkit-user-select: none;
    }
    button[aria-pressed="true"] { border-color: var(--parkade-t1); box-shadow: inset 0 0 0 1px var(--parkade-t1); }
    b { font-weight: 600; overflow: hidden; text-overflow: ellipsis; }
    span { grid-column: 2; color: var(--parkade-t2); overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
    .err { color: var(--parkade-err); } .warn { color: var(--parkade-warn); }
    .off b { color: var(--parkade-t3); text-decoration: line-through; }
    :host([rail]) { border: 0; border-left: 1px solid var(--parkade-hair); min-height: 0; }
    :host([rail]) .chips {
      grid-auto-flow: row; grid-template-columns: 1fr; align-content: start; gap: 4px; padding: 4px; height: 100%;
    }
    :host([rail]) button {
      grid-template-columns: 1fr; justify-items: center; gap: 2px 0; padding: 4px 0; min-height: 48px;
      border-radius: calc(6px * var(--parkade-radius));
    }
    :host([rail]) span { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
    :host([rail]) b { max-width: 100%; }
  `,
  ];
  declare rail: boolean;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private held = false;

  protected watches(): readonly (keyof State)[] {
    return ["planners", "focus", "hidden", "results"];
  }

  protected override render(): TemplateResult {
    const { planners, focus, hidden } = this.state;
    return html`<div class="chips">${planners.map((planner) => {
      const status = statusOf(this.state, planner);
      return html`<button data-planner=${planner} class=${hidden.has(planner) ? "off" : ""}
        aria-pressed=${planner === focus}
        @click=${() => this.tap(planner)} @pointerdown=${() => this.press(planner)} @pointerup=${this.release}
        @pointercancel=${this.release} @contextmenu=${(e: Event) => e.preventDefault()}>
        ${marker(planner)}<b>${shortName(this.state.lang, planner)}</b><span class=${status.tone}
          title=${status.chip}>${status.tiny}</span></button>`;
    })}</div>`;
  }

  private press(planner: PlannerId): void {
    this.held = false;
    this.timer = setTimeout(() => {
      this.held = true;
      const hidden = new Set(this.state.hidden);
      if (!hidden.delete(planner)) hidden.add(planner);
      this.app.store.set({ hidden });
    }, LONG_PRESS_MS);
  }

  private readonly release = (): void => clearTimeout(this.timer);

  private tap(planner: PlannerId): void {
    if (!this.held) this.app.store.set({ focus: planner });
  }
}

/** The phone's bottom sheet with three heights, and the row of tools under it; on its side a drawer at the right. */
export class MobileSheet extends AppElement {
  static override properties = {
    ...AppElement.properties,
    ready: { type: Boolean },
    drawer: { type: Boolean, reflect: true },
    open: { state: true },
    tab: { state: true },
    size: { state: true },
  };
  static override styles = [
    controls,
    css`
    :host { display: block; background: var(--parkade-app); }
    .sheet {
      background: var(--parkade-raise);
      border-radius: calc(14px * var(--parkade-radius)) calc(14px * var(--parkade-radius)) 0 0;
      box-shadow: 0 -1px 0 var(--parkade-hair);
    }
    .grip { display: block; width: 100%; height: 24px; touch-action: none; cursor: ns-resize; position: relative; }
    .grip::before { content: ""; position: absolute; inset: -10px 0 0; }
    .grip::after {
      content: ""; position: absolute; left: 50%; top: 9px; width: 36px; height: 4px; margin-left: -18px;
      border-radius: 2px; background: var(--parkade-hair2);
    }
    .segmented { display: flex; margin: 0 10px 6px; }
    .segmented button { flex: 1; height: 30px; position: relative; }
    .segmented button::after { content: ""; position: absolute; inset: -7px 0; }
    .body {
      overflow-y: auto; overscroll-behavior: contain; transition: height var(--parkade-slow) var(--parkade-ease);
    }
    parkade-inspector { border: 0; }
    .tools {
      display: flex; justify-content: space-between; overflow-x: auto; scrollbar-width: none; height: 48px;
      padding: 0 6px; background: var(--parkade-panel); border-top: 1px solid var(--parkade-hair);
      padding-bottom: env(safe-area-inset-bottom); box-sizing: content-box;
    }
    .tools button { flex: 1 0 44px; height: 48px; max-width: 52px; color: var(--parkade-t1); }
    .tools button[aria-pressed="true"] {
      background: var(--parkade-accent-soft); color: var(--parkade-accent);
      box-shadow: inset 0 0 0 1px var(--parkade-accent);
    }
    .draw { padding: 10px 14px; color: var(--parkade-t2); }
    .toggle {
      width: 100%; height: 44px; border-left: 1px solid var(--parkade-hair); border-radius: 0;
      background: var(--parkade-panel);
    }
    .toggle[aria-expanded="true"] { color: var(--parkade-accent); }
    .drawer {
      position: absolute; z-index: 15; top: 0; right: 57px; bottom: 37px; width: min(320px, 100cqw - 106px);
      display: flex; flex-direction: column; padding-top: 8px; background: var(--parkade-raise);
      border-left: 1px solid var(--parkade-hair); box-shadow: var(--parkade-float);
      animation: slide var(--parkade-slow) var(--parkade-ease);
    }
    .drawer .body { flex: 1; min-height: 0; }
    @keyframes slide { from { transform: translateX(100%); opacity: 0; } }
    .charts { height: 200px; border-left: 0; border-top: 1px solid var(--parkade-hair); }
    .road { padding: 14px; border-top: 1px solid var(--parkade-hair); } .road:has(> [hidden]) { display: none; }
  `,
  ];
  declare ready: boolean;
  declare drawer: boolean;
  declare open: boolean;
  declare tab: (typeof TABS)[number];
  declare size: number;
  private drag: { y: number; size: number; moved: boolean } | null = null;

  constructor() {
    super();
    this.ready = this.drawer = this.open = false;
    this.tab = "results";
    this.size = 1;
  }

  protected watches(): readonly (keyof State)[] {
    return ["tool", "planners"];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    const host = hostOf(this);
    if (host.clientHeight < LOW) this.size = 0;
  }

  protected override render(): TemplateResult {
    return this.drawer ? this.asDrawer() : this.asSheet();
  }

  private asDrawer(): TemplateResult {
    const { open } = this;
    return html`<button class="icon toggle" aria-label=${this.t("sheet.label")} aria-expanded=${open} @click=${() => {
      this.open = !open;
    }}>${icon(open ? "close" : "sliders", 18)}</button>
      ${
        open
          ? html`<div class="drawer" role="region" aria-label=${this.t("sheet.label")}>${this.tabs()}
            <div class="body" id="body" role="tabpanel" tabindex="0"
            aria-label=${this.t(`sheet.${this.tab}`)}>${this.content()}</div></div>`
          : nothing
      }`;
  }

  private asSheet(): TemplateResult {
    return html`<div class="sheet" role="region" aria-label=${this.t("sheet.label")}>
        <button class="grip" aria-label=${this.t("sheet.grip")} aria-expanded=${this.size > 0} @pointerdown=${this.grab}
          @pointermove=${this.pull} @pointerup=${this.drop} @click=${this.next}></button>
        ${this.tabs()}
        <div class="body" id="body" role="tabpanel" tabindex="0" aria-label=${this.t(`sheet.${this.tab}`)}
          .style=${`height:${HEIGHTS[this.size]}`}>${this.size > 0 ? this.content() : nothing}</div>
      </div>
      <div class="tools" role="toolbar" aria-label=${this.t("tools.label")}>${Object.entries(TOOLS).map(
        ([id, tool]) => html`
          <button data-tool=${id} aria-pressed=${id === this.state.tool} aria-label=${this.t(tool.title)}
          @click=${() => this.arm(tool)}>${icon(tool.icon!, 20)}</button>`,
      )}</div>`;
  }

  private tabs(): TemplateResult {
    return html`<div class="segmented" role="tablist" aria-label=${this.t("sheet.label")}>${TABS.map(
      (tab) => html`
        <button role="tab" aria-selected=${tab === this.tab} aria-controls="body"
        @click=${() => this.show(tab)}>${this.t(`sheet.${tab}`)}</button>`,
    )}</div>`;
  }

  /** A tool's settings are shown with it. */
  private arm(tool: Command): void {
    tool.run(this.app);
    if (tool === TOOLS.select || tool === TOOLS.hand) return;
    this.tab = "draw";
    this.size = 1;
  }

  private content(): TemplateResult {
    if (this.tab === "results")
      return html`<parkade-table .app=${this.app} compact
        .style=${`min-height:${TABLE.head + TABLE.row * this.state.planners.length}px`}></parkade-table><parkade-charts
        class="charts" .app=${this.app}></parkade-charts>${
          this.ready ? html`<div class="road"><parkade-road-card .app=${this.app}></parkade-road-card></div>` : nothing
        }`;
    if (this.tab === "params")
      return html`<parkade-inspector .app=${this.app} .ready=${this.ready}></parkade-inspector>`;
    return html`${this.drawer ? nothing : html`<parkade-options .app=${this.app} flat></parkade-options>`}${
      this.ready
        ? html`<div class="draw"><parkade-selection .app=${this.app}></parkade-selection></div><div
          class="draw"><parkade-objects .app=${this.app}></parkade-objects></div>`
        : nothing
    }`;
  }

  private show(tab: (typeof TABS)[number]): void {
    this.tab = tab;
    if (this.size === 0) this.size = 1;
    if (tab === "params") this.size = 2;
  }

  private readonly grab = (event: On<HTMLElement, PointerEvent>): void => {
    event.currentTarget.setPointerCapture(event.pointerId);
    this.drag = { y: event.clientY, size: this.size, moved: false };
  };

  private readonly pull = (event: PointerEvent): void => {
    if (!this.drag) return;
    const up = this.drag.y - event.clientY;
    if (Math.abs(up) > DRAG_PX) this.drag.moved = true;
    this.size = Math.min(2, Math.max(0, this.drag.size + Math.round(up / 90)));
  };

  private readonly drop = (): void => {
    if (this.drag?.moved)
      setTimeout(() => {
        this.drag = null;
      });
    else this.drag = null;
  };

  private readonly next = (): void => {
    if (!this.drag) this.size = (this.size + 1) % HEIGHTS.length;
  };
}

customElements.define("parkade-chips", Chips);
customElements.define("parkade-sheet", MobileSheet);
