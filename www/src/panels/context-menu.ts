import { css, html, nothing, type TemplateResult } from "lit";
import { words } from "../i18n/words";
import { findSlot, flipGoal, movePose, setGoalFromSlot } from "../scene/model";
import { idsOf } from "../scene/things";
import { isPose, type State } from "../store";
import { controls } from "../styles/controls";
import type { MenuRequest } from "../tools/controller";
import { duplicateSelected, removeSelected, selectAll } from "../tools/edit-keys";
import { AppElement } from "./base";
import { icon, type IconName } from "./icons";

const say = words({
  menu: ["Map actions", "地图操作"],
  startHere: ["Set start here", "起点设在此处"],
  goalHere: ["Set goal here", "目标设在此处"],
  duplicate: ["Duplicate", "复制"],
  remove: ["Delete", "删除"],
  all: ["Select all", "全选"],
  slotGoal: ["Set as goal", "设为目标"],
  flip: ["Reverse the goal heading", "目标掉头"],
  undo: ["Undo", "撤销"],
  fit: ["Fit to view", "适应视图"],
  snap: ["Snap to objects and cells", "吸附到物体与栅格"],
  pen: ["Fingers pan, the pen draws", "手指平移，触控笔绘制"],
});

/** What can be done where the pointer is: a right click, or a finger that rests. */
export class ContextMenu extends AppElement {
  static override properties = { ...AppElement.properties, request: { state: true } };
  static override styles = [controls, css`
    .popover { position: fixed; z-index: 40; min-width: 190px; }
    .item[aria-checked] svg { visibility: hidden; }
    .item[aria-checked="true"] svg { visibility: visible; }
  `];
  declare request: MenuRequest | null;

  constructor() {
    super();
    this.request = null;
  }

  protected watches(): readonly (keyof State)[] {
    return [];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    document.addEventListener("pointerdown", this.onPress, true);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    document.removeEventListener("pointerdown", this.onPress, true);
  }

  async show(request: MenuRequest): Promise<void> {
    this.request = request;
    await this.updateComplete;
    // A press may have closed it again.
    const menu = this.renderRoot.querySelector<HTMLElement>(".popover");
    if (!menu) return;
    const { width, height } = menu.getBoundingClientRect();
    menu.style.left = `${Math.max(4, Math.min(request.x, innerWidth - width - 4))}px`;
    menu.style.top = `${Math.max(4, Math.min(request.y, innerHeight - height - 4))}px`;
    menu.querySelector("button")?.focus();
  }

  protected override render(): TemplateResult | typeof nothing {
    const { request } = this;
    if (!request) return nothing;
    const { scene, selection, canUndo, toolOptions, penSeen } = this.state, { store } = this.app;
    const some = idsOf(selection).length > 0;
    const slot = selection?.kind === "slot" ? findSlot(scene, selection.id) : undefined;
    const place = (which: "start" | "goal"): void => {
      const before = which === "start" || "slot" in scene.goal ? scene.start.heading : scene.goal.heading;
      store.edit(movePose(scene, which, { x: request.at[0], y: request.at[1], heading: before }), { label: which });
      store.set({ selection: { kind: which } });
    };
    const toggle = (name: "snap" | "penDraws"): void => store.set({ toolOptions: { ...toolOptions, [name]: !toolOptions[name] } });
    return html`<div class="popover" role="menu" aria-label=${say(this.state.lang, "menu")} @keydown=${this.onKey}>
      ${some ? html`${this.item("copy", "duplicate", "Ctrl D", () => duplicateSelected(store))}${this.item("trash", "remove", "Del", () => removeSelected(store))}` : nothing}
      ${slot && !slot.occupied ? this.item("slot", "slotGoal", "", () => store.edit(setGoalFromSlot(scene, slot.id!), { label: "goal" })) : nothing}
      ${isPose(selection) && selection.kind === "goal" ? this.item("flip", "flip", "X", () => store.edit(flipGoal(scene), { label: "flip" })) : nothing}
      ${some || isPose(selection) ? html`<hr>` : html`${this.item("car", "startHere", "S", () => place("start"))}${this.item("car", "goalHere", "T", () => place("goal"))}<hr>`}
      ${this.item("undo", "undo", "Ctrl Z", () => store.undo(), !canUndo)}
      ${this.item("select", "all", "Ctrl A", () => selectAll(store))}
      ${this.item("fit", "fit", "0", () => this.app.controller.fit())}
      ${this.check("snap", toolOptions.snap, () => toggle("snap"))}
      ${penSeen ? this.check("pen", toolOptions.penDraws, () => toggle("penDraws")) : nothing}</div>`;
  }

  private item(name: IconName, key: Parameters<typeof say>[1], keys: string, run: () => void, disabled = false): TemplateResult {
    return html`<button class="item" role="menuitem" ?disabled=${disabled} @click=${() => { this.close(); run(); }}>${icon(name)}${say(this.state.lang, key)}${keys ? html`<span class="keys">${keys}</span>` : nothing}</button>`;
  }

  private check(key: "snap" | "pen", on: boolean, run: () => void): TemplateResult {
    return html`<button class="item" role="menuitemcheckbox" aria-checked=${on} @click=${() => { this.close(); run(); }}>${icon("check")}${say(this.state.lang, key)}</button>`;
  }

  private close(): void {
    this.request = null;
  }

  private readonly onPress = (event: Event): void => {
    if (this.request && !event.composedPath().includes(this)) this.close();
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    event.stopPropagation();
    if (event.key === "Escape") return this.close();
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    const items = [...this.renderRoot.querySelectorAll<HTMLElement>("button:enabled")];
    const now = items.indexOf(this.shadowRoot?.activeElement as HTMLElement);
    items[(now + (event.key === "ArrowDown" ? 1 : -1) + items.length) % items.length]?.focus();
  };
}

customElements.define("parkade-context", ContextMenu);
