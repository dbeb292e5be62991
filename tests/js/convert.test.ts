/** `parkade scenario`, `generate`, `convert` and `completion`. */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { generateScenario, importScene, init, planners, scenario, scenarios } from "parkade";
import { FILES } from "./site-plan-files";
import { parkade } from "./pack";

let folder = "";
const run = (args: string[], input?: string) => parkade(args, folder, input);
const MAP = "type octile\nheight 4\nwidth 6\nmap\n......\n.@@@@.\n......\n......\n";
const QUESTIONS = "version 1\n0\troom.map\t6\t4\t0\t0\t5\t3\t7.24264069\n1\troom.map\t6\t4\t0\t3\t5\t3\t5\n";

beforeAll(async () => {
  await init();
  folder = mkdtempSync(join(tmpdir(), "parkade-"));
  writeFileSync(join(folder, "room.map"), MAP);
  writeFileSync(join(folder, "room.map.scen"), QUESTIONS);
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

test("scenario and generate print what the library has, and plan reads it", () => {
  for (const id of ["perpendicular", "fig16", "road-curve"]) {
    const { status, out } = run(["scenario", id]);
    expect([status, JSON.parse(out)]).toEqual([0, scenario(id)]);
  }
  const drawn = run(["generate", "--size", "30", "--seed", "9", "--density", "200", "--out", "drawn.json"]);
  expect(drawn).toEqual({ status: 0, out: "", err: "" });
  const expected = generateScenario({ family: "random", size: 30, seed: 9, densityPermille: 200 });
  expect(JSON.parse(readFileSync(join(folder, "drawn.json"), "utf8"))).toEqual(expected);
  expect(run(["plan", "drawn.json", "--planner", "eight"]).err).not.toMatch(/must/);
});

test("convert prints the scene of a map by the question that is asked, and several as lines that batch plans", () => {
  const files = { "room.map": MAP, "room.map.scen": QUESTIONS };
  for (const query of [0, 1]) {
    const { status, out } = run(["convert", "room.map", "--query", String(query), "--resolution", "2"]);
    expect([status, JSON.parse(out)]).toEqual([0, importScene(files, { query, resolution: 2 }).scene]);
  }
  writeFileSync(join(folder, "own.json"), JSON.stringify(scenario("perpendicular")));
  expect(run(["convert", "room.map", "own.json", "--format", "jsonl", "--out", "all.jsonl"]).status).toBe(0);
  expect(readFileSync(join(folder, "all.jsonl"), "utf8").trim().split("\n")).toHaveLength(2);
  expect(run(["batch", "all.jsonl", "--planner", "eight", "--quiet", "--jobs", "1"]).status).toBe(0);
});

test("site plans of each format are scenes, by what their layers are called or said to be", () => {
  for (const [name, content] of Object.entries(FILES)) {
    writeFileSync(join(folder, name), content);
    const { out, status, err } = run(["convert", name, ...(name.endsWith(".svg") ? ["--unit", "0.1"] : [])]);
    expect([name, status, err.includes("internal")]).toEqual([name, 0, false]);
    expect((JSON.parse(out) as { slots: unknown[] }).slots).toHaveLength(10);
  }
  expect(run(["convert", "lot.dxf"]).err.match(/Left out/g)).toHaveLength(1);
  // Drawn in metres by a program that says millimetres: the unit is the one that the page proposes.
  const metres = FILES["lot.dxf"]!.replace(
    /^( *[12][01]\n)(.+)$/gm,
    (_, code: string, n: string) => code + Number(n) / 1000,
  );
  writeFileSync(join(folder, "metres.dxf"), metres);
  const { slots } = JSON.parse(run(["convert", "metres.dxf"]).out) as { slots: { width: number }[] };
  expect(slots.map(({ width }) => width)).toEqual(Array.from({ length: 10 }, () => 2.5));
  const [geojson] = Object.keys(FILES).filter((name) => name.endsWith(".geojson"));
  expect(run(["check", geojson!]).out).toMatch(/^ok: .* 10 slots/);
  expect(run(["convert", geojson!, "--role", "nothing=wall"]).err).toMatch(
    /--role nothing=wall: there is no such layer; there are /,
  );
});

test("standard input that is no scene is refused in words", () => {
  const { status, out, err } = run(["convert", "-"]);
  expect([status, out]).toEqual([2, ""]);
  expect(err).toContain("standard input: is not JSON");
});

test("bash completes commands, options, planners and scenes", () => {
  const { out } = run(["completion", "bash"]);
  const completed = (...words: string[]): string[] => {
    const asked = `${out}\nCOMP_WORDS=(${words
      .map((word) => `"${word}"`)
      .join(" ")}); COMP_CWORD=${words.length - 1}; _parkade; printf '%s\n' "\${COMPREPLY[@]}"`;
    return spawnSync("bash", ["-c", asked], { encoding: "utf8" }).stdout.trim().split("\n");
  };
  expect(completed("parkade", "sce")).toEqual(["scenarios", "scenario"]);
  expect(completed("parkade", "batch", "--sh")).toEqual(["--shard"]);
  expect(completed("parkade", "plan", "--planner", "")).toEqual(planners().map(({ id }) => id));
  expect(completed("parkade", "plan", "perp")).toEqual(
    scenarios()
      .map(({ id }) => id)
      .filter((id) => id.startsWith("perp")),
  );
  for (const shell of ["zsh", "fish"]) expect(run(["completion", shell]).out).toContain("perpendicular");
});
