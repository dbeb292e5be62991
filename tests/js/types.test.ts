/**
 * Whatever the package answers is as its types say, and no more; each function is called, and each word of a list
 * occurs.
 */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import Ajv, { type ValidateFunction } from "ajv";
import { beforeAll, describe, expect, it } from "vitest";
import * as small from "parkade/core";
import * as parkade from "parkade";
import type { HybridPlannerId, Plan, PlannerId, PlannerSettings } from "parkade";
import { declared, schemaOf } from "./declared.mjs";
import { FEW, GOALS, failing, scene } from "./type-cases";

const here = (path: string): string => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const WHOLE = here("packages/parkade/index.d.ts"),
  CORE = here("packages/parkade/core/index.d.ts");

type Function = (...args: unknown[]) => unknown;

/** A module whose answers are held against its types. */
class Watched {
  readonly seen = new Set<string>();
  readonly rules: Record<string, ValidateFunction>;
  readonly answers: Record<string, string>;

  constructor(
    readonly api: Record<string, unknown>,
    file: string,
    ids: readonly string[],
  ) {
    this.answers = declared(file).answers;
    const types = Object.entries(this.answers).flatMap(([name, type]) =>
      /\bId\b/.test(type)
        ? ids.map((id) => [`${name}:${id}`, type.replaceAll(/\bId\b/g, JSON.stringify(id))])
        : [[name, type]],
    );
    const { properties, definitions = {} } = schemaOf(file, Object.fromEntries(types) as Record<string, string>) as {
      properties: Record<string, object>;
      definitions?: object;
    };
    const ajv = new Ajv({ allErrors: true, allowUnionTypes: true });
    ajv.addKeyword({
      keyword: "typedArray",
      validate: (name: string, data: unknown) => Object.prototype.toString.call(data) === `[object ${name}]`,
    });
    this.rules = Object.fromEntries(
      Object.entries(properties).map(([name, schema]) => [name, ajv.compile({ ...schema, definitions })]),
    );
  }

  /** The answer, once it is found to be of its type. */
  check<T>(name: string, answer: T, id = ""): T {
    this.seen.add(name);
    const rule = this.rules[name] ?? this.rules[`${name}:${id}`];
    if (!rule) throw new Error(`${name}: no declared answer`);
    rule(answer);
    expect(rule.errors ?? [], `${name} ${id}`).toEqual([]);
    return answer;
  }

  call(name: string, ...args: unknown[]): unknown {
    return this.check(name, (this.api[name] as Function)(...args), String(args[0]));
  }

  /** Everything that a planner answers. */
  planner(
    id: string,
    scene: unknown,
    config: object = {},
  ): { plan(options?: object): Plan; call(method: string, ...args: unknown[]): unknown; free(): void } {
    const made = new (this.api["Planner"] as new (...args: unknown[]) => Record<string, Function>)(id, scene, config);
    const call = (method: string, ...args: unknown[]): unknown =>
      this.check(`Planner.${method}`, made[method]!(...args), id);
    return {
      call,
      plan: (options) => call("plan", options) as Plan,
      free: () => {
        made["free"]!();
      },
    };
  }

  unseen(): string[] {
    return Object.keys(this.answers).filter((name) => !this.seen.has(name));
  }
}

describe("what the package answers is of the types that it declares:", () => {
  let api: Watched, core: Watched;
  const outcomes = new Set<string>(),
    kinds = new Set<string>(),
    groups = new Set<string>();

  beforeAll(async () => {
    await Promise.all([parkade.init(), small.init()]);
    api = new Watched(
      parkade,
      WHOLE,
      parkade.planners().map(({ id }) => id),
    );
    core = new Watched(
      small,
      CORE,
      small.planners().map(({ id }) => id),
    );
  }, 120_000);

  const note = (plan: Plan): Plan => {
    outcomes.add(plan.outcome);
    if (plan.obstruction) kinds.add(plan.obstruction.kind);
    return plan;
  };

  it("catalogues, scenes and settings, of both modules", () => {
    for (const module of [api, core]) {
      if (module === api) module.call("version");
      for (const { id } of module.call("planners") as { id: string }[]) module.call("defaultConfig", id);
      const all =
        module === core ? small.scenarios() : (module.call("scenarios") as ReturnType<typeof parkade.scenarios>);
      for (const { id, group } of all) {
        groups.add(group);
        module.call("sceneGeometry", module.call("scenario", id));
      }
    }
  });

  it("every planner's plan of every scene, with its trace", () => {
    for (const { id } of parkade.scenarios()) {
      for (const { id: planner, family } of parkade.planners()) {
        const made = api.planner(planner, scene(id), family === "hybrid" ? FEW : {});
        const { path, directions } = note(made.plan({ trace: true }));
        if (path.length > 0) api.call("checkPath", scene(id), path, directions);
        made.free();
      }
    }
  }, 240_000);

  it.each(["perpendicular", "narrow-gap", "trap-60", "L2", "road-narrow", "fig16"])(
    "every planner's plan of %s, without a trace, and its layers",
    (id) => {
      for (const { id: planner, family, hasRiskField } of parkade.planners()) {
        const made = api.planner(planner, scene(id), family === "hybrid" ? FEW : {});
        note(made.plan());
        for (const layer of ["occupancy", "safety", "clearance"]) made.call("layer", layer);
        if (family === "road") made.call("layer", "cost");
        if (family === "grid") made.call("layer", "redundant");
        if (hasRiskField) made.call("layer", "risk", { every: 3 });
        if (hasRiskField) made.call("layer", "potential");
        made.free();
      }
    },
    120_000,
  );

  it("every plan of the small module", () => {
    for (const { id: planner, family } of small.planners()) {
      for (const { id } of small.scenarios()) {
        const made = core.planner(planner, small.scenario(id), family === "hybrid" ? FEW : {});
        const { path, directions } = made.plan({ trace: true });
        if (path.length > 0) core.call("checkPath", small.scenario(id), path, directions);
        made.call("layer", "clearance");
        made.free();
      }
    }
  }, 120_000);

  it("plans that fail, with what is in the way", () => {
    for (const [name, [planner, where, config]] of Object.entries(failing())) {
      const made = api.planner(planner, where, config);
      const plan = note(made.plan({ trace: true }));
      expect(plan.outcome, name).not.toBe("found");
      made.free();
    }
    expect([...kinds].sort()).toEqual(["boxed-in", "contact", "enclosed", "gap", "nearest"]);
  });

  it("choices, goals of sets and improvements", () => {
    for (const planner of ["hybrid", "hybrid-forward", "hybrid-bidirectional"] satisfies HybridPlannerId[]) {
      const made = api.planner(planner, scene("L2"));
      const told: number[] = [];
      made.plan({
        alternatives: true,
        onProgress: (expansions: number) => told.push(expansions),
        onImproved: (plan: Plan) => void api.check("Planner.plan", plan, planner),
      });
      for (const prefer of ["shortest", "fewest-changes", "widest", "fastest"]) made.plan({ prefer, stickiness: 0.1 });
      expect(told.length).toBeGreaterThan(0);
      made.free();
    }
    for (const goal of GOALS) {
      const where = { ...scene("perpendicular"), goal };
      api.call("sceneGeometry", where);
      for (const planner of ["hybrid", "eight", "cost-map"] satisfies PlannerId[]) {
        const made = api.planner(planner, where);
        note(made.plan());
        made.free();
      }
    }
  }, 120_000);

  it("cells that cost, closed passages, searches alone, brushes, fields and the shortest path at any angle", () => {
    const map = scene("random-60"),
      costs = [{ runs: [[10, 10, 20]] as [number, number, number][], weight: 3 }];
    for (const planner of [
      "eight",
      "sixteen-bidirectional",
      "risk-field",
      "cost-map",
      "hybrid",
    ] satisfies PlannerId[]) {
      const config: PlannerSettings[PlannerId] =
        planner === "sixteen-bidirectional" ? { stop: "nba", minPassage: 2, trapMouth: 3 } : {};
      const made = api.planner(planner, { ...map, costs }, config);
      made.plan();
      made.free();
    }
    const eight = api.planner("eight", map),
      risk = api.planner("risk-field", map),
      { start, goal } = parkade.sceneGeometry(map);
    eight.call("search", start, goal);
    eight.call("search", start, { x: -5, y: 0 });
    eight.call("anyAngleLength");
    for (let cell = 0; cell < 60; cell += 7)
      for (let row = 0; row < 60; row += 5) risk.call("explain", { x: cell + 0.5, y: row + 0.5 });
    eight.free();
    risk.free();
  });

  it("audits, and the library of vehicles", () => {
    const rows = api.call("audit", scene("perpendicular"), {
      vehicles: ["sedan", "small-lorry"],
      whatIf: "each-free",
    }) as parkade.AuditRow[];
    expect(new Set(rows.map(({ reachable }) => reachable)).size).toBe(2);
    api.call("vehicles");
    api.call("affectedRows", scene("perpendicular"), { ...scene("perpendicular"), obstacles: [] }, rows, {
      vehicles: ["sedan", "small-lorry"],
    });
    api.call("generateLot", { seed: 2 });
    api.call("lotPresets");
  });

  it("drives, waits and pictures", () => {
    for (const { id, group } of parkade.scenarios().filter((one) => one.group === "moving" || one.id === "L2")) {
      const where = scene(id),
        made = api.planner("hybrid", where),
        plan = made.plan();
      expect(plan.outcome, `${group} ${id}`).toBe("found");
      for (const limits of [{}, { jerk: 1 }, { profile: "constant" }, { steps: "slow", dwell: false }])
        api.call("trajectory", where, plan, limits);
      for (const controller of ["feedback", "pure-pursuit", "stanley"]) api.call("track", where, plan, { controller });
      for (const options of [{}, { rule: "reactive" }, { rule: "reactive", scope: "window" }, { maxTime: 5 }])
        api.call("stopWaitGo", where, plan, options);
      const optimised = api.call("optimise", where, plan, { margin: 0.02 });
      api.call("toTrajectoryCSV", optimised);
      api.call("track", where, optimised);
      for (const judged of [plan, parkade.trajectory(where, plan), "t,x,y,theta\n0,0,0,0\n1,1,0,0\n"])
        api.call("judge", where, judged, { speed: 2 });
      api.call("toSVG", where, [plan], { theme: "dark" });
      api.call("toCSV", where, plan);
      api.call("toCSV", where, plan, parkade.trajectory(where, plan));
      api.call("toTrajectoryCSV", parkade.trajectory(where, plan));
      api.call("roadFigures", where, plan);
      api.call("reedsShepp", where.start, { ...where.start, x: where.start.x + 9 }, 6);
      api.call("collisionRisk", where, plan, { trials: 50 });
      api.call("driveEnvelope", where, plan, { trials: 50 });
      made.free();
    }
  });

  it("maps of other programs, drawn maps and runs as text", () => {
    const map = "type octile\nheight 3\nwidth 4\nmap\n.@GT\nS...\nO..W\n",
      runs = [
        [0, 0, 2],
        [5, 1, 2],
      ];
    api.call("importScene", {
      "room.map": map,
      "room.map.scen": "version 1\n0\tmaps/room.map\t4\t3\t0\t0\t2\t0\t4.0000\n",
    });
    const picture = new Uint8Array([...new TextEncoder().encode("P5 3 2 255\n"), 0, 254, 254, 205, 254, 0]);
    api.call("importScene", {
      "lot.yaml": "image: lot.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nfree_thresh: 0.196\n",
      "lot.pgm": picture,
    });
    api.call("importScene", { "scene.json": JSON.stringify(scene("fig16")) });
    for (const family of ["random", "regular", "trap"]) api.call("generateScenario", { family, size: 40, seed: 3 });
    const ends = { start: { x: 0.5, y: 0.5, heading: 0 }, goal: { x: 2.5, y: 1.5, heading: 0 } };
    const cells = [0, 1, 0, 0, 0, 0],
      costs = [1, 1, 3, 1, 1, 1];
    api.call("fromOccupancy", cells, 3, { ...ends, resolution: 1, costs });
    const info = { width: 3, height: 2, resolution: 1, origin: { position: { x: 0, y: 0 } } };
    api.call("fromOccupancyGrid", { info, data: cells }, ends);
    api.call("unpackRuns", api.call("packRuns", runs));
  });

  it("the papers' tables", () => {
    const { rows } = api.call("paperGridRows") as ReturnType<typeof parkade.paperGridRows>;
    const figures = Object.fromEntries(rows.map(({ id }) => [id, api.call("paperGrid", { row: id, from: 0, to: 2 })]));
    api.call("paperGridSummary", figures);
    const lots = (api.call("paperParkingRows") as { id: string }[]).map(({ id: row }) =>
      api.call("paperParking", { row }),
    );
    api.call("paperIncomplete", { row: "regular-30", from: 1, to: 40 });
    api.call("paperVolumes", { scene: "park-fig13", poses: 500 });
    const road = api.call("paperRoadRows") as { id: string; ship: boolean }[];
    const [cars, ships] = [false, true].map((wanted) =>
      road.filter(({ ship }) => ship === wanted).slice(0, wanted ? 1 : 4),
    ) as [typeof road, typeof road];
    api.call("paperVerdicts", {
      parking: lots,
      road: [...cars, ...ships].map(({ id: row }) => api.call("paperRoad", { row })),
    });
    api.call("paperVerdicts", { parking: lots.slice(1) });
  }, 120_000);

  it("no function was left out", () => {
    expect([api.unseen(), core.unseen()]).toEqual([[], []]);
  });

  it("every word of a list can be met", () => {
    const lists = {
      PlannerId: "PlannerId",
      group: 'ScenarioInfo["group"]',
      family: 'PlannerInfo["family"]',
      Outcome: "Outcome",
      Verdict: 'Check["verdict"]',
      ErrorCode: "ErrorCode",
    };
    const { properties } = schemaOf(WHOLE, lists) as { properties: Record<keyof typeof lists, { enum: string[] }> };
    const words = Object.fromEntries(Object.entries(properties).map(([name, list]) => [name, list.enum.sort()]));
    expect(words).toEqual(
      sorted({
        PlannerId: parkade.planners().map(({ id }) => id),
        family: parkade.planners().map(({ family }) => family),
        group: groups,
        Outcome: outcomes,
        Verdict: rustWords("src/metrics/check.rs", "Verdict"),
        ErrorCode: [...rustWords("src/error.rs", "ErrorCode"), "freed", "not-initialised", "internal"],
      }),
    );
  });
});

const sorted = (lists: Record<string, Iterable<string>>): Record<string, string[]> =>
  Object.fromEntries(Object.entries(lists).map(([name, list]) => [name, [...new Set(list)].sort()]));

/** The words of an enum in Rust, from its `as_str`. */
const rustWords = (file: string, name: string): string[] =>
  [
    ...readFileSync(here(file), "utf8")
      .split(`impl ${name} {`)[1]!
      .split("\n}\n")[0]!
      .matchAll(/Self::\w+ => "([^"]+)"/g),
  ].map(([, word]) => word!);

describe("each module declares what it exports:", () => {
  it.each([
    ["parkade", WHOLE, parkade],
    ["parkade/core", CORE, small],
  ])("%s", (_, file, api) => {
    expect(Object.keys(api).sort()).toEqual(declared(file).values.sort());
  });
});
