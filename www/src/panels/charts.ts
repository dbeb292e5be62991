import { css, html, nothing, svg, type SVGTemplateResult, type TemplateResult } from "lit";
import "../i18n/later";
import messages from "../i18n/messages/charts.json";
import { translator } from "../i18n/translator";
import type { State } from "../store";
import { focusedPlan, played } from "../store/results";
import { controls } from "../styles/controls";
import { plannerColour } from "../styles/icons";
import { distancesOf, nearestPose, poseAtDistance } from "../view/drive";
import { gearsOfDrive, gearsOfPath, type Gears } from "../view/gears";
import { atTime, clockOf, drivenAt, rowAt } from "../view/playback-time";
import { AppElement } from "./base";
import {
  HEIGHT,
  WIDTH,
  extentOf,
  linesOf,
  pathOf,
  plotsOf,
  ticks,
  valueAt,
  yOf,
  type Axis,
  type Line,
  type Plot,
  type Quantity,
} from "./chart-lines";
import { lastIn, nth } from "../scene/nth";
import type { On } from "./inputs";

/** A place on the x axis, in metres or seconds: the focused path's place and, where it is known, its moment. */
interface Position {
  at: number;
  clock: number | null;
  x: number;
}
interface Content {
  lines: Line[];
  total: number;
  plots: Plot[];
  drawn: SVGTemplateResult;
}

const HOVER_REACH = 1.5;
const AXES = ["path", "time"] as const;
const UNITS: Record<Quantity, string> = {
  curvature: "1/m",
  clearance: "m",
  speed: "m/s",
  acceleration: "m/s²",
  steering: "°",
  steeringRate: "°/s",
};
const say = translator("charts", messages);

/**
 * Curvature, clearance and speed along the path, or the car's motion in time; marked where the pointer is on the map.
 */
export class Charts extends AppElement {
  static override properties = { ...AppElement.properties, axis: { state: true } };
  static override styles = [
    controls,
    css`
    :host {
      display: grid; grid-template-columns: 54px 1fr 96px; min-height: 0; background: var(--parkade-panel);
      border-left: 1px solid var(--parkade-hair); font-size: 12px; line-height: 16px; padding: 8px 0 0;
    }
    .plots { position: relative; min-width: 0; container-type: size; }
    .all {
      position: absolute; inset: 0 0 26px; width: 100%; height: calc(100% - 26px); overflow: visible; cursor: crosshair;
    }
    path, line { fill: none; vector-effect: non-scaling-stroke; }
    .limit { stroke: var(--parkade-t3); stroke-dasharray: 4 3; }
    .zero { stroke: var(--parkade-hair2); }
    .line { stroke-width: 1.5; stroke-linejoin: round; }
    .band { fill: var(--parkade-t1); opacity: .05; }
    .cusp { stroke: var(--parkade-t1); }
    .dot {
      position: absolute; top: 0; left: 0; width: 9px; height: 9px; margin: -4.5px 0 0 -4.5px; border: 2px solid;
      border-radius: 50%; background: var(--parkade-panel); pointer-events: none;
    }
    .diamond {
      position: absolute; top: -5px; left: 0; width: 10px; height: 10px; margin-left: -5px; overflow: visible;
    }
    .diamond path { fill: #fff; stroke: #1b1d20; stroke-width: 1.25; }
    .cursor { stroke: var(--parkade-t1); stroke-dasharray: 2 3; }
    .reverse { stroke: var(--parkade-t1); stroke-width: 3; stroke-dasharray: 0.1 5; stroke-linecap: round; }
    .axis {
      container-type: inline-size; position: absolute; left: 0; right: 0; bottom: 2px; height: 22px;
      color: var(--parkade-t2);
    }
    .axis span { position: absolute; transform: translateX(calc(var(--at) - 50%)); }
    .axis span:last-child::after { content: var(--unit); position: absolute; left: calc(100% + 3px); }
    .axis span:first-child { transform: none; }
    .left, .right { position: relative; }
    .left span { position: absolute; right: 6px; transform: translateY(-50%); color: var(--parkade-t2); }
    .close span:nth-child(odd) { transform: translateY(-12%); }
    .close span:nth-child(even) { transform: translateY(-88%); }
    .right div { position: absolute; left: 12px; transform: translateY(-50%); color: var(--parkade-t2); }
    .right b { display: block; font-weight: 600; color: var(--parkade-t1); white-space: nowrap; }
    .axes { position: absolute; right: 4px; bottom: 1px; padding: 0; }
    .axes button { min-width: 42px; height: 24px; padding: 0 6px; font-size: 12px; }
    .none { grid-column: 1 / -1; place-self: center; color: var(--parkade-t3); }
  `,
  ];

  declare axis: Axis;
  protected override redrawMs = 100;
  protected override waits = true;
  private cached: (Pick<State, "results" | "focus" | "hidden" | "guest"> & { axis: Axis; content: Content }) | null =
    null;
  /** The moment that the pointer is at, as long as nothing else moves the hover. */
  private pointed: { hover: State["hover"]; clock: number } | null = null;

  constructor() {
    super();
    this.axis = "path";
  }

  protected watches(): readonly (keyof State)[] {
    return ["results", "focus", "hidden", "hover", "playback", "guest"];
  }

  protected override render(): TemplateResult {
    const { lines, total, plots, drawn } = this.content();
    if (lines.length === 0) return html`<p class="none">${this.t("chart.none")}</p>`;
    const { lang } = this.state,
      isTime = this.axis === "time",
      position = this.position();
    const percent = (y: number): string => `top:calc((100% - 26px) * ${y / HEIGHT})`;
    return html`
      <div class="left ${plots.length > 3 ? "close" : ""}" aria-hidden="true">${plots.map((plot) =>
        plot.blank
          ? nothing
          : [plot.high, plot.low].map(
              (value) => html`
        <span .style=${percent(yOf(plot, value))}>${this.num(value, digitsOf(plot))}</span>`,
            ),
      )}</div>
      <div class="plots" role="img" aria-label="${isTime ? say(lang, "label") : this.t("chart.label")}: ${plots
        .map(({ quantity }) => this.name(quantity))
        .join(", ")}">
        <svg class="all" viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="none"
          @pointermove=${(e: On<SVGElement, PointerEvent>) => this.point(e, total)}
          @pointerleave=${() => this.app.store.set({ hover: null })}>
          <rect width=${WIDTH} height=${HEIGHT} fill="transparent"/>
          ${drawn}
          ${
            position
              ? svg`<line class="cursor" x1=${(position.x / total) * WIDTH} x2=${(position.x / total) * WIDTH} y1="0"
                y2=${HEIGHT}/>`
              : nothing
          }
        </svg>
        ${this.gears().changes.map(
          (at) =>
            html`<svg class="diamond" .style=${`transform:translateX(${(at / total) * 100}cqw)`} viewBox="0 0 10 10"
              aria-hidden="true"><path d="M5 0l5 5-5 5-5-5z"/></svg>`,
        )}
        ${position ? plots.map((plot) => this.dot(plot, position, total)) : nothing}
        <div class="axis" aria-hidden="true" .style=${`--unit:"${isTime ? "s" : "m"}"`}>${ticks(total).map(
          (tick) => html`<span .style=${`--at:${(tick / total) * 100}cqw`}>${this.num(tick, 0)}</span>`,
        )}</div>
      </div>
      <div class="right"><span aria-hidden="true">${plots.map(
        (plot) =>
          html`<div .style=${percent(
            plot.top + plot.height / 2,
          )}>${this.name(plot.quantity)}<b>${this.value(plot.quantity, position)}</b></div>`,
      )}</span>
        <span class="axes segmented" role="group" aria-label=${say(lang, "axis")}>${AXES.map(
          (one) =>
            html`<button aria-pressed=${one === this.axis} @click=${() => {
              this.axis = one;
            }}>${say(lang, one)}</button>`,
        )}</span></div>`;
  }

  private name(quantity: Quantity): string {
    return quantity === "curvature" || quantity === "clearance" || quantity === "speed"
      ? this.t(`chart.${quantity}`)
      : say(this.state.lang, quantity);
  }

  /** The lines change with the answers only, the cursor with every frame. */
  private content(): Content {
    const { results, focus, hidden, guest } = this.state,
      { cached, axis } = this;
    const isSame =
      cached?.results === results && cached.focus === focus && cached.hidden === hidden && cached.guest === guest;
    if (isSame && cached.axis === axis) return cached.content;
    const lines = linesOf(this.state),
      total = extentOf(lines, axis),
      plots = lines.length > 0 ? plotsOf(this.state, lines, axis) : [];
    const drawn = svg`${this.reverse(total)}${plots.map((plot) => this.plot(plot, lines, total))}`;
    const content = { lines, total, plots, drawn };
    this.cached = { results, focus, hidden, guest, axis, content };
    return content;
  }

  private plot(plot: Plot, lines: readonly Line[], total: number): SVGTemplateResult {
    const metrics = focusedPlan(this.state)?.metrics,
      margin = metrics && "margin" in metrics ? metrics.margin : undefined;
    const rule = (value: number, name: string): SVGTemplateResult =>
      svg`<line class=${name} x1="0" x2=${WIDTH} y1=${yOf(plot, value)} y2=${yOf(plot, value)}/>`;
    const isLimited = plot.quantity === "curvature" || plot.quantity === "steering";
    return svg`${
      isLimited ? [rule(plot.high, "limit"), rule(plot.low, "limit")] : nothing
    }${rule(0, "zero")}${plot.quantity === "clearance" && margin ? rule(margin, "limit") : nothing}
      ${lines.map(
        (line) =>
          svg`<path class="line" d=${pathOf(plot, line, this.axis, total)} stroke=${line.colour}
            stroke-dasharray=${line.dash}/>`,
      )}`;
  }

  /** Of the focused path, in the axis's unit. */
  private gears(): Gears {
    const { plan, drive } = played(this.state.results[this.state.focus]) ?? {};
    if (this.axis === "time") return drive ? gearsOfDrive(drive) : { reverse: [], changes: [] };
    return plan?.outcome === "found" ? gearsOfPath(plan) : { reverse: [], changes: [] };
  }

  private reverse(total: number): SVGTemplateResult {
    const { reverse, changes } = this.gears(),
      x = (at: number): number => (at / total) * WIDTH;
    return svg`${reverse.map(
      ([from, to]) => svg`<rect class="band" x=${x(from)} width=${x(to - from)} y="0" height=${HEIGHT}/>`,
    )}
      ${changes.map((at) => svg`<line class="cusp" x1=${x(at)} x2=${x(at)} y1="0" y2=${HEIGHT}/>`)}
      ${reverse.map(([from, to]) => svg`<line class="reverse" x1=${x(from)} x2=${x(to)} y1=${HEIGHT} y2=${HEIGHT}/>`)}`;
  }

  /** Of the point of the focused path that is nearest to the pointer, else of the moving car. */
  private position(): Position | null {
    const { hover, playback, results, focus } = this.state,
      { plan, drive } = played(results[focus]) ?? {},
      isTime = this.axis === "time";
    if (plan?.outcome !== "found" || (isTime && !drive)) return null;
    const along = distancesOf(plan);
    const place = (at: number, clock: number | null): Position => ({ at, clock, x: isTime ? clock! : at });
    const index = hover ? nearestPose(plan, hover.x, hover.y, HOVER_REACH) : null;
    if (index !== null) {
      const clock = hover === this.pointed?.hover ? this.pointed!.clock : null;
      return place(
        nth(along, index),
        clock ?? (drive ? (drive.t[rowAt(drive.stations, nth(along, index))] ?? null) : null),
      );
    }
    if (playback.base !== "drive") return null;
    const car = drivenAt(this.state, plan, results[focus], 1);
    return car && place(car.along, drive ? Math.min(clockOf(this.state), lastIn(drive.t)) : null);
  }

  private focused(): Line | undefined {
    const plan = focusedPlan(this.state);
    return this.content().lines.find((line) => line.plan === plan);
  }

  /** The focused line's value at the cursor. */
  private dot(plot: Plot, position: Position, total: number): TemplateResult | typeof nothing {
    const line = this.focused(),
      value = line ? valueAt(line, plot.quantity, position) : null;
    if (value === null) return nothing;
    return html`<i class="dot"
      .style=${
        `transform:translate(${(position.x / total) * 100}cqw,calc((100cqh - 26px) ` +
        `* ${yOf(plot, value) / HEIGHT}));border-color:${plannerColour(this.state.focus)}`
      }></i>`;
  }

  private value(quantity: Quantity, position: Position | null): string {
    const line = this.focused();
    if (!line || !position) return "–";
    const value = valueAt(line, quantity, position);
    if (value === null) return quantity === "curvature" && line.plan ? this.t("table.corner") : "–";
    const unit = UNITS[quantity];
    return `${this.num(
      value,
      quantity === "curvature" ? 3 : quantity.startsWith("steering") ? 1 : 2,
    )}${unit.startsWith("°") ? "" : " "}${unit}`;
  }

  private point(event: On<SVGElement, PointerEvent>, total: number): void {
    const box = event.currentTarget.getBoundingClientRect(),
      at = ((event.clientX - box.left) / box.width) * total,
      { plan, drive } = played(this.state.results[this.state.focus]) ?? {};
    const isTime = this.axis === "time",
      pose = isTime ? drive && atTime(drive, at)?.pose : plan && poseAtDistance(plan, at);
    if (!pose) return;
    const hover = { x: pose.x, y: pose.y };
    this.pointed = isTime ? { hover, clock: Math.min(at, lastIn(drive!.t)) } : null;
    this.app.store.set({ hover });
  }
}

/** Of the numbers at the ends of an axis. */
const digitsOf = ({ quantity }: Plot): number =>
  quantity === "curvature" ? 3 : quantity.startsWith("steering") ? 0 : 1;

customElements.define("parkade-charts", Charts);
