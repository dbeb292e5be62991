import { css, html, type TemplateResult } from "lit";
import { shownChord } from "../app/chord-text";
import { commands, type CommandId } from "../app/commands";
import "../app/edit-commands";
import { SECTIONS, type Entry } from "../app/help-rows";
import { isMessage, type MessageKey } from "../i18n/index";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { AppElement } from "./base";
import { icon } from "../styles/icons";

/** All keys on one card. */
export class KeysDialog extends AppElement {
  static override styles = [
    controls,
    dialogs,
    css`
    .columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(240px, 1fr)); gap: 8px 32px; }
    h3 { margin: 8px 0 4px; font-size: 12px; line-height: 16px; font-weight: 500; color: var(--parkade-t3); }
    dl { margin: 0; display: grid; grid-template-columns: 1fr auto; gap: 0 16px; }
    dt, dd { margin: 0; padding: 5px 0; border-top: 1px solid var(--parkade-hair); }
    dd { color: var(--parkade-t2); text-align: right; }
  `,
  ];

  protected watches(): readonly (keyof State)[] {
    return [];
  }

  open(): void {
    this.dialog?.showModal();
  }

  protected override render(): TemplateResult {
    return html`<dialog aria-labelledby="title" @click=${(e: Event) => {
      if (e.target === this.dialog) this.dialog?.close();
    }}>
      <div class="top"><h2 id="title">${this.t("keys.title")}</h2>
        <button class="icon" aria-label=${this.t("scenes.close")} @click=${() => this.dialog?.close()}>${icon("close")}</button></div>
      <div class="scroll columns" tabindex="0"><div>${this.list("keys.tools")}${this.list("keys.view")}</div><div>${this.list("keys.edit")}</div></div>
    </dialog>`;
  }

  private list(title: keyof typeof SECTIONS): TemplateResult {
    return html`<h3>${this.t(title)}</h3><dl>${SECTIONS[title].map((entry) => this.row(entry))}</dl>`;
  }

  private row([first, ...others]: Entry): TemplateResult {
    const command = commands[first as CommandId];
    const chords = command
      ? [command, ...others.map((id) => commands[id as CommandId]!)].flatMap(({ keys }) => keys)
      : others.map((chord) => (isMessage(chord) ? this.t(chord) : chord));
    return html`<dt>${this.t(command?.title ?? (first as MessageKey))}</dt><dd>${chords.map(shownChord).join(", ")}</dd>`;
  }

  private get dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector("dialog");
  }
}

customElements.define("parkade-keys", KeysDialog);
