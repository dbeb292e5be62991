/** Obstacles and slots. */
import type { MapFrame, Obstacle, Slot } from "parkade";
import type { Point } from "../../scene/geometry";
import { cornersOf } from "../../scene/shapes";
import { slotLines } from "../../scene/slots";
import { vehicleOf } from "../../scene/vehicle";
import { drawCar, parkedStyle } from "../car";
import { inMetres, linePath, pixels, polygonPath, type Frame } from "../frame";
import { MANY } from "../../scene/large-scene";
import { vast } from "../lazy-large-maps";
import { cellPaths, type CellPaths } from "../outline";
import { perSurface } from "../surface";

const drawn = perSurface(() => new WeakMap<Obstacle, CellPaths>());

function pathsOf(obstacle: Exclude<Obstacle, { type: "car" | "road" }>, map: MapFrame): CellPaths {
  const known = drawn().get(obstacle);
  if (known) return known;
  const made = makePaths(obstacle, map);
  drawn().set(obstacle, made);
  return made;
}

function makePaths(obstacle: Exclude<Obstacle, { type: "car" | "road" }>, map: MapFrame): CellPaths {
  if (obstacle.type !== "cells") {
    const path = obstacle.type === "wall" ? linePath(obstacle.points) : polygonPath(cornersOf(obstacle));
    return { fill: path, edge: path };
  }
  return cellPaths(obstacle.runs, map);
}

const painted = new WeakMap<readonly Slot[], [Point, Point][]>();

function linesOf(slots: readonly Slot[]): [Point, Point][] {
  const lines = painted.get(slots) ?? slotLines(slots);
  painted.set(slots, lines);
  return lines;
}

export function drawSlots(frame: Frame): void {
  const {
    ctx,
    state,
    tokens: { colour },
  } = frame;
  inMetres(frame);
  ctx.strokeStyle = colour.slot;
  ctx.lineWidth = pixels(frame, 1);
  ctx.beginPath();
  for (const [from, to] of linesOf(state.scene.slots ?? [])) {
    ctx.moveTo(...from);
    ctx.lineTo(...to);
  }
  ctx.stroke();
}

export function drawObstacles(frame: Frame): void {
  const { state, resolved } = frame;
  for (const obstacle of state.scene.obstacles ?? []) {
    if (obstacle.type === "car") drawCar(frame, obstacle.pose, vehicleOf(obstacle.vehicle), 0, parkedStyle(frame));
    else if (obstacle.type === "wall") drawWall(frame, obstacle);
    else if (obstacle.type !== "road") drawSolid(frame, obstacle);
  }
  for (const { pose, vehicle } of resolved.parked) drawCar(frame, pose, vehicle, 0, parkedStyle(frame));
}

function drawSolid(frame: Frame, obstacle: Exclude<Obstacle, { type: "car" | "road" }>): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  if (obstacle.type === "cells" && obstacle.runs.length > MANY && vast()?.drawCells(frame, obstacle)) return;
  const { fill, edge } = pathsOf(obstacle, frame.state.scene.map);
  inMetres(frame);
  ctx.fillStyle = colour.obs;
  ctx.fill(fill);
  ctx.strokeStyle = colour["obs-edge"];
  ctx.lineWidth = pixels(frame, 1.25);
  ctx.lineJoin = "round";
  ctx.lineCap = "square";
  ctx.stroke(edge);
  ctx.lineCap = "butt";
}

/** A thick wall is its edge colour with the fill inside; a thin one is a single line. */
function drawWall(frame: Frame, wall: Extract<Obstacle, { type: "wall" }>): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const { edge } = pathsOf(wall, frame.state.scene.map);
  const thick = wall.thickness ?? 0,
    line = pixels(frame, 1.25);
  inMetres(frame);
  ctx.lineCap = thick > 0 ? "butt" : "square";
  ctx.lineJoin = "miter";
  ctx.strokeStyle = colour["obs-edge"];
  ctx.lineWidth = Math.max(thick + line, pixels(frame, 3));
  ctx.stroke(edge);
  if (thick - line > pixels(frame, 1.5)) {
    ctx.lineWidth = thick - line;
    ctx.strokeStyle = colour.obs;
    ctx.stroke(edge);
  }
  ctx.lineCap = "butt";
}
