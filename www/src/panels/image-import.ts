import { css, html, nothing, type TemplateResult } from "lit";
import { sentence } from "../app/app";
import messages from "../i18n/messages/image-import.json";
import { translator } from "../i18n/translator";
import { imageMap, MOST_CELLS, type ImageMap, type ImageOptions, type Pixels } from "../scene/image";
import { pixelsOf } from "../scene/image-decode";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { vast } from "../view/lazy-large-maps";
import { DialogElement } from "./dialog";
import { isChecked, numberOf, type On } from "./inputs";

const say = translator("imageImport", messages);

/** Asks how a picture is to be read, and shows the map that comes of it. */
export class ImageDialog extends DialogElement {
  static override properties = {
    ...DialogElement.properties,
    name: { state: true },
    pixels: { state: true },
    options: { state: true },
  };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 720px; }
    .split { display: grid; grid-template-columns: minmax(0, 1fr) 250px; gap: 18px; }
    .picture {
      min-height: 240px; max-height: 420px; display: grid; place-items: center; background: var(--parkade-out);
      border-radius: calc(8px * var(--parkade-radius)); overflow: hidden;
    }
    canvas { width: 100%; height: 100%; max-height: 420px; object-fit: contain; image-rendering: pixelated; }
    label { display: grid; gap: 4px; color: var(--parkade-t2); margin-bottom: 12px; }
    .check { display: flex; align-items: center; gap: 8px; }
    .field { width: 120px; color: var(--parkade-t1); } output { float: right; color: var(--parkade-t1); }
    p { margin: 0 0 12px; color: var(--parkade-t2); font-size: 12px; line-height: 16px; }
    .warn { color: var(--parkade-warn); }
    input[type="checkbox"] { accent-color: var(--parkade-accent); margin: 0; } .solid { width: 100%; }
    @media (max-width: 640px) {
      .split { grid-template-columns: 1fr; }
      .picture { min-height: 160px; max-height: 240px; }
      canvas { max-height: 240px; }
    }
  `,
  ];
  declare name: string;
  declare pixels: Pixels | null;
  declare options: ImageOptions;
  private made: ImageMap | null = null;

  protected override readonly closesOutside = false;

  constructor() {
    super();
    this.name = "";
    this.pixels = null;
    this.options = { threshold: 128, invert: false, perCell: 1, metres: 0.05 };
  }

  async ask(file: File): Promise<void> {
    try {
      this.pixels = await pixelsOf(file, this.state.lang);
    } catch (error) {
      this.app.store.set({
        message: { tone: "err", text: say(this.state.lang, "broken", { name: file.name, reason: sentence(error) }) },
      });
      return;
    }
    this.name = file.name;
    const longer = Math.max(this.pixels.width, this.pixels.height);
    this.options = {
      threshold: 128,
      invert: false,
      perCell: Math.max(1, Math.ceil(longer / 512)),
      metres: Number((40 / longer).toPrecision(2)),
    };
    this.app.store.set({ message: null });
    this.open();
  }

  protected override closed(): void {
    this.pixels = null;
  }

  protected override content(): TemplateResult {
    const { lang } = this.state,
      { options } = this,
      bad = !(options.metres > 0 && options.metres <= 100);
    this.made = this.pixels && !bad ? imageMap(this.pixels, options, this.name.replace(/\.\w+$/, "")) : null;
    return html`${this.top(say(lang, "title"), this.name)}
      <form class="scroll split" novalidate @submit=${this.accept}>
        <div class="picture"><canvas role="img" aria-label=${say(lang, "preview")}></canvas></div>
        <div>
          <label><span>${say(lang, "threshold")}<output>${options.threshold}</output></span>
            <input class="slider" type="range" min="1" max="255" .value=${String(options.threshold)}
              .style=${`--at: ${(options.threshold / 255) * 100}%`}
              @input=${(e: Event) => this.set({ threshold: numberOf(e) })}></label>
          <label class="check"><input type="checkbox" .checked=${options.invert}
            @change=${(e: Event) => this.set({ invert: isChecked(e) })}>${say(lang, "invertOn")}</label>
          <label>${say(lang, "metres")}<span class="field"><input type="number" min="0.001" max="100" step="0.01"
            .value=${String(options.metres)} aria-invalid=${bad}
            @input=${(e: Event) => this.set({ metres: numberOf(e) })}><span>m</span></span></label>
          <label>${say(lang, "perCell")}<span class="field"><input type="number" min="1" max="64" step="1"
            .value=${String(options.perCell)} @change=${this.coarsen}></span></label>
          ${bad ? html`<p class="warn" role="alert">${say(lang, "bad")}</p>` : this.summary()}
          <button class="button solid" ?disabled=${bad}>${say(lang, "open")}</button>
        </div></form>`;
  }

  private summary(): TemplateResult | typeof nothing {
    const {
      made,
      state: { lang },
    } = this;
    if (!made) return nothing;
    const { width, height, resolution } = made.scene.map;
    const text = say(lang, "size", {
      width,
      height,
      side: Number(resolution.toPrecision(3)),
      across: this.num(width * resolution, 1),
      up: this.num(height * resolution, 1),
      share: this.num((100 * made.blocked) / made.cells, 0),
    });
    return html`<p aria-live="polite">${text}</p>${
      made.roomy ? nothing : html`<p class="warn">${say(lang, "tight")}</p>`
    }`;
  }

  protected override updated(): void {
    const canvas = this.renderRoot.querySelector("canvas"),
      scene = this.made?.scene;
    if (!canvas || !scene) return;
    const {
        map: { width, height },
      } = scene,
      { colour } = this.app.tokens();
    canvas.width = width;
    canvas.height = height;
    const ctx = canvas.getContext("2d")!;
    ctx.fillStyle = colour.floor;
    ctx.fillRect(0, 0, width, height);
    ctx.fillStyle = colour["obs-edge"];
    for (const one of scene.obstacles ?? [])
      if (one.type === "cells") for (const [x, y, count] of one.runs) ctx.fillRect(x, height - 1 - y, count, 1);
  }

  /** A cell is at least one pixel, and a map at most so many cells wide. */
  private readonly coarsen = (event: On<HTMLInputElement>): void => {
    const { pixels } = this,
      typed = Math.round(numberOf(event));
    const least = pixels ? Math.ceil(Math.max(pixels.width, pixels.height) / MOST_CELLS) : 1;
    if (Number.isFinite(typed) && typed >= least && typed <= 64) this.set({ perCell: typed });
    event.currentTarget.value = String(this.options.perCell);
  };

  private set(patch: Partial<ImageOptions>): void {
    this.options = { ...this.options, ...patch };
  }

  private readonly accept = async (event: Event): Promise<void> => {
    event.preventDefault();
    const { made } = this;
    if (!made) return;
    await (await vast.load()).prepare(made.scene, this.app.tokens());
    void this.app.links.mark();
    this.app.preset = null;
    this.app.openScene(made.scene);
    this.close();
  };
}

customElements.define("parkade-image", ImageDialog);
