// `parkade batch` over 1000 generated scenes with two jobs and with one, interleaved: wall-clock speed-up, which needs
// two free cores, and processor time, which does not. Maps of 200 cells a side are what the grid planners are made for;
// on those of 60 a plan takes a millisecond or two, and what is done once, starting and optimizing the module, weighs
// as much as it can.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism, loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { generateScenario, init } from "../../pkg/node.js";

const SCENES = 1000,
  ROUNDS = 5;
const COMMAND = fileURLToPath(new URL("../../pkg/cli/main.js", import.meta.url));
/** Writes the seconds of all threads of a run to standard error when it ends. */
const METER =
  'data:text/javascript,import{isMainThread}from"node:worker_threads";' +
  'if(isMainThread)process.on("exit",()=>{const{userCPUTime:u,systemCPUTime:s}=process.resourceUsage();' +
  "console.error(`cpu ${(u+s)/1e6}`)})";

await init();
const folder = mkdtempSync(join(tmpdir(), "parkade-bench-"));

/** One run from nothing: seconds by the clock and by the processors, and what its results are. */
function run(jobs) {
  rmSync(join(folder, "out.jsonl"), { force: true });
  const from = performance.now();
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    [
      "--import",
      METER,
      COMMAND,
      "batch",
      "scenes.jsonl",
      "--planner",
      "eight,risk-field",
      "--jobs",
      String(jobs),
      "--out",
      "out.jsonl",
      "--quiet",
    ],
    { cwd: folder, encoding: "utf8" },
  );
  const wall = (performance.now() - from) / 1000,
    cpu = Number(/^cpu (.*)$/m.exec(stderr)?.[1]),
    digest = /digest (\w+)/.exec(stdout)?.[1];
  if (status !== 0 || !(cpu > 0) || digest === undefined)
    throw new Error(`--jobs ${jobs} ended with ${status}: ${stderr}`);
  return { wall, cpu, digest, lines: readFileSync(join(folder, "out.jsonl"), "utf8").split("\n").length - 1 };
}

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];

function measured(size) {
  const scenes = Array.from({ length: SCENES }, (_, i) =>
    JSON.stringify(generateScenario({ family: "random", size, seed: i + 1 })),
  );
  writeFileSync(join(folder, "scenes.jsonl"), scenes.join("\n"));
  const rounds = [];
  for (let i = 0; i < ROUNDS; i++) rounds.push({ one: run(1), two: run(2) });
  const all = rounds.flatMap(({ one, two }) => [one, two]);
  if (new Set(all.map(({ digest, lines }) => `${digest} ${lines}`)).size !== 1)
    throw new Error("the runs' results differ");
  const [first] = all;
  const seconds = (jobs, what) => median(rounds.map((round) => round[jobs][what])).toFixed(2);
  console.log(
    `${first.lines} plans of ${SCENES} generated scenes of ${size} × ${size} cells, ${ROUNDS} rounds, medians; all ` +
      `digests ${first.digest.slice(0, 16)}`,
  );
  console.log(`--jobs 1: ${seconds("one", "wall")} s by the clock, ${seconds("one", "cpu")} s of processors`);
  console.log(`--jobs 2: ${seconds("two", "wall")} s by the clock, ${seconds("two", "cpu")} s of processors`);
  console.log(
    `speed-up ${median(rounds.map(({ one, two }) => one.wall / two.wall)).toFixed(2)} (goal 1.7; means something ` +
      `with two processors free)`,
  );
  console.log(
    `processor time ${median(rounds.map(({ one, two }) => two.cpu / one.cpu)).toFixed(2)} times that of one job ` +
      `(goal 1.1)`,
  );
}

try {
  for (const size of [200, 60]) measured(size);
  console.log(`${availableParallelism()} processors, load ${loadavg()[0].toFixed(1)} at the end`);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
