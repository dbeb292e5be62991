// `cargo xtask bench kerb`: hybrid A* through the built package in kerb slots by seed, which the sedan enters with 3 cm
// of margin or more.
//
// Usage: node kerb.mjs SCENES, which `tight scenes` has printed. Prints for each kind how many are solved so, the
// times, and the most gear changes. Times are of the processor, the least of a few runs.
import { readFileSync } from "node:fs";
import { init, Planner } from "../../pkg/node.js";
import { quantile } from "../quantile.mjs";

const RUNS = 3;
/** Plans before the clock starts: the engine compiles what is called often. */
const WARM_UP = 20;
const PROMISED_MARGIN = 0.03;
/** The share of times in the targets, and these (ms). */
const SHARE = 0.95;
const TARGETS = { "kerb +1.2..2.5": 150, "kerb +0.85..1.2": 600 };

const rows = readFileSync(process.argv[2], "utf8")
  .trim()
  .split("\n")
  .map((line) => JSON.parse(line));
await init();

function timed(scene) {
  const planner = new Planner("hybrid", scene),
    from = process.cpuUsage(),
    plan = planner.plan(),
    { user, system } = process.cpuUsage(from);
  planner.free();
  return { plan, millis: (user + system) / 1000 };
}

for (const { scene } of rows.slice(0, WARM_UP)) timed(scene);
for (const [kind, target] of Object.entries(TARGETS)) {
  const answers = rows
    .filter((row) => row.kind === kind)
    .map(({ scene }) => {
      const runs = Array.from({ length: RUNS }, () => timed(scene));
      return { plan: runs[0].plan, millis: Math.min(...runs.map(({ millis }) => millis)) };
    });
  const times = answers.map(({ millis }) => millis);
  const solved = answers.filter(({ plan }) => plan.outcome === "found" && plan.metrics.margin >= PROMISED_MARGIN);
  const at = (share) => quantile(times, share).toFixed(1);
  console.log(
    `${kind} m: ${solved.length} of ${answers.length} with at least ${PROMISED_MARGIN} m of margin, at most ` +
      `${Math.max(0, ...solved.map(({ plan }) => plan.metrics.directionChanges))} gear changes; p50 ${at(0.5)}, ` +
      `p95 ${at(SHARE)}, most ${at(1)} ms; target ${target} ms at p95: ` +
      `${quantile(times, SHARE) <= target ? "met" : "missed"}`,
  );
}
