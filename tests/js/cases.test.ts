import { beforeAll, describe, expect, it } from "vitest";
import {
  defaultConfig,
  init,
  paperParkingRows,
  Planner,
  scenario,
  scenarios,
  sceneGeometry,
  stopWaitGo,
  type Plan,
  type PlannerId,
  type Scenario,
} from "parkade";
import { captionOf, CASES, PRINTED, questionOf } from "../../www/src/panels/planner-showcases";

const solved = new Map<string, Plan>();

function answer(planner: PlannerId, scene: string): Plan {
  const key = `${planner} ${scene}`;
  if (!solved.has(key)) {
    const one = new Planner(planner, scenario(scene));
    solved.set(key, one.plan());
    one.free();
  }
  return solved.get(key)!;
}

const expanded = (planner: PlannerId, scene: string): number => answer(planner, scene).stats.expanded;
const metres = (planner: PlannerId, scene: string): number => answer(planner, scene).metrics.length;

/** What the questions take for granted. */
const CLAIMS: Record<string, () => boolean> = {
  "four best": () =>
    answer("four", "road-straight").check.drivable &&
    metres("four", "road-straight") === metres("hybrid", "road-straight"),
  "four worst": () => metres("four", "parallel") > 1.2 * metres("eight", "parallel"),
  "eight best": () =>
    metres("eight", "road-straight") === metres("four", "road-straight") &&
    expanded("eight", "road-straight") === expanded("four", "road-straight"),
  "eight worst": () => expanded("eight", "P0") > 1000 && !answer("eight", "P0").check.drivable,
  "sixteen best": () => 10 * expanded("sixteen", "L4") < expanded("eight", "L4"),
  "sixteen worst": () => expanded("sixteen", "reverse-in") > 500,
  "twenty-four best": () => expanded("twenty-four", "L4") < 50 && Math.abs(metres("twenty-four", "L4") - 19) < 0.5,
  "twenty-four worst": () => expanded("twenty-four", "regular-60") > 0.9 * expanded("sixteen", "regular-60"),
  "forty-eight best": () =>
    metres("forty-eight", "L4") < metres("twenty-four", "L4") &&
    metres("forty-eight", "L4") > 0.99 * metres("twenty-four", "L4"),
  "forty-eight worst": () => expanded("forty-eight", "regular-60") > 100,
  "sixteen-bidirectional best": () =>
    2 * expanded("sixteen-bidirectional", "reverse-in") < expanded("sixteen", "reverse-in"),
  "sixteen-bidirectional worst": () =>
    expanded("sixteen-bidirectional", "trap-60") > 0.6 * expanded("sixteen", "trap-60"),
  "jump-point best": () => expanded("jump-point", "L4") === 2 && Math.abs(metres("jump-point", "L4") - 20) < 0.5,
  "jump-point worst": () => expanded("jump-point", "regular-60") > 50,
  "any-angle best": () => metres("any-angle", "P3") < 1.005 * Math.hypot(18, 13),
  "any-angle worst": () => expanded("any-angle", "trap-60") > 100,
  "risk-field best": () => 20 * expanded("risk-field", "P4") < expanded("eight", "P4"),
  "risk-field worst": () => answer("risk-field", "narrow-gap").outcome === "no-path",
  "risk-field-plus best": () => expanded("risk-field-plus", "P4") === 1,
  "risk-field-plus worst": () => expanded("risk-field-plus", "trap-60") > expanded("risk-field", "trap-60"),
  "hybrid best": () => expanded("hybrid", "angled") < 100,
  "hybrid worst": () =>
    answer("hybrid", "par-7.2").metrics.directionChanges > 3 && Math.abs(spare("par-7.2") - 1.7) < 1e-9,
  "hybrid-forward best": () => expanded("hybrid-forward", "L3") === 1,
  "hybrid-forward worst": () => expanded("hybrid-forward", "perp-nose-3.2") > 10_000,
  "hybrid-bidirectional best": () =>
    expanded("hybrid-bidirectional", "perp-nose-3.2") < 50 && expanded("hybrid-forward", "perp-nose-3.2") > 10_000,
  "hybrid-bidirectional worst": () => expanded("hybrid-bidirectional", "par-7.2") > expanded("hybrid", "par-7.2"),
  "hybrid-classic best": () => expanded("hybrid-classic", "L3") === 1,
  "hybrid-classic worst": () =>
    defaultConfig("hybrid-classic")["motionPrimitiveLength"] === 3.1 &&
    answer("hybrid-classic", "regular-60").outcome === "no-path",
  "cost-map best": () => answer("cost-map", "road-crossing").check.verdict === "ok",
  "cost-map worst": () => !answer("cost-map", "reverse-in").check.drivable,
  "dijkstra best": () =>
    metres("dijkstra", "road-straight") === metres("eight", "road-straight") &&
    expanded("dijkstra", "road-straight") > 3 * expanded("eight", "road-straight"),
  "dijkstra worst": () =>
    Math.round(expanded("dijkstra", "random-60") / 1000) === 3 &&
    expanded("dijkstra", "random-60") > 2 * expanded("eight", "random-60"),
  "greedy best": () => expanded("greedy", "road-straight") === expanded("eight", "road-straight"),
  "greedy worst": () => metres("greedy", "trap-60") > 1.1 * metres("eight", "trap-60"),
  "rrt best": () => answer("rrt", "perpendicular").outcome === "found" && expanded("rrt", "perpendicular") < 60,
  "rrt worst": () => expanded("rrt", "road-curve") > 2000,
  "genetic best": () => metres("genetic", "P4") < metres("eight", "P4"),
  "genetic worst": () =>
    answer("genetic", "fig9-100").outcome === "budget-spent" && expanded("genetic", "fig9-100") === 20_000,
};

const car = (scene: Scenario) => sceneGeometry(scene).vehicle;
/** The bay's width in the parking paper's lot. */
const bay = (id: string): number => {
  const corners = scenario(id).map.boundary!;
  return corners[4]![0] - corners[1]![0];
};
/** How much longer a bay is than the car. */
const spare = (id: string): number => bay(id) - car(scenario(id)).rearToFront - car(scenario(id)).rearToBack;
const box = (id: string) => scenario(id).moving![0]!;
const waited = (id: string): number => {
  const met = stopWaitGo(scenario(id), answer("hybrid", id));
  return met.waits.reduce((sum, { from, to }) => sum + to - from, 0);
};
const FEATURED: PlannerId[] = ["four", "eight", "risk-field", "hybrid"],
  ON_ROADS: PlannerId[] = ["cost-map", "eight", "risk-field", "hybrid"];
const verdicts = (id: string, planners = FEATURED): string[] => planners.map((one) => answer(one, id).check.verdict);
const least = (id: string, of: (planner: PlannerId, id: string) => number): PlannerId =>
  FEATURED.reduce((a, b) => (of(b, id) < of(a, id) ? b : a));

/** What the gallery's captions say in words, and the figures in them. */
const CAPTIONS: Record<string, readonly [holds: () => boolean, ...figures: (() => number)[]]> = {
  perpendicular: [() => verdicts("perpendicular").join() === "collides,collides,arrives-turned,ok"],
  "reverse-in": [
    () =>
      verdicts("reverse-in").join() === "collides,collides,collides,ok" &&
      answer("hybrid", "reverse-in").metrics.directionChanges === 1,
  ],
  parallel: [
    () =>
      answer("hybrid", "parallel").metrics.directionChanges === 0 &&
      verdicts("parallel").join() === "collides,collides,collides,ok",
    () => bay("parallel"),
  ],
  angled: [
    () =>
      answer("hybrid", "angled").metrics.directionChanges === 0 &&
      verdicts("angled").join() === "collides,collides,too-tight,ok",
  ],
  "narrow-gap": [
    () => verdicts("narrow-gap").join() === "collides,collides,none,none",
    () => 100 * (car(scenario("narrow-gap")).width - gap("narrow-gap")),
  ],
  "regular-60": [
    () => least("regular-60", expanded) === "risk-field" && !answer("risk-field", "regular-60").check.drivable,
  ],
  "random-60": [
    () =>
      least("random-60", metres) === "risk-field" && verdicts("random-60").join() === "collides,collides,collides,ok",
  ],
  "trap-60": [() => expanded("eight", "trap-60") > 10 * expanded("risk-field", "trap-60")],
  "par-8.0": [() => answer("hybrid", "par-8.0").check.drivable, () => spare("par-8.0")],
  "par-7.2": [
    () => answer("hybrid", "par-7.2").metrics.directionChanges > answer("hybrid", "par-8.0").metrics.directionChanges,
    () => spare("par-7.2"),
  ],
  "par-6.6": [() => answer("hybrid", "par-6.6").outcome === "found", () => spare("par-6.6")],
  "perp-tail-3.2": [
    () => answer("hybrid", "perp-tail-3.2").check.drivable,
    () => (bay("perp-tail-3.2") - car(scenario("perp-tail-3.2")).width) / 2,
  ],
  "perp-nose-3.2": [
    () => answer("hybrid", "perp-nose-3.2").check.drivable,
    () => (bay("perp-nose-3.2") - car(scenario("perp-nose-3.2")).width) / 2,
  ],
  "park-free": [
    () => !scenario("park-free").obstacles?.length && answer("hybrid", "park-free").metrics.directionChanges === 0,
    () => 12,
  ],
  "park-fig13": [
    () =>
      scenario("park-fig13").obstacles!.length === 1 && metres("hybrid", "park-fig13") > metres("hybrid", "P0") + 0.5,
    () => 13,
  ],
  "fig16-wait": [() => waited("fig16-wait") > 1],
  fig16: [() => waited("fig16") === 0 && metres("hybrid", "fig16") < PRINTED.L0![2]],
  "fig16-conflict": [() => waited("fig16-conflict") > 0, () => box("fig16-conflict").speed],
  "fig16-oncoming": [
    () => waited("fig16-oncoming") > 0,
    () => scenario("fig16-oncoming").start.y - box("fig16-oncoming").points[0]![1],
  ],
  // The car drives west at first, the box east.
  "fig16-fast": [
    () =>
      box("fig16-fast").points[1]![0] > box("fig16-fast").points[0]![0] &&
      Math.cos(scenario("fig16-fast").start.heading) < -0.99 &&
      box("fig16-fast").speed === 2 * box("fig16").speed &&
      MOVING.every((id) => waited(id) <= waited("fig16-fast")),
  ],
  "fig16-low": [() => MOVING.every((id) => waited(id) >= waited("fig16-low"))],
  "road-straight": [
    () =>
      !scenario("road-straight").obstacles?.length &&
      expanded("hybrid", "road-straight") < expanded("eight", "road-straight"),
  ],
  "road-curve": [
    () =>
      scenario("road-curve").lanes![0]!.pieces.filter(({ curvature }) => curvature !== 0).length === 2 &&
      scenario("road-curve").obstacles!.length === 2 &&
      verdicts("road-curve", ON_ROADS).join() === "ok,collides,collides,ok",
  ],
  "road-crossing": [
    () =>
      scenario("road-crossing").obstacles!.filter(({ id }) => id?.startsWith("barrier")).length === 5 &&
      verdicts("road-crossing", ON_ROADS).join() === "ok,collides,collides,ok",
  ],
  "road-narrow": [
    () =>
      scenario("road-narrow").obstacles!.length === 8 &&
      verdicts("road-narrow", ON_ROADS).join() === "ok,collides,collides,ok",
    () =>
      Math.max(...scenario("road-narrow").map.boundary!.map(([, y]) => y)) -
      Math.max(...scenario("road-narrow").obstacles!.map((one) => (one.type === "rectangle" ? one.size[1] : 0))),
  ],
};
/** Without what bans the shorter way. */
const unbanned = (id: string, ban: string): number => {
  const scene = scenario(id),
    planner = new Planner("cost-map", { ...scene, obstacles: scene.obstacles!.filter((one) => one.id !== ban) });
  try {
    return planner.plan().metrics.length;
  } finally {
    planner.free();
  }
};
CAPTIONS["road-roundabout"] = [
  () =>
    verdicts("road-roundabout", ["cost-map", "hybrid"]).join() === "ok,ok" &&
    unbanned("road-roundabout", "against the ring") < metres("cost-map", "road-roundabout") - 10,
];
CAPTIONS["road-turn-ban"] = [
  () =>
    verdicts("road-turn-ban", ["cost-map", "hybrid"]).join() === "ok,ok" &&
    unbanned("road-turn-ban", "no left turn") < metres("cost-map", "road-turn-ban") - 50,
];
const NARROW = ["perp-tail-3.6", "perp-tail-3.0", "perp-nose-3.6", "perp-nose-3.0"];
for (const id of NARROW)
  CAPTIONS[id] = [
    () => answer("hybrid", id).check.drivable && answer("hybrid", id).metrics.directionChanges === 1,
    () => (bay(id) - car(scenario(id)).width) / 2,
  ];
/** The planners of the risk-field paper's figures 8 and 9, each with its safety space. */
const FIGURES = ["fig8-30", "fig8-60", "fig8-100", "fig9-30", "fig9-60", "fig9-100"];
for (const id of FIGURES)
  CAPTIONS[id] = [
    () => FEATURED.every((one) => answer(one, id).outcome === "found") && least(id, expanded) !== "eight",
  ];
const MOVING = ["fig16-conflict", "fig16-oncoming", "fig16-fast", "fig16-low"];
/** What the two walls of a scene leave between them. */
function gap(id: string): number {
  const [south, north] = scenario(id).obstacles!.map((one) =>
    one.type === "rectangle" ? [one.center[1] - one.size[1] / 2, one.center[1] + one.size[1] / 2] : [],
  );
  return north![0]! - south![1]!;
}

beforeAll(() => init());

describe("captions of the gallery", () => {
  it("are each scene's own, in both languages", () => {
    for (const lang of ["en", "zh"] as const) {
      for (const texts of [
        scenarios().map((one) => captionOf(one, lang)),
        scenarios().map((one) => one.title[lang]),
        CASES.flatMap(([, both]) => [both.best, both.worst].map((one) => questionOf(lang, one))),
      ]) {
        expect(texts.filter((text, at) => texts.indexOf(text) !== at)).toEqual([]);
        expect(texts.length).toBeGreaterThan(25);
      }
    }
  });

  it("exist for scenes that there are", () => {
    expect(
      scenarios()
        .filter(({ group }) => group !== "paper")
        .map(({ id }) => id)
        .sort(),
    ).toEqual(Object.keys(CAPTIONS).sort());
  });

  for (const [id, [holds, ...figures]] of Object.entries(CAPTIONS)) {
    it(`${id}: says what its plans do, with their figures`, () => {
      expect(holds()).toBe(true);
      for (const lang of ["en", "zh"] as const) {
        const stated = [
          ...captionOf(scenarios().find((one) => one.id === id)!, lang).matchAll(/(?<![A-Za-z])\d+(?:\.\d+)?/g),
        ].map(([text]) => text);
        expect(stated.map(String)).toEqual(
          figures.map((figure, i) => figure().toFixed(stated[i]?.split(".")[1]?.length ?? 0)),
        );
      }
    });
  }

  it("P1 touches the wall at its start, and no other row does", () => {
    const touching = scenarios()
      .filter((one) => one.group === "paper" && /touches the wall/.test(captionOf(one, "en")))
      .map(({ id }) => id);
    expect(touching).toEqual(["P1"]);
    for (const { id, group } of scenarios())
      if (group === "paper") {
        const { start, map } = scenario(id),
          right = Math.max(...map.boundary!.map(([x]) => x));
        expect(Math.abs(start.x + car(scenario(id)).rearToBack - right) < 1e-9, id).toBe(touching.includes(id));
      }
  });
});

describe("best and worst cases", () => {
  for (const [planner, { best, worst }] of CASES) {
    it(`${planner} does what its captions say`, () => {
      for (const [which, claim] of Object.entries(CLAIMS)) {
        if (which.split(" ")[0] === planner) expect(claim(), which).toBe(true);
      }
      const { verdict } = answer(planner, best.scene).check;
      expect(
        verdict !== "none" && (verdict !== "collides" || /does the car fit/.test(questionOf("en", best))),
        `${best.scene}: ${verdict}`,
      ).toBe(true);
      expect(worst.scene).not.toBe(best.scene);
    }, 60_000);
  }

  it("each caption has its claim", () => {
    expect(Object.keys(CLAIMS).sort()).toEqual(
      CASES.flatMap(([planner]) => [`${planner} best`, `${planner} worst`]).sort(),
    );
  });
});

it("a paper row's caption has the printed numbers, each its own", () => {
  expect(PRINTED).toEqual(
    Object.fromEntries(
      paperParkingRows().map(({ id, traditional, improved }) => [
        id,
        [traditional.length, traditional.changes, improved.length, improved.changes],
      ]),
    ),
  );
});
