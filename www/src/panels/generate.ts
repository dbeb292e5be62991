import type { Family } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import messages from "../i18n/messages/generate.json";
import { translator } from "../i18n/translator";
import { Helper, joined } from "../planning/job-client";
import { ensureIds } from "../scene/model";
import type { Scene, State } from "../store";
import { controls } from "../styles/controls";
import { vast } from "../view/lazy-large-maps";
import { AppElement } from "./base";
import { valueOf } from "./inputs";
import { icon } from "../styles/icons";
import "./thumbnail";
import { keysOf } from "../scene/records";
import { apart } from "../app/refusals";
import { reasonIn } from "../i18n/index";
import type { Said } from "../i18n/said";

const say = translator("generate", messages);

type Field = "size" | "seed" | "densityPermille" | "blockMin" | "blockMax";
const FAMILIES = ["random", "regular", "trap"] as const;
const ONLY_RANDOM: readonly Field[] = ["densityPermille", "blockMin", "blockMax"];
/** Larger maps are not drawn before they are opened. */
const MOST_PREVIEWED = 400;
const TYPING_MS = 250;

/** A form for the seeded families of maps, with a picture of what would open. */
export class Generate extends AppElement {
  static override properties = {
    ...AppElement.properties,
    family: { state: true },
    values: { state: true },
    fault: { state: true },
    drawn: { state: true },
  };
  static override styles = [
    controls,
    css`
    :host { display: block; }
    form {
      display: grid; grid-template-columns: minmax(160px, 250px) 1fr; gap: 14px 16px;
      border: 1px solid var(--parkade-hair2); border-radius: calc(10px * var(--parkade-radius)); overflow: hidden;
      background: var(--parkade-panel);
    }
    .picture {
      min-height: 168px; display: grid; background: var(--parkade-out); border-right: 1px solid var(--parkade-hair);
    }
    .explanation {
      padding: 12px 14px 12px 0; display: grid; gap: 10px; align-content: start; justify-items: start; min-width: 0;
    }
    h3 { margin: 0; font: inherit; font-weight: 600; }
    p { margin: 0; color: var(--parkade-t2); font-size: 12.5px; line-height: 17px; }
    .fields { display: flex; flex-wrap: wrap; gap: 8px 14px; }
    label { display: flex; align-items: center; gap: 6px; color: var(--parkade-t2); }
    .field { width: 92px; color: var(--parkade-t1); }
    .bad { border-color: var(--parkade-err); box-shadow: inset 0 0 0 1px var(--parkade-err); }
    .fault {
      color: var(--parkade-err); display: flex; gap: 6px; align-items: center; min-height: 18px;
      overflow-wrap: anywhere;
    }
    .seed { display: flex; align-items: center; gap: 2px; }
    @media (max-width: 640px) {
      form { grid-template-columns: 1fr; gap: 0; }
      .picture { min-height: 140px; border-right: 0; border-bottom: 1px solid var(--parkade-hair); }
      .explanation { padding: 12px; }
    }
  `,
  ];
  declare family: (typeof FAMILIES)[number];
  declare values: Record<Field, string>;
  declare fault: { path: string; rule: Said } | null;
  declare drawn: Scene | null;
  private helper: Helper | null = null;
  private turn = 0;
  private typing: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    this.family = "random";
    this.values = { size: "100", seed: "1", densityPermille: "150", blockMin: "1", blockMax: "3" };
    this.fault = null;
    this.drawn = null;
  }

  protected watches(): readonly (keyof State)[] {
    return [];
  }

  protected override firstUpdated(): void {
    void this.draw();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.typing);
    this.helper?.stop();
    this.helper = null;
  }

  protected override render(): TemplateResult {
    const { lang } = this.state;
    const random = this.family === "random";
    return html`<form novalidate aria-labelledby="heading" @submit=${this.submit}>
      <div class="picture">${
        this.drawn ? html`<parkade-thumbnail .app=${this.app} .scene=${this.drawn} whole></parkade-thumbnail>` : nothing
      }</div>
      <div class="explanation"><h3 id="heading">${say(lang, "title")}</h3><p>${say(lang, "lead")}</p>
        <div class="segmented" role="group" aria-label=${say(lang, "family")}>${FAMILIES.map(
          (one) => html`
          <button type="button" aria-pressed=${one === this.family} @click=${() => {
            this.family = one;
            void this.draw();
          }}>${say(lang, one)}</button>`,
        )}</div>
        <div class="fields">${this.field("size")}
          <span class="seed">${this.field("seed")}<button type="button" class="icon small"
            aria-label=${say(lang, "nextSeed")} title=${say(lang, "nextSeed")}
            @click=${this.nextSeed}>${icon("next")}</button></span></div>
        ${
          random
            ? html`<div class="fields">${this.field("densityPermille", "‰")}${this.field("blockMin")}${this.field(
                "blockMax",
                say(lang, "cells"),
              )}</div>`
            : nothing
        }
        <div class="fault" role="alert" id="fault">${
          this.fault ? html`${icon("warning", 14)}<span>${this.faultText()}</span>` : nothing
        }</div>
        <button class="button solid">${say(lang, "open")}</button></div></form>`;
  }

  private field(name: Field, unit = ""): TemplateResult {
    const bad = this.fault?.path === name;
    return html`<label>${say(this.state.lang, name)}<span class="field ${bad ? "bad" : ""}"><input inputmode="numeric"
      name=${name} .value=${this.values[name]} aria-invalid=${bad} aria-describedby=${bad ? "fault" : nothing}
      @input=${(e: Event) => this.type(name, valueOf(e))}>${
        unit ? html`<span>${unit}</span>` : nothing
      }</span></label>`;
  }

  private faultText(): string {
    if (!this.fault) return "";
    const { path, rule } = this.fault,
      { lang } = this.state,
      name = keysOf(this.values).find((field) => field === path);
    return name
      ? `${say(lang, name)}${lang === "zh" ? "：" : ": "}${reasonIn(lang, rule)}`
      : say(lang, "failed", { reason: rule });
  }

  private type(name: Field, value: string): void {
    this.values = { ...this.values, [name]: value };
    clearTimeout(this.typing);
    this.typing = setTimeout(() => void this.draw(), TYPING_MS);
  }

  private readonly nextSeed = (): void => {
    const seed = Number(this.values.seed);
    this.values = { ...this.values, seed: String(Number.isSafeInteger(seed) ? seed + 1 : 1) };
    void this.draw();
  };

  /** Numbers as they were typed: what is none is refused by name. */
  private asked(): Family {
    const number = (text: string): unknown =>
      text.trim() !== "" && Number.isFinite(Number(text)) ? Number(text) : text;
    const names = keysOf(this.values).filter((name) => this.family === "random" || !ONLY_RANDOM.includes(name));
    return {
      family: this.family,
      ...Object.fromEntries(names.map((name) => [name, number(this.values[name])])),
    } as Family;
  }

  private async draw(): Promise<void> {
    const scene = Number(this.values.size) <= MOST_PREVIEWED || !Number(this.values.size) ? await this.make() : null;
    if (scene !== undefined) this.drawn = scene;
  }

  /** Undefined when something else is asked meanwhile, null where the numbers make no map. */
  private async make(): Promise<Scene | null | undefined> {
    const turn = ++this.turn;
    try {
      this.helper ??= new Helper(await this.app.complete());
      const moved = await this.helper.call("generate", this.asked());
      const [scene] = await joined(moved, moved.value);
      if (turn !== this.turn) return undefined;
      this.fault = null;
      return ensureIds(scene!);
    } catch (error) {
      if (turn !== this.turn) return undefined;
      this.fault = apart(error);
      return null;
    }
  }

  private readonly submit = async (event: Event): Promise<void> => {
    event.preventDefault();
    clearTimeout(this.typing);
    const scene = await this.make();
    if (!scene) return;
    await (await vast.load()).prepare(scene, this.app.tokens());
    void this.app.links.mark();
    this.app.preset = null;
    this.app.openScene(scene);
    this.dispatchEvent(new CustomEvent("opened", { bubbles: true }));
  };
}

customElements.define("parkade-generate", Generate);
