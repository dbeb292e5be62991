import { css, html, type TemplateResult } from "lit";
import { shownChord } from "../app/chord-text";
import { commands, join, type CommandId } from "../app/commands";
import { EDITING } from "../app/edit-commands";
import { SECTIONS, type Entry } from "../app/help-rows";
import { isMessage, type MessageKey } from "../i18n/index";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { DialogElement } from "./dialog";

join(EDITING);

/** All keys on one card. */
export class KeysDialog extends DialogElement {
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

  protected override content(): TemplateResult {
    return html`${this.top(this.t("keys.title"))}
      <div class="scroll columns"
        tabindex="0"><div>${this.list("keys.tools")}${this.list(
          "keys.view",
        )}</div><div>${this.list("keys.edit")}</div></div>`;
  }

  private list(title: keyof typeof SECTIONS): TemplateResult {
    return html`<h3>${this.t(title)}</h3><dl>${SECTIONS[title].map((entry) => this.row(entry))}</dl>`;
  }

  private row([first, ...others]: Entry): TemplateResult {
    const command = commands[first as CommandId];
    const chords = command
      ? [command, ...others.map((id) => commands[id as CommandId]!)].flatMap(({ keys }) => keys)
      : others.map((chord) => (isMessage(chord) ? this.t(chord) : chord));
    return html`<dt>${this.t(
      command?.title ?? (first as MessageKey),
    )}</dt><dd>${chords.map(shownChord).join(" / ")}</dd>`;
  }
}

customElements.define("parkade-keys", KeysDialog);
