import { css, html, nothing, type TemplateResult } from "lit";
import { bandPicture } from "../picture/band";
import { smallMultiples } from "../picture/small-multiples";
import { COMPARED, judged, SWEPT, SWEPT_SCENES, type Compared, type Sample, type Swept } from "../planning/comparison";
import { Helper } from "../planning/job-client";
import { workersHere, type Progress } from "../planning/worker-count";
import { plannerName } from "../styles/planner-style";
import { cellOf, chartsOf, claimOf, COLUMNS, foundOf, say } from "../texts/comparison";
import { claimStyles, verdictChip } from "./papers-claims";
import { PapersTab } from "./papers-tab";

interface Sweep {
  swept: Swept;
  scene: string;
  samples: Sample[];
}
interface Band {
  scene: string;
  band: Float64Array;
}
interface Summary {
  compared: Compared[];
  sweeps: Sweep[];
  bands: Band[];
}

/** Kept while the page is open. */
let last: Summary | null = null;

const PAIRS = [COMPARED.grid, COMPARED.road].flatMap(({ scenes, planners }) =>
  scenes.flatMap((scene) => planners.map((planner) => ({ scene, planner }))),
);
const SWEEPS = (Object.keys(SWEPT) as Swept[]).flatMap((swept) => SWEPT_SCENES.map((scene) => ({ swept, scene })));

/** Section 4.4.2 of the road manuscript, and its sensitivity. */
export class PapersComparison extends PapersTab<Summary> {
  static override styles = [
    PapersTab.styles,
    claimStyles,
    css`
    .charts svg { display: block; } .charts { overflow-x: auto; color: var(--parkade-t1); margin: 6px 0; }
    .compared th:nth-child(2) { text-align: start; }
  `,
  ];
  private helpers: Helper[] = [];

  constructor() {
    super();
    this.summary = last;
  }

  leave(): void {
    const { helpers } = this;
    this.helpers = [];
    for (const helper of helpers) helper.stop();
  }

  protected get running(): boolean {
    return this.helpers.length > 0;
  }

  protected override render(): TemplateResult {
    return this.frame(this.button(), this.summary ? this.content(this.summary) : nothing);
  }

  protected told({ done, of }: Progress): string {
    return say(this.state.lang, "progress", { done, of, workers: workersHere() });
  }

  protected cancelled(done: number): string {
    return say(this.state.lang, "cancelled", { done });
  }

  protected async work(): Promise<void> {
    this.leave();
    const engine = await this.app.complete();
    const helpers = (this.helpers = Array.from({ length: workersHere() }, () => new Helper(engine)));
    const found: Summary = { compared: [], sweeps: [], bands: [] };
    const jobs: ((helper: Helper) => Promise<void>)[] = [
      ...SWEPT_SCENES.map((scene) => async (helper: Helper) => {
        found.bands.push({ scene, band: await helper.call("envelope", { scene }) });
      }),
      ...SWEEPS.map((one) => async (helper: Helper) => {
        found.sweeps.push({ ...one, samples: await helper.call("swept", one) });
      }),
      ...PAIRS.map((one) => async (helper: Helper) => {
        found.compared.push(await helper.call("compared", one));
      }),
    ];
    const of = jobs.length;
    try {
      await Promise.all(
        helpers.map(async (helper) => {
          for (let job = jobs.shift(); job; job = jobs.shift()) {
            await job(helper);
            if (this.helpers !== helpers) return;
            const { compared, sweeps, bands } = found;
            this.progress = { done: compared.length + sweeps.length + bands.length, of };
            this.summary = sorted(found);
          }
        }),
      );
      if (this.helpers === helpers) last = this.summary;
    } catch (error) {
      if (this.helpers === helpers) throw error;
    } finally {
      if (this.helpers === helpers) this.leave();
    }
  }

  protected markdown({ compared }: Summary): string {
    const { lang } = this.state,
      row = (cells: readonly string[]): string => `| ${cells.join(" | ")} |`;
    return [
      row([say(lang, "scene"), say(lang, "planner"), ...COLUMNS.map((column) => say(lang, column))]),
      row(["---", "---", ...COLUMNS.map(() => "---:")]),
      ...compared.map((one) =>
        row([one.scene, plannerName(lang, one.planner), ...COLUMNS.map((column) => cellOf(one, column, this.written))]),
      ),
    ].join("\n");
  }

  private readonly written = (value: number, digits: number): string => this.num(value, digits);

  private content({ compared, sweeps, bands }: Summary): TemplateResult {
    const { lang } = this.state;
    const claims = compared.length === PAIRS.length ? judged(compared) : [];
    return html`<h3>${say(lang, "algorithms")}</h3><ul class="claims">${claims.map(
      (claim) =>
        html`<li id=${claim.id}>${verdictChip(
          lang,
          claim.holds,
        )}<div>${claimOf(lang, claim)}<p>${foundOf(lang, claim)}</p></div></li>`,
    )}</ul>
      <p class="note">${say(lang, "lead")}</p>
      <div class="wide"><table
        class="compared"><thead><tr><th>${say(lang, "scene")}</th><th>${say(lang, "planner")}</th>${COLUMNS.map(
          (column) => html`<th>${say(lang, column)}</th>`,
        )}</tr></thead>
        <tbody>${compared.map(
          (one) =>
            html`<tr><th scope="row">${this.link(
              one.scene,
              one.scene,
            )}</th><th>${plannerName(lang, one.planner)}</th>${COLUMNS.map(
              (column) => html`<td>${cellOf(one, column, this.written)}</td>`,
            )}</tr>`,
        )}</tbody></table></div>
      <h3>${say(lang, "sensitivity")}</h3><p class="note">${say(lang, "charts")}</p>
      <div class="charts" tabindex="0" role="group" aria-label=${say(lang, "sensitivity")}
        .innerHTML=${smallMultiples(chartsOf(lang, sweeps), say(lang, "sensitivity"))}></div>
      <h3>${say(lang, "drives")}</h3><p class="note">${say(lang, "drivesLead", { scale: ACROSS })}</p>
      ${bands.map(
        ({ scene, band }) =>
          html`<div class="charts" tabindex="0" role="group" aria-label=${scene}
            .innerHTML=${bandPicture(this.app.catalog!.scenario(scene), band, scene, ACROSS)}></div>`,
      )}
      <p class="note">${say(lang, "experts")}</p>`;
  }
}

/** How much larger the picture of a band is across than along. */
const ACROSS = 10;

/** In the order of the tables, whatever order the workers answer in. */
function sorted({ compared, sweeps, bands }: Summary): Summary {
  const at = <One extends object>(order: readonly Partial<One>[], one: One): number =>
    order.findIndex((it) => Object.entries(it).every(([key, value]) => one[key as keyof One] === value));
  const placeOf = ({ scene }: Band): number => (SWEPT_SCENES as readonly string[]).indexOf(scene);
  return {
    compared: [...compared].sort((a, b) => at<Compared>(PAIRS, a) - at<Compared>(PAIRS, b)),
    sweeps: [...sweeps].sort((a, b) => at<Sweep>(SWEEPS, a) - at<Sweep>(SWEEPS, b)),
    bands: [...bands].sort((a, b) => placeOf(a) - placeOf(b)),
  };
}

customElements.define("parkade-papers-comparison", PapersComparison);
