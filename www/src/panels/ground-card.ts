import { css, html, nothing, type TemplateResult } from "lit";
import {
  axisOf,
  coordinateOf,
  edgeOn,
  groundOf,
  moveSide,
  outward,
  roomOf,
  sizeAlong,
  type Side,
} from "../scene/ground";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { AppElement } from "./base";
import { valueOf } from "./inputs";
import { stopText } from "../texts/ground-limit";
import { keysOf } from "../scene/records";

const FIELDS = { width: ["right", "left"], depth: ["top", "bottom"] } as const satisfies Record<
  string,
  readonly Side[]
>;
type Field = keyof typeof FIELDS;

/** The ground's size in metres, while nothing is selected. */
export class GroundCard extends AppElement {
  static override properties = { ...AppElement.properties, refused: { state: true } };
  static override styles = [
    controls,
    sections,
    css`.bad { border-color: var(--parkade-err); } [role="alert"] { color: var(--parkade-err); }
    @media (pointer: coarse) { .row .field { height: 44px; } }`,
  ];
  /** What was typed last, and why it cannot be. */
  declare refused: { field: Field; text: string; reason: string } | null;
  protected override redrawMs = 100;

  constructor() {
    super();
    this.refused = null;
  }

  protected watches(): readonly (keyof State)[] {
    return ["scene"];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { refused } = this,
      rows = keysOf(FIELDS).map((field) => this.field(field));
    return html`<div class="row">${rows}</div>${
      refused ? html`<div class="row"><p id="why" role="alert">${refused.reason}</p></div>` : nothing
    }`;
  }

  private field(field: Field): TemplateResult {
    const box = groundOf(this.state.scene),
      side = this.sideOf(field),
      bad = this.refused?.field === field,
      size = sizeAlong(box, axisOf(FIELDS[field][0]));
    return html`<label class="field ${bad ? "bad" : ""}"><span>${this.t(`ground.${field}`)}</span><input type="number"
      step="0.1" ?disabled=${!side}
      .value=${bad ? this.refused!.text : String(Math.round(size * 1000) / 1000)} aria-invalid=${bad}
      aria-describedby=${bad ? "why" : nothing}
      @change=${(e: Event) => this.type(field, valueOf(e))}><span>m</span></label>`;
  }

  /** The right and the upper side move where they can. */
  private sideOf(field: Field): Side | undefined {
    return FIELDS[field].find((side) => edgeOn(this.state.scene, side));
  }

  private type(field: Field, text: string): void {
    const { scene } = this.state,
      side = this.sideOf(field)!,
      sign = outward(side),
      box = groundOf(scene),
      size = Number(text),
      room = roomOf(scene, side);
    const now = coordinateOf(box, side),
      length = sizeAlong(box, axisOf(side)),
      at = now + sign * (size - length);
    const least = length - sign * (now - room.inner.at),
      most = length + sign * (room.outer - now),
      isNumber = text.trim() !== "" && Number.isFinite(size);
    if (isNumber && size >= least - 1e-6 && size <= most + 1e-6) {
      this.refused = null;
      this.app.store.edit(moveSide(scene, side, Math.round(at * 1e6) / 1e6), { label: "ground" });
      return;
    }
    const metres = (value: number): string => this.num(value, 2),
      rule = this.t("ground.range", {
        field: this.t(`ground.${field}`),
        least: metres(least),
        most: metres(most),
        value: text,
      });
    this.refused = {
      field,
      text,
      reason: isNumber
        ? [rule, stopText(this.state, room, size < least)].join(this.state.lang === "zh" ? "" : " ")
        : rule,
    };
  }
}

customElements.define("parkade-ground", GroundCard);
