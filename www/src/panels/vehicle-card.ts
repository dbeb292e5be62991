import { css, html, svg, type TemplateResult } from "lit";
import { setVehicle, vehicleOf } from "../scene/model";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { AppElement } from "./base";
import { valueOf } from "./inputs";

/** Which car plans, with the three numbers that matter for parking. */
export class VehicleCard extends AppElement {
  static override styles = [
    controls,
    sections,
    css`
    .card { display: grid; grid-template-columns: 92px 1fr; gap: 14px; align-items: center; }
    .facts { display: grid; font-size: 12px; line-height: 17px; }
    .facts span + span { color: var(--parkade-t2); }
    svg { overflow: visible; }
    .edit {
      justify-self: start; height: 24px; margin-left: -8px; padding: 0 8px; font-size: 12px;
      color: var(--parkade-accent);
    }
    select {
      appearance: none; border: 0; background: none; cursor: pointer; padding: 2px 6px; margin-right: -6px;
      border-radius: calc(6px * var(--parkade-radius)); color: var(--parkade-t2); text-align: right;
    }
    select:hover { background: var(--parkade-hover); color: var(--parkade-t1); }
    option { background: var(--parkade-raise); color: var(--parkade-t1); }
    @media (pointer: coarse) { select { min-height: 44px; } }
  `,
  ];

  protected override redrawMs = 100;
  protected watches(): readonly (keyof State)[] {
    return ["scene"];
  }

  protected override render(): TemplateResult {
    const spec = this.state.scene.vehicle ?? "paper";
    const car = vehicleOf(spec);
    const length = car.rearToFront + car.rearToBack;
    const names: ("paper" | "sedan" | "ship" | "own")[] = ["paper", "sedan"];
    if (spec === "ship") names.push("ship");
    else if (typeof spec !== "string") names.push("own");
    const now = typeof spec === "string" ? spec : "own";
    return html`
      <div class="head"><h2>${this.t("inspect.vehicle")}</h2>
        <select aria-label=${this.t("inspect.vehicle")} @change=${this.choose}>
          ${names.map(
            (name) => html`<option value=${name} ?selected=${name === now}>${this.t(`vehicle.${name}`)}</option>`,
          )}</select></div>
      <div class="card">${drawing(car.rearToBack, car.rearToFront, car.width, car.wheelbase)}
        <div class="facts"><span>${this.t("inspect.size", {
          length: this.num(length, 2),
          width: this.num(car.width, 2),
        })}</span>
          <span>${this.t("inspect.wheelbase", { value: this.num(car.wheelbase, 2) })}</span>
          <span>${this.t("inspect.turns", { value: this.num(car.minTurningRadius, 2) })}</span>
          <button class="button edit" @click=${this.edit}>${this.t("inspect.editVehicle")}</button></div></div>`;
  }

  private readonly edit = (): void =>
    void this.app.fetchPart(async () => (await import("./vehicle-editor")).editVehicle(this.app, this));

  private readonly choose = (event: Event): void => {
    const name = valueOf(event);
    if (name === "paper" || name === "sedan") this.app.store.edit(setVehicle(this.state.scene, name));
  };
}

/** The car from above to scale, nose to the right, front wheels at full lock as far as a sketch shows. */
function drawing(back: number, front: number, width: number, wheelbase: number): TemplateResult {
  const k = 92 / (front + back),
    w = width * k,
    rear = back * k,
    axle = rear + wheelbase * k;
  const wheel = (x: number, y: number, turn: number): unknown =>
    svg`<rect x=${x - 5.5} y=${y - 2} width="11" height="4" rx="1" transform="rotate(${turn} ${x} ${y})"
      fill="currentColor"/>`;
  return html`<svg width="92" height=${w + 6} viewBox="0 -3 92 ${w + 6}" fill="none" stroke="currentColor"
    stroke-width="1.25" aria-hidden="true">
    <g stroke="none"
      opacity=".85">${wheel(rear, 4, 0)}${wheel(rear, w - 4, 0)}${wheel(axle, 4, -16)}${wheel(axle, w - 4, -16)}</g>
    <rect x="0.6" y="0.6" width="90.8" height=${w - 1.2} rx="9" fill="var(--parkade-panel)"/>
    <path
      d="M62 ${w * 0.16}q7 ${w * 0.34} 0 ${w * 0.68}l-10 ${-w * 0.08}q4 ${-w * 0.26}
        0 ${-w * 0.52}zM24 ${w * 0.2}q-5 ${w * 0.3} 0 ${w * 0.6}l6 ${-w * 0.06}q-3 ${-w * 0.24} 0 ${-w * 0.48}z"
      stroke-linejoin="round"/>
    <path d="M${rear} 6V${w - 6}"/><circle cx=${rear} cy=${w / 2} r="3" fill="var(--parkade-panel)"/></svg>`;
}

customElements.define("parkade-vehicle", VehicleCard);
