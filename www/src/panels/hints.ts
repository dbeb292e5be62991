import type { PlannerId } from "parkade";
import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { recall, remember } from "../store/preferences";
import messages from "../i18n/messages/hints.json";
import { translator } from "../i18n/translator";
import "../i18n/later";
import type { Box } from "../scene/geometry";
import type { State } from "../store";
import { plannerName } from "../styles/planner-style";
import { controls } from "../styles/controls";
import { AppElement } from "./base";
import "./entry-switch";
import { boxAround, boxesOf, freeSpot, goalOnMap, moved, type Spot } from "./free-spot";
import { icon } from "../styles/icons";
import { statusOf } from "../texts/status";
import { hostOf } from "./beside";

const say = translator("hints", messages);

const STEPS = ["hint.drag", "hint.wall", "hint.fails"] as const;
type Step = (typeof STEPS)[number];

interface Bubble extends Spot {
  step: Step;
  text: string;
}
interface Anchor {
  box: Box;
  text: string /** Also not to be covered. */;
  near: readonly Box[];
}

/**
 * Hints for the next step: one sentence beside the thing it names, over no control and no text, until the first action.
 */
export class Hints extends AppElement {
  static override properties = { ...AppElement.properties, bubble: { state: true } };
  static override styles = [
    controls,
    css`
    :host { position: absolute; inset: 0; z-index: 20; pointer-events: none; overflow: hidden; }
    div {
      position: absolute; width: max-content; max-width: min(300px, calc(100% - 16px)); display: flex;
      align-items: center; gap: 4px; padding: 3px 3px 3px 12px; border-radius: calc(6px * var(--parkade-radius));
      background: var(--parkade-t1); color: var(--parkade-panel); font-weight: 500; font-size: 13px; line-height: 18px;
    }
    div.out { visibility: hidden; }
    i {
      position: absolute; width: 8px; height: 8px; margin: -4px; background: var(--parkade-t1);
      transform: rotate(45deg);
    }
    u { position: absolute; margin: -1px; min-width: 2px; min-height: 2px; background: var(--parkade-t1); }
    button { pointer-events: auto; width: 26px; height: 26px; min-width: 0; flex: none; }
    @media (pointer: coarse) { button { width: 44px; height: 44px; } }
  `,
  ];
  /** The visible hint. */
  declare bubble: Bubble | null;
  private readonly observer = new ResizeObserver(() => this.place());
  private host: HTMLElement | null = null;

  constructor() {
    super();
    this.bubble = null;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
    this.host = hostOf(this);
    for (const kind of ["pointerdown", "keydown", "wheel"])
      this.host.addEventListener(kind, this.onAction, { capture: true, passive: true });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
    for (const kind of ["pointerdown", "keydown", "wheel"])
      this.host?.removeEventListener(kind, this.onAction, { capture: true });
  }

  protected watches(): readonly (keyof State)[] {
    return this.step
      ? [
          "scene",
          "camera",
          "geometry",
          "transient",
          "tool",
          "results",
          "focus",
          "mode",
          "layers",
          "playback",
          "selection",
          "canUndo",
          "searchSteps",
        ]
      : [];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { step, bubble } = this;
    if (!step) return nothing;
    const text = bubble?.text ?? this.t(step, { planner: "" });
    return html`${bubble ? arrow(bubble) : nothing}
      <div role="status" class=${bubble ? "" : "out"}
        .style=${`left:${bubble?.x ?? 0}px;top:${bubble?.y ?? 0}px`}>${text}
        <button aria-label=${say(this.state.lang, "close")}
          @click=${() => this.dismiss()}>${icon("close", 12)}</button></div>`;
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has("bubble")) {
      this.dataset["step"] = this.bubble?.step ?? "";
      this.host?.dispatchEvent(new Event("parkade-hint"));
    }
    this.place();
  }

  private get step(): Step | undefined {
    return STEPS.find((step) => recall(step) === null);
  }

  private dismiss(): void {
    if (!this.bubble) return;
    remember(this.bubble.step, "seen");
    this.bubble = null;
  }

  private readonly onAction = (event: Event): void => {
    if (!event.composedPath().includes(this)) this.dismiss();
  };

  /** What it stands beside is drawn in other trees, after this one. */
  private place(): void {
    requestAnimationFrame(() => {
      const bubble = this.isConnected ? this.placed() : null;
      if (JSON.stringify(bubble) !== JSON.stringify(this.bubble)) this.bubble = bubble;
    });
  }

  private placed(): Bubble | null {
    const { step, state } = this,
      words = this.renderRoot.querySelector("div");
    if (!step || !words || !this.host || state.transient || state.playback.playing || this.host.hasAttribute("viewing"))
      return null;
    // Another tool drags nothing, and the steps of a search and all bays are looked at undisturbed.
    if (state.tool !== "select" || state.searchSteps || state.bays?.opened === false) return null;
    const anchor = step === "hint.drag" ? this.grip() : state.canUndo ? this.anchor(step) : null;
    if (!anchor) return null;
    // The switch at the same car gives way.
    const origin = this.getBoundingClientRect(),
      taken = [...anchor.near];
    for (const box of boxesOf(
      this.host.shadowRoot!,
      step === "hint.drag" ? "parkade-hints, parkade-entry" : "parkade-hints",
    ))
      taken.push(moved(box, origin));
    const spot = freeSpot(
      moved(anchor.box, origin),
      words,
      origin,
      taken.filter((box) => box.maxX > box.minX),
    );
    return spot && { ...spot, step, text: anchor.text };
  }

  /** The goal car's grip in the map in front. */
  private grip(): Anchor | null {
    const { state } = this,
      goal = goalOnMap(this.host!, state);
    if (!goal || (state.selection !== null && state.selection.kind !== "goal")) return null;
    return {
      box: goal.grip,
      text: this.t("hint.drag"),
      near: goal.cars.map((box) => moved(box, this.getBoundingClientRect())),
    };
  }

  private anchor(step: "hint.wall" | "hint.fails"): Anchor | null {
    const root = this.host!.shadowRoot!;
    const inside = (piece: string, query: string, from: ParentNode = root): Element | null =>
      from.querySelector(piece)?.shadowRoot?.querySelector(query) ?? null;
    if (step === "hint.wall") {
      const element = inside("parkade-toolbar", '[data-tool="wall"]') ?? inside("parkade-sheet", '[data-tool="wall"]');
      return element && { box: boxAround(element), text: this.t(step), near: [] };
    }
    const planner = this.failing();
    if (!planner || planner === this.state.focus) return null;
    const element =
      inside("parkade-chips", `[data-planner="${planner}"]`) ??
      inside("parkade-stage", `.legend [data-planner="${planner}"]`) ??
      inside(
        `parkade-panel[data-planner="${planner}"]`,
        ".chip",
        root.querySelector("parkade-stage")?.shadowRoot ?? root,
      );
    return (
      element && {
        box: boxAround(element),
        text: this.t(step, { planner: plannerName(this.state.lang, planner) }),
        near: [],
      }
    );
  }

  private failing(): PlannerId | undefined {
    return this.state.planners.find(
      (planner) => this.state.results[planner]?.status === "done" && statusOf(this.state, planner).tone === "err",
    );
  }
}

/** From the bubble to its thing, however far it stands. */
function arrow({ tip: [x, y], to: [toX, toY] }: Spot): TemplateResult {
  return html`<u
    .style=${
      `left:${Math.min(x, toX)}px;top:${Math.min(y, toY)}px;width:${Math.abs(toX - x)}px;` +
      `height:${Math.abs(toY - y)}px`
    }></u><i
    .style=${`left:${x}px;top:${y}px`}></i>`;
}

customElements.define("parkade-hints", Hints);
