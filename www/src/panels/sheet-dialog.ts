import type { Plan } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import { download, refusal, type App } from "../app/app";
import { dxfOf } from "../picture/dxf-file";
import { boxOfDrawing, paperFor, printPage, SCALES, sheetSvg, type Paper } from "../picture/scale-sheet";
import { DRAWING_LAYERS, siteDrawing, type DrawingLayer } from "../picture/site-drawing";
import { fileName } from "../scene/files";
import { focusedPlan } from "../store/results";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { DialogElement } from "./dialog";
import { isChecked, numberOf, valueOf } from "./inputs";
import { say, today, vehicleText } from "./sheet-messages";
import { wayCsv } from "./way-csv";
import { besideOf } from "./beside";
import { reasonIn } from "../i18n/index";
import { sceneTitle } from "../app/scene-title";

type Format = "svg" | "print" | "dxf" | "csv";

/** Asks for scale and layers of a drawing of the scene and the focused manoeuvre, and saves it. */
export class SheetDialog extends DialogElement {
  static override properties = {
    ...DialogElement.properties,
    scale: { state: true },
    every: { state: true },
    chosen: { state: true },
  };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 940px; }
    .split { display: grid; grid-template-columns: minmax(0, 1fr) 260px; gap: 18px; }
    .sheet { min-width: 0; background: #fff; border: 1px solid var(--parkade-hair2); align-self: start; }
    .sheet svg { display: block; width: 100%; height: auto; }
    .side { display: grid; gap: 8px; align-content: start; }
    label { display: flex; align-items: center; justify-content: space-between; gap: 8px; color: var(--parkade-t2); }
    .check { justify-content: start; min-height: 24px; color: var(--parkade-t1); }
    .check input { accent-color: var(--parkade-accent); margin: 0; }
    .field { width: 96px; color: var(--parkade-t1); }
    select {
      height: 28px; padding: 0 6px; color: var(--parkade-t1); background: var(--parkade-panel);
      border: 1px solid var(--parkade-hair2); border-radius: calc(6px * var(--parkade-radius));
    }
    .files { display: grid; grid-template-columns: 1fr 1fr; gap: 6px; }
    p { margin: 0; }
    .fault { color: var(--parkade-err); }
    @media (max-width: 640px) { .split { grid-template-columns: minmax(0, 1fr); } }
  `,
  ];
  declare scale: number;
  /** Metres from outline to outline. */
  declare every: number;
  declare chosen: ReadonlySet<DrawingLayer>;

  constructor() {
    super();
    this.scale = 100;
    this.every = 2;
    this.chosen = new Set(DRAWING_LAYERS);
  }

  override open(): void {
    const box = boxOfDrawing(siteDrawing(this.state.scene, null, { every: 0 }));
    this.scale = SCALES.find((scale) => scale >= 100 && paperFor(box, scale) === "A4") ?? 200;
    super.open();
  }

  /** The focused planner's path, where a car drives it. */
  private get plan(): Plan | null {
    const plan = focusedPlan(this.state);
    return plan && plan.outcome === "found" ? plan : null;
  }

  protected override content(): TemplateResult {
    const { lang } = this.state,
      made = this.made();
    const layers = DRAWING_LAYERS.filter(
      (layer) => this.plan || ["ground", "bays", "obstacles", "parked"].includes(layer),
    );
    return html`${this.top(
      say(lang, "title"),
      "paper" in made ? say(lang, "lead", { paper: made.paper, scale: this.scale }) : nothing,
    )}
      <div class="scroll split"><div class="sheet">${
        "svg" in made ? unsafeHTML(made.svg) : html`<p class="fault" role="alert">${made.reason}</p>`
      }</div>
      <div class="side">
        <label>${say(lang, "scale")}<select @change=${(event: Event) => {
          this.scale = Number(valueOf(event));
        }}>${SCALES.map(
          (scale) => html`<option value=${scale} ?selected=${scale === this.scale}>1:${scale}</option>`,
        )}</select></label>
        ${
          this.plan
            ? html`<label>${say(lang, "every")}<span class="field"><input type="number" min="0.5" max="50" step="0.5"
              .value=${String(this.every)} @change=${(event: Event) => {
                const typed = numberOf(event);
                if (typed >= 0.5 && typed <= 50) this.every = typed;
              }}><span>m</span></span></label>`
            : nothing
        }
        ${layers.map(
          (layer) =>
            html`<label class="check"><input type="checkbox" .checked=${this.chosen.has(layer)}
              @change=${(event: Event) => this.show(layer, isChecked(event))}>${say(lang, layer)}</label>`,
        )}
        <div class="files">${(["print", "svg", "dxf", "csv"] as const).map(
          (format) =>
            html`<button class="button outline" ?disabled=${
              (format === "csv" && !this.plan) || ("reason" in made && format !== "dxf")
            } @click=${() => this.save(format)}>${say(lang, format)}</button>`,
        )}</div>
      </div></div>`;
  }

  private show(layer: DrawingLayer, shown: boolean): void {
    this.chosen = new Set(DRAWING_LAYERS.filter((one) => (one === layer ? shown : this.chosen.has(one))));
  }

  private made(): { svg: string; paper: Paper } | { reason: string } {
    const { scene, lang } = this.state,
      { plan } = this;
    const manoeuvre =
      plan &&
      say(lang, "planText", {
        length: this.num(plan.metrics.length, 2),
        moves: plan.metrics.directionChanges + 1,
        clearance: this.num(plan.metrics.minClearance, 2),
      });
    try {
      return sheetSvg({
        drawing: siteDrawing(scene, plan, { every: this.every }),
        shown: this.chosen,
        areas: [],
        scale: this.scale,
        title: sceneTitle(this.app) || say(lang, "scene"),
        rows: [
          [say(lang, "scale"), `1:${this.scale}`],
          [say(lang, "vehicle"), vehicleText(lang, scene.vehicle)],
          ...(manoeuvre ? [[say(lang, "plan"), manoeuvre] as const] : []),
          [say(lang, "date"), today(lang)],
          ...(plan ? [[say(lang, "hash"), plan.hash] as const] : []),
        ],
        legend: [],
      });
    } catch (error) {
      return { reason: reasonIn(lang, refusal(error)) };
    }
  }

  private save(format: Format): void {
    const { scene, lang } = this.state,
      { plan } = this,
      name = fileName(scene);
    const made = this.made(),
      drawing = siteDrawing(scene, plan, { every: this.every });
    if (format === "dxf") download(new Blob([dxfOf(drawing, this.chosen)], { type: "image/vnd.dxf" }), `${name}.dxf`);
    else if (format === "csv" && plan)
      download(new Blob([wayCsv(plan, this.every)], { type: "text/csv" }), `${name}-way.csv`);
    else if ("svg" in made && format === "svg")
      download(new Blob([made.svg], { type: "image/svg+xml" }), `${name}-1-${this.scale}.svg`);
    else if ("svg" in made)
      download(
        new Blob([printPage(sceneTitle(this.app) || name, lang === "zh" ? "zh-CN" : "en", made, "")], {
          type: "text/html",
        }),
        `${name}-1-${this.scale}.html`,
      );
  }
}

customElements.define("parkade-sheet-dialog", SheetDialog);

/** Opens the dialog beside a piece of its playground. */
export function openSheet(app: App, piece: HTMLElement): void {
  besideOf(SheetDialog, app, piece).open();
}
