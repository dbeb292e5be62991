/** The papers' tables, measured beside the printed values. `parkade` only, not `parkade/core`. */

import type { PlannerId } from "../settings.js";
import type { Check } from "./check.js";
import type { RoadMetrics } from "./plan.js";

/**
 * A row of tables 3 and 4 of Hu et al. 2024; printed values of four neighbours, eight neighbours, the improved planner.
 */
export interface PaperRow {
  id: string;
  table: number;
  size: number;
  nodes: [number, number, number];
  lengths: [number, number, number];
  /** No path between the printed end points is shorter, cells. */
  straight: number;
}

/** Over many maps. */
export interface Spread { median: number; p95: number; worst: number }

export interface PaperTable {
  row: Omit<PaperRow, "straight">;
  straight: number;
  maps: number;
  lines: {
    planner: string;
    printedNodes: number | null;
    printedLength: number | null;
    /** The printed length is below the straight line. */
    impossible: boolean;
    /** The column whose median is nearest to the printed length; null where none is printed, or one that cannot be. */
    closest: "lengthRaw" | "lengthPruned" | "lengthDp" | "lengthSmoothed" | null;
    /** In the order of the columns. */
    figures: Spread[];
  }[];
  ratios: { figure: string; planner: string; overFigure: string; over: string; printed: number | null; ours: Spread }[];
}

/**
 * A claim of a paper and what we find. `figures`: ratios, percentages, metres or counts by name; of several rows the
 * smallest and the largest, null where none is measured.
 */
export interface PaperClaim {
  id:
    | "H1" | "H2" | "H3" | "Y1" | "Y2" | "Y3" | "Y4" | "Y5" | "Y6" | "K1" | "K2" | "K3" | "K4" | "K5"
    | "R1" | "R2" | "R3" | "R4" | "R5";
  figures: Record<string, number | [low: number, high: number] | null>;
  holds: "yes" | "no" | "partly" | "unknown";
}

/** Rows, planners and columns that `paperGrid` measures. `parkade` only, not `parkade/core`, as the next two. */
export function paperGridRows(): { rows: PaperRow[]; planners: string[]; columns: string[] };
/**
 * Measures a row of the risk-field paper on the maps of seeds `from` to `to`, both included: per map a number for each
 * planner and column. Slices may be measured anywhere, and joined in any order.
 */
export function paperGrid(slice: { row: string; from: number; to: number }): Float64Array;
/** The papers' values beside ours, from all figures of each row; claims are judged when all rows are there. */
export function paperGridSummary(measured: Record<string, Float64Array>): {
  tables: PaperTable[];
  claims: PaperClaim[];
};

/** A scene of the road manuscript; printed values of plain and improved A*. */
export interface RoadRow {
  id: string;
  /** The scene; with `ship` ten times as large, for the manuscript's ship, and in no menu. */
  scene: string;
  ship: boolean;
  /** Metres, seconds, MB; collisions of 1000. */
  printed: Record<"length" | "turns" | "safety" | "time" | "memory" | "collisions", [plain: number, improved: number]>;
}

export interface RoadTable {
  row: RoadRow;
  /** Of the map. */
  cells: number;
  /** Plain A* first. */
  lines: {
    id: "plain" | "inverse" | "exponential" | "literal" | "paper" | "paper-exponential";
    verdict: Check["verdict"];
    /** No curve was good enough. */
    fellBack: boolean;
    metrics: Required<Pick<RoadMetrics,
      | "cost" | "turnsRaw" | "turnsPruned" | "startMoved" | "goalMoved" | "bytes" | "middleLength"
      | "bodyClearanceMin" | "bodyClearanceMean" | "sideClearanceMin" | "sideClearanceMean" | "curvatureVariation"
      | "middleCurvature" | "laneDeviationMax" | "laneDeviationMean"
      | "laneLeftShare" | "margin" | "marginKept" | "marginExcluded" | "bodyClearanceMeanCapped">>;
    risk: { trials: number; hits: number; discHits: number };
    milliseconds: number;
  }[];
  /** Promises of the second line; none for ships. */
  promises: {
    figure:
      | "length" | "turns" | "curvatureVariation" | "curvature" | "clearanceMean" | "clearanceLeast" | "hits"
      | "laneDeviation" | "laneLeft" | "bytesPerCell";
    atLeast: boolean;
    bound: number;
    found: number;
    plain: number;
    kept: boolean;
  }[];
}

/** Rows that `paperRoad` measures. `parkade` only, not `parkade/core`, as the next one. */
export function paperRoadRows(): RoadRow[];
/**
 * Plans a scene of the road manuscript in several ways, the fastest of some rounds (1) for the time, with the risk of
 * each.
 */
export function paperRoad(options: { row: string; rounds?: number }): RoadTable;

/** A cell of the parking paper's tables: seconds of driving at 2 m/s, gear changes, nodes 0.1 m apart, metres. */
export interface ParkingFigures { time: number; changes: number; nodes: number; length: number }

/** A row of tables 2 to 11 of the parking paper. */
export interface ParkingRow {
  /** Of the scene. */
  id: string;
  /** First and last table. */
  tables: [number, number];
  /** Along the aisle, else across it. */
  parallel: boolean;
  traditional: ParkingFigures;
  improved: ParkingFigures;
  /** Bounds that "hybrid" must meet: metres, gear changes. */
  reach: [number, number];
  /** Error of the printed row; may be empty. */
  note: string;
}

export interface ParkingTable {
  row: ParkingRow;
  /** Length of the shortest path without obstacles, metres. */
  bound: number;
  /** True if the printed lengths, traditional and improved, are below that. */
  impossible: [boolean, boolean];
  /**
   * "hybrid-forward" (traditional), "hybrid" (improved), "hybrid-bidirectional", "hybrid-classic", in the paper's
   * rounding.
   */
  lines: (ParkingFigures & {
    planner: PlannerId;
    verdict: Check["verdict"];
    /** Metres, not rounded. */
    exact: number;
    clearance: number;
    expanded: number;
    /** Of the whole plan with its check, the fastest round. */
    milliseconds: number;
  })[];
  kept: boolean;
  /** Driving time that the improved column saves, percent: printed, ours. */
  saved: [number, number];
}

/** Rows that `paperParking` measures. `parkade` only, not `parkade/core`, as the next one. */
export function paperParkingRows(): ParkingRow[];
/** Plans a row of the parking paper with its planners; the fastest of some rounds (1) counts for the time. */
export function paperParking(options: { row: string; rounds?: number }): ParkingTable;

/** Percent of driving time saved on four rows of the parking paper. */
export interface ParkingSaved {
  /** By the abstract, and by the printed rows. */
  said: number;
  printed: number;
  /** "hybrid" against "hybrid-forward" and against "hybrid-classic". */
  overForward: number;
  overClassic: number;
}

/**
 * Claims of the parking paper and of the road manuscript, judged on their tables, which must be all there; none where
 * they are not. No verdict rests on a time. `saved`: of rows P1 to P4 and L1 to L4. `parkade` only, not `parkade/core`,
 * as the next two.
 */
export function paperVerdicts(tables: { parking?: ParkingTable[]; road?: RoadTable[] }): {
  parking: PaperClaim[];
  road: PaperClaim[];
  saved: [ParkingSaved, ParkingSaved] | null;
};
/**
 * The seeds of a row's maps, `from` to `to`, on which the risk field taken literally (`fallback: "none"`) finds no
 * path.
 */
export function paperIncomplete(slice: { row: string; from: number; to: number }): number[];

/** Volumes around the car held against its exact body (figures 4 and 5 of the parking paper). */
export interface VolumeComparison {
  scene: string;
  poses: number;
  /** Lines that each volume is tested against. */
  lines: number;
  /** Poses at which the exact body hits something. */
  collisions: number;
  volumes: {
    volume: "aabb" | "obb" | "ball";
    /** Poses at which it meets a line. */
    hits: number;
    /** Of those, poses at which the body is free. */
    falseAlarms: number;
    /** Poses at which the body is wholly behind a line, which the volume does not meet. */
    missed: number;
    /** Mean area over the body's. */
    area: number;
    /** Microseconds of a pose, the fastest round. */
    micros: number;
  }[];
}

/** Compares them on "P0", "park-fig13" or "reverse-in", on poses at random (10 000, seed 1, one round). */
export function paperVolumes(options: {
  scene: string;
  poses?: number;
  seed?: number;
  rounds?: number;
}): VolumeComparison;
