// `cargo xtask bench grid`: grid planners through the built package against others, interleaved in one run.
//
// Usage: node grid.mjs MAPS PEERS NATIVE [count] [repeats] [goals], where MAPS holds the MovingAI files, PEERS the
// installed peers, NATIVE is the built example `movingai`; of goals, `G6,G8`, the others are kept as they were written
// last. Times are CPU times; ratios count, not milliseconds. Each rival has a process of its own and is asked in turn:
// one's garbage is not another's time.
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { availableParallelism, cpus, loadavg } from "node:os";
import { join } from "node:path";
import { quantile } from "../quantile.mjs";
import { generateScenario, Planner } from "../../pkg/node.js";
import { count, cpu, fastest, goals, maps, median, native, ours, race, repeats, told, wall } from "./grid_rivals.mjs";
import { load, sample } from "./movingai.mjs";

const wanted = (...any) => goals === "" || any.some((goal) => goals.split(",").includes(goal));

/**
 * How many of the risk field's steps go beyond the cells around, on average over a map's free cells and some questions.
 */
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
  const line = `${goal.padEnd(4)} ${map.padEnd(16)} ${what.padEnd(58)} ${value
    .toPrecision(3)
    .padStart(8)}${unit}  floor ${floor}, goal ${aim}: ${verdict}`;
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
  // A drag moves the goal a quarter of a cell a step; everything that the page shows is computed, check and figures
  // too.
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
const missed = verdicts.filter((one) => one.includes("BELOW")).length,
  tally = `${verdicts.length} figures, ${missed} below their floor.`;
const head =
  oldHead?.replace(/\d+ figures, \d+ below their floor\./, tally) ??
  `# Grid planners against others

Written by \`cargo xtask bench grid\` ` +
    `(${count} + ${count} questions a map, ${repeats} repeats) on ${availableParallelism()} × ${cpus()[0].model.trim()},
Node.js ${process.versions.node}, load ${load1}. CPU times, all rivals interleaved in one run, every answer ` +
    `checked: ratios count, not
milliseconds. "x" is the other's time over ours; each one's fastest round of several counts, what it takes when ` +
    `nothing disturbs. Peers: npm pathfinding 0.4.18, ngraph.path 1.6.1; crates pathfinding 4.16,
grid_pathfinding 0.3.0 in wasm. ${tally}`;
writeFileSync(file, `${head}\n\n${body}\n`);
