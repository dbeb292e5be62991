import { css, html, nothing, type TemplateResult } from "lit";
import { mostExpanded } from "../app/player";
import { isLong } from "../view/camera";
import { durationOf, lastOf } from "../view/playback-time";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { numberOf, valueOf } from "./inputs";
import { laterTexts } from "./lazy-texts";
import { icon, type IconName } from "../styles/icons";

const SPEEDS = [0.25, 0.5, 1, 2, 4] as const;

/** The slider that moves every car, or every search, at once. */
export class Timeline extends AppElement {
  static override properties = {
    ...AppElement.properties,
    compact: { type: Boolean, reflect: true },
    folded: { type: Boolean },
  };
  static override styles = [
    controls,
    css`
    :host {
      display: block; container-type: inline-size; background: var(--parkade-panel);
      border-top: 1px solid var(--parkade-hair);
    }
    .row { display: flex; align-items: center; height: 43px; padding: 0 14px 0 10px; gap: 2px; }
    .segmented { margin: 0 16px 0 14px; flex: none; }
    .track { position: relative; container-type: inline-size; flex: 1; height: 32px; min-width: 60px; }
    .track .rails { position: absolute; inset: 0; width: 100%; height: 100%; overflow: visible; pointer-events: none; }
    .track .slider { position: absolute; inset: 0; height: 32px; }
    .slider::-webkit-slider-runnable-track { background: none; }
    .slider::-moz-range-track, .slider::-moz-range-progress { background: none; }
    .slider::-webkit-slider-thumb { position: relative; z-index: 1; }
    .rail { stroke: var(--parkade-hair2); stroke-width: 2; }
    .done { stroke: var(--parkade-t1); stroke-width: 2; }
    .reverse { stroke: var(--parkade-t1); stroke-width: 3; stroke-dasharray: 0.1 5; stroke-linecap: round; }
    .track .diamond {
      position: absolute; top: 50%; left: 0; width: 10px; height: 10px; margin: -5px 0 0 -5px; pointer-events: none;
      overflow: visible;
    }
    .diamond path { fill: #fff; stroke: #1b1d20; stroke-width: 1.25; }
    .now { margin-left: 16px; white-space: nowrap; min-width: 96px; text-align: left; }
    select {
      appearance: none; border: 0; background: none; height: 32px; padding: 0 8px; font-weight: 500; cursor: pointer;
      border-radius: calc(6px * var(--parkade-radius));
    }
    select:hover { background: var(--parkade-hover); }
    option { background: var(--parkade-raise); color: var(--parkade-t1); }
    @media (forced-colors: active) {
      :is(.rail, .done, .reverse) { stroke: CanvasText; }
      .done { stroke: Highlight; }
      .slider::-webkit-slider-runnable-track { background: none; }
    }
    .up svg { transform: scaleY(-1); }
    .on { color: var(--parkade-accent); }
    @container (max-width: 700px) { .unit { display: none; } .segmented { margin: 0 8px; } }
    :host([compact]) .row { height: 48px; padding: 0 10px; gap: 8px; }
    :host([compact]) .segmented { order: 3; margin: 0; }
    :host([compact]) .icon { width: 44px; height: 44px; }
    :host([compact]) .segmented button { height: 30px; }
    :host([slim]) .row { height: 36px; } :host([slim]) :is(.icon, .slider, .track) { height: 36px; min-height: 0; }
  `,
  ];
  declare compact: boolean;
  declare folded: boolean;

  constructor() {
    super();
    this.compact = this.folded = false;
  }

  protected override redrawMs = 100;

  protected watches(): readonly (keyof State)[] {
    return ["playback", "results", "focus", "hidden", "waiting", "scene", "follow", "guest"];
  }

  protected override render(): unknown {
    const { playing } = this.state.playback;
    const play = this.button(playing ? "pause" : "play", playing ? "time.pause" : "time.play", () =>
      this.app.player.toggle(),
    );
    const fold = this.t(this.folded ? "chart.expand" : "chart.collapse");
    if (this.compact)
      return html`<div class="row" role="group"
        aria-label=${this.t("time.label")}>${play}${this.scrubber()}${this.bases()}</div>`;
    return html`<div class="row" role="group" aria-label=${this.t("time.label")}>
      ${this.button("first", "time.first", () => this.app.player.seek(0))}
      ${this.button("back", "time.back", (e) => this.app.player.step(-1, e.shiftKey))}
      ${play}
      ${this.button("next", "time.next", (e) => this.app.player.step(1, e.shiftKey))}
      ${this.button("last", "time.last", () => this.app.player.seek(1))}
      ${this.bases()}
      ${this.scrubber()}
      <span class="now">${this.position()}</span>
      ${this.state.playback.base === "search" ? this.unit() : nothing}
      ${this.state.scene.moving?.length ? this.waiting() : nothing}
      ${this.speed()}
      <button class="icon ${this.app.player.loop ? "on" : ""}" aria-pressed=${this.app.player.loop}
        aria-label=${this.t("time.loop")} title=${this.t("time.loop")}
        @click=${() => {
          this.app.player.loop = !this.app.player.loop;
          this.requestUpdate();
        }}>${icon("loop")}</button>
      ${
        isLong(this.state.scene)
          ? html`<button class="icon ${this.state.follow ? "on" : ""}" aria-pressed=${this.state.follow}
            aria-label=${this.t("time.follow")} title=${this.t("time.follow")}
        @click=${() => this.app.store.set({ follow: !this.state.follow, camera: null })}>${icon("car")}</button>`
          : nothing
      }
      <button class="icon ${this.folded ? "up" : ""}" aria-expanded=${!this.folded} aria-label=${fold} title=${fold}
        @click=${() => this.app.ask("fold")}>${icon("down")}</button>
    </div>`;
  }

  private bases(): TemplateResult {
    const { base } = this.state.playback;
    return html`<div class="segmented" role="group" aria-label=${this.t("time.base")}>
      ${(["search", "drive"] as const).map(
        (one) =>
          html`<button aria-pressed=${base === one}
            @click=${() => this.setBase(one)}>${this.t(`time.${one}`)}</button>`,
      )}</div>`;
  }

  private setBase(base: "search" | "drive"): void {
    const { layers } = this.state;
    this.app.player.set({ base });
    if (base === "search") this.app.store.set({ layers: { ...layers, heat: true, tree: true } });
    else if (layers.tree) this.app.store.set({ layers: { ...layers, tree: false } });
  }

  private unit(): TemplateResult {
    const { searchMode } = this.state.playback;
    return html`<select class="unit" aria-label=${this.t("time.unit")} .value=${searchMode}
      @change=${(e: Event) => this.app.player.set({ searchMode: valueOf(e) as State["playback"]["searchMode"] })}>
      ${(["percent", "expansions"] as const).map(
        (mode) => html`<option value=${mode} ?selected=${mode === searchMode}>${this.t(`time.${mode}`)}</option>`,
      )}</select>`;
  }

  private waiting(): TemplateResult {
    return html`<select aria-label=${this.t("time.waiting")} title=${this.t("time.waiting")}
      @change=${(e: Event) => this.app.store.set({ waiting: valueOf(e) as State["waiting"] })}>
      ${(["predictive", "reactive"] as const).map(
        (one) => html`<option value=${one} ?selected=${one === this.state.waiting}>${this.t(`time.${one}`)}</option>`,
      )}</select>`;
  }

  private speed(): TemplateResult {
    const { speed } = this.state.playback;
    return html`<select aria-label=${this.t("time.speed")} title=${this.t("time.speed")}
      @change=${(e: Event) => this.app.player.set({ speed: numberOf(e) })}>
      ${SPEEDS.map((one) => html`<option value=${one} ?selected=${one === speed}>${one}×</option>`)}</select>`;
  }

  private position(): string {
    const { playback } = this.state;
    // Seconds are told of drives only.
    if (playback.base === "drive" && (lastOf(this.state) || this.state.scene.moving?.length)) {
      const total = durationOf(this.state);
      return this.t("time.drivenOf", { now: this.num(playback.fraction * total, 1), total: this.num(total, 1) });
    }
    if (playback.base === "drive" || playback.searchMode === "percent")
      return this.t("time.searchOf", { now: this.num(playback.fraction * 100, 0) });
    const total = mostExpanded(this.state);
    return this.t("time.countOf", {
      now: this.num(Math.round(playback.fraction * total), 0),
      total: this.num(total, 0),
    });
  }

  private scrubber(): TemplateResult {
    const { fraction } = this.state.playback;
    const done = `${fraction * 100}%`;
    return html`<div class="track">
      <svg class="rails" aria-hidden="true"><line class="rail" x1="0" x2="100%" y1="16" y2="16"/><line class="done"
        x1="0" x2=${done} y1="16" y2="16"/></svg>
      ${laterTexts()?.gearMarks(this.state)}
      <input class="slider" type="range" min="0" max="1" step="0.001" .value=${String(fraction)}
        aria-label=${this.t("time.position")} aria-valuetext=${this.position()}
        @input=${(e: Event) => this.app.player.seek(numberOf(e))}>
    </div>`;
  }

  private button(
    name: IconName,
    key: "time.first" | "time.back" | "time.play" | "time.pause" | "time.next" | "time.last",
    run: (event: MouseEvent) => void,
  ): TemplateResult {
    return html`<button class="icon" aria-label=${this.t(key)} title=${this.t(key)}
      @click=${run}>${icon(name)}</button>`;
  }
}

customElements.define("parkade-timeline", Timeline);
