/** Plans on paper and as DXF: true to scale, and read again as they were written. */
import { init, Planner, scenario as given, type Plan } from "parkade";
import { beforeAll, expect, it } from "vitest";
import { ensureIds } from "../../www/src/scene/model";
import type { Scenario } from "../../www/src/scene/scenario";
import { wayCsv } from "../../www/src/panels/way-csv";
import { dxfOf } from "../../www/src/picture/dxf-file";
import { boxOfDrawing, PAPERS, paperFor, printPage, SCALES, sheetSvg } from "../../www/src/picture/scale-sheet";
import { DRAWING_LAYERS, siteDrawing } from "../../www/src/picture/site-drawing";
import { readSitePlan } from "../../www/src/siteplan/read-site-plan";

const scenario = (id: string) => ensureIds(given(id));

let scene: Scenario, plan: Plan;
beforeAll(async () => {
  await init();
  scene = scenario("perpendicular");
  using planner = new Planner("hybrid", scene);
  plan = planner.plan();
});

const sheetOf = (scale: number) =>
  sheetSvg({
    drawing: siteDrawing(scene, plan, { every: 2 }),
    shown: new Set(DRAWING_LAYERS),
    areas: [],
    scale,
    title: "A <lot>",
    rows: [["Scale", `1:${scale}`]],
    legend: [],
  });

it("a drawing has every layer of the scene and its manoeuvre", () => {
  const { lines, texts } = siteDrawing(scene, plan, { every: 2 });
  expect(new Set([...lines, ...texts].map(({ layer }) => layer))).toEqual(new Set(DRAWING_LAYERS));
  // The body's outline holds the axle's way, whose ends are the plan's.
  const path = lines.find(({ layer }) => layer === "path")!.points;
  expect(path[0]).toEqual([plan.path[0], plan.path[1]]);
  expect(lines.filter(({ layer }) => layer === "wheels")).toHaveLength(4);
  const outlines = (every: number) =>
    siteDrawing(scene, plan, { every }).lines.filter(({ layer }) => layer === "outlines");
  expect(outlines(1).length).toBeGreaterThan(outlines(4).length);
  expect(outlines(0)).toHaveLength(0);
});

it("the narrowest place is dimensioned as the checker measured it", () => {
  const { texts } = siteDrawing(scene, plan, { every: 2 });
  expect(texts.filter(({ layer }) => layer === "dimensions").map(({ text }) => text)).toEqual([
    `${plan.metrics.minClearance.toFixed(2)} m`,
  ]);
});

it("DXF is read again with the same lines on the same layers", () => {
  const drawing = siteDrawing(scene, plan, { every: 2 }),
    read = readSitePlan("out.dxf", dxfOf(drawing));
  expect(read.metresPerUnit).toBe(1);
  for (const { name, lines } of read.layers) {
    const written = drawing.lines.filter(({ layer }) => layer.toUpperCase() === name);
    expect(lines.length, name).toBe(written.length);
    lines.forEach(({ points, closed }, i) => {
      expect(closed).toBe(written[i]!.closed);
      points.forEach(([x, y], k) => {
        if (points.length !== written[i]!.points.length) return;
        expect(Math.hypot(x - written[i]!.points[k]![0], y - written[i]!.points[k]![1])).toBeLessThan(1e-4);
      });
    });
  }
  expect(read.layers.map(({ name }) => name)).toContain("BODY");
  expect(dxfOf(drawing, new Set(["path"]))).not.toContain("\r\nBODY\r\n10");
});

it.each(SCALES)("at 1:%i a metre is so many millimetres", (scale) => {
  const { svg, paper } = sheetOf(scale),
    [width, height] = PAPERS[paper];
  expect(svg).toContain(`width="${width}mm" height="${height}mm" viewBox="0 0 ${width} ${height}"`);
  const ground = /<g id="ground"><path d="M([^"]*)Z"/
    .exec(svg)![1]!
    .split("L")
    .map((pair) => pair.split(" ").map(Number));
  const across = Math.max(...ground.map(([x]) => x!)) - Math.min(...ground.map(([x]) => x!)),
    box = boxOfDrawing(siteDrawing(scene, null, { every: 0 }));
  expect(across).toBeCloseTo(((box.maxX - box.minX) * 1000) / scale, 2);
  // The bar says its own length.
  const bar = /<g id="scale-bar">(.*?)<\/g>/.exec(svg)![1]!,
    [, step] = /width="([\d.]+)"/.exec(bar)!,
    [, metres] = />([\d.]+) m</.exec(bar)!;
  expect((5 * Number(step) * scale) / 1000).toBeCloseTo(Number(metres), 6);
});

it("the paper is the smallest on which the drawing fits, or none", () => {
  const box = (size: number) => ({ minX: 0, minY: 0, maxX: size, maxY: size / 2 });
  expect(paperFor(box(25), 100)).toBe("A4");
  expect(paperFor(box(35), 100)).toBe("A3");
  expect(paperFor(box(200), 100)).toBeNull();
  // The widest plan, as high as wide, has its paper.
  expect(paperFor({ minX: 0, minY: 0, maxX: 1000, maxY: 1000 }, SCALES.at(-1)!)).not.toBeNull();
  expect(() =>
    sheetSvg({
      drawing: {
        lines: [
          {
            layer: "ground",
            points: [
              [0, 0],
              [900, 900],
            ],
            closed: false,
          },
        ],
        texts: [],
      },
      shown: new Set(),
      areas: [],
      scale: 50,
      title: "",
      rows: [],
      legend: [],
    }),
  ).toThrow("larger than A0 paper");
});

it("texts are escaped, and the page has the paper's size", () => {
  const { svg } = sheetOf(100);
  expect(svg.includes("<title>A &#60;lot&#62;</title>")).toBe(true);
  expect(svg.includes("<lot>")).toBe(false);
  expect(printPage("A <lot>", "en", sheetOf(100), "")).toMatch(/@page \{ size: 420mm 297mm; margin: 0; \}/);
});

it("the way as CSV has a line for each marked pose, with its clearance", () => {
  const [head, ...rows] = wayCsv(plan, 1).trim().split("\r\n");
  expect(head).toBe("distance_m,x_m,y_m,heading_rad,clearance_m");
  expect(rows.length).toBeGreaterThanOrEqual(Math.floor(plan.metrics.length));
  expect(Number(rows.at(-1)!.split(",")[0])).toBeCloseTo(plan.metrics.length, 1);
  const least = Math.min(...rows.map((row) => Number(row.split(",")[4])));
  expect(least).toBeGreaterThanOrEqual(plan.metrics.minClearance - 0.001);
});
