import type { Plan, RoadFigures } from "parkade";
import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { refusal } from "../app/app";
import { translatorAt } from "../i18n/translator";
import { RoadMeasures, type Risk } from "../planning/road-measures";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { infoOf, plannerName } from "../styles/planner-style";
import { AppElement } from "./base";
import { icon } from "../styles/icons";
import type { Said } from "../i18n/said";

/** So long nothing has to change before a plan is measured. */
const QUIET_MS = 350;

const say = translatorAt("roadCard");

/** Room, bends and lanes along the focused planner's path, and how often it would be hit by chance. */
export class RoadCard extends AppElement {
  static override properties = {
    ...AppElement.properties,
    figures: { state: true },
    risk: { state: true },
    running: { state: true },
    failure: { state: true },
  };
  static override styles = [
    controls,
    sections,
    css`
    dl { display: grid; grid-template-columns: 1fr auto; gap: 4px 10px; margin: 0; font-size: 12px; line-height: 16px; }
    dt { color: var(--parkade-t2); }
    dd { margin: 0; text-align: right; }
    dl.old { color: var(--parkade-t3); }
    h3 { margin: 12px 0 4px; font: inherit; font-weight: 500; }
    dd small { font-size: inherit; color: var(--parkade-t3); }
    progress {
      appearance: none; flex: 1; height: 4px; border: 0; border-radius: 2px; background: var(--parkade-hair2);
      overflow: hidden; min-width: 0;
    }
    progress::-webkit-progress-bar { background: var(--parkade-hair2); }
    progress::-webkit-progress-value { background: var(--parkade-t1); }
    progress::-moz-progress-bar { background: var(--parkade-t1); }
    .small { height: 28px; font-size: 12px; }
    .warn { color: var(--parkade-warn); margin-top: 8px; }
    .done { margin-top: 8px; color: var(--parkade-t1); }
    @media (pointer: coarse) { .small { min-height: 44px; } }
  `,
  ];
  declare figures: { of: Plan; values: RoadFigures } | null;
  declare risk: { of: Plan; value: Risk; trials: number } | null;
  declare running: boolean;
  declare failure: Said | null;
  protected override redrawMs = 100;
  private measures: RoadMeasures | null = null;
  private quiet: ReturnType<typeof setTimeout> | undefined;
  private asked: Plan | null = null;

  constructor() {
    super();
    this.figures = null;
    this.risk = null;
    this.running = false;
    this.failure = null;
  }

  protected watches(): readonly (keyof State)[] {
    return ["results", "focus", "scene", "transient"];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.quiet);
    this.asked = null;
    this.measures?.stop();
  }

  protected override willUpdate(changed: PropertyValues): void {
    super.willUpdate(changed);
    const { scene, focus } = this.state;
    this.hidden =
      !scene.lanes?.length && infoOf(focus)?.family !== "road" && !scene.obstacles?.some((one) => one.type === "road");
  }

  protected override updated(changed: PropertyValues): void {
    super.updated(changed);
    const plan = this.hidden ? null : this.plan;
    if (plan === this.asked) return;
    this.asked = plan;
    clearTimeout(this.quiet);
    if (this.running) this.cancel();
    if (plan) this.quiet = setTimeout(() => void this.measure(plan), QUIET_MS);
  }

  protected override render(): TemplateResult | typeof nothing {
    const { lang, focus } = this.state,
      { plan } = this;
    if (this.hidden) return nothing;
    return html`<div class="head"><h2>${say(lang, "title")}</h2><span>${plannerName(lang, focus)}</span></div>
      ${
        plan
          ? html`${this.rows(plan)}${
              plan.detail === "smoothing-fell-back" ? html`<p class="warn">${say(lang, "fellBack")}</p>` : nothing
            }${
              plan.detail === "less-margin" && "marginKept" in plan.metrics
                ? html`<p class="warn">${say(lang, plan.metrics.marginExcluded ? "noMargin" : "lessMargin", {
                    kept: this.num(plan.metrics.marginKept ?? 0, 2),
                    margin: this.num(plan.metrics.margin ?? 0, 2),
                  })}</p>`
                : nothing
            }${this.chances(plan)}`
          : html`<p>${say(lang, "none")}</p>`
      }
      ${
        this.failure ? html`<p class="warn" role="alert">${say(lang, "failed", { reason: this.failure })}</p>` : nothing
      }`;
  }

  private rows(plan: Plan): TemplateResult | typeof nothing {
    const { lang } = this.state,
      { figures } = this;
    if (!figures) return nothing;
    const f = figures.values;
    const row = (name: string, value: string, unit: string): TemplateResult =>
      html`<dt>${name}</dt><dd>${value} <small>${unit}</small></dd>`;
    return html`<dl class=${figures.of === plan ? "" : "old"}>
      ${row(
        say(lang, "bodyClearance"),
        `${this.num(f.bodyClearanceMin, 2)} / ${this.num(f.bodyClearanceMean, 2)}`,
        "m",
      )}
      ${row(
        say(lang, "sideClearance"),
        `${this.num(f.sideClearanceMin, 2)} / ${this.num(f.sideClearanceMean, 2)}`,
        "m",
      )}
      ${row(say(lang, "curvatureVariation"), this.num(f.curvatureVariation, 2), "1/m")}
      ${row(say(lang, "curvature"), this.num(f.middleCurvature, 3), "1/m")}
      ${
        f.laneDeviationMax === null
          ? nothing
          : row(say(lang, "lane"), `${this.num(f.laneDeviationMean ?? 0, 2)} / ${this.num(f.laneDeviationMax, 2)}`, "m")
      }</dl>`;
  }

  private chances(plan: Plan): TemplateResult {
    const { lang } = this.state,
      risk = this.risk?.of === plan ? this.risk : null,
      text = say(lang, "progress", { done: risk?.value.trials ?? 0, of: risk?.trials ?? 1000 });
    return html`<h3>${say(lang, "risk")}</h3><p>${say(lang, "riskHelp")}</p>
      <div class="row">${
        this.running
          ? html`<button class="button outline small"
            @click=${this.cancel}>${icon("close", 14)}${say(lang, "cancel")}</button>
            <progress max=${risk?.trials ?? 1000} .value=${risk?.value.trials ?? 0}
            aria-label=${text}></progress><span>${text}</span>`
          : html`<button class="button outline small"
            @click=${() => void this.drive(plan)}>${say(lang, risk ? "again" : "run")}</button>`
      }</div>
      ${
        risk
          ? html`<p class="done" role="status">${say(lang, "hits", {
              hits: this.num(risk.value.hits, 0),
              of: risk.value.trials,
              disc: this.num(risk.value.discHits, 0),
            })}</p>`
          : nothing
      }`;
  }

  private get plan(): Plan | null {
    const { results, focus } = this.state,
      plan = results[focus]?.plan ?? null;
    return plan?.outcome === "found" && plan.path.length > 3 ? plan : null;
  }

  private async measure(plan: Plan): Promise<void> {
    await this.attempt(plan, async (measures) => {
      const values = await measures.figures(this.state.scene, plan);
      if (this.asked === plan) this.figures = { of: plan, values };
    });
  }

  private async drive(plan: Plan): Promise<void> {
    this.risk = null;
    this.running = true;
    await this.attempt(plan, (measures) =>
      measures.risk(this.state.scene, plan, (value, trials) => {
        if (this.asked === plan) this.risk = { of: plan, value, trials };
      }),
    );
    if (this.asked === plan) this.running = false;
  }

  private async attempt(plan: Plan, work: (measures: RoadMeasures) => Promise<void>): Promise<void> {
    this.failure = null;
    try {
      this.measures ??= new RoadMeasures(await this.app.complete());
      await work(this.measures);
    } catch (error) {
      if (this.asked === plan && this.isConnected && !this.stopped) this.failure = refusal(error);
    }
    this.stopped = false;
  }

  /** A worker that was stopped tells so as a failure. */
  private stopped = false;

  private readonly cancel = (): void => {
    this.stopped = true;
    this.running = false;
    this.measures?.stop();
  };
}

customElements.define("parkade-road-card", RoadCard);
