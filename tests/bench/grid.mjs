// `cargo xtask bench grid`: grid planners through the built package against others, interleaved in one run.
//
// Usage: node grid.mjs MAPS PEERS NATIVE [count] [repeats] [goals], where MAPS holds the MovingAI files, PEERS the
// installed peers, NATIVE is the built example `movingai`; of goals, `G6,G8`, the others are kept as they were written last.
// Times are CPU times; ratios count, not milliseconds. Each rival
// has a process of its own and is asked in turn: one's garbage is not another's time.
import { execFileSync, fork } from "node:child_process";
import { once } from "node:events";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { availableParallelism, cpus, loadavg } from "node:os";
import { join } from "node:path";
import { quantile } from "../quantile.mjs";
import { generateScenario, importScene, init, Planner } from "../../pkg/node.js";
import { agrees, load, sample, walk } from "./movingai.mjs";

const [maps, peers, native, count = "20", repeats = "5", goals = "", role] = process.argv.slice(2);
const wanted = (...any) => goals === "" || any.some((goal) => goals.split(",").includes(goal));
await init();

const cpu = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};
const wall = () => performance.now();
/** Milliseconds of some work. */
function timed(work, clock = cpu) {
  const start = clock();
  work();
  return clock() - start;
}
/** Each of some works in turns; the milliseconds of each one's fastest round: what it takes when nothing disturbs. */
function fastest(rounds, works, clock = cpu) {
  const best = works.map(() => Infinity);
  for (let round = 0; round < rounds; round++) {
    for (const [k, work] of works.entries()) best[k] = Math.min(best[k], timed(work, clock));
  }
  return best;
}
const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b);
  return (sorted[(values.length - 1) >> 1] + sorted[values.length >> 1]) / 2;
};

/** Our planner on a map: asks in cells from the north, as the files do. */
function ours(map, id, config = {}) {
  const { scene } = importScene({ [`${map.name}.map`]: map.text });
  const planner = new Planner(id, scene, config);
  const { resolution, origin } = scene.map;
  const point = (x, y) => ({
    x: origin[0] + (x + 0.5) * resolution,
    y: origin[1] + (map.height - y - 0.5) * resolution,
  });
  const ask = (q) => planner.search(point(q.x0, q.y0), point(q.x1, q.y1));
  const path = ({ path: points }) =>
    points.map((v, i) =>
      i % 2 === 0
        ? Math.floor((v - origin[0]) / resolution)
        : map.height - 1 - Math.floor((v - origin[1]) / resolution),
    );
  return { ask, path, planner, point };
}

/** The lengths that one of our planners tells of its paths, where they are not the files': walks are compared with them. */
function told(map, id, config) {
  const { ask } = ours(map, id, config);
  return (q) => ask(q).costMicro / 1e6;
}

const peer = createRequire(join(peers, "package.json"));

/** PathFinding.js needs a copy of the grid for every search. */
function pathfinding(map, finder, diagonals) {
  const PF = peer("pathfinding");
  const rows = Array.from({ length: map.height }, (_, y) =>
    Array.from(map.blocked.subarray(y * map.width, (y + 1) * map.width)),
  );
  const grid = new PF.Grid(map.width, map.height, rows);
  const search = new PF[finder](
    diagonals
      ? { diagonalMovement: PF.DiagonalMovement.OnlyWhenNoObstacles, heuristic: PF.Heuristic.octile }
      : { diagonalMovement: PF.DiagonalMovement.Never, heuristic: PF.Heuristic.manhattan },
  );
  return { ask: (q) => search.findPath(q.x0, q.y0, q.x1, q.y1, grid.clone()), path: (cells) => cells.flat() };
}

function nba(map) {
  const createGraph = peer("ngraph.graph");
  const ngraph = peer("ngraph.path");
  const { width, height, blocked } = map;
  const graph = createGraph();
  const free = (x, y) => x >= 0 && y >= 0 && x < width && y < height && blocked[y * width + x] === 0;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) if (free(x, y)) graph.addNode(y * width + x, { x, y });
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      for (const [dx, dy] of [
        [1, 0],
        [0, 1],
        [1, 1],
        [-1, 1],
      ]) {
        const legal =
          free(x, y) && free(x + dx, y + dy) && (dx === 0 || dy === 0 || (free(x + dx, y) && free(x, y + dy)));
        if (legal) graph.addLink(y * width + x, (y + dy) * width + x + dx, dx !== 0 && dy !== 0 ? Math.SQRT2 : 1);
      }
  const finder = ngraph.nba(graph, {
    distance: (_a, _b, link) => link.data,
    heuristic: (a, b) => {
      const [dx, dy] = [Math.abs(a.data.x - b.data.x), Math.abs(a.data.y - b.data.y)];
      return Math.max(dx, dy) + (Math.SQRT2 - 1) * Math.min(dx, dy);
    },
  });
  return {
    ask: (q) => finder.find(q.y0 * width + q.x0, q.y1 * width + q.x1),
    path: (nodes) => nodes.reverse().flatMap((node) => [node.data.x, node.data.y]),
  };
}

function crate(map, which) {
  const module = new WebAssembly.Module(readFileSync(join(peers, "grid_peers.wasm")));
  const { exports } = new WebAssembly.Instance(module);
  const room = exports.alloc(map.blocked.length);
  new Uint8Array(exports.memory.buffer, room, map.blocked.length).set(map.blocked);
  exports.init(map.width, map.height);
  const path = () => new Uint32Array(exports.memory.buffer, exports.path(), exports.path_len()).slice();
  return { ask: (q) => (exports.query(which, q.x0, q.y0, q.x1, q.y1) ? path() : null), path: (cells) => cells };
}

/** A rival's process: answers `{ question, runs }` with its CPU time per run and what its path is worth. */
function serve(name, kind, rules) {
  const map = load(maps, name);
  const makers = { ours, pathfinding, nba, crate };
  const rival = makers[kind[0]](map, ...kind.slice(1));
  process.on("message", ({ question, runs }) => {
    const start = cpu();
    let found;
    for (let run = 0; run < runs; run++) found = rival.ask(question);
    process.send({ ms: (cpu() - start) / runs, length: walk(map, question, rival.path(found), rules) });
  });
  process.send("ready");
}

/** Asks everybody every question in turns. Returns CPU milliseconds by name: of each question's fastest round, summed. */
async function race(map, questions, rivals) {
  for (const rival of rivals) {
    const rules = { four: rival.four, cuts: rival.cuts };
    const role = JSON.stringify([map.name, rival.kind, rules]);
    rival.process = fork(process.argv[1], [maps, peers, native, count, repeats, goals, role], {
      execArgv: ["--max-old-space-size=4000"],
    });
    await once(rival.process, "message");
  }
  const ask = async (rival, question, runs) => {
    rival.process.send({ question, runs });
    return (await once(rival.process, "message"))[0];
  };
  const times = rivals.map(() => questions.map(() => []));
  // Engines compile what is called often, on threads of their own; that is not to be measured.
  for (const [k, rival] of rivals.entries()) {
    for (let spent = 0, n = 0; spent < 400 && n < 3 * questions.length; n++) {
      const q = n % questions.length;
      const runs = 8;
      const first = await ask(rival, questions[q], 1);
      times[k][q].first = first.ms;
      if (first.ms < 20) await ask(rival, questions[q], runs);
      spent += first.ms * (first.ms < 20 ? runs + 1 : 1);
    }
  }
  for (let round = 0; round < Number(repeats); round++) {
    for (const [q, question] of questions.entries()) {
      for (const k of rivals.keys()) {
        const which = (k + q + round) % rivals.length;
        const rival = rivals[which];
        const before = Math.min(times[which][q].first ?? 1, ...times[which][q]);
        // Long enough that a rival finds its caches as it left them, not as the one before it did.
        const runs = Math.max(1, Math.min(1024, Math.floor(10 / Math.max(before, 0.005))));
        const { ms, length } = await ask(rival, question, runs);
        times[which][q].push(ms);
        const expected = rival.expect?.(question) ?? question.length;
        if (rival.mine && !agrees(length, expected)) {
          throw new Error(`${map.name}: ${rival.name} answers ${length} instead of ${expected}`);
        }
        if (typeof length !== "number") throw new Error(`${map.name}: ${rival.name}: ${length}`);
      }
    }
  }
  for (const rival of rivals) rival.process.kill();
  return Object.fromEntries(rivals.map((r, k) => [r.name, times[k].reduce((sum, t) => sum + Math.min(...t), 0)]));
}

if (role !== undefined) {
  serve(...JSON.parse(role));
  await new Promise(() => undefined);
}

/** How many of the risk field's steps go beyond the cells around, on average over a map's free cells and some questions. */
function doubleSteps(map, planner, point, questions) {
  let steps = 0,
    cells = 0;
  for (const q of questions.slice(0, 4)) {
    planner.plan({
      start: { ...point(q.x0, q.y0), heading: 0 },
      goal: { ...point(q.x1, q.y1), heading: 0 },
      trace: false,
    });
    for (let k = 0; k < map.blocked.length; k += 101) {
      const explained = planner.explain(point(k % map.width, Math.floor(k / map.width)));
      if (explained === null) continue;
      cells++;
      steps += explained.candidates.filter(({ role }) => role === "extension").length;
    }
  }
  return steps / cells;
}

const rows = [];
function report(goal, map, what, value, floor, aim, unit, less = false) {
  const meets = (bound) => (less ? value <= bound : value >= bound);
  const verdict = meets(aim) ? "goal" : meets(floor) ? "floor" : "BELOW";
  const line = `${goal.padEnd(4)} ${map.padEnd(16)} ${what.padEnd(58)} ${value.toPrecision(3).padStart(8)}${unit}  floor ${floor}, goal ${aim}: ${verdict}`;
  rows.push({ goal, map, what, value: `${value.toPrecision(3)}${unit}`, floor, aim, verdict });
  console.log(line);
}

const BOUNDS = {
  Berlin_0_256: { G1: [15, 30], G2: [2.5, 5], G3: [100, 500], G4: [4, 9], G5: [12, 30], G6: [15, 40] },
  brc202d: { G1: [25, 60], G2: [2.5, 5], G3: [100, 350], G4: [2, 5], G5: [40, 90], G6: [15, 40] },
  "random512-25-0": { G1: [20, 40], G2: [2.5, 5], G3: [15, 40], G4: [0.8, 1.1] },
  "maze512-4-0": { G1: [15, 30], G2: [2.5, 5], G3: [100, 240], G4: [4, 11] },
};
const OCTILE = { heuristic: "octile" };
const NBA = { neighbours: "eight", stop: "nba" };
const FIRST = { neighbours: "eight", stop: "first" };

if (wanted("G9") && existsSync(join(maps, "London_1_1024.map"))) {
  const map = load(maps, "London_1_1024");
  const { ask } = ours(map, "eight", OCTILE);
  const near = map.questions.filter((q) => q.length <= 20);
  ask(near[0]);
  const each = near.map((q) => {
    const start = cpu();
    for (let run = 0; run < 200; run++) ask(q);
    return (cpu() - start) / 200;
  });
  report(
    "G9",
    map.name,
    `eight, another question (${near.length} of at most 20 cells), median`,
    median(each),
    0.05,
    0.01,
    " ms",
    true,
  );
}

if (wanted("G10")) {
  const map = load(maps, "random512-25-0");
  const questions = sample(map.questions, Number(count));
  for (const [id, config, bound] of [
    ["eight", OCTILE, 4],
    ["risk-field", {}, 8],
  ]) {
    const { ask, planner } = ours(map, id, config);
    const dab = Array.from({ length: 9 }, (_, k) => [200, 200 + k, 9]);
    for (let k = 0; k < 20; k++) {
      planner.brush(dab, k % 2 === 0);
      ask(questions[k]);
    }
    const edits = questions.flatMap((q) =>
      [true, false].map((blocked) => () => {
        planner.brush(
          dab.map(([x, y, n]) => [x + (q.x0 % 97), y, n]),
          blocked,
        );
      }),
    );
    const both = edits.map((edit, k) => () => {
      edit();
      ask(questions[k >> 1]);
    });
    report(
      "G10",
      map.name,
      `${id}, one dab of the brush and a search, median`,
      median(fastest(15, both)),
      bound,
      bound,
      " ms",
      true,
    );
    console.log(`     of which the dab ${median(fastest(15, edits)).toPrecision(2)} ms`);
  }
}

if (wanted("G11")) {
  const map = load(maps, "brc202d");
  const questions = sample(map.questions, 10);
  const kinds = [
    ["eight", 8, OCTILE],
    ["sixteen", 16, {}],
    ["twenty-four", 24, {}],
    ["forty-eight", 48, {}],
    ["risk-field", 8, {}],
  ];
  for (const [id, moves, config] of kinds) {
    const { ask, planner, point } = ours(map, id, config);
    const around = moves + (id === "risk-field" ? doubleSteps(map, planner, point, questions) : 0);
    const expanded = questions.reduce((sum, q) => sum + ask(q).expanded, 0);
    const each = fastest(
      40,
      questions.map((q) => () => ask(q)),
    );
    const spent = each.reduce((sum, ms) => sum + ms, 0);
    const bound = Math.round(100 + 35 * (around - 8));
    report(
      "G11",
      map.name,
      `${id}, ${Number(around.toFixed(2))} moves a cell, per expanded cell`,
      (spent * 1e6) / expanded,
      bound,
      bound,
      " ns",
      true,
    );
  }
}
if (wanted("G12")) {
  // A drag moves the goal a quarter of a cell a step; everything that the page shows is computed, check and figures too.
  const scene = generateScenario({ family: "random", size: 200, seed: 1 });
  const ids = ["four", "eight", "risk-field", "hybrid"];
  const planners = ids.map((id) => new Planner(id, scene));
  const steps = Array.from({ length: 30 }, (_, step) => ({ ...scene.goal, x: scene.goal.x - 0.25 * step }));
  const plan = (planner, goal) => () => {
    if (planner.plan({ goal, trace: false }).outcome !== "found") throw new Error(`no path to ${goal.x}`);
  };
  const works = steps.flatMap((goal) => planners.map((planner) => plan(planner, goal)));
  const spent = fastest(6, works);
  const hybrid = spent.filter((_, k) => k % 4 === 3);
  const grids = steps.map((_, k) => spent[4 * k] + spent[4 * k + 1] + spent[4 * k + 2]);
  report(
    "G12",
    "random 200, seed 1",
    "a drag step, four + eight + risk-field, all of the plan, median",
    median(grids),
    16,
    16,
    " ms",
    true,
  );
  report("G12", "random 200, seed 1", "a drag step, hybrid, median", median(hybrid), 60, 60, " ms", true);
  report(
    "G12",
    "random 200, seed 1",
    "a drag step, hybrid, 95th percentile",
    quantile(hybrid, 0.95),
    100,
    100,
    " ms",
    true,
  );
}
for (const [name, bounds] of Object.entries(BOUNDS)) {
  const map = load(maps, name);
  const questions = sample(map.questions, Number(count));
  const all = [
    { goals: ["G1", "G2"], name: "eight", mine: true, kind: ["ours", "eight", OCTILE] },
    { goals: ["G3", "G4"], name: "jump-point", mine: true, kind: ["ours", "jump-point"] },
    { goals: ["G1", "G3"], name: "pathfinding", kind: ["pathfinding", "AStarFinder", true] },
    { goals: ["G2"], name: "crate pathfinding", kind: ["crate", 0] },
    { goals: ["G4"], name: "grid_pathfinding, pruning", cuts: true, kind: ["crate", 1] },
    { goals: ["G4"], name: "grid_pathfinding", cuts: true, kind: ["crate", 2] },
    { goals: ["G6"], name: "nba", mine: true, kind: ["ours", "sixteen-bidirectional", NBA] },
    {
      goals: ["G6"],
      name: "first",
      mine: true,
      expect: told(map, "sixteen-bidirectional", FIRST),
      kind: ["ours", "sixteen-bidirectional", FIRST],
    },
    { goals: ["G6"], name: "ngraph", kind: ["nba"] },
    { goals: ["G6"], name: "BiAStarFinder", kind: ["pathfinding", "BiAStarFinder", true] },
  ];
  const rivals = all.filter((rival) => rival.goals.some((goal) => bounds[goal] && wanted(goal)));
  const ms = await race(map, questions, rivals);
  console.log(
    `\n${name}, ${questions.length} questions, CPU ms in all:`,
    Object.entries(ms)
      .map(([k, v]) => `${k} ${v.toFixed(1)}`)
      .join(", "),
  );
  if (wanted("G1"))
    report("G1", name, "eight against npm pathfinding AStarFinder", ms.pathfinding / ms.eight, ...bounds.G1, "x");
  if (wanted("G2"))
    report(
      "G2",
      name,
      "eight against crate pathfinding in wasm",
      ms["crate pathfinding"] / ms.eight,
      ...bounds.G2,
      "x",
    );
  if (wanted("G3"))
    report(
      "G3",
      name,
      "jump-point against npm pathfinding AStarFinder",
      ms.pathfinding / ms["jump-point"],
      ...bounds.G3,
      "x",
    );
  if (wanted("G4")) {
    const jumps = Math.min(ms.grid_pathfinding, ms["grid_pathfinding, pruning"]);
    report(
      "G4",
      name,
      "jump-point against crate grid_pathfinding in wasm",
      jumps / ms["jump-point"],
      ...bounds.G4,
      "x",
    );
  }
  if (bounds.G6 && wanted("G6")) {
    report(
      "G6",
      name,
      "both ends, optimal (nba, 8), against ngraph nba, optimal as well",
      ms.ngraph / ms.nba,
      ...bounds.G6,
      "x",
    );
    report(
      "G6",
      name,
      "both ends until they meet (first, 8) against BiAStarFinder, which does so",
      ms.BiAStarFinder / ms.first,
      ...bounds.G6,
      "x",
    );
    console.log(`     the optimal one against BiAStarFinder: ${(ms.BiAStarFinder / ms.nba).toPrecision(3)}x`);
  }
  if (bounds.G5 && wanted("G5")) {
    const straight = await race(map, questions, [
      { name: "four", mine: true, four: true, expect: told(map, "four"), kind: ["ours", "four"] },
      { name: "pathfinding", four: true, kind: ["pathfinding", "AStarFinder", false] },
    ]);
    report(
      "G5",
      name,
      "four against npm pathfinding AStarFinder",
      straight.pathfinding / straight.four,
      ...bounds.G5,
      "x",
    );
  }
  if (bounds.G5 && wanted("G8")) {
    // Native and wasm take turns, timed in the same way.
    for (const [id, config] of [
      ["eight", OCTILE],
      ["jump-point", {}],
    ]) {
      const { ask } = ours(map, id, config);
      const asked = questions.map((q) => [q.x0, q.y0, q.x1, q.y1].join(" ")).join("\n");
      const ratios = Array.from({ length: 9 }, () => {
        const mine = questions.reduce((sum, q) => sum + fastest(15, [() => ask(q)], wall)[0], 0);
        const out = execFileSync(native, ["time", join(maps, `${name}.map`), id], { input: asked, encoding: "utf8" });
        return mine / Number(out);
      });
      report("G8", name, `${id} in wasm against native`, median(ratios), 2, 1.4, "x", true);
    }
  }
}

const below = rows.filter((row) => row.verdict === "BELOW");
console.log(`\n${rows.length} figures, ${below.length} below their floor`);

const file = new URL("../../benches/RESULTS.md", import.meta.url);
const load1 = loadavg()[1].toFixed(1);
const cells = (values) => `| ${values.join(" | ")} |`;
const analysis = JSON.parse(readFileSync(new URL("analysis.json", import.meta.url), "utf8"));
const [oldHead, ...oldSections] =
  goals === ""
    ? []
    : readFileSync(file, "utf8")
        .trim()
        .split(/\n\n(?=## )/);
const sections = new Map(oldSections.map((section) => [/^## (G\d+)/.exec(section)[1], section]));
for (const goal of new Set(rows.map((row) => row.goal))) {
  const own = rows.filter((row) => row.goal === goal);
  const table = own.map((row) => cells([row.map, row.what, row.value, row.floor, row.aim, row.verdict]));
  const alone = goals === "" ? "" : ` Measured without the other goals, load ${load1}.`;
  sections.set(
    goal,
    [
      `## ${goal}`,
      "",
      `${analysis[goal]}${alone}`,
      "",
      cells(["map", "what", "measured", "floor", "goal", ""]),
      cells(["---", "---", "---:", "---:", "---:", "---"]),
      ...table,
    ].join("\n"),
  );
}
const body = [...sections]
  .sort(([a], [b]) => a.slice(1) - b.slice(1))
  .map(([, section]) => section)
  .join("\n\n");
const verdicts = body.match(/\| (goal|floor|BELOW) \|$/gm);
const tally = `${verdicts.length} figures, ${verdicts.filter((one) => one.includes("BELOW")).length} below their floor.`;
const head =
  oldHead?.replace(/\d+ figures, \d+ below their floor\./, tally) ??
  `# Grid planners against others

Written by \`cargo xtask bench grid\` (${count} + ${count} questions a map, ${repeats} repeats) on ${availableParallelism()} × ${cpus()[0].model.trim()},
Node.js ${process.versions.node}, load ${load1}. CPU times, all rivals interleaved in one run, every answer checked: ratios count, not
milliseconds. "x" is the other's time over ours; each one's fastest round of several counts, what it takes when nothing disturbs. Peers: npm pathfinding 0.4.18, ngraph.path 1.6.1; crates pathfinding 4.16,
grid_pathfinding 0.3.0 in wasm. ${tally}`;
writeFileSync(file, `${head}\n\n${body}\n`);
