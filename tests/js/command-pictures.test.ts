import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Planner, generateScenario, init, scenario, scenarios, toCSV, toSVG, type Plan } from "parkade";
import { parkade } from "./pack";

let folder = "";
const run = (args: string[], input?: string) => parkade(args, folder, input);

beforeAll(async () => {
  await init();
  folder = mkdtempSync(join(tmpdir(), "parkade-"));
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

test("the SVG picture is well formed, holds the scene, and draws each planner's line", () => {
  const scene = { ...scenario("perpendicular"), name: 'a "name" <with> & signs' };
  const plans = (["eight", "hybrid"] as const).map((planner) => new Planner(planner, scene).plan());
  const svg = toSVG(scene, plans, { width: 640, height: 360, theme: "light" });
  const metadata = /<metadata>([^]*?)<\/metadata>/
    .exec(svg)![1]!
    .replace(/&#(\d+);/g, (_, code) => String.fromCharCode(Number(code)));
  expect(JSON.parse(metadata)).toEqual(scene);
  expect(svg).toContain('width="640" height="360"');
  expect(svg).toContain("#D55E00");
  expect(svg).toContain("#CC79A7");
  expect(svg).not.toMatch(/NaN|undefined|<with>/);
  const [plan] = plans,
    plain = {
      ...plan!,
      path: [...plan!.path],
      curvatures: [...plan!.curvatures],
      clearances: [...plan!.clearances],
      trace: null,
    };
  expect(
    toSVG(
      scene,
      JSON.parse(JSON.stringify({ ...plain, check: { ...plan!.check, hitPoses: [...plan!.check.hitPoses] } })) as Plan,
    ),
  ).toBe(toSVG(scene, { ...plan!, trace: null }));
  const bad = (change: object) => () => toSVG(scene, { ...plan!, ...change } as Plan);
  expect(bad({ check: { ...plan!.check, hitPoses: null } })).toThrow(
    "plan.check.hitPoses: must be an array of numbers, got null",
  );
  expect(bad({ clearances: [1, "2"] })).toThrow('plan.clearances[1]: must be a number, got "2"');
  expect(bad({ metrics: null })).toThrow("plan.metrics: must be an object, got null");
  expect(bad({ outcome: "no-path", obstruction: { kind: "gap", x: 10n, y: 1, width: 2, needed: 3 } })).toThrow(
    /^plans: must be as planners answer them: .*BigInt/,
  );
  expect(() => toSVG(scene, plans, { width: 0 })).toThrow("width: must be 16 to 8192 pixels, got 0");
  expect(() => toSVG(scene, plans, { controls: "full" as "none" })).toThrow(
    'controls: must be none or minimal, got "full"',
  );
  expect(() => toSVG(scene, plans, { camera: { x: 0, y: 0, scale: 0 } })).toThrow(
    "camera.scale: must be a positive number, got 0",
  );
  const own = { hybrid: plans[1]!.path };
  const [without, withPlanned] = [{}, own].map(
    (planned) => toSVG(scene, plans[1]!, { theme: "light", planned }).split("<path").length,
  );
  expect(withPlanned).toBe(without! + 1);
  expect(() => toSVG(scene, plans, { planned: { hybrid: [1, "2" as unknown as number] } })).toThrow(
    "planned.hybrid[1]: must be a number",
  );
  const { status, out } = run(["plan", "perpendicular", "--format", "svg", "--size", "300x200"]);
  expect([status, out.slice(0, 4), out.includes('width="300" height="200"')]).toEqual([0, "<svg", true]);
});

test("a picture is a playground's poster where its layout is given, of one planner or several", () => {
  const { status, out } = run([
    "plan",
    "perpendicular",
    "--planner",
    "eight,hybrid",
    "--format",
    "svg",
    "--layout",
    "single",
    "--controls",
    "minimal",
    "--theme",
    "light",
  ]);
  expect([status, /<svg y="(\d+)" width="(\d+)" height="(\d+)">/.exec(out)?.slice(1)]).toEqual([
    0,
    ["32", "720", "344"],
  ]);
  expect(out).toMatch(/stroke:#D55E00[^]*stroke:#CC79A7/);
  expect(run(["plan", "perpendicular", "--format", "svg", "--planner", "risk-field", "--theme", "light"]).out).toMatch(
    /<pattern/,
  );
});

test("every preset has a picture, with a plan that fails and without one", () => {
  for (const { id } of scenarios()) {
    const scene = scenario(id),
      plan = new Planner("eight", scene).plan();
    for (const plans of [[], [plan]]) expect(toSVG(scene, plans), id).toMatch(/^<svg/);
  }
});

test("every kind of obstacle is drawn, also paths that no car drives", () => {
  const cells = generateScenario({ family: "random", size: 21, seed: 3 });
  const plan = new Planner("eight", cells).plan();
  const filled = (svg: string, colour: string) =>
    [...svg.matchAll(/\.(k\w+)\{fill:(#\w+)\}/g)]
      .filter(([, , fill]) => fill === colour)
      .reduce((sum, [, name]) => sum + svg.split(`class="${name}"`).length - 1, 0);
  expect(filled(toSVG(cells, plan, { theme: "light" }), "#B4B8BE")).toBe(1);
  expect(toCSV(cells, plan).split("\n")[1]!.split(",")[6]).toBe("");
  const scene = {
    ...scenario("perpendicular"),
    obstacles: [
      {
        type: "wall",
        points: [
          [1, 1],
          [3, 1],
        ],
        thickness: 0.2,
      },
      {
        type: "polygon",
        points: [
          [1, 2],
          [2, 2],
          [2, 3],
        ],
      },
      { type: "rectangle", center: [3, 3], size: [1, 2], heading: 0.3 },
      { type: "car", pose: { x: 3, y: 8, heading: 1 }, vehicle: "sedan" },
    ],
  } as ReturnType<typeof scenario>;
  const svg = toSVG(scene, [], { theme: "light" });
  expect([svg.split('stroke-linejoin="round"').length > 5, filled(svg, "#B4B8BE"), filled(svg, "#D5D8DC")]).toEqual([
    true,
    2,
    1 + scene.slots!.filter(({ occupied }) => occupied).length,
  ]);
});
