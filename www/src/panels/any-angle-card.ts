import { css, html, nothing, type TemplateResult } from "lit";
import { translatorAt } from "../i18n/translator";
import { Helper } from "../planning/job-client";
import type { Scene, State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { AppElement } from "./base";
import { messageOf } from "../i18n/said";

const say = translatorAt("yardstick");

/** Cells of the largest map that is measured: some seconds. */
const MOST = 40_000;

/** How much longer a grid planner's path is than any over cell centres must be. */
export class AnyAngleCard extends AppElement {
  static override styles = [
    controls,
    sections,
    css`
    h2 + button, h2 + output { margin-left: auto; white-space: nowrap; }
    p { margin-top: 4px; }
  `,
  ];
  private helper: Helper | null = null;
  /** The scene and planner that were asked about, and metres; undefined while they are measured. */
  private asked: { scene: Scene; planner: string; metres: number | null | undefined } | null = null;

  protected watches(): readonly (keyof State)[] {
    return ["focus", "scene", "results"];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.helper?.stop();
    this.helper = null;
    this.asked = null;
  }

  protected override render(): TemplateResult | typeof nothing {
    const { focus, lang, scene, results } = this.state;
    this.hidden = this.app.catalog?.planners.find((one) => one.id === focus)?.family !== "grid";
    if (this.hidden) return nothing;
    const asked = this.asked?.scene === scene && this.asked.planner === focus ? this.asked : null;
    const large = scene.map.width * scene.map.height > MOST;
    const plan = results[focus]?.plan,
      found = plan?.outcome === "found" ? plan.metrics.length : null;
    const metres = asked?.metres;
    return html`<div class="head"><h2>${say(lang, "title")}</h2>
      ${
        typeof metres === "number"
          ? html`<output>${this.num(metres, 2)} m</output>`
          : html`<button class="link" ?disabled=${large || asked !== null}
            @click=${() => void this.measure()}>${say(
              lang,
              asked && metres === undefined ? "measuring" : "measure",
            )}</button>`
      }</div>
      ${large ? html`<p>${say(lang, "large", { n: this.num(MOST, 0) })}</p>` : nothing}
      ${metres === null ? html`<p>${say(lang, "none")}</p>` : nothing}
      ${
        metres && found !== null
          ? html`<p>${say(lang, "path", {
              share: `${found < metres ? "−" : "+"}${this.num(Math.abs(found / metres - 1) * 100, 1)}`,
            })}</p>`
          : nothing
      }
      <p>${say(lang, "doc")}</p>`;
  }

  private async measure(): Promise<void> {
    const { focus: planner, scene } = this.state;
    const asked: NonNullable<AnyAngleCard["asked"]> = { scene, planner, metres: undefined };
    this.asked = asked;
    this.requestUpdate();
    try {
      this.helper ??= new Helper(await this.app.complete());
      asked.metres = await this.helper.call("anyAngle", { planner, scene });
    } catch (error) {
      if (this.asked === asked) this.asked = null;
      this.app.store.set({ message: { tone: "err", text: messageOf(error) } });
    }
    this.requestUpdate();
  }
}

customElements.define("parkade-any-angle", AnyAngleCard);
