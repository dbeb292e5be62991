import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, truncateSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Planner, checkPath, generateScenario, init, scenario, scenarios, toCSV, trajectory, type Plan } from "parkade";
import { PACKAGE, parkade, slowly } from "./pack";

let folder = "";
const run = (args: string[], input?: string) => parkade(args, folder, input);
const write = (name: string, value: unknown) =>
  writeFileSync(join(folder, name), typeof value === "string" ? value : JSON.stringify(value));

beforeAll(async () => {
  await init();
  folder = mkdtempSync(join(tmpdir(), "parkade-"));
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

test("plan prints the plan as the library has it, from a file, an id or standard input", () => {
  write("scene.json", scenario("perpendicular"));
  const plan = new Planner("hybrid", scenario("perpendicular"), { reverseCost: 1.5 }).plan();
  for (const [place, input] of [
    ["scene.json", ""],
    ["perpendicular", ""],
    ["-", JSON.stringify(scenario("perpendicular"))],
  ] as const) {
    const { status, out, err } = run(["plan", place, "--set", "reverseCost=1.5"], input);
    expect([status, err]).toEqual([0, ""]);
    const printed: Plan = JSON.parse(out);
    expect(printed.hash).toBe(plan.hash);
    expect(printed.path).toEqual([...plan.path]);
  }
});

test("plan reads maps of other programs with their questions and pictures", () => {
  mkdirSync(join(folder, "maps"), { recursive: true });
  write("maps/room.map", "type octile\nheight 4\nwidth 6\nmap\n......\n.@@@@.\n......\n......\n");
  write("maps/room.map.scen", "version 1\n0\troom.map\t6\t4\t0\t0\t5\t3\t7.24264069\n");
  const { status, out } = run(["plan", "maps/room.map", "--planner", "eight"]);
  expect([status, JSON.parse(out).outcome]).toEqual([0, "found"]);
  write("maps/yard.pgm", `P2\n5 4\n255\n${"254 ".repeat(20)}\n`);
  write(
    "maps/yard.yaml",
    "image: yard.pgm\nresolution: 2\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
  );
  expect(run(["check", "maps/yard.yaml"]).out).toMatch(/^ok:/);
});

test("a path's CSV has a row for each pose, distances that add up, and passes the checker as CSV and as JSON", () => {
  write("path.csv", run(["plan", "perpendicular", "--format", "csv"]).out);
  write("plan.json", run(["plan", "perpendicular"]).out);
  const plan: Plan = JSON.parse(readFileSync(join(folder, "plan.json"), "utf8"));
  const [head, ...rows] = readFileSync(join(folder, "path.csv"), "utf8").trim().split("\n");
  expect(head).toBe("s,x,y,theta,kappa,clearance,v,direction,t");
  expect(rows).toHaveLength(plan.path.length / 3);
  expect(Number(rows.at(-1)!.split(",")[0])).toBeCloseTo(plan.metrics.length, 1);
  const speeds = rows.map((row) => Number(row.split(",")[6]));
  expect(Math.max(...speeds)).toBeGreaterThan(1);
  expect(Math.max(...speeds)).toBeLessThanOrEqual(2);
  expect(Number(rows.at(-1)!.split(",")[8])).toBeCloseTo(trajectory(scenario("perpendicular"), plan).duration, 5);
  expect(toCSV(scenario("perpendicular"), plan)).toBe(readFileSync(join(folder, "path.csv"), "utf8"));
  // In JSON the curvature of a corner is null.
  const corners: Plan = JSON.parse(run(["plan", "perpendicular", "--planner", "eight"]).out);
  expect([...corners.curvatures]).toContain(null);
  expect(toCSV(scenario("perpendicular"), corners)).toBe(
    run(["plan", "perpendicular", "--planner", "eight", "--format", "csv"]).out,
  );
  for (const file of ["path.csv", "plan.json"])
    expect(run(["check", "perpendicular", file])).toMatchObject({ status: 0, err: "" });
});

test("check says what is wrong with a path, by its exit code too", () => {
  write("corners.csv", run(["plan", "perpendicular", "--planner", "four", "--format", "csv"]).out);
  const { status, out } = run(["check", "perpendicular", "corners.csv"]);
  expect(status).toBe(1);
  expect(out).toMatch(/^collides: overlaps at \d+ poses/);
  const plan = new Planner("four", scenario("perpendicular")).plan();
  expect(JSON.parse(run(["check", "perpendicular", "corners.csv", "--format", "json"]).out).hits).toBe(
    checkPath(scenario("perpendicular"), plan.path).hits,
  );
});

test("a plan's trajectory passes the referee, one that is damaged is refused by line and column", () => {
  expect(run(["plan", "reverse-in", "--format", "trajectory", "--out", "driven.csv"]).status).toBe(0);
  const { status, out } = run(["judge", "reverse-in", "driven.csv"]);
  expect([status, out.split("\n")[0]]).toEqual([0, "passes: goal attained, limits kept"]);
  expect(JSON.parse(run(["judge", "reverse-in", "driven.csv", "--format", "json"]).out)).toMatchObject({
    passes: true,
    touchingFrames: 0,
  });
  expect(run(["judge", "reverse-in", "driven.csv", "--speed", "1"])).toMatchObject({ status: 1 });
  write("damaged.csv", "t,x,y,theta\n0,1,2,3\n1,1,two,3\n");
  expect(run(["judge", "reverse-in", "damaged.csv"])).toMatchObject({
    status: 2,
    err: 'parkade: damaged.csv:3:5: y must be a finite number, got "two"\n',
  });
  expect(run(["judge", "reverse-in", "driven.csv", "--speed", "fast"]).err).toBe(
    "parkade: --speed fast: must be a number\n",
  );
}, 60_000);

test("no path is exit code 1, with the reason on standard error", () => {
  const scene = scenario("perpendicular");
  write("shut.json", {
    ...scene,
    obstacles: [
      ...(scene.obstacles ?? []),
      { type: "rectangle", center: [scene.start.x, scene.start.y], size: [3, 3] },
    ],
  });
  const { status, err } = run(["plan", "shut.json", "--planner", "eight"]);
  expect(status).toBe(1);
  expect(err).toMatch(/start-blocked/);
});

test("several scenes and planners give a line each, which begins with the scene", () => {
  write("room.json", generateScenario({ family: "random", size: 15, seed: 3 }));
  const { status, out } = run(["plan", "perpendicular", "room.json", "--planner", "eight,hybrid"]);
  const lines = out
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line) as { scene: string; planner: string; hash: string });
  expect(lines.map(({ scene, planner }) => `${scene} ${planner}`)).toEqual([
    "perpendicular eight",
    "perpendicular hybrid",
    "room.json eight",
    "room.json hybrid",
  ]);
  expect([status, lines[1]!.hash]).toEqual([0, new Planner("hybrid", scenario("perpendicular")).plan().hash]);
  write("wrong.json", { version: 1 });
  expect(run(["bench", "room.json", "wrong.json"]).err).toBe("parkade: wrong.json: map: missing field\n");
});

test("bench answers for every planner with its hash and the number of runs", () => {
  const { status, out } = run([
    "bench",
    "perpendicular",
    "--planner",
    "eight,hybrid",
    "--repeats",
    "3",
    "--format",
    "json",
  ]);
  const rows: { planner: string; n: number; hash: string; medianMs: number }[] = JSON.parse(out);
  expect(status).toBe(0);
  expect(rows.map(({ planner, n }) => [planner, n])).toEqual([
    ["eight", 3],
    ["hybrid", 3],
  ]);
  expect(rows[1]!.hash).toBe(new Planner("hybrid", scenario("perpendicular")).plan().hash);
  expect(run(["bench", "perpendicular", "--planner", "eight", "--repeats", "1"]).out.split("\n")[1]).toMatch(
    /^\| --- /,
  );
});

test.each([
  [["plan", "nowhere.json"], "nowhere.json: there is no such file"],
  [["toString"], "unknown command `toString`"],
])("bad input %j is exit code 2 and one line that says so", (args, words) => {
  const { status, out, err } = run(args);
  expect([status, out]).toEqual([2, ""]);
  expect(err).toContain(`parkade: `);
  expect(err).toContain(words);
  expect(err.trim().split("\n")).toHaveLength(1);
});

test("every command explains itself", () => {
  const { status, out } = run(["--help"]);
  expect(status).toBe(0);
  for (const name of [...out.matchAll(/^ {2}(\w+) /gm)].map((match) => match[1]!)) {
    expect(run([name, "--help"])).toMatchObject({ status: 0, err: "" });
    expect(run([name, "--help"]).out).toMatch(new RegExp(`^usage: parkade ${name}`));
  }
  expect(run(["planners"]).out).toMatch(/^hybrid /m);
  expect(run(["planners", "--planner", "hybrid"]).out).toMatch(/^reverseCost /m);
  expect(JSON.parse(run(["scenarios", "--format", "json"]).out)[0]).toHaveProperty("question");
});

test("a word that is nearly right is answered by the right one", () => {
  for (const [change, meant] of [
    [{ vehicle: "sedn" }, "sedan"],
    [{ vehicle: { wheelbas: 1 } }, "wheelbase"],
    [{ obstacels: [] }, "obstacles"],
    [{ goal: { slot: "slot-3", entry: "hed-in" } }, "head-in"],
  ] as const) {
    expect(run(["plan", "-"], JSON.stringify({ ...scenario("perpendicular"), ...change }))).toMatchObject({
      status: 2,
      err: expect.stringContaining(`; did you mean ${meant}?`),
    });
  }
  expect(run(["plan", "perpendicular", "--planner", "zzzzzzzz"]).err).not.toContain("did you mean");
});

test("check refuses a scene whose car has no place at its start or goal, and says what is there", () => {
  const scene = scenario("perpendicular"),
    block = { type: "rectangle", id: "crate", center: [scene.start.x, scene.start.y], size: [1, 1] };
  write("start.json", { ...scene, obstacles: [block] });
  expect(run(["check", "start.json"])).toEqual({
    status: 1,
    out: "start-blocked: the car overlaps crate at the start\n",
    err: "",
  });
  write("goal.json", { ...scene, goal: { x: 1000, y: 0, heading: 0 } });
  expect(run(["check", "goal.json"])).toEqual({
    status: 1,
    out: "goal-blocked: the car overlaps border at the goal\n",
    err: "",
  });
  expect(JSON.parse(run(["check", "start.json", "--format", "json"]).out).blocked).toEqual([
    { end: "start", obstacle: "crate" },
  ]);
  for (const { id } of scenarios()) expect([id, run(["check", id]).status]).toEqual([id, 0]);
}, 60_000);

test("a file of more than 80 MB is refused before it is read, and so is such an input", () => {
  write("large.json", "");
  truncateSync(join(folder, "large.json"), 114_000_000);
  const words = "must have at most 80000000 bytes, has 114000000";
  for (const command of ["plan", "check"])
    expect(run([command, "large.json"])).toEqual({ status: 2, out: "", err: `parkade: large.json: ${words}\n` });
  expect(run(["check", "-"], " ".repeat(80_000_001))).toMatchObject({
    status: 2,
    err: "parkade: standard input: must have at most 80000000 bytes, has 80000001\n",
  });
  expect(run(["batch", "large.json", "--out", "large.jsonl", "--quiet"])).toMatchObject({
    status: 1,
    err: `parkade: large.json (hybrid): ${words}\n`,
  });
});

test("a command that takes longer than --timeout ends with code 124", () => {
  const scene = scenario("perpendicular");
  write("slow.json", { ...scene, obstacles: [...(scene.obstacles ?? []), ...slowly(5000)] });
  const before = performance.now(),
    late = run(["plan", "slow.json", "--timeout", "1"]);
  expect(late).toEqual({ status: 124, out: "", err: "parkade: took longer than 1 s (--timeout)\n" });
  expect(performance.now() - before).toBeLessThan(6000);
  expect(run(["plan", "perpendicular", "--trace", "--timeout", "60"])).toEqual(
    run(["plan", "perpendicular", "--trace"]),
  );
  expect(run(["check", "-", "--timeout", "60"], JSON.stringify(scene)).out).toMatch(/^ok/);
  expect(run(["plan", "nowhere.json", "--timeout", "60"])).toMatchObject({
    status: 2,
    err: expect.stringContaining("there is no such file"),
  });
  expect(run(["plan", "perpendicular", "--timeout", "soon"])).toMatchObject({
    status: 2,
    err: expect.stringContaining("--timeout soon: must be a whole number"),
  });
});

test("obstacles on the same place count once: 200 000 of them take seconds", () => {
  const scene = scenario("perpendicular"),
    block = { type: "rectangle", center: [0, 7.5], size: [1, 1] };
  const within = (count: number) => {
    write("pile.json", {
      ...scene,
      obstacles: [...(scene.obstacles ?? []), ...Array.from({ length: count }, () => block)],
    });
    return run(["plan", "pile.json", "--timeout", "100"]);
  };
  const [one, many] = [within(1), within(200_000)].map(({ status, out }) => [status, (JSON.parse(out) as Plan).hash]);
  expect(many).toEqual(one);
}, 120_000);

test("what cannot be read or written is said in a sentence, with code 2", () => {
  write("plain.json", scenario("perpendicular"));
  expect(run(["plan", "plain.json/scene.json"])).toMatchObject({
    status: 2,
    err: "parkade: plain.json/scene.json: a part of its path is a file, not a folder\n",
  });
  mkdirSync(join(folder, "some"), { recursive: true });
  write("some/a.json", scenario("perpendicular"));
  for (const out of ["plain.json/out.jsonl", "missing/out.jsonl", "some"]) {
    const { status, err } = run(["batch", "some", "--out", out, "--jobs", "1", "--quiet"]);
    expect([out, status, err.split("\n").length]).toEqual([out, 2, 2]);
    expect(err).toContain(`parkade: ${out}: `);
  }
});

test.runIf(existsSync("/dev/full"))("a full disk is said, with code 2", () => {
  write("full.json", scenario("perpendicular"));
  const command = `"${process.execPath}" "${join(PACKAGE, "cli/main.js")}"`;
  for (const [line, place] of [
    ["plan perpendicular > /dev/full", "standard output"],
    [`batch "${join(folder, "full.json")}" --planner eight --jobs 1 --quiet --out /dev/full`, "/dev/full"],
  ] as const) {
    const { status, stderr } = spawnSync("sh", ["-c", `${command} ${line}`], { encoding: "utf8" });
    expect([status, stderr]).toEqual([2, `parkade: ${place}: no space left on the device\n`]);
  }
});
