// `cargo xtask bench parking`: hybrid A* natively and through the built package, beside the best of other programs.
//
// Usage: node parking.mjs RESULTS NATIVE HOPELESS, where NATIVE is the built example `tpcap`, RESULTS what its `json`
// printed and HOPELESS what the example `goals` did. Writes benches/PARKING.md where the public cases are at hand.
// Times are of the processor, the least of several runs, both sides in turns. Every path is checked with the exact body
// every 2 cm, on both sides; answers must agree byte for byte.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { availableParallelism, cpus, loadavg } from "node:os";
import { init, Planner } from "../../pkg/node.js";

const [results, native, hopeless] = process.argv.slice(2);
const { near, rows } = JSON.parse(readFileSync(results, "utf8"));
/** How often either side has its turn. */
const TURNS = 3;
await init();

function cpu() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

/** Milliseconds of a whole plan in WebAssembly: the mean of a batch that is long enough for the processor's clock. */
function batch(planner) {
  let from = cpu();
  planner.plan();
  const runs = Math.max(1, Math.min(400, Math.ceil(40 / Math.max(cpu() - from, 0.1))));
  from = cpu();
  for (let run = 0; run < runs; run++) planner.plan();
  return (cpu() - from) / runs;
}

// The engine compiles what is called often, on threads of its own; that is not to be measured.
for (const { scene } of rows.filter(({ query }) => query < 30)) {
  const planner = new Planner("hybrid", scene);
  for (let run = 0; run < 10; run++) planner.plan();
  planner.free();
}

for (const row of rows) {
  const planner = new Planner("hybrid", row.scene);
  const { hash } = planner.plan();
  if (hash !== row.hash) throw new Error(`${row.name}: ${hash} in WebAssembly, ${row.hash} natively`);
  [row.whole, row.wasm] = [Infinity, Infinity];
  for (let turn = 0; turn < TURNS; turn++) {
    row.whole = Math.min(row.whole, Number(execFileSync(native, ["time", row.name], { encoding: "utf8" })));
    row.wasm = Math.min(row.wasm, batch(planner));
  }
  planner.free();
}

const of = (...groups) => rows.filter(({ group }) => groups.includes(group));
const sorted = (values) => [...values].sort((a, b) => a - b);
const median = (values) => sorted(values)[values.length >> 1];
const worst = (values) => Math.max(...values);
const ms = (value) => value.toFixed(value < 10 ? 2 : 1);
const known = (value) => (value === undefined ? "" : ` (${value})`);

const lines = [];
function say(text) {
  console.log(text);
  lines.push(text);
}

say(
  `| scene | check | length, m (best known) | bound, m | gear changes (best known) | ` +
    `at ${near.margin} m: m, changes | clearance, m | margin, m | level | expanded | native: query, ms (best known) ` +
    `| whole plan, ms | WebAssembly, ms |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |`,
);
for (const row of rows) {
  const { name, verdict, length, bound, changes, clearance, margin, level, expanded, query, whole, wasm, best } = row;
  const nearly = row.near ? `${row.near.length.toFixed(2)}, ${row.near.changes}` : "–";
  say(
    `| ${name} | ${verdict} | ${length.toFixed(2)}${known(best?.length)} | ${bound.toFixed(2)} | ` +
      `${changes}${known(best?.changes)} | ${nearly} | ` +
      `${clearance.toFixed(3)} | ${margin} | ${level} | ${expanded} | ${ms(query)}` +
      `${known(best?.milliseconds)} | ${ms(whole)} | ${ms(wasm)} |`,
  );
}

say("\n| goal | reached | floor | aim | |\n| --- | --- | --- | --- | --- |");
function goal(what, values, floors, aims, unit, digits = 2) {
  const within = (bounds) => values.every((value, at) => value <= bounds[at]);
  const text = (list) =>
    list.map((value) => `${Number.isInteger(value) ? value : value.toFixed(digits)}${unit}`).join(" / ");
  say(
    `| ${what} | ${text(values)} | ${text(floors)} | ${text(aims)} | ${
      within(aims) ? "aim" : within(floors) ? "floor" : "BELOW"
    } |`,
  );
}

const settings = [
  ["as planned by default", (row) => row],
  [`at ${near.margin} m, ${near.directionChangeCost} m a change`, (row) => row.near],
];
const cases = of("tpcap");
if (cases.length > 0) {
  for (const [what, side] of settings) {
    const unsolved = cases.filter((row) => side(row).verdict !== "ok").map(({ name }) => name);
    goal(
      `H1 TPCAP cases not solved, of ${cases.length}, ${what}`,
      [unsolved.length],
      [Number(unsolved.every((name) => name === "Case7"))],
      [0],
      "",
    );
    const queries = cases.map((row) => side(row).query);
    goal(
      `H2 TPCAP, query, native, ${what}: median / worst`,
      [median(queries), worst(queries)],
      [8, 300],
      [3, 150],
      " ms",
    );
  }
}
for (const [name, group] of [
  ["TPCAP", "tpcap"],
  ["lots", "lots"],
  ["paper rows", "paper"],
  ["tight slots", "tight"],
]) {
  const some = of(group);
  if (some.length === 0) continue;
  const total = (key) => some.reduce((sum, row) => sum + row[key], 0);
  goal(
    `H3 ${name}, WebAssembly / native: median / of the sums`,
    [median(some.map(({ wasm, whole }) => wasm / whole)), total("wasm") / total("whole")],
    [2, 2],
    [1.4, 1.4],
    "x",
  );
}
const paper = of("paper").map(({ wasm }) => wasm);
goal("H4 paper rows, WebAssembly: median / worst", [median(paper), worst(paper)], [60, 200], [15, 60], " ms");
const compared = rows.filter(({ best }) => best);
for (const [what, side] of settings) {
  if (compared.length === 0) break;
  // No path to the very goal is shorter than the bound; the best known may end 0.3 m off.
  const best = ({ best, bound, ...row }) => {
    const hasFewest = side(row).changes <= best.changes;
    return Math.max((hasFewest && best.lengthOfFewest) || best.length, bound);
  };
  const lengths = compared.map((row) => side(row).length / best(row));
  goal(
    `H5 length over the best known, or over that with the fewest gear changes where ours has as few, ${what}: worst`,
    [worst(lengths)],
    [1.05],
    [1],
    "x",
    3,
  );
  const extra = compared.map((row) => side(row).changes - row.best.changes);
  const more = extra.filter((n) => n > 0).length;
  goal(
    `H6 gear changes beyond the best known, ${what}: most / percent of ${compared.length} scenes with more`,
    [worst(extra), (more / compared.length) * 100],
    [1, 20],
    [0, 0],
    "",
    0,
  );
}
goal("H7 before the first query: worst", [worst(rows.map(({ prepare }) => prepare))], [20], [5], " ms");
say(`\n${readFileSync(hopeless, "utf8").trim()}`);

if (cases.length === 0) {
  console.log(
    "\nskipped: no TPCAP cases in PARKADE_DATA (tpcap/Case1.csv of libai1943/TPCAP_benchmarks); the built-in scenes " +
      "alone are not written down",
  );
} else {
  const head =
    `# Parking

Written by \`cargo xtask bench parking\` ` +
    `on ${availableParallelism()} × ${cpus()[0].model.trim()}, Node.js ${process.versions.node}, ` +
    `load ${loadavg()[1].toFixed(1)}. Default settings;
CPU times, native and WebAssembly in turns, the least of ${TURNS}. "Query" is search, shortcut and verification ` +
    `with nothing known from a query
before; "whole plan" is a repeated one with check and figures. Every path is checked with the exact body every 2 cm ` +
    `and has the same hash on
both sides. Best known: of six public planners, each case by whichever did best.`;
  writeFileSync(new URL("../../benches/PARKING.md", import.meta.url), `${head}\n\n${lines.join("\n")}\n`);
}
