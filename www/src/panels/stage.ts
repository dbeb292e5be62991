import type { PlannerId } from "parkade";
import { css, html, nothing, unsafeCSS, type TemplateResult } from "lit";
import { plannerName } from "../styles/planner-style";
import type { State } from "../store";
import { played } from "../store/results";
import { controls } from "../styles/controls";
import { LEGEND } from "../view/camera";
import { AppElement } from "./base";
import { lineSample, marker } from "../styles/icons";
import { searchTime, statusOf } from "../texts/status";
import { laterTexts } from "./lazy-texts";
import "./panel";
import "./scene-view";
import type { On } from "./inputs";

const SWIPE_PX = 24;

/** The maps: side by side, overlaid, or one in focus. */
export class Stage extends AppElement {
  static override properties = {
    ...AppElement.properties,
    compact: { type: Boolean, reflect: true },
    bare: { attribute: false },
  };
  static override styles = [
    controls,
    css`
    :host {
      --parkade-buttons: 60px; display: block; position: relative; min-height: 0; min-width: 0; overflow: hidden;
      background: var(--parkade-hair);
    }
    @media (pointer: coarse) { :host { --parkade-buttons: 78px; } }
    .grid {
      position: absolute; inset: 0; display: grid; gap: 1px; grid-auto-rows: 1fr; grid-template-columns: repeat(4, 1fr);
    }
    .grid[data-n="1"] { grid-template-columns: 1fr; }
    .grid[data-n="2"], .grid[data-n="4"], .grid[data-n="3"] { grid-template-columns: 1fr 1fr; }
    .grid[data-n="5"], .grid[data-n="6"], .grid[data-n="9"] { grid-template-columns: repeat(3, 1fr); }
    /* The view's buttons stand over the corners that meet in the middle of the last row. */
    .grid[data-n="2"] > :first-child, .grid[data-n="3"] > :last-child, .grid[data-n="4"] > :nth-child(3) {
      --legend-inset: var(--parkade-buttons);
    }
    .grid[data-n="2"] > :last-child, .grid[data-n="4"] > :last-child { --scale-inset: var(--parkade-buttons); }
    .focus {
      position: absolute; inset: 0; display: grid; gap: 1px; grid-template-columns: 1fr minmax(150px, 22%);
      grid-template-rows: repeat(var(--thumbs, 3), 1fr);
    }
    .focus > .large { grid-row: 1 / -1; grid-column: 1; }
    .focus > :not(.large) { grid-column: 2; }
    .one { position: absolute; inset: 0; background: var(--parkade-panel); }
    .one parkade-scene-view { position: absolute; inset: 0; }
    parkade-failure { position: absolute; inset: 0 0 auto; }
    .legend {
      position: absolute; right: 10px; bottom: 10px; max-width: 340px;
      max-height: ${unsafeCSS(LEGEND.rows * LEGEND.row + LEGEND.edge)}px; padding: 5px; overflow: hidden auto;
      scrollbar-width: thin; font-size: 12px; line-height: 16px;
      background: color-mix(in srgb, var(--parkade-panel) 94%, transparent); border: 1px solid var(--parkade-hair);
      border-radius: calc(8px * var(--parkade-radius));
    }
    .legend button {
      display: grid; grid-template-columns: 14px 30px 1fr auto auto; gap: 6px; width: 100%;
      height: ${unsafeCSS(LEGEND.row)}px; padding: 0 6px; text-align: left; align-items: center;
      border: 1px solid transparent;
    }
    .legend button[aria-pressed="true"] { border-color: var(--parkade-hair2); background: var(--parkade-panel); }
    .legend b { font-weight: 600; }
    .legend .ms { color: var(--parkade-t2); text-align: right; padding-left: 12px; }
    .err { color: var(--parkade-err); } .warn { color: var(--parkade-warn); }
    .legend .off { color: var(--parkade-t3); }
    .title {
      position: absolute; left: 10px; top: 10px; display: flex; align-items: center; gap: 8px; height: 28px;
      padding: 0 10px; pointer-events: none; background: color-mix(in srgb, var(--parkade-panel) 94%, transparent);
      border: 1px solid var(--parkade-hair); border-radius: calc(8px * var(--parkade-radius)); font-weight: 600;
    }
    .title span { font-weight: 400; color: var(--parkade-t2); }
    .readout {
      position: absolute; left: 10px; bottom: 30px; max-width: calc(100% - 40px); display: flex; flex-wrap: wrap;
      gap: 0 10px; padding: 4px 10px; pointer-events: none; font-size: 12px; line-height: 18px;
      color: var(--parkade-t2); background: color-mix(in srgb, var(--parkade-panel) 94%, transparent);
      border: 1px solid var(--parkade-hair); border-radius: calc(8px * var(--parkade-radius));
    }
    .weights {
      position: absolute; left: 10px; bottom: 30px; display: flex; align-items: center; gap: 6px; padding: 4px 10px;
      pointer-events: none; font-size: 12px; line-height: 18px; color: var(--parkade-t2);
      background: color-mix(in srgb, var(--parkade-panel) 94%, transparent); border: 1px solid var(--parkade-hair);
      border-radius: calc(8px * var(--parkade-radius));
    }
    .weights i { width: 18px; height: 14px; border: 1px solid var(--parkade-warn); }
    :host([compact]) .weights { left: auto; right: 10px; bottom: auto; top: 60px; }
    .readout b { font-weight: 500; color: var(--parkade-t1); margin-left: 4px; }
    :host([compact]) .title {
      pointer-events: auto; touch-action: none; user-select: none; -webkit-user-select: none; cursor: ew-resize;
    }
  `,
  ];
  declare compact: boolean;
  /** True if only the maps are wanted yet. */
  declare bare: boolean;
  private grabbed = 0;

  constructor() {
    super();
    this.compact = this.bare = false;
  }

  protected watches(): readonly (keyof State)[] {
    return ["mode", "planners", "focus", "hidden", "results", "hover", "explained"];
  }

  protected override render(): TemplateResult {
    const { mode, planners, focus } = this.state;
    const view = this.bare
      ? nothing
      : html`<parkade-view-controls .app=${this.app} ?compact=${this.compact}></parkade-view-controls>`;
    if (this.compact || mode === "overlay") return html`${this.overlay()}${view}`;
    if (mode === "grid")
      return html`<div class="grid" data-n=${planners.length}>${planners.map((planner) =>
        this.panel(planner),
      )}</div>${view}`;
    const others = planners.filter((planner) => planner !== focus);
    return html`<div class="focus" .style=${`--thumbs:${Math.max(1, others.length)}`}>
      <parkade-panel part="panel" exportparts="canvas" class="large" .app=${this.app} .planner=${focus}></parkade-panel>
      ${others.map(
        (planner) =>
          html`<parkade-panel part="panel" exportparts="canvas" .app=${this.app} .planner=${planner}
            data-planner=${planner} thumb></parkade-panel>`,
      )}</div>${view}`;
  }

  private panel(planner: PlannerId): TemplateResult {
    return html`<parkade-panel part="panel" exportparts="canvas" .app=${this.app} .planner=${planner}
      data-planner=${planner}></parkade-panel>`;
  }

  private overlay(): TemplateResult {
    const { planners, hidden, focus } = this.state;
    const shown = planners.filter((planner) => !hidden.has(planner) && planner !== focus);
    if (!hidden.has(focus)) shown.push(focus);
    return html`<div class="one">
      <parkade-scene-view exportparts="canvas" .app=${this.app} .planners=${shown}
        .label=${this.t("panel.overlay")}></parkade-scene-view>
      ${this.bare ? nothing : this.notes()}</div>`;
  }

  /** The list over the one map. */
  private notes(): TemplateResult {
    const { focus } = this.state;
    return html`${this.compact ? nothing : html`<parkade-failure .app=${this.app}></parkade-failure>`}
      ${
        this.compact ? [this.heading(), laterTexts()?.readoutOf(this.state, focus)] : this.legend()
      }${this.state.scene.costs ? laterTexts()?.weightsOf(this.state) : nothing}`;
  }

  private heading(): TemplateResult {
    const { focus, results, lang } = this.state;
    const plan = played(results[focus])?.plan;
    return html`<div class="title" @pointerdown=${this.grab}
      @pointerup=${this.flip}>${marker(focus)}${plannerName(lang, focus)}
      <span>${
        plan?.outcome === "found" ? `${this.num(plan.metrics.length, 2)} m` : statusOf(this.state, focus).brief
      }</span></div>`;
  }

  private readonly grab = (event: On<HTMLElement, PointerEvent>): void => {
    event.currentTarget.setPointerCapture(event.pointerId);
    this.grabbed = event.clientX;
  };

  /** A swipe brings the planner beside to the front; chips and keys do the same. */
  private readonly flip = (event: PointerEvent): void => {
    const { planners, focus } = this.state,
      way = event.clientX - this.grabbed;
    if (Math.abs(way) < SWIPE_PX) return;
    const next = planners.indexOf(focus) + (way < 0 ? 1 : -1);
    this.app.store.set({ focus: planners.at(next % planners.length)! });
  };

  private legend(): TemplateResult {
    const { state } = this;
    return html`<div class="legend" role="group" aria-label=${this.t("chips.label")}>${state.planners.map((planner) => {
      const status = statusOf(state, planner);
      return html`<button data-planner=${planner} aria-pressed=${planner === state.focus}
        class=${state.hidden.has(planner) ? "off" : ""} @click=${() => this.app.store.set({ focus: planner })}>
        ${marker(planner)}${lineSample(planner)}<b>${plannerName(state.lang, planner)}</b>
        <span class="ms">${searchTime(
          state.lang,
          state.results[planner],
        )}</span><span class=${status.tone}>${status.brief}</span></button>`;
    })}</div>`;
  }
}

customElements.define("parkade-stage", Stage);
