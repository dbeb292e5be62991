/** The scene: a map, obstacles, slots, a vehicle, start and goal; and what it resolves to. */

import type { PlannerSettings } from "../settings.js";

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
  | { type: "car"; id?: string; pose: Pose; vehicle?: VehicleSpec }
  | Road;

/**
 * A road along a line with rounded corners. Its kerbs block; its ends are open, and so are its sides where other roads
 * meet it. Traffic keeps to the right: `cost-map` to the lanes in the direction from start to goal.
 */
export interface Road {
  type: "road";
  id?: string;
  /** Corners of its middle line, metres. */
  points: [number, number][];
  /** Of the middle line at corners, metres; default 20, smaller where ways are short. */
  radius?: number;
  /** Along the line, against it; default [1, 1], at most 8 each. */
  lanes?: [number, number];
  /** Metres; default 3.5. */
  laneWidth?: number;
  /** Speed limit, m/s. */
  speed?: number;
  /** True if its sides are kerbs; default true. */
  kerbs?: boolean;
}

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

/**
 * A box that follows a line at constant speed, its length along its motion. It stands at the first point before its
 * start and at the last one after its arrival. Planners leave it out; `stopWaitGo` waits for it.
 */
export interface MovingObstacle {
  id?: string;
  /** The way of the box's centre. */
  points: [number, number][];
  /** Length along the motion, width across it. */
  size: [number, number];
  /** Metres per second. */
  speed: number;
  /** When it starts to move, seconds; default 0. */
  start?: number;
}

/** A lane's middle, from its beginning in the direction of travel: straight lines and arcs, one after the other. */
export interface Lane {
  id?: string;
  start: Pose;
  /** Curvature in 1/m, positive to the left; default 0. */
  pieces: { length: number; curvature?: number }[];
  width: number;
}

/** An area, a simple polygon, in which nobody may drive faster; m/s. */
export interface SpeedLimit { points: [number, number][]; speed: number }

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

/** "ship": 72 m × 16 m, turns in 144 m; not in `parkade/core`. */
export type VehicleSpec = "paper" | "sedan" | "ship" | Vehicle;

export type Goal = Pose | { slot: string; entry: "reverse-in" | "head-in" };

/**
 * Several goals, of which a plan takes the one that is the cheapest to reach and names it in `goal`. Not in
 * `parkade/core`.
 *
 * - Slots by their ids, or every free one. Occupied slots are left out.
 * - Poses, 1 to 1000. Those at which the car overlaps something are left out.
 * - A region: a simple polygon that shall hold the whole car, and where its nose shall point, ± 15°; anywhere without
 *   `heading`.
 *
 * The `hybrid` planners search from all goals at once; the other planners go to one goal after another.
 */
export type GoalSet =
  | { slots: "free" | string[]; entry: "either" | "reverse-in" | "head-in" }
  | Pose[]
  | { region: [number, number][]; heading?: number };

/** The goal of a `GoalSet` that a path leads to. */
export interface TakenGoal {
  /** Of the pose in the list, or of the slot in the scene's `slots`; 0 in a region. */
  index: number;
  /** The slot's id, if it has one. */
  slot?: string;
  entry?: "reverse-in" | "head-in";
  pose: Pose;
}

/** Runs of brushed cells: x of the first, y, number of cells eastward. */
export type Run = [number, number, number];

/** Cells that cost more to cross: their length times `weight`, 1 to 10. Where areas overlap the heaviest counts. */
export interface CostArea {
  id?: string;
  runs: Run[];
  weight: number;
}

export interface Scenario<AnyGoal extends Goal | GoalSet = Goal | GoalSet> {
  version: 1;
  name?: string;
  map: MapFrame;
  obstacles?: Obstacle[];
  slots?: Slot[];
  /**
   * `jump-point`, `any-angle`, `greedy`, `rrt` and `genetic`, for which all free cells cost the same, refuse scenes
   * with weights above 1.
   */
  costs?: CostArea[];
  /** Left out by planners; `parkade/core` does not even check it. */
  moving?: MovingObstacle[];
  /** For planners that keep to lanes; `parkade/core` leaves lanes and limits out. */
  lanes?: Lane[];
  speedLimits?: SpeedLimit[];
  vehicle?: VehicleSpec;
  start: Pose;
  goal: AnyGoal;
  /** Settings per planner id, laid over that planner's defaults. */
  planners?: Partial<PlannerSettings>;
}

export interface ScenarioInfo {
  id: string;
  group: "parking" | "grid" | "tight" | "paper" | "moving" | "road" | "figures";
  title: { en: string; zh: string };
  /** The question the scene asks. */
  question: { en: string; zh: string };
}

/** A vehicle with nothing left open, and the radius (m) in which it turns. */
export type SceneVehicle = Required<Vehicle> & { minTurningRadius: number };

/** A scene resolved to plain geometry, metres. */
export interface SceneGeometry {
  start: Pose;
  /** Of a set of goals the first, whether or not the car has room there; the start where there is none. */
  goal: Pose;
  /** A set of goals: every slot's poses, the list, or a sample of the region. Not in scenes with one goal. */
  goals?: TakenGoal[];
  vehicle: SceneVehicle;
  boundary: [number, number][];
  /** Outlines of each slot's four corners: near left, near right, far right, far left, seen from the aisle. */
  slots: [number, number][][];
  /** Cars standing in occupied slots. */
  parkedCars: { slot: number; pose: Pose; vehicle: SceneVehicle }[];
}

export function scenarios(): ScenarioInfo[];
export function scenario(id: string): Scenario<Goal>;
/** Checks a scene and resolves it to geometry. Throws ParkadeError. */
export function sceneGeometry(scene: Scenario): SceneGeometry;
/**
 * Brushed cells as text, about two characters a run, for links, files and messages. A scene's `runs` may be such a text
 * wherever a scene is read; scenes that the package makes have them as numbers.
 */
export function packRuns(runs: readonly Run[]): string;
/** The runs that `packRuns` made a text of. */
export function unpackRuns(text: string): Run[];
