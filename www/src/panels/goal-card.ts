import { css, html, nothing, type TemplateResult } from "lit";
import { translatorAt } from "../i18n/translator";
import {
  anyFreeSlot,
  anywhereIn,
  freeSlots,
  flipGoal,
  goalKind,
  leaveSlot,
  onlyOne,
  regionAroundGoal,
  slotOfStart,
  withEntry,
  type AnyEntry,
  type GoalKind,
} from "../scene/goals";
import { goalPose, type Scene } from "../scene/model";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { AppElement } from "./base";
import { isChecked } from "./inputs";
import { icon } from "../styles/icons";

const say = translatorAt("goal");
const ENTRIES = ["either", "head-in", "reverse-in"] as const;

/** The kind of goal: one place, or any of several. */
export class GoalCard extends AppElement {
  static override styles = [
    controls,
    sections,
    css`
    :host { display: block; margin-top: 8px; }
    .segmented { flex-wrap: wrap; } .small { height: 28px; font-size: 12px; }
    label { display: flex; gap: 8px; align-items: center; }
    label input { accent-color: var(--parkade-accent); }
  `,
  ];

  protected watches(): readonly (keyof State)[] {
    return ["scene"];
  }

  protected override render(): TemplateResult {
    const { scene } = this.state,
      { goal } = scene,
      kind = goalKind(goal);
    return html`${this.choice(
      "what",
      [
        ["one", () => this.one(), say(this.state.lang, "one")],
        ...(Array.isArray(goal)
          ? [["poses", () => scene, say(this.state.lang, "poses", { n: goal.length })] as const]
          : []),
        ...(kind === "slots" || freeSlots(scene).length > 0
          ? [["slots", () => anyFreeSlot(scene), this.slotsName()] as const]
          : []),
        ["region", () => anywhereIn(scene, regionAroundGoal(scene)), say(this.state.lang, "region")],
      ],
      kind,
    )}
      ${
        "entry" in goal
          ? this.choice(
              "entry",
              ENTRIES.slice("slots" in goal ? 0 : 1).map((entry) => [
                entry,
                () => withEntry(scene, entry),
                this.entryName(entry),
              ]),
              goal.entry,
            )
          : nothing
      }
      ${
        "x" in goal
          ? html`<div class="row"><button class="button outline small"
            @click=${() => this.edit(flipGoal(scene))}>${icon("flip", 14)}${this.t("inspect.flips")}</button></div>`
          : nothing
      }
      ${
        "region" in goal
          ? html`<div class="row"><label><input type="checkbox" .checked=${goal.heading !== undefined}
            @change=${(e: Event) =>
              this.edit(
                anywhereIn(scene, goal.region, isChecked(e) ? goalPose(scene).heading : undefined),
              )}>${say(this.state.lang, "heading")}</label></div>`
          : nothing
      }
      ${
        slotOfStart(scene) && kind !== "region"
          ? html`<div class="row"><button class="button outline small"
            @click=${() => this.edit(leaveSlot(scene))}>${say(this.state.lang, "leave")}</button></div>`
          : nothing
      }`;
  }

  private choice<Name extends GoalKind | AnyEntry>(
    label: "what" | "entry",
    options: readonly (readonly [Name, () => Scene, string])[],
    chosen: string,
  ): TemplateResult {
    return html`<div class="row"><div class="segmented" role="group"
      aria-label=${say(this.state.lang, label)}>${options.map(
        ([name, scene, text]) =>
          html`<button aria-pressed=${name === chosen}
            @click=${() => name !== chosen && this.edit(scene())}>${text}</button>`,
      )}</div></div>`;
  }

  private slotsName(): string {
    const {
      lang,
      scene: { goal },
    } = this.state;
    return "slots" in goal && goal.slots !== "free" ? say(lang, "some", { n: goal.slots.length }) : say(lang, "free");
  }

  private entryName(entry: AnyEntry): string {
    return entry === "either"
      ? say(this.state.lang, "either")
      : this.t(entry === "head-in" ? "inspect.head" : "inspect.reverse");
  }

  /** The goal that the focused planner leads to. */
  private one(): Scene {
    const { scene, results, focus } = this.state;
    return onlyOne(scene, results[focus]?.plan?.goal);
  }

  private edit(scene: Scene): void {
    this.app.store.edit(scene, { label: "goal" });
  }
}

customElements.define("parkade-goal", GoalCard);
