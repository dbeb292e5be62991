import type { PlannerId } from "parkade";
import { css, html, nothing, type CSSResultGroup, type TemplateResult } from "lit";
import { sentence } from "../app/app";
import type { Progress } from "../planning/worker-count";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { icon } from "../styles/icons";
import { say } from "./papers-messages";

/** One paper's tables: measured when first shown, with progress, cancelled when left, copied as text. */
export abstract class PapersTab<Summary> extends AppElement {
  static override properties = {
    ...AppElement.properties,
    progress: { state: true },
    summary: { state: true },
    notice: { state: true },
    copied: { state: true },
  };
  static override styles: CSSResultGroup = [
    controls,
    css`
    :host { display: contents; }
    .tools {
      display: flex; align-items: center; flex-wrap: wrap; gap: 8px 12px; padding: 0 24px 12px;
      border-bottom: 1px solid var(--parkade-hair);
    }
    .state { display: flex; align-items: center; gap: 8px; color: var(--parkade-t2); min-width: 0; }
    progress {
      appearance: none; width: 140px; height: 4px; border: 0; border-radius: 2px; background: var(--parkade-hair2);
      overflow: hidden;
    }
    progress::-webkit-progress-bar { background: var(--parkade-hair2); }
    progress::-webkit-progress-value { background: var(--parkade-t1); }
    progress::-moz-progress-bar { background: var(--parkade-t1); }
    .copy { margin-left: auto; display: flex; gap: 4px; }
    .scroll { flex: 1; overflow-y: auto; padding: 14px 24px 24px; overscroll-behavior: contain; }
    h3 {
      margin: 18px 0 6px; font: inherit; font-weight: 600; display: flex; gap: 8px; align-items: baseline;
      flex-wrap: wrap;
    }
    h3:first-child { margin-top: 0; }
    h3 span { font-weight: 400; color: var(--parkade-t2); }
    .wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 12px; line-height: 16px; width: 100%; }
    th, td { text-align: right; padding: 5px 8px; white-space: nowrap; font-weight: 400; }
    th:first-child, td:first-child { text-align: left; padding-left: 0; }
    thead th { color: var(--parkade-t2); }
    thead .group-head th { color: var(--parkade-t1); font-weight: 500; padding-bottom: 0; text-align: left; }
    tbody tr { border-top: 1px solid var(--parkade-hair); }
    tbody th { font-weight: 500; }
    .printed { color: var(--parkade-t2); }
    .first { border-left: 1px solid var(--parkade-hair); padding-left: 14px; }
    .ours { font-weight: 600; }
    td .chip { margin-right: 8px; vertical-align: middle; }
    .note { margin: 4px 0 0; color: var(--parkade-t2); font-size: 12px; line-height: 16px; }
    .link {
      border: 0; background: none; padding: 0; margin: 0; min-height: 24px; font: inherit; font-weight: 400;
      color: var(--parkade-accent); cursor: pointer; text-decoration: underline;
    }
    h3 .link { margin-left: 6px; }
    p .link { margin-left: 4px; }
    .pictures { display: flex; flex-wrap: wrap; gap: 10px; margin: 8px 0; }
    @media (max-width: 640px) {
      .tools { padding: 0 16px 10px; }
      .scroll { padding: 14px 16px 16px; }
      .copy { margin-left: 0; }
      th:first-child { position: sticky; left: 0; background: var(--parkade-raise); padding-right: 12px; }
    }
  `,
  ];
  declare progress: Progress | null;
  declare summary: Summary | null;
  declare notice: string | null;
  declare copied: "markdown" | "json" | null;

  constructor() {
    super();
    this.progress = null;
    this.summary = null;
    this.notice = null;
    this.copied = null;
  }

  /** Gives up what runs and keeps what is measured. */
  abstract leave(): void;
  protected abstract get running(): boolean;
  protected abstract work(): Promise<unknown>;
  protected abstract markdown(summary: Summary): string;
  /** How far it is, in words. */
  protected abstract told(progress: Progress): string;
  protected abstract cancelled(done: number): string;

  /** It has come into view. */
  enter(): void {
    if (!this.summary) void this.measure();
  }

  protected watches(): readonly (keyof State)[] {
    return [];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.leave();
  }

  protected frame(tools: TemplateResult | typeof nothing, content: TemplateResult | typeof nothing): TemplateResult {
    const { lang } = this.state;
    return html`<div class="tools">${tools}${this.status()}
        <span class="copy">${(["markdown", "json"] as const).map(
          (one) =>
            html`<button class="button outline" ?disabled=${!this.summary}
              @click=${() => void this.copy(one)}>${icon(
                this.copied === one ? "check" : "copy",
                14,
              )}${say(lang, this.copied === one ? "copied" : one)}</button>`,
        )}</span></div>
      <div class="scroll" tabindex="0">${
        this.summary ? content : html`<p class="note">${say(lang, "waiting")}</p>`
      }</div>`;
  }

  /** Measure, or cancel while it runs. */
  protected button(disabled = false): TemplateResult {
    const { lang } = this.state;
    return this.running
      ? html`<button class="button outline" @click=${this.cancel}>${icon("close", 14)}${say(lang, "cancel")}</button>`
      : html`<button class="button solid" ?disabled=${disabled}
        @click=${() => void this.measure()}>${say(lang, "measure")}</button>`;
  }

  /** Opens a scene of the gallery, beside the planner that a paper means where one is named. */
  protected openScene(id: string, planner?: PlannerId): void {
    this.closest("dialog")?.close();
    if (planner)
      this.app.store.set({ planners: [...new Set([planner, ...this.state.planners])].slice(0, 4), focus: planner });
    this.app.openPreset(id);
  }

  /** The link that opens a row's scene. */
  protected link(id: string, text = say(this.state.lang, "open")): TemplateResult {
    return html`<button class="link" @click=${() => this.openScene(id)}>${text}</button>`;
  }

  /** The paths of planners in scenes, as pictures that open them. */
  protected pictures(pairs: readonly (readonly [scene: string, planner: PlannerId])[], wide = false): TemplateResult {
    return html`<div class="pictures" role="group" aria-label=${say(this.state.lang, "pictures")}
      @parkade-open-scene=${(e: CustomEvent<{ id: string; planner: PlannerId }>) =>
        this.openScene(e.detail.id, e.detail.planner)}>${pairs.map(
        ([scene, planner]) => html`
          <parkade-paper-picture .app=${this.app} .scene=${scene} .planner=${planner}
          ?wide=${wide}></parkade-paper-picture>`,
      )}</div>`;
  }

  /** The reason why it cannot measure, if any. */
  protected refusal(): string | null {
    return null;
  }

  private status(): TemplateResult | typeof nothing {
    const { progress, notice } = this,
      refusal = this.refusal();
    if (refusal) return html`<span class="state" role="alert">${icon("warning", 14)}${refusal}</span>`;
    if (notice) return html`<span class="state" role="alert">${notice}</span>`;
    if (!progress || !this.running) return nothing;
    const text = this.told(progress);
    return html`<span class="state"><progress max=${progress.of} .value=${progress.done}
      aria-label=${text}></progress><span>${text}</span></span>`;
  }

  protected async measure(): Promise<void> {
    if (this.refusal()) return;
    this.notice = null;
    this.progress = null;
    try {
      await this.work();
    } catch (error) {
      this.notice = say(this.state.lang, "failed", { reason: sentence(error) });
    }
    this.requestUpdate();
  }

  private readonly cancel = (): void => {
    this.leave();
    this.notice = this.cancelled(this.progress?.done ?? 0);
  };

  private async copy(format: "markdown" | "json"): Promise<void> {
    if (!this.summary) return;
    if (!(await this.app.copy(format === "json" ? JSON.stringify(this.summary, null, 2) : this.markdown(this.summary))))
      return;
    this.copied = format;
    setTimeout(() => {
      this.copied = null;
    }, 2000);
  }
}
