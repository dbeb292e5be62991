import { css, html, nothing, type TemplateResult } from "lit";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { laterTexts } from "./lazy-texts";
import { icon } from "../styles/icons";

const SETTLE_MS = 500;
const INFO_MS = 4000;

/** Notices over the page, and announcements for screen readers. */
export class Notices extends AppElement {
  static override properties = { ...AppElement.properties, spoken: { state: true } };
  static override styles = [
    controls,
    css`
    :host {
      position: absolute; left: 0; right: 0; top: 56px; z-index: 25; display: grid; justify-items: center;
      pointer-events: none; padding: 0 12px;
    }
    .notice {
      display: flex; align-items: center; gap: 10px; max-width: 640px; padding: 6px 6px 6px 12px; pointer-events: auto;
      border-radius: calc(10px * var(--parkade-radius)); box-shadow: var(--parkade-float);
      background: var(--parkade-raise); border: 1px solid var(--parkade-hair2);
      animation: appear var(--parkade-mid) var(--parkade-ease);
    }
    .notice span { overflow-wrap: anywhere; }
    .err { background: var(--parkade-err-soft); color: var(--parkade-err); border-color: transparent; }
    .warn { background: var(--parkade-warn-soft); color: var(--parkade-warn); border-color: transparent; }
    .notice .icon { color: inherit; }
    @keyframes appear { from { opacity: 0; transform: translateY(-4px); } }
  `,
  ];
  protected override redrawMs = 100;
  /** By its language. */
  declare spoken: Partial<Record<State["lang"], string>>;
  private quiet: ReturnType<typeof setTimeout> | undefined;
  private fade: ReturnType<typeof setTimeout> | undefined;
  private lastMessage: State["message"] = null;
  private lastResults: State["results"] | null = null;

  constructor() {
    super();
    this.spoken = {};
  }

  protected watches(): readonly (keyof State)[] {
    return ["message", "results"];
  }

  protected override render(): TemplateResult {
    const { message, results } = this.state;
    if (message !== this.lastMessage) this.keep(message);
    if (results !== this.lastResults) this.speakLater(results);
    return html`
      <div role="alert">${
        message
          ? html`<div class="notice ${message.tone}">${icon(
              message.tone === "info" ? "check" : "warning",
            )}<span>${message.text}</span>
        ${
          message.action
            ? html`<button class="button outline" @click=${() => {
                this.app.store.set({ message: null });
                message.action?.run();
              }}>${message.action.name}</button>`
            : nothing
        }
            <button class="icon small" aria-label=${this.t("error.dismiss")}
            @click=${() => this.app.store.set({ message: null })}>${icon("close", 14)}</button></div>`
          : nothing
      }</div>
      <output class="visually-hidden" aria-live="polite">${this.spoken[this.state.lang]}</output>`;
  }

  private keep(message: State["message"]): void {
    this.lastMessage = message;
    clearTimeout(this.fade);
    if (message?.tone !== "info" || message.action) return;
    this.fade = setTimeout(() => {
      if (this.state.message === message) this.app.store.set({ message: null });
    }, INFO_MS);
  }

  private speakLater(results: State["results"]): void {
    this.lastResults = results;
    clearTimeout(this.quiet);
    this.quiet = setTimeout(() => {
      this.spoken = { [this.state.lang]: laterTexts()?.spokenOf(this.state) ?? "" };
    }, SETTLE_MS);
  }
}

customElements.define("parkade-notices", Notices);
