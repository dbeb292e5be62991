/** The check of all bays as rows of a table. */
import type { AuditRow } from "parkade";
import { bestRow, gradeOf, type BayCheck } from "../store/bay-check";

export const BAY_COLUMNS = ["bay", "headIn", "reverseIn", "length", "seconds", "clearance"] as const;
export type BayColumn = (typeof BAY_COLUMNS)[number];

export const UNITS: Partial<Record<BayColumn, string>> = { length: "m", seconds: "s", clearance: "m" };

export interface BayLine {
  index: number;
  bay: string;
  best: AuditRow;
  headIn: AuditRow | undefined;
  reverseIn: AuditRow | undefined;
}

export interface BayOrder {
  column: BayColumn | "worst";
  descends: boolean;
}

export function bayLines(check: BayCheck, { column, descends }: BayOrder): BayLine[] {
  const lines = [...check.rows].flatMap(([index, rows]): BayLine[] => {
    const best = bestRow(check, index),
      by = (entry: AuditRow["entry"]): AuditRow | undefined => rows.find((row) => row.entry === entry);
    return best ? [{ index, bay: best.bay, best, headIn: by("head-in"), reverseIn: by("reverse-in") }] : [];
  });
  const key = KEYS[column],
    sign = descends ? -1 : 1;
  return lines.sort((a, b) => sign * (key(a) - key(b)) || a.index - b.index);
}

/** Moves, with out of reach beyond any number of them. */
const movesOf = (row: AuditRow | undefined): number => (row ? (gradeOf(row) === 0 ? 1e6 : row.moves) : 2e6);
const valueOf = (row: AuditRow, value: number | null): number => (row.reachable ? (value ?? Infinity) : Infinity);

/** Worst first: out of reach, then many moves, then little room. */
const KEYS: Record<BayOrder["column"], (line: BayLine) => number> = {
  worst: ({ best }) => -movesOf(best) * 1000 + (best.reachable ? best.clearance : 0),
  bay: ({ index }) => index,
  headIn: ({ headIn }) => movesOf(headIn),
  reverseIn: ({ reverseIn }) => movesOf(reverseIn),
  length: ({ best }) => valueOf(best, best.length),
  seconds: ({ best }) => valueOf(best, best.driveTime),
  clearance: ({ best }) => valueOf(best, best.clearance),
};

/** One line a bay, vehicle and entry, for spreadsheets. */
export function bayCsv(check: BayCheck): string {
  const head =
    "bay,vehicle,entrance,entry,reachable,outcome,moves,length_m,time_s,clearance_m," +
    "out_reachable,out_moves,blocker,reason";
  const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const rows = [...check.rows.keys()].sort((a, b) => a - b).flatMap((index) => check.rows.get(index)!);
  return [
    head,
    ...rows.map((row) =>
      [
        quoted(row.bay),
        quoted(row.vehicle),
        quoted(row.entrance),
        row.entry,
        row.reachable,
        row.outcome,
        row.moves,
        ...[row.length, row.driveTime, row.clearance].map((value) =>
          row.reachable && value !== null ? value.toFixed(3) : "",
        ),
        row.out?.reachable ?? "",
        row.out?.moves ?? "",
        quoted(row.blocker ?? ""),
        quoted(row.reason ?? ""),
      ].join(","),
    ),
    "",
  ].join("\r\n");
}
