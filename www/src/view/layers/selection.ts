/** The outlines of what is selected and under the pointer, and the grips of a shape. */
import type { Selection } from "../../scene/selection";
import { findMoving, findObstacle, slotOutline } from "../../scene/model";
import { cornersOf } from "../../scene/shapes";
import { findThing, idsOf } from "../../scene/scene-objects";
import { inMetres, inPixels, linePath, pixels, polygonPath, toScreen, type Frame } from "../frame";
import { cellPaths } from "../outline";
import { turnGripOf } from "../turn-grip";
import { gripVerticesOf } from "../vertex-grips";
import { drawKnob, drawStalk } from "./handles";

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
  for (const corner of gripVerticesOf(obstacle, frame.view)) drawKnob(frame, toScreen(frame, corner), 5);
}
