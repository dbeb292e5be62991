/** Things turned together. */
import { updateMoving, updateObstacle, updateSlot, type Scene } from "./model";
import { boxOf, rotateAbout, wrapAngle, type Point } from "./geometry";
import { cornersOf, moveShape, turnShape } from "./shapes";
import { boxOfThings, findThing } from "./scene-objects";

/** Turns all of them about the middle of their extent; brushed cells stay. */
export function turnThings(scene: Scene, ids: readonly string[], angle: number): Scene {
  const box = boxOfThings(scene, ids),
    about: Point = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2];
  return ids.reduce((next, id) => {
    const found = findThing(next, id);
    if (found?.kind === "slot") {
      const [x, y] = rotateAbout([found.thing.x, found.thing.y], about, angle);
      return updateSlot(next, id, { x, y, heading: wrapAngle(found.thing.heading + angle) });
    }
    if (found?.kind === "moving")
      return updateMoving(next, id, { points: found.thing.points.map((p) => rotateAbout(p, about, angle)) });
    if (found?.kind !== "obstacle" || found.thing.type === "cells") return next;
    const turned = turnShape(found.thing, angle),
      from = middleOf(cornersOf(turned)),
      [x, y] = rotateAbout(middleOf(cornersOf(found.thing)), about, angle);
    return updateObstacle(next, id, moveShape(turned, x - from[0], y - from[1]));
  }, scene);
}

function middleOf(points: readonly Point[]): Point {
  const { minX, maxX, minY, maxY } = boxOf(points);
  return [(minX + maxX) / 2, (minY + maxY) / 2];
}
