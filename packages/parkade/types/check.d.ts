/** Paths measured: the independent checker, figures of roads, curves without obstacles. */

import type { Pose, Scenario } from "./scene.js";

/** The independent checker's verdict on `path`: exact footprint against exact obstacles. */
export interface Check {
  /** "ok": this car can drive it and arrives as asked. */
  verdict: "ok" | "arrives-turned" | "too-tight" | "collides" | "none";
  /** True if this car can drive it: no hit, no turn tighter than its limit, starts along its heading. */
  drivable: boolean;
  /** Poses of `path` at which the body overlaps something. */
  hits: number;
  /** Their indices into `path`. */
  hitPoses: Uint32Array;
  /**
   * The first obstacle hit: its id or kind ("border", "wall", "polygon", …), its index in `obstacles` (or -1) and the
   * pose.
   */
  firstHit: Hit | null;
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
  /** The pose with the least clearance, unless the body overlaps an obstacle. Not in `parkade/core`. */
  narrowest?: Narrowest;
}

/** The check of a path alone. */
export interface PathCheck extends Check {
  /** Per pose: metres from the body to the nearest obstacle. */
  clearances: Float64Array;
}

/** The narrowest place of a path. */
export interface Narrowest {
  /** Index into `path`. */
  pose: number;
  /** The body's point and the obstacle's, metres. */
  body: [number, number];
  point: [number, number];
  /** Its id or kind ("border", "wall", "polygon", …) and its index in `obstacles` (or -1). */
  obstacle: string;
  index: number;
}

/**
 * The obstacle in the way of a pose: its id or kind ("border", "wall", "polygon", …) and its index in `obstacles` (or
 * -1).
 */
export interface Hit { obstacle: string; index: number; pose: Pose }

/** Re-checks any path (x, y, heading, …) against a scene. `directions` defaults to forward throughout. */
export function checkPath(scene: Scenario, path: Float64Array | number[], directions?: Int8Array | number[]): PathCheck;

/** Of a path on a road, along the line of the car's middle. */
export interface RoadFigures {
  /** Metres of that line. */
  middleLength: number;
  /**
   * Of the body, pointing along that line, 5 m at the ends left out; below zero where it overlaps. The capped mean
   * counts at most 1.2 m.
   */
  bodyClearanceMin: number;
  bodyClearanceMean: number;
  bodyClearanceMeanCapped: number;
  /** Of the middle, less half the width. */
  sideClearanceMin: number;
  sideClearanceMean: number;
  /** Sum of the changes of the middle's curvature from metre to metre, and its largest, 1/m. */
  curvatureVariation: number;
  middleCurvature: number;
  /** Metres from the nearest lane's middle; null without lanes. */
  laneDeviationMax: number | null;
  laneDeviationMean: number | null;
  /** Share of the way, 0 to 1, on which the middle is to the left of all lanes. */
  laneLeftShare: number | null;
}

/** One way to drive from a pose to another with circles of one radius and straight lines, obstacles left out. */
export interface ReedsSheppCurve {
  /** Its arcs in order: L left, S straight, R right, each with + ahead or - in reverse, as in "L+S+R-". */
  word: string;
  /** Metres, reverse included. */
  length: number;
  directionChanges: number;
  /**
   * Per arc: x, y, heading at its beginning, curvature (1/m, positive to the left), signed length (negative: reverse).
   */
  arcs: [x: number, y: number, heading: number, curvature: number, length: number][];
}

/**
 * The Reeds–Shepp words between two poses for a turning radius in metres, the shortest first. Words that turn farther
 * than a shortest curve ever does are left out. `parkade` only, not `parkade/core`.
 */
export function reedsShepp(from: Pose, to: Pose, radius: number): ReedsSheppCurve[];
/** Figures of any path on a scene's road. `parkade` only, not `parkade/core`. */
export function roadFigures(scene: Scenario, plan: { path: Float64Array | number[] }): RoadFigures;
/**
 * How often a path ends in a collision when the car is beside it by chance: in each trial by 0.10 m throughout and 0.12
 * m along the way (standard deviations). Trials `from` to `from + trials` of a seed; slices add up. Defaults: 1000
 * trials from 0, seed 20260101. `discHits`: the same for a disc of the car's width. `parkade` only, not `parkade/core`.
 */
export function collisionRisk(
  scene: Scenario, plan: { path: Float64Array | number[] }, options?: { trials?: number; from?: number; seed?: number },
): { trials: number; hits: number; discHits: number };
/**
 * The band that the car's middle stays in during those drives: for each metre of the path, 5 m at the ends left out,
 * the points farthest to the left and to the right, x, y, x, y, …, metres. `parkade` only, not `parkade/core`.
 */
export function driveEnvelope(
  scene: Scenario, plan: { path: Float64Array | number[] }, options?: { trials?: number; from?: number; seed?: number },
): Float64Array;
