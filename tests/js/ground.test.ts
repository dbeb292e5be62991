import { thingsOf } from "../../www/src/scene/selection";
import { init, sceneGeometry, scenario, scenarios, type Obstacle } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";
import {
  axisOf,
  coordinateOf,
  edgeOn,
  groundOf,
  LEAST,
  MOST_CELLS,
  moveSide,
  outward,
  roomOf,
  SIDES,
  sizeAlong,
  type Side,
} from "../../www/src/scene/ground";
import { pack, unpack } from "../../www/src/scene/link-codec";
import { ensureIds, mapOutline, resolve, type Scene } from "../../www/src/scene/model";
import { boxOf, type Point } from "../../www/src/scene/geometry";
import { outlineOfThing } from "../../www/src/scene/scene-objects";
import { footprint } from "../../www/src/scene/vehicle";
import type { Scenario } from "../../www/src/scene/scenario";

beforeAll(() => init());

const LOT: Scenario = {
  version: 1,
  map: { origin: [-1, 2], width: 60, height: 40, resolution: 0.5 },
  vehicle: "sedan",
  start: { x: 4, y: 6, heading: 0 },
  goal: { x: 20, y: 14, heading: 0 },
  slots: [],
  costs: [{ id: "cost-1", weight: 4, runs: [[5, 30, 6]] }],
  obstacles: [
    {
      type: "cells",
      id: "cells-1",
      runs: [
        [2, 3, 4],
        [50, 30, 5],
      ],
    },
    {
      type: "wall",
      id: "wall-1",
      points: [
        [10, 4],
        [26, 4],
      ],
      thickness: 0.4,
    },
    { type: "rectangle", id: "planter", center: [8, 18], size: [3, 2], heading: 0.4 },
  ],
};

/** Middles of painted cells in the world, in order. */
function painted({ map: { origin, resolution }, obstacles = [], costs = [] }: Scene): string[] {
  return [...obstacles, ...costs].flatMap((one) =>
    ("runs" in one ? one.runs : []).flatMap(([x, y, count]) =>
      Array.from({ length: count }, (_, i) =>
        [origin[0] + (x + i + 0.5) * resolution, origin[1] + (y + 0.5) * resolution]
          .map((value) => value.toFixed(6))
          .join(),
      ),
    ),
  );
}

const plain = (obstacles: readonly Obstacle[] = []): Obstacle[] => obstacles.filter((one) => one.type !== "cells");

/** What a moved side must leave as it was. */
function expectKept(before: Scene, after: Scene): void {
  expect(painted(after)).toEqual(painted(before));
  expect(plain(after.obstacles)).toEqual(plain(before.obstacles));
  for (const key of ["slots", "moving", "start", "goal", "vehicle", "lanes", "planners"] as const)
    expect(after[key], key).toEqual(before[key]);
  const cells = (value: number, k: 0 | 1): number => (value - before.map.origin[k]) / before.map.resolution;
  for (const k of [0, 1] as const)
    expect(Math.abs(cells(after.map.origin[k], k) - Math.round(cells(after.map.origin[k], k)))).toBeLessThan(1e-6);
  const { map } = after;
  for (const one of [...(after.obstacles ?? []), ...(after.costs ?? [])]) {
    for (const [x, y, count] of "runs" in one ? one.runs : [])
      expect(x >= 0 && y >= 0 && x + count <= map.width && y < map.height).toBe(true);
  }
  expect(() => sceneGeometry(after)).not.toThrow();
}

/** Ids of what is not wholly on the ground; poses are "start" and "goal". */
function outside(scene: Scene): string[] {
  const box = groundOf(scene),
    { start, goal, vehicle } = resolve(scene);
  const isOn = (points: readonly Point[]): boolean =>
    points.every(([x, y]) => x > box.minX - 1e-3 && x < box.maxX + 1e-3 && y > box.minY - 1e-3 && y < box.maxY + 1e-3);
  const all: [string, readonly Point[]][] = [
    ["start", footprint(start, vehicle)],
    ["goal", footprint(goal, vehicle)],
    ...thingsOf(scene).map((one): [string, Point[]] => [one.id!, outlineOfThing(scene, one.id!)]),
  ];
  return all.filter(([, points]) => !isOn(points)).map(([id]) => id);
}

describe("a side of the ground", () => {
  it.each(SIDES)("moves outward, and the cells stay where they are: %s", (side) => {
    const at = coordinateOf(groundOf(LOT), side) + outward(side) * 3.3,
      next = moveSide(LOT, side, at);
    expect(coordinateOf(groundOf(next), side)).toBeCloseTo(at, 9);
    expectKept(LOT, next);
    // Half a cell too much is the map's, not the ground's.
    expect(next.map.boundary).toHaveLength(4);
    expect([next.map.width, next.map.height][axisOf(side)]).toBe([60, 40][axisOf(side)]! + 7);
    expect(moveSide(next, side, coordinateOf(groundOf(LOT), side)).map).toEqual(LOT.map);
  });

  it.each([
    ["right", "cells-1", 26.5],
    ["left", "cells-1", 0],
    ["bottom", "cells-1", 3.5],
    ["top", "planter", 19.505],
  ] as [Side, string, number][])("stops at what stands in its way: %s", (side, id, at) => {
    const { inner } = roomOf(LOT, side);
    expect(inner.id).toBe(id);
    expect(inner.at).toBeCloseTo(at, 2);
    const next = moveSide(LOT, side, inner.at);
    expect(outside(next)).toEqual([]);
    expectKept(LOT, next);
  });

  it("keeps a metre of ground, and no more cells than a map can have", () => {
    const bare: Scene = {
      ...LOT,
      obstacles: [],
      costs: [],
      start: { x: 200, y: 0, heading: 0 },
      goal: { x: 200, y: 0, heading: 0 },
    };
    expect(roomOf(bare, "right").inner).toEqual({ at: -1 + LEAST, id: null });
    const next = moveSide(bare, "right", roomOf(bare, "right").outer);
    expect(next.map.width).toBe(MOST_CELLS);
    expectKept(bare, next);
  });

  it("leaves what lies across the border on it, and what lies beyond it alone", () => {
    const scene: Scene = {
      ...LOT,
      costs: [],
      obstacles: [
        {
          type: "wall",
          id: "wall-1",
          points: [
            [22, 10],
            [40, 10],
          ],
        },
        { type: "rectangle", id: "rectangle-1", center: [45, 10], size: [2, 2] },
      ],
      goal: { x: 15, y: 14, heading: 0 },
    };
    expect(roomOf(scene, "right").inner).toEqual({ at: 22, id: "wall-1" });
  });

  it("is in a link where it is on the page, whatever the cells' size", () => {
    for (const resolution of [0.5, 0.125, 0.3, 1 / 3]) {
      const scene: Scene = {
        ...LOT,
        costs: [],
        obstacles: [],
        map: { ...LOT.map, resolution, width: Math.round(40 / resolution), height: Math.round(25 / resolution) },
      };
      for (const side of SIDES) {
        const next = moveSide(scene, side, coordinateOf(groundOf(scene), side) + outward(side) * 3 * resolution),
          wider = moveSide(
            next,
            side === "top" ? "bottom" : "top",
            coordinateOf(groundOf(next), side === "top" ? "bottom" : "top") + 0.37,
          );
        for (const one of [next, wider]) {
          const { map } = unpack(JSON.parse(JSON.stringify(pack(one))) as Record<string, unknown>, ensureIds);
          expect(map.origin).toEqual(one.map.origin.map((value) => expect.closeTo(value, 6) as number));
          expect({ width: map.width, height: map.height, resolution: map.resolution }).toEqual({
            width: one.map.width,
            height: one.map.height,
            resolution,
          });
          expect(() => sceneGeometry({ ...one, map })).not.toThrow();
        }
      }
    }
  });

  it("of any preset moves to any place in its room and back, and nothing is lost", () => {
    let moved = 0;
    for (const { id } of scenarios()) {
      const scene = ensureIds(scenario(id)),
        off = outside(scene);
      for (const side of SIDES.filter((one) => edgeOn(scene, one))) {
        const now = coordinateOf(groundOf(scene), side),
          { inner, outer } = roomOf(scene, side),
          sign = outward(side);
        expect(sign * inner.at <= sign * now + 1e-9, `${id} ${side}`).toBe(true);
        for (const at of [inner.at, now + (inner.at - now) * 0.37, now + sign * Math.min(7.77, sign * (outer - now))]) {
          const next = moveSide(scene, side, at),
            back = moveSide(next, side, now);
          expectKept(scene, next);
          expect(
            outside(next).filter((one) => !off.includes(one)),
            `${id} ${side} ${at}`,
          ).toEqual([]);
          expect(sizeAlong(groundOf(next), axisOf(side))).toBeCloseTo(
            sizeAlong(groundOf(scene), axisOf(side)) + sign * (at - now),
            6,
          );
          const [a, b] = [boxOf(mapOutline(back)), boxOf(mapOutline(scene))];
          for (const key of ["minX", "minY", "maxX", "maxY"] as const) expect(a[key]).toBeCloseTo(b[key], 6);
          expect(painted(back)).toEqual(painted(scene));
          moved++;
        }
      }
    }
    expect(moved).toBeGreaterThan(200);
  }, 60_000);
});
