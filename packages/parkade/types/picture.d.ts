/** Pictures and tables of plans. */

import type { Drive, DrivenPath } from "./drive.js";
import type { Layer, LayerName, Plan } from "./plan.js";
import type { Scenario } from "./scene.js";

/** How `toSVG` draws. */
export interface PictureOptions {
  /** Pixels, 16 to 8192; default 720 × 420. */
  width?: number;
  height?: number;
  /** "auto" (default) follows the reader's system. */
  theme?: "auto" | "light" | "dark";
  /** For screen readers; the scene's name where absent. */
  title?: string;
  /**
   * Where they are given, the picture is a playground of this size with these attributes, to the pixel where its map
   * is: a poster. Others are drawn by the playground's own `toSVG`.
   */
  layout?: "single" | "overlay";
  controls?: "none" | "minimal";
  /** The visible area; by default start, goal and the cars' way. */
  camera?: Camera | null;
  /** Rasters of the plan that leads (hybrid's, or else the last): `safety` and `risk` are drawn. */
  layers?: Partial<Record<LayerName, Layer>>;
  /** Planned paths, by planner, of which trajectories took the place: x, y, heading; drawn as thin lines. */
  planned?: Readonly<Record<string, ArrayLike<number>>>;
  /** CSS colours and the font in place of the page's, by the names of its `--parkade-…` properties without that. */
  colours?: Readonly<Record<string, string>>;
}

/** The world's point in the middle of a picture (m), and pixels of a metre. */
export interface Camera {
  x: number;
  y: number;
  scale: number;
}

/**
 * A picture of a scene and its plans, drawn as the page draws it first, to the pixel; the scene itself is in the
 * picture's `metadata`. Plans with a trace show their search. `parkade` only, not `parkade/core`.
 */
export function toSVG(scene: Scenario, plans?: Plan | readonly Plan[], options?: PictureOptions): string;

/** A path with what is measured along it: a plan, or the path of a drive and its check. */
export interface MeasuredPath extends DrivenPath {
  /** Per pose; NaN or null at a corner. */
  curvatures: Float64Array | (number | null)[];
  directions: Int8Array | number[];
  clearances: Float64Array | (number | null)[];
}

/**
 * A path's poses as CSV: s,x,y,theta,kappa,clearance,v,direction,t in metres, radians, 1/m, m/s, ±1 and seconds.
 * Corners have no kappa; v and t are those of `drive`, which is by default the plan's `trajectory`, and absent where
 * this car cannot drive. `parkade` only, not `parkade/core`.
 */
export function toCSV(scene: Scenario, plan: Plan | MeasuredPath, drive?: Drive | null): string;
