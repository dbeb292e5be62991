import { css, html, nothing, type TemplateResult } from "lit";
import messages from "../i18n/messages/options.json";
import { translator } from "../i18n/translator";
import "../i18n/later";
import { sizedShape } from "../scene/slot-fit";
import { vehicleOf } from "../scene/vehicle";
import type { State, ToolOptions } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { isChecked, numberOf } from "./inputs";
import { icon } from "../styles/icons";

const KINDS = ["perpendicular", "parallel", "angled"] as const;
const ANGLES = [30, 45, 60] as const;
/** Usual widths of the aisle in front of each kind of slot, metres. */
const AISLES: Record<ToolOptions["slot"]["kind"], number> = { perpendicular: 6, parallel: 3.5, angled: 4.6 };

const LANES = ["1+0", "1+1", "2+2"] as const;

const say = translator("options", messages);

/** Options of the active tool: a row above the map, `flat` in a sheet, or the first lines (`form`) of the inspector. */
export class ToolOptionsBar extends AppElement {
  static override styles = [
    controls,
    css`
    :host { display: block; min-width: 0; background: var(--parkade-panel); }
    :host([hidden]) { display: none; }
    .bar { display: flex; align-items: center; gap: 6px 12px; padding: 6px 12px; }
    :host(:not([flat], [form])) .bar {
      overflow-x: auto; scrollbar-width: thin; border-bottom: 1px solid var(--parkade-hair); white-space: nowrap;
    }
    .bar > * { flex: none; }
    b { font-weight: 600; }
    label { display: flex; align-items: center; gap: 6px; color: var(--parkade-t2); }
    .weight { min-width: 26px; color: var(--parkade-t1); }
    input[type="range"] { width: 96px; accent-color: var(--parkade-accent); }
    .field { width: 78px; color: var(--parkade-t1); }
    .lock[aria-pressed="true"] { color: var(--parkade-accent); }
    :host([flat]) .bar { flex-wrap: wrap; padding: 8px 12px; }
    :host([form]) .bar { display: grid; gap: 8px; padding: 0; }
    :host([form]) label { justify-content: space-between; }
    :host([form]) label:has([type="checkbox"]) { justify-content: start; }
    :host([form]) .segmented { display: flex; } :host([form]) .segmented button { flex: 1 0 auto; padding: 0 6px; }
    :host([form]) .lock { justify-content: start; margin: 0 -10px; }
  `,
  ];

  protected watches(): readonly (keyof State)[] {
    return ["tool", "toolOptions", "scene"];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { tool, toolOptions } = this.state;
    this.hidden = tool === "select" || tool === "hand";
    if (this.hidden) return nothing;
    return html`<div class="bar" role="group"
      aria-label=${this.t(`tool.${tool}`)}><b>${this.t(`tool.${tool}`)}</b>${this.fields(
        toolOptions,
      )}${this.lock()}</div>`;
  }

  private fields(options: ToolOptions): TemplateResult | typeof nothing {
    switch (this.state.tool) {
      case "brush":
      case "eraser":
        return this.metres(this.t("option.radius"), options.brushRadius, 0.1, (brushRadius) => ({ brushRadius }));
      case "cost":
        return html`${this.metres(this.t("option.radius"), options.brushRadius, 0.1, (brushRadius) => ({
          brushRadius,
        }))}${this.weight(options.costWeight)}`;
      case "wall":
        return this.metres(this.t("option.thickness"), options.wallThickness, 0, (wallThickness) => ({
          wallThickness,
        }));
      case "car":
        return this.choice(
          ["sedan", "paper", "cone"] as const,
          options.carProfile,
          (name) => (name === "cone" ? say(this.state.lang, "cone") : this.t(`vehicle.${name}`)),
          (carProfile) => ({ carProfile }),
        );
      case "slot":
        return this.slotRow(options.slot);
      case "road":
        return this.road(options.road);
      default:
        return nothing;
    }
  }

  private slotRow(slot: ToolOptions["slot"]): TemplateResult {
    const put = (patch: Partial<ToolOptions["slot"]>): Partial<ToolOptions> => ({ slot: { ...slot, ...patch } });
    const { width, length } = sizedShape(slot, vehicleOf(this.state.scene.vehicle));
    return html`
      ${this.choice(
        KINDS,
        slot.kind,
        (kind) => this.t(`option.${kind}`),
        (kind) => put({ kind, width: null, length: null, aisle: AISLES[kind] }),
      )}
      ${
        slot.kind === "angled"
          ? html`
        ${this.choice(
          ANGLES,
          Math.round((slot.angle * 180) / Math.PI) as 45,
          (angle) => `${angle}°`,
          (angle) => put({ angle: (angle * Math.PI) / 180 }),
        )}
        ${this.choice(
          ["left", "right"] as const,
          slot.lean,
          (lean) => this.t(`option.${lean}`),
          (lean) => put({ lean }),
        )}`
          : nothing
      }
      ${this.metres(this.t("option.width"), width, 1, (width) => put({ width }))}
      ${this.metres(this.t("option.depth"), length, 1, (length) => put({ length }))}
      ${this.metres(say(this.state.lang, "aisle"), slot.aisle, 0, (aisle) => put({ aisle }))}`;
  }

  private road(road: ToolOptions["road"]): TemplateResult {
    const { lang } = this.state,
      put = (patch: Partial<ToolOptions["road"]>): Partial<ToolOptions> => ({ road: { ...road, ...patch } });
    return html`
      ${this.choice(
        LANES,
        road.lanes.join("+") as "1+1",
        (one) => say(lang, one),
        (one) => put({ lanes: one.split("+").map(Number) as [number, number] }),
      )}
      ${this.metres(say(lang, "laneWidth"), road.laneWidth, 2, (laneWidth) => put({ laneWidth }))}
      ${this.metres(say(lang, "bend"), road.radius, 1, (radius) => put({ radius }))}
      <label><input type="checkbox" .checked=${road.kerbs}
        @change=${(e: Event) => this.set(put({ kerbs: isChecked(e) }))}>${say(lang, "kerbs")}</label>`;
  }

  private choice<T extends string | number>(
    all: readonly T[],
    now: T,
    name: (one: T) => string,
    put: (one: T) => Partial<ToolOptions>,
  ): TemplateResult {
    return html`<div class="segmented" role="group" aria-label=${this.t(`tool.${this.state.tool}`)}>${all.map(
      (one) => html`
      <button aria-pressed=${one === now} @click=${() => this.set(put(one))}>${name(one)}</button>`,
    )}</div>`;
  }

  private metres(
    name: string,
    value: number,
    min: number,
    put: (value: number) => Partial<ToolOptions>,
  ): TemplateResult {
    return html`<label>${name}<span class="field"><input type="number" step="0.1" min=${min} .value=${value.toFixed(2)}
      @change=${(e: Event) => {
        const typed = numberOf(e);
        if (Number.isFinite(typed) && typed >= min) this.set(put(typed));
        this.requestUpdate();
      }}><span>m</span></span></label>`;
  }

  private weight(value: number): TemplateResult {
    return html`<label>${this.t("option.weight")}<input type="range" min="1" max="10" step="1" .value=${String(value)}
      aria-valuetext="×${value}"
      @input=${(e: Event) => this.set({ costWeight: numberOf(e) })}><b class="weight">×${value}</b></label>`;
  }

  private lock(): TemplateResult {
    const { locked } = this.state.toolOptions;
    const { snap } = this.state.toolOptions,
      { lang, tool } = this.state;
    const snaps = tool !== "brush" && tool !== "cost" && tool !== "eraser" && tool !== "car";
    return html`${
      snaps
        ? html`<button class="button lock" aria-pressed=${snap} title=${say(lang, "snapHelp")}
          @click=${() => this.set({ snap: !snap })}>${icon("fit", 14)}${say(lang, "snap")}</button>`
        : nothing
    }
      <button class="button lock" aria-pressed=${locked} title="${this.t("option.lock")} · Q"
        @click=${() =>
          this.set({
            locked: !locked,
          })}>${icon("lock", 14)}${this.t("option.lock")}<span class="keys">Q</span></button>`;
  }

  private set(patch: Partial<ToolOptions>): void {
    this.app.store.set({ toolOptions: { ...this.state.toolOptions, ...patch } });
  }
}

customElements.define("parkade-options", ToolOptionsBar);
