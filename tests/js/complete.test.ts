import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import {
  type Narrowest,
  Planner,
  checkPath,
  generateScenario,
  init,
  paperGrid,
  paperGridRows,
  paperGridSummary,
  paperParking,
  paperParkingRows,
  planners,
  scenario,
} from "parkade";
import messages from "../../www/src/i18n/messages/claims.json";
import { core } from "./core";
import { failure } from "./refused";

beforeAll(() => Promise.all([init(), core.init()]));

const untyped = (value: unknown) => value as never;

describe("explain", () => {
  test("tells force, region and candidates of a cell", () => {
    const planner = new Planner("risk-field", generateScenario({ family: "regular", size: 30, seed: 0 }));
    const told = planner.explain({ x: 0.2, y: -0.3 })!;
    expect(told).toMatchObject({ cell: [0, 0], mode: "oblique", region: "2", center: 1 });
    expect(told.slope).toBeCloseTo(1, 9);
    expect(
      told.candidates.filter((candidate) => candidate.role === "primary").map((candidate) => candidate.direction),
    ).toEqual(["NE", "N", "E"]);
    expect(
      told.candidates.filter((candidate) => candidate.role === "extension").map((candidate) => candidate.cell),
    ).toEqual([[2, 2]]);
    expect(told.candidates).toHaveLength(9);
    expect(planner.explain({ x: 3, y: 3 })).toBeNull();
    expect(planner.explain({ x: -9, y: 3 })).toBeNull();
    expect(failure(() => planner.explain(untyped({ x: "a", y: 3 })))).toEqual({ code: "bad-input", path: "at.x" });
    planner.free();
    const eight = new Planner("eight", scenario("regular-60"));
    expect(failure(() => eight.explain({ x: 0, y: 0 }))).toEqual({ code: "bad-input", path: "planner" });
    eight.free();
    const small = new core.Planner("risk-field", scenario("regular-60"));
    expect(() => small.explain({ x: 0, y: 0 })).toThrow("core");
    small.free();
  });
});

describe("the paper's tables", () => {
  test("are measured in slices that add up", () => {
    const { rows, planners, columns } = paperGridRows();
    expect(rows.map((row) => row.id)).toContain("regular-30");
    const whole = paperGrid({ row: "regular-30", from: 1, to: 4 });
    const [low, high] = [
      paperGrid({ row: "regular-30", from: 1, to: 2 }),
      paperGrid({ row: "regular-30", from: 3, to: 4 }),
    ];
    const timeless = (figures: Float64Array) =>
      [...figures].filter((_, i) => columns[i % columns.length] !== "milliseconds");
    expect(whole).toHaveLength(4 * planners.length * columns.length);
    expect(timeless(whole)).toEqual([...timeless(low!), ...timeless(high!)]);
    const {
      tables: [table],
      claims,
    } = paperGridSummary({ "regular-30": whole });
    expect(table).toMatchObject({ maps: 4, row: { id: "regular-30", table: 3 } });
    expect(table!.lines.find((line) => line.planner === "risk-field")).toMatchObject({
      printedNodes: 81,
      impossible: false,
    });
    expect(claims.every((claim) => claim.holds === "unknown")).toBe(true);
    for (const { id, figures } of claims) {
      const said = messages[`claim.${id}.found` as keyof typeof messages];
      for (const text of said) {
        const places = [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name!);
        expect(places.toSorted(), id).toEqual(Object.keys(figures).toSorted());
      }
    }
  });

  test("name what is wrong", () => {
    expect(failure(() => paperGrid({ row: "regular-31", from: 1, to: 2 }))).toEqual({ code: "bad-input", path: "row" });
    expect(failure(() => paperGrid({ row: "regular-30", from: 2, to: 1 }))).toEqual({ code: "bad-input", path: "to" });
    expect(failure(() => paperGrid({ row: "regular-30", from: 0.5, to: 1 }))).toEqual({
      code: "bad-input",
      path: "from",
    });
    expect(failure(() => paperGridSummary({ "regular-30": new Float64Array(3) }))).toEqual({
      code: "bad-input",
      path: "regular-30.figures",
    });
    expect(failure(() => paperGridSummary(untyped({ "regular-30": [1] })))).toEqual({
      code: "bad-input",
      path: "regular-30",
    });
  });

  test("a row of the parking paper is planned in its rounding, impossible lengths are marked", () => {
    const rows = paperParkingRows();
    expect(rows.map((row) => row.id)).toEqual(["P0", "P1", "P2", "P3", "P4", "L0", "L1", "L2", "L3", "L4"]);
    const table = paperParking({ row: "L3" });
    expect(table.row).toEqual(rows[8]);
    expect([table.impossible, table.kept, table.row.improved.length]).toEqual([[false, true], true, 20.2]);
    expect(table.lines.map((line) => line.planner)).toEqual([
      "hybrid-forward",
      "hybrid",
      "hybrid-bidirectional",
      "hybrid-classic",
    ]);
    const ours = table.lines[1]!;
    expect(ours).toMatchObject({ verdict: "ok", changes: 0, nodes: Math.round(ours.length * 10) + 1 });
    expect(ours.time * 2).toBeCloseTo(ours.length, 9);
    expect(ours.exact).toBeGreaterThanOrEqual(table.bound - 1e-6);
    expect(failure(() => paperParking({ row: "L5" }))).toEqual({ code: "bad-input", path: "row" });
    expect(failure(() => paperParking({ row: "L3", rounds: 0 }))).toEqual({ code: "bad-input", path: "rounds" });
  });
});

describe("the risk field's settings", () => {
  const options = () => {
    const { parameters } = planners().find((planner) => planner.id === "risk-field")!;
    return parameters.flatMap(({ name, choices, type }) =>
      (type === "boolean" ? [false, true] : type === "choice" ? choices! : []).map((value) => [name, value] as const),
    );
  };

  test("are all reachable, alone and with every other", () => {
    const scene = generateScenario({ family: "random", size: 30, seed: 1 });
    const all = options();
    expect(all.map(([name]) => name)).toEqual(
      expect.arrayContaining([
        "heuristic",
        "attraction",
        "obstacleSet",
        "fallback",
        "goalSide",
        "goalShot",
        "post",
        "smoothMode",
      ]),
    );
    for (const [name, value] of all) {
      for (const [other, choice] of all) {
        const planner = new Planner("risk-field", scene, { extLen: 2, [name]: value, [other]: choice });
        const { outcome, detail } = planner.plan();
        if (outcome !== "found")
          expect([
            outcome,
            detail,
            [value, choice].some((v) => v === "none" || v === "stuck-only" || v === "half-diagonal" || v === "width"),
          ]).toEqual([outcome, detail, true]);
        planner.free();
      }
    }
  });

  test("of `risk-field-plus` and `risk-field` give the golden counts", () => {
    const golden = JSON.parse(readFileSync(new URL("../data/grid-golden-vectors.json", import.meta.url), "utf8")).maps;
    for (const { family, n, seed, params, ...record } of golden) {
      const fields =
        family === "random"
          ? { densityPermille: params.density_permille, blockMin: params.block_min, blockMax: params.block_max }
          : {};
      const scene = generateScenario(untyped({ family, size: n, seed, ...fields }));
      for (const [id, want] of [
        ["risk-field", record.risk],
        ["risk-field-plus", record.risk_plus],
      ] as const) {
        const planner = new Planner(id, scene);
        const { stats, metrics } = planner.plan();
        expect([stats.costMicro, stats.expanded, stats.generated], `${id} ${family} ${n} ${seed}`).toEqual([
          want.cost_micro,
          want.expanded,
          want.generated,
        ]);
        expect(metrics.lengthDp).toBeCloseTo(want.length_dp, 5);
        planner.free();
      }
    }
  });
});

describe("a planner", () => {
  test("tells where its path is narrowest, and by what", () => {
    const owners = new Set<string>();
    const room = ({ body, point }: Narrowest): number => Math.hypot(body[0] - point[0], body[1] - point[1]);
    for (const id of ["perpendicular", "parallel", "angled"]) {
      const plain = scenario(id),
        slots = plain.slots ?? [];
      const scene = { ...plain, obstacles: (plain.obstacles ?? []).map((one, i) => ({ ...one, id: `thing ${i}` })) };
      const planner = new Planner("hybrid", scene),
        { check, clearances, metrics, path, directions } = planner.plan(),
        narrowest = check.narrowest!;
      planner.free();
      expect(clearances[narrowest.pose]).toBe(metrics.minClearance);
      expect(clearances.length).toBe(path.length / 3);
      expect(room(narrowest)).toBeCloseTo(metrics.minClearance, 6);
      const { obstacle, index } = narrowest,
        taken = slots.findIndex(({ id }) => id === obstacle);
      const among = (keep: (owner: string) => boolean): Narrowest => {
        const obstacles = scene.obstacles.filter(({ id }) => keep(id)),
          others = slots.map((slot) => ({ ...slot, occupied: slot.occupied === true && keep(slot.id!) }));
        return checkPath({ ...scene, obstacles, slots: others }, path, directions).narrowest!;
      };
      // Alone it leaves as little room, and without it there is more.
      expect(room(among((owner) => owner === obstacle))).toBeCloseTo(metrics.minClearance, 6);
      if (obstacle !== "border")
        expect(room(among((owner) => owner !== obstacle))).toBeGreaterThan(metrics.minClearance);
      expect(obstacle).toBe(index >= 0 ? `thing ${index}` : taken >= 0 ? slots[taken]!.id : "border");
      owners.add(obstacle);
    }
    expect(owners.size).toBeGreaterThan(1);
    // Where something is overlapped there is no narrowest place.
    const hit = new Planner("four", scenario("perpendicular")),
      { check } = hit.plan();
    hit.free();
    expect([check.verdict, check.narrowest]).toEqual(["collides", undefined]);
  });

  test("takes over the last path of another planner, and of nothing else", () => {
    const scene = scenario("perpendicular"),
      [one, other] = [new Planner("hybrid", scene), new Planner("hybrid", scene)];
    const { hash } = one.plan();
    other.continueFrom(one);
    expect(other.plan().hash).toBe(hash);
    expect(failure(() => one.continueFrom(one))).toEqual({ code: "bad-input", path: "before" });
    expect(failure(() => one.continueFrom(untyped({})))).toEqual({ code: "bad-input", path: "before" });
    const chosen = one.plan({ prefer: "widest" });
    expect(chosen.metrics.minClearance).toBeGreaterThan(one.plan().metrics.minClearance + 0.1);
    other.continueFrom(chosen);
    const kept = other.plan({ prefer: "widest", stickiness: 0.03 });
    expect([kept.metrics.length, kept.metrics.minClearance]).toEqual([
      expect.closeTo(chosen.metrics.length, 6),
      expect.closeTo(chosen.metrics.minClearance, 6),
    ]);
    expect(failure(() => other.continueFrom(untyped({ ...chosen, directions: chosen.directions.slice(1) })))).toEqual({
      code: "bad-input",
      path: "before",
    });
    other.free();
    expect(failure(() => one.continueFrom(other))).toEqual({ code: "freed", path: "" });
    one.free();
  });
});
