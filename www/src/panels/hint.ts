import { css, html, nothing, type TemplateResult } from "lit";
import { recall, remember } from "../element/memory";
import { goalPose, vehicleOf } from "../scene/model";
import type { State } from "../store";
import { cameraFor, worldToScreen } from "../view/camera";
import { AppElement } from "./base";

const KEY = "hint.drag";

/** One sentence beside the goal car, until the first drag. */
export class Hint extends AppElement {
  static override styles = css`
    :host { display: var(--parkade-hint, block); position: absolute; inset: 0; pointer-events: none; overflow: hidden; z-index: 3; }
    span { position: absolute; padding: 7px 12px; border-radius: calc(6px * var(--parkade-radius)); background: var(--parkade-t1); color: var(--parkade-panel); font-weight: 500; white-space: nowrap; transform: translateY(-50%); }
    span::after { content: ""; position: absolute; top: 50%; width: 8px; height: 8px; background: inherit; transform: translateY(-50%) rotate(45deg); }
    .left::after { right: -4px; } .right::after { left: -4px; }
  `;
  private gone = recall(KEY) !== null;
  private size = { width: 0, height: 0 };
  private readonly observer = new ResizeObserver(([entry]) => {
    if (entry) this.size = { width: entry.contentRect.width, height: entry.contentRect.height };
    this.requestUpdate();
  });

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
  }

  protected watches(): readonly (keyof State)[] {
    return this.gone ? [] : ["scene", "camera", "transient", "geometry", "results", "playback", "selection"];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { state } = this;
    if (state.transient && !this.gone) {
      this.gone = true;
      remember(KEY, "seen");
    }
    const { width, height } = this.size;
    const other = state.selection !== null && state.selection.kind !== "goal";
    if (this.gone || other || width === 0 || !state.geometry || state.playback.playing) return nothing;
    const goal = goalPose(state.scene);
    const ahead = vehicleOf(state.scene.vehicle).rearToFront + 1.2;
    const at = worldToScreen({ camera: cameraFor(state, width, height), width, height },
      goal.x + ahead * Math.cos(goal.heading), goal.y + ahead * Math.sin(goal.heading));
    const toLeft = at[0] > width / 2;
    const place = `top:${Math.min(height - 20, Math.max(20, at[1]))}px;${toLeft ? `right:${width - at[0] + 22}px` : `left:${at[0] + 22}px`}`;
    return html`<span class=${toLeft ? "left" : "right"} .style=${place}>${this.t("hint.drag")}</span>`;
  }
}

customElements.define("parkade-hint", Hint);
