import type { Choice } from "../store/results";
import type { Plan, PlannerId, Prefer } from "parkade";
import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import messages from "../i18n/messages/choices.json";
import { translator } from "../i18n/translator";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { plannerName } from "../styles/planner-style";
import { AppElement } from "./base";

const say = translator("choices", messages);

/** Percent above the shortest way without obstacles: rounding, and what tells more as a length. */
const ROUNDING = 1e-4,
  MUCH = 50;

/** Chips under a planner's title: other paths that it found, to look at and to choose. */
export class Choices extends AppElement {
  static override properties = {
    ...AppElement.properties,
    planner: { type: String },
    searching: { type: Boolean, reflect: true },
  };
  static override styles = [
    controls,
    css`
    :host { position: absolute; z-index: 2; inset: 0 0 auto; display: block; pointer-events: none; }
    :host([searching])::before {
      content: ""; position: absolute; inset: 0 0 auto; height: 2px;
      background: linear-gradient(90deg, transparent, var(--parkade-accent), transparent) 0 0 / 40% 100% no-repeat;
      animation: run 1.2s linear infinite;
    }
    @keyframes run { from { background-position: -40% 0; } to { background-position: 140% 0; } }
    @media (prefers-reduced-motion: reduce) {
      :host([searching])::before { animation: none; background: var(--parkade-accent); opacity: 0.4; }
    }
    :host(.low) { inset: auto 0 38px; }
    div { display: flex; flex-wrap: wrap; gap: 6px; padding: 8px; }
    button {
      pointer-events: auto; height: 24px; padding: 0 8px; font-size: 12px; font-variant-numeric: tabular-nums;
      white-space: nowrap; color: var(--parkade-t1);
      background: color-mix(in srgb, var(--parkade-panel) 94%, transparent); border: 1px solid var(--parkade-hair2);
      border-radius: calc(5px * var(--parkade-radius));
    }
    button:hover { background: var(--parkade-panel); border-color: var(--parkade-t2); }
    button[aria-pressed="true"] { font-weight: 600; outline: 1.5px solid var(--parkade-t1); outline-offset: -1px; }
    @media (pointer: coarse) { button { height: 34px; padding: 0 12px; } }
    /* On a low screen the start is more often above. */
    @media (max-height: 479px) { :host { align-self: end !important; top: auto !important; bottom: 26px !important; } }
  `,
  ];
  /** Unset: the focused one. */
  declare planner: PlannerId | undefined;
  /** True if better paths are being looked for. */
  declare searching: boolean;

  constructor() {
    super();
    this.searching = false;
  }

  protected watches(): readonly (keyof State)[] {
    return ["choices", "improving", "prefer", "hidden", "focus"];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.preview(null);
  }

  protected override willUpdate(changed: PropertyValues): void {
    super.willUpdate(changed);
    const { choices, improving } = this.state;
    this.searching = improving === this.asked;
    if (!choices?.[this.asked]) this.preview(null);
  }

  protected override render(): TemplateResult | typeof nothing {
    const {
        state: { lang, hidden, choices },
        asked,
      } = this,
      list = choices?.[asked];
    if (!list || list.length < 2 || hidden.has(asked)) return nothing;
    return html`<div role="group" aria-label=${say(lang, "label", {
      planner: plannerName(lang, asked),
    })}>${list.map((choice) => this.chip(choice))}</div>`;
  }

  private get asked(): PlannerId {
    return this.planner ?? this.state.focus;
  }

  private chip({ plan, by, isOrdinary }: Choice): TemplateResult {
    const { lang, prefer } = this.state,
      chosen = prefer[this.asked];
    const { length, directionChanges: n, minClearance, gapPercent = 0, rsBound = 0 } = plan.metrics;
    const values = { length: this.num(length, 1), n, clear: this.num(minClearance, 2) };
    const isWidest = by.length === 1 && by[0] === "widest";
    const isChosen = chosen ? by.includes(chosen) : isOrdinary;
    const what = by.length === 0 ? say(lang, "ordinary") : by.map((one) => say(lang, one)).join(", ");
    const how = gapPercent < ROUNDING ? "proven" : gapPercent < MUCH ? "within" : "bound";
    const proof = say(lang, how, { bound: this.num(rsBound, 1), share: this.num(Math.ceil(gapPercent * 10) / 10, 1) });
    const title = say(lang, "title", { ...values, what, proof });
    return html`<button aria-pressed=${isChosen} title=${title} aria-label=${title}
      @click=${() => this.choose(isOrdinary ? undefined : by[0])}
      @pointerenter=${() => this.preview(plan)} @pointerleave=${() => this.preview(null)}
      @focus=${() => this.preview(plan)} @blur=${() => this.preview(null)}
    >${say(lang, isWidest ? "clear" : n === 0 ? "none" : "changes", values)}</button>`;
  }

  private choose(prefer: Prefer | undefined): void {
    const { [this.asked]: _, ...others } = this.state.prefer;
    this.preview(null);
    this.app.store.set({ prefer: prefer ? { ...others, [this.asked]: prefer } : others });
  }

  private preview(plan: Plan | null): void {
    const preview = plan && { planner: this.asked, plan };
    if (this.app?.store.state.preview?.plan !== plan && (plan || this.app.store.state.preview?.planner === this.asked))
      this.app.store.set({ preview });
  }
}

customElements.define("parkade-choices", Choices);
