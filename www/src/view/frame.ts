/** The input of every layer: the canvas, the camera, the state. */
import type { Plan, PlannerId } from "parkade";
import type { PanelResult, State } from "../store";
import type { Draft } from "../store/draft";
import { isOneGoal, resolve, type Resolved } from "../scene/model";
import type { Point } from "../scene/geometry";
import { worldToScreen, type View } from "./camera";
import type { Tokens } from "./tokens";
import { newPath } from "./surface";

export type Context = CanvasRenderingContext2D;

/** One planner's answer as it is drawn. */
export interface Shown {
  planner: PlannerId;
  plan: Plan | null;
  result: PanelResult | null;
  /** An older plan that stands in for a missing one. */
  ghost: boolean;
  /** The planned path of which the plan's own was made, in pictures. */
  planned?: Float64Array;
}

export interface Frame {
  ctx: Context;
  view: View;
  /** Device pixels per CSS pixel. */
  ratio: number;
  state: State;
  tokens: Tokens;
  resolved: Resolved;
  shown: readonly Shown[];
  overlay: boolean;
  draft: Draft | null;
}

export function makeFrame(parts: Omit<Frame, "resolved" | "overlay">): Frame {
  const { scene } = parts.state,
    taken = isOneGoal(scene.goal) ? undefined : leading(parts)?.plan?.goal;
  return {
    ...parts,
    resolved: { ...resolve(scene), ...(taken && { goal: taken.pose }) },
    overlay: parts.shown.length > 1,
  };
}

/** Strength of an answer that is no longer, or not, the asked one. */
export const GHOST = 0.35;

/** The planner whose car, sweep and rasters are drawn. */
export const leading = ({ shown, state }: Pick<Frame, "shown" | "state">): Shown | undefined =>
  shown.find((one) => one.planner === state.focus) ?? shown[0];

export const leads = (frame: Frame, shown: Shown): boolean => leading(frame) === shown;

/** Units are CSS pixels, y down. */
export function inPixels({ ctx, ratio }: { ctx: Context; ratio: number }): void {
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
}

/** Units are metres, y up: the same map as `worldToScreen`. */
export function inMetres({ ctx, ratio, view }: { ctx: Context; ratio: number; view: View }): void {
  const [x, y] = worldToScreen(view, 0, 0);
  const scale = ratio * view.camera.scale;
  ctx.setTransform(scale, 0, 0, -scale, ratio * x, ratio * y);
}

/** CSS pixels as metres, for line widths drawn `inMetres`. */
export const pixels = (frame: { view: View }, px: number): number => px / frame.view.camera.scale;

export const toScreen = (frame: { view: View }, p: Point): Point => worldToScreen(frame.view, p[0], p[1]);

export function polygonPath(points: readonly Point[], path: Path2D = newPath()): Path2D {
  points.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  path.closePath();
  return path;
}

export function linePath(points: readonly Point[], path: Path2D = newPath()): Path2D {
  points.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  return path;
}
