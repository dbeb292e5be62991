/** What an answer brings along for the layers that are shown, what of an older one stays beside it, and its reason. */
import type { LayerName, Plan, PlannerId, PlannerSettings } from "parkade";
import type { PanelResult, Scene, State } from "../store";
import { translate, type Lang } from "../i18n/index";
import { drivesCar, hasField, infoOf, plannerName } from "../styles/planner-style";
import type { Failure, Layers } from "./protocol";

/** Of the risk field, that a step of a drag brings. */
const MOST_FORCES = 1 << 18;

/** The arrows and hatching of the risk planner follow a drag; the hover's clearance can wait for its end. */
export function layersOf(planner: PlannerId, state: State): LayerName[] {
  const names: LayerName[] = hasField(planner) ? ["safety"] : [];
  if (state.layers.risk && hasField(planner)) names.push("risk");
  if (state.layers.tree && state.complete && hasField(planner)) names.push("potential");
  if (state.layers.redundant && state.complete && closes(state.scene.planners?.[planner])) names.push("redundant");
  if (state.layers.cost && hasCosts(planner)) names.push("cost");
  if (!state.transient) names.push("clearance");
  return names;
}

/** A drag over a huge map moves as many arrows as are drawn of all of it. */
export const forceEvery = ({
  transient,
  scene: {
    map: { width, height },
  },
}: State): number => (transient ? Math.max(1, Math.ceil(Math.sqrt((width * height) / MOST_FORCES))) : 1);

/** A drag's plans bring no more than is drawn of them. */
export const isTraced = (planner: PlannerId, { transient, layers, playback }: State): boolean =>
  !transient || playback.base === "search" || (drivesCar(planner) ? layers.tree : layers.heat);

const hasCosts = (planner: PlannerId): boolean => infoOf(planner)?.family === "road";

/** True if a grid planner's settings close free cells. */
const closes = (settings: PlannerSettings[PlannerId] = {}): boolean =>
  ("inflation" in settings && settings.inflation !== "none") ||
  ("minPassage" in settings && Number(settings.minPassage) > 1) ||
  ("trapMouth" in settings && Number(settings.trapMouth) > 1);

export const withOld = (layers: Layers, old: Layers, transient: boolean): Layers =>
  transient && old.clearance && !layers.clearance ? { ...layers, clearance: old.clearance } : layers;

/** The part of a result that stays true on a map with other cells: the paths, not the cells. */
export function offLattice({ plan, lastGood, ...rest }: PanelResult): PanelResult {
  const clear = (one: Plan | null): Plan | null => (one?.trace?.kind === "cells" ? { ...one, trace: null } : one);
  return { ...rest, plan: clear(plan), lastGood: clear(lastGood), layers: {} };
}

export const sameMap = (a: Scene, b: Scene): boolean =>
  a.map === b.map || JSON.stringify(a.map) === JSON.stringify(b.map);

/** What is wrong, without the field that is named beside it. */
export const withoutPath = (failure: Failure): Failure => ({
  ...failure,
  path: "",
  message: failure.path ? failure.message.replace(`${failure.path}: `, "") : failure.message,
});

/** Why a planner gives no answer: its time is up, or one of its settings is refused. */
export function failureText(lang: Lang, planner: PlannerId, error: Failure): string {
  const name = plannerName(lang, planner);
  return error.code === "interrupted"
    ? translate(lang, "error.budget", { planner: name, ms: error.message })
    : translate(lang, "error.config", { planner: name, path: error.path, reason: withoutPath(error) });
}
