/** The papers' tables, computed anew while the site is built. */
import type { PlannerId } from "parkade";
import { Planner, init, paperGrid, paperGridRows, paperGridSummary, roadFigures, scenario } from "../../pkg/node.js";

/** Maps of each kind and size; `cargo xtask paper grid` takes 200. */
const SEEDS = 20;

export async function papers(): Promise<{ params: { id: string; title: string }; content: string }[]> {
  await init();
  return [
    { params: { id: "risk-field", title: "Risk field, 2024" }, content: riskField() },
    { params: { id: "parking", title: "Parking by reverse search, 2025" }, content: parking() },
    { params: { id: "road", title: "Roads, manuscript" }, content: road() },
  ];
}

const table = (head: string[], rows: (string | number)[][]): string => [head, head.map(() => "---"), ...rows].map((row) => `| ${row.join(" | ")} |`).join("\n");
const fixed = (value: number | null | undefined, digits = 2): string => (value === null || value === undefined ? "–" : value.toFixed(digits));
const figure = (scene: string, planners: string): string =>
  `<parkade-playground scene="${scene}" planners="${planners}" layout="grid" controls="minimal" editable alt="${scene}"></parkade-playground>`;

function riskField(): string {
  const { rows, columns } = paperGridRows();
  const measured = Object.fromEntries(rows.map(({ id }) => [id, paperGrid({ row: id, from: 1, to: SEEDS })]));
  const { tables, claims } = paperGridSummary(measured);
  const nodes = columns.indexOf("generated"), length = columns.indexOf("lengthPruned");
  const parts = tables.map(({ row, straight, lines }) => `### ${row.id}: ${row.size} × ${row.size} cells

Straight line ${fixed(straight)} cells.

${table(["planner", "nodes, printed", "nodes, ours", "length, printed", "length, ours"], lines.map((line) => [
    line.planner, line.printedNodes ?? "–", fixed(line.figures[nodes]?.median, 0),
    line.printedLength === null ? "–" : `${line.printedLength}${line.impossible ? " (shorter than the straight line)" : ""}`, fixed(line.figures[length]?.median),
  ]))}`);
  return `# Risk field, 2024

Hu et al. 2024 pick three of eight directions per cell by a potential field. Their maps are not published: each row here is ${SEEDS}
seeded maps of the same kind and size, each figure a median; \`cargo xtask paper grid\` takes 200 and adds spreads and times.

${figure("regular-60", "four eight risk-field risk-field-plus")}

## Tables 3 and 4

${parts.join("\n\n")}

## What it claims

${table(["claim", "found", "holds"], claims.filter(({ text, found }) => !/time/i.test(text + found)).map(({ text, found, holds }) => [text, found, holds]))}
`;
}

function parking(): string {
  const ids = ["P0", "P1", "P2", "P3", "P4", "L0", "L1", "L2", "L3", "L4"];
  const plan = (id: string, planner: PlannerId) => {
    const prepared = new Planner(planner, scenario(id)), found = prepared.plan();
    prepared.free();
    return found;
  };
  const rows = ids.map((id) => {
    const classic = plan(id, "hybrid-classic"), ours = plan(id, "hybrid");
    const cells = [classic, ours].flatMap((one) => [fixed(one.metrics.paperLength, 1), one.metrics.directionChanges, fixed(one.metrics.paperTime), one.check.verdict]);
    return [id, ...cells, ours.hash];
  });
  return `# Parking by reverse search, 2025

The paper searches from the slot outwards and compares itself with the traditional hybrid A*. Its ten scenes, P perpendicular and
L parallel, are built in; lengths and times are rounded as the paper's are.

${figure("L2", "hybrid-classic hybrid")}

## Its rows, planned anew

${table(["scene", "classic: m", "gear changes", "s", "check", "reverse search: m", "gear changes", "s", "check", "hash"], rows)}

\`cargo run --release --example parking\` prints them beside what the paper prints.
`;
}

function road(): string {
  const ids = ["road-straight", "road-curve", "road-crossing", "road-narrow"];
  const rows = ids.flatMap((id) => (["eight", "cost-map"] as const).map((planner) => {
    const scene = scenario(id), prepared = new Planner(planner, scene), plan = prepared.plan();
    prepared.free();
    const figures = roadFigures(scene, plan);
    return [id, planner, fixed(figures.middleLength), fixed(figures.bodyClearanceMin), fixed(figures.bodyClearanceMean), fixed(figures.middleCurvature, 3), fixed(figures.laneDeviationMax), plan.check.verdict];
  }));
  return `# Roads, manuscript

A* for roads with a cost map that knows clearance, lanes, kerbs and limits, compared with plain A*.

${figure("road-narrow", "eight cost-map")}

## Its scenes, planned anew

${table(["scene", "planner", "length m", "body clearance, least m", "mean m", "curvature 1/m", "off the lane m", "check"], rows)}

\`cargo xtask paper road\` prints the manuscript's tables beside ours, promise by promise.
`;
}
