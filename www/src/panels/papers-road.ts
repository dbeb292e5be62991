import type { RoadTable } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import type { Values } from "../i18n/index";
import { icon } from "../styles/icons";
import "./paper-picture";
import { claimList, claimStyles, claimsMarkdown } from "./papers-claims";
import {
  cell,
  change,
  changeOf,
  FIGURES,
  flagOf,
  lineName,
  printedOf,
  promiseOf,
  promiseText,
  roadMarkdown,
  titleOf,
  type Figure,
} from "./papers-road-text";
import { FLAGS, say } from "./papers-road-messages";
import { Measured, PapersRowsTab } from "./papers-rows-tab";

const measured = new Measured("road");

/** Section 4 of the road manuscript. */
export class PapersRoad extends PapersRowsTab<"road"> {
  static override styles = [
    PapersRowsTab.styles,
    claimStyles,
    css`
    td small, th small { font-size: inherit; color: var(--parkade-t2); font-weight: 400; margin-left: 6px; }
    small:empty { display: none; }
    .kept { display: inline-flex; vertical-align: -2px; margin-left: 6px; }
    .kept.missed { color: var(--parkade-err); }
    .kept svg { width: 12px; height: 12px; }
    .flags { margin: 6px 0 0; padding-left: 18px; font-size: 12.5px; line-height: 17px; color: var(--parkade-t2); }
    .flags li { padding: 3px 0; }
    td .chip { margin-right: 0; }
  `,
  ];

  constructor() {
    super(measured);
  }

  protected say(key: "progress" | "cancelled", values: Values): string {
    return say(this.state.lang, key, values);
  }

  protected tables(tables: RoadTable[]): TemplateResult {
    const { lang } = this.state;
    return html`${
      this.claims.length > 0 ? claimList(lang, this.claims) : nothing
    }${tables.map((table) => this.table(table))}
      <h3>${say(lang, "flags")}</h3><ul class="flags">${FLAGS.map((flag) => html`<li>${say(lang, flag)}</li>`)}</ul>`;
  }

  protected markdown(tables: RoadTable[]): string {
    return [...claimsMarkdown(this.state.lang, this.claims), roadMarkdown(this.state.lang, tables)].join("\n");
  }

  private table(table: RoadTable): TemplateResult {
    const { lang } = this.state;
    return html`<h3 id=${table.row.id}>${titleOf(lang, table)}${this.link(table.row.scene)}</h3>
      <div class="wide"><table><thead>
        <tr class="group-head"><th></th><th class="first" colspan="2">${say(lang, "printedHead")}</th><th class="first"
          colspan=${table.lines.length}>${say(lang, "oursHead")}</th></tr>
        <tr><th>${say(lang, "figure")}</th><th class="first">${say(lang, "plain")}</th><th>${say(lang, "improved")}</th>
          ${table.lines.map(
            (line, at) => html`<th class=${at === 0 ? "first" : ""}>${lineName(lang, line)}</th>`,
          )}</tr></thead>
        <tbody>${FIGURES.map((figure) => this.figure(table, figure))}
          <tr><th scope="row">${say(lang, "verdict")}</th><td class="printed first">–</td><td
            class="printed">–</td>${table.lines.map(
              (line, at) => html`
                <td class=${at === 0 ? "first" : ""}><span class="chip ${
                  line.verdict === "ok" ? "" : line.verdict === "collides" || line.verdict === "none" ? "err" : "warn"
                }">${icon(line.verdict === "ok" ? "check" : "warning", 12)}<span>${say(
                  lang,
                  line.verdict,
                )}</span></span>${
                  line.fellBack
                    ? html` <small title=${say(lang, "fellBackTip")}>${say(lang, "fellBack")}</small>`
                    : nothing
                }</td>`,
            )}</tr></tbody></table></div>
      ${
        table.lines.some(({ id, verdict }) => id === "literal" && verdict === "collides")
          ? html`<p class="note">${say(lang, "literalNote")}</p>`
          : nothing
      }
      ${
        this.running
          ? nothing
          : this.pictures(
              (["eight", "cost-map"] as const).map((planner) => [table.row.scene, planner]),
              true,
            )
      }`;
  }

  private figure(table: RoadTable, figure: Figure): TemplateResult {
    const { lang } = this.state,
      printed = printedOf(table, figure),
      flag = flagOf(lang, table, figure),
      promise = promiseOf(table, figure);
    const was = (value: number | undefined): string =>
      value === undefined ? "–" : this.num(value, Number.isInteger(value) ? 0 : 1);
    const mark = promise
      ? html`<span class="kept ${promise.kept ? "" : "missed"}" role="img" title=${promiseText(lang, figure, promise)}
        aria-label=${promiseText(lang, figure, promise)}>${icon(promise.kept ? "check" : "close", 12)}</span>`
      : nothing;
    return html`<tr><th scope="row" title=${figure.tip ? say(lang, figure.tip) : nothing}>${say(lang, figure.key)}</th>
      <td class="printed first">${
        flag
          ? html`<span class="chip err"
            title=${flag}>${icon("warning", 12)}<span>${say(lang, "impossible")}</span></span> `
          : nothing
      }${was(printed?.[0])}</td>
      <td class="printed">${was(printed?.[1])}${
        printed ? html`<small>${change(lang, printed[1], printed[0])}</small>` : nothing
      }</td>
      ${table.lines.map(
        (line, at) =>
          html`<td class=${at === 0 ? "first" : at === 1 ? "ours" : ""}>${cell(lang, figure, line, table)}${
            at > 0 ? html`<small>${changeOf(lang, figure, line, table)}</small>` : nothing
          }${at === 1 ? mark : nothing}</td>`,
      )}</tr>`;
  }
}

customElements.define("parkade-papers-road", PapersRoad);
