import type { ParkingTable } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import type { Values } from "../i18n/index";
import { icon } from "../styles/icons";
import "./paper-picture";
import { claimList, claimStyles, claimsMarkdown } from "./papers-claims";
import "./papers-volumes";
import {
  FIGURES,
  lineName,
  noteOf,
  parkingMarkdown,
  printedOf,
  reachText,
  savings,
  titleOf,
  type Figure,
} from "./papers-parking-text";
import { say } from "./papers-parking-messages";
import { Measured, PapersRowsTab } from "./papers-rows-tab";

const measured = new Measured("parking");

/** Scenes of figures that ask a row's question elsewhere. */
const figuresOf = (id: string): readonly string[] => (id === "P0" ? ["park-free", "park-fig13"] : []);

/** Tables 2 to 11 of the parking paper. */
export class PapersParking extends PapersRowsTab<"parking"> {
  static override styles = [
    PapersRowsTab.styles,
    claimStyles,
    css`
    .kept { display: inline-flex; vertical-align: -2px; margin-left: 6px; }
    .kept.missed { color: var(--parkade-err); }
    .kept svg { width: 12px; height: 12px; }
    td .chip { margin-right: 6px; } .saved { width: auto; }
  `,
  ];

  constructor() {
    super(measured);
  }

  protected say(key: "progress" | "cancelled", values: Values): string {
    return say(this.state.lang, key, values);
  }

  protected tables(tables: ParkingTable[]): TemplateResult {
    return html`${
      this.claims.length > 0 ? claimList(this.state.lang, this.claims) : nothing
    }${this.saved(tables)}${this.search(tables)}
      ${tables.map((table) => this.table(table))}${
        this.claims.length > 0
          ? html`<parkade-papers-volumes .app=${this.app}
            @parkade-open-scene=${(e: CustomEvent<{ id: string }>) =>
              this.openScene(e.detail.id)}></parkade-papers-volumes>`
          : nothing
      }`;
  }

  protected markdown(tables: ParkingTable[]): string {
    return [...claimsMarkdown(this.state.lang, this.claims), parkingMarkdown(this.state.lang, tables)].join("\n");
  }

  private table(table: ParkingTable): TemplateResult {
    const { lang } = this.state,
      note = noteOf(lang, table);
    return html`<h3 id=${table.row.id}>${titleOf(lang, table)}${this.link(table.row.id)}</h3>
      <div class="wide"><table><thead>
        <tr class="group-head"><th></th><th class="first" colspan="2">${say(lang, "printedHead")}</th><th class="first"
          colspan=${table.lines.length}>${say(lang, "oursHead")}</th></tr>
        <tr><th>${say(lang, "figure")}</th><th
          class="first">${say(lang, "traditional")}</th><th>${say(lang, "improved")}</th>
          ${table.lines.map(
            (line, at) => html`<th class=${at === 0 ? "first" : ""}>${lineName(lang, line)}</th>`,
          )}</tr></thead>
        <tbody>${FIGURES.map((figure) => this.figure(table, figure))}
          <tr><th scope="row">${say(lang, "verdict")}</th><td class="printed first">–</td><td
            class="printed">–</td>${table.lines.map(
              ({ verdict }, at) => html`
                <td class=${at === 0 ? "first" : ""}><span class="chip ${verdict === "ok" ? "" : "err"}">${icon(
                  verdict === "ok" ? "check" : "warning",
                  12,
                )}<span>${say(lang, verdict)}</span></span></td>`,
            )}</tr></tbody></table></div>
      ${note ? html`<p class="note">${note}</p>` : nothing}
      ${
        this.running
          ? nothing
          : this.pictures(
              [...figuresOf(table.row.id), table.row.id].flatMap(
                (scene) =>
                  [
                    [scene, "hybrid-classic"],
                    [scene, "hybrid"],
                  ] as const,
              ),
            )
      }`;
  }

  /** How much each end has to search. */
  private search(tables: readonly ParkingTable[]): TemplateResult | typeof nothing {
    const { lang } = this.state,
      [forward, reverse] = ["hybrid-forward", "hybrid"] as const;
    if (tables.length < 10) return nothing;
    return html`<h3>${say(lang, "searched")}</h3><div class="wide"><table
      class="saved"><thead><tr><th>${say(lang, "rows")}</th>${[forward, reverse].map(
        (planner) => html`<th>${say(lang, "expanded")}, ${say(lang, planner)}</th>`,
      )}<th>${say(lang, "share")}</th>${[forward, reverse].map(
        (planner) => html`<th>${say(lang, "milliseconds")}, ${say(lang, planner)}</th>`,
      )}</tr></thead>
      <tbody>${tables.map(
        ({ row: { id }, lines: [before, after] }) =>
          html`<tr><th scope="row">${this.link(id, id)}</th><td>${this.num(
            before!.expanded,
            0,
          )}</td><td class="ours">${this.num(after!.expanded, 0)}</td><td>${this.num(
            (100 * after!.expanded) / before!.expanded,
            1,
          )} %</td><td>${this.num(
            before!.milliseconds,
            1,
          )}</td><td class="ours">${this.num(after!.milliseconds, 1)}</td></tr>`,
      )}</tbody></table></div>`;
  }

  private figure(table: ParkingTable, figure: Figure): TemplateResult {
    const { lang } = this.state,
      printed = printedOf(table, figure),
      bound = this.num(table.bound, 2);
    const cell = (at: 0 | 1): TemplateResult =>
      html`<td class="printed ${at === 0 ? "first" : ""}">${
        figure.key === "length" && table.impossible[at]
          ? html`<span class="chip err" title=${say(lang, "bound", { bound })}>${icon("warning", 12)}<span>${say(
              lang,
              "impossible",
              { bound },
            )}</span></span>`
          : nothing
      }${printed ? this.num(printed[at], figure.digits) : "–"}</td>`;
    const reach = reachText(lang, table);
    const mark = html`<span class="kept ${table.kept ? "" : "missed"}" role="img" title=${reach}
      aria-label=${reach}>${icon(table.kept ? "check" : "close", 12)}</span>`;
    return html`<tr><th scope="row">${say(lang, figure.key)}</th>${cell(0)}${cell(1)}
      ${table.lines.map(
        (line, at) =>
          html`<td class=${at === 0 ? "first" : at === 1 ? "ours" : ""}>${this.num(line[figure.key], figure.digits)}${
            at === 1 && figure.key === "exact" ? mark : nothing
          }</td>`,
      )}</tr>`;
  }

  private saved(tables: readonly ParkingTable[]): TemplateResult | typeof nothing {
    const { lang } = this.state,
      lines = savings(tables);
    if (lines.length === 0) return nothing;
    const percent = (value: number): string => `${this.num(value, 2)} %`;
    return html`<h3>${say(lang, "saved")}</h3><div class="wide"><table
      class="saved"><thead><tr>${(["rows", "abstract", "ofRows", "ours", "overClassic"] as const).map(
        (key) => html`<th>${say(lang, key)}</th>`,
      )}</tr></thead>
      <tbody>${lines.map(
        ({ rows, said, printed, ours, classic }) =>
          html`<tr><th scope="row">${rows}</th><td class="printed">${percent(said)}</td><td
            class="printed">${percent(printed)}</td><td class="ours">${percent(ours)}</td><td
            class="ours">${percent(classic)}</td></tr>`,
      )}</tbody></table></div>
      <p class="note">${say(lang, "sameNote")}</p>`;
  }
}

customElements.define("parkade-papers-parking", PapersParking);
