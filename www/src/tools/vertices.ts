/** More or fewer vertices on a selected polygon or wall. */
import { updateObstacle } from "../scene/model";
import { crossesItself, type Point } from "../scene/geometry";
import { edgeAt, vertexAt, type Shape } from "../scene/shapes";
import { selectedShape } from "./hit";
import { metresOf, type ToolContext, type Input } from "./tool";

/** On an edge of the selected polygon or wall: a new vertex; on a vertex: without it. */
export function editVertex(context: ToolContext, input: Input): void {
  const shape = selectedShape(context.store.state);
  if (!shape || !("points" in shape)) return;
  const points =
    withoutVertex(shape, input.at, metresOf(context, 10)) ?? withVertex(shape, input.at, metresOf(context, 8));
  if (points) context.commit(updateObstacle(context.store.state.scene, shape.id, { ...shape, points }), "vertex");
}

function withVertex(shape: Extract<Shape, { points: Point[] }>, at: Point, reach: number): Point[] | null {
  const index = edgeAt(shape.points, at, reach, shape.type === "polygon");
  if (index < 0) return null;
  const points = [...shape.points.slice(0, index), at, ...shape.points.slice(index)];
  if (index === 0) points.push(points.shift()!);
  return points;
}

function withoutVertex(shape: Extract<Shape, { points: Point[] }>, at: Point, reach: number): Point[] | null {
  const index = vertexAt(shape.points, at, reach),
    least = shape.type === "polygon" ? 3 : 2;
  const points = shape.points.filter((_, i) => i !== index);
  return index < 0 || points.length < least || (shape.type === "polygon" && crossesItself(points)) ? null : points;
}
