/** Two fingers: pan and zoom about their middle. */
import { distance, type Point } from "../scene/geometry";
import type { Camera } from "../store";
import { panBy, zoomAt, type View } from "../view/camera";

interface Grip {
  middle: Point;
  spread: number;
}

const gripOf = (a: Point, b: Point): Grip => ({
  middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
  spread: Math.max(8, distance(a, b)),
});

export class Pinch {
  private last: Grip;

  constructor(a: Point, b: Point) {
    this.last = gripOf(a, b);
  }

  /** The camera after the fingers moved to `a` and `b`. */
  move(view: View, a: Point, b: Point, least: number): Camera {
    const { last } = this,
      now = gripOf(a, b);
    this.last = now;
    const panned = panBy(view.camera, now.middle[0] - last.middle[0], now.middle[1] - last.middle[1]);
    return zoomAt({ ...view, camera: panned }, now.middle[0], now.middle[1], now.spread / last.spread, least);
  }
}
