import type { Plan, PlannerId } from "parkade";
import { millis, number, translate, type Lang } from "../i18n/index";
import { plannerName } from "../styles/planner-style";
import type { PanelResult, State } from "../store";
import { played } from "../store/results";
import { isEncounter } from "../view/playback-time";
import { drivablePlan, searchTime, statusOf, timeTitle, type Status } from "../texts/status";
import { lastIn, nth } from "../scene/nth";

export const COLUMNS = [
  "length",
  "drive",
  "gears",
  "curvature",
  "clearance",
  "heading",
  "expanded",
  "open",
  "plan",
  "memory",
] as const;
export type Column = (typeof COLUMNS)[number];

export interface Cell {
  value: number | null;
  text: string;
  best: boolean;
  title: string;
}
export interface Row {
  planner: PlannerId;
  name: string;
  hidden: boolean;
  drivable: boolean;
  stale: boolean;
  status: Status;
  cells: Record<Column, Cell>;
}

const DIGITS: Record<Column, number> = {
  length: 2,
  drive: 1,
  gears: 0,
  curvature: 3,
  clearance: 2,
  heading: 1,
  expanded: 0,
  open: 0,
  plan: 2,
  memory: 0,
};

export function rowsOf(state: State): Row[] {
  const rows = state.planners.map((planner) => rowOf(state, planner));
  for (const column of COLUMNS) markBest(rows, column);
  return rows;
}

/** The largest number of timed runs behind any row. */
export function runsOf(state: State): number {
  return Math.max(1, ...state.planners.map((planner) => state.results[planner]?.samples.length ?? 0));
}

function rowOf(state: State, planner: PlannerId): Row {
  const result = state.results[planner];
  const drivable = drivablePlan(result) !== null;
  const cells = Object.fromEntries(
    COLUMNS.map((column) => {
      const value = valueOf(result, column, drivable);
      return [
        column,
        {
          value,
          text: textOf(state.lang, result, column, value),
          best: false,
          title: titleOf(state.lang, result, column),
        },
      ];
    }),
  ) as Record<Column, Cell>;
  return {
    planner,
    drivable,
    cells,
    name: plannerName(state.lang, planner),
    hidden: state.hidden.has(planner),
    stale: result?.status === "error",
    status: statusOf(state, planner),
  };
}

function valueOf(result: PanelResult | undefined, column: Column, drivable: boolean): number | null {
  const plan = result?.plan;
  if (!plan) return null;
  if (column === "expanded") return plan.stats.expanded;
  if (column === "open") return plan.stats.openPeak;
  if (column === "plan") return result.time?.search ?? null;
  if (column === "memory") return plan.stats.memoryBytes / 1000 || null;
  if (plan.outcome !== "found") return null;
  if (column === "drive") return drivable ? driveSeconds(result) : null;
  return pathValue(played(result)!.plan!, column, drivable);
}

/** Seconds of the drive that plays; null until it is known, and where the car does not arrive. */
export function driveSeconds(result: PanelResult): number | null {
  const drive = played(result)?.drive;
  return !drive || (isEncounter(drive) && drive.ending !== "arrived") ? null : lastIn(drive.t);
}

function pathValue({ metrics, check }: Plan, column: Column, drivable: boolean): number | null {
  switch (column) {
    case "length":
      return metrics.length;
    case "gears":
      return drivable ? metrics.directionChanges : null;
    case "curvature":
      return metrics.maxCurvature;
    case "clearance":
      return metrics.minClearance;
    case "heading":
      return Math.abs(check.goalHeadingError) * (180 / Math.PI);
    default:
      return null;
  }
}

function textOf(lang: Lang, result: PanelResult | undefined, column: Column, value: number | null): string {
  if (column === "plan" && result?.plan) return timeText(lang, result);
  // A drive follows its path, also when a drag has ended.
  if (column === "drive" && value === null && !result?.drive && drivablePlan(result)) return "…";
  if (value !== null && Number.isFinite(value)) return number(lang, value, DIGITS[column]);
  if (column === "curvature" && result?.plan?.outcome === "found") return translate(lang, "table.corner");
  return "–";
}

/** Repeats behind a benchmark; fewer are only the median. */
export const BENCH_RUNS = 25;

/** A benchmark shows its middle half beside the median. */
function timeText(lang: Lang, result: PanelResult): string {
  const text = searchTime(lang, result).replace(" ms", ""),
    spread = result.samples.length >= BENCH_RUNS ? quartiles(searchesOf(result)) : null;
  return spread ? `${text} [${millis(lang, spread[0])}–${millis(lang, spread[1])}]` : text;
}

const searchesOf = ({ samples }: PanelResult): number[] => samples.map(({ search }) => search);

function quartiles(samples: readonly number[]): [number, number] {
  const sorted = [...samples].sort((a, b) => a - b);
  const at = (share: number): number => nth(sorted, Math.round(share * (sorted.length - 1)));
  return [at(0.25), at(0.75)];
}

function titleOf(lang: Lang, result: PanelResult | undefined, column: Column): string {
  if (column !== "plan" || !result) return "";
  const title = timeTitle(lang, result),
    n = result.samples.length;
  if (n < 4) return title;
  const [low, high] = quartiles(searchesOf(result));
  return `${title} ${translate(lang, "tip.quartiles", { n, low: millis(lang, low), high: millis(lang, high) })}`;
}

/** The best drivable values; what reads the same is a tie. */
function markBest(rows: Row[], column: Column): void {
  const ranked = rows.filter((row) => row.drivable && !row.stale && row.cells[column].value !== null);
  if (ranked.length === 0) return;
  const values = ranked.map((row) => row.cells[column].value!);
  const best = column === "clearance" ? Math.max(...values) : Math.min(...values);
  const read = (cell: Cell): string => nth(cell.text.split(" ["), 0),
    text = read(ranked.find((row) => row.cells[column].value === best)!.cells[column]);
  for (const row of ranked) row.cells[column].best = read(row.cells[column]) === text;
}

export function unitValues(state: State): { limit: string; n: number } {
  const plan = state.planners.map((planner) => state.results[planner]?.plan).find((one) => one);
  return { limit: plan ? number(state.lang, plan.metrics.curvatureLimit, 3) : "–", n: runsOf(state) };
}
