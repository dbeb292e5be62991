import { fileURLToPath } from "node:url";
import { beforeAll, describe, expect, test } from "vitest";
import * as parkade from "parkade";
import {
  type PlannerId,
  type Scenario,
  ParkadeError,
  Planner,
  checkPath,
  defaultConfig,
  init,
  scenario,
  scenarios,
} from "parkade";
import { declared } from "./declared.mjs";

/** The ParkadeError that `run` throws, in parts. */
function failure(run: () => unknown) {
  try {
    run();
  } catch (error) {
    expect(error).toBeInstanceOf(ParkadeError);
    const { code, path, message, name } = error as ParkadeError;
    expect(name).toBe("ParkadeError");
    expect(message).not.toBe("");
    return { code, path };
  }
  throw new Error("nothing was thrown");
}

/** What callers without types may hand over. */
const untyped = (value: unknown) => value as never;

const preset = () => scenario(scenarios()[0]!.id);

test("before init every call says so, and a failed init can be repeated", async () => {
  expect(failure(() => parkade.version())).toEqual({ code: "not-initialised", path: "" });
  expect(failure(() => new Planner("hybrid", untyped({})))).toEqual({ code: "not-initialised", path: "" });
  await expect(init({ wasm: new Uint8Array([1, 2, 3]) })).rejects.toMatchObject({ code: "bad-input", path: "wasm" });
  await expect(init({ wasm: "no/such/file.wasm" })).rejects.toBeInstanceOf(ParkadeError);
  await init();
  expect(parkade.version()).toMatch(/^\d+\.\d+\.\d+/);
});

describe("after init", () => {
  beforeAll(() => init());

  test("init is idempotent, and concurrent calls share one load", async () => {
    const first = init();
    expect(init()).toBe(first);
    await first;
  });

  test("another module than the loaded one is refused, the same one is not", async () => {
    await expect(init({ wasm: "bogus" })).rejects.toMatchObject({
      name: "ParkadeError",
      code: "bad-input",
      path: "wasm",
      message: expect.stringContaining('must be as in the first `init`, got "bogus"'),
    });
    await expect(init()).resolves.toBeUndefined();
    const compiled = await WebAssembly.compile(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]));
    await expect(init({ wasm: structuredClone(compiled) })).resolves.toBeUndefined();
    expect(parkade.version()).toMatch(/^\d/);
  });

  test("plans may end in any slot of the scene, as the scene itself may", () => {
    const scene = scenario("perpendicular"),
      goal = { slot: "slot-1", entry: "reverse-in" } as const;
    using planner = new Planner("eight", scene);
    using other = new Planner("eight", { ...scene, goal });
    expect(planner.plan({ goal }).hash).toBe(other.plan().hash);
    expect(planner.plan({ goal }).hash).not.toBe(planner.plan().hash);
    expect(planner.plan({ start: goal }).path.slice(0, 2)).toEqual(other.plan().path.slice(-3, -1));
    expect(failure(() => planner.plan({ goal: { slot: "nowhere", entry: "head-in" } }))).toEqual({
      code: "bad-input",
      path: "goal.slot",
    });
    expect(failure(() => planner.plan({ goal: untyped({ slot: "slot-1", entry: "sideways" }) }))).toEqual({
      code: "bad-input",
      path: "goal.entry",
    });
    expect(failure(() => planner.plan({ goal: untyped({ x: 1, y: 2 }) }))).toEqual({
      code: "bad-input",
      path: "goal.heading",
    });
  });

  test("the types declare what the package exports", () => {
    const { values } = declared(fileURLToPath(new URL("../../pkg/index.d.ts", import.meta.url)));
    expect(Object.keys(parkade).sort()).toEqual(values.sort());
  });

  test("planners and scenarios answer by the ids that they list", () => {
    for (const { id } of parkade.planners()) expect(defaultConfig(id)).toBeTypeOf("object");
    for (const { id } of scenarios()) expect(scenario(id).version).toBe(1);
  });

  test("unknown names are errors with a code", () => {
    expect(failure(() => defaultConfig(untyped("teleport"))).code).toBe("unknown-planner");
    expect(failure(() => new Planner(untyped("teleport"), preset())).code).toBe("unknown-planner");
    expect(failure(() => scenario("nowhere")).code).toBe("unknown-scenario");
  });

  test("values of the wrong kind are errors, never traps", () => {
    for (const value of [undefined, null, 7, {}, [], Symbol("id")]) {
      expect(failure(() => scenario(untyped(value)))).toEqual({ code: "bad-input", path: "id" });
      expect(failure(() => new Planner(untyped(value), preset())).code).toBe("bad-input");
    }
    for (const value of [undefined, null, 7, "scene", []]) {
      expect(failure(() => new Planner("hybrid", untyped(value))).code).toBe("bad-scenario");
    }
  });

  test("a mistake in the settings is named by its field", () => {
    expect(failure(() => new Planner("hybrid", preset(), untyped({ noSuchSetting: 1 }))).code).toBe("bad-config");
    const scene = { ...preset(), start: { x: untyped("left"), y: 0, heading: 0 } };
    expect(failure(() => new Planner("hybrid", scene))).toEqual({ code: "bad-scenario", path: "start.x" });
  });

  test("a planner plans as often as asked, with the same answer", () => {
    const planner = new Planner("eight", preset());
    const first = planner.plan();
    expect(first.path).toBeInstanceOf(Float64Array);
    expect(first.directions).toBeInstanceOf(Int8Array);
    expect(planner.plan({ trace: true }).hash).toBe(first.hash);
    planner.free();
  });

  test("expansions are told while they are made: together they are the trace", () => {
    using grid = new Planner("eight", scenario("random-60"));
    const cells: number[] = [];
    const plan = grid.plan({
      onExpanded: (events) => {
        expect([events.kind, events.search]).toEqual(["cells", 0]);
        if (events.kind === "cells") cells.push(...events.cells);
      },
    });
    expect(cells).toEqual([...(plan.trace as { cells: Uint32Array }).cells]);
    expect(plan.hash).toBe(grid.plan().hash);
    using car = new Planner("hybrid", scenario("L2"));
    const arcs: number[][] = [];
    const { trace } = car.plan({
      onExpanded: (events) => {
        arcs[events.search] ??= [];
        if (events.kind === "arcs") arcs[events.search]!.push(...events.arcs);
      },
    });
    expect(arcs.at(-1)).toEqual([...(trace as { arcs: Float64Array }).arcs]);
    expect(() =>
      car.plan({
        onExpanded: () => {
          throw new RangeError("enough");
        },
      }),
    ).toThrow(new RangeError("enough"));
  });

  test("a traced search shows its tree and the connections that failed", () => {
    const scene = scenario("L2");
    using planner = new Planner("hybrid", scene);
    const { trace, hash, stats, obstruction } = planner.plan({ trace: true });
    expect(obstruction).toBeNull();
    expect(hash).toBe(planner.plan().hash);
    if (trace?.kind !== "arcs") throw new Error("no tree");
    expect(trace.arcs.length).toBeGreaterThan(500);
    expect(trace.arcs.length).toBeLessThanOrEqual(5 * stats.expanded);
    const { first, hits, obstacles, expansions, arcs, dropped } = trace.failedExpansions;
    expect(first.length).toBeGreaterThan(20);
    expect([hits.length, obstacles.length, expansions.length, arcs.length % 5, dropped]).toEqual([
      3 * first.length,
      first.length,
      first.length,
      0,
      0,
    ]);
    expect(Math.max(...obstacles)).toBeLessThan(scene.obstacles?.length ?? 0);
  });

  test("a failure has a place", () => {
    const hall: Scenario = {
      version: 1,
      map: { origin: [0, 0], width: 40, height: 20, resolution: 1 },
      vehicle: "sedan",
      start: { x: 5, y: 10, heading: 0 },
      goal: { x: 32, y: 10, heading: 0 },
    };
    const wall = (y1: number, y2: number) => ({
      type: "wall" as const,
      points: [
        [22, y1],
        [22, y2],
      ] as [number, number][],
    });
    const ask = (obstacles: Scenario["obstacles"], planner: PlannerId = "hybrid") => {
      using session = new Planner(planner, { ...hall, obstacles: obstacles! });
      return session.plan().obstruction;
    };
    expect(ask([])).toBeNull();
    const enclosed = ask([wall(0, 20)]);
    if (enclosed?.kind !== "enclosed") throw new Error(enclosed?.kind);
    expect(enclosed.end).toBe("goal");
    for (const [x, y, count] of enclosed.runs) {
      expect(x).toBeGreaterThan(22);
      expect(x + count * enclosed.cell).toBeLessThan(40);
      expect(y).toBeGreaterThan(0);
    }
    const gap = ask([wall(0, 9.2), wall(10.8, 20)]);
    if (gap?.kind !== "gap") throw new Error(gap?.kind);
    expect(gap.needed).toBe(1.9);
    expect([gap.width, gap.x, gap.y].map(Math.round)).toEqual([2, 22, 10]);
    expect(ask([wall(0, 4), { type: "car", pose: hall.start }])).toEqual({
      kind: "contact",
      end: "start",
      hit: { obstacle: "parked car", index: 1, pose: hall.start },
    });
    expect(ask([wall(0, 20)], "eight")).toMatchObject({ kind: "nearest", heading: null });
  });

  test("checkPath takes typed and plain arrays alike", () => {
    const scene = preset();
    const planner = new Planner("hybrid", scene);
    const { path, directions, check, clearances } = planner.plan();
    planner.free();
    expect(checkPath(scene, path, directions)).toEqual({ ...check, clearances });
    expect(checkPath(scene, [...path], [...directions])).toEqual({ ...check, clearances });
  });

  test("checkPath refuses what is no list of numbers", () => {
    const scene = preset();
    const path = [scene.start.x, scene.start.y, scene.start.heading];
    expect(failure(() => checkPath(scene, untyped("path")))).toEqual({ code: "bad-input", path: "path" });
    expect(failure(() => checkPath(scene, untyped([1, "2", 3])))).toEqual({ code: "bad-input", path: "path[1]" });
    expect(failure(() => checkPath(scene, path, [257]))).toEqual({ code: "bad-input", path: "directions[0]" });
    expect(failure(() => checkPath(scene, [1, 2])).code).toBe("bad-input");
    expect(failure(() => checkPath(scene, [1, Number.NaN, 0])).code).toBe("bad-input");
  });

  test("a freed planner says so, and freeing it again does nothing", () => {
    const planner = new Planner("eight", preset());
    planner.free();
    planner.free();
    expect(failure(() => planner.plan())).toEqual({ code: "freed", path: "" });
    expect(failure(() => planner.layer("occupancy"))).toEqual({ code: "freed", path: "" });
  });

  test("`using` frees a planner", () => {
    const planner = new Planner("eight", preset());
    planner[Symbol.dispose]();
    expect(failure(() => planner.plan()).code).toBe("freed");
  });
});
