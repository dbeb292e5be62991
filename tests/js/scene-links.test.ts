import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { fitsLink, forPlanners, withoutCells } from "../../www/src/scene/large-scene";
import { capsuleRuns, countCells, subtractRuns, unionRuns, type Run } from "../../www/src/scene/cells";
import { checkScene, sceneToFile } from "../../www/src/scene/files";
import { decodeScene, encodeScene } from "../../www/src/scene/link";
import * as model from "../../www/src/scene/model";
import { brushCells } from "../../www/src/scene/brushing";
import type { Point } from "../../www/src/scene/geometry";
import type { Scenario } from "../../www/src/scene/scenario";
import { scene } from "./scenes";

describe("links", () => {
  it("bring a scene back to the centimetre and a tenth of a degree, and then never change it again", async () => {
    const text = await encodeScene(scene);
    const back = await decodeScene(text);
    expect(text).toMatch(/^1[\w-]+$/);
    expect(text.length).toBeLessThan(1900);
    expect(await encodeScene(back)).toBe(text);
    expect(model.goalPose(back).x).toBeCloseTo(model.goalPose(scene).x, 2);
    expect(back.obstacles!.map((o) => o.id)).toEqual(scene.obstacles!.map((o) => o.id));
    expect(back.obstacles![0]).toEqual(scene.obstacles![0]);
    expect(back.map).toEqual(scene.map);
    expect(back.goal).toEqual(scene.goal);
  });

  it("stay short for a scene drawn by hand", async () => {
    let drawn = scene;
    for (let i = 0; i < 12; i++) {
      const at = (k: number): Point => [-9 + 1.5 * i + Math.sin(i * 7 + k), 4 + 4 * Math.cos(i * 3 + k)];
      drawn = brushCells(drawn, capsuleRuns(drawn.map, at(0), at(1), 0.5), "add");
      drawn = model.addObstacle(drawn, { type: "wall", points: [at(2), at(3), at(4)], thickness: 0.2 }).scene;
    }
    expect((await encodeScene(drawn)).length).toBeLessThan(1900);
  });

  it("that are damaged are refused in words", async () => {
    const text = await encodeScene(scene);
    await expect(decodeScene("2abc")).rejects.toThrow("version");
    await expect(decodeScene(text.slice(0, 40))).rejects.toThrow("damaged");
    await expect(decodeScene("1%%%")).rejects.toThrow("damaged");
  });
});

describe("files", () => {
  it("come back as they were", async () => {
    expect(checkScene(JSON.parse(await sceneToFile(scene).text()))).toEqual(scene);
  });

  it("that are no scene are refused in words", () => {
    expect(() => checkScene("nonsense")).toThrow("an object is expected");
    expect(() => checkScene({ version: 1 })).toThrow("no map");
    expect(() => checkScene(JSON.parse(readFileSync("package.json", "utf8")))).toThrow("version");
  });
});

describe("scenes of very many cells", () => {
  const runs = Array.from({ length: 900 }, (_, i): Run => [(i % 3) * 10, Math.floor(i / 3), 4]);

  it("change only in the rows that are touched", () => {
    const cells: Run[] = [
      [2, 100, 20],
      [5, 101, 1],
    ];
    for (const [change, small] of [
      [unionRuns(runs, cells), unionRuns],
      [subtractRuns(runs, cells), subtractRuns],
    ] as const) {
      const row = (list: readonly Run[], y: number): Run[] => list.filter((run) => run[1] === y);
      expect(row(change, 100)).toEqual(small(row(runs, 100), cells.slice(0, 1)));
      expect(change.find((run) => run[1] === 99)).toBe(runs.find((run) => run[1] === 99));
      expect(countCells(change)).toBe(runs.reduce((sum, run) => sum + run[2], 0) + (small === unionRuns ? 13 : -8));
    }
    expect(unionRuns(runs, [[0, 7, 2]])).toBe(runs);
  });

  it("go to the planners as a text made once, and are left out where nothing depends on them", () => {
    const many = Array.from({ length: 3000 }, (_, i): Run => [0, i, 1]);
    const vast = { ...scene, obstacles: [{ type: "cells" as const, id: "cells-1", runs: many }] };
    let made = 0;
    const pack = (): string => `text ${++made}`;
    expect(forPlanners(vast, pack).obstacles).toEqual([{ type: "cells", id: "cells-1", runs: "text 1" }]);
    expect(forPlanners({ ...vast, start: scene.goal as typeof scene.start }, pack).obstacles).toEqual([
      { type: "cells", id: "cells-1", runs: "text 1" },
    ]);
    expect(withoutCells(vast).obstacles).toEqual([{ type: "cells", id: "cells-1", runs: [] }]);
    expect(forPlanners(scene, pack)).toBe(scene);
    expect(fitsLink(vast)).toBe(true);
  });
});

describe("a link", () => {
  it("keeps moving obstacles, lanes and speed limits", async () => {
    const scene: Scenario = {
      version: 1,
      map: { origin: [0, 0], width: 200, height: 40, resolution: 0.5 },
      obstacles: [],
      slots: [],
      moving: [
        {
          id: "walker",
          points: [
            [1, 2],
            [30, 12.5],
          ],
          size: [0.6, 0.5],
          speed: 1.2,
          start: 2,
        },
      ],
      lanes: [
        {
          id: "road",
          start: { x: 0, y: 5, heading: 0.123456 },
          pieces: [
            { length: 60, curvature: 0 },
            { length: 30.5, curvature: -0.012345 },
          ],
          width: 3.5,
        },
      ],
      speedLimits: [
        {
          points: [
            [0, 0],
            [10, 0],
            [10, 10],
          ],
          speed: 8.33,
        },
      ],
      start: { x: 5, y: 5, heading: 0 },
      goal: { x: 90, y: 10, heading: 0 },
    };
    const back = await decodeScene(await encodeScene(scene));
    expect([back.moving, back.lanes, back.speedLimits]).toEqual([scene.moving, scene.lanes, scene.speedLimits]);
  });
});
