import { css, html, LitElement, type PropertyValues } from "lit";
import { recall, remember } from "../store/preferences";
import messages from "../i18n/messages/splitter.json";
import { translator } from "../i18n/translator";
import type { Lang } from "../i18n/index";

const say = translator("splitter", messages);

export type Pane = "side" | "bottom" | "chart";
/** Pixels: least, usual, most. */
const SIZES: Record<Pane, readonly [number, number, number]> = {
  side: [220, 280, 520],
  bottom: [110, 202, 520],
  chart: [260, 500, 900],
};
const STEP = 16;

/** A bar between two panes: drag it, or move it by arrow keys; a double click takes the usual size. */
export class Splitter extends LitElement {
  static override properties = { pane: { type: String }, lang: { type: String }, size: { state: true } };
  static override styles = css`
    :host { display: block; position: relative; z-index: 6; touch-action: none; outline: none; }
    :host([pane="bottom"]) { cursor: ns-resize; height: 9px; margin: -4px 0; }
    :host(:not([pane="bottom"])) { cursor: ew-resize; width: 9px; margin: 0 -4px; }
    i { position: absolute; background: transparent; transition: background var(--parkade-fast); }
    :host([pane="bottom"]) i { inset: 3.5px 0; } :host(:not([pane="bottom"])) i { inset: 0 3.5px; }
    :host(:hover) i, :host(:focus-visible) i { background: var(--parkade-accent); }
    @media (pointer: coarse) {
      :host([pane="bottom"]) { height: 13px; margin: -6px 0; }
      :host(:not([pane="bottom"])) { width: 13px; margin: 0 -6px; }
    }
  `;
  declare pane: Pane;
  declare lang: Lang;
  declare size: number;
  private pulled = false;

  override connectedCallback(): void {
    super.connectedCallback();
    this.role = "separator";
    this.tabIndex = 0;
    this.addEventListener("pointerdown", this.grab);
    this.addEventListener("pointermove", this.pull);
    this.addEventListener("pointerup", this.drop);
    this.addEventListener("pointercancel", this.drop);
    this.addEventListener("dblclick", () => this.put(SIZES[this.pane][1]));
    this.addEventListener("keydown", this.key);
  }

  protected override willUpdate(changed: PropertyValues): void {
    if (changed.has("pane")) this.lay(Number(recall(`pane.${this.pane}`)) || SIZES[this.pane][1]);
    const [least, , most] = SIZES[this.pane];
    this.ariaLabel = say(this.lang, this.pane);
    this.ariaOrientation = this.pane === "bottom" ? "horizontal" : "vertical";
    this.ariaValueMin = String(least);
    this.ariaValueMax = String(most);
    this.ariaValueNow = String(Math.round(this.size));
  }

  protected override render(): unknown {
    return html`<i></i>`;
  }

  private put(size: number): void {
    this.lay(size);
    remember(`pane.${this.pane}`, String(Math.round(this.size)));
  }

  private lay(size: number): void {
    const [least, usual, most] = SIZES[this.pane];
    this.size = Math.min(most, Math.max(least, size));
    const { style } = this.closest<HTMLElement>(".layout-wide") ?? this;
    if (this.size === usual) style.removeProperty(`--pane-${this.pane}`);
    else style.setProperty(`--pane-${this.pane}`, `${this.size}px`);
  }

  private readonly grab = (event: PointerEvent): void => {
    this.setPointerCapture(event.pointerId);
    this.pulled = true;
    event.preventDefault();
    this.focus();
  };

  /** Every pane reaches to the right or the lower edge. */
  private readonly pull = (event: PointerEvent): void => {
    const edge = this.closest(".layout-wide")?.getBoundingClientRect();
    if (this.pulled && edge)
      this.put(this.pane === "bottom" ? edge.bottom - event.clientY : edge.right - event.clientX);
  };

  private readonly drop = (): void => {
    this.pulled = false;
  };

  private readonly key = (event: KeyboardEvent): void => {
    const sign = { ArrowUp: 1, ArrowLeft: 1, ArrowDown: -1, ArrowRight: -1 }[event.key];
    if (sign === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.put(this.size + sign * (event.shiftKey ? 4 : 1) * STEP);
  };
}

customElements.define("parkade-splitter", Splitter);
