import { spawn } from "node:child_process";
import { once } from "node:events";
import { appendFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { Tinypool } from "tinypool";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Planner, generateScenario, init, scenario } from "parkade";
import { pathToFileURL } from "node:url";
import { PACKAGE, parkade, slowly } from "./pack";

const SCENES = 1000;
let folder = "";
const run = (...args: string[]) => parkade(args, folder);
const lines = (name: string) =>
  existsSync(join(folder, name)) ? readFileSync(join(folder, name), "utf8").split("\n").slice(0, -1) : [];
const results = (name: string) =>
  lines(name).map((line) => JSON.parse(line) as { key: string; scene: string; outcome: string; hash: string });
const digestOf = (...files: string[]) => run("digest", ...files).out.split(" ")[0];

beforeAll(async () => {
  await init();
  folder = mkdtempSync(join(tmpdir(), "parkade-"));
  mkdirSync(join(folder, "scenes/parking"), { recursive: true });
  for (let seed = 1; seed < SCENES; seed++) {
    writeFileSync(
      join(folder, `scenes/random-${seed}.json`),
      JSON.stringify(generateScenario({ family: "random", size: 15, seed })),
    );
  }
  writeFileSync(join(folder, "scenes/parking/perpendicular.json"), JSON.stringify(scenario("perpendicular")));
  expect(run("batch", "scenes", "--planner", "eight", "--out", "whole.jsonl", "--quiet").status).toBe(0);
}, 120_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

test("every scene is planned once, as the library plans it", () => {
  const whole = results("whole.jsonl");
  expect(new Set(whole.map(({ scene }) => scene)).size).toBe(SCENES);
  expect(whole).toHaveLength(SCENES);
  const parking = whole.find(({ scene }) => scene === "scenes/parking/perpendicular.json");
  expect(parking?.hash).toBe(new Planner("eight", scenario("perpendicular")).plan().hash);
  expect(whole.find(({ scene }) => scene === "scenes/random-7.json")?.hash).toBe(
    new Planner("eight", generateScenario({ family: "random", size: 15, seed: 7 })).plan().hash,
  );
});

test("killed half-way, even in the middle of a line, a run goes on with nothing lost or repeated", async () => {
  let before: string[];
  do {
    rmSync(join(folder, "killed.jsonl"), { force: true });
    const child = spawn(
      process.execPath,
      [join(PACKAGE, "cli/main.js"), "batch", "scenes", "--planner", "eight", "--out", "killed.jsonl", "--quiet"],
      { cwd: folder, stdio: "ignore" },
    );
    const ended = once(child, "exit");
    while (lines("killed.jsonl").length < SCENES / 4) await new Promise((done) => setTimeout(done, 2));
    child.kill("SIGKILL");
    await ended;
    before = lines("killed.jsonl");
  } while (before.length === SCENES); // the run was over before this process had its turn
  appendFileSync(join(folder, "killed.jsonl"), '{"key":"torn');
  const { status, out } = run("batch", "scenes", "--planner", "eight", "--out", "killed.jsonl", "--quiet");
  expect(status).toBe(0);
  expect(out).toContain(`${SCENES} of ${SCENES} planned (${SCENES - before.length} now)`);
  expect(lines("killed.jsonl").slice(0, before.length)).toEqual(before);
  expect(lines("killed.jsonl")).toHaveLength(SCENES);
  expect(new Set(results("killed.jsonl").map(({ key }) => key)).size).toBe(SCENES);
  expect(digestOf("killed.jsonl")).toBe(digestOf("whole.jsonl"));
}, 120_000);

test("a run that has all its results plans nothing", () => {
  const { out } = run("batch", "scenes", "--planner", "eight", "--out", "whole.jsonl", "--quiet");
  expect(out).toContain("(0 now)");
  expect(lines("whole.jsonl")).toHaveLength(SCENES);
});

test("paths and times are added where they are asked for, and the digest stays", () => {
  const few = ["batch", "scenes/parking", "--planner", "eight,hybrid", "--out", "more.jsonl", "--quiet", "--jobs", "1"];
  const before = /digest (\w+)/.exec(run(...few).out)![1];
  expect(run(...few, "--paths", "--times").out).toContain(
    `2 of 2 planned (2 now): 2 found, 0 without a path, 0 refused; digest ${before}`,
  );
  expect(run(...few, "--times").out).toContain("(0 now)");
  expect(run("digest", "more.jsonl").out).toBe(`${before}  2 results\n`);
  const newest = results("more.jsonl").slice(-2) as unknown as {
    path: number[];
    directions: number[];
    seconds: number;
  }[];
  const plan = new Planner("eight", scenario("perpendicular")).plan();
  expect([newest[0]!.path, newest[0]!.directions]).toEqual([[...plan.path], [...plan.directions]]);
  expect(newest.every(({ seconds }) => seconds > 0)).toBe(true);
});

test("two shards are two halves of the whole, by hash", () => {
  for (const shard of ["1/2", "2/2"])
    expect(run("batch", "scenes", "--planner", "eight", "--shard", shard, "--quiet").status).toBe(0);
  const [one, two] = [results("results-1-of-2.jsonl"), results("results-2-of-2.jsonl")];
  expect(one.length + two.length).toBe(SCENES);
  expect(Math.min(one.length, two.length)).toBeGreaterThan(SCENES / 3);
  expect(digestOf("results-1-of-2.jsonl", "results-2-of-2.jsonl")).toBe(digestOf("whole.jsonl"));
  expect(digestOf("results-1-of-2.jsonl")).not.toBe(digestOf("whole.jsonl"));
}, 120_000);

test("other planners and settings are other results in the same file", () => {
  mkdirSync(join(folder, "few"), { recursive: true });
  writeFileSync(join(folder, "few/a.json"), JSON.stringify(scenario("perpendicular")));
  const few = (...more: string[]) => run("batch", "few", "--out", "few.jsonl", "--quiet", ...more);
  expect(few("--planner", "four,eight").out).toContain("(2 now)");
  expect(few("--planner", "eight", "--set", "corner=free").out).toContain("(1 now)");
  expect(few("--planner", "four,eight").out).toContain("(0 now)");
  expect(lines("few.jsonl")).toHaveLength(3);
});

test("scenes that cannot be planned are named, told by the exit code, and stop nothing", () => {
  const bad = { ...scenario("perpendicular"), start: { x: "here" } };
  writeFileSync(
    join(folder, "mixed.jsonl"),
    [JSON.stringify(bad), "{", JSON.stringify(scenario("perpendicular"))].join("\n"),
  );
  const { status, out, err } = run("batch", "mixed.jsonl", "--planner", "eight", "--out", "mixed-out.jsonl", "--quiet");
  expect(status).toBe(1);
  expect(out).toContain("3 of 3 planned (3 now): 1 found, 0 without a path, 2 refused");
  expect(err).toContain("mixed.jsonl:1 (eight): start.x");
  expect(err).toContain("mixed.jsonl:2 (eight): is not JSON");
});

test("a scene that is edited, cut or gone since it was listed is refused, and the others are planned", async () => {
  mkdirSync(join(folder, "edited"));
  const text = JSON.stringify(scenario("perpendicular")),
    files = ["edited", "cut", "gone", "kept"].map((name) => join(folder, `edited/${name}.json`));
  files.forEach((file, i) => writeFileSync(file, `${text}${" ".repeat(i)}`));
  const { scenes } = (await import(/* @vite-ignore */ pathToFileURL(join(PACKAGE, "cli/scenes.js")).href)) as {
    scenes(place: string): AsyncIterable<{ scene: { name: string }; content: string }>;
  };
  const tasks: object[] = [];
  for await (const { scene, content } of scenes(join(folder, "edited")))
    tasks.push({
      key: basename(scene.name),
      scene,
      content,
      planner: "eight",
      extras: { paths: false, times: false },
    });
  writeFileSync(files[0]!, text.replace('"name":"p', '"name":"P'));
  writeFileSync(files[1]!, text.slice(0, -1));
  rmSync(files[2]!);
  const pool = new Tinypool({
    filename: pathToFileURL(join(PACKAGE, "cli/worker.js")).href,
    minThreads: 1,
    maxThreads: 1,
    workerData: { module: new WebAssembly.Module(readFileSync(join(PACKAGE, "parkade_bg.wasm"))), config: {} },
  });
  const { done } = (await pool.run(tasks).finally(() => pool.destroy())) as { done: { line: string }[] };
  const written = done.map(
    ({ line }) => JSON.parse(line) as { key: string; outcome?: string; error?: { code: string; message: string } },
  );
  const changed = { code: "bad-input", path: "", message: "was changed while the batch ran" };
  expect(written.map(({ key, outcome, error }) => [key, outcome ?? error])).toEqual([
    ["cut.json", changed],
    ["edited.json", changed],
    ["gone.json", { ...changed, message: expect.stringContaining("no such file") }],
    ["kept.json", "found"],
  ]);
});

test("the result of a scene that was corrected supersedes the one before, and that of its unchanged copy stays", () => {
  const place = join(folder, "fixed"),
    good = scenario("perpendicular");
  mkdirSync(place);
  const write = (name: string, value: object) => writeFileSync(join(place, name), JSON.stringify(value));
  const fixed = (out: string) => run("batch", "fixed", "--planner", "eight", "--out", out, "--quiet");
  write("a.json", { ...good, start: { x: "here" } });
  write("copy.json", { ...good, name: "copied" });
  write("of.json", { ...good, name: "copied" });
  expect(fixed("fixed.jsonl").status).toBe(1);
  write("a.json", good);
  write("copy.json", { ...good, name: "edited" });
  expect(fixed("fixed.jsonl")).toMatchObject({ status: 0, out: expect.stringContaining("3 of 3 planned (2 now)") });
  expect(fixed("anew.jsonl").status).toBe(0);
  expect(digestOf("fixed.jsonl")).toBe(digestOf("anew.jsonl"));
  expect(run("digest", "fixed.jsonl")).toMatchObject({ status: 0, out: expect.stringMatching(/ 3 results\n$/) });
  // Back to what it was before.
  write("a.json", { ...good, start: { x: "here" } });
  expect(fixed("fixed.jsonl").status).toBe(1);
  rmSync(join(folder, "anew.jsonl"));
  fixed("anew.jsonl");
  expect(digestOf("fixed.jsonl")).toBe(digestOf("anew.jsonl"));
});

test("several folders and files are planned together", () => {
  for (const name of ["one", "two"]) mkdirSync(join(folder, name));
  for (const file of ["one/a.json", "two/a.json", "b.json"])
    writeFileSync(join(folder, file), JSON.stringify({ ...scenario("perpendicular"), name: file }));
  writeFileSync(join(folder, "c.jsonl"), JSON.stringify({ ...scenario("perpendicular"), name: "c" }));
  const { status, out } = run(
    "batch",
    "one",
    "two/a.json",
    "b.json",
    "c.jsonl",
    "--planner",
    "eight",
    "--out",
    "several.jsonl",
    "--quiet",
  );
  expect([status, out]).toEqual([0, expect.stringContaining("4 of 4 planned")]);
  expect(
    results("several.jsonl")
      .map(({ scene }) => scene)
      .sort(),
  ).toEqual(["b.json", "c.jsonl:1", "one/a.json", "two/a.json"]);
  expect(run("batch", "one", "nowhere", "--out", "several.jsonl").err).toBe(
    "parkade: nowhere: no such file or folder\n",
  );
});

test("a plan that takes too long is given up, named and tried again later; the others are planned", () => {
  mkdirSync(join(folder, "late"));
  const slow = scenario("perpendicular");
  slow.obstacles?.push(...slowly(3000));
  writeFileSync(join(folder, "late/slow.json"), JSON.stringify(slow));
  for (const name of ["a", "b", "c"])
    writeFileSync(join(folder, `late/${name}.json`), JSON.stringify({ ...scenario("perpendicular"), name }));
  const late = () => run("batch", "late", "--out", "late.jsonl", "--quiet", "--jobs", "1", "--timeout", "2");
  const { status, out, err } = late();
  expect([status, out]).toEqual([
    1,
    expect.stringContaining("4 of 4 planned (4 now): 3 found, 0 without a path, 1 refused"),
  ]);
  expect(err).toBe("parkade: late/slow.json (hybrid): took longer than 2 s\n");
  expect(late().out).toContain("(1 now)");
  expect(run("digest", "late.jsonl")).toMatchObject({ status: 0, out: expect.stringContaining(" 4 results") });
}, 60_000);

test("a file that holds something else is refused before anything is planned", () => {
  writeFileSync(join(folder, "other.jsonl"), '{"a":1}\n');
  const { status, err } = run("batch", "few", "--out", "other.jsonl");
  expect([status, err]).toEqual([2, "parkade: other.jsonl:1: is no result of `parkade batch`\n"]);
  expect(lines("other.jsonl")).toEqual(['{"a":1}']);
});

test(
  "after a trap threads are replaced: what failed is tried once more, and nothing else is lost, repeated or " +
    "blamed",
  async () => {
    const { planned } = (await import(/* @vite-ignore */ pathToFileURL(join(PACKAGE, "cli/batch.js")).href)) as {
      planned(...args: unknown[]): Promise<boolean>;
    };
    type Done = { line: string; result: { key: string; error?: { code: string } } };
    const TRAPS = new Map([
      ["7", 1],
      ["23", 2],
      ["24", 1],
    ]); // by task: how often its plan traps
    let dead = false,
      recycled = 0;
    const pool = {
      async run(group: { key: string }[]) {
        await Promise.resolve();
        const done: Done[] = [];
        for (const { key } of group) {
          if (dead) break;
          const traps = TRAPS.get(key) ?? 0;
          if (traps > 0) TRAPS.set(key, traps - 1);
          dead = traps > 0;
          done.push({ line: `${key}\n`, result: { key, ...(dead && { error: { code: "internal" } }) } });
        }
        return { done, ms: done.length };
      },
      async recycleWorkers() {
        await Promise.resolve();
        dead = false;
        recycled++;
      },
    };
    const written: Done["result"][] = [];
    let text = "";
    const stopped = await planned(
      pool,
      Array.from({ length: 100 }, (_, key) => ({ key: `${key}` })),
      2,
      (lines: string, results: Done["result"][]) => {
        text += lines;
        written.push(...results);
      },
    );
    expect(stopped).toBe(false);
    expect(written.map(({ key }) => Number(key)).sort((a, b) => a - b)).toEqual(
      Array.from({ length: 100 }, (_, i) => i),
    );
    expect(text).toBe(written.map(({ key }) => `${key}\n`).join(""));
    expect(written.filter(({ error }) => error !== undefined).map(({ key }) => key)).toEqual(["23"]);
    expect(recycled).toBe(4);
  },
);
