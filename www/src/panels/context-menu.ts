import { isPose } from "../scene/selection";
import type { Pose } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { ariaKeys, shownChord } from "../app/chord-text";
import type { Command } from "../app/command";
import { commands, isEnabled, type CommandId } from "../app/commands";
import messages from "../i18n/messages/context-menu.json";
import { translator } from "../i18n/translator";
import { anyOfSlots, anywhereIn, leaveSlot, orThere, slotOfStart, slotsOfGoal } from "../scene/goals";
import { findObstacle, findSlot, isGoalPose, movePose, setGoalFromSlot } from "../scene/model";
import { removeObstacle } from "../scene/removal";
import { cornersOf } from "../scene/shapes";
import { idsOf } from "../scene/scene-objects";
import type { Scene, State } from "../store";
import { controls } from "../styles/controls";
import type { MenuRequest } from "../tools/controller";
import { AppElement } from "./base";
import { icon, type IconName } from "../styles/icons";
import { nth } from "../scene/nth";

const say = translator("contextMenu", messages);

/**
 * Menu at the pointer, opened by a right click or a resting finger. The platform has it over everything; it is closed
 * here, as an "auto" popover would take the end of the press that opens it for a press elsewhere.
 */
export class ContextMenu extends AppElement {
  static override properties = { ...AppElement.properties, request: { state: true } };
  static override styles = [
    controls,
    css`
    .popover { min-width: 190px; }
    .item[aria-checked] svg { visibility: hidden; }
    .item[aria-checked="true"] svg { visibility: visible; }
  `,
  ];
  declare request: MenuRequest | null;
  /** What had the focus before. */
  private opener: HTMLElement | null = null;

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
    if (!menu.matches(":popover-open")) {
      this.opener = focused();
      menu.showPopover();
    }
    const { width, height } = menu.getBoundingClientRect();
    menu.style.left = `${Math.max(4, Math.min(request.x, innerWidth - width - 4))}px`;
    menu.style.top = `${Math.max(4, Math.min(request.y, innerHeight - height - 4))}px`;
    menu.querySelector("button")?.focus();
  }

  protected override render(): TemplateResult | typeof nothing {
    const { request } = this;
    if (!request) return nothing;
    const { scene, selection, toolOptions, penSeen } = this.state,
      { store } = this.app;
    const some = idsOf(selection).length > 0;
    const slot = selection?.kind === "slot" ? findSlot(scene, selection.id) : undefined;
    const place = (which: "start" | "goal"): void => {
      store.edit(movePose(scene, which, poseAt(scene, which, request)), { label: which });
      store.set({ selection: { kind: which } });
    };
    const toggle = (name: "snap" | "penDraws"): void =>
      store.set({ toolOptions: { ...toolOptions, [name]: !toolOptions[name] } });
    return html`<div class="popover" popover="manual" role="menu" aria-label=${say(this.state.lang, "menu")}
      @keydown=${this.onKey}>
      ${some ? html`${this.command("duplicate")}${this.command("remove")}` : nothing}
      ${
        slot && !slot.occupied
          ? this.item("slot", "slotGoal", null, () => store.edit(setGoalFromSlot(scene, slot.id), { label: "goal" }))
          : nothing
      }
      ${this.goals(request)}
      ${isPose(selection) && selection.kind === "goal" ? this.command("flip") : nothing}
      ${
        some || isPose(selection)
          ? html`<hr>`
          : html`${this.item("car", "startHere", "placeStart", () =>
              place("start"),
            )}${this.item("car", "goalHere", "placeGoal", () => place("goal"))}<hr>`
      }
      ${this.command("undo")}${this.command("selectAll")}${this.command("fit")}
      ${this.check("snap", toolOptions.snap, () => toggle("snap"))}
      ${penSeen ? this.check("pen", toolOptions.penDraws, () => toggle("penDraws")) : nothing}</div>`;
  }

  /** Sets of goals. */
  private goals(request: MenuRequest): TemplateResult | typeof nothing {
    const { scene, selection } = this.state,
      ids = idsOf(selection),
      named = slotsOfGoal(scene).map((slot) => slot.id);
    const goal = (name: IconName, key: Parameters<typeof say>[1], make: () => Scene): TemplateResult =>
      this.item(name, key, null, () => this.app.store.edit(make(), { label: "goal" }));
    if (selection?.kind === "start")
      return slotOfStart(scene) ? goal("slot", "leave", () => leaveSlot(scene)) : nothing;
    if (selection === null) return goal("car", "orHere", () => orThere(scene, poseAt(scene, "goal", request)));
    const slots = ids.filter((id) => findSlot(scene, id));
    if (slots.length > 1 && slots.length === ids.length)
      return goal("slot", "slotsGoal", () => anyOfSlots(scene, slots));
    if (slots.length === 1 && named.length > 0 && !named.includes(nth(slots, 0)))
      return goal("slot", "orSlot", () => anyOfSlots(scene, [...named, nth(slots, 0)]));
    const shape = ids.length === 1 ? findObstacle(scene, nth(ids, 0)) : undefined;
    return shape?.type === "polygon" || shape?.type === "rectangle"
      ? goal("polygon", "region", () => anywhereIn(removeObstacle(scene, nth(ids, 0)), cornersOf(shape)))
      : nothing;
  }

  private command(id: CommandId): TemplateResult | typeof nothing {
    const command = commands[id];
    return command
      ? this.entry(
          command.icon!,
          this.t(command.title),
          command,
          () => command.run(this.app),
          !isEnabled(this.state, command),
        )
      : nothing;
  }

  /** `keys`: the command that does the same by keys. */
  private item(
    name: IconName,
    key: Parameters<typeof say>[1],
    keys: CommandId | null,
    run: () => void,
  ): TemplateResult {
    return this.entry(name, say(this.state.lang, key), keys ? commands[keys] : undefined, run);
  }

  private entry(
    name: IconName,
    text: string,
    keyed: Command | undefined,
    run: () => void,
    disabled = false,
  ): TemplateResult {
    return html`<button class="item" role="menuitem" ?disabled=${disabled}
      aria-keyshortcuts=${keyed ? ariaKeys(keyed) : nothing} @click=${() => {
        this.close();
        run();
      }}>${icon(name)}${text}${
        keyed ? html`<span class="keys" aria-hidden="true">${shownChord(nth(keyed.keys, 0))}</span>` : nothing
      }</button>`;
  }

  private check(key: "snap" | "pen", on: boolean, run: () => void): TemplateResult {
    return html`<button class="item" role="menuitemcheckbox" aria-checked=${on} @click=${() => {
      this.close();
      run();
    }}>${icon("check")}${say(this.state.lang, key)}</button>`;
  }

  /** By keys and by its own items: the focus goes back to where it was. */
  private close(): void {
    if (this.shadowRoot?.activeElement) this.opener?.focus({ preventScroll: true });
    this.opener = this.request = null;
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

/** The focused element, in whichever tree. */
function focused(): HTMLElement | null {
  let element = document.activeElement;
  while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
  return element instanceof HTMLElement ? element : null;
}

/** Headed as the goal is or, of the start and where the goal is not one pose, as the start. */
const poseAt = ({ goal, start }: Scene, which: "start" | "goal", { at: [x, y] }: MenuRequest): Pose => ({
  x,
  y,
  heading: which === "goal" && isGoalPose(goal) ? goal.heading : start.heading,
});

customElements.define("parkade-context", ContextMenu);
