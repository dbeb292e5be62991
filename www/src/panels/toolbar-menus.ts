/** Contents of the toolbar's menus. */
import { html, nothing, type TemplateResult } from "lit";
import { ALL_LAYERS, LAYER_PRESETS, presetLayers, presetOf } from "../store/layer-sets";
import type { App } from "../app/app";
import { saveAs } from "./exports";
import { ariaKeys, shownChord } from "../app/chord-text";
import { commands, isEnabled, type CommandId } from "../app/commands";
import { copySnippet } from "../app/snippets";
import "../i18n/later";
import { translate, type Lang, type MessageKey } from "../i18n/index";
import { icon, marker, type IconName } from "../styles/icons";
import { nth } from "../scene/nth";

/** What the menus use of the toolbar. */
interface Bar extends HTMLElement {
  readonly app: App;
  readonly compact: boolean;
  readonly rail: boolean;
  readonly menus: { close(): void };
  themeName(): string;
  readonly nextTheme: () => void;
  readonly nextLang: () => void;
  readonly checkBays: () => void;
  readonly share: () => void;
}

/** Papers are cited by authors and year; in Chinese, what is not a name is translated. */
function cited(lang: Lang, paper: string): string {
  if (lang === "en") return paper;
  const known = (["parking", "road", "beyond"] as const).find((name) => translate("en", `cited.${name}`) === paper);
  return known ? translate(lang, `cited.${known}`) : paper.replace(" et al.", " 等");
}

export function planners(bar: Bar): TemplateResult {
  const { app } = bar,
    { planners, lang } = app.store.state;
  return html`${app.catalog?.planners.map(
    ({ id, title, paper }) => html`<label class="check" title=${cited(lang, paper)}>
      <input type="checkbox" .checked=${planners.includes(id)} ?disabled=${planners.length === 1 && planners[0] === id}
      @change=${() => app.togglePlanner(id)}>
    ${marker(id)}${title[lang]}</label>`,
  )}
    <hr>${item(bar, "undo", "planners.first", () => app.showFirstPlanners())}`;
}

export function layers(bar: Bar): TemplateResult {
  const { app } = bar,
    { store } = app,
    { lang, layers } = store.state,
    now = presetOf(layers);
  return html`<div class="segmented" role="group" aria-label=${translate(lang, "layers.presets")}>
      ${LAYER_PRESETS.map(
        (preset) =>
          html`<button aria-pressed=${preset === now}
            @click=${() =>
              store.set({ layers: presetLayers(preset) })}>${translate(lang, `layers.${preset}`)}</button>`,
      )}
    </div>
    ${ALL_LAYERS.map(
      (key) => html`<label class="check"><input type="checkbox" .checked=${layers[key]}
        @change=${() =>
          store.set({
            layers: { ...store.state.layers, [key]: !store.state.layers[key] },
          })}>${translate(lang, `layer.${key}`)}</label>`,
    )}
    <hr>${item(
      bar,
      "planners",
      "bar.debugger",
      () => void app.fetchPart(async () => (await import("./debugger")).toggleDebugger(app, bar)),
    )}`;
}

export function exports(bar: Bar): TemplateResult {
  const { app } = bar;
  return html`${item(
    bar,
    "slot",
    "bar.newLot",
    () => void app.fetchPart(async () => (await import("./new-lot")).openNewLot(app, bar)),
  )}
    ${item(bar, "check", "bar.checkBays", bar.checkBays)}
    ${item(bar, "file", "bar.save", () => void app.saveFile())}
    ${item(bar, "open", "bar.open", () => bar.app.ask("open"))}
    ${item(bar, "image", "bar.png", () => bar.app.ask("png", 1))}
    ${item(bar, "image", "bar.png2", () => bar.app.ask("png", 2))}
    ${item(
      bar,
      "play",
      "bar.movie",
      () => void app.fetchPart(async () => (await import("./movie")).openMovie(app, bar)),
    )}
    ${item(bar, "image", "bar.svg", () => void saveAs(app, "svg"))}
    ${item(
      bar,
      "file",
      "bar.sheet",
      () => void app.fetchPart(async () => (await import("./sheet-dialog")).openSheet(app, bar)),
    )}
    ${item(bar, "moving", "bar.csv", () => void saveAs(app, "csv"))}
    ${item(bar, "clock", "bar.trajectory", () => void saveAs(app, "trajectory"))}
    <hr>${item(bar, "share", "bar.copyEmbed", () => void copySnippet(app, "embed"))}
    ${item(bar, "share", "bar.copyMarkdown", () => void copySnippet(app, "markdown"))}
    ${item(bar, "share", "bar.copyTest", () => void copySnippet(app, "test"))}
    ${item(
      bar,
      "share",
      "bar.task",
      () => void app.fetchPart(async () => (await import("./task")).openTaskDialog(app, bar)),
    )}
    <hr>${command(bar, "papers")}
    ${item(bar, "undo", "bar.reset", () => app.reset())}`;
}

export function more(bar: Bar): TemplateResult {
  const { app, compact, rail } = bar;
  // What the bar has no room for.
  const folded = !bar.shadowRoot?.querySelector<HTMLElement>(".collapse-2")?.offsetParent;
  return html`
    ${compact ? item(bar, "share", "bar.share", bar.share) : nothing}
    ${command(bar, "fit")}
    ${rail ? railed(bar) : nothing}<hr>
    ${folded ? html`${planners(bar)}<hr>${layers(bar)}<hr>` : nothing}
    ${exports(bar)}<hr>
    <button class="item" @click=${bar.nextTheme}>${icon("theme")}${bar.themeName()}</button>
    <button class="item" @click=${bar.nextLang}>${icon("language")}${translate(
      app.store.state.lang,
      "bar.language",
    )}</button>
    ${command(bar, "keys")}`;
}

/** Entries that the wide toolbar shows itself. */
const railed = (bar: Bar): TemplateResult =>
  html`${item(bar, "file", "bar.scene", () => bar.app.ask("presets"))}${command(bar, "undo")}${command(bar, "redo")}`;

/** A command with its keys at the right. */
function command(bar: Bar, id: CommandId): TemplateResult | typeof nothing {
  const { app } = bar,
    { state } = app.store,
    row = commands[id];
  if (!row) return nothing;
  return html`<button class="item" ?disabled=${!isEnabled(state, row)} aria-keyshortcuts=${ariaKeys(row)}
    @click=${() => {
      bar.menus.close();
      row.run(app);
    }}>${row.icon ? icon(row.icon) : nothing}${translate(state.lang, row.title)}<span class="keys"
    aria-hidden="true">${shownChord(nth(row.keys, 0))}</span></button>`;
}

function item(bar: Bar, name: IconName, key: MessageKey, run: () => void, disabled = false): TemplateResult {
  return html`<button class="item" ?disabled=${disabled} @click=${() => {
    bar.menus.close();
    run();
  }}>${icon(name)}${translate(bar.app.store.state.lang, key)}</button>`;
}
