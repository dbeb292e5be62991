import type { ParameterInfo, PlannerId } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { isMessage } from "../i18n/index";
import messages from "../i18n/messages/parameters.json";
import { translator } from "../i18n/translator";
import { distancesOf } from "../view/drive";
import { plannerName } from "../styles/planner-style";
import type { Scene, State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { AppElement } from "./base";
import { isChecked, numberOf } from "./inputs";
import { marker } from "../styles/icons";
import { thingName } from "../texts/status";
import { nth } from "../scene/nth";

/** Of any planner, by the names that its parameters have. */
type Settings = Record<string, unknown>;

const DEGREES = 180 / Math.PI;
const say = translator("parameters", messages);
/** Less than this short of the margin asked for is not said, metres: figures show centimetres. */
const SHORT = 0.005;
const UNITS: Record<string, string> = { rad: "°", "1": "" };

/** The focused planner's settings, from what the planner says of them. */
export class Parameters extends AppElement {
  static override properties = { ...AppElement.properties, all: { state: true } };
  static override styles = [
    controls,
    sections,
    css`
    .one { padding: 5px 0; }
    .member { margin: 2px 0 6px; }
    .narrow {
      padding: 0; text-align: left; font: inherit; line-height: inherit; height: auto; color: var(--parkade-warn);
      white-space: normal;
    }
    .name { display: flex; align-items: baseline; gap: 8px; font-size: 12.5px; line-height: 17px; font-weight: 500; }
    .name output, .name .field { margin-left: auto; }
    .name output { font-weight: 400; white-space: nowrap; }
    .changed::after {
      content: ""; display: inline-block; width: 5px; height: 5px; margin-left: 6px; border-radius: 50%;
      background: var(--parkade-accent); vertical-align: 2px;
    }
    .switch { display: flex; align-items: center; gap: 8px; margin: 4px 0; }
    .switch input { accent-color: var(--parkade-accent); margin: 0; }
    .segmented { margin: 4px 0; flex-wrap: wrap; }
    .range {
      display: flex; justify-content: space-between; margin-top: -2px; color: var(--parkade-t3); font-size: 12px;
      line-height: 14px;
    }
    .more { margin-top: 6px; }
  `,
  ];
  protected override redrawMs = 100;
  declare all: boolean;

  constructor() {
    super();
    this.all = false;
  }

  protected watches(): readonly (keyof State)[] {
    return ["focus", "scene", "complete", "results"];
  }

  protected override render(): TemplateResult {
    const { focus, lang, scene } = this.state;
    const parameters = this.app.catalog?.planners.find((one) => one.id === focus)?.parameters ?? [];
    const settings: Settings = { ...scene.planners?.[focus] };
    const basic = parameters.filter((one) => one.basic);
    const shown = this.all || basic.length === 0 ? parameters : basic;
    return html`
      <div class="head"><h2>${marker(focus)}${plannerName(lang, focus)}</h2>
        <button class="link" ?disabled=${Object.keys(settings).length === 0}
          @click=${() => this.app.store.edit(withSettings(scene, focus, {}))}>${this.t("inspect.reset")}</button></div>
      ${this.member()}${this.narrowest(
        Number(settings["margin"] ?? parameters.find(({ name }) => name === "margin")?.default ?? 0),
      )}
      ${shown.map((info) => this.parameter(info, settings))}
      ${
        basic.length > 0 && basic.length < parameters.length
          ? html`<button class="link more" aria-expanded=${this.all} @click=${() => {
              this.all = !this.all;
            }}>${this.t(this.all ? "inspect.less" : "inspect.more")}</button>`
          : nothing
      }`;
  }

  /** Which of hybrid's searches answered. */
  private member(): TemplateResult | typeof nothing {
    const { focus, results, lang } = this.state,
      plan = results[focus]?.plan;
    if (!plan || !("member" in plan) || !plan.member) return nothing;
    const { member } = plan;
    const values = {
      cell: this.metres(member.xyResolution),
      angle: this.num(member.headingResolution * DEGREES, member.headingResolution * DEGREES < 1 ? 1 : 0),
      margin: this.metres(member.margin),
    };
    return html`<p class="member">${say(
      lang,
      plan.outcome === "found"
        ? member.fromGoal
          ? "fromGoal"
          : "fromStart"
        : plan.outcome === "no-path"
          ? "none"
          : "spent",
      values,
    )}</p>`;
  }

  private metres(value: number): string {
    return `${this.num(value, value < 0.01 ? 3 : 2)} m`;
  }

  /** How much of the margin a path keeps where it keeps less, and where; shown on the map while it is pointed at. */
  private narrowest(margin: number): TemplateResult | typeof nothing {
    const { focus, results, lang } = this.state,
      plan = results[focus]?.plan,
      place = plan?.check.narrowest;
    if (!place || !plan.check.drivable || plan.metrics.minClearance > margin - SHORT) return nothing;
    const values = {
      kept: this.metres(plan.metrics.minClearance),
      margin: this.metres(margin),
      along: this.num(nth(distancesOf(plan), place.pose), 1),
      thing: thingName(this.state, place),
    };
    const show = (): void => this.app.store.set({ preview: { planner: focus, plan, place } }),
      hide = (): void => this.app.store.set({ preview: null });
    return html`<p class="member"><button class="narrow" @pointerenter=${show} @pointerleave=${hide} @focus=${show}
      @blur=${hide}>${say(lang, "narrow", values)}</button></p>`;
  }

  private parameter(info: ParameterInfo, settings: Settings): TemplateResult {
    const value = settings[info.name] ?? info.default;
    const changed = info.name in settings && settings[info.name] !== info.default;
    const { lang } = this.state;
    return html`<div class="one">
      <div class="name"><span id="n-${info.name}" class=${changed ? "changed" : ""}>${info.title[lang]}</span>
        ${isNumeric(info) ? html`<output>${this.valueText(info, value)}</output>` : nothing}</div>
      ${this.control(info, value)}
      <p>${info.doc[lang]}</p></div>`;
  }

  private control(info: ParameterInfo, value: unknown): TemplateResult {
    if (info.type === "boolean") {
      return html`<label class="switch"><input type="checkbox" aria-labelledby="n-${info.name}"
        .checked=${value === true}
        @change=${(e: Event) => this.change(info, isChecked(e), false)}></label>`;
    }
    if (info.type === "choice") {
      return html`<div class="segmented" role="group" aria-labelledby="n-${info.name}">${(info.choices ?? []).map(
        (choice) => html`
          <button aria-pressed=${choice === value} @click=${() =>
            this.change(info, choice, false)}>${this.choiceName(choice)}</button>`,
      )}</div>`;
    }
    return this.slider(info, value);
  }

  private choiceName(choice: string): string {
    const key = `choice.${choice}`;
    return isMessage(key) ? this.t(key) : plannerName(this.state.lang, choice);
  }

  private slider(info: ParameterInfo, value: unknown): TemplateResult {
    const { min = 0, max = 1 } = info;
    const step = info.step ?? (info.type === "integer" ? 1 : (max - min) / 100);
    const now = typeof value === "number" ? value : min;
    const at = max > min ? ((Math.min(max, Math.max(min, now)) - min) / (max - min)) * 100 : 0;
    return html`<input class="slider" type="range" min=${min} max=${max} step=${step} .value=${String(now)}
      .style=${`--at: ${at}%`}
      aria-labelledby="n-${info.name}" aria-valuetext=${this.valueText(info, value)}
      @input=${(e: Event) => this.change(info, numberOf(e), true)}
      @change=${(e: Event) => this.change(info, numberOf(e), false)}>
      <div class="range" aria-hidden="true"><span>${this.valueText(
        info,
        min,
      )}</span><span>${this.valueText(info, max)}</span></div>`;
  }

  private valueText(info: ParameterInfo, value: unknown): string {
    if (typeof value !== "number") return this.t("inspect.noPath");
    const angle = info.unit === "rad";
    const shown = angle ? value * DEGREES : value;
    const digits =
      info.type === "integer" ? 0 : digitsOf(angle ? (info.step ?? 0.0175) * DEGREES : (info.step ?? 0.01));
    const unit = info.unit === "cells" ? this.t("unitname.cells") : (UNITS[info.unit] ?? info.unit);
    return `${this.num(shown, digits)}${unit === "°" || unit === "" ? unit : ` ${unit}`}`;
  }

  private change(info: ParameterInfo, value: number | boolean | string, transient: boolean): void {
    const { focus, scene } = this.state;
    const settings: Settings = { ...scene.planners?.[focus] };
    if (value === info.default) delete settings[info.name];
    else settings[info.name] = value;
    this.app.store.edit(withSettings(scene, focus, settings), { transient });
  }
}

const isNumeric = (info: ParameterInfo): boolean => info.type === "number" || info.type === "integer";

const digitsOf = (step: number): number => (step >= 1 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3);

function withSettings(scene: Scene, planner: PlannerId, settings: Settings): Scene {
  const planners = { ...scene.planners };
  if (Object.keys(settings).length > 0) return { ...scene, planners: { ...planners, [planner]: settings } };
  delete planners[planner];
  return { ...scene, planners };
}

customElements.define("parkade-parameters", Parameters);
