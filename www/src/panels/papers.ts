import { css, html, nothing, type TemplateResult } from "lit";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { DialogElement } from "./dialog";
import type { PapersTab } from "./papers-tab";
import { say } from "./papers-messages";
import { nth } from "../scene/nth";

type Tab = PapersTab<unknown>;

/** A paper each; what its tables need is fetched when they are first shown. */
const TABS = {
  grid: async (): Promise<Tab> => new (await import("./papers-grid")).PapersGrid(),
  parking: async (): Promise<Tab> => new (await import("./papers-parking")).PapersParking(),
  road: async (): Promise<Tab> => new (await import("./papers-road")).PapersRoad(),
  comparison: async (): Promise<Tab> => new (await import("./papers-comparison")).PapersComparison(),
} as const;
type TabName = keyof typeof TABS;
const NAMES = Object.keys(TABS) as TabName[];

/** The papers' printed values beside ours, measured while one looks on. */
export class PapersDialog extends DialogElement {
  static override properties = {
    ...DialogElement.properties,
    tab: { state: true },
    inside: { state: true },
  };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 1240px; height: 94vh; height: 94dvh; max-height: 94vh; max-height: 94dvh; }
    .top p { min-width: 0; } .tabs { margin: 0 24px 12px; align-self: start; } .panel { display: contents; }
    @media (max-width: 640px) { .tabs { margin: 0 16px 10px; } }
  `,
  ];
  declare tab: TabName;
  declare inside: Tab | null;
  private readonly made = new Map<TabName, Tab>();

  constructor() {
    super();
    this.tab = "grid";
    this.inside = null;
  }

  override open(): void {
    super.open();
    void this.show(this.tab);
  }

  protected override content(): TemplateResult {
    const { lang } = this.state;
    return html`${this.top(say(lang, "title"), say(lang, `${this.tab}Lead`))}
      <div class="segmented tabs" role="tablist" aria-label=${say(lang, "title")} @keydown=${this.keys}>${NAMES.map(
        (name) => html`
          <button id="tab-${name}" role="tab" aria-selected=${name === this.tab} aria-controls="panel"
          tabindex=${name === this.tab ? 0 : -1} @click=${() => void this.show(name)}>${say(lang, name)}</button>`,
      )}</div>
      <div id="panel" class="panel" role="tabpanel" aria-labelledby="tab-${this.tab}">${this.inside ?? nothing}</div>`;
  }

  private async show(name: TabName): Promise<void> {
    if (name !== this.tab) this.inside?.leave();
    this.tab = name;
    const content = this.made.get(name) ?? (await TABS[name]());
    content.app = this.app;
    this.made.set(name, content);
    if (!this.shown || this.tab !== name) return;
    this.inside = content;
    await this.updateComplete;
    content.enter();
  }

  private readonly keys = (event: KeyboardEvent): void => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const next = nth(NAMES, (NAMES.indexOf(this.tab) + step + NAMES.length) % NAMES.length);
    void this.show(next).then(() => this.renderRoot.querySelector<HTMLElement>(`#tab-${next}`)?.focus());
  };

  protected override closed(): void {
    this.inside?.leave();
  }
}

customElements.define("parkade-papers", PapersDialog);
