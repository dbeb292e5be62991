import type { Judgement } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { removeTrajectory } from "../app/guest";
import messages from "../i18n/messages/guest-card.json";
import { translator } from "../i18n/translator";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { icon } from "../styles/icons";
import { sections } from "../styles/sections";
import { shortName } from "../styles/planner-style";
import { thingName } from "../texts/status";
import { AppElement } from "./base";
import { degrees } from "../scene/geometry";

const say = translator("guestCard", messages);

type Row = [key: Parameters<typeof say>[1], value: (verdict: Judgement) => number | boolean, digits?: number];
const ROWS: readonly Row[] = [
  ["attained", (v) => v.attained],
  ["limits", (v) => v.keepsLimits],
  ["touching", (v) => v.touchingFrames],
  ["uncertified", (v) => v.uncertified],
  ["duration", (v) => v.duration, 1],
  ["length", (v) => v.length, 2],
  ["gears", (v) => v.gearChanges],
  ["clearance", (v) => v.minClearance, 2],
  ["position", (v) => 1000 * Math.hypot(v.endError.x, v.endError.y), 1],
  ["heading", (v) => degrees(v.endError.heading), 2],
  ["model", (v) => 1000 * v.modelError.distance, 1],
  ["effort", (v) => v.effort, 2],
  ["steering", (v) => v.steeringEffort, 2],
  ["smoothness", (v) => v.smoothness, 1],
  ["tpcap", (v) => v.tpcapCost, 1],
];

/** The referee's figures of a trajectory from a file, beside those of the focused planner's. */
export class GuestCard extends AppElement {
  static override styles = [
    controls,
    sections,
    css`
    table { width: 100%; border-collapse: collapse; font-size: 12px; line-height: 16px; }
    th, td { padding: 2px 0 2px 8px; text-align: right; font-weight: 400; }
    th:first-child { padding-left: 0; text-align: left; color: var(--parkade-t2); }
    thead th {
      color: var(--parkade-t2); white-space: nowrap; max-width: 84px; overflow: hidden; text-overflow: ellipsis;
    }
    .err { color: var(--parkade-err); }
    h2 { overflow: hidden; }
    h2 span { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
  `,
  ];

  protected watches(): readonly (keyof State)[] {
    return ["guest", "focus", "results"];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { guest, lang, focus, results } = this.state;
    this.hidden = !guest;
    if (!guest) return nothing;
    const { verdict, name } = guest,
      { smoothed, plan } = results[focus] ?? {},
      ours = smoothed?.of === plan ? smoothed?.trajectory?.check : undefined;
    const remove = say(lang, "remove", { name });
    return html`<div class="head"><h2 title=${name}><span>${name}</span></h2><button class="icon small"
      aria-label=${remove} title=${remove} @click=${() =>
        removeTrajectory(this.app)}>${icon("trash", 14)}</button></div>
      <p class=${verdict.passes ? "" : "err"} role="status">${say(lang, verdict.passes ? "passes" : "fails")} ${
        verdict.firstContact
          ? say(lang, "contact", {
              thing: thingName(this.state, verdict.firstContact),
              s: this.num(verdict.firstContact.t, 1),
            })
          : nothing
      }</p>
      <table><caption class="visually-hidden">${say(lang, "title")}</caption>
        <thead><tr><td></td><th scope="col" title=${name}>${name}</th>${
          ours ? html`<th scope="col">${shortName(lang, focus)}</th>` : nothing
        }</tr></thead>
        <tbody>${ROWS.map(
          ([key, value, digits = 0]) =>
            html`<tr><th scope="row">${say(lang, key)}</th><td>${this.text(value(verdict), digits)}</td>${
              ours ? html`<td>${this.text(value(ours), digits)}</td>` : nothing
            }</tr>`,
        )}</tbody></table>`;
  }

  private text(value: number | boolean, digits: number): string {
    if (typeof value === "boolean") return say(this.state.lang, value ? "yes" : "no");
    return Number.isFinite(value) ? this.num(value, digits) : "–";
  }
}

customElements.define("parkade-guest", GuestCard);
