import type { LibraryVehicle, Vehicle } from "parkade";
import { css, html, nothing, svg, type TemplateResult } from "lit";
import { refusal, type App } from "../app/app";
import { reasonIn } from "../i18n/index";
import messages from "../i18n/messages/vehicle-editor.json";
import { translator } from "../i18n/translator";
import { degrees, radians } from "../scene/geometry";
import { setVehicle } from "../scene/model";
import { turningCircles } from "../scene/turning-circles";
import { vehicleOf } from "../scene/vehicle";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { DialogElement } from "./dialog";
import { numberOf, valueOf } from "./inputs";
import { besideOf } from "./beside";

const say = translator("vehicleEditor", messages);

const FIELDS = ["wheelbase", "frontOverhang", "rearOverhang", "width", "lock"] as const;
type Form = Record<(typeof FIELDS)[number], number>;
const LONGEST_OVERHANG = 6;

/** Edits the scene's vehicle, or takes one of the library; draws its turning circles and refuses impossible ones. */
export class VehicleEditor extends DialogElement {
  static override properties = {
    ...DialogElement.properties,
    form: { state: true },
    library: { state: true },
    known: { state: true },
  };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 720px; }
    form { display: grid; grid-template-columns: minmax(0, 1fr) 290px; gap: 18px; }
    form svg {
      width: 100%; height: 320px; background: var(--parkade-floor); border: 1px solid var(--parkade-hair);
      border-radius: calc(8px * var(--parkade-radius)); color: var(--parkade-t1);
    }
    .side { display: grid; gap: 8px; align-content: start; }
    label { display: flex; align-items: center; justify-content: space-between; gap: 8px; color: var(--parkade-t2); }
    .field { width: 96px; color: var(--parkade-t1); flex: none; }
    select {
      min-width: 0; max-width: 170px; height: 28px; padding: 0 4px; color: var(--parkade-t1);
      background: var(--parkade-panel); border: 1px solid var(--parkade-hair2);
      border-radius: calc(6px * var(--parkade-radius));
    }
    p { margin: 0; color: var(--parkade-t2); font-size: 12px; line-height: 16px; }
    .fault { color: var(--parkade-err); }
    .solid { width: 100%; }
    @media (max-width: 640px) { form { grid-template-columns: minmax(0, 1fr); } form svg { height: 200px; } }
  `,
  ];
  declare form: Form;
  declare library: LibraryVehicle[];
  /** Id of the library; empty for own dimensions. */
  declare known: string;

  constructor() {
    super();
    this.form = { wheelbase: 2.8, frontOverhang: 0.95, rearOverhang: 0.95, width: 1.9, lock: 27 };
    this.library = [];
    this.known = "";
  }

  async ask(): Promise<void> {
    this.library = (await this.app.complete()).api.vehicles();
    this.form = formOf(vehicleOf(this.state.scene.vehicle));
    this.known = "";
    this.open();
  }

  protected override content(): TemplateResult {
    const { lang } = this.state,
      { form } = this,
      vehicle = vehicleFrom(form),
      fault = this.fault(vehicle),
      source = this.library.find(({ id }) => id === this.known)?.source;
    return html`${this.top(say(lang, "title"))}
      <div class="scroll"><form novalidate @submit=${(event: Event) => this.accept(event, vehicle, fault)}>
        ${
          fault
            ? html`<svg role="img" aria-label=${say(lang, "picture")}></svg>`
            : picture(vehicle, say(lang, "picture"))
        }
        <div class="side">
          <label>${say(lang, "library")}<select @change=${this.choose}><option value=""
            ?selected=${this.known === ""}>${say(lang, "own")}</option>${this.library.map(
              ({ id, title }) =>
                html`<option value=${id} ?selected=${id === this.known}
                  .selected=${id === this.known}>${title[lang]}</option>`,
            )}</select></label>
          ${FIELDS.map(
            (field) =>
              html`<label>${say(lang, field)}<span class="field"><input type="number" step="any" name=${field}
                .value=${String(form[field])} aria-invalid=${fault !== null}
                @input=${(event: Event) =>
                  this.set(field, numberOf(event))}><span>${field === "lock" ? "°" : "m"}</span></span></label>`,
          )}
          ${fault ? html`<p class="fault" role="alert">${fault}</p>` : this.circles(vehicle)}
          ${source ? html`<p>${say(lang, "source", { source })}</p>` : nothing}
          <button class="button solid" ?disabled=${fault !== null}>${say(lang, "use")}</button></div></form></div>`;
  }

  private circles(vehicle: Vehicle): TemplateResult {
    const { lang } = this.state,
      { kerb, wall } = turningCircles(vehicle);
    return html`<p aria-live="polite">${say(lang, "kerb", {
      metres: this.num(2 * kerb, 2),
    })}<br>${say(lang, "wall", { metres: this.num(2 * wall, 2) })}</p>`;
  }

  private set(field: keyof Form, value: number): void {
    this.form = { ...this.form, [field]: value };
    this.known = "";
  }

  private readonly choose = (event: Event): void => {
    this.known = valueOf(event);
    const found = this.library.find(({ id }) => id === this.known);
    if (found) this.form = formOf(found.vehicle);
  };

  /** Why there is no such vehicle, in words. */
  private fault(vehicle: Vehicle): string | null {
    const { lang, scene } = this.state,
      { frontOverhang, rearOverhang } = this.form;
    if (![frontOverhang, rearOverhang].every((metres) => metres >= 0 && metres <= LONGEST_OVERHANG))
      return say(lang, "maxOverhang");
    try {
      this.app.catalog?.geometry(setVehicle(scene, vehicle));
    } catch (error) {
      return reasonIn(lang, refusal(error));
    }
    return turningCircles(vehicle).inner <= 0 ? say(lang, "turnsInside") : null;
  }

  private accept(event: Event, vehicle: Vehicle, fault: string | null): void {
    event.preventDefault();
    if (fault) return;
    this.app.store.edit(setVehicle(this.state.scene, vehicle));
    this.close();
  }
}

const rounded = (value: number): number => Math.round(value * 1000) / 1000;

const formOf = ({ wheelbase, rearToFront, rearToBack, width, maxSteer }: Vehicle): Form => ({
  wheelbase,
  frontOverhang: rounded(rearToFront - wheelbase),
  rearOverhang: rearToBack,
  width,
  lock: Math.round(degrees(maxSteer) * 100) / 100,
});

const vehicleFrom = ({ wheelbase, frontOverhang, rearOverhang, width, lock }: Form): Vehicle => ({
  wheelbase,
  width,
  rearToFront: rounded(wheelbase + frontOverhang),
  rearToBack: rearOverhang,
  maxSteer: radians(lock),
});

/** The body from above, nose up, with its circles about the point that it turns about, to the left. */
function picture(vehicle: Vehicle, label: string): TemplateResult {
  const { axle, kerb, wall, inner } = turningCircles(vehicle),
    { width, rearToFront, rearToBack, wheelbase } = vehicle,
    side = wall * 1.06;
  const arc = (radius: number, dash: string, stroke: string): unknown =>
    svg`<circle cx="0" cy="0" r=${radius} fill="none" stroke=${stroke} stroke-width=${side / 160}
      stroke-dasharray=${dash}/>`;
  return html`<svg role="img" aria-label=${label} viewBox="${-side} ${-side} ${2 * side} ${2 * side}">
    ${arc(wall, "", "var(--parkade-t1)")}${arc(
      kerb,
      `${side / 30} ${side / 50}`,
      "var(--parkade-accent)",
    )}${arc(inner, "", "var(--parkade-t3)")}
    <rect x=${axle - width / 2} y=${-rearToFront} width=${width} height=${rearToFront + rearToBack} rx=${width / 6}
      fill="var(--parkade-panel)" stroke="currentColor" stroke-width=${side / 110}/>
    <path d="M${axle - width / 2} 0h${width}M${axle - width / 2} ${-wheelbase}h${width}M0 0H${axle}" fill="none"
      stroke="currentColor" stroke-width=${side / 220}/>
    <circle cx="0" cy="0" r=${side / 70} fill="currentColor"/></svg>`;
}

customElements.define("parkade-vehicle-editor", VehicleEditor);

/** Opens the editor beside a piece of its playground. */
export function editVehicle(app: App, piece: HTMLElement): void {
  void besideOf(VehicleEditor, app, piece).ask();
}
