import { css, html, nothing, type TemplateResult } from "lit";
import { sentence } from "../app/app";
import messages from "../i18n/messages/trajectory-card.json";
import { translator } from "../i18n/translator";
import { canSmooth, chooseSmooth, isTooLong } from "../planning/smoother";
import type { Smoothed } from "../store/results";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { plannerName } from "../styles/planner-style";
import { drivablePlan } from "../texts/status";
import { AppElement } from "./base";
import { degrees } from "../scene/geometry";

const say = translator("trajectory", messages);

/** What is said of the stage that answered. */
const STAGES = { optimised: "optimised", "continuous-curvature": "ramps", "stop-and-steer": "stops" } as const;

/** How the focused planner's path is driven: the switch, the stage that answered, and the referee's figures. */
export class TrajectoryCard extends AppElement {
  static override styles = [
    controls,
    sections,
    css`
    label { display: flex; align-items: center; gap: 8px; }
    label input { accent-color: var(--parkade-accent); margin: 0; }
    dl {
      display: grid; grid-template-columns: 1fr auto; gap: 4px 10px; margin: 8px 0 0; font-size: 12px;
      line-height: 16px;
    }
    dt { color: var(--parkade-t2); }
    dd { margin: 0; text-align: right; }
    dd small { font-size: inherit; color: var(--parkade-t3); }
    .warn { color: var(--parkade-warn); }
    @media (pointer: coarse) { label { min-height: 44px; } }
  `,
  ];
  protected override redrawMs = 100;

  protected watches(): readonly (keyof State)[] {
    return ["focus", "results", "smooth", "scene", "transient"];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { focus, lang, results, smooth } = this.state,
      result = results[focus];
    this.hidden = !drivablePlan(result);
    if (this.hidden) return nothing;
    const can = canSmooth(this.state),
      smoothed = result!.smoothed?.of === result!.plan ? result!.smoothed : null;
    return html`<div class="head"><h2>${say(lang, "title")}</h2>${
      can
        ? html`<label>${say(lang, "smooth")}<input type="checkbox" role="switch" .checked=${smooth === true}
          @change=${() => chooseSmooth(this.app.store, !smooth)}></label>`
        : html`<span>${plannerName(lang, focus)}</span>`
    }</div>
      ${can ? (smooth ? this.answer(smoothed) : html`<p>${say(lang, "off")}</p>`) : html`<p>${say(lang, "road")}</p>`}`;
  }

  private answer(smoothed: Smoothed | null | undefined): TemplateResult {
    const { lang, results, focus } = this.state,
      plan = results[focus]!.plan!;
    if (smoothed?.failure)
      return html`<p class="warn">${say(lang, "failed", {
        reason: { ...smoothed.failure, message: sentence(smoothed.failure.message) },
      })}</p>`;
    if (!smoothed?.trajectory) return html`<p>${say(lang, isTooLong(plan) ? "long" : "pending")}</p>`;
    return html`<p class="stage">${say(lang, STAGES[smoothed.trajectory.stage])}</p>${this.figures(
      smoothed,
      results[focus]!.drive?.t.at(-1),
    )}`;
  }

  private figures({ trajectory, drive }: Smoothed, planned: number | undefined): TemplateResult {
    const { lang } = this.state,
      { check } = trajectory!;
    const row = (key: Parameters<typeof say>[1], value: string, unit: string): TemplateResult =>
      html`<dt>${say(lang, key)}</dt><dd>${value} <small>${unit}</small></dd>`;
    const { x, y, heading } = check.endError;
    return html`<dl>
      ${row("duration", this.num(drive!.t.at(-1)!, 1), "s")}
      ${planned === undefined ? nothing : row("planned", this.num(planned, 1), "s")}
      ${row("clearance", this.num(check.minClearance, 2), "m")}
      ${row("steering", this.num(degrees(check.maxSteeringRate), 1), "°/s")}
      ${row("end", this.num(1000 * Math.hypot(x, y), 1), "mm")}
      ${row("heading", this.num(degrees(heading), 2), "°")}
      ${row("contact", `${this.num(check.touchingFrames, 0)} / ${this.num(check.frames, 0)}`, "")}</dl>`;
  }
}

customElements.define("parkade-trajectory", TrajectoryCard);
