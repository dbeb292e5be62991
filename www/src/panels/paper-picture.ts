/** A planner's path in a paper's scene, drawn once it is planned; pressed, it opens the scene. */
import type { Plan, PlannerId } from "parkade";
import { css, html, type TemplateResult } from "lit";
import { Helper } from "../planning/job-client";
import type { Scene, State } from "../store";
import { controls } from "../styles/controls";
import { plannerName } from "../styles/planner-style";
import { AppElement } from "./base";
import { marker } from "../styles/icons";
import { say } from "./papers-messages";
import "./thumbnail";

/** Answers are kept while the page is open; null where there is none. */
const solved = new Map<string, Plan | null>();
/** One after the other, by one worker that ends when nothing waits. */
let queue: Promise<void> = Promise.resolve();
let helper: Helper | null = null,
  waiting = 0;

export class PaperPicture extends AppElement {
  static override properties = { ...AppElement.properties, scene: {}, planner: {}, wide: { type: Boolean } };
  static override styles = [
    controls,
    css`
    :host { display: block; width: 230px; }
    button {
      display: block; width: 100%; padding: 0; border: 1px solid var(--parkade-hair2);
      border-radius: calc(10px * var(--parkade-radius)); overflow: hidden; text-align: left;
      background: var(--parkade-panel); height: auto;
    }
    button:hover { border-color: var(--parkade-t3); }
    parkade-thumbnail { height: 120px; border-bottom: 1px solid var(--parkade-hair); pointer-events: none; }
    span {
      display: flex; align-items: center; gap: 6px; padding: 6px 10px; font-size: 12px; line-height: 16px;
      white-space: normal;
    }
  `,
  ];
  declare scene: string;
  declare planner: PlannerId;
  declare wide: boolean;
  private shown: Scene | null = null;

  protected watches(): readonly (keyof State)[] {
    return ["theme"];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void this.solve();
  }

  protected override render(): TemplateResult {
    const { lang } = this.state,
      scene = (this.shown ??= this.app.catalog!.scenario(this.scene)),
      title = this.app.catalog!.scenarios.find(({ id }) => id === this.scene)?.title[lang] ?? this.scene;
    return html`<button @click=${this.open} title=${say(lang, "open")}><parkade-thumbnail .app=${this.app}
      .scene=${scene} .plan=${solved.get(this.key)} ?whole=${this.wide}></parkade-thumbnail>
      <span>${marker(this.planner)}${title}, ${plannerName(lang, this.planner)}</span></button>`;
  }

  private get key(): string {
    return `${this.scene} ${this.planner}`;
  }

  private async solve(): Promise<void> {
    const { key, planner, scene: id, app } = this;
    if (solved.has(key)) return;
    waiting++;
    queue = queue.then(async () => {
      if (!solved.has(key)) {
        helper ??= new Helper(await app.complete());
        solved.set(key, await helper.call("solve", { planner, scene: app.catalog!.scenario(id) }).catch(() => null));
      }
      if (--waiting === 0) {
        helper?.stop();
        helper = null;
      }
    });
    await queue;
    this.requestUpdate();
  }

  private readonly open = (): void => {
    this.dispatchEvent(
      new CustomEvent("parkade-open-scene", {
        detail: { id: this.scene, planner: this.planner },
        bubbles: true,
        composed: true,
      }),
    );
  };
}

customElements.define("parkade-paper-picture", PaperPicture);
