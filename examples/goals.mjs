// Times hybrid A* in WebAssembly: the parking paper's rows, the tight slots and the TPCAP cases, through the built package.
// Prints what `cargo run --release --example goals` calls "whole plan", to be compared with it.
//
//   cargo xtask build && PARKADE_DATA=folder node examples/goals.mjs
import { readFileSync } from "node:fs";
import { importScene, init, Planner, scenario } from "../pkg/node.js";

await init();
const folder = process.env.PARKADE_DATA ?? "../shared/data";

function cases() {
  return Array.from({ length: 20 }, (_, i) => `Case${i + 1}.csv`).flatMap((name) => {
    try {
      return [[name, importScene({ [name]: readFileSync(`${folder}/tpcap/${name}`, "utf8") }).scene]];
    } catch (error) {
      if (error.code === "ENOENT") return [];
      throw error;
    }
  });
}

function least(scene) {
  const planner = new Planner("hybrid", scene);
  let best = Infinity;
  for (let run = 0; run < 6 && (run < 2 || best < 200); run++) {
    const from = process.cpuUsage();
    const begin = performance.now();
    const plan = planner.plan();
    const cpu = process.cpuUsage(from);
    if (plan.outcome !== "found" || plan.check.verdict !== "ok") throw new Error(`${scene.name}: ${plan.reason}`);
    best = Math.min(best, performance.now() - begin, (cpu.user + cpu.system) / 1e3 || Infinity);
  }
  planner.free();
  return best;
}

function row(name, scenes) {
  if (scenes.length === 0) return console.log(`| ${name} | skipped: none in ${folder} |`);
  const times = scenes.map(([, scene]) => least(scene)).sort((a, b) => a - b);
  const [median, worst] = [times[times.length >> 1], times[times.length - 1]].map((t) => t.toFixed(2));
  console.log(`| ${name} | median ${median} ms, worst ${worst} ms |`);
}

const named = (ids) => ids.map((id) => [id, scenario(id)]);
console.log("| whole plan, wasm | time |\n| --- | --- |");
row("paper rows", named(["P0", "P1", "P2", "P3", "P4", "L0", "L1", "L2", "L3", "L4"]));
row("tight slots", named(["par-8.0", "par-7.2", "par-6.6", "perp-tail-3.2", "perp-nose-3.2"]));
row("TPCAP", cases());
