import { css, html, nothing, type TemplateResult } from "lit";
import type { Plan } from "parkade";
import { refusal, type App } from "../app/app";
import { Helper } from "../planning/job-client";
import {
  buildLot,
  firstForm,
  LIMITS,
  sizesOf,
  type LotFault,
  type LotForm,
  type NumberField,
  type Sizes,
} from "../scene/lot";
import type { Scene, State } from "../store";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { DialogElement } from "./dialog";
import { numberOf, valueOf } from "./inputs";
import { icon } from "../styles/icons";
import { BLOCKS, CHOICES, followed, isChoice, UNITS, type Block, type Choice } from "./new-lot-fields";
import { faultText, say, type Word } from "./new-lot-messages";
import "./new-lot-preview";
import type { Resize } from "./new-lot-preview";
import { besideOf } from "./beside";
import { keysOf } from "../scene/records";
import type { Said } from "../i18n/said";

/** A plan for numbers that are no longer asked is given up after so many milliseconds. */
const GIVE_UP_AFTER_MS = 300;

/** A lot from a few numbers, drawn and planned while they change. */
export class NewLot extends DialogElement {
  static override properties = {
    ...DialogElement.properties,
    form: { state: true },
    block: { state: true },
    plan: { state: true },
    trouble: { state: true },
    typed: { state: true },
  };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 880px; height: min(560px, 92dvh); }
    form {
      flex: 1; min-height: 0; display: grid; grid-template: minmax(0, 1fr) auto / 320px minmax(0, 1fr);
      border-top: 1px solid var(--parkade-hair);
    }
    .blocks { overflow-y: auto; border-right: 1px solid var(--parkade-hair); overscroll-behavior: contain; }
    section { border-bottom: 1px solid var(--parkade-hair); }
    .head {
      display: flex; width: 100%; height: 40px; padding: 0 16px 0 24px; justify-content: flex-start; gap: 10px;
      border-radius: 0;
    }
    .head:hover { background: var(--parkade-hover); } .head:focus-visible { outline-offset: -2px; }
    .head b { font-weight: 600; }
    .head span {
      flex: 1; min-width: 0; text-align: right; overflow: hidden; text-overflow: ellipsis; color: var(--parkade-t2);
      font-size: 12.5px;
    }
    .head svg { color: var(--parkade-t3); }
    .head[aria-expanded="true"] svg { transform: rotate(180deg); }
    .head.bad b { color: var(--parkade-err); }
    .rows { padding: 0 16px 10px 24px; }
    .row { display: flex; align-items: center; gap: 10px; min-height: 32px; }
    .row > label, .name { width: 94px; flex: none; color: var(--parkade-t2); }
    .name { width: auto; }
    .row .slider { flex: 1; min-width: 0; width: 0; }
    .row .field { width: 74px; flex: none; }
    .row .segmented { margin-left: auto; }
    .row .segmented button { padding: 0 8px; }
    .row .field.bad { border-color: var(--parkade-err); } .row .field.auto input { color: var(--parkade-t2); }
    .row .icon { width: 20px; height: 24px; margin: 0 -4px; }
    .row .segmented:only-child { margin: 0; }
    footer {
      grid-column: 1 / -1; display: flex; align-items: center; gap: 10px; padding: 12px 16px 12px 24px;
      border-top: 1px solid var(--parkade-hair);
    }
    footer p { margin: 0; flex: 1; min-width: 0; color: var(--parkade-t2); } footer p.bad { color: var(--parkade-err); }
    @media (max-width: 640px) {
      dialog { width: 100vw; height: 100dvh; max-height: none; border-radius: 0; margin: 0; }
      form { grid-template: 45dvh minmax(0, 1fr) auto / 100%; }
      parkade-lot-preview { order: -1; border-bottom: 1px solid var(--parkade-hair); }
      .blocks { border: 0; }
      .head { height: 44px; padding: 0 16px; }
      .rows { padding: 0 16px 10px; }
      .row { min-height: 44px; }
      .row .field { height: 36px; }
      footer { padding: 10px 16px; flex-wrap: wrap; }
      footer p { flex: 1 0 100%; min-height: 20px; }
      footer .button { height: 44px; flex: 1; }
    }
  `,
  ];
  declare form: LotForm;
  declare block: Block | null;
  declare plan: Plan | null;
  /** Why there is no plan, where that is no fault of the numbers. */
  declare trouble: Said | null;
  /** The text of the field being edited. */
  declare typed: { field: NumberField; text: string } | null;
  private helper: Helper | null = null;
  private scene: Scene | null = null;
  private fault: LotFault | null = null;
  /** Why the dragged border goes no further. */
  private stopped: LotFault | null = null;
  /** The form when the border was taken hold of. */
  private grabbed: LotForm | null = null;
  private asked: Scene | null = null;
  private askedAt = 0;

  protected override readonly closesOutside = false;

  constructor() {
    super();
    this.form = firstForm;
    this.block = "bays";
    this.plan = this.typed = null;
    this.trouble = null;
  }

  override open(): void {
    super.open();
    this.change({});
  }

  protected override watches(): readonly (keyof State)[] {
    return ["theme"];
  }

  protected override content(): TemplateResult {
    const { lang } = this.state,
      sizes = sizesOf(this.form),
      found = this.plan?.outcome === "found";
    return html`${this.top(say(lang, "title"))}
      <form novalidate @submit=${this.submit}>
        <div class="blocks">${keysOf(BLOCKS).map((block) => this.section(block, sizes))}</div>
        ${
          this.scene
            ? html`<parkade-lot-preview .app=${this.app} .scene=${this.scene}
              .plan=${found && !this.fault ? this.plan : null} .stale=${this.fault !== null} @pointerdown=${() => {
                this.grabbed = this.form;
              }} @parkade-ground=${this.resize}></parkade-lot-preview>`
            : nothing
        }
        <footer><p role="status" id="fault" class=${(this.fault ?? this.stopped) ? "bad" : ""}>${this.sentence()}</p>
          <button class="button outline" type="button" @click=${this.close}>${say(lang, "cancel")}</button>
          <button class="button solid" autofocus ?disabled=${this.fault !== null}>${say(lang, "open")}</button></footer>
      </form>`;
  }

  private section(block: Block, sizes: Sizes): TemplateResult {
    const { lang } = this.state,
      isOpen = this.block === block,
      bad = this.fault !== null && BLOCKS[block].includes(this.fault.field);
    return html`<section><button type="button" class="head ${bad ? "bad" : ""}" aria-expanded=${isOpen} @click=${() => {
      this.block = isOpen ? null : block;
    }}>
        <b>${say(lang, block)}</b><span>${
          isOpen ? nothing : this.summary(block, sizes)
        }</span>${icon("down", 14)}</button>
      ${
        isOpen
          ? html`<div class="rows">${BLOCKS[block]
              .filter((field) => this.isAsked(field))
              .map((field) => (isChoice(field) ? this.choice(field) : this.number(field, sizes)))}</div>`
          : nothing
      }</section>`;
  }

  /** One-line summary of a closed block. */
  private summary(block: Block, { car, bay, rows, width, depth }: Sizes): string {
    const { form } = this,
      { lang } = this.state,
      metres = (value: number): string => this.num(value, 1);
    switch (block) {
      case "ground":
        return say(lang, "groundIs", { width: metres(width), depth: metres(depth) });
      case "bays":
        return say(lang, "baysAre", {
          n: rows * form.count,
          kind: say(lang, form.kind).toLowerCase(),
          width: metres(bay.width),
          length: metres(bay.length),
        });
      case "obstacles":
        return [
          say(lang, "parkedCars", { n: form.parked }),
          ...(form.wall > 0 ? [say(lang, "walls")] : []),
          ...(form.every > 0 ? [say(lang, "columns")] : []),
        ].join(lang === "zh" ? "，" : ", ");
      case "vehicle":
        return say(lang, "carIs", {
          car: say(lang, form.car),
          length: metres(car.rearToFront + car.rearToBack),
          width: metres(car.width),
        });
    }
  }

  private isAsked(field: keyof LotForm): boolean {
    const { kind, every, car } = this.form;
    switch (field) {
      case "angle":
        return kind === "angled";
      case "column":
        return every > 0;
      case "entry":
        return kind !== "parallel";
      case "carLength":
      case "carWidth":
      case "wheelbase":
      case "radius":
        return car === "own";
      default:
        return true;
    }
  }

  private choice(field: Choice): TemplateResult {
    const { lang } = this.state,
      name = say(lang, field);
    return html`<div class="row">${
      field === "kind" ? nothing : html`<span class="name">${name}</span>`
    }<div class="segmented" role="group" aria-label=${name}>${CHOICES[field].map(
      (value) => html`
        <button type="button" aria-pressed=${this.form[field] === value}
        @click=${() => this.change({ [field]: value })}>${say(lang, value as Word)}</button>`,
    )}</div></div>`;
  }

  private number(field: NumberField, sizes: Sizes): TemplateResult {
    const { lang } = this.state,
      [least, most, digits, usual] = LIMITS[field],
      step = digits > 0 ? 0.1 : 1,
      unit = UNITS[field] ?? "m";
    const given = this.form[field],
      now = given ?? followed(field, sizes),
      bad = this.fault?.field === field,
      top = Math.min(most, Math.max(usual, now || 0));
    const text =
      this.typed?.field === field ? this.typed.text : Number.isFinite(now) ? String(Math.round(now * 100) / 100) : "";
    return html`<div class="row"><label for=${field}>${say(lang, field)}</label>
      <input class="slider" type="range" tabindex="-1" aria-label=${say(lang, field)} min=${least} max=${top}
        step=${step} .value=${String(now)} .style=${`--at: ${((now - least) / (top - least)) * 100}%`}
        @input=${(e: Event) => this.set(field, numberOf(e))}>
      ${
        given !== null && firstForm[field] === null
          ? html`<button type="button" class="icon" title=${say(lang, "auto")}
            aria-label=${`${say(lang, field)}: ${say(lang, "auto")}`}
            @click=${() => this.set(field, null)}>${icon("undo", 14)}</button>`
          : nothing
      }
      <span class="field ${bad ? "bad" : ""} ${given === null ? "auto" : ""}"><input id=${field} inputmode="decimal"
        autocomplete="off" .value=${text} aria-invalid=${bad} aria-describedby=${bad ? "fault" : nothing}
        @input=${(e: Event) => this.type(field, valueOf(e))} @blur=${() => {
          this.typed = null;
        }} @keydown=${(e: KeyboardEvent) =>
          this.onArrow(e, field, now, step)}>${unit ? html`<span>${unit}</span>` : nothing}</span></div>`;
  }

  /** An emptied field follows the other numbers again, where it can. */
  private type(field: NumberField, text: string): void {
    const number = text.trim() === "" ? NaN : Number(text.replace(",", "."));
    this.change({ [field]: text.trim() === "" && firstForm[field] === null ? null : number });
    this.typed = { field, text };
  }

  private onArrow(event: KeyboardEvent, field: NumberField, now: number, step: number): void {
    const sign = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0,
      [least, most] = LIMITS[field];
    if (sign === 0 || !Number.isFinite(now)) return;
    event.preventDefault();
    this.set(field, Math.min(most, Math.max(least, Math.round((now + sign * step) / step) * step)));
  }

  private set(field: NumberField, value: number | null): void {
    this.typed = null;
    this.change({ [field]: value === null ? null : Math.round(value * 1000) / 1000 });
  }

  private change(patch: Partial<LotForm>): void {
    this.form = { ...this.form, ...patch };
    const { scene, fault } = buildLot(this.form);
    this.fault = fault;
    this.stopped = null;
    this.trouble = null;
    this.plan = null;
    // Numbers that make no lot leave the last one in sight, pale.
    if (scene) this.scene = scene;
    void this.solve();
  }

  private sentence(): string {
    const { lang } = this.state,
      { plan, scene } = this;
    const fault = this.fault ?? this.stopped;
    if (fault) return faultText(lang, fault);
    if (this.trouble) return say(lang, "failed", { reason: this.trouble });
    const goal = scene?.goal,
      bay = goal && "slot" in goal ? goal.slot.replace("slot-", "") : "";
    if (!plan) return say(lang, "planning", { bay });
    return plan.outcome === "found"
      ? say(lang, "reaches", { bay, length: this.num(plan.metrics.length, 1), n: plan.metrics.directionChanges })
      : say(lang, "noWay", { bay });
  }

  /** The border stops where a number would make no lot. */
  private readonly resize = ({ detail: { field, metres } }: CustomEvent<Resize>): void => {
    if (metres === null) {
      if (this.grabbed) this.change({ [field]: this.grabbed[field] });
      return;
    }
    const [least, most] = LIMITS[field],
      within = Math.min(most, Math.max(least, metres)),
      { fault } = buildLot({ ...this.form, [field]: within });
    const stop: LotFault | null =
      fault?.field === field ? fault : within === metres ? null : { field, rule: "limits", least };
    this.block = "ground";
    this.set(field, fault?.field === field ? fault.least : within);
    this.stopped = stop;
  };

  /** Plans the latest numbers; what is planned for others ends first, or is given up. */
  private async solve(): Promise<void> {
    if (this.asked) {
      if (performance.now() - this.askedAt > GIVE_UP_AFTER_MS) this.giveUp();
      return;
    }
    while (this.shown && !this.fault && !this.plan && !this.trouble) {
      const scene = (this.asked = this.scene!);
      try {
        const engine = await this.app.complete();
        this.helper ??= new Helper(engine);
        this.askedAt = performance.now();
        const plan = await this.helper.call("solve", { planner: "hybrid", scene });
        if (scene === this.scene) this.plan = plan;
      } catch (error) {
        if (scene === this.scene) this.trouble = refusal(error);
      } finally {
        this.asked = null;
      }
    }
  }

  private giveUp(): void {
    this.helper?.stop();
    this.helper = null;
  }

  private readonly submit = (event: Event): void => {
    event.preventDefault();
    if (this.fault || !this.scene) return;
    void this.app.links.mark();
    void this.app.openForeign(this.scene);
    this.close();
  };

  protected override closed(): void {
    this.giveUp();
  }
}

customElements.define("parkade-new-lot", NewLot);

/** Opens the form beside a piece of its playground. */
export function openNewLot(app: App, piece: HTMLElement): void {
  besideOf(NewLot, app, piece).open();
}
