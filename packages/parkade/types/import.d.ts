/** Scenes from elsewhere: files of other programs, grids, map messages, and seeded families. */

import type { Goal, GoalSet, Pose, Scenario, VehicleSpec } from "./scene.js";

/** `parkade` only, not `parkade/core`: what `importScene` is asked. */
export interface ImportOptions {
  /** Side of a cell, metres, of maps that do not say; default 1. */
  resolution?: number;
  /** Which of the queries gives the scene's start and goal; default 0. */
  query?: number;
  /** Treatment of cells that are neither free nor occupied; default "blocked". */
  unknown?: "blocked" | "free";
  /** Default: a cart 0.8 cells wide for maps of cells, "paper" for maps in metres. */
  vehicle?: VehicleSpec;
}

/** A question that comes with a map. */
export interface ImportedQuery {
  /** Its group of about equal length. */
  bucket: number;
  /** Centre of the cell; the heading points to the goal. */
  start: Pose;
  goal: Pose;
  /** Length of the shortest eight-connected path that touches no corner of a blocked cell, metres. */
  length: number;
}

export interface Imported {
  format: "movingai" | "ros-map" | "tpcap" | "lots" | "scene";
  /** The first of `scenes`. */
  scene: Scenario;
  scenes: Scenario[];
  queries: ImportedQuery[];
  /** Remarks about how the file was read. */
  notes: string[];
}

/**
 * Detects the format from the file name: MovingAI `.map` with or without its `.scen`, ROS `.yaml` with its `.pgm`,
 * TPCAP `.csv`, lots and scenes as `.json`. Throws ParkadeError "bad-import" with `path` "file:line". `parkade` only,
 * not `parkade/core`.
 */
export function importScene(
  files: Record<string, string | Uint8Array | ArrayBuffer>, options?: ImportOptions,
): Imported;

/** What a grid of cells does not say. */
export interface OccupancyOptions extends Omit<Partial<Scenario>, "version" | "map" | "costs"> {
  start: Pose;
  goal: Goal | GoalSet;
  /** Side of a cell, metres. */
  resolution: number;
  /** Lower left corner of the map, metres; default [0, 0]. */
  origin?: [number, number];
  /**
   * "bottom-up" (default): the first row is the southernmost one, as in ROS. "top-down": the northernmost one, as in
   * pictures.
   */
  rows?: "bottom-up" | "top-down";
  /** Cells of at least this value are blocked; default 1. Negative values, and what is no number, are unknown. */
  occupied?: number;
  /** Treatment of unknown cells; default "blocked". */
  unknown?: "blocked" | "free";
  /**
   * What a metre costs in each cell, in metres: whole numbers from 1 to 10, in the order of the cells. For planners
   * with `takesCosts`.
   */
  costs?: ArrayLike<number>;
}

/**
 * A scene of a grid: one value per cell, row by row from west to east, `width` cells a row. Other fields of a scene
 * (`vehicle`, `slots`, …) may be given with the options; `obstacles` come on top of the grid. Throws ParkadeError
 * "bad-input". `parkade` only, not `parkade/core`.
 */
export function fromOccupancy(cells: ArrayLike<number | boolean>, width: number, options: OccupancyOptions): Scenario;

/** The part of ROS's nav_msgs/OccupancyGrid that a scene is made of. */
export interface OccupancyGrid {
  info: {
    resolution: number;
    width: number;
    height: number;
    origin: {
      position: { x: number; y: number; z?: number };
      orientation?: { x?: number; y?: number; z?: number; w?: number };
    };
  };
  /** Chance of being occupied in percent, -1 for unknown. */
  data: ArrayLike<number>;
}

/**
 * A scene of a ROS map message, in the map's frame. `occupied` is 65 by default. A map that is rotated is refused.
 * `parkade` only, not `parkade/core`.
 */
export function fromOccupancyGrid(
  message: OccupancyGrid,
  options: Omit<OccupancyOptions, "resolution" | "origin">,
): Scenario;

/** A seeded map; the same arguments give the same map everywhere. */
export type Family =
  | {
      family: "random";
      /** Cells a side, 5 to 4096. */
      size: number;
      seed: number;
      /** Share of blocked cells, thousandths; default 150. */
      densityPermille?: number;
      /** Sides of the blocks, cells; default 1 to 3. */
      blockMin?: number;
      blockMax?: number;
    }
  | { family: "regular" | "trap"; size: number; seed: number };

/** Draws a map of a family, one metre a cell, from corner to corner. `parkade` only, not `parkade/core`. */
export function generateScenario(family: Family): Scenario<Goal>;
