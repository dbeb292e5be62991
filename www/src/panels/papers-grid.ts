import type { Family, PaperClaim, PaperTable, PlannerId, Spread } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { workersHere, type Progress } from "../planning/worker-count";
import { Papers, type Summary } from "../planning/paper-grid-runs";
import { Helper, joined } from "../planning/job-client";
import { ensureIds } from "../scene/model";
import type { Scene } from "../store";
import { icon } from "../styles/icons";
import "./paper-picture";
import { claimList, claimStyles } from "./papers-claims";
import { figureName, lineName, papersMarkdown, READINGS, readingOf, SHOWN, titleOf } from "./papers-text";
import { PapersTab } from "./papers-tab";
import { say } from "./papers-messages";
import { valueOf } from "./inputs";

const RANGES = [20, 60, 200] as const;
const MOST = 200;
/** The scene of a row: figure 8 has regular maps, figure 9 random ones. */
const sceneOf = (row: string): string => `fig${row.startsWith("random") ? 9 : 8}-${row.split("-")[1]}`;

/** Measurements, kept while the page is open. */
let papers: Papers | null = null;
let last: Summary | null = null;

/** Tables 3 and 4 of the risk-field paper and the claims of the 16-neighbour paper. */
export class PapersGrid extends PapersTab<Summary> {
  static override properties = {
    ...PapersTab.properties,
    from: { state: true },
    to: { state: true },
    lost: { state: true },
  };
  static override styles = [
    PapersTab.styles,
    claimStyles,
    css`
    .range { display: flex; align-items: center; gap: 6px; color: var(--parkade-t2); }
    .field { width: 56px; color: var(--parkade-t1); }
    .bad { border-color: var(--parkade-err); }
    td.printed { border-left: 1px solid var(--parkade-hair); padding-left: 14px; }
    details { margin-top: 6px; }
    summary { cursor: pointer; color: var(--parkade-t2); font-size: 12px; line-height: 20px; }
  `,
  ];
  declare from: string;
  declare to: string;
  declare lost: Record<string, number[]>;

  constructor() {
    super();
    this.from = "1";
    this.to = "20";
    this.lost = {};
    this.summary = last;
  }

  leave(): void {
    papers?.stop();
  }

  protected get running(): boolean {
    return papers?.running ?? false;
  }

  protected override render(): TemplateResult {
    const { summary } = this;
    return this.frame(
      this.range(),
      summary ? html`${this.claims(summary.claims)}${summary.tables.map((table) => this.table(table))}` : nothing,
    );
  }

  protected told({ done, of }: Progress): string {
    return say(this.state.lang, "progress", { done, of, workers: workersHere() });
  }

  protected cancelled(done: number): string {
    return say(this.state.lang, "cancelled", { done });
  }

  protected override refusal(): string | null {
    return this.seeds ? null : say(this.state.lang, "badSeeds");
  }

  protected markdown(summary: Summary): string {
    return papersMarkdown(this.state.lang, summary, papers?.columns ?? []);
  }

  protected async work(): Promise<void> {
    const { seeds } = this;
    if (!seeds) return;
    papers ??= new Papers(await this.app.complete());
    const whole = await papers.measure(seeds, (progress, summary) => {
      this.progress = progress;
      if (summary) this.summary = last = summary;
    });
    if (whole) this.lost = await papers.incomplete(seeds);
  }

  private range(): TemplateResult {
    const { lang } = this.state,
      bad = !this.seeds;
    const field = (
      name: "from" | "to",
    ): TemplateResult => html`<span class="field ${bad ? "bad" : ""}"><input inputmode="numeric"
      aria-label=${say(lang, name)} aria-invalid=${bad} .value=${this[name]}
      @input=${(e: Event) => {
        this[name] = valueOf(e);
      }} @keydown=${(e: KeyboardEvent) => {
        if (e.key === "Enter") void this.measure();
      }}></span>`;
    return html`<span class="range">${say(lang, "seeds")} ${field("from")} – ${field("to")}</span>
      <div class="segmented" role="group" aria-label=${say(lang, "seeds")}>${RANGES.map(
        (n) => html`
        <button aria-pressed=${this.from === "1" && this.to === String(n)} @click=${() => {
          this.from = "1";
          this.to = String(n);
          void this.measure();
        }}>1–${n}</button>`,
      )}</div>
      ${this.button(bad)}`;
  }

  private claims(claims: readonly PaperClaim[]): TemplateResult {
    return html`${claimList(this.state.lang, claims)}
      ${crossOriginIsolated ? nothing : html`<p class="note">${say(this.state.lang, "coarse")}</p>`}`;
  }

  private heads(...keys: Parameters<typeof say>[1][]): TemplateResult[] {
    return keys.map((key) => html`<th>${say(this.state.lang, key)}</th>`);
  }

  private table(table: PaperTable): TemplateResult {
    const { lang } = this.state;
    const length = this.num(table.straight, 2);
    const scene = sceneOf(table.row.id);
    return html`<h3>${titleOf(lang, table)}<span>${say(lang, "maps", { n: table.maps })}</span>${this.link(
      scene,
      say(lang, "figureScene", { figure: scene.slice(3, 4) }),
    )}</h3>
      <div class="wide"><table><thead>
        <tr class="group-head"><th></th><th class="first" colspan="4"
          title=${say(lang, "nodesTip")}>${say(lang, "nodes")}</th><th class="first" colspan="4"
          title=${say(lang, "lengthTip")}>${say(lang, "length")}</th>
          <th class="first">${say(lang, "turns")}</th><th>${say(lang, "turning")}</th><th
            title=${say(lang, "timeTip")}>${say(lang, "time")}</th></tr>
        <tr><th>${say(lang, "planner")}</th>${[0, 1].map(
          () => html`<th class="first">${say(lang, "printed")}</th>${this.heads("median", "p95", "worst")}`,
        )}
          <th class="first">${say(lang, "median")}</th>${this.heads("median", "mean")}</tr></thead>
        <tbody>${table.lines.map(
          (line, at) => html`<tr><th scope="row">${lineName(lang, line.planner)}</th>
          <td class="printed">${line.printedNodes ?? "–"}</td>${this.spread(this.of(line, SHOWN.nodes), 0)}
            <td class="printed">${
              line.impossible
                ? html`<span class="chip err" title=${say(lang, "straight", {
                    length,
                  })}>${icon("warning", 12)}<span>${say(lang, "impossible", { length })}</span></span>`
                : nothing
            }${line.printedLength === null ? "–" : this.num(line.printedLength, 2)}</td>
          ${this.spread(this.of(line, SHOWN.length), 2)}
            <td class="first">${this.median(this.of(line, "turns"), 0)}</td><td>${this.median(
              this.of(line, "turnAngleDeg"),
              0,
            )}</td><td>${this.time(table, at)}</td></tr>`,
        )}</tbody></table></div>
      ${
        table.lines.some((line) => line.impossible)
          ? html`<p class="note">${say(lang, "straight", { length })}</p>`
          : nothing
      }
      ${this.readings(table)}${this.incomplete(table)}${
        this.running
          ? nothing
          : this.pictures(
              ["four", "eight", "risk-field"].map((planner) => [scene, planner as PlannerId]),
              true,
            )
      }
      <details><summary>${say(lang, "ratios")}</summary><div class="wide"><table><thead><tr>${this.heads(
        "ratio",
        "printed",
        "median",
        "p95",
        "worst",
      )}</tr></thead>
        <tbody>${table.ratios.map(
          (ratio) => html`<tr><th scope="row">${say(lang, "over", {
            planner: lineName(lang, ratio.planner),
            over: lineName(lang, ratio.over),
            figure: figureName(ratio),
          })}</th>
            <td class="printed">${
              ratio.printed === null ? "–" : this.num(ratio.printed, 3)
            }</td>${this.spread(ratio.ours, 3)}</tr>`,
        )}</tbody></table></div></details>`;
  }

  /** What the printed lengths may mean, side by side. */
  private readings({ lines }: PaperTable): TemplateResult {
    const { lang } = this.state;
    const columns = papers?.columns ?? [];
    return html`<details><summary>${say(lang, "readings")}</summary><div
      class="wide"><table><thead><tr><th>${say(lang, "planner")}</th><th>${say(lang, "printed")}</th>${READINGS.map(
        (name) => html`<th>${say(lang, name)}</th>`,
      )}</tr></thead>
      <tbody>${lines
        .filter(({ printedLength }) => printedLength !== null)
        .map(
          (
            line,
          ) => html`<tr><th scope="row">${lineName(lang, line.planner)}</th><td>${this.num(line.printedLength!, 2)}</td>
        ${READINGS.map((name) => {
          const cell = readingOf(lang, line, columns, name);
          return html`<td>${line.closest === name ? html`<b>${cell}</b>` : cell}</td>`;
        })}</tr>`,
        )}</tbody></table></div></details>`;
  }

  /** The maps on which the literal planner is incomplete, each to open. */
  private incomplete({ row: { id, size }, maps }: PaperTable): TemplateResult | typeof nothing {
    const { lang } = this.state,
      seeds = this.lost[id];
    if (!seeds || this.running) return nothing;
    const open = async (seed: number): Promise<void> => {
      const scene = await this.drawn({ family: id.startsWith("random") ? "random" : "regular", size, seed });
      this.closest("dialog")?.close();
      this.app.store.set({ planners: ["risk-field", "eight"], focus: "risk-field" });
      this.app.openScene({ ...scene, planners: { "risk-field": { fallback: "none" } } });
    };
    return html`<p class="note">${say(lang, "incomplete", { n: seeds.length, maps })}
      ${seeds.map(
        (seed) => html`<button class="link" @click=${() => void open(seed)}>${say(lang, "seed", { seed })}</button> `,
      )}</p>`;
  }

  private async drawn(family: Family): Promise<Scene> {
    const helper = new Helper(await this.app.complete());
    try {
      const answer = await helper.call("generate", family),
        [scene] = await joined(answer, answer.value);
      return ensureIds(scene!);
    } finally {
      helper.stop();
    }
  }

  private of(line: PaperTable["lines"][number], column: string): Spread | undefined {
    return line.figures[papers?.columns.indexOf(column) ?? -1];
  }

  private spread(spread: Spread | undefined, digits: number): TemplateResult {
    const cell = (value: number | undefined): string => (value === undefined ? "–" : this.num(value, digits));
    return html`<td
      class="ours">${cell(spread?.median)}</td><td>${cell(spread?.p95)}</td><td>${cell(spread?.worst)}</td>`;
  }

  private time({ row }: PaperTable, at: number): string {
    const time = this.summary?.times[row.id]?.[at];
    return time === undefined ? "–" : this.num(time, 2);
  }

  private median(spread: Spread | undefined, digits: number): string {
    return spread ? this.num(spread.median, digits) : "–";
  }

  /** Null where the fields hold no range. */
  private get seeds(): { from: number; to: number } | null {
    const from = Number(this.from),
      to = Number(this.to);
    const whole = [from, to].every((n) => Number.isInteger(n) && n >= 1 && n <= MOST);
    return whole && from <= to && this.from.trim() && this.to.trim() ? { from, to } : null;
  }
}

customElements.define("parkade-papers-grid", PapersGrid);
