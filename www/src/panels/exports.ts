/** Files that the export menu saves. */
import "../i18n/later";
import { focusedPlan } from "../store/results";
import { fileName } from "../scene/files";
import { download, refusal, type App } from "../app/app";

export type ExportKind = "svg" | "csv" | "trajectory";

const MAKERS: Record<ExportKind, (app: App) => Promise<Blob | null>> = {
  svg: pictureFile,
  csv: pathFile,
  trajectory: trajectoryFile,
};

/** Saves a file; says why where there is nothing to save. */
export async function saveAs(app: App, kind: ExportKind): Promise<void> {
  try {
    const blob = await MAKERS[kind](app);
    const { scene, focus } = app.store.state,
      tail = { svg: ".svg", csv: `-${focus}.csv`, trajectory: `-${focus}-trajectory.csv` }[kind];
    if (blob) download(blob, fileName(scene) + tail);
    else app.notify("warn", "error.noPath");
  } catch (error) {
    app.refuse("error.export", { reason: refusal(error) });
  }
}

/** A drawing with the scene inside: it opens here again. */
async function pictureFile(app: App): Promise<Blob> {
  const { plannedIn, plansOf, toSVG } = await formats(app),
    { state } = app.store,
    { scene, planners, hidden, theme } = state;
  const shown = planners.filter((planner) => !hidden.has(planner)),
    options = { width: 1200, height: 700, theme, planned: plannedIn(state, shown) };
  return new Blob([toSVG(scene, plansOf(state, shown), options)], { type: "image/svg+xml" });
}

async function pathFile(app: App): Promise<Blob | null> {
  const { csvOf } = await formats(app),
    { state } = app.store;
  return focusedPlan(state) && new Blob([csvOf(state)], { type: "text/csv" });
}

async function trajectoryFile(app: App): Promise<Blob | null> {
  const text = (await formats(app)).trajectoryCsvOf(app.store.state);
  return text === null ? null : new Blob([text], { type: "text/csv" });
}

async function formats(app: App): Promise<typeof import("./svg-csv")> {
  await app.complete();
  return import("./svg-csv");
}
