import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { capsuleRuns, countCells, subtractRuns, unionRuns, type Run } from "../../www/src/scene/cells";
import { decodeScene, encodeScene } from "../../www/src/scene/link";
import * as model from "../../www/src/scene/model";
import { removeObstacle, removeSlot, removeThings } from "../../www/src/scene/removal";
import { brushCells } from "../../www/src/scene/brushing";
import { flipGoal } from "../../www/src/scene/goals";
import { moveThings } from "../../www/src/scene/scene-objects";
import { turnThings } from "../../www/src/scene/turning";
import { paintCosts, reweigh, weightAt } from "../../www/src/scene/costs";
import { steerAngle } from "../../www/src/view/drive";
import { canExtend, crossesItself, type Point } from "../../www/src/scene/geometry";
import { fit, screenToWorld, worldToScreen, zoomAt } from "../../www/src/view/camera";
import type { Scenario } from "../../www/src/scene/scenario";
import { frame, scene } from "./scenes";

const cellsOf = (runs: readonly Run[]): Set<string> =>
  new Set(runs.flatMap(([x, y, count]) => Array.from({ length: count }, (_, i) => `${x + i},${y}`)));

function isConnected(cells: Set<string>): boolean {
  const [first] = cells;
  if (first === undefined) return true;
  const seen = new Set([first]),
    queue = [first];
  for (let cell = queue.pop(); cell !== undefined; cell = queue.pop()) {
    const [x, y] = cell.split(",").map(Number) as [number, number];
    for (const next of [`${x + 1},${y}`, `${x - 1},${y}`, `${x},${y + 1}`, `${x},${y - 1}`]) {
      if (cells.has(next) && !seen.has(next)) {
        seen.add(next);
        queue.push(next);
      }
    }
  }
  return seen.size === cells.size;
}

const inside = fc.tuple(fc.double({ min: -9, max: 9, noNaN: true }), fc.double({ min: -4, max: 9, noNaN: true }));

describe("brush strokes", () => {
  it("hold together along their sides, however far apart the pointer events are", () => {
    fc.assert(
      fc.property(
        fc.array(inside, { minLength: 2, maxLength: 6 }),
        fc.double({ min: 0.01, max: 2, noNaN: true }),
        (points, radius) => {
          const runs = points.slice(1).flatMap((to, i) => capsuleRuns(frame, points[i]!, to, radius));
          expect(isConnected(cellsOf(runs))).toBe(true);
        },
      ),
    );
  });

  it("cover exactly the cells whose centre is within the radius", () => {
    fc.assert(
      fc.property(inside, inside, fc.double({ min: 0.2, max: 2, noNaN: true }), (a, b, radius) => {
        const painted = cellsOf(capsuleRuns(frame, a, b, radius)),
          wrong: string[] = [];
        for (let y = 0; y < frame.height; y++) {
          for (let x = 0; x < frame.width; x++) {
            const gap = distanceTo([-10 + (x + 0.5) * 0.25, -5 + (y + 0.5) * 0.25], a, b);
            if (Math.abs(gap - radius) > 1e-6 && painted.has(`${x},${y}`) !== gap < radius) wrong.push(`${x},${y}`);
          }
        }
        expect(wrong).toEqual([]);
      }),
      { numRuns: 25 },
    );
  });

  it("spare the start and goal cars", () => {
    const painted = brushCells(scene, capsuleRuns(scene.map, [-9, 3], [9, 3], 1), "add");
    const cells = painted.obstacles!.find((o) => o.type === "cells")!;
    for (const [x, y] of [
      [-4, 3],
      [-2, 3.5],
      [0, 2.2],
    ] as Point[]) {
      const key = `${Math.floor((x + 10) / 0.25)},${Math.floor((y + 5) / 0.25)}`;
      expect(cellsOf(cells.runs).has(key)).toBe(false);
    }
    expect(countCells(cells.runs)).toBeGreaterThan(200);
  });

  it("are taken back by the same stroke of the eraser", () => {
    const stroke = capsuleRuns(frame, [-3, -2], [5, 6], 0.6),
      dot = capsuleRuns(frame, [1, 1], [1, 1], 1);
    expect(subtractRuns(unionRuns(stroke, dot), stroke)).toEqual(subtractRuns(dot, stroke));
    expect(subtractRuns(stroke, stroke)).toEqual([]);
  });
});

describe("painted cells", () => {
  const weights = (of: Scenario): Map<string, number> =>
    new Map((of.costs ?? []).flatMap(({ runs, weight }) => [...cellsOf(runs)].map((cell) => [cell, weight] as const)));

  it("have the weight of the last stroke over them, each in one area, and an area for each weight", () => {
    const stroke = fc.tuple(
      inside,
      inside,
      fc.double({ min: 0.2, max: 2, noNaN: true }),
      fc.integer({ min: 1, max: 10 }),
    );
    fc.assert(
      fc.property(fc.array(stroke, { maxLength: 8 }), (strokes) => {
        const wanted = new Map<string, number>();
        const painted = strokes.reduce((before, [from, to, radius, weight]) => {
          const runs = capsuleRuns(frame, from, to, radius);
          for (const cell of cellsOf(runs)) weight > 1 ? wanted.set(cell, weight) : wanted.delete(cell);
          return paintCosts(before, runs, weight);
        }, scene);
        expect(weights(painted)).toEqual(wanted);
        const areas = painted.costs ?? [];
        expect(areas.reduce((sum, { runs }) => sum + countCells(runs), 0)).toBe(wanted.size);
        expect(new Set(areas.map(({ weight }) => weight)).size).toBe(areas.length);
        expect(new Set(areas.map(({ id }) => id)).size).toBe(areas.length);
        expect("costs" in painted).toBe(areas.length > 0);
      }),
    );
  });

  it("change nothing twice, are told by cell, and change weight as a whole", () => {
    const runs = capsuleRuns(frame, [0, 0], [4, 0], 1),
      once = paintCosts(scene, runs, 5);
    expect(paintCosts(once, runs, 5)).toBe(once);
    expect(paintCosts(scene, runs, 1)).toBe(scene);
    expect(weightAt(once, 20 * 80 + 44)).toBe(5);
    expect(weightAt(once, 0)).toBe(1);
    const id = once.costs![0]!.id!;
    expect(reweigh(once, id, 7).costs).toEqual([{ ...once.costs![0], weight: 7 }]);
    const two = paintCosts(once, [[0, 0, 3]], 7);
    expect(reweigh(two, id, 7).costs).toHaveLength(1);
    expect(reweigh(once, id, 1).costs).toBeUndefined();
  });

  it("travel in links as they are", async () => {
    const painted = paintCosts(paintCosts(scene, capsuleRuns(frame, [0, 0], [4, 3], 1), 5), [[0, 0, 3]], 10);
    const link = await encodeScene(painted);
    expect((await decodeScene(link)).costs).toEqual(painted.costs);
    expect(link.length).toBeLessThan(1900);
  });

  it("move by whole cells and go by their ids", () => {
    const painted = paintCosts(scene, [[10, 10, 4]], 5),
      id = painted.costs![0]!.id!;
    expect(moveThings(painted, [id], 0.5, 0.25).costs![0]!.runs).toEqual([[12, 11, 4]]);
    expect(removeThings(painted, [id]).costs).toBeUndefined();
  });
});

describe("a car's front wheels", () => {
  it("point along the circle that its rear axle is on, and straight ahead at corners", () => {
    expect(Math.tan(steerAngle(0.2, 2.8))).toBeCloseTo(0.56, 12);
    expect(steerAngle(-0.2, 2.8)).toBe(-steerAngle(0.2, 2.8));
    expect(steerAngle(NaN, 2.8)).toBe(0);
  });
});

function distanceTo([x, y]: Point, [ax, ay]: Point, [bx, by]: Point): number {
  const dx = bx - ax,
    dy = by - ay,
    along = dx * dx + dy * dy;
  const t = along === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / along));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

describe("edits", () => {
  const frozen = freeze(structuredClone(scene));

  it("leave the scene they start from as it was", () => {
    const edits: ((s: Scenario) => Scenario)[] = [
      (s) => model.moveStart(s, { x: 1, y: 2, heading: 7 }),
      (s) => model.moveGoal(s, { x: 1, y: 2, heading: 3 }),
      (s) =>
        model.addObstacle(s, {
          type: "wall",
          points: [
            [0, 0],
            [1, 1],
          ],
        }).scene,
      (s) => moveThings(s, ["planter"], 1, -1),
      (s) => turnThings(s, ["rectangle-1"], 0.3),
      (s) => removeObstacle(s, "car-1"),
      (s) =>
        brushCells(
          s,
          [
            [0, 0, 80],
            [3, 1, 2],
          ],
          "add",
        ),
      (s) => brushCells(s, [[0, 50, 80]], "erase"),
      (s) => model.updateSlot(s, "slot-1", { occupied: true }),
      (s) => model.setGoalFromSlot(s, "slot-1"),
      (s) => removeSlot(s, "slot-2"),
      (s) => flipGoal(s),
    ];
    for (const edit of edits) expect(edit(frozen)).not.toBe(frozen);
    expect(frozen).toEqual(scene);
  });

  it("give the same object back where nothing changes", () => {
    expect(model.ensureIds(frozen)).toBe(frozen);
    expect(brushCells(frozen, [[41, 50, 2]], "add")).toBe(frozen);
    expect(brushCells(frozen, [[0, 0, 3]], "erase")).toBe(frozen);
  });

  it("give every object an id of its own", () => {
    const twins = model.ensureIds({
      ...scene,
      obstacles: [
        { type: "wall", id: "w", points: [] },
        { type: "wall", id: "w", points: [] },
        { type: "wall", points: [] },
      ],
    });
    expect(new Set(twins.obstacles!.map((o) => o.id)).size).toBe(3);
  });

  it("keep the goal where it was when its slot goes", () => {
    const without = removeSlot(scene, "slot-2");
    expect(model.goalPose(without)).toEqual(model.goalPose(scene));
  });
});

function freeze<T>(value: T): T {
  if (typeof value === "object" && value !== null) Object.values(Object.freeze(value)).forEach(freeze);
  return value;
}

describe("polygons", () => {
  it("that cross themselves are told from those that do not", () => {
    expect(
      crossesItself([
        [0, 0],
        [4, 0],
        [4, 4],
        [0, 4],
      ]),
    ).toBe(false);
    expect(
      crossesItself([
        [0, 0],
        [4, 4],
        [4, 0],
        [0, 4],
      ]),
    ).toBe(true);
    expect(
      crossesItself([
        [0, 0],
        [4, 0],
        [2, 0],
        [2, 4],
      ]),
    ).toBe(true);
    expect(
      crossesItself([
        [0, 0],
        [4, 0],
        [2, 0.5],
        [4, 4],
      ]),
    ).toBe(false);
  });

  it("refuse a corner whose edge would cross, and one that folds back", () => {
    expect(
      canExtend(
        [
          [0, 0],
          [4, 0],
          [4, 4],
        ],
        [2, -2],
      ),
    ).toBe(false);
    expect(
      canExtend(
        [
          [0, 0],
          [4, 0],
          [4, 4],
        ],
        [4, 2],
      ),
    ).toBe(false);
    expect(
      canExtend(
        [
          [0, 0],
          [4, 0],
          [4, 4],
        ],
        [0, 4],
      ),
    ).toBe(true);
  });
});

describe("the camera", () => {
  const view = { camera: { x: 3, y: -2, scale: 17.5 }, width: 560, height: 300 };

  it("turns pixels into metres and back", () => {
    fc.assert(
      fc.property(inside, ([x, y]) => {
        const [u, v] = worldToScreen(view, x, y);
        const [p, q] = screenToWorld(view, u, v);
        expect(p).toBeCloseTo(x, 9);
        expect(q).toBeCloseTo(y, 9);
      }),
    );
  });

  it("holds the point under the pointer while it zooms", () => {
    const before = screenToWorld(view, 100, 50);
    const after = screenToWorld({ ...view, camera: zoomAt(view, 100, 50, 1.7) }, 100, 50);
    expect(after[0]).toBeCloseTo(before[0], 9);
    expect(after[1]).toBeCloseTo(before[1], 9);
  });

  it("fits both cars into the canvas", () => {
    const camera = fit(scene, null, 560, 300);
    for (const pose of [scene.start, model.goalPose(scene)]) {
      for (const [x, y] of model.footprint(pose, model.vehicleOf("paper"))) {
        const [u, v] = worldToScreen({ camera, width: 560, height: 300 }, x, y);
        expect(u >= 0 && u <= 560 && v >= 0 && v <= 300).toBe(true);
      }
    }
  });
});
