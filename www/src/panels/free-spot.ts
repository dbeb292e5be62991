/** A place beside a thing that covers nothing else. */
import type { Box } from "../scene/plane";

export interface Spot { x: number; y: number; /** The point of its edge that faces the thing. */ tip: [x: number, y: number] }

/** From the edges, and between a thing and what speaks of it: a row of controls or text may be between. CSS pixels. */
const EDGE = 8, GAPS = [10, 46, 80];
/** How far along a side the box may stand from the middle, as parts of its own length. */
const SHIFTS = [0, -0.25, 0.25, -0.42, 0.42];

/** The first place at a side of `anchor` where a box of this size is inside `bounds` and meets none of `taken`; null where there is none. */
export function freeSpot(anchor: Box, { offsetWidth: width, offsetHeight: height }: { offsetWidth: number; offsetHeight: number },
  bounds: { width: number; height: number }, taken: readonly Box[]): Spot | null {
  const middleX = (anchor.minX + anchor.maxX) / 2, middleY = (anchor.minY + anchor.maxY) / 2;
  for (const [gap, shift] of GAPS.flatMap((one) => SHIFTS.map((other) => [one, other] as const))) {
    const x = middleX - width * (0.5 + shift), y = middleY - height * (0.5 + shift);
    const spots: Spot[] = [
      { x: anchor.maxX + gap, y, tip: [anchor.maxX + gap, middleY] },
      { x: anchor.minX - gap - width, y, tip: [anchor.minX - gap, middleY] },
      { x, y: anchor.minY - gap - height, tip: [middleX, anchor.minY - gap] },
      { x, y: anchor.maxY + gap, tip: [middleX, anchor.maxY + gap] },
    ];
    const free = spots.find((spot) => {
      const inside = spot.x >= EDGE && spot.y >= EDGE && spot.x + width <= bounds.width - EDGE && spot.y + height <= bounds.height - EDGE;
      return inside && !taken.some((box) => box.minX < spot.x + width && box.maxX > spot.x && box.minY < spot.y + height && box.maxY > spot.y);
    });
    if (free) return { x: Math.round(free.x), y: Math.round(free.y), tip: [Math.round(free.tip[0]), Math.round(free.tip[1])] };
  }
  return null;
}
