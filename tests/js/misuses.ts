/**
 * Wrong calls, made from what is right: every field of a scene, every setting and option, and calls that people get
 * wrong.
 */
import * as parkade from "parkade";
import type { PlannerInfo, Scenario } from "parkade";
import { RICH } from "./rich-scene";

/** A call, the field that it gets wrong ("" for none), and what it is called in lists. */
export interface Misuse {
  name: string;
  field: string;
  call(): unknown;
}

type Steps = (string | number)[];
/** Fields as errors name them. */
const named = (steps: Steps) =>
  steps.map((step, i) => (typeof step === "number" ? `[${step}]` : i > 0 ? `.${step}` : step)).join("");
const shown = (value: unknown): string =>
  typeof value === "number" || value === undefined ? String(value) : JSON.stringify(value);

/** A copy with one field changed, or taken away. */
function changed(steps: Steps, value: unknown, isGone = false): Scenario {
  const copy = structuredClone(RICH) as unknown as Scenario;
  let place = copy as unknown as Record<string | number, unknown>;
  for (const step of steps.slice(0, -1)) place = place[step] as Record<string | number, unknown>;
  if (isGone) delete place[steps.at(-1)!];
  else place[steps.at(-1)!] = value;
  return copy;
}

const geometry = (name: string, field: string, scene: unknown): Misuse => ({
  name: `sceneGeometry: ${name}`,
  field,
  call: () => parkade.sceneGeometry(scene as Scenario),
});

/** Values of other kinds than the given one's. */
function wrong(value: unknown): unknown[] {
  if (typeof value === "number") return ["3", Number.NaN, Number.POSITIVE_INFINITY, [1], {}, true];
  if (typeof value === "string") return [3, false, []];
  if (typeof value === "boolean") return [1, "no"];
  return Array.isArray(value) ? [7, {}, "list"] : [7, "text", [1]];
}

/** Fields that a scene may leave out. */
const OPTIONAL = ["name", "boundary", "vehicle", "obstacles", "slots", "costs", "moving", "lanes", "speedLimits"]
  .concat([
    "id",
    "thickness",
    "radius",
    "laneWidth",
    "speed",
    "kerbs",
    "angle",
    "lean",
    "occupied",
    "start",
    "curvature",
  ])
  .concat(["maxSteerRate", "heading"]);

/** Each field of a scene with values of other kinds, missing, and misspelt. */
function ofScenes(value: unknown = RICH, steps: Steps = []): Misuse[] {
  const field = named(steps),
    all: Misuse[] = [];
  if (steps.length > 0)
    for (const other of wrong(value)) all.push(geometry(`${field} = ${shown(other)}`, field, changed(steps, other)));
  if (typeof value !== "object" || value === null) return all;
  if (!Array.isArray(value))
    all.push(geometry(`${field} has colour`, named([...steps, "colour"]), changed([...steps, "colour"], 1)));
  for (const [key, inner] of Object.entries(value)) {
    const next = [...steps, Array.isArray(value) ? Number(key) : key];
    if (!Array.isArray(value) && !OPTIONAL.includes(key))
      all.push(geometry(`${named(next)} is missing`, named(next), changed(next, undefined, true)));
    all.push(...ofScenes(inner, next));
  }
  return all;
}

/** Each setting of each planner out of its range, of another kind, and misspelt. */
function ofSettings({ id, parameters }: PlannerInfo, scene: Scenario): Misuse[] {
  const misuse = (name: string, value: unknown): Misuse => ({
    name: `${id}: ${name} = ${shown(value)}`,
    field: name,
    call: () => new parkade.Planner(id, scene, { [name]: value } as never),
  });
  return [
    misuse("colour", 1),
    ...parameters.flatMap(({ name, type, min, max, choices }) => [
      misuse(`${name}s`, 1),
      misuse(name, type === "boolean" ? 1 : type === "choice" ? 7 : "much"),
      misuse(name, []),
      ...(choices ? [misuse(name, `${choices[0]}x`)] : []),
      // The lists' bounds are those of sliders; planners take more where it makes sense.
      ...(min === undefined || name === "seed" ? [] : [misuse(name, -1e9)]),
      ...(max === undefined || name === "seed" ? [] : [misuse(name, 1e12)]),
      ...(type === "integer" ? [misuse(name, (min ?? 0) + 0.5)] : []),
    ]),
  ];
}

/** Calls that people get wrong, with the field that the answer names. */
function ofCalls(): Misuse[] {
  const scene = parkade.scenario("perpendicular"),
    own = { x: 1, y: 2, heading: 0 };
  const all: Misuse[] = [];
  const add = (field: string, ...calls: (() => unknown)[]) =>
    all.push(
      ...calls.map((call) => ({
        name: String(call)
          .replace(/\s+/g, " ")
          .slice(6)
          .replace(/__vite\w+\./g, ""),
        field,
        call,
      })),
    );
  const any = (value: unknown) => value as never;
  const hybrid = (options: unknown) => {
    using planner = new parkade.Planner("hybrid", scene);
    return planner.plan(any(options));
  };
  const eight = <T>(run: (planner: parkade.Planner) => T): T => {
    using planner = new parkade.Planner("eight", scene);
    return run(planner);
  };
  const plan = eight((planner) => planner.plan());

  add(
    "planner",
    () => new parkade.Planner(any(undefined), scene),
    () => new parkade.Planner(any(7), scene),
  );
  add(
    "",
    () => new parkade.Planner(any("hybird"), scene),
    () => new parkade.Planner(any(""), scene),
  );
  add(
    "",
    () => new parkade.Planner(any("Hybrid"), scene),
    () => parkade.defaultConfig(any("astar")),
  );
  add("planner", () => parkade.defaultConfig(any(null)));
  add(
    "id",
    () => parkade.scenario(any(3)),
    () => parkade.scenario(any(undefined)),
    () => parkade.scenario(any(["P0"])),
  );
  add(
    "",
    () => parkade.scenario("perpendiculer"),
    () => parkade.scenario(""),
    () => parkade.scenario("scenes/a.json"),
  );
  add(
    "scene",
    () => parkade.sceneGeometry(any("perpendicular")),
    () => parkade.sceneGeometry(any(null)),
  );
  add(
    "scene",
    () => parkade.sceneGeometry(any(undefined)),
    () => parkade.sceneGeometry(any([])),
  );
  add(
    "scene",
    () => parkade.sceneGeometry(any(JSON.stringify(scene))),
    () => parkade.sceneGeometry(any(() => scene)),
  );
  add("map", () => parkade.sceneGeometry(any({ version: 1 })));
  add(
    "config",
    () => new parkade.Planner("hybrid", scene, any("margin=1")),
    () => new parkade.Planner("hybrid", scene, any([1])),
  );
  add("config", () => new parkade.Planner("hybrid", scene, any(7)));

  for (const value of [7, "fast", true, [1]]) add("options", () => hybrid(value));
  add(
    "start",
    () => hybrid({ start: 3 }),
    () => hybrid({ start: "here" }),
  );
  add("start[0]", () => hybrid({ start: [1, 2, 3] }));
  add("start.y", () => hybrid({ start: { x: 1 } }));
  add("start.heading", () => hybrid({ start: { x: 1, y: 2 } }));
  add(
    "start.x",
    () => hybrid({ start: { ...own, x: "1" } }),
    () => hybrid({ start: { ...own, x: Number.NaN } }),
  );
  add("start.theta", () => hybrid({ start: { ...own, theta: 1 } }));
  add("goal.slot", () => hybrid({ goal: { slot: "bay", entry: "head-in" } }));
  add("goal.slot", () => hybrid({ goal: { slot: 3, entry: "head-in" } }));
  add("goal.entry", () => hybrid({ goal: { slot: "slot-3", entry: "forwards" } }));
  add("goal.entry", () => hybrid({ goal: { slot: "slot-3" } }));
  add(
    "prefer",
    () => hybrid({ prefer: "shortes" }),
    () => hybrid({ prefer: 1 }),
  );
  add("alternatives", () => hybrid({ alternatives: "yes" }));
  add(
    "trace",
    () => hybrid({ trace: 1 }),
    () => hybrid({ trace: "ful" }),
  );
  add(
    "traceLimit",
    () => hybrid({ trace: "full", traceLimit: 0 }),
    () => hybrid({ trace: "full", traceLimit: 1e9 }),
  );
  add(
    "stickiness",
    () => hybrid({ stickiness: 2 }),
    () => hybrid({ stickiness: "a bit" }),
  );
  add(
    "onProgress",
    () => hybrid({ onProgress: 1 }),
    () => hybrid({ onProgress: "log" }),
  );
  add("onImproved", () => hybrid({ onImproved: {} }));
  add("signal", () => hybrid({ signal: new AbortController().signal }));
  add("timeout", () => hybrid({ timeout: 10 }));
  add("prefer", () => eight((planner) => planner.plan(any({ prefer: "widest" }))));
  add("alternatives", () => eight((planner) => planner.plan(any({ alternatives: true }))));

  for (const name of ["clearence", "Occupancy", "potential", ""])
    add("name", () => eight((planner) => planner.layer(any(name))));
  add(
    "name",
    () => eight((planner) => planner.layer(any(undefined))),
    () => eight((planner) => planner.layer(any(1))),
  );
  add("every", () => eight((planner) => planner.layer("clearance", { every: 0 })));
  add("every", () => eight((planner) => planner.layer("clearance", { every: 1.5 })));
  add("each", () => eight((planner) => planner.layer("clearance", any({ each: 1 }))));
  add("start.x", () => eight((planner) => planner.search(any({}), { x: 1, y: 1 })));
  add("goal.y", () => eight((planner) => planner.search({ x: 1, y: 1 }, any({ x: 1 }))));
  add("at.x", () => eight((planner) => planner.explain(any([1, 2]))));
  add("planner", () => eight((planner) => planner.explain({ x: 1, y: 2 })));
  add(
    "runs",
    () => eight((planner) => planner.brush(any(7), true)),
    () => eight((planner) => planner.brush(any([[1, 2]]), true)),
  );
  add("blocked", () => eight((planner) => planner.brush([[1, 2, 3]], any("yes"))));
  add(
    "before",
    () => eight((planner) => planner.continueFrom(any(3))),
    () => eight((planner) => planner.continueFrom(planner)),
  );
  add("", () => {
    const planner = new parkade.Planner("eight", scene);
    planner.free();
    return planner.plan();
  });

  add(
    "path",
    () => parkade.checkPath(scene, any("path")),
    () => parkade.checkPath(scene, any(undefined)),
  );
  add("path", () => parkade.checkPath(scene, [1, 2]));
  add("path[1]", () => parkade.checkPath(scene, any([1, "2", 3])));
  add("path[0]", () => parkade.checkPath(scene, any([[1, 2, 3]])));
  add("directions[0]", () => parkade.checkPath(scene, [1, 2, 3], [257]));
  add("text", () => parkade.unpackRuns(any("?")));
  add("cells", () => parkade.fromOccupancy(any(7), 3, any({})));
  add("resolution", () => parkade.fromOccupancy([0, 1, 0, 0], 2, any({ resolution: -1 })));
  add("resolution", () => parkade.fromOccupancy([0, 1, 0, 0], 2, any({})));
  add("family", () => parkade.generateScenario(any({ family: "rondom", size: 20, seed: 1 })));
  add("size", () => parkade.generateScenario(any({ family: "random", size: 4, seed: 1 })));
  add("size", () => parkade.generateScenario(any({ family: "random", size: "20", seed: 1 })));
  add("size", () => parkade.generateScenario(any({ family: "random", seed: 1 })));
  add("seed", () => parkade.generateScenario(any({ family: "random", size: 20, seed: -1 })));
  add("density", () => parkade.generateScenario(any({ family: "random", size: 20, seed: 1, density: 3 })));
  add(
    "family",
    () => parkade.generateScenario(any(7)),
    () => parkade.generateScenario(any(undefined)),
  );
  add("preset", () => parkade.generateLot(any({ preset: "twoo" })));
  add(
    "options",
    () => parkade.generateLot(any(7)),
    () => parkade.importScene({ "a.map": "x" }, any("free")),
    () => parkade.optimise(scene, plan, any(8)),
    () => parkade.trajectory(scene, plan, any(8)),
    () => parkade.audit(scene, any("sedan")),
    () => parkade.toSVG(scene, plan, any(720)),
    () => eight((planner) => planner.layer("clearance", any(2))),
  );
  add("limits", () => parkade.judge(scene, "x,y\n1,2", any(7)));
  add("angle", () => parkade.generateLot({ angle: 60 }));
  add(
    "rows",
    () => parkade.generateLot(any({ rows: 0 })),
    () => parkade.generateLot(any({ rows: "two" })),
  );
  add(
    "files",
    () => parkade.importScene(any(7)),
    () => parkade.importScene(any({})),
  );
  add("a.txt", () => parkade.importScene({ "a.txt": "x" }));
  add("a.map:1", () => parkade.importScene({ "a.map": "x" }));
  add(
    "radius",
    () => parkade.reedsShepp(own, own, 0),
    () => parkade.reedsShepp(own, own, any("4")),
  );
  add("from.y", () => parkade.reedsShepp(any({ x: 1 }), own, 4));
  add(
    "plan",
    () => parkade.trajectory(scene, any(7)),
    () => parkade.optimise(scene, any(undefined)),
  );
  add("plan", () => parkade.toCSV(scene, any(null)));
  add("drive", () => parkade.toTrajectoryCSV(any(3)));
  add(
    "plan.path",
    () => parkade.toCSV(scene, any({})),
    () => parkade.toCSV(scene, any({ path: "x" })),
  );
  add(
    "width",
    () => parkade.toSVG(scene, plan, { width: -1 }),
    () => parkade.toSVG(scene, plan, any({ width: "720" })),
  );
  add("theme", () => parkade.toSVG(scene, plan, any({ theme: "blue" })));
  add("vehicles[0]", () => parkade.audit(scene, any({ vehicles: ["seden"] })));
  add("entry", () => parkade.audit(scene, any({ entry: "sideways" })));
  add("1:3", () => parkade.judge(scene, "a,b\n1,2"));
  add("1:1", () => parkade.judge(scene, ""));
  return all;
}

/** Every misuse of the API; the module must be there. */
export function misusesOfApi(): Misuse[] {
  const scene = parkade.scenario("perpendicular");
  return [...ofScenes(), ...parkade.planners().flatMap((info) => ofSettings(info, scene)), ...ofCalls()];
}
