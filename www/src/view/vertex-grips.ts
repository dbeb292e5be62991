/** Corners of a selected shape that have a grip, for drawing and for hitting. */
import { boxOf, type Point } from "../scene/geometry";
import { verticesOf, type Shape } from "../scene/shapes";
import type { View } from "./camera";

/** A shape that is smaller on the screen is only moved as a whole: its grips would cover it. CSS pixels. */
const SMALLEST = 40;

export function gripVerticesOf(shape: Shape, { camera }: View): Point[] {
  const vertices = verticesOf(shape),
    { minX, minY, maxX, maxY } = boxOf(vertices);
  return Math.max(maxX - minX, maxY - minY) * camera.scale < SMALLEST ? [] : vertices;
}
