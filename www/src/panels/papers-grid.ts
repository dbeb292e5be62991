import type { PaperClaim, PaperTable, Spread } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { reasonIn } from "../i18n/index";
import { workersHere, type Progress } from "../planning/crew";
import { Papers, type Summary } from "../planning/papers";
import { icon, type IconName } from "./icons";
import { figureName, lineName, papersMarkdown, SHOWN, titleOf } from "./papers-text";
import { PapersTab } from "./papers-tab";
import { say } from "./papers-words";

const RANGES = [20, 60, 200] as const;
const MOST = 200;
const VERDICT: Record<PaperClaim["holds"], { tone: string; icon: IconName }> = {
  yes: { tone: "", icon: "check" }, partly: { tone: "warn", icon: "warning" }, no: { tone: "err", icon: "close" }, unknown: { tone: "quiet", icon: "clock" },
};

/** What was measured stays while the page is open. */
let papers: Papers | null = null;
let last: Summary | null = null;

/** Tables 3 and 4 of the risk-field paper and the claims of the 16-neighbour paper. */
export class PapersGrid extends PapersTab<Summary> {
  static override properties = { ...PapersTab.properties, from: { state: true }, to: { state: true } };
  static override styles = [PapersTab.styles, css`
    .range { display: flex; align-items: center; gap: 6px; color: var(--parkade-t2); } .field { width: 56px; color: var(--parkade-t1); } .bad { border-color: var(--parkade-err); }
    td.printed { border-left: 1px solid var(--parkade-hair); padding-left: 14px; }
    .claims { list-style: none; margin: 0; padding: 0; font-size: 12.5px; line-height: 17px; } .claims li { display: grid; grid-template-columns: 130px 1fr; gap: 2px 12px; padding: 6px 0; border-top: 1px solid var(--parkade-hair); align-items: start; } .claims .chip { justify-self: start; }
    .claims p { margin: 2px 0 0; color: var(--parkade-t2); }
    details { margin-top: 6px; } summary { cursor: pointer; color: var(--parkade-t2); font-size: 12px; line-height: 20px; }
    @media (max-width: 640px) { .claims li { grid-template-columns: 1fr; } }
  `];
  declare from: string;
  declare to: string;

  constructor() {
    super();
    this.from = "1";
    this.to = "20";
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
    return this.frame(this.range(), summary ? html`${this.claims(summary.claims)}${summary.tables.map((table) => this.table(table))}` : nothing);
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
    await papers.measure(seeds, (progress, summary) => {
      this.progress = progress;
      if (summary) this.summary = last = summary;
    });
  }

  private range(): TemplateResult {
    const { lang } = this.state, bad = !this.seeds;
    const field = (name: "from" | "to"): TemplateResult => html`<span class="field ${bad ? "bad" : ""}"><input inputmode="numeric" aria-label=${say(lang, name)} aria-invalid=${bad} .value=${this[name]}
      @input=${(e: Event) => { this[name] = (e.target as HTMLInputElement).value; }} @keydown=${(e: KeyboardEvent) => { if (e.key === "Enter") void this.measure(); }}></span>`;
    return html`<span class="range">${say(lang, "seeds")} ${field("from")} – ${field("to")}</span>
      <div class="segmented" role="group" aria-label=${say(lang, "seeds")}>${RANGES.map((n) => html`
        <button aria-pressed=${this.from === "1" && this.to === String(n)} @click=${() => { this.from = "1"; this.to = String(n); void this.measure(); }}>1–${n}</button>`)}</div>
      ${this.button(bad)}`;
  }

  private claims(claims: readonly PaperClaim[]): TemplateResult {
    const { lang } = this.state;
    return html`<h3>${say(lang, "claims")}</h3><ul class="claims">${claims.map((claim) => this.claim(claim))}</ul>
      ${crossOriginIsolated ? nothing : html`<p class="note">${say(lang, "coarse")}</p>`}`;
  }

  private claim(claim: PaperClaim): TemplateResult {
    const { lang } = this.state, { tone, icon: name } = VERDICT[claim.holds];
    return html`<li id=${claim.id}><span class="chip ${tone}">${icon(name, 12)}<span>${say(lang, claim.holds)}</span></span><div>${reasonIn(lang, claim.text)}<p>${reasonIn(lang, claim.found)}</p></div></li>`;
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
}

customElements.define("parkade-papers-grid", PapersGrid);
