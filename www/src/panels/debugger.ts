import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import type { Explanation, PlannerId, PoseTrace, SearchTrace } from "parkade";
import { refusal, type App } from "../app/app";
import { Helper } from "../planning/job-client";
import { FailedExpansionIndex } from "../planning/failed-expansions";
import { STEP } from "../planning/search-replay";
import { forPlanners } from "../scene/large-scene";
import { resolve } from "../scene/model";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { icon, marker } from "../styles/icons";
import { hasField, plannerName } from "../styles/planner-style";
import { eventLine } from "../texts/search-steps";
import { say } from "../texts/search-messages";
import { drawExplained } from "../view/layers/explained";
import { drawBreakpoints } from "../view/layers/breakpoints";
import { drawPoseStep } from "../view/layers/pose-steps";
import { MAX_SCALE } from "../view/camera";
import { SearchStepsLayer } from "../view/layers/search-steps";
import type { Frame } from "../view/frame";
import { AppElement } from "./base";
import { breakpoints, transport } from "./debugger-controls";
import { connectionCard, obstacleName } from "./debugger-connection";
import { code, estimatesCard, fieldCard, movesTable, openTable, variables } from "./debugger-parts";
import { POSE_RADIUS, Session } from "./debugger-session";
import { bytesOf, recordingNote, saveButtons } from "./debugger-recording";
import { debuggerStyles, room } from "./debugger-styles";
import { nth } from "../scene/nth";
import { rootOf } from "./beside";
import { reasonIn } from "../i18n/index";

/** A recording of more than this is asked for, bytes. */
const ASK_BYTES = 8e6;
const LIMIT = 100_000;
/** How long the walk rests before the risk field is asked, milliseconds. */
const REST_MS = 80;
const ZOOMED_PX = 84;
/** A node nearer to the map's edge than this counts as out of sight, CSS pixels. */
const EDGE_PX = 24;
/** Pixels a metre where a car's moves are looked at. */
const CAR_SCALE = 40;

/** The search debugger: walks through a planner's search beside its map. */
export class Debugger extends AppElement {
  static override properties = {
    ...AppElement.properties,
    session: { state: true },
    trouble: { state: true },
    picking: { state: true },
    field: { state: true },
    asked: { state: true },
  };
  static override styles = [controls, debuggerStyles];
  declare session: Session | null;
  declare trouble: string;
  declare picking: boolean;
  declare field: Explanation | null;
  /** Steps of a long search that is recorded once somebody says so. */
  declare asked: number | null;
  /** Events that are done when the first recording is there. */
  opensAt = 0;
  private helper: Helper | null = null;
  private layer: Pick<SearchStepsLayer, "draw"> | null = null;
  private failures: FailedExpansionIndex | null = null;
  private scene: State["scene"] | null = null;
  private planner: PlannerId | null = null;
  private looks: Partial<State> | null = null;
  /** The root whose layout makes room. */
  private around: ShadowRoot | null = null;
  private rest: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    this.session = this.field = this.asked = null;
    this.trouble = "";
    this.picking = false;
  }

  protected watches(): readonly (keyof State)[] {
    return ["scene", "focus", "results", "transient"];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    const { layers, playback, mode, camera, planners } = this.state;
    this.looks = { layers, playback, mode, camera };
    const off = {
      path: false,
      sweep: false,
      ghosts: false,
      difference: false,
      heat: false,
      tree: false,
      risk: false,
      safety: false,
    };
    this.app.player.pause();
    this.app.store.set({
      layers: { ...layers, ...off, obstacles: true },
      playback: { ...playback, base: "search", fraction: 1, playing: false },
      // The other planners' column would be empty.
      mode: planners.length > 1 ? "focus" : mode,
      camera: null,
    });
    this.around = rootOf(this);
    this.around.adoptedStyleSheets.push(room.styleSheet!);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.leave();
    this.helper?.stop();
    this.helper = null;
    if (this.looks) this.app.store.set({ ...this.looks, searchSteps: null });
    if (this.around)
      this.around.adoptedStyleSheets = this.around.adoptedStyleSheets.filter((one) => one !== room.styleSheet);
  }

  protected override willUpdate(changed: PropertyValues): void {
    super.willUpdate(changed);
    const { scene, focus, transient } = this.state;
    if (transient || (scene === this.scene && focus === this.planner)) return;
    [this.scene, this.planner] = [scene, focus];
    this.leave();
    void this.begin();
  }

  private leave(): void {
    this.session?.pause();
    clearTimeout(this.rest);
    this.session = this.layer = this.field = this.asked = null;
    this.failures = null;
    this.app.store.set({ searchSteps: null });
  }

  /** Events done; null where nothing is walked through. */
  get position(): number | null {
    return this.session?.replay.at ?? null;
  }

  /** One unit on, or back, as presenters' keys ask. */
  move(sign: 1 | -1): void {
    this.session?.move(sign);
  }

  /** Records the search at once where it is short. */
  private async begin(): Promise<void> {
    this.trouble = "";
    await this.app.planning?.whenSettled();
    const { focus } = this.state;
    const expanded = this.state.results[focus]?.plan?.stats.expanded ?? 0;
    const steps = Math.min(LIMIT, expanded);
    if (bytesOf(steps) > ASK_BYTES) this.asked = steps;
    else await this.record();
  }

  private readonly record = async (): Promise<void> => {
    this.asked = null;
    const { scene, planner } = this;
    try {
      const engine = await this.app.complete();
      this.helper ??= new Helper(engine);
      const packed = forPlanners(scene!, engine.api.packRuns);
      const trace = await this.helper.call("record", { planner: planner!, scene: packed, limit: LIMIT });
      if (scene !== this.scene || planner !== this.planner) return;
      if (trace) this.take(planner!, trace);
      else this.trouble = say(this.state.lang, "none", { planner: plannerName(this.state.lang, planner!) });
    } catch (error) {
      this.trouble = reasonIn(this.state.lang, refusal(error));
    }
  };

  private take(planner: PlannerId, trace: SearchTrace | PoseTrace): void {
    this.session = new Session(planner, trace, this.moved);
    const { replay } = this.session;
    replay.nameOf = (obstacle) => obstacleName(this.state, obstacle);
    if (trace.kind === "search") this.layer = new SearchStepsLayer(replay, trace);
    else {
      const failures = new FailedExpansionIndex(trace.tree.failedExpansions);
      this.failures = failures;
      this.session.fails = failures.has;
      this.layer = { draw: (frame) => drawPoseStep(frame, replay, failures.at(replay.step), planner) };
    }
    this.session.replay.seek(this.opensAt);
    this.opensAt = 0;
    this.moved();
  }

  /** The walk has come to another event. */
  private readonly moved = (): void => {
    const { session, layer } = this;
    if (!session || !layer) return;
    this.follow(session);
    this.field = null;
    clearTimeout(this.rest);
    if (!session.isRunning && hasField(session.planner)) this.rest = setTimeout(() => void this.askField(), REST_MS);
    this.show();
  };

  private show(): void {
    const { session, layer, field } = this;
    if (!session || !layer) return;
    const draw = (frame: unknown): void => {
      layer.draw(frame as Frame);
      drawBreakpoints(frame as Frame, session.breaks, POSE_RADIUS);
      if (field) drawExplained(frame as Frame, field);
    };
    this.app.store.set({ searchSteps: { planner: session.planner, draw } });
    this.requestUpdate();
  }

  private async askField(): Promise<void> {
    const { session, scene, helper } = this;
    if (!session || !scene || !helper || session.replay.step < 0) return;
    const { at, step, trace } = session.replay;
    if (session.replay.kindOf(step) === STEP.goal) return;
    const engine = await this.app.complete();
    const place = this.centreOf(nth(trace.nodes, step));
    const field = await helper
      .call("field", { planner: session.planner, scene: forPlanners(scene, engine.api.packRuns), at: place })
      .catch(() => null);
    if (session !== this.session || session.replay.at !== at) return;
    this.field = field;
    this.show();
  }

  private goalCell(): { x: number; y: number } {
    const { scene } = this.state,
      { origin, resolution } = scene.map,
      { goal } = resolve(scene);
    return { x: Math.floor((goal.x - origin[0]) / resolution), y: Math.floor((goal.y - origin[1]) / resolution) };
  }

  private centreOf(node: number): { x: number; y: number } {
    const { origin, resolution, width } = this.state.scene.map;
    return {
      x: origin[0] + ((node % width) + 0.5) * resolution,
      y: origin[1] + (Math.floor(node / width) + 0.5) * resolution,
    };
  }

  protected override render(): TemplateResult {
    const { lang, focus } = this.state,
      { session } = this;
    return html`<section class="head"><h2>${marker(focus)}${say(lang, "title")}</h2><span
      class="planner-name">${plannerName(lang, focus)}</span>
        <button class="icon" aria-label=${say(lang, "close")} title=${say(lang, "close")}
          @click=${() => this.remove()}>${icon("close")}</button></section>
      ${
        session
          ? this.walk(session)
          : html`<section><p role="status">${this.waiting()}</p>${
              this.asked === null
                ? nothing
                : html`<button class="button outline" @click=${this.record}>${say(lang, "record")}</button>`
            }</section>`
      }`;
  }

  private waiting(): string {
    const { lang } = this.state;
    if (this.asked !== null) return say(lang, "ask", { n: this.asked, mb: this.num(bytesOf(this.asked) / 1e6, 1) });
    return this.trouble || say(lang, "loading");
  }

  private walk(session: Session): TemplateResult {
    const { lang } = this.state,
      { replay } = session;
    return html`<section class="transport">${transport(lang, session, () => this.requestUpdate())}</section>
      <section class="event"><p aria-live="polite">${
        session.stopped ? html`<b>${say(lang, "breaks.hit")}</b> ` : nothing
      }${eventLine(lang, replay, session.unit === "move")}</p></section>
      ${
        replay.trace.kind === "poses"
          ? html`<section>${connectionCard(
              this.state,
              replay,
              this.failures?.at(replay.step) ?? null,
            )}<p class="note">${say(
              lang,
              replay.sides.length > 1 ? "arcs.fromBoth" : replay.trace.fromGoal ? "arcs.fromGoal" : "arcs.fromStart",
            )} ${say(lang, "arcs.steps")}</p></section>`
          : nothing
      }
      ${this.field ? html`<section class="field-card">${fieldCard(lang, this.field)}</section>` : nothing}
      <section>${movesTable(lang, replay)}</section>
      <section>${code(lang, replay, session.unit === "move")}${variables(lang, replay)}</section>
      <section>${replay.sides.map((_, side) => openTable(lang, replay, side))}</section>
      ${estimatesCard(lang, replay, this.goalCell())}
      <section>${breakpoints(lang, session, {
        isPicking: this.picking,
        pick: this.pick,
        shown: () => this.show(),
      })}</section>
      <section class="foot"><div class="rows"><button class="button outline"
        @click=${this.zoom}>${say(
          lang,
          replay.trace.kind === "poses" ? "zoomPose" : "zoom",
        )}</button>${saveButtons(lang, session)}</div>
        <p class="note">${recordingNote(this.state, session)}</p></section>`;
  }

  /** The next click on the map chooses a cell or, of a search for a car, a point. */
  private readonly pick = (): void => {
    this.picking = true;
    const stage = rootOf(this).querySelector("parkade-stage");
    const take = (event: Event): void => {
      event.preventDefault();
      event.stopPropagation();
      this.picking = false;
      const { hover, scene } = this.state,
        { session } = this;
      if (!hover || !session) return;
      const { breaks } = session;
      if (session.replay.trace.kind === "poses") {
        session.breaks = { ...breaks, points: [...breaks.points, { x: hover.x, y: hover.y }] };
        this.show();
        return;
      }
      const { origin, resolution, width, height } = scene.map;
      const x = Math.floor((hover.x - origin[0]) / resolution),
        y = Math.floor((hover.y - origin[1]) / resolution);
      if (x < 0 || y < 0 || x >= width || y >= height) return;
      session.breaks = { ...breaks, cells: new Set([...breaks.cells, y * width + x]) };
      this.show();
    };
    stage?.addEventListener("pointerdown", take, { capture: true, once: true });
  };

  /** Shows the node at hand with its costs. */
  private readonly zoom = (): void => {
    const { session } = this;
    if (!session) return;
    const scale = session.replay.trace.kind === "poses" ? CAR_SCALE : ZOOMED_PX / this.state.scene.map.resolution;
    this.app.store.set({ camera: { ...this.placeAtHand(session), scale: Math.min(MAX_SCALE, scale) } });
  };

  /** The middle of the node at hand, or of the first. */
  private placeAtHand({ replay }: Session): { x: number; y: number } {
    const step = Math.max(0, replay.step),
      node = nth(replay.trace.nodes, step),
      { x, y } = replay.poseOf(replay.sideOf(step), node) ?? this.centreOf(node);
    return { x, y };
  }

  /** Moves a zoomed map on where the node at hand is out of sight. */
  private follow(session: Session): void {
    const { camera } = this.state,
      stage = this.around?.querySelector("parkade-stage");
    if (!camera || !stage) return;
    const { x, y } = this.placeAtHand(session),
      { clientWidth: width, clientHeight: height } = stage;
    const isSeen =
      Math.abs(x - camera.x) * camera.scale < width / 2 - EDGE_PX &&
      Math.abs(y - camera.y) * camera.scale < height / 2 - EDGE_PX;
    if (!isSeen) this.app.store.set({ camera: { ...camera, x, y } });
  }
}

customElements.define("parkade-debugger", Debugger);

/** Opens the debugger in its playground after so many events, or closes it. */
export function toggleDebugger(app: App, beside: HTMLElement, at = 0): void {
  const root = rootOf(beside);
  const open = root.querySelector<Debugger>("parkade-debugger");
  if (open) open.remove();
  else root.querySelector(".layout-wide, .layout-narrow")?.append(Object.assign(new Debugger(), { app, opensAt: at }));
}
