import type { Plan } from "parkade";
import { fromPose, type Point } from "../scene/geometry";
import { mapOutline, resolve, type Scene } from "../scene/model";
import { cornersOf } from "../scene/shapes";
import { slotLines } from "../scene/slots";
import { footprint } from "../scene/vehicle";
import { poseAt } from "../view/drive";
import { hullsAlong, outlineOf } from "../view/swept";
import { lastIn, nth } from "../scene/nth";

export const DRAWING_LAYERS = [
  "ground",
  "bays",
  "obstacles",
  "parked",
  "body",
  "wheels",
  "outlines",
  "path",
  "clearances",
  "dimensions",
] as const;
export type DrawingLayer = (typeof DRAWING_LAYERS)[number];

export interface DrawingLine {
  layer: DrawingLayer;
  points: Point[];
  closed: boolean;
}
/** `at`: the middle of the text. */
export interface DrawingText {
  layer: DrawingLayer;
  at: Point;
  text: string;
}
export interface SiteDrawing {
  lines: DrawingLine[];
  texts: DrawingText[];
}

export interface DrawingOptions {
  /** Metres along the path from one outline of the body to the next; 0 draws none. */
  every: number;
}

export function siteDrawing(scene: Scene, plan: Plan | null, { every }: DrawingOptions): SiteDrawing {
  const drawing: SiteDrawing = { lines: [], texts: [] };
  const line = (layer: DrawingLayer, points: readonly Point[], closed = false): void => {
    drawing.lines.push({ layer, points: [...points], closed });
  };
  line("ground", mapOutline(scene), true);
  for (const [a, b] of slotLines(scene.slots ?? [])) line("bays", [a, b]);
  drawObstacles(scene, line);
  for (const { pose, vehicle } of resolve(scene).parked) line("parked", footprint(pose, vehicle), true);
  if (plan && plan.path.length >= 6) drawManoeuvre(scene, plan, every, drawing, line);
  return drawing;
}

type Line = (layer: DrawingLayer, points: readonly Point[], closed?: boolean) => void;

function drawObstacles({ obstacles = [], map: { origin, resolution } }: Scene, line: Line): void {
  for (const obstacle of obstacles)
    if (obstacle.type === "cells")
      for (const [x, y, count] of obstacle.runs) {
        const left = origin[0] + x * resolution,
          low = origin[1] + y * resolution,
          right = left + count * resolution,
          high = low + resolution;
        line(
          "obstacles",
          [
            [left, low],
            [right, low],
            [right, high],
            [left, high],
          ],
          true,
        );
      }
    else line("obstacles", cornersOf(obstacle), obstacle.type !== "wall" && obstacle.type !== "road");
}

function drawManoeuvre(scene: Scene, plan: Plan, every: number, drawing: SiteDrawing, line: Line): void {
  const { vehicle } = resolve(scene),
    poses = Array.from({ length: plan.path.length / 3 }, (_, i) => poseAt(plan, i));
  for (const piece of joined(outlineOf(hullsAlong(plan, vehicle)))) line("body", piece);
  // The outer faces of the tyres, flush with the body's sides.
  for (const [ahead, side] of [
    [0, 1],
    [0, -1],
    [vehicle.wheelbase, 1],
    [vehicle.wheelbase, -1],
  ] as const)
    line(
      "wheels",
      poses.map((pose) => fromPose(pose, ahead, (side * vehicle.width) / 2)),
    );
  line(
    "path",
    poses.map(({ x, y }): Point => [x, y]),
  );
  for (const index of every > 0 ? markedPoses(poses, every) : []) {
    const pose = nth(poses, index),
      clearance = plan.clearances[index];
    line("outlines", footprint(pose, vehicle), true);
    if (typeof clearance === "number" && Number.isFinite(clearance))
      drawing.texts.push({
        layer: "clearances",
        at: fromPose(pose, (vehicle.rearToFront - vehicle.rearToBack) / 2, 0),
        text: clearance.toFixed(2),
      });
  }
  const narrowest = plan.check.narrowest;
  if (narrowest) {
    const { body, point } = narrowest,
      metres = Math.hypot(body[0] - point[0], body[1] - point[1]);
    line("dimensions", [body, point]);
    drawing.texts.push({
      layer: "dimensions",
      at: [(body[0] + point[0]) / 2, (body[1] + point[1]) / 2],
      text: `${metres.toFixed(2)} m`,
    });
  }
}

/** The poses nearest above each multiple of a length along the path, its ends included. */
export function markedPoses(poses: readonly { x: number; y: number }[], every: number): number[] {
  const marked = [0];
  let along = 0;
  for (let i = 1; i < poses.length; i++) {
    along += Math.hypot(nth(poses, i).x - nth(poses, i - 1).x, nth(poses, i).y - nth(poses, i - 1).y);
    if (along >= marked.length * every || i === poses.length - 1) marked.push(i);
  }
  return marked;
}

/** Pieces of an outline joined where one ends as another begins. */
function joined(pieces: readonly (readonly [Point, Point])[]): Point[][] {
  const keyOf = ([x, y]: Point): string => `${Math.round(x * 1000)} ${Math.round(y * 1000)}`,
    from = new Map<string, number[]>(),
    used = new Set<number>();
  pieces.forEach(([a], i) => from.set(keyOf(a), [...(from.get(keyOf(a)) ?? []), i]));
  return pieces.flatMap(([a, b], i) => {
    if (used.has(i)) return [];
    used.add(i);
    const points: Point[] = [a, b];
    for (;;) {
      const next = (from.get(keyOf(lastIn(points))) ?? []).find((k) => !used.has(k));
      if (next === undefined) return [points];
      used.add(next);
      points.push(nth(pieces, next)[1]);
    }
  });
}
