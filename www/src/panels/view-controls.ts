import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { ariaKeys, tooltip } from "../app/chord-text";
import { commands, type CommandId } from "../app/commands";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { LEGEND, pathLeaves } from "../view/camera";
import { AppElement } from "./base";
import { icon } from "../styles/icons";

/** Zoom and fit for all maps, and a word where a path is cut off. */
export class ViewControls extends AppElement {
  static override properties = { ...AppElement.properties, compact: { type: Boolean, reflect: true } };
  static override styles = [
    controls,
    css`
    :host {
      position: absolute; left: 0; right: 0; bottom: 8px; z-index: 4; display: grid; justify-items: center; gap: 8px;
      pointer-events: none; container-type: inline-size;
    }
    div {
      display: flex; background: var(--parkade-panel); border: 1px solid var(--parkade-hair2);
      border-radius: calc(6px * var(--parkade-radius)); overflow: hidden; pointer-events: auto;
    }
    div > * + * { border-left: 1px solid var(--parkade-hair); }
    div button { width: 32px; height: 32px; border-radius: 0; color: var(--parkade-t2); font-size: 16px; }
    div button:focus-visible { outline-offset: -2px; }
    button:hover { background: var(--parkade-hover); color: var(--parkade-t1); }
    .pill {
      height: 24px; padding: 0 10px; font-size: 12px; font-weight: 500; pointer-events: auto; color: var(--parkade-t1);
      background: var(--parkade-panel); border: 1px solid var(--parkade-hair2); border-radius: 999px;
    }
    /* On a narrow map the list of planners reaches the middle: above it there is room. */
    @container (max-width: 840px) {
      :host([listed]) :is(div, .pill) { justify-self: end; margin-right: 10px; }
      :host([listed]) div { margin-bottom: var(--list); }
    }
    /* Fingers zoom by themselves, and a narrow map has no room to spare. */
    :host([compact]) { justify-items: end; inset: 8px 8px auto auto; }
    :host([compact]) div button:not(.fit) { display: none; }
    @media (pointer: coarse) { div button { width: 44px; height: 44px; } .pill { height: 44px; } }
  `,
  ];

  declare compact: boolean;
  protected override redrawMs = 100;

  protected watches(): readonly (keyof State)[] {
    return ["camera", "results", "planners", "hidden", "mode", "scene", "follow"];
  }

  protected override willUpdate(changed: PropertyValues): void {
    super.willUpdate(changed);
    const { mode, planners } = this.state;
    this.toggleAttribute("listed", mode === "overlay" && !this.compact);
    this.style.setProperty(
      "--list",
      `${LEGEND.row * Math.min(LEGEND.rows, planners.length) + LEGEND.edge + LEGEND.off}px`,
    );
  }

  protected override render(): TemplateResult {
    const { controller } = this.app,
      leaves = !this.state.follow && pathLeaves(this.state, controller.view());
    const button = (name: "out" | "fit" | "in", id: CommandId, face: unknown): TemplateResult => {
      const command = commands[id]!;
      return html`<button class=${name} aria-label=${this.t(command.title)} aria-keyshortcuts=${ariaKeys(command)}
        title=${tooltip(this.state.lang, command)} @click=${() => command.run(this.app)}>${face}</button>`;
    };
    return html`${
      leaves ? html`<button class="pill" @click=${() => controller.fit()}>${this.t("view.leaves")}</button>` : nothing
    }
      <div role="group" aria-label=${this.t("view.group")}>${button("out", "zoomOut", "−")}${button(
        "fit",
        "fit",
        icon("fit"),
      )}${button("in", "zoomIn", "+")}</div>`;
  }
}

customElements.define("parkade-view-controls", ViewControls);
