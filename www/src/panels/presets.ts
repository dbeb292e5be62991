import "../i18n/later";
import { css, html, nothing, type TemplateResult } from "lit";
import type { Plan, PlannerId, ScenarioInfo } from "parkade";
import { isMessage } from "../i18n/index";
import messages from "../i18n/messages/presets.json";
import { translator } from "../i18n/translator";
import { Helper } from "../planning/job-client";
import { emptyResult, FIRST_PLANNERS, type Scene, type State } from "../store";
import { controls } from "../styles/controls";
import { dialogs } from "../styles/dialogs";
import { plannerName } from "../styles/planner-style";
import { DialogElement } from "./dialog";
import { captionOf, CASES, questionOf } from "./planner-showcases";
import { icon, marker } from "../styles/icons";
import { statusOf } from "../texts/status";
import "./generate";
import "./thumbnail";

/** Groups whose words the page does not have. */
const say = translator("presets", messages);
const GENERATE = "generate",
  CASE = "cases";
/** Whose path a card shows. */
const DRAWN: Record<string, PlannerId> = { grid: "risk-field", road: "cost-map" };
/** Answers are kept while the page is open; null where there is none. */
const solved = new Map<string, Plan | null>();

/** The gallery of scenes, each asking a question. */
export class Presets extends DialogElement {
  static override properties = { ...DialogElement.properties, group: { state: true } };
  static override styles = [
    controls,
    dialogs,
    css`
    dialog { --dialog-width: 984px; }
    ul {
      list-style: none; margin: 0; padding: 0; display: grid;
      grid-template-columns: repeat(auto-fill, minmax(250px, 1fr)); gap: 16px;
    }
    li { display: grid; }
    li button {
      flex-direction: column; align-items: stretch; justify-content: flex-start; gap: 0; text-align: left;
      white-space: normal; border-radius: calc(10px * var(--parkade-radius)); border: 1px solid var(--parkade-hair2);
      overflow: hidden; background: var(--parkade-panel);
    }
    li button:hover { border-color: var(--parkade-t3); }
    li button[aria-current="true"] { border-color: var(--parkade-accent); box-shadow: 0 0 0 1px var(--parkade-accent); }
    li button:focus-visible { border-radius: calc(10px * var(--parkade-radius)); }
    ul:not(:empty) + parkade-generate { margin-top: 16px; }
    parkade-thumbnail { height: 128px; border-bottom: 1px solid var(--parkade-hair); pointer-events: none; }
    .new {
      display: grid; place-items: center; height: 128px; border-bottom: 1px solid var(--parkade-hair);
      color: var(--parkade-t2);
      background: linear-gradient(var(--parkade-hair) 1px, transparent 0) center / 16px 16px,
        linear-gradient(90deg, var(--parkade-hair) 1px, transparent 0) center / 16px 16px;
    }
    .caption { padding: 10px 12px 11px; display: block; }
    b { display: flex; align-items: center; gap: 8px; font-weight: 600; } .by { margin-left: auto; }
    h3 { margin: 18px 0 8px; font: inherit; font-weight: 600; display: flex; align-items: center; gap: 8px; }
    h3:first-child { margin-top: 0; }
    i { display: block; font-style: normal; font-size: 12.5px; line-height: 17px; color: var(--parkade-t2); }
    small {
      display: block; margin-top: 2px; min-height: 16px; font-size: 12px; line-height: 16px; color: var(--parkade-t3);
    }
    footer {
      display: flex; align-items: center; gap: 10px; padding: 12px 16px 12px 24px;
      border-top: 1px solid var(--parkade-hair);
    }
    footer p { margin: 0; color: var(--parkade-t2); } footer b { white-space: nowrap; }
    footer .button { margin-left: auto; flex: none; }
    .tables { margin-left: auto; flex: none; } .top .tables + .icon { margin-left: 0; } .top p { min-width: 0; }
    .groups { padding: 0 24px 14px; }
    .groups .segmented { max-width: 100%; overflow-x: auto; }
    .groups button { flex: none; }
    @media (max-width: 640px) {
      ul { grid-template-columns: 1fr 1fr; gap: 10px; }
      parkade-thumbnail, .new { height: 92px; }
      footer b + p { display: none; }
      .groups { padding: 0 16px 12px; }
      .top p { display: none; }
    }
  `,
  ];
  declare group: string;
  private readonly scenes = new Map<string, Scene>();
  private helper: Helper | null = null;
  private asked: [id: string, planner: PlannerId][] = [];

  constructor() {
    super();
    this.group = "all";
  }

  protected override watches(): readonly (keyof State)[] {
    return ["theme"];
  }

  protected override content(): TemplateResult {
    const all = this.app.catalog?.scenarios ?? [];
    const groups = ["all", ...new Set(all.map((one) => one.group)), CASE, GENERATE];
    this.asked = [];
    const shown = all.filter((one) => this.group === "all" || one.group === this.group);
    return html`
      ${this.top(
        this.t("scenes.title"),
        this.t("scenes.lead"),
        html`<button class="button outline tables"
          @click=${this.showTables}>${icon("cells", 14)}${this.t("bar.papers")}</button>`,
      )}
      <div class="groups"><div class="segmented" role="group" aria-label=${this.t("scenes.title")}>${groups.map(
        (group) => html`
          <button aria-pressed=${group === this.group} @click=${() => {
            this.group = group;
          }}>${this.groupName(group)}</button>`,
      )}</div></div>
      <div class="scroll">${
        this.group === CASE
          ? this.cases(all)
          : html`<ul>${this.group === "all" ? this.newCard() : nothing}${shown.map((info) =>
              this.card(info, DRAWN[info.group] ?? "hybrid"),
            )}</ul>`
      }
        ${
          ["all", "grid", GENERATE].includes(this.group)
            ? html`<parkade-generate .app=${this.app} @opened=${this.close}></parkade-generate>`
            : nothing
        }</div>
      <footer>${icon("open")}<b>${this.t("scenes.own")}</b><p>${this.t("scenes.ownHelp")}</p>
        <button class="button outline" @click=${this.choose}>${this.t("scenes.choose")}</button></footer>`;
  }

  private newCard(): TemplateResult {
    const { lang } = this.state;
    return html`<li><button @click=${this.newLot}><span class="new"><svg viewBox="0 0 16 16" width="28" fill="none"
      stroke="currentColor"><path d="M8 2.5v11M2.5 8h11"/></svg></span>
      <span class="caption"><b>${say(lang, "newLot")}</b><i>${say(lang, "numbers")}</i></span></button></li>`;
  }

  private card(
    info: ScenarioInfo,
    planner: PlannerId,
    title = info.title[this.state.lang],
    question = captionOf(info, this.state.lang),
    run = () => this.pick(info.id),
  ): TemplateResult {
    const key = `${info.id} ${planner}`,
      suits = say(this.state.lang, "suits", { planner: plannerName(this.state.lang, planner) });
    if (!solved.has(key)) this.asked.push([info.id, planner]);
    return html`<li><button aria-current=${info.id === this.app.preset} @click=${run}>
      <parkade-thumbnail .app=${this.app} .scene=${this.sceneOf(info.id)} .plan=${solved.get(key)}
        ?whole=${info.group === "grid" || info.group === "road"}></parkade-thumbnail>
      <span class="caption"><b>${title}<span class="by"
        title=${suits}>${marker(planner)}<span
        class="visually-hidden">${suits}</span></span></b><i>${question}</i><small>${this.factOf(
          info.id,
          planner,
        )}</small></span></button></li>`;
  }

  /** Summary of the plan on the card; empty until it exists. */
  private factOf(id: string, planner: PlannerId): string {
    const { state } = this,
      plan = solved.get(`${id} ${planner}`);
    if (!plan) return "";
    const { brief, tone } = statusOf(
      { ...state, scene: this.sceneOf(id), results: { [planner]: { ...emptyResult, status: "done", plan } } },
      planner,
    );
    if (plan.outcome !== "found") return brief;
    const path = say(state.lang, "path", {
      length: this.num(plan.metrics.length, 1),
      n: plan.metrics.directionChanges,
    });
    return tone === "ok" ? path : `${path} · ${brief}`;
  }

  /** Two scenes for each planner. */
  private cases(all: readonly ScenarioInfo[]): TemplateResult {
    const { lang } = this.state;
    return html`${CASES.map(
      ([planner, cases]) => html`<h3>${marker(planner)}${plannerName(lang, planner)}</h3>
      <ul>${(["best", "worst"] as const).map((which) => {
        const { scene } = cases[which],
          info = all.find((one) => one.id === scene);
        return info
          ? this.card(
              info,
              planner,
              `${say(lang, which)}: ${info.title[lang]}`,
              questionOf(lang, cases[which]),
              () => void this.pickCase(scene, planner),
            )
          : nothing;
      })}</ul>`,
    )}`;
  }

  /** The planner beside those of the first picture. */
  private async pickCase(scene: string, planner: PlannerId): Promise<void> {
    await this.app.complete();
    this.app.store.set({ planners: [...new Set([planner, ...FIRST_PLANNERS])].slice(0, 4), focus: planner });
    this.pick(scene);
  }

  protected override updated(): void {
    if (this.shown) void this.solveNext().catch(() => undefined);
  }

  /** One after the other, in a worker; what fails has no path to show. */
  private async solveNext(): Promise<void> {
    const [next] = this.asked;
    if (!next || this.helper) return;
    const helper = (this.helper = new Helper(await this.app.complete()));
    try {
      for (
        let ask: typeof next | undefined = next;
        ask && this.helper === helper;
        ask = this.asked.find(([id, planner]) => !solved.has(`${id} ${planner}`))
      ) {
        const [id, planner] = ask;
        solved.set(
          `${id} ${planner}`,
          await helper.call("solve", { planner, scene: this.sceneOf(id) }).catch(() => null),
        );
        if (this.helper !== helper) solved.delete(`${id} ${planner}`);
        this.requestUpdate();
        await this.updateComplete;
      }
    } finally {
      if (this.helper === helper) this.helper = null;
      helper.stop();
    }
  }

  protected override closed(): void {
    this.helper?.stop();
    this.helper = null;
  }

  private sceneOf(id: string): Scene {
    let scene = this.scenes.get(id);
    if (!scene) {
      scene = this.app.catalog!.scenario(id);
      this.scenes.set(id, scene);
    }
    return scene;
  }

  private groupName(group: string): string {
    if (group === GENERATE || group === CASE || group === "moving" || group === "road" || group === "figures")
      return say(this.state.lang, group);
    const key = `scenes.${group}`;
    return isMessage(key) ? this.t(key) : group;
  }

  private pick(id: string): void {
    this.close();
    this.app.openPreset(id);
  }

  private readonly choose = (): void => {
    this.close();
    this.app.ask("open");
  };

  private readonly showTables = (): void => {
    this.close();
    this.app.ask("papers");
  };

  private readonly newLot = (): void => {
    this.close();
    void this.app.fetchPart(async () => (await import("./new-lot")).openNewLot(this.app, this));
  };
}

customElements.define("parkade-presets", Presets);
