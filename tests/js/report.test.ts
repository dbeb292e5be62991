import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { asyncBufferFromFile, parquetMetadataAsync, parquetReadObjects } from "hyparquet";
import { Planner, generateScenario, init, scenario } from "parkade";
import { parkade } from "./pack";

let folder = "";
const run = (...args: string[]) => parkade(args, folder);
const results = (file: string) =>
  readFileSync(join(folder, file), "utf8")
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line));

beforeAll(async () => {
  await init();
  folder = mkdtempSync(join(tmpdir(), "parkade-report-"));
  mkdirSync(join(folder, "scenes"));
  for (let seed = 0; seed < 12; seed++)
    writeFileSync(
      join(folder, `scenes/${seed}.json`),
      JSON.stringify(generateScenario({ family: "random", size: 20, seed })),
    );
  writeFileSync(join(folder, "scenes/closed.json"), JSON.stringify(closed()));
  writeFileSync(join(folder, "scenes/wrong.json"), JSON.stringify({ ...scenario("parallel"), vehicle: "seden" }));
}, 60_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** A wall from side to side. */
function closed() {
  const scene = scenario("perpendicular"),
    { origin, width, resolution } = scene.map;
  const middle = (scene.start.y + 3 * resolution + origin[1]) / 2;
  return {
    ...scene,
    name: "closed",
    obstacles: [
      {
        type: "wall",
        points: [
          [origin[0] - 1, middle],
          [origin[0] + width * resolution + 1, middle],
        ],
        thickness: 0.2,
      },
    ],
  };
}

test("a sweep plans every combination, with the settings of a single plan", () => {
  run(
    ...["batch", "scenes/0.json", "--planner", "eight", "--set", "corner=strict", "--out", "sweep.jsonl", "--quiet"],
    ...["--sweep", "heuristic=octile,euclid", "--sweep", "margin=0,0.03,0.1"],
  );
  const all = results("sweep.jsonl");
  expect(all.map(({ settings }) => JSON.stringify(settings)).sort()).toEqual(
    ["euclid", "octile"]
      .flatMap((heuristic) => [0, 0.03, 0.1].map((margin) => ({ corner: "strict", heuristic, margin })))
      .map((one) => JSON.stringify(one))
      .sort(),
  );
  for (const { settings, hash, sceneHash } of all) {
    const planner = new Planner("eight", JSON.parse(readFileSync(join(folder, "scenes/0.json"), "utf8")), settings);
    expect(planner.plan().hash).toBe(hash);
    expect(sceneHash).toBe(all[0].sceneHash);
    planner.free();
  }
  expect(new Set(all.map(({ key }) => key)).size).toBe(6);
});

test("wrong sweeps are refused before anything is planned", () => {
  const refused = (...args: string[]) => {
    const { status, err } = run("batch", "scenes/0.json", "--planner", "eight", "--out", "no.jsonl", ...args);
    expect(status).toBe(2);
    return err;
  };
  expect(refused("--sweep", "margin")).toContain("--sweep margin: must be NAME=VALUE,VALUE…");
  expect(refused("--sweep", "margn=1,2")).toContain("--sweep margn=1: eight has no such setting; did you mean margin?");
  expect(refused("--sweep", "margin=1,1")).toContain("has a value twice");
  expect(refused("--set", "margin=0", "--sweep", "margin=1,2")).toContain("margin is set already");
  const many = Array.from({ length: 101 }, (_, i) => i).join();
  expect(refused("--sweep", `margin=${many}`, "--sweep", `trapMouth=${many}`)).toContain("at most 10000 combinations");
});

test("columns have the newest result of each key, the numbers as they were", async () => {
  run("batch", "scenes", "--planner", "four,eight", "--out", "all.jsonl", "--quiet");
  expect(run("columns", "all.jsonl", "--out", "all.parquet").out).toBe("all.parquet: 28 results\n");
  const file = await asyncBufferFromFile(join(folder, "all.parquet"));
  const metadata = await parquetMetadataAsync(file);
  expect(metadata.key_value_metadata).toContainEqual({ key: "parkade.results", value: "1" });
  const rows = await parquetReadObjects({ file });
  const lines = results("all.jsonl");
  expect(rows.map(({ key }) => key).sort()).toEqual(lines.map(({ key }) => key).sort());
  for (const line of lines) {
    const row = rows.find(({ key }) => key === line.key)!;
    expect([row["planner"], row["outcome"], row["hash"]]).toEqual([
      line.planner,
      line.outcome ?? null,
      line.hash ?? null,
    ]);
    expect(row["length"]).toBe(line.metrics?.length ?? null);
    expect(row["expanded"]).toBe(line.stats ? BigInt(line.stats.expanded) : null);
    expect(row["error_code"]).toBe(line.error?.code ?? null);
  }
});

/** Rows of a table after a heading, cells as text. */
function tableAfter(html: string, heading: string): string[][] {
  const table = html.slice(html.indexOf(heading)).match(/<table>.*?<\/table>/s)![0];
  return [...table.matchAll(/<tr>(.*?)<\/tr>/gs)].map(([, row]) =>
    [...row!.matchAll(/<t[hd][^>]*>(.*?)<\/t[hd]>/g)].map(([, cell]) => cell!),
  );
}

test("the report counts, from lines and from columns alike", () => {
  expect(run("report", "all.jsonl", "--out", "lines.html").out).toBe(
    "lines.html: 28 results of 2 planners with settings\n",
  );
  run("report", "all.parquet", "--out", "columns.html");
  const [html, other] = ["lines.html", "columns.html"].map((file) => readFileSync(join(folder, file), "utf8"));
  expect(other!.replace("all.parquet", "all.jsonl")).toBe(html);
  const lines = results("all.jsonl");
  const of = (planner: string) => lines.filter((line) => line.planner === planner);
  const [, eight, four] = tableAfter(html!, "<h2>Outcomes");
  for (const [row, planner] of [
    [eight, "eight"],
    [four, "four"],
  ] as const) {
    const found = of(planner).filter(({ outcome }) => outcome === "found").length;
    expect(row!.slice(0, 3)).toEqual([planner, "14", String(found)]);
    expect(row!.slice(4, 6)).toEqual([String(13 - found), "1"]);
  }
  const lengths = of("eight").flatMap(({ outcome, metrics }) => (outcome === "found" ? metrics.length : []));
  lengths.sort((a, b) => a - b);
  const row = tableAfter(html!, "<h3>Length")[1]!;
  expect([row[2], row[8]]).toEqual([lengths[0].toFixed(2), lengths.at(-1).toFixed(2)]);
  // Of the row against the column: wins, ties and losses.
  const duels = tableAfter(html!, "<h3>Wins").slice(1);
  const counts = duels[0]![2]!.split(" / ").map(Number);
  expect(duels[1]![1]!.split(" / ").map(Number)).toEqual([...counts].reverse());
  expect(counts.reduce((sum, count) => sum + count)).toBe(14);
  const better = of("eight").filter(({ sceneHash, metrics }) => {
    const rival = of("four").find((line) => line.sceneHash === sceneHash);
    return (metrics?.length ?? Infinity) < (rival.metrics?.length ?? Infinity) - 1e-6;
  });
  expect(counts[0]).toBe(better.length);
});

test("reports of nothing and of other files are refused in words", () => {
  writeFileSync(join(folder, "text.parquet"), "no columns at all");
  writeFileSync(join(folder, "empty.jsonl"), "");
  const refused = (...args: string[]) => {
    const { status, err } = run(...args);
    expect([status, err.split("\n").length]).toEqual([2, 2]);
    return err;
  };
  expect(refused("report")).toContain("which files?");
  expect(refused("report", "text.parquet")).toContain("text.parquet: is no Parquet file");
  expect(refused("report", "missing.parquet")).toContain("there is no such file");
  expect(refused("report", "scenes/0.json")).toContain("is no result of `parkade batch`");
  expect(refused("report", "empty.jsonl")).toContain("no results");
  expect(refused("report", "all.jsonl", "--out", "scenes")).toContain("scenes: is a folder");
  expect(refused("columns", "all.jsonl", "--out", "scenes")).toContain("scenes: is a folder");
  expect(refused("columns", "all.parquet")).toContain("is in columns already");
});

test("names in a report are text, whatever they are", () => {
  const line = { key: "a", scene: "<script>", planner: "<b>x</b>", settings: { note: '"<i>' }, outcome: "found" };
  writeFileSync(join(folder, "odd.jsonl"), `${JSON.stringify(line)}\n`);
  run("report", "odd.jsonl", "--out", "odd.html");
  const html = readFileSync(join(folder, "odd.html"), "utf8");
  expect(html).toContain("&lt;b&gt;x&lt;/b&gt; note=&quot;");
  expect(html).not.toMatch(/<script|<b>|<i>/);
});
