/** The check of all bays as views read it. */
import type { AuditRow, VehicleSpec } from "parkade";

export type BayEntry = "either" | "head-in" | "reverse-in";

export interface AskedVehicle {
  id: string;
  vehicle: VehicleSpec;
}

export interface BayCheck {
  vehicle: AskedVehicle;
  entry: BayEntry;
  /** Of the vehicle, by bay. */
  rows: ReadonlyMap<number, readonly AuditRow[]>;
  /** Bays whose answers are of the scene before an edit. */
  stale: ReadonlySet<number>;
  done: number;
  of: number;
  /** The bay pointed at, on the map or in the table. */
  lit: number | null;
  /** True while the plan into a bay is looked at. */
  opened: boolean;
}

/** The better way into a bay of those asked for; the first of them where there is none; undefined before any answer. */
export function bestRow(check: BayCheck, index: number): AuditRow | undefined {
  const rows = (check.rows.get(index) ?? []).filter(({ entry }) => check.entry === "either" || entry === check.entry);
  const reached = rows.filter(({ reachable }) => reachable);
  return reached.sort((a, b) => a.moves - b.moves || a.length - b.length)[0] ?? rows[0];
}

/** More moves than this make a bay hard. */
export const HARD = 3;

/** 1 to 4 by moves, the last for more than three; 0 is out of reach. */
export const gradeOf = ({ reachable, moves }: AuditRow): number => (reachable ? Math.min(moves, HARD + 1) : 0);

export interface BayCounts {
  asked: number;
  reachable: number;
  hard: number;
}

export function countBays(check: BayCheck): BayCounts {
  const counts = { asked: 0, reachable: 0, hard: 0 };
  for (const index of check.rows.keys()) {
    const row = bestRow(check, index);
    if (!row) continue;
    counts.asked++;
    if (row.reachable) counts.reachable++;
    if (row.reachable && row.moves > HARD) counts.hard++;
  }
  return counts;
}
