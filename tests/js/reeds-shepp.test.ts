import fc from "fast-check";
import { init, ParkadeError, reedsShepp, type Pose } from "parkade";
import { beforeAll, expect, test } from "vitest";

beforeAll(() => init());

/** Where a pose comes to along an arc, by the formulas of a circle. */
function driven([x, y, heading, curvature, length]: readonly [number, number, number, number, number]): Pose {
  const turned = heading + curvature * length;
  if (curvature === 0) return { x: x + length * Math.cos(heading), y: y + length * Math.sin(heading), heading };
  return {
    x: x + (Math.sin(turned) - Math.sin(heading)) / curvature,
    y: y - (Math.cos(turned) - Math.cos(heading)) / curvature,
    heading: turned,
  };
}

const pose = fc.record({
  x: fc.double({ min: -50, max: 50, noNaN: true }),
  y: fc.double({ min: -50, max: 50, noNaN: true }),
  heading: fc.double({ min: -4, max: 4, noNaN: true }),
});

test("every curve leads from the first pose to the second, by circles of the radius, and the list is sorted", () => {
  fc.assert(
    fc.property(pose, pose, fc.double({ min: 1, max: 12, noNaN: true }), (from, to, radius) => {
      const curves = reedsShepp(from, to, radius);
      expect(curves.length).toBeGreaterThan(0);
      curves.forEach(({ word, length, directionChanges, arcs }, i) => {
        const letters = arcs.map(
          ([, , , curvature, along]) => "RSL"[Math.sign(curvature) + 1]! + (along < 0 ? "-" : "+"),
        );
        expect(word).toBe(letters.join(""));
        const gears = letters.map((one) => one[1]);
        expect(directionChanges).toBe(gears.filter((gear, k) => k > 0 && gear !== gears[k - 1]).length);
        expect(arcs.reduce((sum, [, , , , along]) => sum + Math.abs(along), 0)).toBeCloseTo(length, 6);
        for (const [, , , curvature] of arcs)
          if (curvature !== 0) expect(Math.abs(curvature)).toBeCloseTo(1 / radius, 9);
        const end = arcs.length > 0 ? driven(arcs.at(-1)!) : from;
        expect(Math.hypot(end.x - to.x, end.y - to.y)).toBeLessThan(1e-6);
        expect(Math.cos(end.heading - to.heading)).toBeGreaterThan(1 - 1e-9);
        if (i > 0) expect(length).toBeGreaterThanOrEqual(curves[i - 1]!.length);
      });
    }),
    { seed: 26, numRuns: 300 },
  );
});

test("a straight way is one straight line", () => {
  const [shortest] = reedsShepp({ x: 0, y: 0, heading: 0 }, { x: 10, y: 0, heading: 0 }, 5);
  expect(shortest!.word).toBe("S+");
  expect(shortest!.length).toBeCloseTo(10, 9);
});

test("what breaks a rule is named", () => {
  const at = { x: 0, y: 0, heading: 0 };
  const named = (...args: unknown[]): string => {
    try {
      reedsShepp(...(args as Parameters<typeof reedsShepp>));
    } catch (error) {
      if (error instanceof ParkadeError) return `${error.code} ${error.message}`;
    }
    return "nothing";
  };
  expect(named(at, at, 0)).toMatch(/^bad-input radius: .*0 to 100000 metres/);
  expect(named(at, at, Number.NaN)).toMatch(/^bad-input radius/);
  expect(named({ ...at, y: Number.POSITIVE_INFINITY }, at, 5)).toMatch(/^bad-input from\.y/);
  expect(named(at, { x: 1, y: 2 }, 5)).toMatch(/^bad-input to\.heading/);
  expect(named(at, null, 5)).toMatch(/^bad-input to/);
});
