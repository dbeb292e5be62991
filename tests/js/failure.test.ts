import { beforeAll, describe, expect, it } from "vitest";
import { init, planners, Planner, scenario as given, type HybridPlan, type Plan, type PlannerId } from "parkade";
import { ensureIds } from "../../www/src/scene/model";
import { whyOf } from "../../www/src/texts/failure";
import { thingName } from "../../www/src/texts/status";
import { gapAt } from "../../www/src/scene/gap";
import { overlapAt } from "../../www/src/scene/overlap";
import { footprint, vehicleOf } from "../../www/src/scene/vehicle";
import { insidePolygon, type Point } from "../../www/src/scene/geometry";
import { emptyResult, initialState, type State } from "../../www/src/store";
import { distancesOf } from "../../www/src/view/drive";
import { failureOf, passageOf } from "../../www/src/view/failure";
import { between } from "../../www/src/view/fly";
import { alongRoad, stripOf } from "../../www/src/view/layers/lane-strip";
import { drivesCar, hasField, introduce } from "../../www/src/styles/planner-style";
import { loadChinese } from "./chinese";
import type { Scenario } from "../../www/src/scene/scenario";
const scenario = (id: string) => ensureIds(given(id));

beforeAll(async () => {
  await loadChinese();
  await init();
  introduce(planners());
});

const car = vehicleOf("paper"),
  pose = { x: 0, y: 0, heading: 0 };
const lot = (parts: Partial<Scenario>): Scenario => ({
  version: 1,
  map: { origin: [-20, -20], width: 160, height: 160, resolution: 0.25 },
  vehicle: "paper",
  start: { x: -10, y: 0, heading: 0 },
  goal: { x: 10, y: 0, heading: 0 },
  ...parts,
});
const box = (center: Point, size: Point, id = "box-1") => ({ type: "rectangle", id, center, size }) as const;

function answer(id: PlannerId, scene: Scenario): Plan {
  const planner = new Planner(id, scene),
    plan = planner.plan();
  planner.free();
  return plan;
}

function stateWith(scene: Scenario, ids: PlannerId[], lang: State["lang"] = "en"): State {
  const results = Object.fromEntries(
    ids.map((id) => [id, { ...emptyResult, status: "done" as const, plan: answer(id, scene) }]),
  );
  return { ...initialState(), scene, planners: ids, results, lang };
}

describe("how deep something reaches into the car", () => {
  it("is exact for each kind, over the nearest side", () => {
    const wall = {
      type: "wall",
      id: "wall-1",
      points: [
        [2, 1],
        [2, 6],
      ] as Point[],
      thickness: 0.2,
    } as const;
    const cells = { type: "cells", id: "cells-1", runs: [[80, 76, 4]] as [number, number, number][] } as const;
    const scene = lot({ obstacles: [box([2, 1.8], [2, 1.4]), wall, cells, box([9, 9], [1, 1], "box-2")] });
    const at = (index: number) => overlapAt(scene, { obstacle: "", index }, pose, car);
    expect(at(0)!.depth).toBeCloseTo(0.2, 9);
    // Its square cap stands half its thickness before its first point.
    expect(at(1)!.depth).toBeCloseTo(1.3 - 0.9, 9);
    expect(at(2)!.depth).toBeCloseTo(1.3 - 0.75, 9);
    expect(at(3)).toBeNull();
  });

  it("counts what stands over the boundary", () => {
    const scene = lot({ map: { origin: [0, 0], width: 40, height: 40, resolution: 0.25 } });
    const over = overlapAt(scene, { obstacle: "border", index: -1 }, { x: 5, y: 1, heading: 0 }, car)!;
    expect(over.depth).toBeCloseTo(0.3, 9);
    expect(overlapAt(scene, { obstacle: "border", index: -1 }, { x: 5, y: 5, heading: 0 }, car)).toBeNull();
  });

  it("frees the car when it moves by so much away from it", () => {
    let seed = 7;
    const random = (from: number, to: number): number =>
      from + (to - from) * ((seed = (seed * 48271) % 2147483647) / 2147483647);
    for (let round = 0; round < 300; round++) {
      const corners = [0, 1, 2].map((): Point => [random(-4, 7), random(-4, 4)]),
        place = { x: random(-1, 1), y: random(-1, 1), heading: random(-3, 3) };
      const scene = lot({ obstacles: [{ type: "polygon", id: "polygon-1", points: corners }] }),
        owner = { obstacle: "polygon-1", index: 0 };
      const found = overlapAt(scene, owner, place, car);
      const inside =
        footprint(place, car).some((corner) => insidePolygon(corner, corners)) ||
        corners.some((corner) => insidePolygon(corner, footprint(place, car)));
      if (inside) expect(found, `round ${round}`).not.toBeNull();
      if (!found) continue;
      const k = 1 + 1e-6,
        moved = {
          ...place,
          x: place.x + k * (found.to[0] - found.from[0]),
          y: place.y + k * (found.to[1] - found.from[1]),
        };
      expect(Math.hypot(found.to[0] - found.from[0], found.to[1] - found.from[1])).toBeCloseTo(found.depth, 9);
      // Another part may come in over the other sides, but nothing stays over this one beyond what stood within.
      const after = overlapAt(scene, owner, moved, car);
      expect(
        after?.shared.some((p) =>
          found.shared.some(
            (q) => Math.hypot(p[0] - q[0], p[1] - q[1]) < 1e-9 && insidePolygon(p, footprint(moved, car, -1e-6)),
          ),
        ) ?? false,
        `round ${round}`,
      ).toBe(false);
    }
  });
});

describe("the gap", () => {
  it("is as wide as it is drawn, not as the cells put it", () => {
    const scene = lot({ obstacles: [box([0, 6.25], [1, 10]), box([0, -6.27], [1, 10])] });
    expect(gapAt(scene, [0.6, 0.1], 2.4, 0.4)!.width).toBeCloseTo(2.52, 9);
    expect(gapAt(scene, [0.6, 0.1], 1, 0.4)).toBeNull();
  });
});

describe("why it fails", () => {
  it("names what the check hits first, and after how many metres", () => {
    const scene = lot({ obstacles: [box([4.4, 1.6], [1, 1], "crate")] });
    const state = stateWith(scene, ["four", "hybrid"]),
      plan = state.results["four"]!.plan!;
    const failure = failureOf(scene, plan)!,
      along = distancesOf(plan);
    expect(plan.check.firstHit!.obstacle).toBe("crate");
    expect(failure.along).toBeGreaterThan(along[plan.check.hitPoses[0]!]! - 0.11);
    expect(failure.along).toBeLessThanOrEqual(along[plan.check.hitPoses[0]!]! + 1e-6);
    // The car's front, 4.5 m ahead of its pose, meets the crate's near side at x = 3.9.
    expect(plan.check.firstHit!.pose.x + 4.5).toBeCloseTo(3.9, 1);
    expect(failure.along).toBeCloseTo(plan.check.firstHit!.pose.x - plan.path[0]!, 6);
    // Its left side passes y + 1.3, the crate reaches down to 1.1.
    expect(failure.overlap!.depth).toBeCloseTo(plan.path[1]! + 1.3 - 1.1, 6);
    expect(whyOf(state, "four")).toBe(
      "Hits “crate” after 9.3 m. Its path passes too close to obstacles for this car. Hybrid A* finds a path.",
    );
    expect(whyOf(state, "hybrid")).toBeNull();
    expect(whyOf({ ...state, lang: "zh" }, "four")).toContain("9.3 m 后撞上“crate”");
  });

  it("says that a path has corners, and where it is too tight", () => {
    const state = stateWith(lot({ goal: { x: 5, y: 9, heading: 0 } }), ["four"]);
    expect(whyOf(state, "four")).toMatch(
      /^(Turns in place after \d+\.\d m: this car needs a radius of 5\.41 m\.|Starts)/,
    );
    expect(whyOf(state, "four")).toContain("plans for the car’s shape");
  });

  it("names things by their names, else by kind and number", () => {
    const obstacles: Scenario["obstacles"] = [
      box([0, 0], [1, 1], "rectangle-1"),
      box([3, 0], [1, 1], "rectangle-2"),
      { type: "car", id: "car-1", pose },
      box([6, 0], [1, 1], "planter"),
      box([6, 0], [1, 1], "Fred’s van"),
      box([9, 0], [1, 1], "barrier-1"),
    ];
    const state = { ...initialState(), scene: lot({ obstacles, slots: [] }) };
    const name = (index: number) => thingName(state, { index, obstacle: obstacles[index]?.id ?? "border" });
    expect([0, 1, 2, 3, 4, 5, -1].map(name)).toEqual([
      "rectangle 1",
      "rectangle 2",
      "the parked car",
      "the planter",
      "“Fred’s van”",
      "barrier 1",
      "the boundary",
    ]);
  });

  it("gives every failing answer of the built-in scenes a sentence and, where it is known, a place", () => {
    for (const id of ["perpendicular", "reverse-in", "parallel", "angled", "narrow-gap", "P1", "regular-60"]) {
      const state = stateWith(scenario(id), ["four", "eight", "risk-field", "hybrid"]);
      for (const planner of state.planners) {
        const plan = state.results[planner]!.plan!,
          why = whyOf(state, planner);
        expect(why === null, `${id} ${planner}`).toBe(plan.check.drivable);
        if (why === null) continue;
        expect(why, `${id} ${planner}`).not.toMatch(/[{}]|undefined|NaN/);
        expect(failureOf(state.scene, plan), `${id} ${planner}`).not.toBeNull();
      }
    }
  });

  it("says of a corner that is too narrow how finely it was searched, and how wide passage and turn are", () => {
    // Corridors of 2.6 m for a car of 1.9 m that sweeps 3.06 m.
    const corner = (wide: number): Scenario => ({
      ...lot({}),
      vehicle: "sedan",
      start: { x: -16, y: wide / 2, heading: 0 },
      goal: { x: wide / 2, y: -14, heading: -Math.PI / 2 },
      obstacles: [
        { type: "rectangle", id: "inner", center: [-10, -10], size: [20, 20] },
        { type: "rectangle", id: "above", center: [-8, wide + 2], size: [24 + 2 * wide, 4] },
        { type: "rectangle", id: "beside", center: [wide + 2, -8], size: [4, 24 + 2 * wide] },
      ],
    });
    const scene = corner(2.6),
      plan = answer("hybrid", scene);
    expect(plan.outcome).not.toBe("found");
    const passage = passageOf(scene, plan)!;
    expect(passage.width).toBeCloseTo(2.6, 6);
    expect(passage.needed).toBeCloseTo(Math.hypot(5.5 + 0.95, 3.75) - 4.55, 9);
    const state = stateWith(scene, ["hybrid"]),
      { margin, xyResolution } = (plan as HybridPlan).member!;
    const small = (value: number): string =>
      value < 0.01 ? `${(value * 1000).toFixed(0)} mm` : `${(value * 100).toFixed(0)} cm`;
    for (const lang of ["en", "zh"] as const) {
      const why = whyOf({ ...state, lang }, "hybrid")!;
      expect(why).toContain("2.60 m");
      expect(why).toContain("2.91 m");
      if (plan.detail !== "no-room") {
        expect(why).toContain(small(margin));
        expect(why).toContain(small(xyResolution));
      }
    }
    // A passage in which the car turns as it likes, or that is open on one side, is not said to be narrow.
    expect(passageOf(corner(3.2), plan)).toBeNull();
    expect(passageOf({ ...scene, obstacles: [] }, plan)).toBeNull();
  });

  it("tells the gap of the narrow gap as it is drawn", () => {
    expect(whyOf(stateWith(scenario("narrow-gap"), ["hybrid"]), "hybrid")).toBe(
      "No way through: the gap is 2.50 m wide, the car needs 2.60 m. Widen it by 0.10 m or more.",
    );
  });
});

it("the planners of the first picture drive, or do not, as the module says", () => {
  for (const { id, family, hasRiskField } of planners())
    expect([id, drivesCar(id), hasField(id)]).toEqual([id, family === "hybrid", hasRiskField]);
});

it("a flight begins and ends at its cameras and moves evenly on the screen", () => {
  const from = { x: 0, y: 0, scale: 10 },
    to = { x: 8, y: -4, scale: 80 };
  expect(between(from, to, 0)).toEqual(from);
  const end = between(from, to, 1);
  expect([end.x, end.y, end.scale]).toEqual([8, -4, 80].map((n) => expect.closeTo(n, 9)));
});

it("the strip over a long road tells metres along it and to the left of its middle", () => {
  const stations = [0, 10, 20].map((along) => ({ x: 0, y: along, heading: Math.PI / 2, along, left: 5, right: -3 }));
  const [s, d] = alongRoad({ stations }, [-2, 13]);
  expect([s, d]).toEqual([expect.closeTo(13, 9), expect.closeTo(1, 9)]);
});

it("the strip is laid over roads, not over wide ground", () => {
  const ground = lot({
    map: { origin: [0, 0], width: 420, height: 300, resolution: 0.5 },
    start: { x: 10, y: 4, heading: 0 },
    goal: { x: 180, y: 4, heading: 0 },
    obstacles: [],
    slots: [],
  });
  expect(stripOf(stateWith(ground, ["eight"]))).toBeNull();
  for (const id of ["road-straight", "road-curve", "road-crossing", "road-narrow"])
    expect(stripOf(stateWith(scenario(id), ["eight"])), id).not.toBeNull();
});
