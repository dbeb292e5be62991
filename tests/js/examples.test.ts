import { execFileSync } from "node:child_process";
import { chmodSync, copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, test } from "vitest";
import { generateScenario, init } from "parkade";
import { PACKAGE, installed, parkade } from "./pack";

const EXAMPLES = fileURLToPath(new URL("../../examples/", import.meta.url));
const VERSION = (JSON.parse(readFileSync(join(PACKAGE, "package.json"), "utf8")) as { version: string }).version;
let folder = "";
let path = "";

beforeAll(async () => {
  await init();
  folder = installed();
  mkdirSync(join(folder, "scenes"));
  for (let seed = 0; seed < 40; seed++)
    writeFileSync(
      join(folder, `scenes/${seed}.json`),
      JSON.stringify(generateScenario({ family: "random", size: 15, seed })),
    );
  // What `npx` would start, and a machine with the package has.
  mkdirSync(join(folder, "bin"));
  for (const [name, skip] of [
    ["npx", `[ "$1 $2" = "--yes parkade@${VERSION}" ] || exit 9; shift 2; `],
    ["parkade", ""],
  ] as const) {
    writeFileSync(
      join(folder, `bin/${name}`),
      `#!/bin/sh\n${skip}exec "${process.execPath}" "${join(folder, "node_modules/parkade/cli/main.js")}" "$@"\n`,
    );
    chmodSync(join(folder, `bin/${name}`), 0o755);
  }
  path = `${join(folder, "bin")}:${process.env["PATH"]}`;
}, 120_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const digestOf = (...files: string[]) => parkade(["digest", ...files], folder).out;

test("the Node test suite passes", () => {
  copyFileSync(join(EXAMPLES, "node/planners.test.mjs"), join(folder, "planners.test.mjs"));
  const out = execFileSync(process.execPath, ["--test", "--test-reporter=tap", "planners.test.mjs"], {
    cwd: folder,
    encoding: "utf8",
    env: { ...process.env, NODE_OPTIONS: "" },
  });
  expect(out).toMatch(/^# pass 5$/m);
  expect(out).toMatch(/^# fail 0$/m);
});

test("the worker example answers for its three scenes", () => {
  cpSync(join(EXAMPLES, "worker"), folder, { recursive: true });
  const lines = execFileSync(process.execPath, ["main.mjs"], { cwd: folder, encoding: "utf8" }).trim().split("\n");
  expect(lines.map((line) => line.replace(/\d+(\.\d+)?/g, "n"))).toEqual([
    "perpendicular: found, n m, n poses",
    "parallel: found, n m, n poses",
    "angled: found, n m, n poses",
  ]);
});

test.skipIf(process.platform === "win32")(
  "Slurm's array and Kubernetes' indexed Job plan every scene once, whatever the number of shards",
  () => {
    parkade(["batch", "scenes", "--planner", "eight", "--out", "whole.jsonl", "--quiet"], folder);
    const whole = digestOf("whole.jsonl");
    expect(whole).toContain("40 results");
    const env = { ...process.env, PATH: path };
    for (const at of ["1", "2", "3"]) {
      execFileSync("sh", [join(EXAMPLES, "cluster/array.sh"), "scenes"], {
        cwd: folder,
        env: { ...env, PLANNER: "eight", SHARDS: "3", SLURM_ARRAY_TASK_ID: at },
      });
    }
    expect(digestOf("results-1.jsonl", "results-2.jsonl", "results-3.jsonl")).toBe(whole);
    // One task again, alone, as after a failure of its machine.
    rmSync(join(folder, "results-2.jsonl"));
    execFileSync("sh", [join(EXAMPLES, "cluster/array.sh"), "scenes"], {
      cwd: folder,
      env: { ...env, PLANNER: "eight", SHARDS: "3", SLURM_ARRAY_TASK_ID: "2", SLURM_ARRAY_TASK_COUNT: "1" },
    });
    expect(digestOf("results-1.jsonl", "results-2.jsonl", "results-3.jsonl")).toBe(whole);
    const job = readFileSync(join(EXAMPLES, "cluster/job.yaml"), "utf8");
    const [, script] = /command: \["sh", "-c", "(.*)"\]/.exec(job)!,
      completions = Number(/completions: (\d+)/.exec(job)![1]),
      [, task] = /name: TASK, value: "(.*)"/.exec(job)!;
    expect(script).toContain(`/${completions} `);
    const local = script!
      .replaceAll("/data/", `${folder}/`)
      .replace(`/${completions} `, "/4 ")
      .replace("results-", "pod-");
    const files = Array.from({ length: 4 }, (_, index) => {
      execFileSync("sh", ["-c", local], {
        cwd: folder,
        env: { ...env, TASK: task!.replace("hybrid", "eight"), JOB_COMPLETION_INDEX: String(index) },
      });
      return `pod-${index}.jsonl`;
    });
    expect(digestOf(...files)).toBe(whole);
    const matrix = readFileSync(join(EXAMPLES, "cluster/matrix.yml"), "utf8");
    const steps = [...matrix.matchAll(/- run: (parkade .*?)( # .*)?$/gm)].map(([, step]) => step!);
    const [, shards] = /shard: \[(.*)\]/.exec(matrix)!;
    expect(steps).toHaveLength(2);
    for (const shard of shards!.split(", "))
      execFileSync(
        "sh",
        ["-ec", steps[0]!.replaceAll(/\$\{\{ matrix.shard \}\}/g, shard).replaceAll("results-", "matrix-")],
        {
          cwd: folder,
          env: { ...env, TASK: "--planner eight" },
          stdio: "pipe",
        },
      );
    const told = execFileSync("sh", ["-ec", steps[1]!.replace("results-", "matrix-")], { cwd: folder, env });
    expect(String(told)).toContain(whole);
  },
  120_000,
);

test.skipIf(process.platform === "win32")(
  "a scene that is refused fails no task of a cluster, and a folder that is not there does",
  () => {
    mkdirSync(join(folder, "some"));
    writeFileSync(join(folder, "some/bad.json"), "{}");
    writeFileSync(join(folder, "some/good.json"), readFileSync(join(folder, "scenes/0.json")));
    const run = (scenes: string, command = {}): number => {
      const env = { ...process.env, PATH: path, PLANNER: "eight", SHARDS: "1", SLURM_ARRAY_TASK_ID: "1", ...command };
      try {
        execFileSync("sh", [join(EXAMPLES, "cluster/array.sh"), scenes], { cwd: folder, env, stdio: "pipe" });
        return 0;
      } catch (error) {
        return (error as { status: number }).status;
      }
    };
    expect(run("some")).toBe(0);
    expect(run("some", { PARKADE: "parkade" })).toBe(0);
    expect(run("nowhere")).not.toBe(0);
    // npx ends with 1 where it finds no package, as `batch` does after a refused scene.
    expect(run("some", { PARKADE: "false" })).not.toBe(0);
  },
);

test("the CI matrix names the command's options as it has them", () => {
  const help = parkade(["batch", "--help"], folder).out,
    text = readFileSync(join(EXAMPLES, "cluster/matrix.yml"), "utf8");
  expect(text).toContain(`default: parkade@${VERSION}\n`);
  for (const [option] of text.replaceAll("--global", "").matchAll(/--[a-z]+/g)) expect(help).toContain(option);
});
