import type { ImportedQuery } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { refusal, sentence } from "../app/app";
import { isTrajectory, openTrajectory } from "../app/guest";
import { reasonIn } from "../i18n/index";
import messages from "../i18n/messages/import.json";
import { translator } from "../i18n/translator";
import { Helper, joined } from "../planning/job-client";
import { ensureIds } from "../scene/model";
import type { Scenario } from "../scene/scenario";
import type { Scene, State } from "../store";
import { controls } from "../styles/controls";
import type { SitePlanReader } from "../planning/site-plan-reader";
import type { SitePlanDialog } from "./site-plan-dialog";
import { vast } from "../view/lazy-large-maps";
import { AppElement } from "./base";
import { numberOf } from "./inputs";
import { icon, type IconName } from "../styles/icons";
import { nth } from "../scene/nth";
import { rootOf } from "./beside";
import { fieldsOf } from "../scene/records";
import { apart } from "../app/refusals";
import { refused } from "../i18n/refusal";

const say = translator("import", messages);

const IMAGE = /\.(png|jpe?g|webp|gif|bmp)$/i;

/** Bytes of a drawing in which its kind is told. */
const HEAD = 20_000;

const ENTITIES: Record<string, string> = { amp: "&", lt: "<", gt: ">", quot: '"', apos: "'" };

/** The scene that a drawing of ours carries; the drawing itself is not looked at, nor its styles. */
async function sceneInside(file: File): Promise<readonly [string, Uint8Array<ArrayBuffer>]> {
  const found = /<metadata\b[^>]*>([^<]*)<\/metadata>/.exec(await file.text())?.[1]?.trim();
  if (!found) throw refused`this drawing holds no scene; only those saved here do.`;
  const text = found.replace(/&(?:#(\d+)|(\w+));/g, (whole, code?: string, name?: string) =>
    code ? String.fromCharCode(Number(code)) : (ENTITIES[name ?? ""] ?? whole),
  );
  return [file.name.replace(/\.svg$/i, ".json"), new TextEncoder().encode(text)];
}

/** True for drawings and maps of the ground by layers; a drawing of ours carries its scene. */
async function isSitePlan(file: File): Promise<boolean> {
  if (/\.(dxf|dwg|osm|geojson)$/i.test(file.name)) return true;
  // Ours begin with their scene.
  if (/\.svg$/i.test(file.name)) return !/<metadata\b[^>]*>\s*\{/.test(await file.slice(0, HEAD).text());
  if (!/\.json$/i.test(file.name)) return false;
  const head = await file.slice(0, HEAD).text();
  return /"type"\s*:\s*"(FeatureCollection|Feature)"|"elements"\s*:\s*\[/.test(head);
}

interface Opened {
  name: string;
  scenes: Scene[];
  queries: readonly ImportedQuery[];
}

/** Opens files of many kinds, and offers the questions or scenes that come with them. */
export class ImportBar extends AppElement {
  static override properties = { ...AppElement.properties, opened: { state: true }, at: { state: true } };
  static override styles = [
    controls,
    css`
    :host {
      grid-area: stage; align-self: end; z-index: 9; display: grid; justify-items: center; pointer-events: none;
      padding: 0 10px 46px; min-width: 0;
    }
    .bar {
      pointer-events: auto; display: flex; align-items: center; flex-wrap: wrap; gap: 6px 12px;
      padding: 6px 6px 6px 12px; max-width: 100%; background: var(--parkade-raise);
      border: 1px solid var(--parkade-hair); border-radius: calc(10px * var(--parkade-radius));
      box-shadow: var(--parkade-float);
    }
    b { font-weight: 600; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; max-width: 200px; }
    .step { display: flex; align-items: center; gap: 2px; color: var(--parkade-t2); }
    .field { width: 58px; color: var(--parkade-t1); }
    select {
      height: 28px; padding: 0 6px; background: var(--parkade-panel); border: 1px solid var(--parkade-hair2);
      border-radius: calc(6px * var(--parkade-radius));
    }
    label { display: flex; align-items: center; gap: 6px; color: var(--parkade-t2); }
    select { color: var(--parkade-t1); max-width: 150px; }
    .length { color: var(--parkade-t2); }
    @media (max-width: 640px) {
      :host { padding: 0 8px 8px; }
      .length { display: none; }
      b { order: -2; flex: 1 0 calc(100% - 64px); max-width: none; }
      .close { order: -1; }
      .bar { gap: 2px 8px; padding: 2px 4px 6px 12px; width: 100%; }
      select { max-width: 112px; }
      label { font-size: 0; }
      select { font-size: 13px; }
      .step { margin-left: auto; }
    }
  `,
  ];
  declare opened: Opened | null;
  declare at: number;
  private helper: Helper | null = null;
  private sitePlans: SitePlanDialog | null = null;
  private sitePlan: SitePlanReader | null = null;
  private turn = 0;

  constructor() {
    super();
    this.opened = null;
    this.at = 0;
  }

  protected watches(): readonly (keyof State)[] {
    return ["scene"];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.helper?.stop();
    this.helper = null;
    this.sitePlan?.close();
    this.sitePlans?.remove();
  }

  /** Opens files that belong together; bad ones leave everything as it was. */
  async openFiles(files: readonly File[]): Promise<void> {
    if (files.length === 1 && IMAGE.test(nth(files, 0).name)) return this.openImage(nth(files, 0));
    if (files.length === 1 && (await isTrajectory(nth(files, 0)))) return openTrajectory(this.app, nth(files, 0));
    if (files.length === 1 && (await isSitePlan(nth(files, 0)))) return this.openSitePlan(nth(files, 0));
    const turn = ++this.turn,
      name = files.map((file) => file.name).join(", ");
    const { lang } = this.state;
    const reading = { tone: "info" as const, text: say(lang, "reading", { name }) };
    this.app.store.set({ message: reading });
    try {
      const opened = await this.read(files, name);
      // Somebody has dropped other files meanwhile.
      if (turn !== this.turn) return;
      // The first questions are of a few steps, the last ones lead through the whole map.
      const fair = opened.queries.findIndex(({ bucket }) => bucket >= (opened.queries.at(-1)?.bucket ?? 0) / 4);
      const first = nth(opened.scenes, 0),
        query = opened.queries[fair];
      this.app.preset = null;
      this.app.openScene(query ? { ...first, start: query.start, goal: query.goal } : first);
      this.opened = opened;
      this.at = Math.max(0, fair);
      const { width, height, resolution } = first.map;
      const text = say(lang, "opened", { name, width, height, side: Number(resolution.toPrecision(4)) });
      this.app.store.set({
        message: {
          tone: "info",
          text: [text, ...opened.notes.map((reason) => reasonIn(lang, sentence(reason)))].join(" "),
        },
      });
    } catch (error) {
      if (turn === this.turn) this.app.store.set({ message: { tone: "err", text: this.complaint(error, name) } });
    }
  }

  /** A picture is asked about before it is a map. */
  private async openImage(file: File): Promise<void> {
    this.turn++;
    await import("./image-import");
    const root = rootOf(this);
    await root.querySelector<HTMLElement & { ask(file: File): Promise<void> }>("parkade-image")?.ask(file);
  }

  /** What the layers of a site plan are is asked before it is a scene. */
  private async openSitePlan(file: File): Promise<void> {
    const turn = ++this.turn,
      { name } = file;
    this.app.store.set({ message: { tone: "info", text: say(this.state.lang, "reading", { name }) } });
    try {
      const [{ SitePlanReader }, { SitePlanDialog }] = await Promise.all([
        import("../planning/site-plan-reader"),
        import("./site-plan-dialog"),
      ]);
      this.sitePlan?.close();
      const reader = new SitePlanReader();
      this.sitePlan = reader;
      const plan = await reader.read(file);
      if (turn !== this.turn) return reader.close();
      this.sitePlans ??= Object.assign(new SitePlanDialog(), { app: this.app });
      if (!this.sitePlans.isConnected) this.getRootNode().appendChild(this.sitePlans);
      this.sitePlans.ask(plan, reader, name);
    } catch (error) {
      if (turn !== this.turn) return;
      this.sitePlan?.close();
      const { lang } = this.state,
        { line } = fieldsOf(error),
        reason = refusal(error);
      const text =
        typeof line !== "number" ? say(lang, "bad", { name, reason }) : say(lang, "line", { name, line, reason });
      this.app.store.set({ message: { tone: "err", text } });
    }
  }

  private async read(files: readonly File[], name: string): Promise<Opened & { notes: string[] }> {
    const engine = await this.app.complete();
    this.helper ??= new Helper(engine);
    const described = files.some((file) => /\.ya?ml$/i.test(file.name));
    const contents = await Promise.all(files.map((file) => this.contents(file, described)));
    const [moved, { prepare }] = await Promise.all([
      this.helper.call(
        "import",
        { files: Object.fromEntries(contents), options: {} },
        contents.map(([, { buffer }]) => buffer),
      ),
      vast.load(),
    ]);
    const scenes = (await joined(moved, moved.value.scenes)).map(ensureIds);
    this.app.catalog?.geometry(nth(scenes, 0));
    await prepare(nth(scenes, 0), this.app.tokens());
    return { name, scenes, queries: moved.value.queries, notes: moved.value.notes };
  }

  /** What importing reads of a file; a picture that a map server's description comes with is one in another form. */
  private async contents(file: File, described: boolean): Promise<readonly [string, Uint8Array<ArrayBuffer>]> {
    if (/\.svg$/i.test(file.name)) return sceneInside(file);
    if (described && IMAGE.test(file.name)) return (await import("../scene/image-decode")).pgmOf(file, this.state.lang);
    return [file.name, new Uint8Array(await file.arrayBuffer())];
  }

  private complaint(error: unknown, name: string): string {
    const { lang } = this.state;
    // Importers put values together before their rule has them: the catalogue knows their whole texts.
    const {
        path,
        rule: { message },
      } = apart(error),
      place = /^(.*):(\d+)$/.exec(path);
    if (place) return say(lang, "line", { name: nth(place, 1), line: nth(place, 2), reason: message });
    // The sentence begins with the file's name.
    const field = path.startsWith(`${name}.`) ? path.slice(name.length + 1) : path;
    return say(lang, "bad", { name, reason: name.includes(field) ? message : `${field}: ${message}` });
  }

  protected override render(): TemplateResult | typeof nothing {
    const {
      opened,
      state: { lang, scene },
    } = this;
    if (!opened?.scenes.some((one) => one.map === scene.map)) return nothing;
    const { queries, scenes, name } = opened;
    const many = queries.length || scenes.length;
    if (many < 2) return nothing;
    return html`<div class="bar" role="group" aria-label=${say(
      lang,
      queries.length ? "queries" : "scenes",
    )}><b title=${name}>${name.split(", ")[0]}</b>
      ${queries.length ? this.groups(queries) : this.names(scenes)}
      <span class="step">${this.button("back", "previous", this.at - 1, many)}
        <span class="field"><input type="number" min="1" max=${many} .value=${String(this.at + 1)}
          aria-label=${say(lang, queries.length ? "question" : "scene")}
          @change=${(e: Event) => this.choose(Math.round(numberOf(e)) - 1)}></span>
        ${this.button("next", "next", this.at + 1, many)} ${say(lang, "of", { n: this.num(many, 0) })}</span>
      ${
        queries[this.at]
          ? html`<span class="length">${say(lang, "shortest", {
              length: this.num(nth(queries, this.at).length, 2),
            })}</span>`
          : nothing
      }
      <button class="icon small close" aria-label=${say(lang, "close")} title=${say(lang, "close")} @click=${() => {
        this.opened = null;
      }}>${icon("close", 14)}</button></div>`;
  }

  /** Questions come in groups of about the same length; a group's first one is chosen. */
  private groups(queries: readonly ImportedQuery[]): TemplateResult {
    const { lang } = this.state;
    const firsts = queries.flatMap((query, i) => (i === 0 || query.bucket !== nth(queries, i - 1).bucket ? [i] : []));
    const now = firsts.findLast((first) => first <= this.at);
    return html`<label>${say(lang, "group")}<select @change=${(e: Event) => this.choose(numberOf(e))}>
      ${firsts.map(
        (first) =>
          html`<option value=${first} ?selected=${first === now}
            .selected=${first === now}>${say(lang, "groupOf", {
              length: this.num(nth(queries, first).length, 0),
            })}</option>`,
      )}</select></label>`;
  }

  private names(scenes: readonly Scene[]): TemplateResult {
    const { lang } = this.state;
    return html`<label>${say(lang, "scene")}<select @change=${(e: Event) => this.choose(numberOf(e))}>
      ${scenes.map(
        (scene, i) =>
          html`<option value=${i} ?selected=${i === this.at}
            .selected=${i === this.at}>${scene.name ?? i + 1}</option>`,
      )}</select></label>`;
  }

  private button(name: IconName, key: "previous" | "next", to: number, many: number): TemplateResult {
    const label = say(this.state.lang, key);
    return html`<button class="icon small" aria-label=${label} title=${label} ?disabled=${to < 0 || to >= many}
      @click=${() => this.choose(to)}>${icon(name)}</button>`;
  }

  private choose(at: number): void {
    const { opened, app } = this;
    this.requestUpdate();
    if (!opened) return;
    const query = opened.queries[at],
      scene = opened.scenes[at];
    if (query) this.edit({ ...app.store.state.scene, start: query.start, goal: query.goal });
    else if (scene && opened.queries.length === 0) app.openScene(scene);
    else return;
    this.at = at;
  }

  /** The answers to another question need not lie where the last ones did. */
  private edit(scene: Scenario): void {
    this.app.store.edit(scene, { label: "question" });
    this.app.controller.fit();
  }
}

customElements.define("parkade-import", ImportBar);
