import type { Plan } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import { axisOf, coordinateOf, groundOf, outward, SIDES, sizeAlong, type Side } from "../scene/ground";
import type { Camera, Scene, State } from "../store";
import { arrowOf } from "../tools/arrow-keys";
import { fitMap, worldToScreen } from "../view/camera";
import { AppElement } from "./base";
import { say } from "./new-lot-messages";
import "./thumbnail";
import type { On } from "./inputs";

/** A size that the border is dragged to, metres; null gives the drag up. */
export interface Resize {
  field: "width" | "depth";
  metres: number | null;
}

/** `from` is the size at the press, `at` the pixel. */
interface Drag {
  side: Side;
  from: number;
  at: number;
  camera: Camera;
}

/** The lot in its ground, whose sides are dragged or moved by arrow keys. */
export class LotPreview extends AppElement {
  static override properties = {
    ...AppElement.properties,
    scene: { attribute: false },
    plan: { attribute: false },
    stale: { type: Boolean },
    drag: { state: true },
  };
  static override styles = css`
    :host { position: relative; min-width: 0; overflow: hidden; background: var(--parkade-out); }
    parkade-thumbnail { position: absolute; inset: 0; }
    .stale { opacity: .4; }
    button {
      position: absolute; width: 24px; height: 24px; margin: -12px 0 0 -12px; padding: 0; border: 0; background: none;
      cursor: ew-resize; touch-action: none;
    }
    .up { cursor: ns-resize; }
    button::before {
      content: ""; position: absolute; inset: 0; margin: auto; width: 7px; height: 7px;
      border: 1.5px solid var(--parkade-obs-edge); background: var(--parkade-floor);
    }
    button:hover::before, .held::before { background: var(--parkade-accent); border-color: var(--parkade-accent); }
    button:focus-visible { outline: 2px solid var(--parkade-accent); outline-offset: -4px; }
    span {
      position: absolute; left: 50%; top: 50%; translate: -50% -50%; padding: 0 8px; border-radius: 5px;
      background: var(--parkade-accent); color: var(--parkade-panel); font-size: 12px; line-height: 22px;
      white-space: nowrap; pointer-events: none;
    }
    .right span { translate: calc(-100% - 12px) -50%; }
    .left span { translate: 12px -50%; }
    .top span { translate: -50% 12px; }
    .bottom span { translate: -50% calc(-100% - 12px); }
    button:not(.held, :focus-visible) span { display: none; }
    @media (pointer: coarse) { button { width: 44px; height: 44px; margin: -22px 0 0 -22px; } }
  `;
  declare scene: Scene;
  declare plan: Plan | null;
  declare stale: boolean;
  declare drag: Drag | null;
  private readonly resized = new ResizeObserver(() => this.requestUpdate());

  constructor() {
    super();
    this.drag = null;
    this.resized.observe(this);
  }

  protected watches(): readonly (keyof State)[] {
    return ["theme"];
  }

  protected override render(): TemplateResult | typeof nothing {
    const { clientWidth: width, clientHeight: height, scene } = this;
    if (width === 0) return nothing;
    const camera = this.camera(width, height),
      box = groundOf(scene),
      middle = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2] as const;
    return html`<parkade-thumbnail class=${this.stale ? "stale" : ""} role="img"
      aria-label=${say(this.state.lang, "lot")} .app=${this.app} .scene=${scene} .plan=${this.plan}
      .camera=${camera}></parkade-thumbnail>
      ${SIDES.map((side) => {
        const k = axisOf(side),
          at = coordinateOf(box, side),
          [left, top] = worldToScreen({ camera, width, height }, k === 0 ? at : middle[0], k === 0 ? middle[1] : at),
          size = `${this.num(sizeAlong(box, k), 1)} m`;
        return html`<button type="button" role="slider"
          class="${side} ${k === 1 ? "up" : ""} ${this.drag?.side === side ? "held" : ""}"
          .style=${`left:${left}px;top:${top}px`} aria-label=${say(this.state.lang, `${side}Side`)}
          aria-orientation=${k === 0 ? "horizontal" : "vertical"} aria-valuemin="6" aria-valuemax="200"
          aria-valuenow=${sizeAlong(box, k)} aria-valuetext=${size}
          @pointerdown=${(e: On<HTMLElement, PointerEvent>) => this.press(e, side)} @pointermove=${this.pull}
          @pointerup=${this.release} @pointercancel=${this.giveUp}
          @keydown=${(e: KeyboardEvent) => this.key(e, side)}><span>${size}</span></button>`;
      })}`;
  }

  /** Under a drag the side across from it rests, however the lot's own coordinates move. */
  private camera(width: number, height: number): Camera {
    const { drag, scene } = this;
    if (!drag) return fitMap(scene, width, height);
    const grown = outward(drag.side) < 0 ? this.sizeOf(drag.side) - drag.from : 0,
      k = axisOf(drag.side);
    return { ...drag.camera, x: drag.camera.x + (k === 0 ? grown : 0), y: drag.camera.y + (k === 1 ? grown : 0) };
  }

  private sizeOf(side: Side): number {
    return sizeAlong(groundOf(this.scene), axisOf(side));
  }

  private press(event: On<HTMLElement, PointerEvent>, side: Side): void {
    if (event.button !== 0 || this.drag) return;
    const target = event.currentTarget;
    target.setPointerCapture(event.pointerId);
    this.drag = {
      side,
      from: this.sizeOf(side),
      at: pixelOf(event, side),
      camera: fitMap(this.scene, this.clientWidth, this.clientHeight),
    };
  }

  private readonly pull = (event: PointerEvent): void => {
    const { drag } = this;
    if (drag) this.ask(drag.side, drag.from + (pixelOf(event, drag.side) - drag.at) / drag.camera.scale);
  };

  private readonly release = (): void => {
    this.drag = null;
  };

  private readonly giveUp = (): void => {
    if (this.drag) this.ask(this.drag.side, null);
    this.drag = null;
  };

  private key(event: KeyboardEvent, side: Side): void {
    const way = arrowOf(event.key)?.[axisOf(side)];
    if (way) this.ask(side, this.sizeOf(side) + way * outward(side) * (event.shiftKey ? 1 : 0.1));
    else if (event.key === "Escape" && this.drag) this.giveUp();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private ask(side: Side, metres: number | null): void {
    const detail: Resize = {
      field: axisOf(side) === 0 ? "width" : "depth",
      metres: metres === null ? null : Math.round(metres * 10) / 10,
    };
    this.dispatchEvent(new CustomEvent<Resize>("parkade-ground", { detail }));
  }
}

/** Pixels outward. */
const pixelOf = (event: PointerEvent, side: Side): number =>
  (axisOf(side) === 0 ? event.clientX : -event.clientY) * outward(side);

customElements.define("parkade-lot-preview", LotPreview);
