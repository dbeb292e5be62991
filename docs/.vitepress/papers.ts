/** The papers' tables beside ours, computed anew while the site is built. */
import type { PaperClaim, PaperTable } from "parkade";
import { init, paperGrid, paperGridRows, paperGridSummary, paperParking, paperParkingRows, paperRoad, paperRoadRows } from "../../pkg/node.js";

/** Maps of each kind and size; `cargo xtask paper grid` takes 200. */
const SEEDS = 20;

export async function papers(): Promise<{ params: { id: string; title: string }; content: string }[]> {
  await init();
  const { rows } = paperGridRows();
  const grids = paperGridSummary(Object.fromEntries(rows.map(({ id }) => [id, paperGrid({ row: id, from: 1, to: SEEDS })])));
  return [
    { params: { id: "risk-field", title: "Risk field, 2024" }, content: riskField(grids) },
    { params: { id: "sixteen", title: "Sixteen neighbours from both ends" }, content: sixteen(grids) },
    { params: { id: "parking", title: "Parking by reverse search, 2025" }, content: parking() },
    { params: { id: "road", title: "Roads, manuscript" }, content: road() },
  ];
}

interface Grids { tables: PaperTable[]; claims: PaperClaim[] }

const table = (head: string[], rows: (string | number)[][]): string => [head, head.map(() => "---"), ...rows].map((row) => `| ${row.join(" | ")} |`).join("\n");
const fixed = (value: number | null | undefined, digits = 2): string => (value === null || value === undefined ? "–" : value.toFixed(digits));
const figure = (scene: string, planners: string): string =>
  `<parkade-playground scene="${scene}" planners="${planners}" layout="grid" controls="minimal" editable alt="${scene}"></parkade-playground>`;
const TIME = /,? time [^;,]*?(?= of sixteen|;|$)/g;
/** Claims of one paper; those about time are not judged here, where nothing else may rest. */
const judged = (claims: PaperClaim[], paper: string): string =>
  table(["claim", "found", "holds"], claims.filter(({ id }) => id.startsWith(paper)).map(({ text, found, holds }) => [text, found.replace(TIME, ""), found.replace(TIME, "") === found ? holds : "by its times"]));

function riskField({ tables, claims }: Grids): string {
  const { columns } = paperGridRows();
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

${judged(claims, "H")}
`;
}

function sixteen({ tables, claims }: Grids): string {
  const { columns } = paperGridRows();
  const shown = ["generated", "lengthRaw", "turns", "turnAngleDeg"].map((name) => columns.indexOf(name));
  const planners = ["eight", "sixteen", "twenty-four", "forty-eight", "sixteen-bidirectional", "sixteen-nba"];
  const parts = tables.map(({ row, lines }) => `### ${row.id}: ${row.size} × ${row.size} cells

${table(["planner", "nodes", "length, cells", "turns", "turning, °"], planners.flatMap((planner) => lines.filter((line) => line.planner === planner)).map((line) => [
    line.planner, ...shown.map((at, i) => fixed(line.figures[at]?.median, i === 1 ? 2 : 0)),
  ]))}`);
  return `# Sixteen neighbours from both ends

A* that may move to sixteen neighbours, searched from start and goal at once. The paper prints no maps and few numbers, so what can be
held against it is which planner does better: medians over ${SEEDS} seeded maps of each kind, and its claims.

${figure("random-60", "eight sixteen sixteen-bidirectional")}

## On seeded maps

${parts.join("\n\n")}

## What it claims

${judged(claims, "Y")}

Times are measured, and the claims judged by them, by \`cargo xtask paper grid\`, and under Papers on the page.
`;
}

function parking(): string {
  const tables = paperParkingRows().map(({ id }) => paperParking({ row: id }));
  const compared = (column: "traditional" | "improved", planner: string) => table(["scene", "bound m", "printed m", "gears", "s", "ours m", "gears", "s", "check"], tables.map(({ row, bound, impossible, lines }) => {
    const printed = row[column], ours = lines.find((line) => line.planner === planner)!;
    const below = impossible[column === "traditional" ? 0 : 1] ? " †" : "";
    return [row.id, fixed(bound, 1), fixed(printed.length, 1) + below, printed.changes, fixed(printed.time), fixed(ours.length, 1), ours.changes, fixed(ours.time), ours.verdict];
  }));
  return `# Parking by reverse search, 2025

The paper searches from the slot outwards and compares itself with the traditional hybrid A*. Its ten scenes, P perpendicular and
L parallel, are built in; lengths and times are rounded as the paper's are. The bound is the length of the shortest way without
obstacles: a printed length below it (†) cannot be. "gears": changes of gear.

${figure("L2", "hybrid-forward hybrid")}

## Tables 2 to 11, traditional: searched from the start

${compared("traditional", "hybrid-forward")}

## Tables 2 to 11, improved: searched from the slot

${compared("improved", "hybrid")}

\`cargo xtask paper parking\` prints them with nodes and times.
`;
}

function road(): string {
  const rows = paperRoadRows().filter(({ ship }) => !ship).map(({ id }) => paperRoad({ row: id })).flatMap(({ row, lines }) => {
    const [plain, improved] = lines;
    return ([["plain A*", 0, plain], ["improved", 1, improved]] as const).map(([name, at, line]) => {
      const { printed } = row, { metrics, risk } = line!;
      const pair = (theirs: number, ours: string | number) => `${theirs} / ${ours}`;
      return [
        row.id, name, pair(printed.length[at], fixed(metrics.middleLength, 1)), pair(printed.turns[at], metrics.turnsPruned), pair(printed.safety[at], fixed(metrics.bodyClearanceMin)),
        pair(printed.collisions[at], risk.hits), fixed(metrics.curvatureVariation), line!.verdict,
      ];
    });
  });
  return `# Roads, manuscript

A* for roads with a cost map that knows clearance, lanes, kerbs and limits, compared with plain A*. The manuscript's vehicle is a ship;
the scenes here are of the size of roads, so its metres are not ours, but what changes from plain to improved can be compared.

${figure("road-narrow", "eight cost-map")}

## Its tables, printed and ours

Printed / ours. Ours in metres; the safety is the least clearance of the body.

${table(["scene", "search", "length", "turns", "safety", "collisions of 1000", "change of curvature", "check"], rows)}

\`cargo xtask paper road\` prints these promise by promise, with the ship at its own scale and the literal modes.
`;
}
