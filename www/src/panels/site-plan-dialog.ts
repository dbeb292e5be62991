import type { Role, SitePlanScene } from "parkade/siteplan";
import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { refusal, sentence } from "../app/app";
import { reasonIn } from "../i18n/index";
import messages from "../i18n/messages/site-plan.json";
import { translator } from "../i18n/translator";
import { distance, type Point } from "../scene/geometry";
import { ensureIds } from "../scene/model";
import type { Scene } from "../store";
import type { SitePlanReader } from "../planning/site-plan-reader";
import type { PlanOutline } from "../siteplan/plan-outline";
import { ROLES, suggestedRole } from "../siteplan/site-plan-scene";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { vast } from "../view/lazy-large-maps";
import { DialogElement } from "./dialog";
import { numberOf } from "./inputs";
import "./site-plan-preview";
import { chosenOf } from "./chosen";
import type { Said } from "../i18n/said";

const say = translator("sitePlan", messages);

/** A scene with what there is to say of it. */
type Made = Omit<SitePlanScene, "scene"> & { scene: Scene };

/** What takes less is not told, milliseconds: a small plan would flicker. */
const SLOW = 150;

/** Asks what the layers of a site plan are, and shows the scene that comes of them. */
export class SitePlanDialog extends DialogElement {
  static override properties = {
    ...DialogElement.properties,
    plan: { state: true },
    roles: { state: true },
    unit: { state: true },
    around: { state: true },
    ruler: { state: true },
    lit: { state: true },
    made: { state: true },
    isConverting: { state: true },
    isSlow: { state: true },
  };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 940px; }
    form { display: grid; grid-template-columns: minmax(0, 1fr) 330px; gap: 18px; }
    parkade-site-plan-preview { min-height: 300px; height: 100%; max-height: 560px; }
    .side { display: flex; flex-direction: column; gap: 12px; min-width: 0; min-height: 0; }
    h3 { margin: 0; font: inherit; font-weight: 600; }
    ul {
      list-style: none; margin: 0; padding: 0; max-height: 250px; overflow-y: auto;
      border-block: 1px solid var(--parkade-hair);
    }
    li {
      display: grid; grid-template-columns: minmax(0, 1fr) auto; align-items: center; gap: 2px 8px; padding: 5px 2px;
      border-bottom: 1px solid var(--parkade-hair);
    }
    li:last-child { border: 0; }
    li span { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
    small { color: var(--parkade-t3); font-size: 12px; }
    select {
      height: 28px; padding: 0 6px; max-width: 176px; color: var(--parkade-t1); background: var(--parkade-panel);
      border: 1px solid var(--parkade-hair2); border-radius: calc(6px * var(--parkade-radius));
    }
    label { display: flex; align-items: center; justify-content: space-between; gap: 8px; color: var(--parkade-t2); }
    .field { width: 112px; color: var(--parkade-t1); }
    p { margin: 0; color: var(--parkade-t2); font-size: 12px; line-height: 16px; }
    .fault { color: var(--parkade-err); }
    .fault::first-letter { text-transform: uppercase; }
    .solid { width: 100%; }
    @media (max-width: 640px) {
      form { grid-template-columns: 1fr; gap: 12px; }
      parkade-site-plan-preview { min-height: 34vh; height: 34vh; }
      ul { max-height: 200px; }
      select { height: 36px; }
    }
    @media (max-height: 480px) {
      form { grid-template-columns: minmax(0, 1fr) 300px; }
      parkade-site-plan-preview { position: sticky; top: 0; min-height: 0; height: min(250px, 92vh - 120px); }
      ul { max-height: none; }
    }
  `,
  ];
  declare plan: PlanOutline | null;
  declare roles: Record<string, Role>;
  declare unit: number;
  declare around: number;
  declare ruler: [Point, Point] | null;
  declare lit: string;
  /** What the last conversion gave: a scene, or why there is none. */
  declare made: Made | { reason: Said } | null;
  declare isConverting: boolean;
  declare isSlow: boolean;
  private name = "";
  private reader: SitePlanReader | null = null;
  /** True if something was chosen while a conversion ran. */
  private isOutdated = false;

  protected override readonly closesOutside = false;

  constructor() {
    super();
    this.plan = this.ruler = this.made = null;
    this.isConverting = this.isSlow = false;
    this.roles = {};
    this.unit = 1;
    this.around = 25;
    this.lit = "";
  }

  /** The dialog closes the reader. */
  ask(plan: PlanOutline, reader: SitePlanReader, name: string): void {
    this.plan = plan;
    this.reader = reader;
    this.made = null;
    this.name = name;
    this.roles = Object.fromEntries(plan.layers.map((layer) => [layer.name, suggestedRole(layer.name)]));
    this.unit = plan.suggestedUnit;
    this.around = 25;
    this.ruler = null;
    this.app.store.set({ message: null });
    this.open();
  }

  protected override closed(): void {
    this.plan = null;
    this.reader?.close();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (this.plan && (["plan", "roles", "unit", "around"] as const).some((key) => changed.has(key)))
      void this.convert(this.plan);
  }

  protected override content(): TemplateResult {
    const { plan, roles, unit, lit, ruler, made } = this,
      { lang } = this.state,
      isOpenable = made !== null && "scene" in made && !this.isConverting;
    if (!plan) return html``;
    return html`${this.top(say(lang, "title"), this.name)}
      <div class="scroll"><form novalidate aria-busy=${this.isConverting} @submit=${this.accept}>
        <parkade-site-plan-preview .app=${this.app} .plan=${plan} .roles=${roles} .unit=${unit} .lit=${lit}
          .ruler=${ruler} .scene=${made && "scene" in made ? made.scene : null}
          label=${say(lang, "preview")} @ruler=${(event: CustomEvent<[Point, Point]>) => {
            this.ruler = event.detail;
          }}></parkade-site-plan-preview>
        <div class="side"><h3 id="layers">${say(lang, "layers")}</h3>
          <ul aria-labelledby="layers">${plan.layers.map(({ name, ends }) => this.layer(name, ends.length))}</ul>
          ${plan.kind === "geojson" || plan.kind === "osm" ? nothing : this.scale(plan)}
          ${this.field("around", this.around, "m", (value) => {
            this.around = value;
          })}
          ${(made && "notes" in made ? made : plan).notes.map((note) => html`<p>${reasonIn(lang, sentence(note))}</p>`)}
          ${this.answer()}
          <button class="button solid" ?disabled=${!isOpenable}>${say(lang, "open")}</button></div></form></div>`;
  }

  /** What would open, or why nothing does. */
  private answer(): TemplateResult {
    const { made } = this,
      { lang } = this.state;
    if (!made || this.isSlow) return html`<p aria-live="polite">${this.isSlow ? say(lang, "converting") : nothing}</p>`;
    return "reason" in made
      ? html`<p class="fault" role="alert">${reasonIn(lang, made.reason)}</p>`
      : html`<p aria-live="polite">${say(lang, "found", made.counts)} ${this.size(made)}</p>`;
  }

  private layer(name: string, lines: number): TemplateResult {
    const { lang } = this.state,
      light = (to: string) => () => {
        this.lit = to;
      };
    return html`<li @pointerenter=${light(name)}
      @pointerleave=${light("")}><span title=${name}>${withoutReference(name)}
      <small>${say(lang, "count", { n: lines })}</small></span>
      <select aria-label=${say(lang, "role", { layer: name })} @focus=${light(name)} @blur=${light("")} @change=${(
        event: Event,
      ) => {
        this.roles = { ...this.roles, [name]: chosenOf(event, ROLES) };
      }}>${ROLES.map(
        (role) =>
          html`<option value=${role} .selected=${role === this.roles[name]}
            ?selected=${role === this.roles[name]}>${say(lang, role)}</option>`,
      )}</select></li>`;
  }

  private scale(plan: PlanOutline): TemplateResult {
    const { lang } = this.state,
      { ruler, unit } = this;
    const drawn = ruler && distance(...ruler) > 0 ? distance(...ruler) : null;
    return html`${this.field("unit", unit, "m", (value) => {
      this.unit = value;
    })}${this.guess(plan)}
      ${
        drawn
          ? this.field("distance", Number((drawn * unit).toPrecision(4)), "m", (value) => {
              this.unit = value / drawn;
            })
          : html`<p>${say(lang, "ruler")}</p>`
      }<p>${this.across(plan)}</p>`;
  }

  /** Where the unit is not the file's, which nobody would see in its field. */
  private guess(plan: PlanOutline): TemplateResult | typeof nothing {
    const { lang } = this.state,
      { metresPerUnit, box } = plan;
    if (this.unit !== plan.suggestedUnit || this.unit === metresPerUnit) return nothing;
    const words =
      metresPerUnit === null
        ? say(lang, "unitUnknown")
        : say(lang, "unitReplaced", {
            metres: this.num(Math.max(box.maxX - box.minX, box.maxY - box.minY) * metresPerUnit, 2),
          });
    return html`<p class="guess">${words}</p>`;
  }

  private field(
    key: "unit" | "around" | "distance",
    value: number,
    unit: string,
    set: (value: number) => void,
  ): TemplateResult {
    return html`<label>${say(this.state.lang, key)}<span class="field"><input type="number" min="0" step="any"
      .value=${String(value)} @change=${(event: Event) => set(numberOf(event))}><span>${unit}</span></span></label>`;
  }

  private across({ box }: PlanOutline): string {
    const metres = (units: number): string => this.num(units * this.unit, 1);
    return say(this.state.lang, "across", { width: metres(box.maxX - box.minX), height: metres(box.maxY - box.minY) });
  }

  private size({ scene: { map } }: SitePlanScene): string {
    return say(this.state.lang, "across", {
      width: this.num(map.width * map.resolution, 0),
      height: this.num(map.height * map.resolution, 0),
    });
  }

  /** Makes the scene of what is chosen now, and once more of what was chosen meanwhile. */
  private async convert(plan: PlanOutline): Promise<void> {
    this.isOutdated = true;
    if (this.isConverting) return;
    this.isConverting = true;
    const timer = setTimeout(() => {
      this.isSlow = true;
    }, SLOW);
    while (this.isOutdated && this.plan === plan) {
      this.isOutdated = false;
      this.made = await this.converted();
    }
    clearTimeout(timer);
    this.isConverting = this.isSlow = false;
    if (this.plan && this.plan !== plan) void this.convert(this.plan);
  }

  /** The scene, or why there is none. */
  private async converted(): Promise<Made | { reason: Said }> {
    const { roles, unit, around } = this;
    if (Object.values(roles).every((role) => role === "none"))
      return { reason: { message: say(this.state.lang, "choose") } };
    try {
      const made = await this.reader!.scene({
        roles,
        metresPerUnit: unit,
        around,
        name: this.name.replace(/\.\w+$/, ""),
      });
      const scene = ensureIds(made.scene);
      this.app.catalog?.geometry(scene);
      return { ...made, scene };
    } catch (error) {
      if (error instanceof Error) return { reason: refusal(error) };
      throw error;
    }
  }

  private async accept(event: Event): Promise<void> {
    event.preventDefault();
    const { made } = this;
    if (!made || !("scene" in made) || this.isConverting) return;
    await (await vast.load()).prepare(made.scene, this.app.tokens());
    void this.app.links.mark();
    this.app.preset = null;
    this.app.openScene(made.scene);
    this.close();
  }
}

/** DXF names layers of a referenced drawing "drawing$0$layer": the layer alone fits the list. */
const withoutReference = (name: string): string => name.replace(/^.*\$\d+\$/, "");

customElements.define("parkade-site-plan", SitePlanDialog);
