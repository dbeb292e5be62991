/** The car as a drawing: body, glass, mirrors, wheels turned by the steering angle. */
import type { Pose, Vehicle } from "parkade";
import { inMetres, pixels, type Frame } from "./frame";
import { fade, mix } from "./tokens";
import { newPath, perSurface } from "./surface";

interface Parts {
  body: Path2D;
  glass: Path2D;
  lines: Path2D;
  mirrors: Path2D;
  bumper: Path2D;
}

const parts = perSurface(() => new Map<string, Parts>());

/** Outlines in the car's frame: x ahead of the rear axle, y to the left. */
function partsOf(v: Vehicle): Parts {
  const key = `${v.rearToFront},${v.rearToBack},${v.width},${v.wheelbase}`;
  const known = parts().get(key);
  if (known) return known;
  const made = makeParts(v);
  if (parts().size > 64) parts().clear();
  parts().set(key, made);
  return made;
}

function makeParts(v: Vehicle): Parts {
  const back = -v.rearToBack,
    length = v.rearToFront + v.rearToBack,
    half = v.width / 2;
  const at = (share: number): number => back + share * length;
  return {
    body: bodyPath(back, v.rearToFront, half),
    glass: glassPath(at, half),
    lines: linesPath(at, half),
    mirrors: mirrorPath(at(0.66), half),
    bumper: bumperPath(v.rearToFront, half),
  };
}

/** A little rounder at the nose than at the tail, so that the drawing fills its collision box but shows its front. */
function bodyPath(back: number, front: number, half: number): Path2D {
  const nose = Math.min(0.62, half * 0.6),
    tail = Math.min(0.4, half * 0.4);
  const path = newPath();
  path.moveTo(back + tail, -half);
  path.lineTo(front - nose * 1.15, -half);
  path.bezierCurveTo(front - nose * 0.35, -half, front, -half + nose * 0.45, front, -half + nose);
  path.lineTo(front, half - nose);
  path.bezierCurveTo(front, half - nose * 0.45, front - nose * 0.35, half, front - nose * 1.15, half);
  path.lineTo(back + tail, half);
  path.quadraticCurveTo(back, half, back, half - tail);
  path.lineTo(back, -half + tail);
  path.quadraticCurveTo(back, -half, back + tail, -half);
  path.closePath();
  return path;
}

function glassPath(at: (share: number) => number, half: number): Path2D {
  const path = newPath();
  pane(path, at(0.6), at(0.715), half * 0.68, half * 0.82, at(0.03) - at(0));
  pane(path, at(0.2), at(0.115), half * 0.68, half * 0.78, at(0) - at(0.018));
  return path;
}

/** A window across the car: `x0` at the roof, `x1` at the bonnet or boot, bowed outward. */
function pane(path: Path2D, x0: number, x1: number, half0: number, half1: number, bow: number): void {
  path.moveTo(x0, -half0);
  path.quadraticCurveTo(x0 + bow, 0, x0, half0);
  path.lineTo(x1, half1);
  path.quadraticCurveTo(x1 + bow, 0, x1, -half1);
  path.closePath();
}

/** Side windows and the roof's edges. */
function linesPath(at: (share: number) => number, half: number): Path2D {
  const path = newPath();
  for (const side of [-1, 1]) {
    path.moveTo(at(0.2), side * half * 0.7);
    path.lineTo(at(0.6), side * half * 0.7);
    path.moveTo(at(0.78), side * half * 0.62);
    path.lineTo(at(0.95), side * half * 0.5);
  }
  return path;
}

function mirrorPath(x: number, half: number): Path2D {
  const path = newPath();
  for (const side of [-1, 1]) path.roundRect(x - 0.1, side > 0 ? half - 0.05 : -half - 0.15, 0.15, 0.2, 0.06);
  return path;
}

/** The lamps: short strokes at the corners of the nose. */
function bumperPath(front: number, half: number): Path2D {
  const path = newPath();
  for (const side of [-1, 1]) {
    path.moveTo(front - 0.12, side * half * 0.62);
    path.quadraticCurveTo(front - 0.16, side * half * 0.86, front - 0.42, side * half * 0.9);
  }
  return path;
}

export interface CarStyle {
  fill: string;
  edge: string;
  edgeWidth: number;
  glass: string;
  wheels: string | null;
  axle: string | null;
  dash?: readonly number[];
}

const WHEEL = { length: 0.74, width: 0.27 };

/** Draws a car; leaves the transform in the car's frame to its callers' care. */
export function drawCar(frame: Frame, pose: Pose, vehicle: Vehicle, steer: number, style: CarStyle): void {
  const { ctx } = frame;
  const shape = partsOf(vehicle);
  ctx.save();
  inMetres(frame);
  ctx.translate(pose.x, pose.y);
  ctx.rotate(pose.heading);
  ctx.lineJoin = "round";
  ctx.lineCap = "butt";
  ctx.fillStyle = style.edge;
  if (style.wheels) ctx.fill(shape.mirrors);
  ctx.fillStyle = style.fill;
  ctx.fill(shape.body);
  ctx.fillStyle = style.glass;
  ctx.fill(shape.glass);
  drawTrim(frame, shape, style);
  ctx.strokeStyle = style.edge;
  ctx.lineWidth = pixels(frame, style.edgeWidth);
  ctx.setLineDash((style.dash ?? []).map((px) => pixels(frame, px)));
  ctx.stroke(shape.body);
  ctx.setLineDash([]);
  if (style.wheels) drawWheels(frame, vehicle, steer, style.wheels);
  if (style.axle) drawAxle(frame, vehicle, style);
  ctx.restore();
}

function drawTrim(frame: Frame, shape: Parts, style: CarStyle): void {
  const { ctx } = frame;
  ctx.strokeStyle = style.edge;
  ctx.lineWidth = pixels(frame, 0.9);
  ctx.globalAlpha *= 0.75;
  ctx.stroke(shape.glass);
  if (frame.view.camera.scale > 9) {
    ctx.globalAlpha *= 0.6;
    ctx.stroke(shape.lines);
    ctx.stroke(shape.bumper);
    ctx.globalAlpha /= 0.6;
  }
  ctx.globalAlpha /= 0.75;
}

function drawWheels({ ctx }: Frame, vehicle: Vehicle, steer: number, colour: string): void {
  const inset = vehicle.width / 2 - WHEEL.width * 0.62;
  ctx.fillStyle = colour;
  for (const [x, angle] of [
    [0, 0],
    [vehicle.wheelbase, steer],
  ] as const) {
    for (const side of [-1, 1]) {
      ctx.save();
      ctx.translate(x, side * inset);
      ctx.rotate(angle);
      ctx.beginPath();
      ctx.roundRect(-WHEEL.length / 2, -WHEEL.width / 2, WHEEL.length, WHEEL.width, 0.07);
      ctx.fill();
      ctx.restore();
    }
  }
}

/** The rear axle and the reference point every pose speaks of. */
function drawAxle(frame: Frame, vehicle: Vehicle, style: CarStyle): void {
  const { ctx } = frame;
  ctx.strokeStyle = style.edge;
  ctx.lineWidth = pixels(frame, 1);
  ctx.beginPath();
  ctx.moveTo(0, -vehicle.width / 2 + 0.3);
  ctx.lineTo(0, vehicle.width / 2 - 0.3);
  ctx.stroke();
  drawDot(frame, [0, 0], style.edge);
}

function drawDot(frame: Frame, [x, y]: readonly [number, number], edge: string): void {
  const { ctx } = frame;
  ctx.beginPath();
  ctx.arc(x, y, pixels(frame, 3), 0, 2 * Math.PI);
  ctx.fillStyle = frame.tokens.colour.floor;
  ctx.fill();
  ctx.lineWidth = pixels(frame, 1.5);
  ctx.strokeStyle = edge;
  ctx.stroke();
}

/** The reference points of start and goal, on top of the paths that begin and end there. */
export function drawReferences(frame: Frame): void {
  inMetres(frame);
  for (const { x, y } of [frame.resolved.start, frame.resolved.goal]) drawDot(frame, [x, y], frame.tokens.colour.t1);
}

export const startStyle = ({ tokens: { colour } }: Frame): CarStyle => ({
  fill: fade(colour.floor, 0.8),
  edge: colour.t1,
  edgeWidth: 1.5,
  glass: fade(colour.t1, 0.06),
  wheels: fade(colour.t1, 0.9),
  axle: colour.t1,
});

export const goalStyle = (frame: Frame): CarStyle => ({
  ...startStyle(frame),
  fill: fade(frame.tokens.colour.floor, 0.55),
  glass: fade(frame.tokens.colour.t1, 0.04),
  wheels: null,
  dash: [5, 3.5],
});

export const parkedStyle = ({ tokens: { colour } }: Frame): CarStyle => ({
  fill: colour.parked,
  edge: colour["obs-edge"],
  edgeWidth: 1,
  glass: fade(colour["obs-edge"], 0.5),
  wheels: null,
  axle: null,
});

export const drivingStyle = ({ tokens: { colour } }: Frame, planner: string): CarStyle => ({
  fill: mix(planner, colour.floor, 0.26),
  edge: mix(planner, colour.t1, 0.78),
  edgeWidth: 1.5,
  glass: fade(mix(planner, colour.t1, 0.6), 0.85),
  wheels: colour.t1,
  axle: mix(planner, colour.t1, 0.78),
});
