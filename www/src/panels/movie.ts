import { css, html, LitElement, nothing, type TemplateResult } from "lit";
import { download, refusal, type App } from "../app/app";
import { canEncode, encode } from "../picture/movie";
import { FORMATS, type Format } from "../picture/movie-format";
import { played } from "../store/results";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { plannerName } from "../styles/planner-style";
import { tokens } from "../styles/tokens";
import { fit, fitMap } from "../view/camera";
import { makeFrame, type Shown } from "../view/frame";
import { laterLayers } from "../view/lazy-layers";
import { SceneLayers } from "../view/scene-layers";
import { readTokens, type Tokens } from "../view/tokens";
import { DialogElement } from "./dialog";
import { numberOf, type On } from "./inputs";
import { say } from "./movie-messages";
import { besideOf } from "./beside";
import { nth } from "../scene/nth";
import { reasonIn } from "../i18n/index";

const WIDTHS = [480, 640, 960, 1280] as const;
const RATES = [10, 15, 25] as const;
const ASPECT = 5 / 8;
const LONGEST_S = 60;

/** An element without content that has the colours of a theme. */
class Themed extends LitElement {
  static override styles = tokens;
}
customElements.define("parkade-themed", Themed);

/** Saves the search or the drive as a moving picture. */
export class MovieDialog extends DialogElement {
  static override properties = {
    ...DialogElement.properties,
    options: { state: true },
    done: { state: true },
    note: { state: true },
    known: { state: true },
  };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 440px; }
    form { padding: 4px 24px 20px; }
    .row { display: flex; align-items: center; justify-content: space-between; gap: 12px; min-height: 40px; }
    select {
      appearance: none; height: 28px; padding: 0 8px; border: 1px solid var(--parkade-hair2);
      border-radius: calc(6px * var(--parkade-radius)); background: var(--parkade-panel); max-width: 60%;
    }
    .field { width: 90px; }
    footer { display: flex; align-items: center; gap: 12px; margin-top: 10px; }
    footer p { flex: 1; margin: 0; color: var(--parkade-t2); }
    progress { width: 100%; height: 4px; margin-top: 10px; accent-color: var(--parkade-accent); }
    @media (pointer: coarse) { select, .field { height: 44px; } }
  `,
  ];
  declare options: {
    format: Format;
    base: "search" | "drive";
    width: (typeof WIDTHS)[number];
    rate: (typeof RATES)[number];
    seconds: number;
    theme: "light" | "dark";
    all: boolean;
  };
  /** Share that is drawn; null where nothing is being made. */
  declare done: number | null;
  declare note: string;
  /** Formats that this browser makes. */
  declare known: ReadonlySet<Format>;
  private isStopped = false;

  constructor() {
    super();
    this.done = null;
    this.note = "";
    this.known = new Set(["gif"]);
    this.options = { format: "gif", base: "drive", width: 640, rate: 15, seconds: 10, theme: "light", all: true };
  }

  override open(): void {
    this.options = {
      ...this.options,
      base: this.state.playback.base,
      theme: this.app.tokens().dark ? "dark" : "light",
    };
    this.note = "";
    for (const format of FORMATS)
      void canEncode(format).then(
        (can) => {
          if (can) this.known = new Set([...this.known, format]);
        },
        () => undefined,
      );
    super.open();
  }

  protected override content(): TemplateResult {
    const { lang, focus } = this.state,
      { options } = this;
    const set = (patch: Partial<typeof options>): void => {
      this.options = { ...this.options, ...patch };
    };
    const choice = <T extends string | number>(
      key: "format" | "shows" | "width" | "rate" | "theme" | "who",
      values: readonly T[],
      now: T,
      name: (value: T) => string,
      take: (value: T) => void,
      isOff: (value: T) => boolean = () => false,
    ): TemplateResult =>
      html`<label class="row">${say(lang, key)}<select @change=${({ currentTarget }: On<HTMLSelectElement>) =>
        take(nth(values, currentTarget.selectedIndex))}>${values.map(
        (value) =>
          html`<option value=${value} ?selected=${value === now} ?disabled=${isOff(value)}>${name(value)}</option>`,
      )}</select></label>`;
    return html`${this.top(say(lang, "title"))}<form @submit=${this.save}>
      ${choice(
        "format",
        FORMATS,
        options.format,
        (one) => (this.known.has(one) ? say(lang, one) : say(lang, "unsupported", { format: say(lang, one) })),
        (format) => set({ format }),
        (one) => !this.known.has(one),
      )}
      ${choice(
        "shows",
        ["drive", "search"] as const,
        options.base,
        (one) => say(lang, one),
        (base) => set({ base }),
      )}
      ${choice(
        "who",
        ["all", "front"] as const,
        options.all ? "all" : "front",
        (one) => say(lang, one, { planner: plannerName(lang, focus) }),
        (one) => set({ all: one === "all" }),
      )}
      ${choice("width", WIDTHS, options.width, String, (width) => set({ width }))}
      ${choice("rate", RATES, options.rate, String, (rate) => set({ rate }))}
      ${choice(
        "theme",
        ["light", "dark"] as const,
        options.theme,
        (one) => say(lang, one),
        (theme) => set({ theme }),
      )}
      <label class="row">${say(lang, "seconds")}<span class="field"><input type="number" min="1" max=${LONGEST_S}
        step="1" .value=${String(options.seconds)}
        @change=${(e: Event) => set({ seconds: Math.min(LONGEST_S, Math.max(1, numberOf(e) || 10)) })}></span></label>
      ${this.done === null ? nothing : html`<progress max="1" .value=${this.done}></progress>`}
      <footer><p role="status">${
        this.done === null ? this.note : say(lang, "progress", { percent: Math.floor(100 * this.done) })
      }</p>
        ${
          this.done === null
            ? html`<button class="button solid">${say(lang, "save")}</button>`
            : html`<button type="button" class="button outline" @click=${this.cancel}>${say(lang, "stop")}</button>`
        }</footer></form>`;
  }

  private readonly cancel = (): void => {
    this.isStopped = true;
  };

  protected override closed(): void {
    this.cancel();
  }

  private readonly save = async (event: Event): Promise<void> => {
    event.preventDefault();
    if (this.done !== null) return;
    const { lang } = this.state,
      { format } = this.options,
      from = performance.now();
    this.isStopped = false;
    this.done = 0;
    try {
      const blob = await this.make();
      if (blob) {
        download(blob, `parkade-${this.options.base}.${format}`);
        this.note = say(lang, "done", {
          mb: this.num(blob.size / 1e6, 2),
          seconds: this.num((performance.now() - from) / 1000, 1),
        });
      } else this.note = say(lang, "stopped");
    } catch (error) {
      this.note = reasonIn(this.state.lang, refusal(error));
    } finally {
      this.done = null;
    }
  };

  /** Draws the scene as it is now, whatever happens on the page meanwhile. */
  async make(): Promise<Blob | null> {
    const { state } = this,
      { format, rate, seconds, width, base } = this.options;
    await laterLayers.load();
    const height = 2 * Math.round((width * ASPECT) / 2),
      frames = Math.max(2, Math.round(seconds * rate));
    const colours = await this.colours();
    const layers = new SceneLayers();
    const shown = this.answers(state);
    const camera =
      state.camera && state.mode !== "grid"
        ? fitMap(state.scene, width, height)
        : fit(state.scene, state.geometry, width, height);
    return encode(
      {
        format,
        width,
        height,
        frames,
        rate,
        draw: (canvas, i) => {
          const playback = { ...state.playback, base, fraction: i / (frames - 1), playing: false };
          const drawn: State = {
            ...state,
            playback,
            hover: null,
            selection: null,
            searchSteps: null,
            ...(base === "search" && { layers: { ...state.layers, heat: true, tree: true } }),
          };
          const ctx = canvas.getContext("2d")!;
          ctx.setTransform(1, 0, 0, 1, 0, 0);
          layers.draw(
            makeFrame({
              ctx,
              view: { camera, width, height },
              ratio: 1,
              state: drawn,
              tokens: colours,
              shown,
              draft: null,
            }),
          );
        },
      },
      (done) => {
        this.done = done;
        return !this.isStopped;
      },
    );
  }

  /** The planner in front last. */
  private answers({ planners, hidden, focus, results }: State): Shown[] {
    const some = this.options.all ? planners.filter((one) => !hidden.has(one) && one !== focus) : [];
    return [...some, focus].map((planner) => {
      const result = results[planner] ?? null;
      const plan = result?.plan?.outcome === "found" ? played(result)!.plan : (result?.lastGood ?? null);
      return { planner, plan, result, ghost: false };
    });
  }

  private async colours(): Promise<Tokens> {
    const element = Object.assign(new Themed(), { hidden: true });
    element.setAttribute("theme", this.options.theme);
    this.renderRoot.append(element);
    try {
      await element.updateComplete;
      return readTokens(element);
    } finally {
      element.remove();
    }
  }
}

customElements.define("parkade-movie", MovieDialog);

/** Opens the dialog beside a piece of its playground. */
export function openMovie(app: App, piece: HTMLElement): void {
  besideOf(MovieDialog, app, piece).open();
}
