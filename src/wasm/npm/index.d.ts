/** Vehicle path planners. SI units, radians; x east, y north, headings counter-clockwise from east. */

export type PlannerId = "four" | "eight" | "risk-field" | "hybrid" | "hybrid-forward";

export type Outcome =
  | "found" | "no-path" | "budget-spent" | "interrupted"
  | "start-blocked" | "goal-blocked" | "start-outside" | "goal-outside";

export interface Pose { x: number; y: number; heading: number }

/** Lower left corner of cell (0, 0) is at `origin`; `resolution` is the side of a cell in metres. */
export interface MapFrame {
  origin: [number, number];
  width: number;
  height: number;
  resolution: number;
  /** Outline of the drivable floor; the map's rectangle where absent. Its edges are walls. */
  boundary?: [number, number][];
}

export type Obstacle =
  /** Brushed cells: runs of [x, y, count], eastward, in cells. */
  | { type: "cells"; id?: string; runs: [number, number, number][] }
  /** A wall along a polyline; thickness 0 is a mathematical line. */
  | { type: "wall"; id?: string; points: [number, number][]; thickness?: number }
  | { type: "polygon"; id?: string; points: [number, number][] }
  /** size = [along heading, across]. */
  | { type: "rectangle"; id?: string; center: [number, number]; size: [number, number]; heading?: number }
  | { type: "car"; id?: string; pose: Pose; vehicle?: VehicleSpec };

/** (x, y): middle of the open side; heading: from the aisle into the slot, at right angles to the aisle. */
export interface Slot {
  id?: string;
  kind: "perpendicular" | "parallel" | "angled";
  x: number;
  y: number;
  heading: number;
  /** Clear width across the car's axis (for `parallel`: the depth from the aisle). */
  width: number;
  /** Clear length along the car's axis. */
  length: number;
  /** `angled` only: angle between aisle and car axis, in (0, π/2); default π/4. */
  angle?: number;
  /** `angled` only: to which side of `heading` the car's axis leans; default "left". */
  lean?: "left" | "right";
  occupied?: boolean;
}

export interface Vehicle {
  wheelbase: number;
  width: number;
  /** Rear axle to front bumper. */
  rearToFront: number;
  /** Rear axle to rear bumper. */
  rearToBack: number;
  maxSteer: number;
  maxSteerRate?: number;
}

export type VehicleSpec = "paper" | "sedan" | Vehicle;

export type Goal = Pose | { slot: string; entry: "reverse-in" | "head-in" };

export interface Scenario {
  version: 1;
  name?: string;
  map: MapFrame;
  obstacles?: Obstacle[];
  slots?: Slot[];
  vehicle?: VehicleSpec;
  start: Pose;
  goal: Goal;
  /** Settings per planner id, laid over that planner's defaults. */
  planners?: Partial<Record<PlannerId, Record<string, unknown>>>;
}

export interface Stats {
  expanded: number;
  generated: number;
  pushes: number;
  /** Largest size of the open list. */
  openPeak: number;
  /** Grid planners: second expansions (risk-field). */
  deferred?: number;
  losCalls?: number;
  /** Grid planners: exact integer cost in millionths of a cell. */
  costMicro?: number;
  /** Hybrid: the same number as `expanded`, by the name of its specification. */
  expansions?: number;
  collisionChecks?: number;
  /** Hybrid: level of the resolution ladder that gave the path. */
  level?: number;
}

export interface Metrics {
  /** Length of `path`, metres. */
  length: number;
  directionChanges: number;
  /** Largest |curvature| of `path`, 1/m; null where it has corners. */
  maxCurvature: number | null;
  /** The car's limit, 1/m. */
  curvatureLimit: number;
  /** Of the car's body along `path`, metres. */
  minClearance: number;
  meanClearance: number;
  /** Grid planners, cells: see the grid specification. */
  lengthRaw?: number;
  lengthPruned?: number;
  lengthSmoothed?: number;
  turns?: number;
  turnAngleDeg?: number;
  turnsPruned?: number;
  turnAngleDegPruned?: number;
  sharpCorners?: number;
  arcs?: number;
  /** Smallest arc radius, cells. */
  minRadius?: number | null;
  /** Hybrid: path cost, shortest Reeds–Shepp length without obstacles (m), gap to it in percent. */
  cost?: number;
  rsBound?: number;
  gapPercent?: number;
  /** Hybrid: the parking paper's rounding. */
  paperLength?: number;
  paperNodes?: number;
  paperTime?: number;
}

/** What the independent checker says of `path`: exact footprint against exact obstacles. */
export interface Check {
  /** "ok": this car can drive it and arrives as asked. */
  verdict: "ok" | "arrives-turned" | "too-tight" | "collides" | "none";
  /** Whether this car can drive it: no hit, no turn tighter than its limit, starts along its heading. */
  drivable: boolean;
  /** Poses of `path` at which the body overlaps something. */
  hits: number;
  /** Their indices into `path`. */
  hitPoses: Uint32Array;
  /** What is hit first: its id or kind ("border", "wall", "polygon", …), its index in `obstacles` (or -1) and the pose. */
  firstHit: { obstacle: string; index: number; pose: Pose } | null;
  /** Corners and arcs that turn tighter than the car can. */
  tightTurns: number;
  /** Steps in which the body moves sideways; a path that begins elsewhere than at the start counts as one. */
  slips: number;
  /** Tightest radius, metres; 0 at a corner, null for a straight path. */
  tightestRadius: number | null;
  /** The limit, metres. */
  minTurningRadius: number;
  /** Radians, between the car's start heading and the path's first heading. */
  startHeadingError: number;
  goalHeadingError: number;
  /** Metres between the last pose and the goal. */
  goalDistance: number;
}

export type Trace =
  /** Cell indices (y * width + x) in order of expansion. */
  | { kind: "cells"; cells: Uint32Array; dropped: number }
  /** Hybrid search tree: x, y, heading, curvature, signed length of each arc as driven, in order of expansion. */
  | { kind: "arcs"; arcs: Float32Array; dropped: number };

export interface Plan {
  planner: PlannerId;
  outcome: Outcome;
  /** A finer word for the outcome: "unreachable", "too-narrow", "stranded", "suboptimal", "verification-failed". */
  detail: string | null;
  /** For people, when there is no path: what is in the way, where the search stopped. */
  reason: string | null;
  /** x, y, heading, … at most 0.1 m apart (grid paths beyond 5 km: 50 000 poses). */
  path: Float64Array;
  /** Per pose: +1 forward, −1 reverse. */
  directions: Int8Array;
  /** Per pose: signed curvature of the path ahead, 1/m; NaN at a corner. */
  curvatures: Float64Array;
  /** Per pose: distance from the body to the nearest obstacle, metres; 0 where it overlaps. */
  clearances: Float64Array;
  /** The planner's unprocessed path, x, y, …: cell centres, or the ends of the arcs. */
  rawPath: Float64Array;
  stats: Stats;
  metrics: Metrics;
  check: Check;
  trace: Trace | null;
  /** The same in every browser and in Node; time and trace are no part of it. */
  hash: string;
}

export type LayerName = "occupancy" | "safety" | "clearance" | "risk";

export interface Layer {
  width: number;
  height: number;
  /**
   * Row-major from the south-western cell. occupancy: 0 free, 1 blocked. safety: 0 free, 1 obstacle, 2 necessary
   * safety space (half the car's width). clearance: metres from the cell's centre to the nearest blocked
   * cell's square. risk: force east, force north per cell.
   */
  data: Uint8Array | Float32Array;
}

export interface ParameterInfo {
  name: string;
  type: "number" | "integer" | "boolean" | "choice";
  /** "m", "rad", "cells", "1", … */
  unit: string;
  min?: number;
  max?: number;
  step?: number;
  choices?: string[];
  default: number | boolean | string | null;
  /** Whether people reach for it first. */
  basic: boolean;
  title: { en: string; zh: string };
  doc: { en: string; zh: string };
}

export interface PlannerInfo {
  id: PlannerId;
  family: "grid" | "hybrid";
  title: { en: string; zh: string };
  paper: string;
  parameters: ParameterInfo[];
}

export interface ScenarioInfo {
  id: string;
  /** "parking", "grid", "paper". */
  group: string;
  title: { en: string; zh: string };
  /** The question the scene asks. */
  question: { en: string; zh: string };
}

/** A scene resolved to plain geometry, metres. */
export interface SceneGeometry {
  start: Pose;
  goal: Pose;
  vehicle: Required<Vehicle> & { minTurningRadius: number };
  boundary: [number, number][];
  /** Outlines of each slot's four corners: near left, near right, far right, far left, seen from the aisle. */
  slots: [number, number][][];
  /** Cars standing in occupied slots. */
  parkedCars: { slot: number; pose: Pose; vehicle: Required<Vehicle> }[];
}

export class ParkadeError extends Error {
  /** "bad-config" | "bad-scenario" | "bad-vehicle" | "bad-input" | "bad-import" | "unknown-planner" | "unknown-scenario" | "freed" | "not-initialised" | "internal" */
  readonly code: string;
  /** The field, such as "obstacles[2].points[0]"; empty for the whole. */
  readonly path: string;
}

/** Loads the wasm module, once. `wasm`: its bytes, a module or where it is, instead of the file beside this one. */
export function init(options?: { wasm?: BufferSource | WebAssembly.Module | URL | string }): Promise<void>;
export function version(): string;
export function planners(): PlannerInfo[];
export function defaultConfig(planner: PlannerId): Record<string, unknown>;
export function scenarios(): ScenarioInfo[];
export function scenario(id: string): Scenario;
/** Checks a scene and resolves it to geometry. Throws ParkadeError. */
export function sceneGeometry(scene: Scenario): SceneGeometry;
/** Re-checks any path (x, y, heading, …) against a scene. `directions` defaults to forward throughout. */
export function checkPath(scene: Scenario, path: Float64Array | number[], directions?: Int8Array | number[]): Check;

export class Planner {
  /** Checks scene and settings and prepares the map, once. Throws ParkadeError. */
  constructor(planner: PlannerId, scene: Scenario, config?: Record<string, unknown>);
  plan(options?: { trace?: boolean }): Plan;
  layer(name: LayerName): Layer;
  free(): void;
  [Symbol.dispose](): void;
}
