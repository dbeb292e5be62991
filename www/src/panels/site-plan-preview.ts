/** A site plan in its layers' roles, on which a known distance is drawn. */
import type { Role } from "parkade/siteplan";
import { css, html, type TemplateResult } from "lit";
import type { Point } from "../scene/geometry";
import { slotOutline } from "../scene/slots";
import type { Scenario } from "../scene/scenario";
import { joined, type PlanOutline } from "../siteplan/plan-outline";
import type { State } from "../store";
import type { Tokens } from "../view/tokens";
import { AppElement } from "./base";
import type { On } from "./inputs";
import { PlanPainter, trace, type Fit, type LineStyle } from "./site-plan-painter";

const EDGE = 14;

export class SitePlanPreview extends AppElement {
  static override properties = {
    ...AppElement.properties,
    plan: { attribute: false },
    roles: { attribute: false },
    scene: { attribute: false },
    unit: { type: Number },
    lit: { type: String },
    ruler: { attribute: false },
    label: { type: String },
  };
  static override styles = css`
    :host {
      position: relative; display: block; min-width: 0; overflow: hidden; background: var(--parkade-out);
      border-radius: calc(8px * var(--parkade-radius));
    }
    canvas { position: absolute; inset: 0; width: 100%; height: 100%; cursor: crosshair; touch-action: none; }
  `;
  declare plan: PlanOutline | null;
  declare roles: Readonly<Record<string, Role>>;
  /** What would open. */
  declare scene: Scenario | null;
  /** Metres per unit. */
  declare unit: number;
  /** The layer pointed at. */
  declare lit: string;
  /** Both ends of the distance that is drawn, in units. */
  declare ruler: [Point, Point] | null;
  declare label: string;
  private readonly resized = new ResizeObserver(() => this.requestUpdate());
  /** The plan as it is shown, and as it is painted for the next picture. */
  private shown = new PlanPainter();
  private next = new PlanPainter();
  /** What the last picture was begun for. */
  private begun: readonly unknown[] = [];
  private frame = 0;

  constructor() {
    super();
    this.plan = null;
    this.ruler = null;
    this.lit = this.label = "";
    this.resized.observe(this);
  }

  protected watches(): readonly (keyof State)[] {
    return ["theme"];
  }

  protected override render(): TemplateResult {
    return html`<canvas role="img" aria-label=${this.label} @pointerdown=${this.down}
      @pointermove=${this.move}></canvas>`;
  }

  protected override updated(): void {
    const { plan, roles, lit, clientWidth: width, clientHeight: height } = this;
    if (!plan || width === 0) return;
    const ratio = devicePixelRatio || 1,
      { colour } = this.app.tokens(),
      wanted = [plan, roles, lit, width, height, ratio, JSON.stringify(colour)];
    if (wanted.some((one, i) => one !== this.begun[i])) {
      this.begun = wanted;
      const styles = plan.layers.map(
        (layer) => [layer, styleOf(roles[layer.name] ?? "none", colour, layer.name === lit)] as const,
      );
      this.next.begin({ width, height, ratio }, styles, this.fit());
      this.paintOn();
    }
    this.compose(colour);
  }

  /** Paints a share of the plan now and, while more is left, another in each frame. What was shown stays until then. */
  private paintOn(): void {
    cancelAnimationFrame(this.frame);
    this.next.paint();
    if (this.next.isDone) [this.shown, this.next] = [this.next, this.shown];
    else
      this.frame = requestAnimationFrame(() => {
        this.paintOn();
        this.compose(this.app.tokens().colour);
      });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    cancelAnimationFrame(this.frame);
  }

  /** The plan, the bays that would open, and the distance that is drawn. */
  private compose(colour: Tokens["colour"]): void {
    const canvas = this.renderRoot.querySelector("canvas");
    if (!canvas || !this.plan) return;
    const { clientWidth: width, clientHeight: height } = canvas,
      ratio = devicePixelRatio || 1,
      ctx = canvas.getContext("2d")!,
      fit = this.fit();
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    ctx.scale(ratio, ratio);
    // The first picture shows as it grows.
    const painted = this.shown.canvas.width === canvas.width ? this.shown : this.next;
    if (painted.canvas.width > 0 && painted.canvas.height > 0) ctx.drawImage(painted.canvas, 0, 0, width, height);
    this.paintBays(ctx, colour, fit);
    if (this.ruler) {
      ctx.strokeStyle = colour.accent;
      ctx.lineWidth = 2;
      ctx.setLineDash([]);
      trace(ctx, this.ruler.flat(), false, fit);
      ctx.stroke();
    }
  }

  /** Bays as they would open: the open side is left out, a stroke leads in. */
  private paintBays(ctx: CanvasRenderingContext2D, colour: Tokens["colour"], fit: Fit): void {
    const { scene, unit } = this,
      low = this.lowest();
    if (!scene || !low) return;
    ctx.strokeStyle = colour.accent;
    ctx.lineWidth = 1.25;
    ctx.setLineDash([]);
    const back = ([x, y]: Point): Point => [x / unit + low[0], y / unit + low[1]];
    for (const slot of scene.slots ?? []) {
      const [p, q, r, s] = slotOutline(slot),
        [a, b, c, d] = [back(p), back(q), back(r), back(s)],
        mouth: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
        deep: Point = [(a[0] + b[0] + c[0] + d[0]) / 4, (a[1] + b[1] + c[1] + d[1]) / 4];
      for (const points of [
        [a, d, c, b],
        [mouth, deep],
      ]) {
        trace(ctx, points.flat(), false, fit);
        ctx.stroke();
      }
    }
  }

  /** The lower left corner of the chosen layers, from which a scene measures. */
  private lowest(): Point | null {
    const chosen = this.plan!.layers.filter(({ name }) => (this.roles[name] ?? "none") !== "none");
    if (chosen.length === 0) return null;
    const { minX, minY } = joined(chosen.map(({ box }) => box));
    return [minX, minY];
  }

  private fit(): Fit {
    const { clientWidth: width, clientHeight: height } = this,
      { box } = this.plan!;
    const scale = Math.min(
      (width - 2 * EDGE) / Math.max(box.maxX - box.minX, 1e-9),
      (height - 2 * EDGE) / Math.max(box.maxY - box.minY, 1e-9),
    );
    return {
      scale,
      x: width / 2 - ((box.minX + box.maxX) / 2) * scale,
      y: height / 2 + ((box.minY + box.maxY) / 2) * scale,
    };
  }

  private at(event: PointerEvent): Point {
    const { left, top } = this.getBoundingClientRect(),
      { scale, x, y } = this.fit();
    return [(event.clientX - left - x) / scale, (y - (event.clientY - top)) / scale];
  }

  private readonly down = (event: On<HTMLElement, PointerEvent>): void => {
    event.currentTarget.setPointerCapture(event.pointerId);
    const at = this.at(event);
    this.ruler = [at, at];
  };

  private readonly move = (event: PointerEvent): void => {
    if (event.buttons === 0 || !this.ruler) return;
    this.ruler = [this.ruler[0], this.at(event)];
    this.dispatchEvent(new CustomEvent("ruler", { detail: this.ruler }));
  };
}

function styleOf(role: Role, colour: Tokens["colour"], lit: boolean): LineStyle {
  const base: LineStyle = { stroke: colour["obs-edge"], width: 1.25, dash: [], fill: null, alpha: 1 };
  const own: Partial<Record<Role, Partial<LineStyle>>> = {
    none: { stroke: colour.t3, width: 1, alpha: 0.35 },
    wall: { width: 2 },
    kerb: { dash: [5, 3] },
    column: { fill: colour.obs },
    building: { fill: colour.obs },
    bay: { stroke: colour.slot, width: 1 },
    ground: { stroke: colour.t1, fill: colour.floor, dash: [8, 3, 2, 3] },
  };
  return { ...base, ...own[role], ...(lit ? { stroke: colour.accent, width: 3, alpha: 1 } : {}) };
}

customElements.define("parkade-site-plan-preview", SitePlanPreview);
