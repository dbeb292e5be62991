import type { PlannerId } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import messages from "../i18n/messages/smooth-switch.json";
import { translator } from "../i18n/translator";
import { canSmooth, chooseSmooth } from "../planning/smoother";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { drivablePlan } from "../texts/status";

const say = translator("smooth", messages);

/** Beside a planner's title: whether its path is driven as an optimised trajectory. */
export class SmoothSwitch extends AppElement {
  static override properties = { ...AppElement.properties, planner: { type: String } };
  static override styles = [
    controls,
    css`
    :host { display: inline-flex; }
    button { height: 26px; padding: 0 6px; font-size: 12px; font-weight: 500; color: var(--parkade-t2); }
    button:hover { background: var(--parkade-hover); color: var(--parkade-t1); }
    button[aria-checked="true"] { color: var(--parkade-accent); }
    @container (max-width: 480px) { span { display: none; } }
    @container (max-width: 250px) { :host { display: none; } }
    @media (pointer: coarse) { button { min-width: 44px; min-height: 32px; } }
  `,
  ];
  declare planner: PlannerId;
  protected override redrawMs = 100;

  protected watches(): readonly (keyof State)[] {
    return ["results", "smooth", "scene", "complete", "hidden"];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { state, planner } = this,
      { lang, smooth } = state;
    if (!canSmooth(state) || state.hidden.has(planner) || !drivablePlan(state.results[planner])) return nothing;
    const title = say(lang, smooth ? "on" : "off");
    return html`<button role="switch" aria-checked=${smooth === true} aria-label=${say(lang, "name")} title=${title}
      @click=${() => chooseSmooth(this.app.store, !smooth)}>
      <svg width="16" height="16" viewBox="0 0 16 16" fill="none" stroke="currentColor" stroke-width="1.5"
        stroke-linecap="round"
        aria-hidden="true"><path d="M2 12.5c7 0 5-9 12-9"/></svg><span>${say(lang, "name")}</span></button>`;
  }
}

customElements.define("parkade-smooth", SmoothSwitch);
