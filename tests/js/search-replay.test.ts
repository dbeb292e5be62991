/** Recorded searches, walked through by the debugger, against a plain search and the planners' own counters. */
import { beforeAll, describe, expect, it } from "vitest";
import { Planner, init, scenario, type PlannerId, type PoseTrace, type Scenario, type SearchTrace } from "parkade";
import { FATE, STEP, SearchReplay } from "../../www/src/planning/search-replay";
import { traceAsJson, traceForPosthoc } from "../../www/src/planning/trace-export";
import { eventLine, pseudocode } from "../../www/src/texts/search-steps";

const WIDTH = 24,
  HEIGHT = 18,
  MAPS = 100;
const PLANNERS: PlannerId[] = [
  "four",
  "eight",
  "sixteen",
  "sixteen-bidirectional",
  "jump-point",
  "any-angle",
  "risk-field",
  "risk-field-plus",
  "dijkstra",
];

/** They have no open list. */
const SAMPLERS: PlannerId[] = ["rrt", "genetic"];

beforeAll(() => init());

/** Numbers from 0 to below 1 that a seed decides. */
function random(seed: number): () => number {
  let state = seed * 2654435761 + 1;
  return () => {
    state = (Math.imul(state ^ (state >>> 15), state | 1) + 0x6d2b79f5) | 0;
    return ((state ^ (state >>> 14)) >>> 0) / 4294967296;
  };
}

/** A map of cells of one metre, a quarter of them blocked. */
function randomScene(seed: number): Scenario {
  const next = random(seed);
  const start = [Math.floor(next() * WIDTH), Math.floor(next() * HEIGHT)] as const,
    goal = [Math.floor(next() * WIDTH), Math.floor(next() * HEIGHT)] as const;
  const runs: [number, number, number][] = [];
  for (let y = 0; y < HEIGHT; y++)
    for (let x = 0; x < WIDTH; x++) {
      const isEnd = (x === start[0] && y === start[1]) || (x === goal[0] && y === goal[1]);
      if (next() < 0.25 && !isEnd) runs.push([x, y, 1]);
    }
  const pose = ([x, y]: readonly [number, number]) => ({ x: x + 0.5, y: y + 0.5, heading: 0 });
  return {
    version: 1,
    map: { origin: [0, 0], width: WIDTH, height: HEIGHT, resolution: 1 },
    obstacles: [{ type: "cells", runs }],
    slots: [],
    vehicle: "paper",
    start: pose(start),
    goal: pose(goal),
  } as Scenario;
}

function recorded(planner: PlannerId, scene: Scenario, limit = 100_000) {
  const made = new Planner(planner, scene);
  try {
    const plan = made.plan({ trace: "full", traceLimit: limit });
    if (plan.trace?.kind !== "search") throw new Error(`${planner} gave no recording`);
    const blocked = made.layer("occupancy").data as Uint8Array;
    return { plan, trace: plan.trace as SearchTrace, blocked };
  } finally {
    made.free();
  }
}

function recordedPoses(planner: PlannerId, id: string, settings = {}, traceLimit = 100_000): PoseTrace {
  const made = new Planner(planner, scenario(id), settings);
  try {
    const { trace } = made.plan({ trace: "full", traceLimit });
    if (trace?.kind !== "poses") throw new Error(`${planner} on ${id} gave no recording`);
    return trace;
  } finally {
    made.free();
  }
}

/** A* as one writes it down: the nodes in order of expansion, with g, h and f. */
function plainSearch(
  blocked: Uint8Array,
  start: number,
  goal: number,
  isEight: boolean,
): [number, number, number, number][] {
  const steps = isEight
    ? [
        [1, 0],
        [1, 1],
        [0, 1],
        [-1, 1],
        [-1, 0],
        [-1, -1],
        [0, -1],
        [1, -1],
      ]
    : [
        [1, 0],
        [0, 1],
        [-1, 0],
        [0, -1],
      ];
  const h = (node: number): number => {
    const dx = Math.abs((node % WIDTH) - (goal % WIDTH)),
      dy = Math.abs(Math.floor(node / WIDTH) - Math.floor(goal / WIDTH));
    if (!isEight) return 1e6 * (dx + dy);
    return Number(wholeRoot(BigInt(dx * dx + dy * dy) * 10n ** 12n));
  };
  const isFree = (x: number, y: number): boolean =>
    x >= 0 && y >= 0 && x < WIDTH && y < HEIGHT && blocked[y * WIDTH + x] === 0;
  const g = new Map([[start, 0]]),
    closed = new Set<number>(),
    order: [number, number, number, number][] = [];
  let open = [{ node: start, f: h(start), age: 0 }],
    age = 1;
  while (open.length > 0) {
    const first = open.reduce((a, b) =>
      b.f < a.f || (b.f === a.f && (h(b.node) < h(a.node) || (h(b.node) === h(a.node) && b.age > a.age))) ? b : a,
    );
    open = open.filter((one) => one !== first);
    if (closed.has(first.node)) continue;
    closed.add(first.node);
    const at = g.get(first.node)!;
    order.push([first.node, at, h(first.node), first.f]);
    if (first.node === goal) return order;
    const x = first.node % WIDTH,
      y = Math.floor(first.node / WIDTH);
    for (const [dx, dy] of steps as [number, number][]) {
      const isDiagonal = dx !== 0 && dy !== 0;
      if (!isFree(x + dx, y + dy) || (isDiagonal && !(isFree(x + dx, y) && isFree(x, y + dy)))) continue;
      const target = (y + dy) * WIDTH + x + dx,
        cost = at + (isDiagonal ? 1_414_214 : 1_000_000);
      if (closed.has(target) || cost >= (g.get(target) ?? Infinity)) continue;
      g.set(target, cost);
      open.push({ node: target, f: cost + h(target), age: age++ });
    }
  }
  return order;
}

function wholeRoot(n: bigint): bigint {
  let root = BigInt(Math.floor(Math.sqrt(Number(n))));
  while (root * root > n) root--;
  while ((root + 1n) * (root + 1n) <= n) root++;
  return root;
}

const isSearched = (trace: SearchTrace): boolean => trace.nodes.length > 0;

describe("a recorded search", () => {
  it.each(["four", "eight"] as const)("of %s neighbours has the order, g, h and f of a plain search", (planner) => {
    let steps = 0;
    for (let seed = 0; seed < MAPS; seed++) {
      const { trace, blocked } = recorded(planner, randomScene(seed));
      if (!isSearched(trace)) continue;
      const cell = (pose: { x: number; y: number }): number => Math.floor(pose.y) * WIDTH + Math.floor(pose.x);
      const scene = randomScene(seed) as unknown as { start: { x: number; y: number }; goal: { x: number; y: number } };
      const plain = plainSearch(blocked, cell(scene.start), cell(scene.goal), planner === "eight");
      expect([...trace.nodes].map((node, i) => [node, trace.g[i], trace.h[i], trace.f[i]])).toEqual(plain);
      steps += plain.length;
    }
    expect(steps).toBeGreaterThan(1000);
  });

  it.each(PLANNERS)("of %s has the planner's counters, and its open list says which entry comes next", (planner) => {
    for (let seed = 0; seed < MAPS; seed++) {
      const { trace, plan } = recorded(planner, randomScene(seed));
      if (!isSearched(trace)) continue;
      const { expanded, generated, pushes, openPeak } = plan.stats;
      // Where Dijkstra's search finds no path, the planner searches once more for the nearest cell.
      if (planner !== "dijkstra") expect(trace.counters).toEqual({ expanded, generated, pushes, openPeak });
      const replay = new SearchReplay(trace);
      for (let step = 0; step < replay.steps; step++) {
        const [next] = replay.openList(replay.sideOf(step), 1);
        expect([next?.node, next?.f, next?.h]).toEqual([trace.nodes[step], trace.f[step], trace.h[step]]);
        expect(next?.g).toBe(trace.g[step]);
        expect(next?.deferred).toBe(replay.kindOf(step) === STEP.deferred);
        replay.seek(replay.endOf(step));
        expect(replay.step).toBe(step);
      }
    }
  });

  it.each(PLANNERS)("of %s is the same walked back, event by event", (planner) => {
    for (let seed = 0; seed < 12; seed++) {
      const replay = new SearchReplay(recorded(planner, randomScene(seed)).trace);
      const picture = (): string =>
        JSON.stringify(replay.sides.map((side, at) => [replay.openList(at, 1000), [...side.entry], [...side.closed]]));
      const before: string[] = [];
      for (let event = 0; event <= replay.events; event += 7) {
        replay.seek(event);
        before.push(picture());
      }
      for (let at = before.length - 1; at >= 0; at--) {
        replay.seek(7 * at);
        expect(picture()).toBe(before[at]);
      }
    }
  });

  it.each([
    ["hybrid", "perpendicular"],
    ["hybrid", "par-6.6"],
    ["hybrid-bidirectional", "L2"],
    ["hybrid-bidirectional", "road-roundabout"],
  ] as const)("of %s on %s takes the first entry of a side's open list at each step, and walks back", (planner, id) => {
    const trace = recordedPoses(planner, id);
    const replay = new SearchReplay(trace);
    expect(replay.sides).toHaveLength(planner === "hybrid" ? 1 : 2);
    expect(trace.counters.expanded).toBe(replay.steps);
    const before: string[] = [];
    for (let step = 0; step < replay.steps; step++) {
      const side = replay.sideOf(step),
        [next] = replay.openList(side, 1);
      expect([next?.node, next?.f, next?.g]).toEqual([trace.nodes[step], trace.f[step], trace.g[step]]);
      if (step % 97 === 0) before.push(JSON.stringify(replay.sides.map((one) => one.open.length)));
      replay.seek(replay.endOf(step));
    }
    expect(before.length).toBeGreaterThan(0);
    for (let step = replay.steps - 1; step >= 0; step--) {
      replay.seek(replay.endOf(step - 1));
      if (step % 97 === 0) expect(JSON.stringify(replay.sides.map((one) => one.open.length))).toBe(before.pop());
    }
    expect(replay.at).toBe(0);
  });

  it.each([
    ["metre", "road-curve"],
    ["steps", "road-curve"],
    ["paper", "road-straight"],
  ] as const)("of cost-map with costs %s has the open list's order and the plan's counters", (costs, id) => {
    const made = new Planner("cost-map", scenario(id), { costs, margin: 0 });
    const plan = made.plan({ trace: "full", traceLimit: 3000 }),
      trace = plan.trace as SearchTrace;
    made.free();
    expect(trace.oldestFirst).toBe(costs === "steps");
    const { expanded, generated, pushes, openPeak } = plan.stats;
    expect(trace.counters).toEqual({ expanded, generated, pushes, openPeak });
    const replay = new SearchReplay(trace);
    for (let step = 0; step < replay.steps; step++) {
      const [next] = replay.openList(0, 1);
      expect([next?.node, next?.f, next?.g]).toEqual([trace.nodes[step], trace.f[step], trace.g[step]]);
      replay.seek(replay.endOf(step));
    }
    expect(replay.steps).toBeGreaterThan(500);
  });

  it.each(SAMPLERS)("of %s has the planner's counters and is the same walked back", (planner) => {
    for (let seed = 0; seed < 12; seed++) {
      const { trace, plan } = recorded(planner, randomScene(seed), 300);
      if (!isSearched(trace)) continue;
      const { expanded, generated, pushes, openPeak } = plan.stats;
      expect(trace.counters).toEqual({ expanded, generated, pushes, openPeak });
      const replay = new SearchReplay(trace),
        [side] = replay.sides;
      const picture = (): string => JSON.stringify([[...side!.open].sort(), [...side!.entry], [...side!.closed]]);
      const before: string[] = [];
      for (let event = 0; event <= replay.events; event++) {
        replay.seek(event);
        before.push(picture());
      }
      for (let at = replay.events; at >= 0; at--) {
        replay.seek(at);
        expect(picture()).toBe(before[at]);
      }
      const grown = [...trace.fates].filter((fate) => fate === FATE.kept).length;
      replay.seek(replay.events);
      const ends = trace.kinds.at(-1) === STEP.goal ? 1 : 0;
      expect(side!.open).toHaveLength(1 + grown - ends);
    }
  });

  it("from both ends says where the trees of a car meet", () => {
    const { kinds, roots } = recordedPoses("hybrid-bidirectional", "road-roundabout");
    expect(kinds.some((kind) => (kind & 15) === STEP.meet)).toBe(true);
    const { start, goal } = scenario("road-roundabout");
    [start, goal as { x: number; y: number }].forEach(({ x, y }, side) => {
      expect(roots[side]!.x).toBeCloseTo(x);
      expect(roots[side]!.y).toBeCloseTo(y);
    });
  });

  const long: [string, () => SearchTrace | PoseTrace][] = [
    [
      "cells",
      () =>
        recorded("dijkstra", {
          ...randomScene(1),
          map: { origin: [0, 0], width: 160, height: 160, resolution: 1 },
          obstacles: [],
          start: { x: 0.5, y: 0.5, heading: 0 },
          goal: { x: 159.5, y: 159.5, heading: 0 },
        } as Scenario).trace,
    ],
    ["poses", () => recordedPoses("hybrid", "random-60", { heuristic: "euclid", heuristicWeight: 0.1 }, 14_000)],
  ];
  it.each(long)("of a hundred thousand events over %s takes no more memory, walked back and forth", (_, make) => {
    const replay = new SearchReplay(make());
    expect(replay.events).toBeGreaterThan(100_000);
    const held = (): number =>
      Object.values(replay as object).reduce(
        (sum: number, part: unknown) => sum + (ArrayBuffer.isView(part) ? part.byteLength : 0),
        0,
      );
    const bytes = held(),
      [first] = replay.openList(0, 12);
    for (let round = 0; round < 2; round++) {
      replay.seek(replay.events);
      expect(held()).toBe(bytes);
      replay.seek(0);
    }
    expect(held()).toBe(bytes);
    expect(replay.openList(0, 12)).toEqual([first]);
  });

  it("stops at its limit and says so", () => {
    const scene = randomScene(3),
      whole = recorded("four", scene).trace,
      part = recorded("four", scene, 5).trace;
    expect(whole.cut).toBe(false);
    expect(part.cut).toBe(whole.nodes.length > 5);
    expect([...part.nodes]).toEqual([...whole.nodes].slice(0, 5));
  });

  it("refuses limits that are none, and leaves planners without an open list their own trace", () => {
    const made = new Planner("four", randomScene(3));
    for (const traceLimit of [0, 1.5, 1_000_001, "7"])
      expect(() => made.plan({ trace: "full", traceLimit: traceLimit as number })).toThrow(
        /^traceLimit: must be a whole number from 1/,
      );
    expect(() => made.plan({ trace: "most" as "full" })).toThrow(/^trace: /);
    made.free();
  });
});

describe("words", () => {
  it("name the reason of each move and light one line of the pseudocode", () => {
    const seen = new Set<number>();
    for (const planner of [...PLANNERS, ...SAMPLERS]) {
      const replay = new SearchReplay(recorded(planner, randomScene(5), 500).trace);
      for (let event = 0; event <= replay.events; event++) {
        replay.seek(event);
        if (replay.move >= 0) seen.add(replay.trace.fates[replay.move]! & 15);
        for (const lang of ["en", "zh"] as const) expect(eventLine(lang, replay, true)).toMatch(/\S{2}/);
        expect(pseudocode("en", replay, true).filter(({ current }) => current)).toHaveLength(1);
      }
    }
    const { leftOut, requeued, ...common } = FATE;
    for (const fate of Object.values(common)) expect(seen).toContain(fate);
    expect(requeued + leftOut).toBe(15);
  });
});

describe("files", () => {
  it("are JSON with every column, and events as Posthoc reads them", () => {
    const { trace } = recorded("eight", randomScene(5));
    const plain = JSON.parse(traceAsJson("eight", trace)) as Record<string, unknown>;
    expect(plain).toMatchObject({ format: "parkade-search", version: 1, planner: "eight", nodes: [...trace.nodes] });
    const { version, views, events } = JSON.parse(traceForPosthoc(trace)) as {
      version: string;
      views: { main: object[] };
      events: { type: string; id: number; pId?: number | null; x: number; y: number; f?: number }[];
    };
    expect(version).toBe("1.4.0");
    expect(views.main).toHaveLength(1);
    expect(events[0]).toMatchObject({ type: "source", id: trace.nodes[0] });
    expect(events.filter(({ type }) => type === "expanding" || type === "end").map(({ id }) => id)).toEqual([
      ...trace.nodes,
    ]);
    for (const { id, x, y } of events) expect(id).toBe((HEIGHT - 1 - y) * WIDTH + x);
  });
});
