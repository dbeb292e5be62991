import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import {
  type Run,
  type Scenario,
  Planner,
  generateScenario,
  importScene,
  init,
  packRuns,
  sceneGeometry,
  unpackRuns,
} from "parkade";
import { core } from "./core";
import { failure } from "./refused";

beforeAll(() => Promise.all([init(), core.init()]));

const MAP = "type octile\nheight 3\nwidth 4\nmap\n.@GT\nS...\nO..W\n";
const SCEN = "version 1\n0\tmaps/room.map\t4\t3\t0\t0\t2\t0\t4.0000\n";
const YAML = "image: lot.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nfree_thresh: 0.196\n";

const untyped = (value: unknown) => value as never;

function runsOf(scene: Scenario): Run[] {
  const [cells] = scene.obstacles!;
  if (cells?.type !== "cells" || typeof (cells.runs as unknown) === "string") throw new Error("no cells");
  return cells.runs;
}

describe("importScene", () => {
  test("reads a map and its questions", () => {
    const { format, scene, scenes, queries } = importScene({
      "room.map": MAP,
      "room.map.scen": new TextEncoder().encode(SCEN),
    });
    expect(format).toBe("movingai");
    expect(scenes).toEqual([scene]);
    expect(runsOf(scene)).toEqual([
      [0, 0, 1],
      [3, 0, 1],
      [1, 2, 1],
      [3, 2, 1],
    ]);
    expect(queries).toEqual([
      { bucket: 0, length: 4, start: { x: 0, y: 2, heading: 0 }, goal: { x: 2, y: 2, heading: 0 } },
    ]);
    const planner = new Planner("eight", scene);
    expect(planner.plan().metrics.lengthRaw).toBeCloseTo(queries[0]!.length, 6);
    planner.free();
  });

  test("reads a picture where its description says", () => {
    const picture = new Uint8Array([...new TextEncoder().encode("P5 3 2 255\n"), 0, 254, 254, 205, 254, 0]);
    const { format, scene, notes } = importScene({ "lot.yaml": YAML, "lot.pgm": picture.buffer }, { vehicle: "sedan" });
    expect([format, scene.map.origin, scene.vehicle]).toEqual(["ros-map", [-1, 2], "sedan"]);
    expect(notes).toEqual(["1 unknown cells count as blocked."]);
  });

  test("what is wrong is named by file and line, or by option", () => {
    expect(failure(() => importScene({ "room.map": MAP.replace("S...", "S..") }))).toEqual({
      code: "bad-import",
      path: "room.map:6",
    });
    expect(failure(() => importScene({}))).toEqual({ code: "bad-import", path: "files" });
    expect(failure(() => importScene({ "room.map": untyped(7) }))).toEqual({
      code: "bad-input",
      path: 'files["room.map"]',
    });
    expect(failure(() => importScene({ "room.map": MAP }, { resolution: -1 }))).toEqual({
      code: "bad-input",
      path: "resolution",
    });
    expect(failure(() => importScene({ "room.map": MAP }, untyped({ size: 1 })))).toEqual({
      code: "bad-input",
      path: "size",
    });
    for (const files of [undefined, null, 7, "map", [MAP]]) {
      expect(failure(() => importScene(untyped(files)))).toEqual({ code: "bad-input", path: "files" });
    }
    const junk = new Uint8Array(100_000_000).fill(46);
    expect(failure(() => importScene({ "junk.map": junk }))).toEqual({ code: "bad-import", path: "junk.map:1" });
    expect(failure(() => importScene({ "junk.map": "@".repeat(100_000_000) }))).toEqual({
      code: "bad-import",
      path: "junk.map:1",
    });
    junk[7] = junk[79_999_999] = junk[80_000_001] = 10;
    expect(failure(() => importScene({ "junk.map": junk }))).toEqual({ code: "bad-import", path: "junk.map:3" });
    expect(failure(() => importScene({ "junk.map": junk.subarray(0, 80_000_000) }))).toEqual({
      code: "bad-import",
      path: "junk.map:1",
    });
  });
});

describe("generateScenario", () => {
  interface Golden {
    family: string;
    n: number;
    seed: number;
    map_fnv1a64: string;
    params?: Record<string, number>;
  }
  const golden: Golden[] = JSON.parse(
    readFileSync(new URL("../data/grid-golden-vectors.json", import.meta.url), "utf8"),
  ).maps;

  test("draws the golden maps bit for bit", () => {
    for (const { family, n, seed, params, map_fnv1a64 } of golden) {
      const fields = {
        family,
        size: n,
        seed,
        densityPermille: params?.["density_permille"],
        blockMin: params?.["block_min"],
        blockMax: params?.["block_max"],
      };
      const scene = generateScenario(untyped(family === "random" ? fields : { family, size: n, seed }));
      let hash = 0xcbf29ce484222325n;
      const cells = new Uint8Array(n * n);
      for (const [x, y, count] of runsOf(scene)) cells.fill(1, y * n + x, y * n + x + count);
      for (const cell of cells) hash = BigInt.asUintN(64, (hash ^ BigInt(cell)) * 0x100000001b3n);
      expect(hash.toString(16).padStart(16, "0"), `${family} ${n} ${seed}`).toBe(map_fnv1a64);
    }
  });

  test("names the field that is wrong", () => {
    expect(failure(() => generateScenario(untyped({ family: "maze", size: 30, seed: 1 })))).toEqual({
      code: "bad-input",
      path: "family",
    });
    expect(failure(() => generateScenario({ family: "trap", size: 9, seed: 1 }))).toEqual({
      code: "bad-input",
      path: "size",
    });
    expect(failure(() => generateScenario({ family: "trap", size: 30, seed: 0.5 }))).toEqual({
      code: "bad-input",
      path: "seed",
    });
    expect(failure(() => generateScenario({ family: "random", size: 30, seed: 1, blockMin: 5 }))).toEqual({
      code: "bad-input",
      path: "blockMin",
    });
    expect(failure(() => generateScenario(untyped({ family: "regular", size: 30, seed: 1, blockMin: 5 })))).toEqual({
      code: "bad-input",
      path: "blockMin",
    });
    expect(failure(() => generateScenario(untyped(undefined))).code).toBe("bad-input");
  });
});

describe("packed cells", () => {
  /** Every third cell or so of a map, as runs. */
  function checkered(size: number): Run[] {
    const runs: Run[] = [];
    let state = 1;
    for (let y = 0; y < size; y++) {
      for (let x = 2; x < size - 2; x += 2 + (state >>> 30)) {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        runs.push([x, y, 1 + (state >>> 31)]);
        x += state >>> 31;
      }
    }
    return runs;
  }

  test("come back as they were, joined where they touch or overlap", () => {
    expect(packRuns([])).toBe("");
    expect(
      packRuns([
        [2, 0, 3],
        [2, 1, 40],
      ]),
    ).toBe("CD9/DoB");
    const runs = checkered(300);
    expect(unpackRuns(packRuns(runs))).toEqual(runs);
    expect(
      unpackRuns(
        packRuns([
          [5, 1, 2],
          [0, 0, 2],
          [6, 1, 4],
          [2, 0, 1],
        ]),
      ),
    ).toEqual([
      [0, 0, 3],
      [5, 1, 5],
    ]);
  });

  test("are read wherever scenes are, in both modules", () => {
    const scene = generateScenario({ family: "random", size: 60, seed: 13 });
    const packed = { ...scene, obstacles: [{ type: "cells" as const, runs: packRuns(runsOf(scene)) }] };
    const hash = (api: typeof core, scene: Scenario) => {
      const planner = new api.Planner("eight", scene);
      const { hash } = planner.plan();
      planner.free();
      return hash;
    };
    expect(hash(core, untyped(packed))).toBe(hash(core, scene));
    const broken = { ...scene, obstacles: [{ type: "cells", runs: "C-" }] };
    expect(failure(() => sceneGeometry(untyped(broken)))).toEqual({ code: "bad-scenario", path: "obstacles[0].runs" });
    const runs: unknown[] = runsOf(generateScenario({ family: "random", size: 100, seed: 1 })).slice();
    runs[300] = [1, "2", 3];
    const wrong = { ...scene, obstacles: [{ type: "cells", runs }] };
    expect(failure(() => sceneGeometry(untyped(wrong)))).toEqual({
      code: "bad-scenario",
      path: "obstacles[0].runs[300][1]",
    });
  });

  test("of large maps load quickly", () => {
    const frame = (size: number) => ({ origin: [0, 0] as [number, number], width: size, height: size, resolution: 1 });
    const ends = { start: { x: 0.5, y: 0.5, heading: 0 }, goal: { x: 1.5, y: 0.5, heading: 0 } };
    for (const size of [1024, 2048]) {
      const runs = checkered(size);
      const scene: Scenario = { version: 1, map: frame(size), obstacles: [{ type: "cells", runs }], ...ends };
      const start = performance.now();
      const planner = new Planner("eight", scene);
      const ready = performance.now();
      const plan = planner.plan();
      console.log(
        `${size}²: ${runs.length} runs ready in ${(ready - start).toFixed(0)} ms, planned in ${(
          performance.now() - ready
        ).toFixed(0)} ms`,
      );
      expect(plan.outcome).toBe("found");
      planner.free();
    }
  });
});
