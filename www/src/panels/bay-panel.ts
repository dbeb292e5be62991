import type { AuditRow, LibraryVehicle, PlannerId } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { download, sentence, type App } from "../app/app";
import { reasonIn } from "../i18n/index";
import { BayChecker, bayWorker } from "../planning/bay-checker";
import { insidePolygon } from "../scene/geometry";
import { fileName } from "../scene/files";
import { setGoalFromSlot } from "../scene/model";
import { sameTail } from "../scene/scene-changes";
import { slotOutline } from "../scene/slots";
import type { Scene, State } from "../store";
import { countBays, gradeOf, type AskedVehicle, type BayCheck, type BayEntry } from "../store/bay-check";
import { controls } from "../styles/controls";
import { icon } from "../styles/icons";
import { fitMap, LINE } from "../view/camera";
import { INK, RAMP } from "../view/layers/bays";
import { AppElement } from "./base";
import { BAY_COLUMNS, bayCsv, bayLines, UNITS, type BayColumn, type BayLine, type BayOrder } from "./bay-rows";
import { heading, say } from "./bay-words";
import { valueOf } from "./inputs";
import { nth } from "../scene/nth";

const ENTRIES: readonly BayEntry[] = ["either", "head-in", "reverse-in"];
const ENTRY_WORDS = { either: "either", "head-in": "headIn", "reverse-in": "reverseIn" } as const;

/** Room for the panel: the way back stands above the inspector, and in a low window the table beside the map. */
const room = css`
  .layout-wide:has(~ parkade-bays[opened]) parkade-inspector { margin-top: 44px; }
  .rails:has(~ parkade-bays:not([hidden], [opened])) :is(parkade-stage, parkade-timeline) { margin-right: 360px; }
`;

/** What the page showed before all bays were checked. */
interface Before {
  planners: PlannerId[];
  focus: PlannerId;
  mode: State["mode"];
}

/** The check of all bays: its table beside the map, in the inspector's place. */
export class BayPanel extends AppElement {
  static override properties = {
    ...AppElement.properties,
    order: { state: true },
    library: { state: true },
    opened: { type: Boolean, reflect: true },
  };
  static override styles = [
    controls,
    css`
    :host {
      position: absolute; inset: 49px 0 0 auto; width: 420px; z-index: 16; display: grid;
      grid-template: auto auto minmax(0, 1fr) auto / minmax(0, 1fr); background: var(--parkade-panel);
      border-left: 1px solid var(--parkade-hair); font-size: 12px; line-height: 16px;
    }
    :host([hidden]) { display: none; }
    header { display: grid; gap: 8px; padding: 10px 14px; }
    .row { display: flex; align-items: center; gap: 8px; }
    h2 { margin: 0; font-size: 13px; line-height: 18px; font-weight: 600; flex: 1; }
    label { display: flex; align-items: center; gap: 6px; color: var(--parkade-t2); min-width: 0; }
    select {
      height: 28px; min-width: 0; max-width: 130px; padding: 0 4px; color: var(--parkade-t1);
      background: var(--parkade-panel); border: 1px solid var(--parkade-hair2);
      border-radius: calc(6px * var(--parkade-radius));
    }
    .sum { color: var(--parkade-t1); font-weight: 500; flex: 1; }
    .legend { display: flex; gap: 3px; align-items: center; color: var(--parkade-t2); }
    .legend b {
      min-width: 20px; padding: 0 4px; font-weight: 600; text-align: center; border-radius: 3px; color: var(--ink);
      background: var(--fill);
    }
    .legend .none {
      background: var(--parkade-err-soft); color: var(--parkade-err); border: 1px solid var(--parkade-err);
    }
    progress { appearance: none; display: block; width: 100%; height: 2px; border: 0; background: var(--parkade-hair); }
    progress::-webkit-progress-bar { background: var(--parkade-hair); }
    progress::-webkit-progress-value { background: var(--parkade-accent); }
    progress::-moz-progress-bar { background: var(--parkade-accent); }
    progress.done { visibility: hidden; }
    .scroll { overflow: auto; min-height: 0; }
    table { border-collapse: collapse; width: 100%; table-layout: fixed; }
    th, td {
      padding: 0 5px; overflow: hidden; text-overflow: ellipsis; text-align: right; font-weight: 400;
      white-space: nowrap;
    }
    :is(th, td):first-child { text-align: left; padding-left: 14px; }
    :is(th, td):last-child { padding-right: 14px; }
    thead th { position: sticky; top: 0; background: var(--parkade-panel); padding-block: 2px; }
    thead button {
      width: 100%; min-height: 28px; height: auto; justify-content: inherit; font-size: 12px; line-height: 14px;
      color: var(--parkade-t2); white-space: normal; text-align: inherit; display: block; overflow-wrap: normal;
      word-break: keep-all;
    }
    thead small { display: block; font-size: 12px; color: var(--parkade-t3); }
    table .button.button { padding: 0; }
    tbody tr { height: 33px; border-top: 1px solid var(--parkade-hair); cursor: pointer; }
    tbody tr.lit { box-shadow: inset 2px 0 0 var(--parkade-t1); background: var(--parkade-hover); }
    .stale { opacity: .5; }
    .err { color: var(--parkade-err); }
    thead th:first-child { width: 20%; }
    thead th:last-child { width: 20%; }
    tbody th button {
      max-width: 100%; display: block; overflow: hidden; text-overflow: ellipsis; min-height: 28px; font-weight: 600;
      font-size: 12px;
    }
    tbody td[colspan] { text-align: left; white-space: normal; line-height: 15px; padding-block: 4px; }
    footer { display: flex; gap: 6px; padding: 6px 14px; border-top: 1px solid var(--parkade-hair); }
    footer .button { font-size: 12px; }
    p { margin: 0; padding: 12px 14px; color: var(--parkade-t2); }
    .back { display: none; }
    :host([opened]) {
      inset: 49px 0 auto auto; width: var(--pane-side, 280px); height: 44px; box-sizing: border-box; display: flex;
      align-items: center; padding: 0 8px; border-bottom: 1px solid var(--parkade-hair);
    }
    :host([opened]) > :not(.back) { display: none; }
    :host([opened]) .back { display: flex; }
    :host(.phone) {
      inset: auto 0 0 0; width: auto; height: 46%; border-left: 0; border-top: 1px solid var(--parkade-hair);
    }
    :host(.phone) .side, :host(.rails) .side { display: none; }
    :host(.rails) { inset: 0 57px 0 auto; width: 360px; z-index: 30; }
    :host(.rails) header { gap: 2px; padding-block: 2px 4px; }
    :host(.rails) footer { padding-block: 3px; }
    :host(.rails) :is(th, td), :host(.phone) :is(th, td) { padding-inline: 3px; }
    :host(.rails) :is(th, td):first-child, :host(.phone) :is(th, td):first-child { padding-left: 14px; }
    :host(.rails) :is(th, td):last-child, :host(.phone) :is(th, td):last-child { padding-right: 10px; }
    :host(.rails) thead th:first-child { width: 17%; }
    :host(.rails) thead th:last-child { width: 21%; }
    :host(.phone[opened]), :host(.rails[opened]) {
      width: auto; height: auto; padding: 0; border: 1px solid var(--parkade-hair);
      border-radius: calc(10px * var(--parkade-radius)); box-shadow: var(--parkade-float);
      background: var(--parkade-raise);
    }
    :host(.phone[opened]) { inset: 106px 8px auto auto; }
    :host(.rails[opened]) { inset: 8px 66px auto auto; }
    @container (max-width: 960px) {
      :host([opened]:not(.phone, .rails)) {
        inset: 96px 12px auto auto; width: auto; height: auto; padding: 0; border: 1px solid var(--parkade-hair);
        border-radius: calc(10px * var(--parkade-radius)); box-shadow: var(--parkade-float);
        background: var(--parkade-raise);
      }
    }
  `,
  ];
  declare order: BayOrder;
  declare library: LibraryVehicle[];
  declare opened: boolean;
  private checker: BayChecker | null = null;
  private earlier: Before | null = null;
  /** The scene as a plan's opening made it, and the one before. */
  private visited: { from: Scene; to: Scene } | null = null;
  private unwatch: (() => void) | null = null;
  private readonly resized = new ResizeObserver(() => this.fitLot());

  constructor() {
    super();
    this.order = { column: "worst", descends: false };
    this.library = [];
    this.opened = false;
    this.hidden = true;
  }

  protected watches(): readonly (keyof State)[] {
    return ["bays", "theme", "scene"];
  }

  private get check(): BayCheck | null {
    return this.state.bays ?? null;
  }

  /** Opens, or closes what is open. */
  async toggle(): Promise<void> {
    if (!this.hidden) return this.close();
    const { app } = this,
      { store } = app,
      engine = await app.complete();
    if (!this.hidden) return;
    this.library = engine.api.vehicles();
    const { planners, focus, mode, scene } = store.state;
    this.earlier = { planners, focus, mode };
    const vehicle = { id: "own", vehicle: scene.vehicle ?? "paper" };
    store.set({
      bays: { vehicle, entry: "either", rows: new Map(), stale: new Set(), done: 0, of: 0, lit: null, opened: false },
    });
    this.checker = new BayChecker(store, () => bayWorker(engine), this.failed, vehicle);
    this.hidden = false;
    this.showAll();
    this.unwatch = store.subscribe((state, previous) => this.onState(state, previous));
    this.checker.askAll();
  }

  readonly close = (): void => {
    const { store } = this.app;
    this.unwatch?.();
    this.checker?.stop();
    this.checker = null;
    this.resized.disconnect();
    this.hidden = true;
    this.visited = null;
    this.opened = false;
    this.host.style.removeProperty("--pane-side");
    this.host.folded = false;
    store.set({ bays: null, ...(this.earlier ?? {}), camera: null });
  };

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resized.disconnect();
    this.unwatch?.();
    this.checker?.stop();
    this.checker = null;
  }

  private get host(): HTMLElement & { folded: boolean; compact: boolean; rails: boolean } {
    return (this.getRootNode() as ShadowRoot).host as HTMLElement & {
      folded: boolean;
      compact: boolean;
      rails: boolean;
    };
  }

  /** One map with all bays. */
  private showAll(): void {
    const { host } = this;
    this.classList.toggle("rails", host.rails);
    this.classList.toggle("phone", host.compact && !host.rails);
    if (!host.compact) {
      host.style.setProperty("--pane-side", "420px");
      host.folded = true;
    }
    this.opened = false;
    this.app.store.set({ planners: ["hybrid"], focus: "hybrid", mode: "overlay", camera: null });
    if (host.compact) this.resized.observe(this);
  }

  /** On a phone the whole lot stands in what the table leaves of the map. */
  private fitLot(): void {
    const map = this.host.shadowRoot?.querySelector("parkade-stage")?.getBoundingClientRect();
    if (!map || this.hidden || this.opened || !this.host.compact) return;
    const { width, height } = map,
      covered = this.classList.contains("phone") ? Math.max(0, map.bottom - this.getBoundingClientRect().top) : 0,
      { scene } = this.app.store.state;
    const camera = fitMap(scene, width, height - covered - LINE);
    this.app.store.set({ camera: { ...camera, y: camera.y + (LINE - covered) / 2 / camera.scale } });
  }

  private onState(state: State, previous: State): void {
    if (state.hover !== previous.hover && state.hover) this.light(this.bayAt(state.hover));
    if (state.opened !== previous.opened && !this.opened) return this.checker?.askAll();
    const isEdited = state.scene !== previous.scene || state.transient !== previous.transient;
    if (isEdited && !state.transient && !this.opened) this.checker?.follow(state.scene);
  }

  private bayAt({ x, y }: { x: number; y: number }): number | null {
    const at = (this.state.scene.slots ?? []).findIndex((slot) => insidePolygon([x, y], slotOutline(slot)));
    return at < 0 ? null : at;
  }

  private light(lit: number | null, scrolls = true): void {
    const { check } = this;
    if (!check || check.lit === lit) return;
    this.app.store.set({ bays: { ...check, lit } });
    if (lit !== null && scrolls)
      void this.updateComplete.then(() =>
        this.renderRoot.querySelector("tr.lit")?.scrollIntoView({ block: "nearest" }),
      );
  }

  private readonly failed = (error: unknown): void => {
    const { lang } = this.state;
    this.app.store.set({
      message: { tone: "err", text: say(lang, "failed", { reason: reasonIn(lang, sentence(error)) }) },
    });
  };

  /** The plan into a bay in the panels that were there before. */
  private openPlan({ index, best }: BayLine): void {
    const { app, check } = this,
      { store } = app,
      { scene } = store.state,
      slot = scene.slots?.[index];
    if (!check || slot?.id === undefined) return;
    const { vehicle } = check.vehicle,
      moved =
        check.vehicle.id === "own"
          ? scene
          : { ...scene, vehicle, start: sameTail(scene.start, scene.vehicle, vehicle) },
      to = setGoalFromSlot(moved, slot.id, best.entry);
    this.opened = true;
    this.visited = { from: scene, to };
    this.host.style.removeProperty("--pane-side");
    this.host.folded = false;
    store.edit(to, { label: "question" });
    store.set({ ...this.earlier, focus: "hybrid", bays: { ...check, opened: true, lit: null }, camera: null });
  }

  /** Takes the visit back, unless the scene was edited in it. */
  private readonly back = (): void => {
    const { store } = this.app,
      { visited, check } = this;
    if (visited && store.state.scene === visited.to) store.undo();
    this.visited = null;
    if (check) store.set({ bays: { ...check, opened: false } });
    this.showAll();
    this.checker?.follow(store.state.scene);
  };

  private choose(id: string): void {
    const { check } = this,
      known = this.library.find((one) => one.id === id);
    if (!check) return;
    const vehicle: AskedVehicle = known
      ? { id, vehicle: known.vehicle }
      : { id: "own", vehicle: this.state.scene.vehicle ?? "paper" };
    this.checker?.askAll(vehicle);
  }

  protected override render(): TemplateResult | typeof nothing {
    const { check } = this,
      { lang, scene } = this.state;
    if (!check || this.hidden) return nothing;
    const lines = bayLines(check, this.order),
      { asked, reachable, hard } = countBays(check),
      isRunning = check.done < check.of;
    return html`<button class="button back" @click=${this.back}>${icon("undo", 14)}${say(lang, "allBays")}</button>
      <header><div class="row"><h2>${say(lang, "title")}</h2>${this.legend()}<button class="icon small" aria-label=${say(lang, "close")} title=${say(lang, "close")} @click=${this.close}>${icon("close", 14)}</button></div>
        <div class="row"><label><span class="side">${say(lang, "vehicle")}</span>${this.vehicles(check)}</label><label><span class="side">${say(lang, "entry")}</span>${this.entries(check)}</label></div>
        <div class="row"><span class="sum" aria-live="polite">${asked > 0 ? html`${say(lang, "reachable", { n: reachable, of: asked })} · ${say(lang, "hard", { n: hard })}` : nothing}</span>
          <span>${isRunning ? say(lang, "running", { done: check.done, of: check.of }) : nothing}</span></div></header>
      <progress class=${isRunning ? "" : "done"} max=${check.of || 1} value=${check.done} aria-label=${say(lang, "running", { done: check.done, of: check.of })}></progress>
      ${(scene.slots ?? []).length === 0 ? html`<p>${say(lang, "none")}</p>` : html`<div class="scroll" @pointerleave=${() => this.light(null)}>${this.table(lines, check)}</div>`}
      <footer><button class="button outline" ?disabled=${isRunning} @click=${this.report}>${icon("file", 14)}${say(lang, "report")}</button><button class="button outline" ?disabled=${isRunning} @click=${this.csv}>${icon("export", 14)}${say(lang, "table")}</button></footer>`;
  }

  private legend(): TemplateResult {
    const scheme = this.app.tokens().dark ? "dark" : "light";
    return html`<span class="legend">${say(this.state.lang, "legend")} ${RAMP[scheme].map((fill, i) => html`<b .style=${`--fill:${fill};--ink:${nth(INK[scheme], i)}`}>${i < 3 ? i + 1 : ">3"}</b>`)}<b class="none" title=${say(this.state.lang, "outOfReach")}>✕</b></span>`;
  }

  private vehicles({ vehicle }: BayCheck): TemplateResult {
    const { lang } = this.state,
      choices = [
        { id: "own", title: say(lang, "own") },
        ...this.library.map(({ id, title }) => ({ id, title: title[lang] })),
      ];
    return html`<select aria-label=${say(lang, "vehicle")} @change=${(event: Event) => this.choose(valueOf(event))}>${choices.map(({ id, title }) => html`<option value=${id} ?selected=${id === vehicle.id}>${title}</option>`)}</select>`;
  }

  private entries(check: BayCheck): TemplateResult {
    const { lang } = this.state;
    return html`<select aria-label=${say(lang, "entry")} @change=${(event: Event) => this.app.store.set({ bays: { ...check, entry: valueOf(event) as BayEntry } })}>${ENTRIES.map((entry) => html`<option value=${entry} ?selected=${entry === check.entry}>${say(lang, ENTRY_WORDS[entry])}</option>`)}</select>`;
  }

  private table(lines: readonly BayLine[], check: BayCheck): TemplateResult {
    return html`<table><thead><tr>${BAY_COLUMNS.map((column) => this.head(column))}</tr></thead>
      <tbody>${lines.map((line) => this.line(line, check))}</tbody></table>`;
  }

  private head(column: BayColumn): TemplateResult {
    const { lang } = this.state,
      unit = UNITS[column],
      { order } = this,
      sorted = order.column === column ? (order.descends ? "descending" : "ascending") : "none";
    return html`<th scope="col" aria-sort=${sorted}><button class="button" title=${say(lang, "sort", { column: heading(lang, column) })} @click=${() => {
      this.order = { column, descends: order.column === column && !order.descends };
    }}>${say(lang, column)}${sorted === "none" ? nothing : sorted === "ascending" ? " ↑" : " ↓"}${unit ? html`<small>${unit}</small>` : nothing}</button></th>`;
  }

  private line(line: BayLine, check: BayCheck): TemplateResult {
    const { index, bay, best, headIn, reverseIn } = line,
      { lang } = this.state;
    const name = `${index === check.lit ? "lit" : ""} ${check.stale.has(index) ? "stale" : ""}`,
      value = (number: number | null, digits: number): string => (number === null ? "–" : this.num(number, digits));
    return html`<tr class=${name} @click=${() => this.openPlan(line)} @pointerenter=${() => this.light(index, false)}>
      <th scope="row"><button class="button" title=${say(lang, "show", { bay })} @focus=${() => this.light(index, false)}>${bay}</button></th>
      <td>${this.moves(headIn)}</td><td>${this.moves(reverseIn)}</td>
      ${best.reachable ? html`<td>${value(best.length, 1)}</td><td>${value(best.driveTime, 0)}</td><td>${value(best.clearance, 2)}</td>` : html`<td colspan="3" class="err">${reasonIn(lang, best.reason ?? "") || say(lang, "outOfReach")}</td>`}</tr>`;
  }

  private moves(row: AuditRow | undefined): TemplateResult | string {
    if (!row) return "–";
    const { lang } = this.state,
      out = row.out && !row.out.reachable ? say(lang, "wayOut", { reason: row.out.reason ?? "" }) : "";
    if (gradeOf(row) === 0) return html`<span class="err" title=${reasonIn(lang, row.reason ?? "")}>✕</span>`;
    return out ? html`<span class="err" title=${out}>${row.moves} ⚠</span>` : `${row.moves}`;
  }

  private readonly csv = (): void => {
    if (this.check)
      download(new Blob([bayCsv(this.check)], { type: "text/csv" }), `${fileName(this.state.scene)}-bays.csv`);
  };

  private readonly report = (): void => {
    void this.app.fetchPart(async () => (await import("./bay-report")).saveReport(this.app));
  };
}

customElements.define("parkade-bays", BayPanel);

/** Opens or closes the check of all bays of the playground that `beside` is a piece of. */
export function toggleBays(app: App, beside: HTMLElement): void {
  const root = beside.getRootNode() as ShadowRoot;
  let panel = root.querySelector<BayPanel>("parkade-bays");
  if (!panel) {
    panel = Object.assign(new BayPanel(), { app });
    root.append(panel);
    root.adoptedStyleSheets.push(room.styleSheet!);
  }
  void panel.toggle();
}
