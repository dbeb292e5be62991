import type { Explanation, Layer, Plan, PlannerId } from "parkade";
import { html, nothing, type TemplateResult } from "lit";
import "../i18n/later";
import { number, translate, type MessageKey } from "../i18n/index";
import type { Scene, State } from "../store";
import { played } from "../store/results";
import { weightAt } from "../scene/costs";
import { costRange } from "../view/layers/cost-raster";
import { spacingOf } from "../view/layers/painted-costs";
import { distancesOf, nearestPose } from "../view/drive";
import { drivesCar, hasField } from "../styles/planner-style";

type Entry = [label: string, value: string];

/** The values under the pointer, for one planner. */
export function readoutOf(state: State, planner: PlannerId): TemplateResult | typeof nothing {
  const entries = entriesOf(state, planner);
  if (entries.length === 0) return nothing;
  return html`<div class="pill readout">${entries.map(
    ([label, value]) => html`<span>${label}<b>${value}</b></span>`,
  )}</div>`;
}

export function legendOf(state: State, planner: PlannerId): TemplateResult {
  return html`${weightsOf(state)}${countsOf(state, planner)}`;
}

/** The weights that are painted, hatched as on the map. */
export function weightsOf({ scene: { costs = [] }, lang }: State): TemplateResult | typeof nothing {
  if (costs.length === 0) return nothing;
  const weights = [...new Set(costs.map(({ weight }) => weight))].sort((a, b) => a - b);
  return html`<div class="pill weights" title=${translate(
    lang,
    "read.weights",
  )}><span class="visually-hidden">${translate(lang, "read.weights")}</span>${weights.map(
    (weight) => html`
      <i
      .style=${
        `background:repeating-linear-gradient(135deg,var(--parkade-warn) 0 1.25px,color-mix(in ` +
        `srgb,var(--parkade-warn) ${Math.round(4 + 2.2 * weight)}%,transparent) 0 ${spacingOf(weight)}px)`
      }></i><span>×${weight}</span>`,
  )}</div>`;
}

function countsOf(state: State, planner: PlannerId): TemplateResult | typeof nothing {
  const stats = state.results[planner]?.plan?.stats;
  if (!state.layers.redundant || !stats || !("narrow" in stats)) return rampOf(state, planner);
  const { narrow = 0, pocket, restored } = stats;
  const counts = translate(state.lang, "read.redundant", { narrow, pocket: pocket ?? 0, restored: restored ?? 0 });
  return html`<div class="pill legend">${counts}</div>${rampOf(state, planner)}`;
}

function rampOf(state: State, planner: PlannerId): TemplateResult | typeof nothing {
  const plan = state.results[planner]?.plan;
  if (hasField(planner) && state.layers.risk && !state.layers.heat) return riskLegend(state);
  const expanded = plan?.stats.expanded ?? 0;
  const drawn = drivesCar(planner) ? state.layers.tree : state.layers.heat;
  const cost = state.layers.cost ? state.results[planner]?.layers.cost : undefined;
  const range = cost && !state.layers.heat ? costRange(cost) : undefined;
  if (range) {
    const { low, high } = range;
    return html`<div class="pill legend" title=${translate(state.lang, "layer.cost")}>
      <span>${number(state.lang, low, 2)}</span><span class="ramp"></span><span>≥
        ${number(state.lang, high, 2)}</span></div>`;
  }
  if (!drawn || expanded < 2) return nothing;
  const tree = plan?.trace?.kind === "arcs";
  return html`${
    tree ? html`<div class="pill legend tree">${translate(state.lang, "read.tree")}</div>` : nothing
  }<div class="pill legend" title=${translate(state.lang, "read.legend")}>
    <span>1</span><span class="ramp"></span><span>${number(state.lang, expanded, 0)}</span></div>`;
}

function riskLegend({ lang }: State): TemplateResult {
  return html`<div class="pill legend"><span>→ ${translate(lang, "read.gradient")}</span></div>`;
}

function entriesOf(state: State, planner: PlannerId): Entry[] {
  const { hover } = state;
  const result = state.results[planner];
  if (!hover || !result?.plan) return [];
  const text = (key: MessageKey): string => translate(state.lang, key);
  const shown = played(result)!.plan!,
    near = nearestPose(shown, hover.x, hover.y);
  if (drivesCar(planner) && near !== null) return poseEntries(state, shown, near);
  const cell = cellAt(state.scene, hover.x, hover.y);
  if (!cell) return [];
  const entries: Entry[] = [];
  if (result.plan.trace?.kind === "cells") entries.push([text("read.rank"), rankText(state, result.plan, cell.index)]);
  const risk = result.layers.risk,
    { explained } = state;
  if (risk && explained && explained.cell[1] * state.scene.map.width + explained.cell[0] === cell.index) {
    entries.push(...fieldEntries(state, explained));
  } else if (risk?.every === 1)
    entries.push([
      text("read.risk"),
      number(state.lang, Math.hypot(at(risk, cell.index * 2), at(risk, cell.index * 2 + 1)), 2),
    ]);
  const weight = weightAt(state.scene, cell.index);
  if (weight > 1) entries.push([text("read.weight"), `×${weight}`]);
  const cost = state.layers.cost ? result.layers.cost : undefined;
  if (cost) {
    const value = at(cost, cell.index);
    entries.push([text("read.cost"), Number.isFinite(value) ? number(state.lang, value, 2) : "\u221e"]);
  }
  const clearance = result.layers.clearance;
  if (clearance && clearance.data.length > cell.index) {
    entries.push([text("read.clearance"), `${number(state.lang, at(clearance, cell.index), 2)} m`]);
  }
  return entries;
}

/** F, its slope k, and the region of the paper's table that it falls in. */
function fieldEntries({ lang }: State, { force, slope, region, mode }: Explanation): Entry[] {
  return [
    ["F", number(lang, Math.hypot(force[0], force[1]), 2)],
    ["k", slope === null ? "\u221e" : number(lang, slope, 2)],
    [translate(lang, mode === "oblique" ? "read.table1" : "read.table2"), region],
  ];
}

function poseEntries({ lang }: State, plan: Plan, index: number): Entry[] {
  const curvature = plan.curvatures[index] ?? NaN;
  return [
    ["s", `${number(lang, distancesOf(plan)[index] ?? 0, 2)} m`],
    ["κ", Number.isFinite(curvature) ? number(lang, curvature, 3) : translate(lang, "table.corner")],
    [translate(lang, "read.clearance"), `${number(lang, plan.clearances[index] ?? 0, 2)} m`],
  ];
}

function rankText({ lang }: State, plan: Plan, cell: number): string {
  const rank = plan.trace?.kind === "cells" ? plan.trace.cells.indexOf(cell) : -1;
  return rank < 0 ? translate(lang, "read.unexpanded") : number(lang, rank + 1, 0);
}

const at = (layer: Layer, index: number): number => layer.data[index] ?? 0;

function cellAt({ map }: Scene, x: number, y: number): { index: number } | null {
  const column = Math.floor((x - map.origin[0]) / map.resolution);
  const row = Math.floor((y - map.origin[1]) / map.resolution);
  const inside = column >= 0 && row >= 0 && column < map.width && row < map.height;
  return inside ? { index: row * map.width + column } : null;
}
