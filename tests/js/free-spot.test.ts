import { describe, expect, it } from "vitest";
import type { Box } from "../../www/src/scene/geometry";
import { freeSpot } from "../../www/src/panels/free-spot";

const anchor: Box = { minX: 400, maxX: 428, minY: 300, maxY: 328 },
  bubble = { offsetWidth: 160, offsetHeight: 32 },
  bounds = { width: 900, height: 700 };
/** What lies around the thing, so that the bubble has to stand off. */
const ring = (by: number): Box[] => [
  { minX: anchor.minX - by, maxX: anchor.maxX + by, minY: anchor.minY - by, maxY: anchor.minY - 1 },
  { minX: anchor.minX - by, maxX: anchor.maxX + by, minY: anchor.maxY + 1, maxY: anchor.maxY + by },
  { minX: anchor.minX - by, maxX: anchor.minX - 1, minY: anchor.minY - by, maxY: anchor.maxY + by },
  { minX: anchor.maxX + 1, maxX: anchor.maxX + by, minY: anchor.minY - by, maxY: anchor.maxY + by },
];

describe("a hint's arrow", () => {
  for (const [taken, gap] of [
    [[], 10],
    [ring(40), 46],
    [ring(75), 80],
  ] as const) {
    it(`reaches from the bubble to the thing, ${gap} px away`, () => {
      const {
        x,
        y,
        tip: [tipX, tipY],
        to: [toX, toY],
      } = freeSpot(anchor, bubble, bounds, taken)!;
      expect(Math.hypot(tipX - toX, tipY - toY)).toBe(gap);
      expect(tipX === toX || tipY === toY).toBe(true);
      expect([anchor.minX, anchor.maxX].includes(toX) || [anchor.minY, anchor.maxY].includes(toY)).toBe(true);
      expect(toX >= anchor.minX && toX <= anchor.maxX && toY >= anchor.minY && toY <= anchor.maxY).toBe(true);
      expect(tipX >= x && tipX <= x + bubble.offsetWidth && tipY >= y && tipY <= y + bubble.offsetHeight).toBe(true);
    });
  }
});
