import type { PlannerId } from "parkade";
import { css, html, nothing, type TemplateResult } from "lit";
import messages from "../i18n/messages/failure-line.json";
import { translator } from "../i18n/translator";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { below, frameBox, isLong, leastScale, LINE, STRIP } from "../view/camera";
import { failureOf } from "../view/failure";
import { flyTo } from "../view/fly";
import { AppElement } from "./base";
import { whyOf } from "../texts/failure";
import { icon } from "../styles/icons";
import type { SceneView } from "./scene-view";

const say = translator("failureLine", messages);

/** One line under a planner's title: why its answer fails; a click shows the place. */
export class FailureLine extends AppElement {
  static override properties = { ...AppElement.properties, planner: { type: String }, short: { type: Boolean } };
  static override styles = [
    controls,
    css`
    :host { display: block; z-index: 3; font-size: 12px; line-height: 15px; }
    div {
      display: flex; align-items: start; gap: 8px; min-height: 28px; padding: 6px 4px 2px 12px;
      color: var(--parkade-t2);
    }
    .err { background: var(--parkade-err-soft); color: var(--parkade-err); font-weight: 500; }
    p {
      margin: 0; flex: 1; min-width: 0; overflow: hidden; display: -webkit-box; -webkit-box-orient: vertical;
      -webkit-line-clamp: 2;
    }
    svg { margin-top: 2px; }
    button { height: 22px; margin: -3px 0; padding: 0 8px; font-weight: 600; color: inherit; flex: none; }
    button:hover { text-decoration: underline; }
    :host([short]) div { height: 40px; padding-top: 4px; }
    /* The rest is in its tooltip. */
    :host([slim]) div { align-items: center; min-height: 22px; padding: 0 0 0 8px; gap: 6px; }
    :host([slim]) p { -webkit-line-clamp: 1; }
    @media (pointer: coarse) { button { height: 34px; margin: -9px 0; padding: 0 12px; } }
  `,
  ];
  /** Unset: the focused one. */
  declare planner: PlannerId | undefined;
  /** On a phone: two lines at most, so the cause gives way to what would help. */
  declare short: boolean;

  constructor() {
    super();
    this.short = false;
  }

  protected override redrawMs = 100;
  protected watches(): readonly (keyof State)[] {
    return ["results", "focus", "hidden", "planners"];
  }

  private get asked(): PlannerId {
    return this.planner ?? this.state.focus;
  }

  protected override render(): TemplateResult | typeof nothing {
    const { state, asked } = this,
      why = state.hidden.has(asked) ? null : whyOf(state, asked, this.short);
    if (why === null) return nothing;
    const plan = state.results[asked]?.plan,
      failure = plan && failureOf(state.scene, plan);
    return html`<div class="err">${icon("warning", 12)}<p title=${whyOf(state, asked)}>${why}</p>
      ${
        failure
          ? html`<button title=${say(state.lang, "where")} aria-label=${say(state.lang, "where")}
            @click=${this.show}>${say(state.lang, "show")}</button>`
          : nothing
      }</div>`;
  }

  private readonly show = (): void => {
    const { scene, results } = this.state,
      plan = results[this.asked]?.plan,
      view = this.map?.view;
    const failure = plan && failureOf(scene, plan);
    if (!failure || !view) return;
    const inset = isLong(scene) ? STRIP.room : LINE;
    flyTo(
      this.app.store,
      view.camera,
      below(inset, frameBox(failure.box, view.width, view.height - inset, leastScale(scene.map))),
    );
  };

  /** The map beside it, or the one of the stage. */
  private get map(): SceneView | null {
    for (let root = this.getRootNode(); root instanceof ShadowRoot; root = root.host.getRootNode()) {
      const inside = root.querySelector("parkade-stage")?.shadowRoot ?? root,
        map = inside.querySelector<SceneView>("parkade-scene-view");
      if (map) return map;
    }
    return null;
  }
}

customElements.define("parkade-failure", FailureLine);
