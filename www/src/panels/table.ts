import { css, html, nothing, type TemplateResult } from "lit";
import "../i18n/later";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { shortName } from "../styles/planner-style";
import { icon, marker } from "../styles/icons";
import { Menus } from "./popover-controller";
import { BENCH_RUNS, COLUMNS, rowsOf, unitValues, type Column, type Row } from "./metrics";
import type { TableFormat } from "./table-format";
import type { On } from "./inputs";

const SMALL: readonly Column[] = ["length", "gears", "clearance", "plan"];
/** Percent: as wide as their usual contents, so that no column moves when answers come. */
const WIDTHS = [14, 16.4, 6.9, 5.9, 7, 8.6, 7.5, 6.9, 8.1, 5, 7.1, 6.6],
  SMALL_WIDTHS = [21.5, 18, 17, 11, 13.3, 19.2];

/** The planners' numbers side by side, the best drivable ones starred. */
export class MetricsTable extends AppElement {
  static override properties = {
    ...AppElement.properties,
    compact: { type: Boolean, reflect: true },
    copied: { state: true },
    benching: { state: true },
  };
  static override styles = [
    controls,
    css`
    :host {
      display: grid; grid-template: minmax(0, 1fr) auto / minmax(0, 1fr); min-width: 0; min-height: 0;
      background: var(--parkade-panel); font-size: 12px; line-height: 16px; container-type: inline-size;
    }
    .scroll { overflow: auto; min-height: 0; }
    table { border-collapse: collapse; width: 100%; }
    th, td { padding: 0 8px; text-align: right; white-space: nowrap; font-weight: 400; }
    th:first-child, td:first-child { padding-left: 14px; }
    th:nth-child(-n+2), tbody th, td:nth-child(2) { text-align: left; }
    thead th { height: 34px; color: var(--parkade-t2); vertical-align: middle; line-height: 14px; cursor: help; }
    thead th:nth-child(-n+2) { cursor: default; }
    thead small { display: block; font-size: 12px; line-height: 14px; color: var(--parkade-t3); }
    tbody tr { height: 33px; border-top: 1px solid var(--parkade-hair); cursor: pointer; position: relative; }
    tbody tr:hover td, tbody tr:hover th { text-decoration: none; }
    tbody tr.chosen th { box-shadow: inset 2px 0 0 var(--parkade-t1); }
    tbody th button { font-weight: 600; gap: 8px; height: 28px; }
    .grey, .grey th button { color: var(--parkade-t3); }
    td.err { color: var(--parkade-err); }
    td.warn { color: var(--parkade-t1); }
    td.best { font-weight: 650; color: var(--parkade-t1); }
    .star { font-size: 10px; line-height: 0; margin-right: 3px; }
    footer {
      display: flex; align-items: center; gap: 14px; height: 34px; padding: 0 14px;
      border-top: 1px solid var(--parkade-hair); color: var(--parkade-t2);
    }
    footer > span:first-child { flex: 1; min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
    footer .end { display: flex; gap: 4px; flex: none; position: relative; }
    footer .button { height: 26px; font-size: 12px; min-height: 0; color: var(--parkade-t1); }
    .popover { min-width: 150px; font-size: 13px; line-height: 18px; }
    @container (max-width: 960px) { th, td { padding: 0 5px; } }
    :host([compact]) tbody tr { height: 29px; }
    :host([compact]) thead th { height: 26px; }
    :host([compact]) th, :host([compact]) td { padding: 0 4px; }
    :host([compact]) th:first-child { padding-left: 12px; }
    :host([compact]) td:last-child, :host([compact]) th:last-child { padding-right: 12px; }
    :host([compact]) thead small { display: inline; }
    :host([compact]) tbody th button { min-height: 0; }
    @media (pointer: coarse) { tbody th button { min-height: 0; } }
  `,
  ];
  declare compact: boolean;
  declare copied: boolean;
  declare benching: boolean;
  protected override redrawMs = 100;
  protected override waits = true;
  private readonly menus = new Menus<"copy">(this);

  constructor() {
    super();
    this.compact = this.copied = this.benching = false;
  }

  protected watches(): readonly (keyof State)[] {
    return ["results", "planners", "hidden", "focus"];
  }

  protected override render(): unknown {
    const rows = rowsOf(this.state);
    const columns = this.compact ? SMALL : COLUMNS;
    return html`<div class="scroll" tabindex="0" role="region" aria-label=${this.t("table.label")}><table>
        <caption class="visually-hidden">${this.t("table.label")}</caption>
        <colgroup>${(this.compact ? SMALL_WIDTHS : WIDTHS).map(
          (width) => html`<col .style=${`width:${width}%`}>`,
        )}</colgroup>
        <thead><tr><th scope="col">${this.t("table.planner")}</th><th
          scope="col">${this.t("table.status")}</th>${columns.map((column) => this.head(column))}</tr></thead>
        <tbody>${rows.map((row) => this.row(row, columns))}</tbody>
      </table></div>
      ${this.compact ? nothing : this.footer()}`;
  }

  private head(column: Column): TemplateResult {
    const unit = this.t(`unit.${column}`, unitValues(this.state));
    const small = this.compact && (column === "gears" || column === "clearance");
    const name = small ? this.t(`short.${column as "gears" | "clearance"}`) : this.t(`table.${column}`);
    const units: Partial<Record<Column, string>> = { length: "m", gears: "", clearance: "m", plan: "ms" };
    return html`<th scope="col" title=${this.t(`tip.${column}`)}>${name}
      <small .textContent=${this.compact ? (units[column] ?? "") : unit}></small></th>`;
  }

  private row(row: Row, columns: readonly Column[]): TemplateResult {
    const { focus } = this.state;
    const tone = row.status.tone === "err" ? "err" : "";
    return html`<tr data-planner=${row.planner} class="${
      row.planner === focus ? "chosen" : ""
    } ${row.drivable ? "" : "grey"}" @click=${() => this.app.store.set({ focus: row.planner })}>
      <th scope="row"><button aria-pressed=${row.planner === focus}>${marker(row.planner)}${
        this.compact ? shortName(this.state.lang, row.planner) : row.name
      }</button></th>
      ${
        row.hidden
          ? html`<td></td>${columns.map(() => html`<td></td>`)}`
          : html`
        <td class=${tone}>${this.compact ? row.status.tiny : row.status.brief}</td>
        ${columns.map((column) => {
          const { text, best, title } = row.cells[column];
          return html`<td class=${best ? "best" : ""}
            title=${title || nothing}>${
              best
                ? html`<span class="star" aria-hidden="true">★</span><span
                    class="visually-hidden">${this.t("table.best")} </span>`
                : nothing
            }<span .textContent=${text}></span></td>`;
        })}`
      }
    </tr>`;
  }

  private footer(): TemplateResult {
    return html`<footer><span title=${this.t("table.rule")}>★ ${this.t("table.rule")}</span>${this.hash()}
      <span class="end">
        <button class="button" popovertarget="copy" aria-expanded=${this.menus.open === "copy"}
          @click=${(e: On<HTMLElement>) => this.menus.toggle("copy", e.currentTarget)}>
          ${icon(this.copied ? "check" : "copy", 14)}${this.t(
            this.copied ? "table.copied" : "table.copy",
          )}${icon("down", 14)}</button>
        ${
          this.menus.open === "copy"
            ? html`<div class="popover right" id="copy" popover>${(["markdown", "csv", "json"] as const).map(
                (format) => html`
          <button class="item" @click=${() => void this.copy(format)}>${this.t(`table.${format}`)}</button>`,
              )}</div>`
            : nothing
        }
        <button class="button" ?disabled=${this.benching}
          @click=${this.bench}>${this.t(this.benching ? "table.benching" : "table.bench")}</button>
      </span></footer>`;
  }

  /** The focused plan's hash, which is the same on every platform. */
  private hash(): TemplateResult | typeof nothing {
    const hash = this.state.results[this.state.focus]?.plan?.hash;
    return hash
      ? html`<button class="button hash" title="${this.t("table.hash")} ${hash}"
        @click=${() => void this.app.copy(hash)}>${marker(this.state.focus, 9)}${this.t("table.hashName")}
        ${hash.slice(0, 8)}</button>`
      : nothing;
  }

  private async copy(format: TableFormat): Promise<void> {
    this.menus.close();
    const { formatTable } = await import("./table-format");
    this.copied = await this.app.copy(formatTable(this.state, format));
    if (this.copied)
      setTimeout(() => {
        this.copied = false;
      }, 2000);
  }

  private readonly bench = async (): Promise<void> => {
    this.benching = true;
    // Planners that are still to be replaced by the complete module's would end it early.
    await this.app.complete().catch(() => undefined);
    await this.app.planning?.whenSettled();
    await this.app.planning?.measure(BENCH_RUNS);
    this.benching = false;
  };
}

customElements.define("parkade-table", MetricsTable);
