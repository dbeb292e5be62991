import { html, nothing, type TemplateResult } from "lit";
import type { State } from "../store";
import { icon } from "../styles/icons";
import { AppElement } from "./base";

/** A modal dialog: its frame with heading and close button. The content is built while it is open only. */
export abstract class DialogElement extends AppElement {
  static override properties = { ...AppElement.properties, shown: { state: true } };
  declare shown: boolean;
  /** False where a press beside the dialog would lose what was typed. */
  protected readonly closesOutside: boolean = true;

  constructor() {
    super();
    this.shown = false;
  }

  protected watches(): readonly (keyof State)[] {
    return [];
  }

  open(): void {
    this.shown = true;
    void this.updateComplete.then(() => this.dialog?.showModal());
  }

  readonly close = (): void => this.dialog?.close();

  protected override render(): TemplateResult {
    return html`<dialog aria-labelledby="title" @close=${this.onClose}
      @click=${this.onPress}>${this.shown ? this.content() : nothing}</dialog>`;
  }

  protected abstract content(): TemplateResult;

  /** Heading, a line under it, buttons beside it. */
  protected top(title: string, lead: unknown = nothing, buttons: unknown = nothing): TemplateResult {
    return html`<div class="top"><h2 id="title">${title}</h2>${lead ? html`<p>${lead}</p>` : nothing}${buttons}
      <button class="icon" aria-label=${this.t("scenes.close")} @click=${this.close}>${icon("close")}</button></div>`;
  }

  /** The dialog has been closed, by whatever. */
  protected closed(): void {}

  private readonly onClose = (): void => {
    this.shown = false;
    this.closed();
  };

  private readonly onPress = (event: Event): void => {
    if (this.closesOutside && event.target === this.dialog) this.close();
  };

  private get dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector("dialog");
  }
}
