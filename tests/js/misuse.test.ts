/** What people get wrong is answered by a sentence that helps: never by a stack, a trap, or a guess. */
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import * as parkade from "parkade";
import { afterAll, afterEach, beforeAll, expect, test, vi } from "vitest";
import { check, faultOfAttribute, RULES, ValueError } from "../../www/src/app/schema";
import { ATTRIBUTES, COMMAND_LINES } from "./misuse-lines";
import { misusesOfApi } from "./misuses";
import { PACKAGE } from "./pack";
import { FILES } from "./site-plan-files";

const LONGEST = 600;
/** Words of engines, not of people. */
const RAW = new RegExp(
  [
    /\n\s+at |\[object |undefined is|is not a function|Cannot (read|set|convert)/,
    /panicked|unreachable|recursive|E[A-Z]{4,}:/,
  ]
    .map(({ source }) => source)
    .join("|"),
);

let folder = "";
let answer: (args: string[]) => Promise<number>;

beforeAll(async () => {
  const run = (await import(/* @vite-ignore */ pathToFileURL(join(PACKAGE, "cli/run.js")).href)) as {
    answer: typeof answer;
  };
  answer = run.answer;
  folder = mkdtempSync(join(tmpdir(), "parkade-"));
  // The command loads the module, from its own bytes.
  vi.spyOn(process.stdout, "write").mockReturnValue(true);
  expect(await answer(["version"])).toBe(0);
  vi.restoreAllMocks();
  const scene = JSON.stringify(parkade.scenario("perpendicular"));
  for (const name of ["folder", "empty"]) mkdirSync(join(folder, name));
  for (const [name, text] of Object.entries({
    "a.json": scene,
    "folder/b.json": scene,
    "text.json": "park here",
    "empty.json": "",
    "list.json": "[1]",
    "a.map": "a map\n",
    "room.map": "type octile\nheight 1\nwidth 3\nmap\n...\n",
    "room.map.scen": "version 1\n0 room.map 3 1 0 0 2 0 2\n",
    "picture.png": "PNG",
    "lot.geojson": Object.entries(FILES).find(([name]) => name.endsWith(".geojson"))![1],
    "bad.geojson": "{}",
    "bad.dxf": "no drawing",
    "bad.svg": "<html></html>",
    "bad.csv": "x,y,theta\n1,2,north\n",
    "short.csv": "x,y\n1,2\n",
    "good.csv": "x,y,theta\n1,2,0\n1.1,2,0\n",
    "text.parquet": "PAR",
    "x.parquet": "PAR",
    "nothing.jsonl": "",
    "results.jsonl": `${JSON.stringify({ key: "k", scene: "s", planner: "eight", settings: {}, outcome: "found" })}\n`,
  }))
    writeFileSync(join(folder, name), text);
});
afterEach(() => vi.restoreAllMocks());
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const said: string[] = [];
/** One line that a person can read. */
function expectSentence(message: string, about: string): void {
  said.push(`${about} -> ${message}`);
  expect(message, about).not.toMatch(RAW);
  expect(message.length, about).toBeLessThan(LONGEST);
  expect(message, about).toMatch(/\w+ \w+/);
  expect(message, about).not.toContain("\n");
}

test("wrong calls are answered by an error that names the field and the rule", () => {
  for (const { name, field, call } of misusesOfApi()) {
    let thrown: unknown;
    try {
      call();
    } catch (error) {
      thrown = error;
    }
    expect(thrown, name).toBeInstanceOf(parkade.ParkadeError);
    const { path, message } = thrown as parkade.ParkadeError;
    // A list of goals is right, so its first entry is what is wrong.
    expect(path, `${name}: ${message}`).toBe(name.endsWith("goal = [1]") ? "goal[0]" : field);
    expectSentence(message, name);
  }
});

test("wrong command lines are answered by one line on standard error, with code 2", async () => {
  const print = vi.spyOn(process.stdout, "write").mockReturnValue(true);
  const complain = vi.spyOn(process.stderr, "write").mockReturnValue(true);
  const before = process.cwd();
  process.chdir(folder);
  for (const [line, words] of COMMAND_LINES) {
    print.mockClear();
    complain.mockClear();
    const code = await answer(line.split(" ").filter(Boolean));
    const message = complain.mock.calls.map(([text]) => String(text)).join("");
    expect([code, print.mock.calls.length], `${line}: ${message}`).toEqual([2, 0]);
    expect(message, line).toContain(words);
    expect(message.endsWith("\n"), line).toBe(true);
    expectSentence(message.slice(0, -1), line);
  }
  process.chdir(before);
});

test("wrong values of the element are answered by field, value and rule", () => {
  const scene = parkade.scenario("perpendicular"),
    known = { planners: parkade.planners(), map: scene.map };
  for (const [name, ...texts] of ATTRIBUTES)
    for (const text of texts) {
      const fault = faultOfAttribute(name, text);
      expect(fault?.field.startsWith(name), `${name}="${text}"`).toBe(true);
      expectSentence(fault!.message, `${name}="${text}"`);
    }
  const values: [field: string, rule: Parameters<typeof check>[1], ...values: unknown[]][] = [
    ["playhead", RULES.playhead(), -1, 2, "half", null, Number.NaN, undefined],
    [
      "camera",
      RULES.camera(known),
      3,
      "fit",
      {},
      { x: 0, y: 0 },
      { x: 0, y: 0, scale: 0 },
      { x: "0", y: 0, scale: 9 },
      [],
    ],
    ["seek.options", RULES.seekOptions(), 1, { base: "time" }, { bas: "drive" }],
    ["toBlob.options", RULES.blobOptions(), "png", { type: "image/bmp" }, { kind: "image/png" }],
    ["openLink", RULES.link(), 7, null, {}],
    [
      "params",
      RULES.params(known),
      7,
      [],
      { hybird: {} },
      { hybrid: 1 },
      { hybrid: { margn: 1 } },
      { eight: { corner: 3 } },
    ],
    ["planners", RULES.planners(known), "hybrid", [], ["hybird"], ["eight", "eight"]],
  ];
  for (const [field, rule, ...wrong] of values)
    for (const value of wrong) {
      let thrown: unknown;
      try {
        check(value, rule, field);
      } catch (error) {
        thrown = error;
      }
      expect(thrown, field).toBeInstanceOf(ValueError);
      expect((thrown as ValueError).field.startsWith(field), (thrown as Error).message).toBe(true);
      expectSentence((thrown as Error).message, `${field} = ${JSON.stringify(value)}`);
    }
});

test("these are more than 500 that differ", () => {
  const kinds = new Set(said);
  if (process.env["PARKADE_MISUSES"]) writeFileSync(process.env["PARKADE_MISUSES"], [...kinds].join("\n"));
  expect(kinds.size).toBeGreaterThan(500);
});
