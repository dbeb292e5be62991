/** Selection outlines, grips and the label of the pose. */
import { isPose, type Selection } from "../../scene/selection";
import type { Pose } from "parkade";
import { findMoving, findObstacle, slotOutline } from "../../scene/model";
import { boxOf, type Box, type Point } from "../../scene/geometry";
import { cornersOf, verticesOf } from "../../scene/shapes";
import { footprint } from "../../scene/vehicle";
import { findThing, idsOf } from "../../scene/scene-objects";
import { inMetres, inPixels, leading, linePath, pixels, polygonPath, toScreen, type Frame } from "../frame";
import { cellPaths } from "../outline";
import { gripOf, noseOf } from "../pose-handle";
import { turnGripOf } from "../turn-grip";
import { drawPill, PILL_HEIGHT, pillWidth, placePill, poseText } from "../text";
import { keepPoseLabel } from "../pose-label";

const GRIP_PX = 6,
  GRIP_TOUCH_PX = 11;

const pointer = globalThis.matchMedia?.("(pointer: coarse)");
const coarse = (): boolean => pointer?.matches ?? false;

/** The pose whose grip is drawn: the selected or grabbed one; the goal's while nothing else is chosen. */
function posesWithGrip({ state, draft }: Frame): ("start" | "goal")[] {
  if (state.tool !== "select" && !draft?.grabbed) return [];
  const chosen =
    draft?.grabbed?.which ?? (isPose(state.selection) ? state.selection.kind : state.selection ? null : "goal");
  const hot = isPose(draft?.hot ?? null) ? draft?.hot?.kind : null;
  return (["start", "goal"] as const).filter((which) => which === chosen || which === hot);
}

export function drawHandles(frame: Frame): void {
  for (const which of posesWithGrip(frame)) drawGrip(frame, frame.resolved[which]);
  const {
    draft,
    state: { selection },
  } = frame;
  const labelled = draft?.grabbed?.which ?? (isPose(selection) ? selection.kind : null);
  if (labelled) drawPoseLabel(frame, labelled, draft?.grabbed !== undefined);
  else keepPoseLabel(frame.ctx.canvas, null);
}

/** The round grip ahead of the nose, on its stalk. */
function drawGrip(frame: Frame, pose: Pose): void {
  const {
    resolved: { vehicle },
  } = frame;
  drawStalk(frame, noseOf(pose, vehicle), gripOf(pose, vehicle));
}

function drawStalk(frame: Frame, from: Point, to: Point): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const a = toScreen(frame, from),
    b = toScreen(frame, to);
  inPixels(frame);
  ctx.strokeStyle = colour.accent;
  ctx.lineWidth = 1.25;
  ctx.beginPath();
  ctx.moveTo(...a);
  ctx.lineTo(...b);
  ctx.stroke();
  drawKnob(frame, b, coarse() ? GRIP_TOUCH_PX : GRIP_PX);
}

function drawKnob({ ctx, tokens: { colour } }: Frame, [x, y]: Point, radius: number): void {
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
  ctx.fillStyle = colour.floor;
  ctx.fill();
  ctx.lineWidth = 1.75;
  ctx.strokeStyle = colour.accent;
  ctx.stroke();
}

function drawPoseLabel(frame: Frame, which: "start" | "goal", editing: boolean): void {
  const { resolved } = frame;
  const pose = resolved[which];
  const boxes = (["start", "goal"] as const).map((one) => screenBox(frame, footprint(resolved[one], resolved.vehicle)));
  const grip = screenBox(frame, [gripOf(pose, resolved.vehicle)], 14);
  const own = boxes[which === "start" ? 0 : 1]!;
  const text = poseText(pose);
  const keep: Box = {
    minX: Math.min(own.minX, grip.minX),
    minY: Math.min(own.minY, grip.minY),
    maxX: Math.max(own.maxX, grip.maxX),
    maxY: Math.max(own.maxY, grip.maxY),
  };
  const parked = resolved.parked.map((car) => screenBox(frame, footprint(car.pose, car.vehicle)));
  const place = placePill(frame, text, keep, grip, [...boxes, ...parked, ...pathBoxes(frame)]);
  drawPill(frame, text, ...place, editing ? "editing" : "plain");
  keepPoseLabel(frame.ctx.canvas, which, {
    minX: place[0],
    minY: place[1],
    maxX: place[0] + pillWidth(frame, text),
    maxY: place[1] + PILL_HEIGHT,
  });
}

/** Small boxes along the shown path, which labels keep off. */
function pathBoxes(frame: Frame): Box[] {
  const path = leading(frame)?.plan?.path ?? new Float64Array();
  const boxes: Box[] = [];
  for (let i = 0; i + 2 < path.length; i += 15) boxes.push(screenBox(frame, [[path[i]!, path[i + 1]!]], 6));
  return boxes;
}

function screenBox(frame: Frame, points: readonly Point[], margin = 0): Box {
  const box = boxOf(points.map((p) => toScreen(frame, p)));
  return { minX: box.minX - margin, minY: box.minY - margin, maxX: box.maxX + margin, maxY: box.maxY + margin };
}

/** The outline of what is selected and, thinner, of what is under the pointer. */
export function drawSelection(frame: Frame): void {
  const {
    state: { selection },
    draft,
  } = frame;
  if (draft?.hot && !sameSelection(draft.hot, selection)) outlineOf(frame, draft.hot, 1.25);
  if (!selection) return;
  outlineOf(frame, selection, 2);
  if (selection.kind === "obstacle") drawShapeGrips(frame, selection.id);
  if (selection.kind === "moving" && frame.state.tool === "select") {
    inPixels(frame);
    for (const corner of findMoving(frame.state.scene, selection.id)?.points ?? [])
      drawKnob(frame, toScreen(frame, corner), 5);
  }
}

const sameSelection = (a: Selection, b: Selection): boolean =>
  a?.kind === b?.kind && idsOf(a).join() === idsOf(b).join();

/** Start and goal need no outline: their grip and label say that they are chosen. */
function outlineOf(frame: Frame, selection: NonNullable<Selection>, width: number): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  inMetres(frame);
  ctx.strokeStyle = colour.accent;
  ctx.lineWidth = pixels(frame, width);
  ctx.lineJoin = "round";
  for (const id of idsOf(selection)) {
    const path = pathOfThing(frame, id);
    if (path) ctx.stroke(path);
  }
}

function pathOfThing({ state: { scene } }: Frame, id: string): Path2D | null {
  const found = findThing(scene, id);
  if (!found) return null;
  if (found.kind === "slot") return polygonPath(slotOutline(found.thing));
  if (found.kind === "moving") return linePath(found.thing.points);
  if (found.kind === "cost") return cellPaths(found.thing.runs, scene.map).edge;
  const { thing } = found;
  if (thing.type === "cells") return cellPaths(thing.runs, scene.map).edge;
  return thing.type === "wall" || thing.type === "road" ? linePath(thing.points) : polygonPath(cornersOf(thing));
}

function drawShapeGrips(frame: Frame, id: string): void {
  const obstacle = findObstacle(frame.state.scene, id);
  if (frame.state.tool !== "select" || !obstacle || obstacle.type === "cells") return;
  const grip = turnGripOf(obstacle, frame.view);
  if (grip) drawStalk(frame, grip.from, grip.to);
  inPixels(frame);
  for (const corner of verticesOf(obstacle)) drawKnob(frame, toScreen(frame, corner), 5);
}
