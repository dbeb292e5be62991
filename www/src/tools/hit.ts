/** The thing under the pointer. */
import type { Selection } from "../scene/selection";
import type { MovingObstacle, Obstacle } from "../scene/scenario";
import { findMoving, resolve } from "../scene/model";
import { distance, distanceToPolyline, insidePolygon, type Point } from "../scene/geometry";
import { distanceToShape, rectangleCorners, vertexAt, type Shape } from "../scene/shapes";
import { footprint } from "../scene/vehicle";
import type { State } from "../store";
import { boxAt, clockOf } from "../view/playback-time";
import { gripOf } from "../view/pose-handle";
import { turnGripOf } from "../view/turn-grip";
import { gripVerticesOf } from "../view/vertex-grips";
import { metresOf, reachOf, type ToolContext, type Input } from "./tool";

export type Hit =
  | { part: "pose-grip"; which: "start" | "goal" }
  | { part: "turn-grip"; id: string }
  | { part: "vertex"; id: string; index: number }
  | { part: "way"; id: string; index: number }
  | { part: "object"; selection: NonNullable<Selection> };

/** Grips first, then vertices of the selected shape, cars, shapes from the top, slots. */
export function hitAt(context: ToolContext, input: Input, hot: Selection): Hit | null {
  const { state } = context.store;
  return (
    hitGrip(context, input, hot) ??
    hitShapeGrip(context, input) ??
    hitWay(context, input) ??
    wrap(
      hitPose(state, input.at) ?? hitMoving(context, input) ?? hitObstacle(context, input) ?? hitSlot(state, input.at),
    )
  );
}

const wrap = (selection: Selection): Hit | null => (selection ? { part: "object", selection } : null);

/** A grip answers where it is drawn: at the chosen pose, the pose under the pointer, the goal if nothing is chosen. */
function hitGrip(context: ToolContext, input: Input, hot: Selection): Hit | null {
  const { scene, selection } = context.store.state;
  const resolved = resolve(scene);
  const reach = metresOf(context, reachOf(input));
  const drawn = (which: "start" | "goal"): boolean =>
    selection?.kind === which || hot?.kind === which || (which === "goal" && selection === null);
  for (const which of ["goal", "start"] as const) {
    if (drawn(which) && distance(gripOf(resolved[which], resolved.vehicle), input.at) <= reach)
      return { part: "pose-grip", which };
  }
  return null;
}

/** The selected obstacle if it is a shape. */
export function selectedShape({ scene, selection }: State): (Shape & { id: string }) | null {
  if (selection?.kind !== "obstacle") return null;
  const found = scene.obstacles?.find((o) => o.id === selection.id);
  return found && found.type !== "cells" ? { ...found, id: selection.id } : null;
}

function hitShapeGrip(context: ToolContext, input: Input): Hit | null {
  const shape = selectedShape(context.store.state);
  if (!shape) return null;
  const reach = metresOf(context, reachOf(input));
  const grip = turnGripOf(shape, context.view);
  if (grip && distance(grip.to, input.at) <= reach) return { part: "turn-grip", id: shape.id };
  const index = vertexAt(gripVerticesOf(shape, context.view), input.at, reach * 0.75);
  return index >= 0 ? { part: "vertex", id: shape.id, index } : null;
}

/** A corner of the selected moving obstacle's way. */
function hitWay(context: ToolContext, input: Input): Hit | null {
  const { scene, selection } = context.store.state;
  if (selection?.kind !== "moving") return null;
  const index = vertexAt(
    findMoving(scene, selection.id)?.points ?? [],
    input.at,
    metresOf(context, reachOf(input)) * 0.75,
  );
  return index >= 0 ? { part: "way", id: selection.id, index } : null;
}

function hitMoving(context: ToolContext, input: Input): Selection {
  const { state } = context.store,
    slack = metresOf(context, input.touch ? 12 : 5),
    clock = clockOf(state);
  const touched = (one: MovingObstacle): boolean => {
    const { x, y, heading } = boxAt(one, clock);
    return (
      insidePolygon(input.at, rectangleCorners({ center: [x, y], size: one.size, heading })) ||
      distanceToPolyline(input.at, one.points) <= slack
    );
  };
  const id = state.scene.moving?.find(touched)?.id;
  return id === undefined ? null : { kind: "moving", id };
}

function hitPose({ scene, selection }: State, at: Point): Selection {
  const { start, goal, vehicle } = resolve(scene);
  const kinds = selection?.kind === "start" ? (["start", "goal"] as const) : (["goal", "start"] as const);
  for (const kind of kinds) if (insidePolygon(at, footprint(kind === "start" ? start : goal, vehicle))) return { kind };
  return null;
}

function hitObstacle(context: ToolContext, input: Input): Selection {
  const slack = metresOf(context, input.touch ? 12 : 4);
  const touched = (o: Obstacle): boolean => o.type !== "cells" && distanceToShape(input.at, o) <= slack;
  const all = [...(context.store.state.scene.obstacles ?? [])].reverse();
  // What stands on a road comes before it.
  const found = all.find((o) => o.type !== "road" && touched(o)) ?? all.find(touched);
  return found?.id === undefined ? null : { kind: "obstacle", id: found.id };
}

function hitSlot({ scene }: State, at: Point): Selection {
  const found = resolve(scene).slots.find((one) => insidePolygon(at, one.outline));
  return found?.slot.id === undefined ? null : { kind: "slot", id: found.slot.id };
}
