import type { Road } from "parkade";
import { distance, towards, wrapAngle, type Point } from "./geometry";
import { halfOf } from "./road-width";
import { lastIn, nth } from "./nth";

export const RADIUS = 20;
/** The inner edge of a bend has at least this radius, metres. */
const INNER = 0.5;
/** Places on arcs are this far apart, metres. */
const STEP = 0.5;

export interface Place {
  at: Point;
  heading: number;
}

interface Bend {
  turn: number;
  radius: number;
  tangent: number;
}

/** The arcs at the inner corners. */
function bendsOf({ points, radius: wanted = RADIUS }: Road): Bend[] {
  return points.slice(1, -1).map((corner, i) => {
    const before = nth(points, i),
      after = nth(points, i + 2),
      turn = wrapAngle(towards(corner, after) - towards(before, corner));
    const half = Math.tan(Math.abs(turn) / 2);
    const room = Math.min(
      distance(before, corner) / (i === 0 ? 1 : 2),
      distance(corner, after) / (i + 3 === points.length ? 1 : 2),
    );
    const radius = Math.min(wanted, half === 0 ? Infinity : room / half);
    return { turn, radius, tangent: radius * half };
  });
}

/** The corner that a road of this width cannot turn at, or \u22121. */
export function tooTight(road: Road): number {
  const found = bendsOf(road).findIndex(({ turn, radius }) => Math.abs(turn) > 1e-9 && radius < halfOf(road) + INNER);
  return found < 0 ? -1 : found + 1;
}

/** Places along the middle line. */
export function placesOf(road: Road): Place[] {
  const { points } = road,
    places: Place[] = [{ at: nth(points, 0), heading: towards(nth(points, 0), nth(points, 1)) }];
  bendsOf(road).forEach(({ turn, radius, tangent }, i) => {
    const corner = nth(points, i + 1),
      heading = towards(nth(points, i), corner),
      side = Math.sign(turn);
    const from: Point = [corner[0] - Math.cos(heading) * tangent, corner[1] - Math.sin(heading) * tangent];
    const centre: Point = [from[0] - Math.sin(heading) * radius * side, from[1] + Math.cos(heading) * radius * side];
    const parts = Math.max(1, Math.ceil((Math.abs(turn) * radius) / STEP));
    for (let k = 0; k <= parts; k++) {
      const now = heading + (turn * k) / parts;
      places.push({
        at: [centre[0] + Math.sin(now) * radius * side, centre[1] - Math.cos(now) * radius * side],
        heading: now,
      });
    }
  });
  const last = lastIn(points);
  return [...places, { at: last, heading: towards(points.at(-2)!, last) }];
}

/** The line `left` metres to the left of these places. */
export const beside = (places: readonly Place[], left: number): Point[] =>
  places.map(({ at, heading }) => [at[0] - Math.sin(heading) * left, at[1] + Math.cos(heading) * left]);
