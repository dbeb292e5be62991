import type { AuditRow, LibraryVehicle, PlannerId } from "parkade";
import { html, nothing, type TemplateResult } from "lit";
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
import { bayStyles, room } from "./bay-styles";
import { heading, say } from "./bay-messages";
import { valueOf } from "./inputs";
import { nth } from "../scene/nth";

const ENTRIES: readonly BayEntry[] = ["either", "head-in", "reverse-in"];
const ENTRY_WORDS = { either: "either", "head-in": "headIn", "reverse-in": "reverseIn" } as const;

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
  static override styles = [controls, bayStyles];
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
    this.resized.observe(this);
  }

  /** The whole lot stands in what the table leaves of the map, on a phone below the map's first line. */
  private fitLot(): void {
    const map = this.host.shadowRoot?.querySelector("parkade-stage")?.getBoundingClientRect();
    if (!map || this.hidden || this.opened) return;
    const { width, height } = map,
      line = this.host.compact ? LINE : 0,
      covered = this.classList.contains("phone") ? Math.max(0, map.bottom - this.getBoundingClientRect().top) : 0,
      { scene } = this.app.store.state;
    const camera = fitMap(scene, width, height - covered - line);
    this.app.store.set({ camera: { ...camera, y: camera.y + (line - covered) / 2 / camera.scale } });
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
      // A map of its own is fitted to this bay's plan.
      to = setGoalFromSlot({ ...moved, map: { ...scene.map } }, slot.id, best.entry);
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
      <header><div class="row"><h2>${say(lang, "title")}</h2>${this.legend()}<button class="icon small"
        aria-label=${say(lang, "close")} title=${say(lang, "close")}
        @click=${this.close}>${icon("close", 14)}</button></div>
        <div class="row"><label><span
          class="side">${say(lang, "vehicle")}</span>${this.vehicles(check)}</label><label><span
          class="side">${say(lang, "entry")}</span>${this.entries(check)}</label></div>
        <div class="row"><span class="summary" aria-live="polite">${
          asked > 0
            ? html`${say(lang, "reachable", { n: reachable, of: asked })} · ${say(lang, "hard", { n: hard })}`
            : nothing
        }</span>
          <span>${isRunning ? say(lang, "running", { done: check.done, of: check.of }) : nothing}</span></div></header>
      <progress class=${isRunning ? "" : "done"} max=${check.of || 1} value=${check.done}
        aria-label=${say(lang, "running", { done: check.done, of: check.of })}></progress>
      ${
        (scene.slots ?? []).length === 0
          ? html`<p>${say(lang, "none")}</p>`
          : html`<div class="scroll" @pointerleave=${() => this.light(null)}>${this.table(lines, check)}</div>`
      }
      <footer><button class="button outline" ?disabled=${isRunning}
        @click=${this.report}>${icon("file", 14)}${say(lang, "report")}</button><button class="button outline"
        ?disabled=${isRunning} @click=${this.csv}>${icon("export", 14)}${say(lang, "table")}</button></footer>`;
  }

  private legend(): TemplateResult {
    const scheme = this.app.tokens().dark ? "dark" : "light";
    return html`<span class="legend">${say(this.state.lang, "legend")}
      ${RAMP[scheme].map(
        (fill, i) => html`<b .style=${`--fill:${fill};--ink:${nth(INK[scheme], i)}`}>${i < 3 ? i + 1 : ">3"}</b>`,
      )}<b class="none" title=${say(this.state.lang, "outOfReach")}>✕</b></span>`;
  }

  private vehicles({ vehicle }: BayCheck): TemplateResult {
    const { lang } = this.state,
      choices = [
        { id: "own", title: say(lang, "own") },
        ...this.library.map(({ id, title }) => ({ id, title: title[lang] })),
      ];
    return html`<select aria-label=${say(lang, "vehicle")}
      @change=${(event: Event) => this.choose(valueOf(event))}>${choices.map(
        ({ id, title }) => html`<option value=${id} ?selected=${id === vehicle.id}>${title}</option>`,
      )}</select>`;
  }

  private entries(check: BayCheck): TemplateResult {
    const { lang } = this.state;
    return html`<select aria-label=${say(lang, "entry")}
      @change=${(event: Event) =>
        this.app.store.set({ bays: { ...check, entry: valueOf(event) as BayEntry } })}>${ENTRIES.map(
        (entry) =>
          html`<option value=${entry} ?selected=${entry === check.entry}>${say(lang, ENTRY_WORDS[entry])}</option>`,
      )}</select>`;
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
    return html`<th scope="col" aria-sort=${sorted}><button class="button"
      title=${say(lang, "sort", { column: heading(lang, column) })} @click=${() => {
        this.order = { column, descends: order.column === column && !order.descends };
      }}>${say(lang, column)}${
        sorted === "none" ? nothing : sorted === "ascending" ? " ↑" : " ↓"
      }${unit ? html`<small>${unit}</small>` : nothing}</button></th>`;
  }

  private line(line: BayLine, check: BayCheck): TemplateResult {
    const { index, bay, best, headIn, reverseIn } = line,
      { lang } = this.state;
    const name = `${index === check.lit ? "lit" : ""} ${check.stale.has(index) ? "stale" : ""}`,
      value = (number: number | null, digits: number): string => (number === null ? "–" : this.num(number, digits));
    return html`<tr class=${name} @click=${() => this.openPlan(line)} @pointerenter=${() => this.light(index, false)}>
      <th scope="row"><button class="button" title=${say(lang, "show", { bay })}
        @focus=${() => this.light(index, false)}>${bay}</button></th>
      <td>${this.moves(headIn)}</td><td>${this.moves(reverseIn)}</td>
      ${
        best.reachable
          ? [value(best.length, 1), value(best.driveTime, 0), value(best.clearance, 2)].map(
              (one) => html`<td>${one}</td>`,
            )
          : html`<td colspan="3" class="err">${reasonIn(lang, best.reason ?? "") || say(lang, "outOfReach")}</td>`
      }</tr>`;
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
