import type { PlannerId } from "parkade";
import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { plannerName } from "../styles/planner-style";
import { goalPose, vehicleOf } from "../scene/model";
import type { State } from "../store";
import { waiting } from "../view/piece";
import { controls } from "../styles/controls";
import { cameraFor, LOW_MAP, worldToScreen } from "../view/camera";
import { AppElement } from "./base";
import { laterTexts } from "./lazy-texts";
import { icon, marker } from "../styles/icons";
import { searchTime, statusOf, timeTitle, type Status } from "../texts/status";
import "./scene-view";

const TITLE = 32;
/** Pixels of the line that says why a planner fails, in two rows, and a little more. */
const LINES = 40;
/** Pixels of a corner's pill, and a little more. */
const READOUT = { width: 280, height: 68 };
const LEGEND = { width: 160, height: 48 };

/** Waits before "updating" is said, so that quick plans do not flicker. */
const SLOW_MS = 300;

/** One planner: its name, its answer in words, and the scene with its path. */
export class PlannerPanel extends AppElement {
  static override properties = {
    ...AppElement.properties,
    planner: { type: String },
    thumb: { type: Boolean, reflect: true },
    slow: { state: true },
  };
  static override styles = [
    controls,
    css`
    :host {
      display: grid; container-type: inline-size; grid-template-rows: 32px 1fr; min-width: 0; min-height: 0;
      background: var(--parkade-panel); position: relative;
    }
    :host([active])::before {
      content: ""; position: absolute; inset: 0 0 auto; height: 2px; background: var(--parkade-accent); z-index: 2;
    }
    header {
      display: flex; align-items: center; gap: 8px; padding: 0 8px 0 12px; border-bottom: 1px solid var(--parkade-hair);
      min-width: 0; overflow: hidden; cursor: default; user-select: none; -webkit-user-select: none;
    }
    h2 {
      margin: 0; min-width: 0; font: inherit; font-weight: 600; white-space: nowrap; display: flex; align-items: center;
      gap: 8px;
    }
    h2 span { overflow: hidden; text-overflow: ellipsis; }
    .time { color: var(--parkade-t2); white-space: nowrap; min-width: 58px; }
    .chip { flex: 0 1 auto; min-width: 56px; }
    .chip .short { display: none; }
    @container (max-width: 470px) {
      .chip .short { display: block; }
      .chip .long { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
    }
    /* Of many planners the names stay, and what the answer is, by its colour and sign. */
    @container (max-width: 330px) { .time { display: none; } h2 { flex: 0 1 auto; } }
    @container (max-width: 250px) {
      .chip .short { display: none; }
      .chip { flex: none; min-width: 0; padding: 0 4px; }
      header { gap: 4px; padding: 0 4px 0 8px; }
    }
    @container (max-width: 150px) { .end button:first-child:not(:last-child) { display: none; } }
    .off h2, .off .time { color: var(--parkade-t3); }
    .stale .time { color: var(--parkade-t3); }
    .end, parkade-smooth { margin-left: auto; display: flex; flex: none; } parkade-smooth + .end { margin: 0; }
    .body { position: relative; min-height: 0; }
    parkade-scene-view { position: absolute; inset: 0; }
    .corner { position: absolute; left: var(--scale-inset, 8px); bottom: 28px; pointer-events: none; }
    .corner.right {
      left: auto; right: var(--legend-inset, 8px); bottom: 8px; display: grid; gap: 4px; justify-items: end;
    }
    .slim .corner { display: none; }
    .corner.top { bottom: auto; top: 46px; }
    .pill {
      display: flex; align-items: center; gap: 10px; height: 24px; padding: 0 8px;
      background: color-mix(in srgb, var(--parkade-panel) 94%, transparent); border: 1px solid var(--parkade-hair);
      border-radius: calc(5px * var(--parkade-radius)); font-size: 12px; line-height: 16px; color: var(--parkade-t2);
      white-space: nowrap;
    }
    .pill b { font-weight: 500; color: var(--parkade-t1); margin-left: 4px; }
    .legend { gap: 6px; }
    .weights { gap: 6px; }
    .weights i { width: 18px; height: 14px; border: 1px solid var(--parkade-warn); }
    .ramp {
      width: 72px; height: 6px; border-radius: 1px;
      background: linear-gradient(to right, #00224e, #123570, #3b496c, #575d6d, #707173, #8a8678, #a59c74, #c3b369,
        #e1cc55, #fde838);
    }
    parkade-failure { position: absolute; inset: 0 0 auto; }
    parkade-failure.low { inset: auto 0 0; }
    .low ~ .corner:not(.top) { bottom: 46px; }
    .hidden-note {
      position: absolute; inset: 0; display: grid; place-items: center; background: var(--parkade-panel);
      color: var(--parkade-t3); text-align: center; padding: 12px;
    }
    :host([thumb]) .time, :host([thumb]) .pill, :host([thumb]) parkade-failure { display: none; }
    :host([thumb]) { --panel-gap: 6px; }
  `,
  ];
  declare planner: PlannerId;
  declare thumb: boolean;
  declare slow: boolean;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Of the map, kept because reading it makes the browser lay out the page. */
  private size = { width: 0, height: 0 };
  private readonly observer = new ResizeObserver(([entry]) => {
    if (!entry) return;
    const { width, height } = entry.contentRect;
    this.size = { width, height: height - TITLE };
    this.requestUpdate();
  });

  constructor() {
    super();
    this.slow = false;
    this.thumb = false;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
    waiting.add(this.drawAgain);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
    waiting.delete(this.drawAgain);
  }

  protected override redrawMs = 100;
  private readonly drawAgain = (): void => this.requestUpdate();

  protected watches(): readonly (keyof State)[] {
    return ["results", "progress", "hidden", "focus", "hover", "explained", "mode", "layers", "scene", "camera"];
  }

  protected override willUpdate(changed: PropertyValues): void {
    super.willUpdate(changed);
    this.watchTheClock(this.state.results[this.planner]?.status === "planning");
    this.toggleAttribute("active", this.state.focus === this.planner);
  }

  protected override render(): unknown {
    const { state, planner } = this;
    const result = state.results[planner];
    const hidden = state.hidden.has(planner);
    const status = statusOf(state, planner);
    const slim = this.size.height < LOW_MAP;
    const met = laterTexts()?.encounterOf(state, result);
    const label = this.t("panel.canvas", { planner: plannerName(state.lang, planner), status: status.chip });
    return html`
      <header class="${hidden ? "off" : ""} ${result?.status === "planning" ? "stale" : ""}" @dblclick=${this.maximise}
        @pointerdown=${this.takeFocus}>
        <h2>${marker(planner)}<span>${plannerName(state.lang, planner)}</span></h2>
        <span class="time" title=${timeTitle(state.lang, result)}>${searchTime(state.lang, result)}</span>
        ${this.chip(status)}${met ? this.chip(met) : nothing}
        ${
          this.thumb ? nothing : html`<parkade-smooth .app=${this.app} .planner=${planner}></parkade-smooth>`
        }<span class="end">${this.buttons(hidden)}</span>
      </header>
      <div class="body ${slim ? "slim" : ""}" @pointerdown=${this.takeFocus}>
        ${
          hidden
            ? html`<div class="hidden-note">${this.t("panel.hidden")}</div>`
            : html`
              <parkade-scene-view exportparts="canvas" .app=${this.app} .planners=${[planner]}
              .label=${label}></parkade-scene-view>
              <parkade-failure class=${this.isLow() ? "low" : ""} ?slim=${slim} .app=${this.app}
              .planner=${planner}></parkade-failure>
              ${
                this.thumb
                  ? nothing
                  : html`<parkade-choices class=${this.isLow() ? "low" : ""} .app=${this.app}
                .planner=${planner}></parkade-choices>`
              }
          <div class="corner ${this.corner("left")}">${laterTexts()?.readoutOf(state, planner)}</div>
          <div class="corner right ${this.corner("right")}">${laterTexts()?.legendOf(state, planner)}</div>`
        }
      </div>`;
  }

  /** True if the line over the map would lie on start or goal. */
  private isLow(): boolean {
    const { width, height } = this.size;
    return width > 0 && handlePoints(this.state, width, height).some(([, y]) => y < LINES);
  }

  /** The upper corner where a pose or its handle would be covered in the lower one. */
  private corner(side: "left" | "right"): "top" | "" {
    const { width, height } = this.size;
    if (width === 0) return "";
    const reach = side === "left" ? READOUT : LEGEND;
    const covered = handlePoints(this.state, width, height).some(
      ([x, y]) => y > height - reach.height && (side === "left" ? x < reach.width : x > width - reach.width),
    );
    return covered ? "top" : "";
  }

  private chip(status: Status): TemplateResult {
    const told = this.state.progress[this.planner];
    const updating = told === undefined ? this.t("status.updating") : `${this.num(told, 0)} ${this.t("unit.expanded")}`;
    const busy = this.slow && (told !== undefined || this.state.results[this.planner]?.plan);
    const shown: Status = busy
      ? { ...status, tone: "quiet", icon: "clock", chip: updating, brief: updating, tiny: updating }
      : status;
    return html`<span class="chip ${shown.tone}" title=${
      shown.title ?? shown.chip
    }>${icon(shown.icon, 12)}<span class="long">${shown.chip}</span><span class="short"
      aria-hidden="true">${this.thumb ? shown.tiny : shown.brief}</span></span>`;
  }

  private buttons(hidden: boolean): TemplateResult {
    const name = plannerName(this.state.lang, this.planner);
    const eye = this.t(hidden ? "panel.show" : "panel.hide", { planner: name });
    const alone = this.state.mode === "focus" && this.state.focus === this.planner;
    const size = alone ? this.t("panel.restore") : this.t("panel.maximise", { planner: name });
    return html`
      ${
        this.thumb
          ? nothing
          : html`<button class="icon small" aria-pressed=${!hidden} aria-label=${eye} title=${eye}
            @click=${this.hide}>${icon(hidden ? "eyeOff" : "eye")}</button>`
      }
      <button class="icon small" aria-label=${size} title=${size}
        @click=${this.maximise}>${icon(alone ? "restore" : "maximise")}</button>`;
  }

  private readonly hide = (): void => {
    const hidden = new Set(this.state.hidden);
    if (!hidden.delete(this.planner)) hidden.add(this.planner);
    this.app.store.set({ hidden });
  };

  private readonly maximise = (): void => {
    const alone = this.state.mode === "focus" && this.state.focus === this.planner;
    this.app.store.set({ mode: alone ? "grid" : "focus", focus: this.planner, camera: null });
  };

  private readonly takeFocus = (): void => {
    if (this.state.focus !== this.planner && !this.thumb) this.app.store.set({ focus: this.planner });
  };

  private watchTheClock(planning: boolean): void {
    if (planning && this.timer === undefined)
      this.timer = setTimeout(() => {
        this.slow = true;
      }, SLOW_MS);
    if (planning) return;
    clearTimeout(this.timer);
    this.timer = undefined;
    this.slow = false;
  }
}

/** Positions of start, goal and the goal's handle, in pixels. */
function handlePoints(state: State, width: number, height: number): [number, number][] {
  const view = { camera: cameraFor(state, width, height), width, height };
  const nose = vehicleOf(state.scene.vehicle).rearToFront;
  const goal = goalPose(state.scene);
  return [state.scene.start, goal].flatMap(({ x, y, heading }) =>
    [0, nose, nose + 1.2].map((ahead) =>
      worldToScreen(view, x + ahead * Math.cos(heading), y + ahead * Math.sin(heading)),
    ),
  );
}

customElements.define("parkade-panel", PlannerPanel);
