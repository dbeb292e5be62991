import { css, html, nothing, type TemplateResult } from "lit";
import messages from "../i18n/messages/entry-switch.json";
import { translator } from "../i18n/translator";
import { withEntry } from "../scene/goals";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import { boxesOf, freeSpot, goalOnMap, moved, type Spot } from "./free-spot";
import { icon } from "../styles/icons";
import { hostOf } from "./beside";

const say = translator("entrySwitch", messages);

/** Beside a goal car that stands in a slot: how it enters, and another way at a press. */
export class EntrySwitch extends AppElement {
  static override properties = { ...AppElement.properties, spot: { state: true } };
  static override styles = [
    controls,
    css`
    :host { position: absolute; inset: 0; z-index: 10; pointer-events: none; overflow: hidden; }
    button {
      position: absolute; pointer-events: auto; height: 28px; gap: 6px; padding: 0 10px 0 8px; font-size: 12px;
      font-weight: 500; white-space: nowrap; color: var(--parkade-t1);
      background: color-mix(in srgb, var(--parkade-panel) 94%, transparent); border: 1px solid var(--parkade-hair2);
      border-radius: calc(6px * var(--parkade-radius));
    }
    button:hover { background: var(--parkade-panel); border-color: var(--parkade-accent); }
    button.out { visibility: hidden; }
    @media (pointer: coarse) { button { height: 44px; } }
  `,
  ];
  declare spot: Spot | null;
  private readonly observer = new ResizeObserver(() => this.place());
  private readonly onHint = (): void => this.place();
  private host: HTMLElement | null = null;

  constructor() {
    super();
    this.spot = null;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
    this.host = hostOf(this);
    this.host.addEventListener("parkade-hint", this.onHint);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
    this.host?.removeEventListener("parkade-hint", this.onHint);
  }

  protected watches(): readonly (keyof State)[] {
    return ["scene", "camera", "geometry", "transient", "tool", "focus", "mode", "playback", "results"];
  }

  protected override render(): TemplateResult | typeof nothing {
    const {
      scene: { goal },
      lang,
    } = this.state;
    if (!("entry" in goal)) return nothing;
    const next =
      goal.entry === "either"
        ? "reverse-in"
        : goal.entry === "head-in"
          ? "slots" in goal
            ? "either"
            : "reverse-in"
          : "head-in";
    const title = say(lang, "title", { now: say(lang, goal.entry), next: say(lang, next) });
    return html`<button class=${this.spot ? "" : "out"} aria-label=${title} aria-keyshortcuts="X" title="${title} · X"
      .style=${`left:${this.spot?.x ?? 0}px;top:${this.spot?.y ?? 0}px`}
      @click=${() =>
        this.app.store.edit(withEntry(this.state.scene, next), {
          label: "entry",
        })}>${icon("flip", 14)}${say(lang, goal.entry)}</button>`;
  }

  protected override updated(): void {
    this.place();
  }

  /** The maps are drawn in other trees, after this one. */
  private place(): void {
    requestAnimationFrame(() => {
      const spot = this.isConnected ? this.placed() : null;
      if (JSON.stringify(spot) !== JSON.stringify(this.spot)) this.spot = spot;
    });
  }

  private placed(): Spot | null {
    const { state, host } = this,
      button = this.renderRoot.querySelector("button");
    // A hint speaks of the same car.
    const isHinted = host?.shadowRoot?.querySelector("parkade-hints[data-step='hint.drag']");
    if (
      !button ||
      !host ||
      isHinted ||
      state.transient ||
      state.playback.playing ||
      state.tool !== "select" ||
      host.matches("[viewing], [controls=none]")
    )
      return null;
    const goal = goalOnMap(host, state);
    if (!goal) return null;
    const origin = this.getBoundingClientRect(),
      taken = [...goal.cars, ...boxesOf(host.shadowRoot!, "parkade-entry")];
    return freeSpot(
      moved(goal.grip, origin),
      button,
      origin,
      taken.filter((box) => box.maxX > box.minX).map((box) => moved(box, origin)),
    );
  }
}

customElements.define("parkade-entry", EntrySwitch);
