import { css, html, type TemplateResult } from "lit";
import type { MessageKey } from "../i18n/index";
import { words } from "../i18n/words";
import "../i18n/later";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { AppElement } from "./base";
import { icon } from "../styles/icons";
import { TOOLS } from "./toolbar";

type Entry = [name: MessageKey | Own, keys: string];

const OWN = {
  copy: ["Duplicate; while dragging", "复制；拖动时"],
  all: ["Select all, add to the selection", "全选；加入选择"],
  turn: ["Turn by 5°, by 1°", "旋转 5°、1°"],
  type: ["Type the chosen pose", "输入所选位姿"],
  draw: ["Move the drawing pointer, press or release", "移动绘图光标、按下或松开"],
  place: ["Place start, goal", "放置起点、目标"],
  snap: ["Without snapping, in steps of 15°", "不吸附；按 15° 步进"],
  tens: ["A tenth of the timeline at a step", "时间轴每步十分之一"],
} as const;
type Own = keyof typeof OWN;
const say = words<Own>(OWN);

const EDIT: readonly Entry[] = [
  ["keys.undo", "Ctrl Z, Ctrl Shift Z"],
  ["keys.delete", "Del"],
  ["keys.escape", "Esc"],
  ["keys.nudge", "↑ ↓ ← →, Shift"],
  ["copy", "Ctrl D, Alt"],
  ["all", "Ctrl A, Shift"],
  ["turn", "Ctrl ← →, Shift"],
  ["type", "Enter"],
  ["place", "S, T"],
  ["draw", "↑ ↓ ← →, Enter"],
  ["snap", "Ctrl, Shift"],
  ["keys.flip", "X"],
  ["keys.lock", "Q"],
  ["keys.radius", "[ ]"],
  ["keys.weight", "{ }"],
];
const VIEW: readonly Entry[] = [
  ["keys.mode", "\\"],
  ["keys.layers", ", ."],
  ["keys.fit", "0"],
  ["bar.papers", "Y"],
  ["tens", "Shift"],
];

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
    const tools = TOOLS.map((tool): Entry => [`tool.${tool.id}`, tool.digit ? `${tool.key}, ${tool.digit}` : tool.key]);
    const view: readonly Entry[] = [
      ["keys.play", "A"],
      ...VIEW,
      ["keys.pan", `H, ${this.t("keys.space")}`],
      ["keys.zoom", this.t("keys.zoomKeys")],
    ];
    return html`<dialog aria-labelledby="title" @click=${(e: Event) => {
      if (e.target === this.dialog) this.dialog?.close();
    }}>
      <div class="top"><h2 id="title">${this.t("keys.title")}</h2>
        <button class="icon" aria-label=${this.t("scenes.close")} @click=${() => this.dialog?.close()}>${icon("close")}</button></div>
      <div class="scroll columns" tabindex="0"><div>${this.list("keys.tools", tools)}</div><div>${this.list("keys.edit", EDIT)}${this.list("keys.view", view)}</div></div>
    </dialog>`;
  }

  private list(title: MessageKey, entries: readonly Entry[]): TemplateResult {
    return html`<h3>${this.t(title)}</h3><dl>${entries.map(([name, keys]) => html`<dt>${name in OWN ? say(this.state.lang, name as Own) : this.t(name as MessageKey)}</dt><dd>${keys}</dd>`)}</dl>`;
  }

  private get dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector("dialog");
  }
}

customElements.define("parkade-keys", KeysDialog);
