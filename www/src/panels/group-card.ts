import type { Slot } from "../scene/scenario";
import { css, html, nothing, type TemplateResult } from "lit";
import { translatorAt } from "../i18n/translator";
import { findSlot, updateSlot, type Scene } from "../scene/model";
import { turnRows } from "../scene/slot-fit";
import { idsOf, moveThings } from "../scene/scene-objects";
import { turnThings } from "../scene/turning";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { duplicateSelected, removeSelected } from "../tools/edit-keys";
import { AppElement } from "./base";
import { icon } from "../styles/icons";
import type { On } from "./inputs";

const say = translatorAt("group");

/** Properties that several selected things share. */
export class GroupCard extends AppElement {
  static override styles = [
    controls,
    sections,
    css`
    .bays { display: flex; flex-wrap: wrap; gap: 4px; margin: 4px 0 8px; }
    .bays button { width: 36px; height: 32px; border: 1px solid var(--parkade-hair2); font-size: 12px; }
    .bays button[aria-pressed="true"] { background: var(--parkade-parked); border-color: var(--parkade-t2); }
    .danger { color: var(--parkade-err); margin-left: -8px; }
    .small { height: 28px; font-size: 12px; }
    h3 { margin: 0; font-size: 12px; line-height: 16px; font-weight: 400; color: var(--parkade-t2); }
    h3 + .row { margin-top: 4px; } .row + h3 { margin-top: 8px; }
  `,
  ];

  protected watches(): readonly (keyof State)[] {
    return ["scene", "selection"];
  }

  protected override render(): TemplateResult {
    const { lang, scene, selection } = this.state,
      ids = idsOf(selection);
    const slots = ids.flatMap((id) => findSlot(scene, id) ?? []);
    const only = slots.length > 0 && slots.length === ids.length;
    return html`<div class="head"><h2>${say(lang, only ? "slots" : "title", {
      n: ids.length,
    })}</h2><span>${this.t("inspect.selected")}</span></div>
      ${slots.length > 0 ? this.bays(slots) : nothing}
      ${
        only
          ? html`${this.sizes(slots)}<div class="row"><button class="button outline small"
            @click=${() =>
              this.app.store.edit(
                turnRows(this.state.scene, ids),
              )}>${icon("flip", 14)}${say(lang, "aisle")}</button></div>`
          : nothing
      }
      <h3>${say(lang, "move")}</h3><div class="row">${this.field("x", "m", (dx) =>
        moveThings(this.state.scene, ids, dx, 0),
      )}${this.field("y", "m", (dy) => moveThings(this.state.scene, ids, 0, dy))}</div>
      <h3>${say(lang, "turn")}</h3><div class="row">${this.field("\u03b8", "\u00b0", (angle) =>
        turnThings(this.state.scene, ids, (angle * Math.PI) / 180),
      )}</div>
      <div class="row"><button class="button outline small"
        @click=${() =>
          duplicateSelected(
            this.app.store,
          )}>${icon("copy", 14)}${say(lang, "duplicate")}</button><span class="keys to-end">Ctrl D</span></div>
      <div class="row"><button class="button danger small"
        @click=${() =>
          removeSelected(
            this.app.store,
          )}>${icon("trash", 14)}${say(lang, "remove")}</button><span class="keys to-end">Del</span></div>`;
  }

  private bays(slots: readonly Slot[]): TemplateResult {
    const { lang, scene } = this.state,
      { goal } = scene;
    return html`<h3>${say(lang, "occupied")}</h3><div class="bays" role="group"
      aria-label=${say(lang, "occupied")}>${slots.map(
        ({ id, occupied = false }, i) => html`
          <button aria-pressed=${occupied} ?disabled=${"slot" in goal && goal.slot === id}
          aria-label="${this.t("thing.slotName")} ${i + 1}"
          @click=${() =>
            this.app.store.edit(
              updateSlot(this.state.scene, id!, { occupied: !occupied }),
            )}>${occupied ? icon("car", 14) : i + 1}</button>`,
      )}</div>
      <p>${say(lang, "help")}</p>`;
  }

  private sizes(slots: readonly Slot[]): TemplateResult {
    const all = (patch: Partial<Slot>): Scene =>
      slots.reduce((scene, { id }) => updateSlot(scene, id!, patch), this.state.scene);
    const [first] = slots;
    return html`<div class="row">${this.field(
      this.t("option.width"),
      "m",
      (width) => all({ width }),
      first!.width,
      0.5,
    )}${this.field(this.t("option.depth"), "m", (length) => all({ length }), first!.length, 0.5)}</div>`;
  }

  private field(label: string, unit: string, apply: (value: number) => Scene, value = 0, min?: number): TemplateResult {
    return html`<label class="field"><span>${label}</span><input type="number" step="0.1" min=${min ?? nothing}
      .value=${value.toFixed(2)}
      @change=${({ currentTarget: input }: On<HTMLInputElement>) => {
        const typed = Number(input.value);
        const fits = input.value !== "" && Number.isFinite(typed) && (min === undefined || typed >= min);
        if (fits && typed !== value) this.app.store.edit(apply(typed));
        if (!fits || min === undefined) input.value = value.toFixed(2);
      }}><span>${unit}</span></label>`;
  }
}

customElements.define("parkade-group", GroupCard);
