/** Wrong calls, made from what is right: every field of a scene, every setting and option, and calls that people get wrong. */
import * as parkade from "parkade";
import type { PlannerInfo, Scenario } from "parkade";

/** A call, the field that it gets wrong ("" for none), and what it is called in lists. */
export interface Misuse {
  name: string;
  field: string;
  call(): unknown;
}

/** A scene with everything that a scene may have. */
const RICH = {
  version: 1,
  name: "Everything",
  map: {
    origin: [0, 0],
    width: 60,
    height: 40,
    resolution: 0.5,
    boundary: [
      [0, 0],
      [30, 0],
      [30, 20],
      [0, 20],
    ],
  },
  vehicle: { wheelbase: 2.7, width: 1.9, rearToFront: 3.6, rearToBack: 1, maxSteer: 0.6, maxSteerRate: 0.5 },
  start: { x: 4, y: 10, heading: 0 },
  goal: { slot: "bay", entry: "head-in" },
  obstacles: [
    { type: "rectangle", id: "box", center: [10, 4], size: [1, 1], heading: 0.1 },
    {
      type: "polygon",
      points: [
        [14, 3],
        [15, 3],
        [15, 4],
      ],
    },
    {
      type: "wall",
      points: [
        [1, 1],
        [2, 1],
      ],
      thickness: 0.1,
    },
    { type: "car", pose: { x: 24, y: 3, heading: 0 } },
    { type: "cells", runs: [[2, 2, 3]] },
    {
      type: "road",
      points: [
        [0, 10],
        [30, 10],
      ],
      radius: 20,
      lanes: [1, 1],
      laneWidth: 3.5,
      speed: 8,
      kerbs: true,
    },
  ],
  slots: [
    {
      id: "bay",
      kind: "angled",
      x: 20,
      y: 16,
      heading: 1.5,
      width: 3,
      length: 3,
      angle: 1,
      lean: "left",
      occupied: false,
    },
  ],
  costs: [{ id: "mud", runs: [[5, 5, 2]], weight: 2 }],
  moving: [
    {
      id: "bus",
      points: [
        [28, 18],
        [29, 18],
      ],
      size: [1, 1],
      speed: 1,
      start: 2,
    },
  ],
  lanes: [{ id: "lane", start: { x: 1, y: 10, heading: 0 }, pieces: [{ length: 5, curvature: 0.1 }], width: 3.5 }],
  speedLimits: [
    {
      points: [
        [1, 18],
        [3, 18],
        [3, 19],
      ],
      speed: 1,
    },
  ],
};

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

/** Lines of the command that people get wrong, each with a word of its answer; `a.json` is a scene in the folder. */
export const COMMAND_LINES: [line: string, words: string][] = [
  ["plan", "which scene?"],
  ["plan nowhere", "neither a file nor a built-in scene"],
  ["plan perpendiculer", "did you mean perpendicular?"],
  ["plan Perpendicular", "did you mean perpendicular?"],
  ["plan nowhere.json", "there is no such file"],
  ["plan folder", "is a folder"],
  ["plan folder.json", "there is no such file"],
  ["plan a.json a.json", "is given twice"],
  ["plan a.json/x.json", "a part of its path is a file"],
  ["plan text.json", "is not JSON"],
  ["plan empty.json", "is not JSON"],
  ["plan list.json", "list.json: must be an object"],
  ["plan a.map", 'must be "type octile"'],
  ["plan picture.png", ".dxf"],
  ["plan a.json --planner hybird", "did you mean hybrid?"],
  ["plan a.json --planner", "needs a value"],
  ["plan a.json --planner=", '--planner "": there is no such planner'],
  ["plan a.json --planner hybrid,", "there is no such planner"],
  ["plan a.json --planner eight,hybrid --format csv", "one planner at a time"],
  ["plan a.json perpendicular --format svg", "holds one scene"],
  ["plan a.json --plannr hybrid", "did you mean --planner?"],
  ["plan a.json --sett margin=1", "did you mean --set?"],
  ["plan a.json --format png", "must be one of json, csv, svg"],
  ["plan a.json --format JSON", "must be one of json, csv, svg"],
  ["plan a.json --set margin", "must be NAME=VALUE"],
  ["plan a.json --set =1", "must be NAME=VALUE"],
  ["plan a.json --set margn=1", "did you mean margin?"],
  ["plan a.json --set margin=-1", "margin: must be"],
  ["plan a.json --set margin=wide", "margin: must be"],
  ["plan a.json --set margin=", "margin: must be"],
  ["plan a.json --set margin=null", "margin: must be"],
  ["plan a.json --prefer widest --planner eight", "eight finds one path"],
  ["plan a.json --prefer wide", "must be one of shortest"],
  ["plan a.json --alternatives --planner eight", "alternatives"],
  ["plan a.json --alternatives=yes", "takes no value"],
  ["plan a.json --trace=full", "takes no value"],
  ["plan a.json --size big --format svg", "must be WIDTHxHEIGHT"],
  ["plan a.json --size 720 --format svg", "must be WIDTHxHEIGHT"],
  ["plan a.json --size 0x0 --format svg", "width"],
  ["plan a.json --theme blue --format svg", "must be one of auto, light, dark"],
  ["plan a.json --layout grid --format svg", "must be one of single, overlay"],
  ["plan a.json --controls full --format svg", "must be one of none, minimal"],
  ["plan a.json --timeout soon", "must be a whole number"],
  ["plan a.json --timeout 0", "must be a whole number"],
  ["plan a.json --timeout -5", "needs a value"],
  ["plan a.json --timeout 1.5", "must be a whole number"],
  ["plan a.json --out missing/a.csv", "its folder does not exist"],
  ["plan a.json --out folder", "is a folder"],
  ["plan a.json -o x", "there is no such option"],
  ["plan a.json --help=1", "--help: takes no value"],
  ["plann a.json", "did you mean plan?"],
  ["Plan a.json", "did you mean plan?"],
  ["--planner hybrid", "unknown command"],
  ["toString", "unknown command"],
  ["check", "which scene?"],
  ["check nowhere", "neither a file nor"],
  ["check a.json nowhere.csv", "there is no such file"],
  ["check a.json a.json", "path: must be"],
  ["check a.json text.json", "has no column x"],
  ["check a.json bad.csv", "theta: must be a number"],
  ["check a.json short.csv", "has no column theta"],
  ["check a.json a.csv b.csv", "one path at a time"],
  ["check a.json --format csv", "must be one of text, json"],
  ["check a.json --planner hybrid", "there is no such option"],
  ["judge", "which trajectory?"],
  ["judge a.json", "which trajectory?"],
  ["judge a.json nowhere.csv", "there is no such file"],
  ["judge a.json text.json", "must be one of t, x, y"],
  ["judge a.json bad.csv", "bad.csv:2"],
  ["judge a.json a.json", "a.json: path: must be"],
  ["judge a.json bad.csv more.csv", "one trajectory at a time"],
  ["judge a.json bad.csv --speed fast", "must be a number"],
  ["judge a.json good.csv --speed -1", "needs a value"],
  ["judge a.json good.csv --speed=-1", "--speed: must be"],
  ["judge a.json good.csv --acceleration 0", "acceleration"],
  ["judge a.json good.csv --speeed 1", "did you mean --speed?"],
  ["bench", "which scene?"],
  ["bench a.json --repeats 0", "must be a whole number from 1"],
  ["bench a.json --repeats many", "must be a whole number from 1"],
  ["bench a.json --repeats 1e3", "must be a whole number from 1"],
  ["bench a.json --planner astar", "there is no such planner"],
  ["bench a.json --format html", "must be one of markdown, csv, json"],
  ["batch", "which scenes?"],
  ["batch nowhere", "no such file or folder"],
  ["batch empty", "no .json scenes here"],
  ["batch folder --shard 3/2", "must be I/N"],
  ["batch folder --shard 0/2", "must be I/N"],
  ["batch folder --shard 1", "must be I/N"],
  ["batch folder --shard 1of2", "must be I/N"],
  ["batch folder --jobs 0", "must be a whole number"],
  ["batch folder --jobs all", "must be a whole number"],
  ["batch folder --planner eigth", "did you mean eight?"],
  ["batch folder --set cornr=free --planner eight", "did you mean corner?"],
  ["batch folder --sweep margin", "must be NAME=VALUE,VALUE"],
  ["batch folder --sweep margin=1,1", "has a value twice"],
  ["batch folder --sweep margin=1 --set margin=2", "is set already"],
  ["batch folder --sweep magin=1,2", "did you mean margin?"],
  ["batch folder --task audits", "must be one of plan, audit"],
  ["batch folder --task audit --planner hybrid", "audits use hybrid"],
  ["batch folder --task audit --sweep margin=1,2", "audits have one set"],
  ["batch folder --task audit --paths", "rows of audits have no paths"],
  ["batch folder --task audit --vehicle seden", "did you mean sedan?"],
  ["batch folder --paths=yes", "takes no value"],
  ["batch folder --timeout never", "must be a whole number"],
  ["batch folder --out folder", "is a folder"],
  ["batch folder --out a.json/x.jsonl", "a part of its path is a file"],
  ["batch folder --out missing/x.jsonl", "its folder does not exist"],
  ["batch folder --out text.json", "is no file of results"],
  ["batch folder --time", "did you mean --times?"],
  ["audit", "which scene?"],
  ["audit nowhere", "neither a file nor"],
  ["audit a.json --vehicle seden", "did you mean sedan?"],
  ["audit a.json --entry sideways", "entry"],
  ["audit a.json --format html", "must be one of markdown, csv, json"],
  ["audit a.json --jobs none", "must be a whole number"],
  ["audit a.json --vehicles sedan", "did you mean --vehicle?"],
  ["lot --preset two", "--preset: must be"],
  ["lot --rows none", "must be a number"],
  ["lot --rows 0", "rows"],
  ["lot --seed x", "must be a number"],
  ["lot --angle 9", "--angle: must be 0.5 to 1.5707963267948966 rad"],
  ["lot here", "takes options only"],
  ["vehicles --format csv", "must be one of text, json"],
  ["vehicles --list", "there is no such option"],
  ["columns", "which files?"],
  ["columns nowhere.jsonl", "there is no such file"],
  ["columns a.json", "is no result of"],
  ["columns x.parquet", "is in columns already"],
  ["columns results.jsonl --out folder", "is a folder"],
  ["columns results.jsonl --out missing/x.parquet", "its folder does not exist"],
  ["report", "which files?"],
  ["report nowhere.jsonl", "there is no such file"],
  ["report text.parquet", "is no Parquet file"],
  ["report a.json", "is no result of"],
  ["report nothing.jsonl", "no results"],
  ["report results.jsonl --out folder", "is a folder"],
  ["digest", "which files?"],
  ["digest nowhere.jsonl", "there is no such file"],
  ["digest a.json", "is no result of"],
  ["digest text.json", "is no result of"],
  ["digest results.jsonl --out x", "there is no such option"],
  ["planners --planner hybird", "did you mean hybrid?"],
  ["planners --format csv", "must be one of text, json"],
  ["planners hybrid", "takes options only"],
  ["scenarios --format csv", "must be one of text, json"],
  ["scenarios perpendicular", "takes options only"],
  ["scenario", "which scene?"],
  ["scenario perpendiculer", "did you mean perpendicular?"],
  ["scenario fig16 fig12", "one scene at a time"],
  ["scenario fig16 --out folder", "is a folder"],
  ["generate here", "takes options only"],
  ["generate --family rondom", "must be one of random, regular, trap"],
  ["generate --size x", "must be a number"],
  ["generate --size 1e9", "size"],
  ["generate --size 4", "size"],
  ["generate --size=", '--size "": must be a number'],
  ["generate --seed 1.5", "seed"],
  ["generate --seed -1", "needs a value"],
  ["generate --seed=-1", "seed"],
  ["generate --density 2000", "--density: must be"],
  ["generate --block-min 0", "--block-min: must be"],
  ["generate --family trap --density 3", "density"],
  ["generate --sed 1", "did you mean --seed?"],
  ["convert", "which files?"],
  ["convert nothing.map", "there is no such file"],
  ["convert a.json b.json", "there is no such file"],
  ["convert a.json folder/b.json", "JSON holds one"],
  ["convert text.json", "is not JSON"],
  ["convert picture.png", ".dxf"],
  ["convert a.map", 'must be "type octile"'],
  ["convert a.json --unknown maybe", "must be one of blocked, free"],
  ["convert a.json --format csv", "must be one of json, jsonl"],
  ["convert a.json --resolution fine", "must be a number"],
  ["convert room.map --query 7", "query"],
  ["convert lot.geojson --role a", "must be LAYER=ROLE"],
  ["convert lot.geojson --role a=wall", "there is no such layer"],
  ["convert lot.geojson --unit x", "must be a number"],
  ["convert bad.geojson", "GeoJSON, got undefined"],
  ["convert bad.dxf", "bad.dxf"],
  ["plan bad.svg", "bad.svg"],
  ["convert room.map --resolution 0", "resolution"],
  ["completion", "which shell?"],
  ["completion csh", "must be one of bash, zsh, fish"],
  ["completion bash zsh", "which shell?"],
];

/** Attributes of the element. */
export const ATTRIBUTES: [name: string, ...texts: string[]][] = [
  ["layout", "gird", "", "Single", "grid overlay"],
  ["controls", "non", "all", "true"],
  ["wheel", "ctl", "false", "zoom"],
  ["theme", "blue", "Dark", ""],
  ["smooth", "yes", "1"],
  ["speed", "fast", "0", "-1", "1e9", "NaN"],
  ["budget-ms", "soon", "0", "-5", "1s", "Infinity"],
  ["layers", "serach", "search,drive", "search search", "all"],
  ["loading", "laizy", "now"],
  ["reveal", "click", "hover"],
  ["editable", "no", "1"],
];

/** Every misuse of the API; the module must be there. */
export function misusesOfApi(): Misuse[] {
  const scene = parkade.scenario("perpendicular");
  return [...ofScenes(), ...parkade.planners().flatMap((info) => ofSettings(info, scene)), ...ofCalls()];
}
