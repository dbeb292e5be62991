import { css, html, nothing, type TemplateResult } from "lit";
import type { HybridPlan, PlannerId } from "parkade";
import { number } from "../i18n/index";
import { ArcWalk, type FailedConnection } from "../planning/arc-walk";
import { resolve } from "../scene/model";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { icon, type IconName } from "../styles/icons";
import { say } from "../texts/search-steps";
import { thingName } from "../texts/status";
import { drawArcWalk } from "../view/layers/arc-walk";
import type { Frame } from "../view/frame";
import { AppElement } from "./base";
import { debuggerStyles } from "./debugger-styles";
import { numberOf, valueOf } from "./inputs";

const PER_SECOND = 8;
const DEGREES = 180 / Math.PI;

/** The debugger of searches for a car: their tree, pose by pose. */
export class ArcDebugger extends AppElement {
  static override properties = { ...AppElement.properties, step: { state: true }, unit: { state: true } };
  static override styles = [
    controls,
    debuggerStyles,
    css`:host { display: block; position: static; width: auto; max-width: none; height: auto; overflow: visible; border: 0; box-shadow: none; }`,
  ];
  declare step: number;
  declare unit: "step" | "failure";
  private walk: ArcWalk | null = null;
  private plan: HybridPlan | null = null;
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor() {
    super();
    this.step = 0;
    this.unit = "step";
  }

  protected watches(): readonly (keyof State)[] {
    return ["results", "focus"];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearInterval(this.timer);
  }

  private get planner(): PlannerId {
    return this.state.focus;
  }

  protected override willUpdate(): void {
    const plan = (this.state.results[this.planner]?.plan ?? null) as HybridPlan | null;
    if (plan === this.plan) return;
    this.plan = plan;
    this.walk = null;
    if (plan?.trace?.kind !== "arcs") return;
    const { start, goal } = resolve(this.state.scene),
      fromGoal = plan.member?.fromGoal ?? true;
    this.walk = new ArcWalk(plan.trace, fromGoal ? (plan.goal?.pose ?? goal) : start, fromGoal);
    this.go(0);
  }

  private go(step: number): void {
    const { walk } = this;
    if (!walk) return;
    this.step = Math.min(walk.steps - 1, Math.max(0, step));
    const { step: now, planner } = this;
    const { playback, layers } = this.state;
    this.app.store.set({
      searchSteps: { planner, draw: (frame) => drawArcWalk(frame as Frame, walk, now, planner) },
      layers: { ...layers, tree: true },
      playback: {
        ...playback,
        base: "search",
        searchMode: "percent",
        fraction: Math.min(0.999, now / Math.max(1, walk.steps - 1)),
      },
    });
  }

  move(sign: 1 | -1): void {
    this.go(this.unit === "step" || !this.walk ? this.step + sign : this.walk.nextFailure(this.step, sign));
  }

  private toggle(): void {
    if (this.timer) {
      clearInterval(this.timer);
      this.timer = undefined;
    } else {
      this.timer = setInterval(() => {
        this.move(1);
        if (this.walk && this.step === this.walk.steps - 1) this.toggle();
      }, 1000 / PER_SECOND);
    }
    this.requestUpdate();
  }

  protected override render(): TemplateResult | typeof nothing {
    const { walk, step } = this,
      { lang } = this.state;
    if (!walk) return nothing;
    const press = (
      name: IconName,
      key: "first" | "back" | "run" | "pause" | "next" | "last",
      run: () => void,
    ): TemplateResult =>
      html`<button class="icon" aria-label=${say(lang, key)} title=${say(lang, key)} @click=${run}>${icon(name)}</button>`;
    const at = { step: step + 1, steps: walk.steps };
    return html`<section class="transport"><div class="keys-row">
        ${press("first", "first", () => this.go(0))}${press("back", "back", () => this.move(-1))}
        ${press(this.timer ? "pause" : "play", this.timer ? "pause" : "run", () => this.toggle())}
        ${press("next", "next", () => this.move(1))}${press("last", "last", () => this.go(walk.steps - 1))}
        <select aria-label=${say(lang, "unit")} title=${say(lang, "unit")} @change=${(e: Event) => {
          this.unit = valueOf(e) as "step" | "failure";
        }}>${(["step", "failure"] as const).map((unit) => html`<option value=${unit} ?selected=${unit === this.unit}>${say(lang, unit === "step" ? "unit.step" : "unit.failure")}</option>`)}</select></div>
      <input class="slider" type="range" min="0" max=${walk.steps - 1} .value=${String(step)} .style=${`--at:${(100 * step) / Math.max(1, walk.steps - 1)}%`} aria-label=${say(lang, "position", at)} @input=${(e: Event) => this.go(numberOf(e))}>
      <p class="note">${say(lang, "position", at)}</p></section>
      <section class="event"><p aria-live="polite">${this.sentence(walk)}</p></section>
      <section>${this.connection(walk)}</section>
      <section><p class="note">${say(lang, walk.fromGoal ? "arcs.fromGoal" : "arcs.fromStart")} ${say(lang, "arcs.legend")} ${walk.trace.dropped > 0 ? say(lang, "arcs.dropped", { n: walk.trace.dropped }) : ""}</p></section>`;
  }

  private sentence(walk: ArcWalk): string {
    const { lang } = this.state,
      { pose, arc } = walk.at(this.step);
    const degrees = (((pose.heading * DEGREES) % 360) + 360) % 360;
    const place = `(${this.num(pose.x, 2)} m, ${this.num(pose.y, 2)} m, ${this.num(degrees, 1)}°)`;
    if (!arc) return say(lang, "arcs.root", { place });
    const length = this.num(Math.abs(arc.length), 2),
      bend =
        Math.abs(arc.curvature) < 1e-6
          ? say(lang, "arcs.straight")
          : say(lang, "arcs.radius", { radius: this.num(1 / Math.abs(arc.curvature), 2) });
    return say(lang, "arcs.expand", {
      place,
      length,
      gear: say(lang, arc.length < 0 ? "arcs.reverse" : "arcs.forward"),
      bend,
    });
  }

  private connection(walk: ArcWalk): TemplateResult {
    const { lang } = this.state,
      children = walk.childrenOf(this.step).length;
    const isLast = this.step === walk.steps - 1 && this.plan?.outcome === "found";
    return html`${connectionCard(this.state, walk.failedAt(this.step), isLast)}
      <h3>${say(lang, "arcs.children")}</h3><p>${say(lang, "arcs.childrenCount", { n: children })}</p>`;
  }
}

/** What came of the connection that a step tried. */
export function connectionCard(state: State, failed: FailedConnection | null, isJoined: boolean): TemplateResult {
  const { lang } = state;
  const text = failed
    ? say(lang, "arcs.failed", {
        thing: obstacleName(state, failed.obstacle),
        length: number(lang, failed.length, 2),
      })
    : say(lang, isJoined ? "arcs.joined" : "arcs.untried");
  return html`<h3>${say(lang, "arcs.connection")}</h3><p>${text}</p>`;
}

/** The name of an obstacle by its index; below 0 the border and parked cars. */
export function obstacleName(state: State, index: number): string {
  const { lang, scene } = state;
  if (index < 0) return say(lang, "arcs.other");
  return thingName(state, { obstacle: scene.obstacles?.[index]?.id ?? "", index });
}

customElements.define("parkade-arc-debugger", ArcDebugger);
