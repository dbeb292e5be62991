import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import Ajv from "ajv";
import {
  Planner,
  checkPath,
  init,
  packRuns,
  sceneGeometry,
  toSVG,
  unpackRuns,
  type Goal,
  type GoalSet,
  type Plan,
} from "parkade";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import schema from "../../src/scenario/scenario.schema.json";
import { chineseReasons } from "../../www/src/i18n/reasons-zh";
import catalogue from "../../www/src/i18n/reasons-zh.json";
import { decodeHistory, encodeHistory } from "../../www/src/app/history";
import { pack, unpack } from "../../www/src/scene/link-codec";
import { checkScene } from "../../www/src/scene/files";
import { checkedScene } from "../../www/src/scene/foreign";
import {
  anyFreeSlot,
  anyOfSlots,
  anywhereIn,
  flipGoal,
  leaveSlot,
  onlyOne,
  orThere,
  regionAroundGoal,
  slotOfStart,
  slotsOfGoal,
  withEntry,
} from "../../www/src/scene/goals";
import { decodeScene, encodeScene } from "../../www/src/scene/link";
import { ensureIds, footprint, moveGoal, poseInSlot, resolve, slotOutline, vehicleOf } from "../../www/src/scene/model";
import type { Scenario } from "../../www/src/scene/scenario";
import { insidePolygon } from "../../www/src/scene/geometry";
import { removeSlot } from "../../www/src/scene/removal";
import { parkade } from "./pack";
import { core } from "./core";

let folder = "";
beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "parkade-"));
  await Promise.all([init(), core.init()]);
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** A lot whose slots `a`, `c` and `d` are free. */
const lot = (goal: Goal | GoalSet): Scenario => ({
  version: 1,
  map: { origin: [0, 0], width: 88, height: 26, resolution: 0.5 },
  slots: ["a", "b", "c", "d"].map((id, i) => ({
    id,
    kind: "perpendicular",
    x: 10 + 8 * i,
    y: 6,
    heading: -Math.PI / 2,
    width: 3,
    length: 5.5,
    occupied: id === "b",
  })),
  vehicle: "sedan",
  start: { x: 12, y: 9, heading: 0 },
  goal,
});

const SETS: GoalSet[] = [
  { slots: "free", entry: "either" },
  { slots: ["b", "d"], entry: "head-in" },
  [
    { x: 40, y: 9, heading: 0 },
    { x: 20, y: 9, heading: 0 },
  ],
  {
    region: [
      [16, 6],
      [40, 6],
      [40, 12.9],
      [16, 12.9],
    ],
    heading: 0,
  },
];

function planned(goal: Goal | GoalSet): Plan {
  const planner = new Planner("hybrid", lot(goal));
  try {
    return planner.plan();
  } finally {
    planner.free();
  }
}

const messageOf = (run: () => unknown): string => {
  try {
    run();
  } catch (error) {
    return (error as Error).message;
  }
  return "";
};

describe("sets of goals", () => {
  it("are met by the goal that the plan names", () => {
    for (const goal of SETS) {
      const plan = planned(goal);
      expect([plan.outcome, plan.check.verdict], JSON.stringify(goal)).toEqual(["found", "ok"]);
      const [x, y, heading] = plan.path.slice(-3),
        { pose } = plan.goal!;
      expect([x, y, heading]).toEqual([pose.x, pose.y, pose.heading]);
      expect(checkPath(lot(goal), plan.path, plan.directions).verdict).toBe("ok");
      // The command and pages tell plans by JSON.
      expect(JSON.parse(JSON.stringify(plan)).goal).toEqual(plan.goal);
    }
    expect(planned(SETS[1]!).goal).toMatchObject({ index: 3, slot: "d", entry: "head-in" });
    expect(planned(SETS[2]!).goal).toEqual({ index: 1, pose: { x: 20, y: 9, heading: 0 } });
  });

  it("leave plans for one goal as they were", () => {
    const one = planned({ x: 20, y: 9, heading: 0 });
    expect("goal" in one).toBe(false);
    expect(planned([{ x: 20, y: 9, heading: 0 }]).hash).toBe(one.hash);
  });

  it("are resolved to poses", () => {
    expect(sceneGeometry(lot(SETS[0]!)).goals!.map(({ slot, entry }) => `${slot} ${entry}`)).toEqual(
      ["a", "c", "d"].flatMap((slot) => [`${slot} reverse-in`, `${slot} head-in`]),
    );
    expect(sceneGeometry(lot({ slot: "a", entry: "head-in" })).goals).toBeUndefined();
  });

  it("give paths to choose from, each with the goal that it leads to", () => {
    const planner = new Planner("hybrid", lot(SETS[0]!));
    const { goal, path, alternatives } = planner.plan({ alternatives: true });
    planner.free();
    for (const other of alternatives!)
      expect([...other.path.slice(-3)]).toEqual([other.goal!.pose.x, other.goal!.pose.y, other.goal!.pose.heading]);
    expect([...path.slice(-3)]).toEqual([goal!.pose.x, goal!.pose.y, goal!.pose.heading]);
  });

  it("are drawn with the goal that was taken", () => {
    const plan = planned(SETS[2]!),
      { pose } = plan.goal!;
    const drawn = toSVG(lot(SETS[2]!), plan),
      alone = toSVG(lot(pose), plan);
    const shown = (svg: string): string =>
      svg.replace(/<metadata>.*<\/metadata>/s, "").replaceAll(/k[0-9a-z]{10,}/g, "");
    expect(shown(drawn) === shown(alone)).toBe(true);
    expect(shown(drawn) === shown(toSVG(lot({ x: 40, y: 9, heading: 0 }), plan))).toBe(false);
  });

  it("are in the published schema, which refuses what planners refuse for its form", () => {
    const validate = new Ajv({ strict: true, allowUnionTypes: true }).compile(schema);
    for (const goal of SETS) expect(validate(lot(goal)), JSON.stringify(goal)).toBe(true);
    const broken: unknown[] = [
      [],
      [{ x: 1, y: 2 }],
      { slots: [], entry: "either" },
      { slots: "all", entry: "either" },
      { slots: ["a", "a"], entry: "either" },
      { slots: "free" },
      { slots: "free", entry: "sideways" },
      {
        region: [
          [0, 0],
          [1, 1],
        ],
      },
      { region: SETS[0], heading: 0 },
    ];
    for (const goal of broken) {
      const scene = lot(goal as Goal);
      expect(validate(scene), JSON.stringify(goal)).toBe(false);
      expect(
        messageOf(() => sceneGeometry(scene)),
        JSON.stringify(goal),
      ).toMatch(/^goal/);
    }
  });

  it("are refused where one goal is asked for", () => {
    const planner = new Planner("hybrid", lot(SETS[0]!)),
      set = "goal: must be one pose or slot, got a set of goals";
    expect(messageOf(() => planner.plan({ goal: SETS[2] as unknown as Goal }))).toBe(set);
    planner.free();
    const chinese = chineseReasons(catalogue);
    for (const goal of SETS) {
      expect(messageOf(() => new core.Planner("hybrid", lot(goal)))).toBe(
        `${set}: not in parkade/core, but in parkade`,
      );
      const refused = messageOf(() =>
        checkedScene(lot(goal), { sceneGeometry: core.sceneGeometry, packRuns, unpackRuns }),
      );
      expect(refused).toMatch(/^goal: must be one pose or slot/);
      expect(chinese(refused)).toMatch(/位姿或车位/);
    }
  });
});

describe("sets of goals on the page", () => {
  const page = (goal: Goal | GoalSet): Scenario => checkedScene(lot(goal), { sceneGeometry, packRuns, unpackRuns });
  const REGION: [number, number][] = [
    [16, 6],
    [40, 6],
    [40, 12.9],
    [16, 12.9],
  ];

  it("come back from links, files and the history as they were", async () => {
    const sets: GoalSet[] = [
      ...SETS,
      { slots: ["c", "a"], entry: "reverse-in" },
      { region: REGION },
      { region: REGION, heading: Math.PI / 2 },
      [{ x: 20, y: 9, heading: 0.25 * Math.PI }],
    ];
    for (const goal of sets) {
      const scene = page(goal);
      expect((await decodeScene(await encodeScene(scene))).goal, JSON.stringify(goal)).toEqual(goal);
      expect(checkScene(JSON.parse(JSON.stringify(scene))).goal).toEqual(goal);
      const kept = encodeHistory({ past: [page({ x: 20, y: 9, heading: 0 })], scene, future: [scene] }, "#")!;
      expect(
        decodeHistory(kept, (one) => checkedScene(one, { sceneGeometry, packRuns, unpackRuns })).scene.goal,
      ).toEqual(goal);
    }
  });

  it("are damaged links, not scenes, where their parts make no sense", () => {
    const packed = pack(page(SETS[1]!));
    for (const g of [
      ["s", 0, [9]],
      ["s", 0, ["a"]],
      ["s", "x", 0],
      ["r", 3, null],
      ["r", [0, 0], "x"],
      ["p", 7],
      ["p", [1]],
      ["q"],
    ]) {
      expect(
        messageOf(() => unpack({ ...packed, g }, ensureIds)),
        JSON.stringify(g),
      ).toMatch(/^This link is damaged/);
    }
  });

  it("are made from one goal and back, and every one of them can be planned", () => {
    const one = page({ slot: "c", entry: "head-in" }),
      { goal } = resolve(one);
    const taken = (scene: Scenario) => planned(scene.goal).goal!;
    const any = anyFreeSlot(one);
    // The goal car stays where it is until an answer leads elsewhere.
    expect([any.goal, resolve(any).goal]).toEqual([{ slots: "free", entry: "either" }, goal]);
    expect(onlyOne(any, taken(any)).goal).toEqual({ slot: "a", entry: taken(any).entry });
    expect(withEntry(any, "head-in").goal).toEqual({ slots: "free", entry: "head-in" });
    expect(flipGoal(withEntry(any, "head-in")).goal).toEqual({ slots: "free", entry: "reverse-in" });
    expect(slotsOfGoal(anyOfSlots(one, ["d", "b"])).map(({ id }) => id)).toEqual(["b", "d"]);
    const there = { x: 30, y: 9, heading: 0 },
      poses = orThere(orThere(moveGoal(one, { x: 20, y: 9, heading: 0 }), there), { ...there, x: 40 });
    expect(poses.goal).toEqual([{ x: 20, y: 9, heading: 0 }, there, { ...there, x: 40 }]);
    expect(onlyOne(poses, taken(poses)).goal).toEqual({ x: 20, y: 9, heading: 0 });
    const region = anywhereIn(poses, regionAroundGoal(moveGoal(one, there)), 0);
    expect(
      insidePolygon(
        [taken(region).pose.x, taken(region).pose.y],
        (region.goal as { region: [number, number][] }).region,
      ),
    ).toBe(true);
    expect([flipGoal(region), flipGoal(poses)]).toEqual([region, poses]);
  });

  it("lead out of a slot into its aisle", () => {
    const start = poseInSlot(lot(SETS[0]!).slots![2]!, "reverse-in", vehicleOf("sedan")),
      parked = { ...page({ x: 40, y: 9, heading: 0 }), start };
    expect(slotOfStart(page(SETS[0]!))).toBeUndefined();
    const leaving = leaveSlot(parked),
      planner = new Planner("hybrid", leaving),
      plan = planner.plan();
    planner.free();
    expect([plan.outcome, plan.metrics.directionChanges, plan.check.verdict]).toEqual(["found", 0, "ok"]);
    const body = footprint(plan.goal!.pose, vehicleOf("sedan")),
      slot = slotOutline(leaving.slots![2]!);
    expect(body.some((corner) => insidePolygon(corner, slot))).toBe(false);
  });

  it("lose a slot that is removed, and with the last one become a pose", () => {
    const both = anyOfSlots(page({ slot: "c", entry: "head-in" }), ["c", "d"]),
      { goal } = resolve(both);
    const one = removeSlot(both, "c");
    expect(one.goal).toEqual({ slots: ["d"], entry: "either" });
    expect(removeSlot(both, "a").goal).toBe(both.goal);
    expect(removeSlot(one, "d").goal).toEqual(goal);
  });
});

describe("the command", () => {
  const run = (args: string[]) => parkade(args, folder);
  const write = (goal: Goal | GoalSet): void => writeFileSync(join(folder, "lot.json"), JSON.stringify(lot(goal)));

  it("names the goal that was taken", () => {
    write(SETS[1]!);
    expect(JSON.parse(run(["plan", "lot.json"]).out).goal.slot).toBe("d");
    expect(run(["plan", "lot.json", "--format", "csv"])).toMatchObject({
      status: 0,
      err: expect.stringMatching(/^parkade: goal: d, head-in, x 34\.00 m, y /),
    });
    expect(run(["batch", "lot.json", "--out", "results.jsonl", "--quiet"]).status).toBe(0);
    expect(run(["check", "lot.json"]).out).toMatch(/^ok:/);
  });

  it("finds scenes blocked where no goal has room", () => {
    write({ slots: ["b"], entry: "either" });
    expect(run(["check", "lot.json"])).toMatchObject({
      status: 1,
      out: expect.stringContaining("goal-blocked: no slot of the goal is free"),
    });
    write([
      { x: -9, y: 9, heading: 0 },
      { x: 99, y: 9, heading: 0 },
    ]);
    expect(run(["check", "lot.json"])).toMatchObject({
      status: 1,
      out: expect.stringContaining("goal-blocked: the car overlaps border"),
    });
  });
});
