import type { PaperClaim, PaperTable, Spread } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { sentence } from "../element/app";
import { Papers, workersHere, type Progress, type Summary } from "../planning/papers";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { AppElement } from "./base";
import { icon, type IconName } from "./icons";
import { figureName, lineName, papersMarkdown, SHOWN, titleOf } from "./papers-text";
import { say } from "./papers-words";

const RANGES = [20, 60, 200] as const;
const MOST = 200;
const VERDICT: Record<PaperClaim["holds"], { tone: string; icon: IconName }> = {
  yes: { tone: "", icon: "check" }, partly: { tone: "warn", icon: "warning" }, no: { tone: "err", icon: "close" }, unknown: { tone: "quiet", icon: "clock" },
};

/** What was measured stays while the page is open. */
let papers: Papers | null = null;
let last: Summary | null = null;

/** The papers' printed values beside ours, measured while one looks on. */
export class PapersDialog extends AppElement {
  static override properties = {
    ...AppElement.properties, shown: { state: true }, from: { state: true }, to: { state: true }, progress: { state: true }, summary: { state: true }, notice: { state: true }, copied: { state: true },
  };
  static override styles = [controls, dialogs, css`
    dialog { --dialog-width: 1240px; height: 94vh; height: 94dvh; max-height: 94vh; max-height: 94dvh; }
    .top p { min-width: 0; }
    .tools { display: flex; align-items: center; flex-wrap: wrap; gap: 8px 12px; padding: 0 24px 12px; border-bottom: 1px solid var(--parkade-hair); }
    .range { display: flex; align-items: center; gap: 6px; color: var(--parkade-t2); } .field { width: 56px; color: var(--parkade-t1); } .bad { border-color: var(--parkade-err); }
    .state { display: flex; align-items: center; gap: 8px; color: var(--parkade-t2); min-width: 0; }
    progress { appearance: none; width: 140px; height: 4px; border: 0; border-radius: 2px; background: var(--parkade-hair2); overflow: hidden; }
    progress::-webkit-progress-bar { background: var(--parkade-hair2); } progress::-webkit-progress-value { background: var(--parkade-t1); } progress::-moz-progress-bar { background: var(--parkade-t1); }
    .copy { margin-left: auto; display: flex; gap: 4px; }
    .scroll { flex: 1; padding-top: 14px; } h3 { margin: 18px 0 6px; font: inherit; font-weight: 600; display: flex; gap: 8px; align-items: baseline; flex-wrap: wrap; } h3:first-child { margin-top: 0; } h3 span { font-weight: 400; color: var(--parkade-t2); }
    .wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 12px; line-height: 16px; width: 100%; }
    th, td { text-align: right; padding: 5px 8px; white-space: nowrap; font-weight: 400; } th:first-child, td:first-child { text-align: left; padding-left: 0; }
    thead th { color: var(--parkade-t2); } thead .over th { color: var(--parkade-t1); font-weight: 500; padding-bottom: 0; text-align: left; } tbody tr { border-top: 1px solid var(--parkade-hair); }
    tbody th { font-weight: 500; } .printed { border-left: 1px solid var(--parkade-hair); padding-left: 14px; color: var(--parkade-t2); } .first { border-left: 1px solid var(--parkade-hair); padding-left: 14px; } .ours { font-weight: 600; }
    td .chip { margin-right: 8px; vertical-align: middle; }
    .claims { list-style: none; margin: 0; padding: 0; font-size: 12.5px; line-height: 17px; } .claims li { display: grid; grid-template-columns: 130px 1fr; gap: 2px 12px; padding: 6px 0; border-top: 1px solid var(--parkade-hair); align-items: start; } .claims .chip { justify-self: start; }
    .claims p { margin: 2px 0 0; color: var(--parkade-t2); } .note { margin: 4px 0 0; color: var(--parkade-t2); font-size: 12px; line-height: 16px; }
    details { margin-top: 6px; } summary { cursor: pointer; color: var(--parkade-t2); font-size: 12px; line-height: 20px; }
    @media (max-width: 640px) { .tools { padding: 0 16px 10px; } .copy { margin-left: 0; } .claims li { grid-template-columns: 1fr; } th:first-child { position: sticky; left: 0; background: var(--parkade-raise); padding-right: 12px; } }
  `];
  declare shown: boolean;
  declare from: string;
  declare to: string;
  declare progress: Progress | null;
  declare summary: Summary | null;
  declare notice: { tone: "err" | ""; text: string } | null;
  declare copied: "markdown" | "json" | null;

  constructor() {
    super();
    this.shown = false;
    this.from = "1";
    this.to = "20";
    this.progress = null;
    this.summary = last;
    this.notice = null;
    this.copied = null;
  }

  protected watches(): readonly (keyof State)[] {
    return [];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    papers?.stop();
  }

  open(): void {
    this.shown = true;
    void this.updateComplete.then(() => this.dialog?.showModal());
    if (!this.summary) void this.measure();
  }

  protected override render(): TemplateResult {
    return html`<dialog aria-labelledby="title" @close=${this.closed} @click=${(e: Event) => { if (e.target === this.dialog) this.dialog?.close(); }}>${this.shown ? this.content() : nothing}</dialog>`;
  }

  private content(): TemplateResult {
    const { lang } = this.state;
    return html`<div class="top"><h2 id="title">${say(lang, "title")}</h2><p>${say(lang, "lead")}</p>
        <button class="icon" aria-label=${say(lang, "close")} @click=${() => this.dialog?.close()}>${icon("close")}</button></div>
      <div class="tools">${this.range()}${this.progressBar()}
        <span class="copy">${(["markdown", "json"] as const).map((one) => html`<button class="button outline" ?disabled=${!this.summary} @click=${() => void this.copy(one)}>${icon(this.copied === one ? "check" : "copy", 14)}${say(lang, this.copied === one ? "copied" : one)}</button>`)}</span></div>
      <div class="scroll" tabindex="0">${this.summary ? html`${this.claims(this.summary.claims)}${this.summary.tables.map((table) => this.table(table))}` : html`<p class="note">${say(lang, "waiting")}</p>`}</div>`;
  }

  private range(): TemplateResult {
    const { lang } = this.state, bad = !this.seeds;
    const field = (name: "from" | "to"): TemplateResult => html`<span class="field ${bad ? "bad" : ""}"><input inputmode="numeric" aria-label=${say(lang, name)} aria-invalid=${bad} .value=${this[name]}
      @input=${(e: Event) => { this[name] = (e.target as HTMLInputElement).value; }} @keydown=${(e: KeyboardEvent) => { if (e.key === "Enter") void this.measure(); }}></span>`;
    return html`<span class="range">${say(lang, "seeds")} ${field("from")} – ${field("to")}</span>
      <div class="segmented" role="group" aria-label=${say(lang, "seeds")}>${RANGES.map((n) => html`
        <button aria-pressed=${this.from === "1" && this.to === String(n)} @click=${() => { this.from = "1"; this.to = String(n); void this.measure(); }}>1–${n}</button>`)}</div>
      ${this.running ? html`<button class="button outline" @click=${this.cancel}>${icon("close", 14)}${say(lang, "cancel")}</button>`
        : html`<button class="button solid" ?disabled=${bad} @click=${() => void this.measure()}>${say(lang, "measure")}</button>`}`;
  }

  private progressBar(): TemplateResult {
    const { lang } = this.state, { progress, notice } = this;
    if (!this.seeds) return html`<span class="state" role="alert">${icon("warning", 14)}${say(lang, "badSeeds")}</span>`;
    if (notice) return html`<span class="state" role="alert">${notice.text}</span>`;
    if (!progress || !this.running) return html``;
    const text = say(lang, "progress", { done: progress.done, of: progress.of, workers: workersHere() });
    return html`<span class="state"><progress max=${progress.of} .value=${progress.done} aria-label=${text}></progress><span>${text}</span></span>`;
  }

  private claims(claims: readonly PaperClaim[]): TemplateResult {
    const { lang } = this.state;
    return html`<h3>${say(lang, "claims")}</h3><ul class="claims">${claims.map(({ id, text, found, holds }) => html`
      <li id=${id}><span class="chip ${VERDICT[holds].tone}">${icon(VERDICT[holds].icon, 12)}<span>${say(lang, holds)}</span></span><div>${text}<p>${found}</p></div></li>`)}</ul>
      ${crossOriginIsolated ? nothing : html`<p class="note">${say(lang, "coarse")}</p>`}`;
  }

  private table(table: PaperTable): TemplateResult {
    const { lang } = this.state;
    const length = this.num(table.straight, 2);
    return html`<h3>${titleOf(lang, table)}<span>${say(lang, "maps", { n: table.maps })}</span></h3>
      <div class="wide"><table><thead>
        <tr class="over"><th></th><th class="first" colspan="4" title=${say(lang, "nodesTip")}>${say(lang, "nodes")}</th><th class="first" colspan="4" title=${say(lang, "lengthTip")}>${say(lang, "length")}</th>
          <th class="first">${say(lang, "turns")}</th><th>${say(lang, "turning")}</th><th title=${say(lang, "timeTip")}>${say(lang, "time")}</th></tr>
        <tr><th>${say(lang, "planner")}</th>${[0, 1].map(() => html`<th class="first">${say(lang, "printed")}</th><th>${say(lang, "median")}</th><th>${say(lang, "p95")}</th><th>${say(lang, "worst")}</th>`)}
          <th class="first">${say(lang, "median")}</th><th>${say(lang, "median")}</th><th>${say(lang, "mean")}</th></tr></thead>
        <tbody>${table.lines.map((line, at) => html`<tr><th scope="row">${lineName(lang, line.planner)}</th>
          <td class="printed">${line.printedNodes ?? "–"}</td>${this.spread(this.of(line, SHOWN.nodes), 0)}
          <td class="printed">${line.impossible ? html`<span class="chip err" title=${say(lang, "straight", { length })}>${icon("warning", 12)}<span>${say(lang, "impossible", { length })}</span></span>` : nothing}${line.printedLength === null ? "–" : this.num(line.printedLength, 2)}</td>
          ${this.spread(this.of(line, SHOWN.length), 2)}
          <td class="first">${this.median(this.of(line, "turns"), 0)}</td><td>${this.median(this.of(line, "turnAngleDeg"), 0)}</td><td>${this.time(table, at)}</td></tr>`)}</tbody></table></div>
      ${table.lines.some((line) => line.impossible) ? html`<p class="note">${say(lang, "straight", { length })}</p>` : nothing}
      <details><summary>${say(lang, "ratios")}</summary><div class="wide"><table><thead><tr><th>${say(lang, "ratio")}</th><th>${say(lang, "printed")}</th><th>${say(lang, "median")}</th><th>${say(lang, "p95")}</th><th>${say(lang, "worst")}</th></tr></thead>
        <tbody>${table.ratios.map((ratio) => html`<tr><th scope="row">${say(lang, "over", { planner: lineName(lang, ratio.planner), over: lineName(lang, ratio.over), figure: figureName(ratio) })}</th>
          <td class="printed">${ratio.printed === null ? "–" : this.num(ratio.printed, 3)}</td>${this.spread(ratio.ours, 3)}</tr>`)}</tbody></table></div></details>`;
  }

  private of(line: PaperTable["lines"][number], column: string): Spread | undefined {
    return line.figures[papers?.columns.indexOf(column) ?? -1];
  }

  private spread(spread: Spread | undefined, digits: number): TemplateResult {
    const cell = (value: number | undefined): string => (value === undefined ? "–" : this.num(value, digits));
    return html`<td class="ours">${cell(spread?.median)}</td><td>${cell(spread?.p95)}</td><td>${cell(spread?.worst)}</td>`;
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
    const from = Number(this.from), to = Number(this.to);
    const whole = [from, to].every((n) => Number.isInteger(n) && n >= 1 && n <= MOST);
    return whole && from <= to && this.from.trim() && this.to.trim() ? { from, to } : null;
  }

  private get running(): boolean {
    return papers?.running ?? false;
  }

  private async measure(): Promise<void> {
    const { seeds } = this;
    if (!seeds) return;
    this.notice = null;
    this.progress = null;
    try {
      papers ??= new Papers(await this.app.complete());
      await papers.measure(seeds, (progress, summary) => {
        this.progress = progress;
        if (summary) this.summary = last = summary;
      });
    } catch (error) {
      this.notice = { tone: "err", text: say(this.state.lang, "failed", { reason: sentence(error) }) };
    }
    this.requestUpdate();
  }

  private readonly cancel = (): void => {
    papers?.stop();
    this.notice = { tone: "", text: say(this.state.lang, "cancelled", { done: this.progress?.done ?? 0 }) };
  };

  private readonly closed = (): void => {
    this.shown = false;
    papers?.stop();
  };

  private async copy(format: "markdown" | "json"): Promise<void> {
    if (!this.summary || !papers) return;
    const text = format === "json" ? JSON.stringify(this.summary, null, 2) : papersMarkdown(this.state.lang, this.summary, papers.columns);
    if (!(await this.app.copy(text))) return;
    this.copied = format;
    setTimeout(() => { this.copied = null; }, 2000);
  }

  private get dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector("dialog");
  }
}

customElements.define("parkade-papers", PapersDialog);
