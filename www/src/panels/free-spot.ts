/** A place beside a thing that covers nothing else. */
import type { Box } from "../scene/plane";

export interface Spot { x: number; y: number; /** The point that faces the thing. */ tip: [x: number, y: number] }

/** Between a thing and what speaks of it, and from the edges, CSS pixels. */
const GAP = 10, EDGE = 8;
/** How far along a side the box may stand from the middle, as parts of its own length. */
const SHIFTS = [0, -0.25, 0.25, -0.42, 0.42];

/** The first place at a side of `anchor` where a box of this size is inside `bounds` and meets none of `taken`; null where there is none. */
export function freeSpot(anchor: Box, { offsetWidth: width, offsetHeight: height }: { offsetWidth: number; offsetHeight: number },
  bounds: { width: number; height: number }, taken: readonly Box[]): Spot | null {
  const middleX = (anchor.minX + anchor.maxX) / 2, middleY = (anchor.minY + anchor.maxY) / 2;
  for (const shift of SHIFTS) {
    const x = middleX - width * (0.5 + shift), y = middleY - height * (0.5 + shift);
    const spots: Spot[] = [
      { x: anchor.maxX + GAP, y, tip: [anchor.maxX + GAP, middleY] },
      { x: anchor.minX - GAP - width, y, tip: [anchor.minX - GAP, middleY] },
      { x, y: anchor.minY - GAP - height, tip: [middleX, anchor.minY - GAP] },
      { x, y: anchor.maxY + GAP, tip: [middleX, anchor.maxY + GAP] },
    ];
    const free = spots.find((spot) => {
      const inside = spot.x >= EDGE && spot.y >= EDGE && spot.x + width <= bounds.width - EDGE && spot.y + height <= bounds.height - EDGE;
      return inside && !taken.some((box) => box.minX < spot.x + width && box.maxX > spot.x && box.minY < spot.y + height && box.maxY > spot.y);
    });
    if (free) return { x: Math.round(free.x), y: Math.round(free.y), tip: [Math.round(free.tip[0]), Math.round(free.tip[1])] };
  }
  return null;
}
