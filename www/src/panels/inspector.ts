import { css, html, nothing, type TemplateResult } from "lit";
import "../i18n/later";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import "./objects";
import "./options";
import "./parameters";
import "./guest-card";
import "./road-card";
import "./selection";
import "./trajectory-card";
import "./vehicle-card";
import "./any-angle-card";

/**
 * The column at the right: the tool in hand, what is selected, the car, the focused planner's settings, every object.
 */
export class Inspector extends AppElement {
  static override properties = { ...AppElement.properties, ready: { type: Boolean } };
  static override styles = [
    controls,
    css`
    :host {
      display: block; overflow-y: auto; overflow-x: hidden; background: var(--parkade-panel);
      border-left: 1px solid var(--parkade-hair); scrollbar-width: thin;
      scrollbar-color: var(--parkade-hair2) transparent;
    }
    section { padding: 14px; border-top: 1px solid var(--parkade-hair); }
    section:has(> [hidden]) { display: none; }
    section:first-child, section:first-child:has(> [hidden]) + section { border-top: 0; }
  `,
  ];
  declare ready: boolean;
  protected override waits = true;

  constructor() {
    super();
    this.ready = false;
  }

  protected watches(): readonly (keyof State)[] {
    return [];
  }

  protected override render(): TemplateResult | typeof nothing {
    if (!this.ready) return nothing;
    return html`
      <section><parkade-options form .app=${this.app}></parkade-options></section>
      <section><parkade-selection .app=${this.app}></parkade-selection></section>
      <section><parkade-vehicle .app=${this.app}></parkade-vehicle></section>
      <section><parkade-parameters .app=${this.app}></parkade-parameters></section>
      <section><parkade-trajectory .app=${this.app}></parkade-trajectory></section>
      <section><parkade-guest .app=${this.app}></parkade-guest></section>
      <section><parkade-any-angle .app=${this.app}></parkade-any-angle></section>
      <section><parkade-road-card .app=${this.app}></parkade-road-card></section>
      <section><parkade-objects .app=${this.app}></parkade-objects></section>`;
  }
}

customElements.define("parkade-inspector", Inspector);
