/** The jobs of complete-module workers besides planning. */
import type { Choice } from "../store/results";
import type {
  AuditOptions,
  AuditRow,
  Explanation,
  Family,
  HybridPlan,
  HybridPlannerId,
  ImportOptions,
  Imported,
  Limits,
  PaperRow,
  ParkingRow,
  ParkingTable,
  PaperTable,
  Plan,
  PlannerId,
  PaperClaim,
  Prefer,
  RoadFigures,
  RoadRow,
  RoadTable,
  PoseTrace,
  SearchTrace,
  VolumeComparison,
} from "parkade";
import {
  Planner,
  audit,
  collisionRisk,
  generateScenario,
  importScene,
  init,
  driveEnvelope,
  packRuns,
  paperGrid,
  paperGridRows,
  paperGridSummary,
  paperParking,
  paperParkingRows,
  paperRoad,
  paperRoadRows,
  paperIncomplete,
  paperVerdicts,
  paperVolumes,
  roadFigures,
  scenario,
} from "parkade";
import type { Run } from "../scene/cells";
import type { Scenario } from "parkade";
import { compare, envelope, sweep, type Compared, type Engine, type Sample, type Swept } from "./comparison";
import { cheapest, choicesOf, type Driven } from "./choices-of";
import { driveOf } from "./drive-of";
import { judged, smoothed } from "./trajectories";
import { answerCalls } from "./answer-calls";
import type { Waiting } from "./protocol";

/** Lists of cells longer than this travel as numbers and as a text. */
const MANY = 2000;

/** The cells of an obstacle: x, y, count of each run. */
export interface Cells {
  scene: number;
  obstacle: number;
  numbers: Int32Array;
  text: string;
}
export interface Moved<T> {
  value: T;
  cells: Cells[];
}

const ENGINE: Engine = { Planner, scenario, collisionRisk, driveEnvelope };

const JOBS = {
  audit: ({ scene, options }: { scene: Scenario; options: AuditOptions }): AuditRow[] => audit(scene, options),
  /** The answer alone, without its search. */
  solve: ({ planner, scene }: { planner: PlannerId; scene: Scenario }): Plan => {
    const made = new Planner(planner, scene);
    try {
      return made.plan({ trace: false });
    } finally {
      made.free();
    }
  },
  /**
   * What there is to choose from; tells of each path that is better than the first one by what is preferred, or costs
   * less.
   */
  improve: (
    {
      planner,
      scene,
      prefer,
      waiting,
      limits,
    }: { planner: HybridPlannerId; scene: Scenario; prefer: Prefer | undefined; waiting: Waiting; limits: Limits },
    tell: (better: Driven) => void,
  ): Driven[] => {
    const made = new Planner(planner, scene);
    const driven = (choice: Choice): Driven => {
      try {
        return { ...choice, drive: driveOf(scene, choice.plan, waiting, limits) };
      } catch {
        return { ...choice, drive: null };
      }
    };
    let first: HybridPlan | undefined;
    try {
      const best = made.plan({
        ...(prefer && { prefer }),
        alternatives: true,
        onImproved: (plan) => {
          if (first) tell(driven({ plan, by: prefer ? [prefer] : [], isOrdinary: !prefer }));
          else first = plan;
        },
      });
      const others = best.alternatives ?? [best];
      return choicesOf(cheapest(first ?? best, others), others).map(driven);
    } finally {
      made.free();
    }
  },
  /** The search once more, with all that it did. */
  record: ({
    planner,
    scene,
    limit,
  }: {
    planner: PlannerId;
    scene: Scenario;
    limit: number;
  }): SearchTrace | PoseTrace | null => {
    const made = new Planner(planner, scene);
    try {
      const { trace } = made.plan({ trace: "full", traceLimit: limit });
      return trace?.kind === "search" || trace?.kind === "poses" ? trace : null;
    } finally {
      made.free();
    }
  },
  /** The risk field at a point. */
  field: ({
    planner,
    scene,
    at,
  }: {
    planner: PlannerId;
    scene: Scenario;
    at: { x: number; y: number };
  }): Explanation | null => {
    const made = new Planner(planner, scene);
    try {
      return made.explain(at);
    } finally {
      made.free();
    }
  },
  smooth: smoothed,
  judge: judged,
  /** The length of the shortest path at any angle, on the map of this planner. */
  anyAngle: ({ planner, scene }: { planner: PlannerId; scene: Scenario }): number | null => {
    const made = new Planner(planner, scene);
    try {
      return made.anyAngleLength();
    } finally {
      made.free();
    }
  },
  import: ({
    files,
    options,
  }: {
    files: Record<string, Uint8Array>;
    options: ImportOptions;
  }): Moved<Omit<Imported, "scene" | "scenes"> & { scenes: Scenario[] }> => {
    const { format, scenes, queries, notes } = importScene(files, options);
    const { value, cells } = apart(scenes);
    return { value: { format, scenes: value, queries, notes }, cells };
  },
  generate: (family: Family): Moved<Scenario[]> => apart([generateScenario(family)]),
  rows: (): { rows: PaperRow[]; planners: string[]; columns: string[] } => paperGridRows(),
  paper: (slice: { row: string; from: number; to: number }): Float64Array => paperGrid(slice),
  summary: (measured: Record<string, Float64Array>): { tables: PaperTable[]; claims: PaperClaim[] } =>
    paperGridSummary(measured),
  parkingRows: (): ParkingRow[] => paperParkingRows(),
  parking: (options: { row: string }): ParkingTable => paperParking(options),
  roadRows: (): RoadRow[] => paperRoadRows(),
  roadFigures: ({ scene, path }: { scene: Scenario; path: Float64Array }): RoadFigures => roadFigures(scene, { path }),
  risk: ({
    scene,
    path,
    ...trials
  }: {
    scene: Scenario;
    path: Float64Array;
    from: number;
    trials: number;
  }): ReturnType<typeof collisionRisk> => collisionRisk(scene, { path }, trials),
  road: (options: { row: string }): RoadTable => paperRoad(options),
  verdicts: (tables: { parking?: ParkingTable[]; road?: RoadTable[] }): ReturnType<typeof paperVerdicts> =>
    paperVerdicts(tables),
  compared: ({ scene, planner }: { scene: string; planner: PlannerId }): Compared => compare(ENGINE, scene, planner),
  swept: ({ scene, swept }: { scene: string; swept: Swept }): Sample[] => sweep(ENGINE, scene, swept),
  envelope: ({ scene }: { scene: string }): Float64Array => envelope(ENGINE, scene),
  incomplete: (slice: { row: string; from: number; to: number }): number[] => paperIncomplete(slice),
  volumes: (options: { scene: string; poses: number; rounds: number }): VolumeComparison => paperVolumes(options),
};

export type Jobs = typeof JOBS;

/** Answers jobs and leaves everything else to who listened before. */
export const serveJobs = (): void =>
  answerCalls(
    JOBS,
    (module: WebAssembly.Module) => init({ wasm: module }),
    (answer) => {
      const { cells } = Object(answer) as Partial<Moved<unknown>>;
      return Array.isArray(cells) ? cells.map(({ numbers }) => numbers.buffer as ArrayBuffer) : [];
    },
  );

/** Scenes without their long lists of cells, and these. */
function apart(scenes: Scenario[]): Moved<Scenario[]> {
  const cells: Cells[] = [];
  const value = scenes.map(
    (scene, at): Scenario => ({
      ...scene,
      obstacles: (scene.obstacles ?? []).map((one, obstacle) => {
        if (one.type !== "cells" || one.runs.length <= MANY) return one;
        cells.push({ scene: at, obstacle, numbers: flat(one.runs), text: packRuns(one.runs) });
        return { ...one, runs: [] };
      }),
    }),
  );
  return { value, cells };
}

function flat(runs: readonly Run[]): Int32Array {
  const numbers = new Int32Array(3 * runs.length);
  runs.forEach((run, i) => numbers.set(run, 3 * i));
  return numbers;
}
