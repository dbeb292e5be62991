/** Driving in time: trajectories, the simulated car, moving obstacles, the referee. */

import type { Check } from "./check.js";
import type { Pose, Scenario } from "./scene.js";

/** A path to drive: a plan, or its columns alone. */
export interface DrivenPath {
  /** x, y, heading, … */
  path: Float64Array | number[];
  /** Gear (±1) of the way on from each pose; forward where absent. */
  directions?: Int8Array | number[];
  /** Curvature of the way on from each pose, 1/m, NaN or null at a corner; from the poses where absent. */
  curvatures?: Float64Array | (number | null)[];
}

/** Limits of a trajectory. */
export interface Limits {
  /**
   * "limited" (default): from rest to rest within all limits. "constant": `speed` throughout, as in the parking paper.
   */
  profile?: "limited" | "constant";
  /** m/s; default 2. The scene's `speedLimits` hold as well. */
  speed?: number;
  /** m/s²; default 1. */
  acceleration?: number;
  /** m/s²; default 1.5. */
  deceleration?: number;
  /** v²·|κ|, m/s²; default 1.5. */
  lateralAcceleration?: number;
  /** m/s³; none where absent. */
  jerk?: number | null;
  /** Speed at the beginning, m/s; default 0. */
  startSpeed?: number;
  /** Speed at the end, m/s; default 0. */
  goalSpeed?: number;
  /**
   * Where the curvature steps, which the wheel cannot. "preview" (default): the speed is kept and the wheel begins to
   * turn before the step. "slow": 0.5 m/s near steps, and everywhere slow enough for the wheel.
   */
  steps?: "preview" | "slow";
  /** True if the wheel turns at standstill at the start and at gear changes; default true. */
  dwell?: boolean;
  /** Most time between two rows, seconds; default 0.05. */
  dt?: number;
}

/** Columns with one item per moment; times increase strictly. */
export interface Drive {
  /** Seconds. */
  t: Float64Array;
  /** x, y, heading, … per moment. */
  path: Float64Array;
  /** Distance driven, metres. */
  stations: Float64Array;
  /** m/s, negative in reverse. */
  speeds: Float64Array;
  /** Of `speeds` from here on, m/s². */
  accelerations: Float64Array;
  /** Angle of the middle front wheel, radians, positive to the left. */
  steering: Float64Array;
  /** The same in every browser and in Node. */
  hash: string;
}

export interface Trajectory extends Drive {
  /** Seconds. */
  duration: number;
  /** Metres. */
  length: number;
  /** Seconds at standstill to turn the wheel. */
  dwell: number;
  maxLateralAcceleration: number;
}

/** Limits and options of `optimise`. */
export interface OptimiseOptions extends MotionLimits {
  /** Metres kept from obstacles where the plan keeps as much; default 0.05. */
  margin?: number;
}

/**
 * A trajectory that a car can follow to the centimetre: at rest with a straight wheel at both ends, speed and steering
 * angle linear between rows, which are at most 0.05 s apart; headings do not jump by 2π.
 */
export interface OptimisedTrajectory extends Trajectory {
  /** From each row on, rad/s. */
  steeringRates: Float64Array;
  /**
   * The stage that made it: the optimised path, or the plan's own path, where the wheel turns on the way at each step
   * of the curvature, or at a standstill.
   */
  stage: "optimised" | "continuous-curvature" | "stop-and-steer";
  /** The referee's verdict. */
  check: Judgement;
}

/** How closely a simulated car followed. */
export interface Tracking {
  t: Float64Array;
  /** Poses of the simulated car: x, y, heading, … */
  path: Float64Array;
  /** Metres to the left of the path. */
  lateral: Float64Array;
  /** Radians. */
  steering: Float64Array;
  /** Metres. */
  maxLateral: number;
  /** Radians. */
  maxHeading: number;
  /** Metres and radians between the last pose and the path's. */
  endDistance: number;
  endHeading: number;
  /** The first obstacle that the body overlapped. */
  hit: Check["firstHit"];
  /** At most 0.10 m to the side, 0.10 m and 0.05 rad off at the end, no hit. */
  passes: boolean;
  hash: string;
}

export interface WaitOptions {
  /**
   * "predictive" (default): stops before a hit to come, where it is safe to stand. "reactive", the parking paper's:
   * stops while an obstacle is on the way ahead or, with a trajectory, while a moving one is nearer to it than the car
   * needs to brake. It can be in a box's way, and `contact` tells so.
   */
  rule?: "predictive" | "reactive";
  /** How far ahead "reactive" looks: to the end (default), or a stopping distance. */
  scope?: "remaining" | "window";
  /** Along a plan, m/s; default 2. A trajectory has its own speeds. */
  speed?: number;
  /** For a plan's window, m/s²; default 1.5. Along a trajectory the car brakes as hard as that does itself. */
  deceleration?: number;
  /** Metres kept when it decides to stop, default 0.3, and when it decides to go on, default 0.5. */
  margin?: number;
  releaseMargin?: number;
  /** Seconds after which the drive is given up; default 600. */
  maxTime?: number;
  /** Seconds between two decisions; default 0.05. */
  dt?: number;
}

/** A drive among a scene's moving obstacles, checked by outlines. */
export interface Encounter extends Drive {
  /** "unavoidable": there was no place to stand safely. "blocked": an obstacle stays on the path for ever. */
  ending: "arrived" | "unavoidable" | "hit" | "blocked" | "out-of-time";
  /** Per moment: metres from the body to the nearest box; Infinity where there is none. */
  clearances: Float64Array;
  /**
   * Per moment: seconds until the body would touch a moving box if both kept their velocity; Infinity where they never
   * would.
   */
  timesToCollision: Float64Array;
  /** Per moment, per moving obstacle: x, y, heading of the box. */
  boxes: Float64Array;
  waits: { pose: Pose; station: number; from: number; to: number }[];
  /** The first overlap: whose, its index in `moving`, when, where the car was and whether it stood. */
  contact: { obstacle: string; index: number; t: number; pose: Pose; standing: boolean } | null;
  /** Seconds, with and without waiting. */
  duration: number;
  freeDuration: number;
}

/** Limits of a car in motion; the steering angle's limit is the car's own. */
export interface MotionLimits {
  /** m/s in either gear; default 2.5. */
  speed?: number;
  /** m/s²; default 1. */
  acceleration?: number;
  /** m/s²; default 1. */
  deceleration?: number;
  /** rad/s; default 0.5, and never more than the car's own `maxSteerRate`. */
  steeringRate?: number;
  /** v²·|κ|, m/s²; none where absent. */
  lateralAcceleration?: number | null;
}

/**
 * What the referee takes. With `t` (seconds, increasing from 0) a trajectory; without, a path, which is given times run
 * by run and driven by a simulated car.
 */
export interface JudgedTrajectory {
  /** x, y, heading, … */
  path: Float64Array | number[];
  t?: Float64Array | number[];
  /** m/s, negative in reverse; from the poses where absent. */
  speeds?: Float64Array | number[];
  /** Radians, positive to the left; from the poses where absent. */
  steering?: Float64Array | number[];
  /** Of a path without times: gear (±1) of the way on from each pose; from the poses where absent. */
  directions?: Int8Array | number[];
}

/** The referee's verdict on a trajectory, by the protocol of the public benchmarks. */
export interface Judgement {
  /** Attained, no touching frame, all between frames certified, limits kept. */
  passes: boolean;
  /**
   * It begins at the scene's start, ends at rest within 1 cm in x and in y and 1° of the goal, and its poses are those
   * of a car with these speeds and steering angles, to 1 cm and 0.5°.
   */
  attained: boolean;
  /** Speed, acceleration, steering angle and steering rate, to 0.1 %. */
  keepsLimits: boolean;
  /** Moments at which the whole body was held against the obstacles: every millisecond, every row and the end. */
  frames: number;
  /** Those at which it overlaps something, and moments between two of them where an overlap was found. */
  touchingFrames: number;
  /** Stretches between two frames that are neither certified as free nor known to touch. */
  uncertified: number;
  firstContact: { obstacle: string; index: number; pose: Pose; t: number } | null;
  /** The least clearance that was measured, metres. */
  minClearance: number;
  /** Seconds. */
  duration: number;
  /** Metres driven. */
  length: number;
  /** ∫ a² + v²·ω² dt. */
  effort: number;
  /** ∫ φ² dt. */
  steeringEffort: number;
  /** Sign changes of the speed beyond 0.01 m/s. */
  gearChanges: number;
  /** 10 · effort + 10 · steeringEffort + 5 · gearChanges. */
  smoothness: number;
  /** smoothness + 100 · duration. */
  tpcapCost: number;
  /** m/s, m/s², m/s², rad, rad/s, m/s². */
  maxSpeed: number;
  maxAcceleration: number;
  maxDeceleration: number;
  maxSteering: number;
  maxSteeringRate: number;
  maxLateralAcceleration: number;
  /** Of the first pose from the scene's start: metres, radians. */
  startError: { distance: number; heading: number };
  /** Of the last pose from the goal: metres, radians. */
  endError: { x: number; y: number; heading: number };
  /** m/s. */
  endSpeed: number;
  /** Of the poses from a replay of speeds and steering angles, at most: metres, radians. */
  modelError: { distance: number; heading: number };
}

/** Gives a path times. Throws ParkadeError for paths that this car cannot drive. `parkade` only, not `parkade/core`. */
export function trajectory(scene: Scenario, plan: DrivenPath, limits?: Limits): Trajectory;
/**
 * Makes a trajectory of a plan that passes its check, from its first pose to its last: the path may change its shape,
 * and gear changes their places. `parkade` only, not `parkade/core`.
 */
export function optimise(scene: Scenario, plan: DrivenPath, options?: OptimiseOptions): OptimisedTrajectory;
/** A drive as CSV, as `judge` reads it: t,x,y,theta,v,phi,a,omega. `parkade` only, not `parkade/core`. */
export function toTrajectoryCSV(drive: Drive | OptimisedTrajectory): string;
/**
 * Lets a simulated car follow a path, or an optimised trajectory at its own speeds. `parkade` only, not `parkade/core`.
 */
export function track(
  scene: Scenario, plan: DrivenPath, options?: Limits & { controller?: "feedback" | "pure-pursuit" | "stanley" },
): Tracking;
/**
 * Judges a trajectory or a path: columns, or CSV with a header (`t,x,y,theta[,v,phi[,a,omega]]` or `x,y,theta[,gear]`;
 * seconds, metres, radians). Throws ParkadeError, with `path` the line and column of CSV. `parkade` only, not
 * `parkade/core`.
 */
export function judge(scene: Scenario, trajectory: JudgedTrajectory | string, limits?: MotionLimits): Judgement;
/**
 * Waits for the scene's moving obstacles along a path, at constant speed as in the parking paper, or along an optimised
 * trajectory, within its limits. `parkade` only, not `parkade/core`.
 */
export function stopWaitGo(scene: Scenario, plan: DrivenPath | OptimisedTrajectory, options?: WaitOptions): Encounter;
