import type { Drive, Plan, PlannerId } from "parkade";
import { css, html, nothing, svg, type SVGTemplateResult, type TemplateResult } from "lit";
import "../i18n/later";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { clockOf, drivenAt, rowAt } from "../view/playback-time";
import { cuspsOf, distancesOf, nearestPose, poseAtDistance } from "../view/drive";
import { identityOf } from "../styles/planner-style";
import { AppElement } from "./base";
import { plannerColour } from "../styles/icons";
import { drivablePlan } from "../texts/status";
import { focusedPlan, reverseSpans } from "./timeline";

type Quantity = "curvature" | "clearance" | "speed";
interface Position {
  at: number;
  clock: number | null;
}
/** `timed`: it has a drive, or will have one when the pointer rests. */
interface Line {
  planner: PlannerId;
  plan: Plan;
  drive: Drive | null;
  timed: boolean;
}
interface Content {
  lines: Line[];
  total: number;
  plots: Plot[];
  drawn: SVGTemplateResult;
}
/** `blank`: there is nothing to show yet. */
interface Plot {
  quantity: Quantity;
  top: number;
  height: number;
  low: number;
  high: number;
  blank?: boolean;
}

const WIDTH = 1000;
const HEIGHT = 160;
/** Points closer than this fall on one pixel. */
const MIN_STEP = 2.5;
/** Steps closer than this fall on one line: of those only the peaks show. */
const MIN_GAP = 0.5;
const HOVER_REACH = 1.5;

/** Curvature, clearance and speed over the way driven, marked where the pointer is on the map. */
export class Charts extends AppElement {
  static override styles = [
    controls,
    css`
    :host { display: grid; grid-template-columns: 54px 1fr 96px; min-height: 0; background: var(--parkade-panel); border-left: 1px solid var(--parkade-hair); font-size: 12px; line-height: 16px; padding: 8px 0 0; }
    .plots { position: relative; min-width: 0; }
    .all { position: absolute; inset: 0 0 20px; width: 100%; height: calc(100% - 20px); overflow: visible; cursor: crosshair; }
    path, line { fill: none; vector-effect: non-scaling-stroke; }
    .limit { stroke: var(--parkade-t3); stroke-dasharray: 4 3; }
    .zero { stroke: var(--parkade-hair2); }
    .line { stroke-width: 1.5; stroke-linejoin: round; }
    .band { fill: var(--parkade-t1); opacity: .05; }
    .cusp { stroke: var(--parkade-t1); }
    .dot { position: absolute; width: 9px; height: 9px; margin: -4.5px 0 0 -4.5px; border: 2px solid; border-radius: 50%; background: var(--parkade-panel); pointer-events: none; }
    .diamond { position: absolute; top: -5px; width: 10px; height: 10px; margin-left: -5px; overflow: visible; } .diamond path { fill: #fff; stroke: #1b1d20; stroke-width: 1.25; }
    .cursor { stroke: var(--parkade-t1); stroke-dasharray: 2 3; }
    .reverse { stroke: var(--parkade-t1); stroke-width: 3; stroke-dasharray: 0.1 5; stroke-linecap: round; }
    .axis { container-type: inline-size; position: absolute; left: 0; right: 0; bottom: 0; height: 18px; color: var(--parkade-t2); }
    .axis span { position: absolute; transform: translateX(calc(var(--at) - 50%)); }
    .axis span:last-child::after { content: "m"; position: absolute; left: calc(100% + 3px); }
    .axis span:first-child { transform: none; }
    .left, .right { position: relative; }
    .left span { position: absolute; right: 6px; transform: translateY(-50%); color: var(--parkade-t2); }
    .right div { position: absolute; left: 12px; transform: translateY(-50%); color: var(--parkade-t2); }
    .right b { display: block; font-weight: 600; color: var(--parkade-t1); white-space: nowrap; }
    .none { grid-column: 1 / -1; place-self: center; color: var(--parkade-t3); }
  `,
  ];

  protected override pace = 100;
  protected override waits = true;
  private cached: (Pick<State, "results" | "focus" | "hidden"> & { content: Content }) | null = null;

  protected watches(): readonly (keyof State)[] {
    return ["results", "focus", "hidden", "hover", "playback"];
  }

  protected override render(): TemplateResult {
    const { lines, total, plots, drawn } = this.content();
    if (lines.length === 0) return html`<p class="none">${this.t("chart.none")}</p>`;
    const position = this.position(),
      at = position && position.at;
    const percent = (y: number): string => `top:calc((100% - 20px) * ${y / HEIGHT})`;
    return html`
      <div class="left" aria-hidden="true">${plots.map((plot) =>
        plot.blank
          ? nothing
          : [plot.high, plot.low].map(
              (value) => html`
        <span .style=${percent(yOf(plot, value))}>${this.num(value, plot.quantity === "curvature" ? 3 : 1)}</span>`,
            ),
      )}</div>
      <div class="plots" role="img" aria-label="${this.t("chart.label")}: ${plots.map(({ quantity }) => this.t(`chart.${quantity}`)).join(", ")}">
        <svg class="all" viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="none" @pointermove=${(e: PointerEvent) => this.point(e, total)} @pointerleave=${() => this.app.store.set({ hover: null })}>
          <rect width=${WIDTH} height=${HEIGHT} fill="transparent"/>
          ${drawn}
          ${at === null ? nothing : svg`<line class="cursor" x1=${(at / total) * WIDTH} x2=${(at / total) * WIDTH} y1="0" y2=${HEIGHT}/>`}
        </svg>
        ${this.cusps(total).map((x) => html`<svg class="diamond" .style=${`left:${x * 100}%`} viewBox="0 0 10 10" aria-hidden="true"><path d="M5 0l5 5-5 5-5-5z"/></svg>`)}
        ${at === null ? nothing : plots.map((plot) => this.dot(plot, position!, total, percent))}
        <div class="axis" aria-hidden="true">${ticks(total).map((tick) => html`<span .style=${`--at:${(tick / total) * 100}cqw`}>${this.num(tick, 0)}</span>`)}</div>
      </div>
      <div class="right" aria-hidden="true">${plots.map((plot) => html`<div .style=${percent(plot.top + plot.height / 2)}>${this.t(`chart.${plot.quantity}`)}<b>${this.value(plot.quantity, position)}</b></div>`)}</div>`;
  }

  /** The lines change with the answers only, the cursor with every frame. */
  private content(): Content {
    const { results, focus, hidden } = this.state;
    const { cached } = this;
    if (cached && cached.results === results && cached.focus === focus && cached.hidden === hidden)
      return cached.content;
    const lines = linesOf(this.state);
    const total = Math.max(...lines.map(({ plan }) => distancesOf(plan).at(-1) ?? 0), 0.1);
    const plots = lines.length > 0 ? plotsOf(lines) : [];
    const content = {
      lines,
      total,
      plots,
      drawn: svg`${this.reverse(total)}${plots.map((plot) => this.plot(plot, lines, total))}`,
    };
    this.cached = { results, focus, hidden, content };
    return content;
  }

  private plot(plot: Plot, lines: readonly Line[], total: number): SVGTemplateResult {
    const limit = lines[0]!.plan.metrics.curvatureLimit,
      metrics = focusedPlan(this.state)?.metrics;
    const margin = metrics && "margin" in metrics ? metrics.margin : undefined;
    const rule = (value: number, name: string): SVGTemplateResult =>
      svg`<line class=${name} x1="0" x2=${WIDTH} y1=${yOf(plot, value)} y2=${yOf(plot, value)}/>`;
    return svg`${plot.quantity === "curvature" ? [rule(limit, "limit"), rule(-limit, "limit"), rule(0, "zero")] : [rule(0, "zero"), plot.quantity === "clearance" && margin ? rule(margin, "limit") : nothing]}
      ${lines.map(({ planner, plan, drive }) => svg`<path class="line" d=${lineOf(plot, plan, drive, total)} stroke=${plannerColour(planner)} stroke-dasharray=${identityOf(planner).dash.join(" ") || "none"}/>`)}`;
  }

  private reverse(total: number): SVGTemplateResult | typeof nothing {
    const plan = focusedPlan(this.state);
    if (!plan) return nothing;
    const length = distancesOf(plan).at(-1) ?? 0;
    return svg`${reverseSpans(plan).map(([from, to]) => svg`<rect class="band" x=${((from * length) / total) * WIDTH} width=${(((to - from) * length) / total) * WIDTH} y="0" height=${HEIGHT}/>`)}
      ${this.cusps(total).map((x) => svg`<line class="cusp" x1=${x * WIDTH} x2=${x * WIDTH} y1="0" y2=${HEIGHT}/>`)}
      ${reverseSpans(plan).map(([from, to]) => svg`<line class="reverse" x1=${((from * length) / total) * WIDTH} x2=${((to * length) / total) * WIDTH} y1=${HEIGHT} y2=${HEIGHT}/>`)}`;
  }

  /** Gear changes of the focused path, as shares of the axis. */
  private cusps(total: number): number[] {
    const plan = focusedPlan(this.state);
    return plan ? cuspsOf(plan).map((index) => distancesOf(plan)[index]! / total) : [];
  }

  /** Metres along the focused path: of the point nearest to the pointer, else of the moving car, with its clock. */
  private position(): Position | null {
    const { hover, playback } = this.state;
    const plan = focusedPlan(this.state);
    if (!plan) return null;
    const along = distancesOf(plan);
    const index = hover ? nearestPose(plan, hover.x, hover.y, HOVER_REACH) : null;
    if (index !== null) return { at: along[index]!, clock: null };
    if (playback.base !== "drive") return null;
    const car = drivenAt(this.state, plan, this.state.results[this.state.focus], 1);
    // Without moving obstacles the car is played at one speed, not at its own.
    return car && { at: car.along, clock: this.state.scene.moving?.length ? clockOf(this.state) : null };
  }

  /** The focused line's value at the cursor. */
  private dot(
    plot: Plot,
    position: Position,
    total: number,
    percent: (y: number) => string,
  ): TemplateResult | typeof nothing {
    const { at } = position,
      plan = focusedPlan(this.state),
      pose = plan && poseAtDistance(plan, at);
    if (!pose) return nothing;
    const value = plot.quantity === "speed" ? this.speed(position) : pose[plot.quantity];
    if (value === undefined || !Number.isFinite(value)) return nothing;
    return html`<i class="dot" .style=${`left:${(at / total) * 100}%;${percent(yOf(plot, value))};border-color:${plannerColour(this.state.focus)}`}></i>`;
  }

  private value(quantity: Quantity, position: Position | null): string {
    const plan = focusedPlan(this.state);
    const pose = plan && position ? poseAtDistance(plan, position.at) : null;
    if (!pose) return "–";
    if (quantity === "speed") {
      const speed = this.speed(position!);
      return speed === undefined ? "–" : `${this.num(speed, 2)} m/s`;
    }
    if (quantity === "clearance") return `${this.num(pose.clearance, 2)} m`;
    return Number.isFinite(pose.curvature) ? `${this.num(pose.curvature, 3)} 1/m` : this.t("table.corner");
  }

  /** A car that waits is at one place for a while: its clock tells whether it stands. */
  private speed({ at, clock }: Position): number | undefined {
    const drive = this.state.results[this.state.focus]?.drive;
    return drive?.speeds[clock === null ? rowAt(drive.stations, at) : rowAt(drive.t, clock)];
  }

  private point(event: PointerEvent, total: number): void {
    const box = (event.currentTarget as SVGElement).getBoundingClientRect();
    const plan = focusedPlan(this.state);
    const pose = plan ? poseAtDistance(plan, ((event.clientX - box.left) / box.width) * total) : null;
    if (pose) this.app.store.set({ hover: { x: pose.x, y: pose.y } });
  }
}

/** The drivable paths in sight, and the focused one. */
function linesOf(state: State): Line[] {
  return state.planners
    .filter((planner) => !state.hidden.has(planner))
    .flatMap((planner) => {
      const result = state.results[planner],
        drivable = drivablePlan(result);
      const plan = drivable ?? (planner === state.focus ? focusedPlan(state) : null);
      return plan
        ? [{ planner, plan, drive: result?.plan === plan ? result.drive : null, timed: drivable !== null }]
        : [];
    });
}

function plotsOf(lines: readonly Line[]): Plot[] {
  const limit = lines[0]!.plan.metrics.curvatureLimit;
  const clearances = lines.map(({ plan }) => plan.clearances.reduce((most, value) => Math.max(most, value), 0.5));
  const high = Math.max(...clearances);
  const drives = lines.flatMap(({ drive }) => drive ?? []);
  if (!lines.some(({ drive, timed }) => drive || timed)) {
    return [
      { quantity: "curvature", top: 6, height: 62, low: -limit, high: limit },
      { quantity: "clearance", top: 88, height: 62, low: 0, high },
    ];
  }
  return [
    { quantity: "curvature", top: 6, height: 40, low: -limit, high: limit },
    { quantity: "clearance", top: 60, height: 40, low: 0, high },
    {
      quantity: "speed",
      top: 114,
      height: 40,
      low: Math.min(0, ...drives.map((drive) => extremesOf(drive)[0])),
      high: Math.max(0.5, ...drives.map((drive) => extremesOf(drive)[1])),
      blank: drives.length === 0,
    },
  ];
}

const extremes = new WeakMap<Drive, readonly [low: number, high: number]>();

/** The lowest and the highest speed; ways of kilometres have very many. */
function extremesOf(drive: Drive): readonly [low: number, high: number] {
  let known = extremes.get(drive);
  if (!known) {
    let low = 0,
      high = 0.5;
    for (const speed of drive.speeds) {
      if (speed < low) low = speed;
      if (speed > high) high = speed;
    }
    extremes.set(drive, (known = [low, high]));
  }
  return known;
}

const drawn = new WeakMap<object, Map<Quantity, { key: string; text: string }>>();

/** A plan's line, drawn again only where the axes or the answer have changed: one planner's answer leaves the others' lines. */
function lineOf(plot: Plot, plan: Plan, drive: Drive | null, total: number): string {
  const of = plot.quantity === "speed" ? drive : plan;
  if (!of) return "";
  const key = [total, plot.top, plot.height, plot.low, plot.high].join(" "),
    lines = drawn.get(of) ?? new Map<Quantity, { key: string; text: string }>();
  drawn.set(of, lines);
  let line = lines.get(plot.quantity);
  if (line?.key !== key)
    lines.set(
      plot.quantity,
      (line = { key, text: of === drive ? speedPath(plot, drive, total) : pathOf(plot, plan, total) }),
    );
  return line.text;
}

const yOf = (plot: Plot, value: number): number => {
  const part = (value - plot.low) / (plot.high - plot.low);
  return plot.top + plot.height * (1 - Math.min(1.08, Math.max(-0.08, part)));
};

/** Curvature holds between poses, so it is drawn in steps; clearance is joined. */
function pathOf(plot: Plot, plan: Plan, total: number): string {
  const along = distancesOf(plan);
  const values = plot.quantity === "curvature" ? plan.curvatures : plan.clearances;
  const steps = plot.quantity === "curvature";
  let text = "",
    before: number | null = null,
    lastX = -MIN_STEP,
    peak = 0;
  for (let i = 0; i < along.length; i++) {
    const value = values[i]!;
    const x = (along[i]! / total) * WIDTH;
    const unseen = steps ? value === before && i < along.length - 1 : x - lastX < MIN_STEP && i < along.length - 1;
    if (!Number.isFinite(value) || unseen) continue;
    const y = yOf(plot, value).toFixed(1);
    if (steps && before !== null && x - lastX < MIN_GAP && i < along.length - 1) {
      before = value;
      if (Math.abs(value) <= peak) continue;
      peak = Math.abs(value);
      text += `V${y}`;
      continue;
    }
    peak = Math.abs(value);
    if (before === null) text += `M${x.toFixed(1)} ${y}`;
    else text += steps ? `H${x.toFixed(1)}V${y}` : `L${x.toFixed(1)} ${y}`;
    before = value;
    lastX = x;
  }
  return text;
}

/** Speed over the way driven, negative in reverse. */
function speedPath(plot: Plot, drive: Drive, total: number): string {
  let text = "",
    lastX = -MIN_STEP,
    lastY = "";
  const { stations, speeds } = drive;
  for (let i = 0; i < stations.length; i++) {
    const x = (stations[i]! / total) * WIDTH,
      inside = i > 0 && i < stations.length - 1;
    if (inside && x - lastX < MIN_GAP) continue;
    const y = yOf(plot, speeds[i]!).toFixed(1);
    if (inside && x - lastX < MIN_STEP && y === lastY) continue;
    text += `${text ? "L" : "M"}${x.toFixed(1)} ${y}`;
    lastX = x;
    lastY = y;
  }
  return text;
}

function ticks(total: number): number[] {
  const step = [1, 2, 5, 10, 20, 50, 100].find((one) => total / one <= 6) ?? 200;
  return Array.from({ length: Math.floor(total / step) + 1 }, (_, i) => i * step);
}

customElements.define("parkade-charts", Charts);
