import fc from "fast-check";
import { expect, test } from "vitest";
import * as parkade from "parkade";
import {
  ParkadeError,
  Planner,
  defaultConfig,
  init,
  planners,
  scenario,
  scenarios,
  sceneGeometry,
  type Scenario,
} from "parkade";

/**
 * More of it, with another seed, `-t toSVG` for one function: `PARKADE_FUZZ=100000:7 vitest run tests/js/fuzz.test.ts`.
 */
const [times = "300", seed = "20260101"] = (process.env["PARKADE_FUZZ"] ?? "").split(":").filter(Boolean);
const HOURS = 36_000_000;
/** Nothing smaller is looked for: after a trap the module answers nothing. */
const options = { numRuns: Number(times), seed: Number(seed), endOnFailure: true };

/** Errors that callers can cause; "internal" is none of them. */
const CODES = [
  "bad-config",
  "bad-scenario",
  "bad-vehicle",
  "bad-input",
  "bad-import",
  "unknown-planner",
  "unknown-scenario",
  "not-drivable",
  "freed",
];

/** An answer, or a ParkadeError that says whose fault it is. */
function answersOrExplains(run: () => unknown) {
  try {
    run();
  } catch (error) {
    expect(error).toBeInstanceOf(ParkadeError);
    const { code, message } = error as ParkadeError;
    expect(CODES, message).toContain(code);
    expect(message).not.toBe("");
  }
  expect(Object.keys(Object.prototype)).toEqual([]);
}

const untyped = (value: unknown) => value as never;

const number = fc.oneof(
  fc.double({ min: -100, max: 100 }),
  fc.constantFrom(0, -0, 1e-300, 1e9, 1e300, -1, 2 ** 31, 2 ** 53, Infinity, -Infinity, NaN),
);
const POLLUTING = JSON.parse('{"__proto__":{"polluted":1},"constructor":{"prototype":{"polluted":1}}}') as unknown;
const value = fc.oneof(
  number,
  fc.constantFrom(
    null,
    undefined,
    true,
    "",
    "hybrid",
    10n,
    () => 0,
    [],
    {},
    POLLUTING,
    { toString: 1, valueOf: 1 },
    Object.create(null),
  ),
  fc.anything(),
);

/** A copy of `whole` with one of its fields, at any depth, replaced. */
function damaged<T extends object>(whole: T, choices: number[], by: unknown): T {
  const copy = structuredClone(whole);
  let at = copy as Record<string, unknown>;
  for (const [depth, choice] of choices.entries()) {
    const keys = Object.keys(at);
    const key = keys[choice % keys.length];
    if (key === undefined) break;
    const inner = at[key];
    if (typeof inner !== "object" || inner === null || ArrayBuffer.isView(inner) || depth === choices.length - 1) {
      at[key] = by;
      break;
    }
    at = inner as Record<string, unknown>;
  }
  return copy;
}

const choices = fc.array(fc.nat(50), { minLength: 1, maxLength: 5 });

/** The smallest preset: fuzzing is about the border, not about long searches. */
function smallest(): Scenario {
  const cells = ({ map }: Scenario) => map.width * map.height;
  return scenarios()
    .map(({ id }) => scenario(id))
    .reduce((best, other) => (cells(other) < cells(best) ? other : best));
}

await init();
const small = smallest();

test(
  "any value for a scene, and a preset with one damaged field, is geometry or an explained error",
  () => {
    const scenes = scenarios().map(({ id }) => scenario(id));
    const scene = fc.oneof(
      value,
      fc.tuple(fc.constantFrom(...scenes), choices, value).map(([whole, path, by]) => damaged(whole, path, by)),
    );
    fc.assert(
      fc.property(scene, (any) => answersOrExplains(() => sceneGeometry(untyped(any)))),
      options,
    );
  },
  HOURS,
);

test(
  "settings with one damaged field prepare a planner or are explained",
  () => {
    const ids = planners().map(({ id }) => id);
    fc.assert(
      fc.property(fc.constantFrom(...ids), choices, value, (id, path, by) =>
        answersOrExplains(() => new Planner(id, small, untyped(damaged(defaultConfig(id), path, by))).free()),
      ),
      options,
    );
  },
  HOURS,
);

/** Every function that takes something, with arguments that it accepts. */
function calls(): [name: string, run: (...args: never[]) => unknown, args: unknown[]][] {
  const plan = new Planner("hybrid", small).plan(),
    road = scenario("road-narrow");
  const four = new Planner("four", small),
    risk = new Planner("risk-field", small);
  const cells = Array.from({ length: 300 }, (_, i) => [2 * (i % 20), Math.floor(i / 20), 1]);
  const files = {
    "a.map": "type octile\nheight 2\nwidth 2\nmap\n..\n..\n",
    "a.map.scen": "version 1\n0\ta.map\t2\t2\t0\t0\t1\t1\t1.41\n",
  };
  const rows = Object.fromEntries(parkade.paperGridRows().rows.map(({ id }) => [id, new Float64Array(12)]));
  // The start is blocked, so an audit takes no time.
  const [x, y] = [small.start.x, small.start.y],
    lot: Scenario = {
      ...small,
      slots: [{ id: "a", kind: "perpendicular", x, y, heading: 0, width: 3, length: 6 }],
      obstacles: [{ type: "rectangle", center: [x, y], size: [2, 2], heading: 0 }],
    };
  const pose = { x: 0.5, y: 0.5, heading: 0 },
    grid = { resolution: 1, start: pose, goal: pose, rows: "top-down" as const, costs: [1, 1, 1, 1, 1, 2] },
    info = { resolution: 1, width: 2, height: 1, origin: { position: { x: 0, y: 0 }, orientation: { w: 1 } } },
    message = { info, data: [0, 100] };
  return [
    ["defaultConfig", defaultConfig, ["hybrid"]],
    ["scenario", scenario, [small.name]],
    ["checkPath", parkade.checkPath, [small, [...plan.path], [...plan.directions]]],
    ["sceneGeometry of many cells", sceneGeometry, [{ ...small, obstacles: [{ type: "cells", runs: cells }] }]],
    ["packRuns", parkade.packRuns, [cells]],
    ["unpackRuns", parkade.unpackRuns, ["AABB"]],
    ["importScene", parkade.importScene, [files, {}]],
    [
      "generateScenario",
      parkade.generateScenario,
      [{ family: "random", size: 15, seed: 1, densityPermille: 150, blockMin: 1, blockMax: 3 }],
    ],
    ["paperGrid", parkade.paperGrid, [{ row: "regular-20", from: 1, to: 1 }]],
    ["paperGridSummary", parkade.paperGridSummary, [rows]],
    ["paperRoad", parkade.paperRoad, [{ row: "none", rounds: 1 }]],
    ["paperParking", parkade.paperParking, [{ row: "none", rounds: 1 }]],
    ["paperVerdicts", parkade.paperVerdicts, [{ parking: [], road: [] }]],
    ["paperIncomplete", parkade.paperIncomplete, [{ row: "none", from: 1, to: 1 }]],
    ["paperVolumes", parkade.paperVolumes, [{ scene: "none", poses: 10, seed: 1, rounds: 1 }]],
    ["audit", parkade.audit, [lot, { vehicles: ["compact"], entries: ["head-in"] }]],
    ["affectedRows", parkade.affectedRows, [lot, { ...lot, obstacles: [] }, parkade.audit(lot), {}]],
    ["generateLot", parkade.generateLot, [{ seed: 1, rows: 1, bays: 4 }]],
    ["fromOccupancy", parkade.fromOccupancy, [[0, 1, 0, 0, 0, 0], 3, grid]],
    ["fromOccupancyGrid", parkade.fromOccupancyGrid, [message, { start: grid.start, goal: grid.goal }]],
    ["reedsShepp", parkade.reedsShepp, [{ x: 0, y: 0, heading: 0 }, { x: 5, y: 3, heading: 1 }, 4]],
    ["roadFigures", parkade.roadFigures, [road, { path: [0, 0, 0, 1, 0, 0] }]],
    ["driveEnvelope", parkade.driveEnvelope, [small, { path: [...plan.path] }, { trials: 2, from: 0, seed: 1 }]],
    ["collisionRisk", parkade.collisionRisk, [small, { path: [...plan.path] }, { trials: 2, from: 0, seed: 1 }]],
    ["toSVG", parkade.toSVG, [small, plan, { width: 100, height: 100, theme: "dark", title: "t" }]],
    ["toCSV", parkade.toCSV, [small, plan]],
    ["toCSV of a drive", parkade.toCSV, [small, plan, { t: [0, 1], stations: [0, 9], speeds: [0, 0] }]],
    ["trajectory", parkade.trajectory, [small, plan, { maxSpeed: 2 }]],
    ["track", parkade.track, [small, plan, { controller: "stanley" }]],
    ["stopWaitGo", parkade.stopWaitGo, [small, plan, {}]],
    ["optimise", parkade.optimise, [small, plan, { margin: 0.1, speed: 2 }]],
    [
      "judge",
      parkade.judge,
      [small, { path: [...plan.path], t: [...plan.path.keys()].slice(0, plan.path.length / 3) }, { speed: 2 }],
    ],
    ["judge of text", parkade.judge, [small, "t,x,y,theta\n0,1,2,3\n1,2,2,3\n", {}]],
    [
      "toTrajectoryCSV",
      parkade.toTrajectoryCSV,
      [
        {
          t: [0, 1],
          path: [0, 0, 0, 1, 0, 0],
          speeds: [0, 0],
          steering: [0, 0],
          accelerations: [0, 0],
          steeringRates: [0, 0],
        },
      ],
    ],
    [
      "Planner",
      (...args) => new Planner(...(args as unknown as ConstructorParameters<typeof Planner>)).free(),
      ["eight", small, {}],
    ],
    ["plan", (given) => four.plan(given), [{ trace: true, start: small.start, goal: small.goal }]],
    ["search", (from, to) => four.search(from, to), [small.start, small.goal]],
    ["brush", (runs, blocked) => four.brush(runs, blocked), [[[1, 1, 2]], true]],
    ["layer", (name, given) => risk.layer(name, given), ["risk", { every: 2 }]],
    ["explain", (at) => risk.explain(at), [small.start]],
  ];
}

const all = calls();

test("every function of the package that takes something is called", () => {
  const tried = new Set(all.map(([, run]) => run));
  for (const [name, run] of Object.entries(parkade)) {
    expect(
      tried.has(run as never) || run.length === 0 || ["init", "Planner", "ParkadeError", "auditInParts"].includes(name),
      name,
    ).toBe(true);
  }
});

test.each(all)(
  "arguments of %s, one damaged at any depth or another altogether, are answered or explained",
  (_, run, args) => {
    answersOrExplains(() => run(...(args as never[])));
    const given = fc
      .tuple(choices, value)
      .map(([path, by]) => ({ args: damaged(args, path, by), by: [path, by] as unknown }));
    const any = fc.oneof(
      { weight: 5, arbitrary: given },
      fc.array(value, { maxLength: 3 }).map((some) => ({ args: some, by: some as unknown })),
    );
    const found = fc.check(
      fc.property(any, (some) => answersOrExplains(() => run(...(some.args as never[])))),
      options,
    );
    const words = ({ errorInstance, counterexample }: typeof found) =>
      `${errorInstance}, of ${fc.stringify(counterexample?.[0].by)}`;
    expect(found.failed && words(found)).toBe(false);
  },
  HOURS,
);

test(
  "an audit in parts with damaged arguments rejects with an explained error or resolves",
  async () => {
    const scene = { ...small, slots: [{ id: "a" }, { id: "b" }] },
      args = [scene, { bays: ["a"] }, () => [], { workers: 2, bays: 1 }];
    const given = fc.tuple(choices, value).map(([path, by]) => {
      const copy = damaged([args[0], args[1], null, args[3]], path, by);
      return copy[2] === null ? [copy[0], copy[1], args[2], copy[3]] : copy;
    });
    const any = fc.oneof({ weight: 5, arbitrary: given }, fc.array(value, { maxLength: 4 }));
    await fc.assert(
      fc.asyncProperty(any, async (some) => {
        try {
          await parkade.auditInParts(...(some as unknown as Parameters<typeof parkade.auditInParts>));
        } catch (error) {
          expect(error).toBeInstanceOf(ParkadeError);
          expect(CODES).toContain((error as ParkadeError).code);
        }
      }),
      options,
    );
  },
  HOURS,
);
