import type { PlannerId } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { recall, remember } from "../element/memory";
import type { State, ToolId } from "../store";
import { plannerName } from "../view/identity";
import { AppElement } from "./base";
import { statusOf } from "./status";

const DRAWING: readonly ToolId[] = ["brush", "wall", "rectangle", "polygon"];
const FIRST = "hint.drag";
const STEPS = ["hint.wall", "hint.fails"] as const;
/** How far the bubble stays off the host's edges, and its arrow off its ends (px). */
const EDGE = 8, ARROW = 18;

interface Bubble { text: string; x: number; y: number; above: boolean }

/** What can be done next, after the first drag: one sentence at the tools, then one at the row of a planner that fails. */
export class NextHints extends AppElement {
  static override properties = { ...AppElement.properties, bubble: { state: true } };
  static override styles = css`
    :host { position: absolute; inset: 0; z-index: 20; pointer-events: none; overflow: hidden; }
    span { position: absolute; max-width: calc(100% - 16px); padding: 7px 12px; border-radius: calc(6px * var(--parkade-radius)); background: var(--parkade-t1); color: var(--parkade-panel); font-weight: 500; font-size: 13px; line-height: 18px; }
    i { position: absolute; width: 8px; height: 8px; margin-left: -4px; background: var(--parkade-t1); transform: rotate(45deg); }
  `;
  declare bubble: Bubble | null;
  private readonly observer = new ResizeObserver(() => this.place());

  constructor() {
    super();
    this.bubble = null;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
  }

  protected watches(): readonly (keyof State)[] {
    return this.step ? ["transient", "tool", "scene", "results", "focus"] : [];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { bubble } = this;
    if (!bubble) return nothing;
    const { x, y, above } = bubble;
    return html`<i .style=${`left:${x}px;top:${above ? y - 12 : y + 4}px`}></i>
      <span role="status" .style=${`top:${y + (above ? -8 : 8)}px;transform:translate(0, ${above ? "-100%" : "0"})`}>${bubble.text}</span>`;
  }

  protected override updated(): void {
    const words = this.renderRoot.querySelector("span");
    if (words && this.bubble) words.style.left = `${Math.max(EDGE, Math.min(this.bubble.x - words.offsetWidth / 2, this.offsetWidth - EDGE - words.offsetWidth))}px`;
    this.advance();
    this.place();
  }

  private get step(): (typeof STEPS)[number] | undefined {
    return STEPS.find((step) => recall(step) === null);
  }

  private advance(): void {
    const { tool, focus } = this.state, { step } = this;
    if (step === "hint.wall" && DRAWING.includes(tool)) remember(step, "seen");
    if (step === "hint.fails" && this.bubble && focus === this.failing()) remember(step, "seen");
  }

  private failing(): PlannerId | undefined {
    return this.state.planners.find((planner) => this.state.results[planner]?.status === "done" && statusOf(this.state, planner).tone === "err");
  }

  /** The anchors stand in other pieces' trees, which are drawn after this one. */
  private place(): void {
    requestAnimationFrame(() => {
      const anchor = this.state.transient || recall(FIRST) === null ? null : this.anchor();
      const bubble = anchor && this.bubbleAt(anchor.element, anchor.text);
      if (JSON.stringify(bubble) !== JSON.stringify(this.bubble)) this.bubble = bubble;
    });
  }

  private anchor(): { element: Element; text: string } | null {
    const { step } = this, root = this.getRootNode() as ShadowRoot;
    const inside = (piece: string, query: string): Element | null => root.querySelector(piece)?.shadowRoot?.querySelector(query) ?? null;
    if (step === "hint.wall") {
      const element = inside("parkade-toolbar", '[data-tool="wall"]') ?? inside("parkade-sheet", '[data-tool="wall"]');
      return element && { element, text: this.t(step) };
    }
    const planner = this.failing();
    if (step !== "hint.fails" || !planner || planner === this.state.focus) return null;
    const element = inside("parkade-table", `[data-planner="${planner}"] td`);
    return element && { element, text: this.t(step, { planner: plannerName(this.state.lang, planner) }) };
  }

  private bubbleAt(element: Element, text: string): Bubble | null {
    const box = element.getBoundingClientRect(), host = this.getBoundingClientRect();
    if (box.width === 0 || host.width === 0) return null;
    const above = box.top - host.top > host.height / 2;
    const x = Math.min(host.width - EDGE - ARROW, Math.max(EDGE + ARROW, (box.left + box.right) / 2 - host.left));
    return { text, x: Math.round(x), y: Math.round((above ? box.top : box.bottom) - host.top), above };
  }
}

customElements.define("parkade-next-hints", NextHints);
