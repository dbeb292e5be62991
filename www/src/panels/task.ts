import { css, html, nothing, type TemplateResult } from "lit";
import type { App } from "../app/app";
import { LONGEST_TASK, withTask, type Task } from "../app/task-link";
import messages from "../i18n/messages/task.json";
import { translator } from "../i18n/translator";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { icon } from "../styles/icons";
import { AppElement } from "./base";
import type { Debugger } from "./debugger";
import { DialogElement } from "./dialog";
import { besideOf, rootOf } from "./beside";
import { isChecked, valueOf } from "./inputs";

const say = translator("task", messages);

const debuggerIn = (root: ParentNode): Debugger | null => root.querySelector<Debugger>("parkade-debugger");

/** A task over the maps, as its link asks for it: hidden answers, large type, keys of presenters. */
export class TaskCard extends AppElement {
  static override properties = { ...AppElement.properties, task: { attribute: false } };
  static override styles = [
    controls,
    css`
    :host {
      grid-area: stage; align-self: start; justify-self: start; z-index: 14; margin: 44px 12px 12px;
      max-width: min(440px, 90cqw); padding: 12px 14px; background: var(--parkade-panel);
      border: 1px solid var(--parkade-hair2); border-radius: calc(10px * var(--parkade-radius));
      box-shadow: var(--parkade-float);
    }
    header { display: flex; align-items: start; gap: 8px; }
    p { margin: 0; flex: 1; font-size: 15px; line-height: 22px; white-space: pre-wrap; overflow-wrap: anywhere; }
    .large p { font-size: 22px; line-height: 31px; }
    footer { display: flex; align-items: center; gap: 10px; margin-top: 10px; }
    small { color: var(--parkade-t3); font-size: 12px; line-height: 16px; }
    .large small { font-size: 15px; line-height: 20px; }
    .large .button { height: 40px; font-size: 17px; }
    .icon { margin: -6px -8px 0 0; }
  `,
  ];
  declare task: Task;

  protected watches(): readonly (keyof State)[] {
    return ["hidden", "planners"];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("keydown", this.onKey, { capture: true });
    const { planners, focus } = this.state,
      { hidden, step } = this.task;
    // The debugger shows its planner's search, which is no answer yet.
    if (hidden) this.app.store.set({ hidden: new Set(planners.filter((one) => step === null || one !== focus)) });
    if (this.task.step !== null) void this.openDebugger(this.task.step);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("keydown", this.onKey, { capture: true });
    this.show();
  }

  private async openDebugger(step: number): Promise<void> {
    await this.app.planning?.whenSettled();
    const { toggleDebugger } = await import("./debugger");
    const root = rootOf(this);
    if (debuggerIn(root)) return;
    toggleDebugger(this.app, this, step);
    // Only what has no map in it is enlarged: pointers on maps count in the page's own pixels.
    if (this.task.large) debuggerIn(root)?.style.setProperty("zoom", "1.2");
  }

  private readonly show = (): void => this.app.store.set({ hidden: new Set() });

  /** The keys of hand-held presenters. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.key !== "PageDown" && event.key !== "PageUp") return;
    event.preventDefault();
    event.stopPropagation();
    const sign = event.key === "PageDown" ? 1 : -1,
      open = debuggerIn(rootOf(this));
    if (open) open.move(sign);
    else this.app.player.step(sign);
  };

  protected override render(): TemplateResult {
    const { lang, hidden, planners } = this.state,
      { text, large } = this.task;
    const isHidden = planners.some((one) => hidden.has(one));
    return html`<section class=${large ? "large" : ""} role="region"
      aria-label=${say(lang, "label")}><header><p>${text}</p>
      <button class="icon" aria-label=${say(lang, "close")} title=${say(lang, "close")}
        @click=${() => this.remove()}>${icon("close")}</button></header>
      <footer>${
        isHidden ? html`<button class="button solid" @click=${this.show}>${say(lang, "show")}</button>` : nothing
      }<small>${say(lang, "keys")}</small></footer></section>`;
  }
}

/** Makes a link with a task. */
export class TaskDialog extends DialogElement {
  static override properties = { ...DialogElement.properties, task: { state: true }, copied: { state: true } };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 480px; }
    form { padding: 0 24px 20px; }
    textarea {
      width: 100%; height: 110px; padding: 8px; font: inherit; color: inherit; resize: vertical;
      background: var(--parkade-panel); border: 1px solid var(--parkade-hair2);
      border-radius: calc(6px * var(--parkade-radius));
    }
    label { display: flex; align-items: center; gap: 8px; min-height: 32px; }
    footer { display: flex; align-items: center; gap: 12px; margin-top: 10px; }
    footer p { flex: 1; margin: 0; color: var(--parkade-t2); }
    @media (pointer: coarse) { label { min-height: 44px; } }
  `,
  ];
  declare task: Task;
  declare copied: boolean;
  protected override readonly closesOutside = false;
  /** The debugger's position when the dialog opened. */
  private step: number | null = null;

  constructor() {
    super();
    this.copied = false;
    this.task = { text: "", hidden: true, step: null, large: false };
  }

  override open(): void {
    this.step = debuggerIn(rootOf(this))?.position ?? null;
    this.task = { ...this.task, step: this.step };
    this.copied = false;
    super.open();
  }

  protected override content(): TemplateResult {
    const { lang } = this.state,
      { task } = this;
    const set = (patch: Partial<Task>): void => {
      this.task = { ...this.task, ...patch };
      this.copied = false;
    };
    const check = (key: "hidden" | "large" | "step", now: boolean, take: (on: boolean) => void): TemplateResult =>
      html`<label><input type="checkbox" .checked=${now}
        @change=${(e: Event) => take(isChecked(e))}>${say(lang, key)}</label>`;
    return html`${this.top(say(lang, "title"), say(lang, "lead"))}<form @submit=${this.copy}>
      <textarea aria-label=${say(lang, "text")} placeholder=${say(lang, "text")} maxlength=${LONGEST_TASK}
        .value=${task.text} @input=${(e: Event) => set({ text: valueOf(e) })}></textarea>
      ${check("hidden", task.hidden, (hidden) => set({ hidden }))}
      ${check("step", task.step !== null, (on) => set({ step: on ? (this.step ?? 0) : null }))}
      ${check("large", task.large, (large) => set({ large }))}
      <footer><p role="status">${this.copied ? say(lang, "copied") : ""}</p><button class="button solid"
        ?disabled=${task.text.trim() === ""}>${say(lang, "copy")}</button></footer></form>`;
  }

  private readonly copy = async (event: Event): Promise<void> => {
    event.preventDefault();
    await this.app.links.write();
    const href = await this.app.links.address(true);
    if (!href) this.app.notify("warn", "error.longLink");
    else this.copied = await this.app.copy(withTask(href, this.task));
  };
}

customElements.define("parkade-task", TaskCard);
customElements.define("parkade-task-dialog", TaskDialog);

/** Shows a task over the maps of the page. */
export function showTask(app: App, task: Task): void {
  const root = document.querySelector("parkade-playground")?.shadowRoot;
  root?.querySelector(".layout-wide, .layout-narrow")?.append(Object.assign(new TaskCard(), { app, task }));
}

/** Opens the dialog for a link with a task. */
export function openTaskDialog(app: App, piece: HTMLElement): void {
  besideOf(TaskDialog, app, piece).open();
}
