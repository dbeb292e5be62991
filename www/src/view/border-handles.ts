/** Positions of the handles of the ground's sides, for drawing and for hitting. */
import { axisOf, edgeOn, outward, SIDES, type Side } from "../scene/ground";
import { cornersOf } from "../scene/shapes";
import { resolve, type Scene } from "../scene/model";
import { boxOf, type Box, type Point } from "../scene/geometry";
import { footprint } from "../scene/vehicle";
import { worldToScreen, type View } from "./camera";
import { gripOf } from "./pose-handle";
import { nth } from "../scene/nth";

/** CSS pixels. */
export const HANDLE_PX = 10;
/** Between a handle's middle and a car or its grip, and from the view's edge. */
const CLEAR_PX = 14,
  INSET_PX = 8;
/** Off the ground, where cars leave no place on its border. */
const OFF_PX = 18;
/** Shares of a side from its middle at which a handle may stand. */
const PLACES = [0, 0.1, -0.1, 0.2, -0.2, 0.3, -0.3, 0.4, -0.4];

export interface BorderHandle {
  side: Side;
  at: Point;
}

/** In the middle of what is seen of each side that can be moved, or as near to that as no car is. */
export function handlesOn(scene: Scene, view: View): BorderHandle[] {
  const cars = carBoxes(scene, view);
  return SIDES.flatMap((side): BorderHandle[] => {
    const edge = edgeOn(scene, side);
    if (!edge) return [];
    const k = axisOf(side),
      along = 1 - k,
      [a, b] = [worldToScreen(view, ...edge[0]), worldToScreen(view, ...edge[1])];
    const size = [view.width, view.height] as const,
      low = Math.max(INSET_PX, Math.min(nth(a, along), nth(b, along))),
      high = Math.min(nth(size, along) - INSET_PX, Math.max(nth(a, along), nth(b, along)));
    if (high - low < 2 * HANDLE_PX || a[k] < 0 || a[k] > size[k]) return [];
    const place = (share: number, off: number): Point => {
      const middle = (low + high) / 2 + share * (high - low),
        beside = a[k] + (k === 0 ? off : -off) * outward(side);
      return k === 0 ? [beside, middle] : [middle, beside];
    };
    const free = [0, OFF_PX]
      .flatMap((off) => PLACES.map((share) => place(share, off)))
      .find(([x, y]) => cars.every((box) => x < box.minX || x > box.maxX || y < box.minY || y > box.maxY));
    return free ? [{ side, at: free }] : [];
  });
}

function carBoxes(scene: Scene, view: View): Box[] {
  const { start, goal, vehicle, parked } = resolve(scene);
  const outlines = [start, goal].flatMap((pose) => [footprint(pose, vehicle), [gripOf(pose, vehicle)]]);
  for (const one of scene.obstacles ?? []) if (one.type === "car") outlines.push(cornersOf(one));
  for (const one of parked) outlines.push(footprint(one.pose, one.vehicle));
  return outlines.map((points) => {
    const box = boxOf(points.map((p) => worldToScreen(view, ...p)));
    return {
      minX: box.minX - CLEAR_PX,
      minY: box.minY - CLEAR_PX,
      maxX: box.maxX + CLEAR_PX,
      maxY: box.maxY + CLEAR_PX,
    };
  });
}
