/** Files that the export menu saves. */
import "../i18n/later";
import { focusedPlan } from "./timeline";
import { fileName } from "../scene/files";
import { download, sentence, type App } from "../app/app";

export type ExportKind = "svg" | "csv";

const MAKERS: Record<ExportKind, (app: App) => Promise<Blob | null>> = { svg: pictureFile, csv: pathFile };

/** Saves a file; says why where there is nothing to save. */
export async function saveAs(app: App, kind: ExportKind): Promise<void> {
  try {
    const blob = await MAKERS[kind](app);
    if (blob)
      download(blob, `${fileName(app.store.state.scene)}${kind === "csv" ? `-${app.store.state.focus}` : ""}.${kind}`);
    else app.say("warn", "error.noPath");
  } catch (error) {
    app.refuse("error.export", { reason: sentence(error) });
  }
}

/** A drawing with the scene inside: it opens here again. */
async function pictureFile(app: App): Promise<Blob> {
  const { toSVG } = await formats(app),
    { scene, planners, hidden, results, theme } = app.store.state;
  const plans = planners.flatMap((planner) => (hidden.has(planner) ? [] : (results[planner]?.plan ?? [])));
  return new Blob([toSVG(scene, plans, { width: 1200, height: 700, theme })], { type: "image/svg+xml" });
}

async function pathFile(app: App): Promise<Blob | null> {
  const plan = focusedPlan(app.store.state);
  return plan && new Blob([(await formats(app)).toCSV(app.store.state.scene, plan)], { type: "text/csv" });
}

async function formats(app: App): Promise<typeof import("./svg-csv")> {
  await app.complete();
  return import("./svg-csv");
}
