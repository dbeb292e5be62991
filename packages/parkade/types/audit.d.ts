/** Every bay of a lot: vehicles, audits, and lots by seed. */

import type { PlannerSettings } from "../settings.js";
import type { Detail, Outcome } from "./plan.js";
import type { Goal, Pose, Scenario, Vehicle, VehicleSpec } from "./scene.js";

/** A vehicle of the library, from the standards and everyday traffic; metres and radians. */
export interface LibraryVehicle {
  id: string;
  title: { en: string; zh: string };
  wheelbase: number;
  /** Front axle to front bumper, rear axle to rear bumper. */
  frontOverhang: number;
  rearOverhang: number;
  /** Without mirrors. */
  width: number;
  /** Null where the source does not state it. */
  widthWithMirrors: number | null;
  maxSteer: number;
  /**
   * Radii of the circles of the outer front wheel and of the outer front corner at full lock, as the source states
   * them.
   */
  kerbRadius: number | null;
  wallRadius: number | null;
  /** Fields that the source leaves open and that were chosen here. */
  assumed: string[];
  source: string;
  /** The same as dimensions of a scene's vehicle, without mirrors. */
  vehicle: Vehicle;
}

/** Where vehicles come in and leave. */
export interface Entrance {
  id: string;
  /** Of the scene's car; other vehicles stand with their tail in the same place. */
  pose: Pose;
  /** Where they leave; where absent, at the entrance with the nose at the other end. */
  exit?: Pose;
}

export interface AuditOptions {
  /** Ids of the library, profiles, or dimensions with an id of one's own; default: the scene's car. */
  vehicles?: (string | { id: string; vehicle: VehicleSpec })[];
  /** Default: head-in and reverse-in. */
  entries?: ("head-in" | "reverse-in")[];
  /** Occupied bays are left out ("as-is", the default), or each is asked as if it were free. */
  whatIf?: "as-is" | "each-free";
  /** Default: the scene's start, with the id "start". */
  entrances?: Entrance[];
  /** Ids or indices of slots; default: all. Parts give exactly the rows of the whole. */
  bays?: (string | number)[];
  /** True (default) if ways out are asked as well. */
  out?: boolean;
  /** Settings of `hybrid`, laid over the scene's. */
  settings?: Partial<PlannerSettings["hybrid"]>;
}

/** A way in or out, or why there is none. */
export interface AuditWay {
  /** True if there is a path that the independent validator accepts. */
  reachable: boolean;
  /** As a plan's; `budget-spent` where nothing is proven. */
  outcome: Outcome;
  detail: Detail | null;
  /** For people, where there is no path. */
  reason: string | null;
  /** The place that blocks the way, or the obstacle's point nearest to the body on it. */
  place: [number, number] | null;
  /** What stands there, by name. */
  blocker: string | null;
  /** Gear changes and one; 0 without a path. */
  moves: number;
  length: number;
  /** Seconds. */
  driveTime: number | null;
  /** Least distance from the body to anything along the way. */
  clearance: number;
  /** The plan's hash: for ways in that of `hybrid` between the same poses, for ways out that of `hybrid-forward`. */
  hash: string;
  /** x, y, heading, … half a metre apart along the way, and its last pose. */
  swept: Float64Array;
}

/** The answer for one bay, vehicle, entrance and entry. */
export interface AuditRow extends AuditWay {
  /** The slot's id, or `#` and its number from 1; `index` is its place in the scene's slots. */
  bay: string;
  index: number;
  vehicle: string;
  entrance: string;
  entry: "head-in" | "reverse-in";
  /** How far the parked body sticks out of the bay, along its lines or across them; 0 where it fits. */
  overhang: number;
  /** Null where `out` is false. */
  out: AuditWay | null;
}

/**
 * Asks of each bay whether each vehicle can drive in from each entrance, and out again: rows bay by bay, and for each
 * bay by vehicle, entrance and entry, in the order of the options. `onRow` is given each row at once; where it answers
 * false, the audit ends with the rows so far. `parkade` only, not `parkade/core`.
 */
export function audit(
  scene: Scenario, options?: AuditOptions & { onRow?: (row: AuditRow) => boolean | void },
): AuditRow[];
/**
 * An audit in parts, of which several run at once, such as in workers: the same rows as `audit`'s, in the same order,
 * for any number of them. `run` audits one part; at most `workers` (default 2) parts of `bays` bays (default 4) are
 * under way. `signal` ends it: it rejects with the signal's reason, and gives `run` the signal, too. `parkade` only,
 * not `parkade/core`.
 */
export function auditInParts(
  scene: Scenario,
  options: AuditOptions,
  run: (scene: Scenario, options: AuditOptions, signal?: AbortSignal) => AuditRow[] | Promise<AuditRow[]>,
  how?: {
    workers?: number;
    bays?: number;
    signal?: AbortSignal;
    /** After each part: bays so far, all bays, and the part's rows. */
    onProgress?: (progress: { done: number; total: number; rows: AuditRow[] }) => void;
  },
): Promise<AuditRow[]>;
/**
 * Of an audit's rows those that an edit can touch: their swept body comes near what was added or removed, their bay
 * changed, or they were out of reach and something was removed; all, where more than obstacles and slots changed. The
 * other rows stay true, but an audit of the edited scene may find other paths. `options`: the audit's. `parkade` only,
 * not `parkade/core`.
 */
export function affectedRows(before: Scenario, after: Scenario, rows: AuditRow[], options?: AuditOptions): AuditRow[];

/** How a lot is drawn; what is absent is the preset's or, without one, drawn by the seed. Metres and radians. */
export interface LotOptions {
  /** Id of one of `lotPresets`. */
  preset?: string;
  /** Default 1, or the preset's. */
  seed?: number;
  /** Rows of bays, two of which share an aisle: 1 to 40; bays in each: 1 to 100. */
  rows?: number;
  bays?: number;
  /** Between aisle and bay: 0.5 to π/2. */
  angle?: number;
  /** The rectangle that a bay holds; the lines beside an angled bay are longer. */
  bayWidth?: number;
  bayLength?: number;
  /** Width of the aisles. */
  aisle?: number;
  /** Bays from one column to the next; 0 for none. */
  columns?: number;
  /** Share of occupied bays, 0 to 1. */
  occupancy?: number;
  /** 1 or 2. */
  entrances?: number;
  /** Width of a ramp that joins the first aisle at a right angle; 0 for none. */
  ramp?: number;
}

/** Draws a parking lot: the same for the same options. `parkade` only, not `parkade/core`. */
export function generateLot(options?: LotOptions): { scene: Scenario<Goal>; entrances: Pose[] };
/** Lots with a name. `parkade` only, not `parkade/core`. */
export function lotPresets(): { id: string; title: { en: string; zh: string }; bays: number }[];
/** The library of vehicles. `parkade` only, not `parkade/core`. */
export function vehicles(): LibraryVehicle[];
