/** What stands where around the maps, and which maps there are. */
import { html, nothing, type TemplateResult } from "lit";
import type { App } from "../app/app";
import type { Pane } from "../panels/splitter";
import type { SceneView } from "../panels/scene-view";
import type { Store } from "../store";

const PHONE_WIDTH = 640;
/** Too low for an embedded map with a sheet or a table. */
const SHORT_HEIGHT = 560;
/** A page lower and wider than this has its controls in rails beside the map: a phone on its side. */
const RAILS = { height: 480, width: 480 };

/** What the arrangement asks of the page. */
interface Page {
  readonly store: Store;
  readonly isFull: boolean;
  readonly loaded: boolean;
  readonly folded: boolean;
  readonly rails: boolean;
  readonly short: boolean;
}

/** Which arrangement a size has room for. */
export function roomOf(
  { width, height }: { width: number; height: number },
  alone: boolean,
): { rails: boolean; compact: boolean; short: boolean } {
  const rails = alone && height < RAILS.height && width > RAILS.width;
  return { rails, compact: rails || width <= PHONE_WIDTH, short: !alone && height < SHORT_HEIGHT };
}

/** A page with room for columns. */
export function wide({ isFull, loaded, folded, store }: Page, app: App): TemplateResult {
  const splitter = (pane: Pane): TemplateResult =>
    html`<parkade-splitter part="handle" pane=${pane} lang=${store.state.lang}></parkade-splitter>`;
  const around = (): TemplateResult => html`
      <parkade-inspector .app=${app} .ready=${loaded}></parkade-inspector>
      <div class="bottom-pane"><parkade-table part="table" .app=${app}></parkade-table><parkade-charts part="chart"
        .app=${app}></parkade-charts>${splitter("chart")}</div>
      ${splitter("side")}${splitter("bottom")}`;
  return html`
      ${isFull ? html`<parkade-options .app=${app}></parkade-options>` : nothing}
      <parkade-timeline part="timeline" .app=${app} .folded=${folded}></parkade-timeline>
      ${isFull ? around() : nothing}`;
}

/** A phone, upright or on its side, and small embedded pages. */
export function narrow({ isFull, loaded, rails, short }: Page, app: App): TemplateResult {
  return html`${isFull ? html`<parkade-chips .app=${app} ?rail=${rails}></parkade-chips>` : nothing}
      <parkade-choices .app=${app}></parkade-choices><parkade-failure .app=${app} ?short=${isFull}></parkade-failure>
      ${rails ? html`<parkade-options .app=${app}></parkade-options>` : nothing}
      <parkade-timeline part="timeline" .app=${app} compact ?slim=${rails}></parkade-timeline>
      ${
        isFull && !short ? html`<parkade-sheet .app=${app} .ready=${loaded} ?drawer=${rails}></parkade-sheet>` : nothing
      }`;
}

export function sceneViews(root: ParentNode): SceneView[] {
  const stage = root.querySelector("parkade-stage")?.shadowRoot;
  if (!stage) return [];
  const panels = [...stage.querySelectorAll("parkade-panel")].flatMap((panel) => [
    ...(panel.shadowRoot?.querySelectorAll<SceneView>("parkade-scene-view") ?? []),
  ]);
  return [...stage.querySelectorAll<SceneView>("parkade-scene-view"), ...panels];
}
