/**
 * Figures 4 and 5 of the parking paper: volumes around the car, turned by hand, and what they answer on poses at
 * random.
 */
import type { VolumeComparison } from "parkade";
import { css, html, svg, type TemplateResult } from "lit";
import messages from "../i18n/messages/papers-volumes.json";
import { translator } from "../i18n/translator";
import { Helper } from "../planning/job-client";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { numberOf } from "./inputs";

const say = translator("papersVolumes", messages);
const POSES = 20_000,
  SCENES = ["P0", "park-fig13", "reverse-in"] as const;
/** The paper's car: half its length, half its width, metres. */
const HALF = [2.75, 1.3] as const,
  RADIUS = Math.hypot(...HALF);

let measured: VolumeComparison[] | null = null;

export class PapersVolumes extends AppElement {
  static override properties = { ...AppElement.properties, heading: { state: true } };
  static override styles = [
    controls,
    css`
    :host { display: block; }
    h3 { margin: 18px 0 6px; font: inherit; font-weight: 600; }
    p { margin: 0 0 6px; color: var(--parkade-t2); font-size: 12px; line-height: 16px; }
    .both { display: flex; flex-wrap: wrap; gap: 12px 24px; align-items: flex-start; }
    svg.car { width: 220px; height: 220px; flex: none; }
    label { display: grid; gap: 4px; width: 220px; font-size: 12px; }
    .wide { overflow-x: auto; flex: 1; min-width: 0; }
    table { border-collapse: collapse; font-size: 12px; line-height: 16px; }
    th, td { text-align: right; padding: 5px 8px; white-space: nowrap; font-weight: 400; }
    th:first-child, th:nth-child(2) { text-align: left; }
    .link {
      border: 0; background: none; padding: 0; min-height: 24px; font: inherit; color: var(--parkade-accent);
      cursor: pointer; text-decoration: underline;
    }
    thead th { color: var(--parkade-t2); }
    tbody tr { border-top: 1px solid var(--parkade-hair); }
  `,
  ];
  declare heading: number;

  constructor() {
    super();
    this.heading = 25;
  }

  protected watches(): readonly (keyof State)[] {
    return [];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void this.measure();
  }

  private async measure(): Promise<void> {
    if (measured) return;
    const helper = new Helper(await this.app.complete()),
      found: VolumeComparison[] = [];
    try {
      for (const scene of SCENES) found.push(await helper.call("volumes", { scene, poses: POSES, rounds: 3 }));
      measured = found;
    } finally {
      helper.stop();
    }
    this.requestUpdate();
  }

  protected override render(): TemplateResult {
    const { lang } = this.state;
    return html`<h3>${say(lang, "title")}</h3><p>${say(lang, "lead", {
      poses: this.num(POSES, 0),
    })}</p><div class="both">
      <div>${this.picture()}<label>${say(lang, "heading")}: ${this.heading}°<input class="slider" type="range" min="0"
        max="90" step="1" .value=${String(this.heading)} @input=${(e: Event) => {
          this.heading = numberOf(e);
        }}></label></div>
      <div class="wide"><table><thead><tr>${(
        ["scene", "volume", "collisions", "hits", "falseAlarms", "share", "missed", "area", "micros"] as const
      ).map((key) => html`<th>${say(lang, key)}</th>`)}</tr></thead>
        <tbody>${(measured ?? []).flatMap(({ scene, collisions, poses, volumes }) =>
          volumes.map(
            (one) => html`<tr><th scope="row"><button class="link"
              @click=${() => this.open(scene)}>${scene}</button></th><th>${say(lang, one.volume)}</th>${this.cells(
                [collisions, one.hits, one.falseAlarms],
                0,
              )}
              <td>${this.num((100 * one.falseAlarms) / (poses - collisions), 1)}
            %</td>${this.cells([one.missed], 0)}${this.cells([one.area, one.micros], 2)}</tr>`,
          ),
        )}</tbody></table></div></div>`;
  }

  private open(id: string): void {
    this.dispatchEvent(new CustomEvent("parkade-open-scene", { detail: { id }, bubbles: true, composed: true }));
  }

  private cells(values: readonly number[], digits: number): TemplateResult[] {
    return values.map((value) => html`<td>${this.num(value, digits)}</td>`);
  }

  private picture(): TemplateResult {
    const turn = (this.heading * Math.PI) / 180,
      [a, b] = HALF;
    const x = a * Math.cos(turn) + b * Math.sin(turn),
      y = a * Math.sin(turn) + b * Math.cos(turn),
      ink = { fill: "none", width: "0.05" };
    return html`<svg class="car" viewBox="-3.4 -3.4 6.8 6.8" role="img"
      aria-label=${say(this.state.lang, "title")}>${svg`
        <circle r=${RADIUS} fill=${ink.fill} stroke="#CC79A7" stroke-width=${ink.width} stroke-dasharray="0.05 0.12"
        stroke-linecap="round"></circle>
        <rect x=${-x} y=${-y} width=${2 * x} height=${2 * y} fill=${ink.fill} stroke="#D55E00" stroke-width=${ink.width}
        stroke-dasharray="0.25 0.12"></rect>
        <g transform="rotate(${-this.heading})"><rect x=${-a} y=${-b} width=${2 * a} height=${2 * b} fill="currentColor"
        fill-opacity="0.12" stroke="#0072B2"
        stroke-width="0.07"></rect><path d="M${a * 0.35} ${-b * 0.8}V${b * 0.8}L${a * 0.6} ${b * 0.9}V${-b * 0.9}Z"
        fill="currentColor" fill-opacity="0.3"></path></g>`}</svg>`;
  }
}

customElements.define("parkade-papers-volumes", PapersVolumes);
