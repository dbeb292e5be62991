/** A grid figure as SVG: drawn while the site is built, and again by the same code whenever the reader changes it. */
import { middleOf, type GridMap } from "./grid-map";
import { chosenOf, expandedOf, type GridState } from "./grid-state";

export const WIDTH = 680;
/** Shades of the search, from the first cells to the last. */
const SHADES = 6;

interface View {
  map: GridMap;
  /** Side of a cell in pixels. */
  side: number;
  height: number;
}

export function viewOf(map: GridMap): View {
  const side = WIDTH / map.width;
  return { map, side, height: side * map.height };
}

const px = (value: number): string => String(Math.round(value * 10) / 10);
const at = ({ map, side }: View, x: number, y: number): string => `${px(x * side)} ${px((map.height - y) * side)}`;
const columnOf = ({ map }: View, cell: number): number => cell % map.width;
const rowOf = ({ map }: View, cell: number): number => Math.floor(cell / map.width);

const squares = (view: View, cells: readonly number[], kind: string, inset = 0.5): string => {
  const size = px(view.side - 2 * inset);
  const path = cells
    .map(
      (cell) =>
        `M${px(
          columnOf(view, cell) * view.side + inset,
        )} ${px(rowOf(view, cell) * view.side + inset)}h${size}v${size}h-${size}z`,
    )
    .join("");
  return path ? `<path class="${kind}" d="${path}"/>` : "";
};

function lines({ map, side, height }: View): string {
  const across = Array.from({ length: map.width - 1 }, (_, i) => `M${px((i + 1) * side)} 0V${px(height)}`);
  const down = Array.from({ length: map.height - 1 }, (_, i) => `M0 ${px((i + 1) * side)}H${WIDTH}`);
  return `<path class="lab-grid" d="${[...across, ...down].join("")}"/>`;
}

function end(view: View, cell: number, letter: "S" | "G"): string {
  const x = px((columnOf(view, cell) + 0.5) * view.side),
    y = px((rowOf(view, cell) + 0.5) * view.side);
  return (
    `<g class="lab-end"><circle ` +
    `cx="${x}" cy="${y}" r="${px(view.side * 0.48)}"/><text x="${x}" y="${y}" dy="0.36em" ` +
    `font-size="${px(view.side * 0.62)}">${letter}</text></g>`
  );
}

/** What is inside the `<svg>`. */
export function drawingOf(state: GridState, cursor: number | null = null): string {
  const view = viewOf(state.map),
    walls = state.map.walls.flatMap((wall, cell) => (wall ? [cell] : []));
  return [
    `<rect class="lab-floor" width="${WIDTH}" height="${px(view.height)}"/>`,
    state.figure.view === "stages" ? "" : search(view, state),
    lines(view),
    squares(view, walls, "lab-wall", 0),
    state.figure.view === "stages" ? stages(view, state) : path(view, state),
    state.figure.view === "force" ? force(view, state) : "",
    end(view, state.map.start, "S"),
    end(view, state.map.goal, "G"),
    state.picked !== null ? squares(view, [state.picked], "lab-picked", -1) : "",
    cursor !== null ? squares(view, [cursor], "lab-cursor", -2) : "",
  ].join("");
}

function search(view: View, state: GridState): string {
  const all = expandedOf(state, 1).length,
    shown = expandedOf(state);
  const shade = (i: number): number => Math.min(SHADES - 1, Math.floor((SHADES * i) / Math.max(1, all)));
  const parts = Array.from({ length: SHADES }, (_, k) =>
    squares(
      view,
      shown.filter((_, i) => shade(i) === k),
      `lab-search lab-search-${k}`,
    ),
  );
  return parts.join("") + (state.share < 1 && shown.length > 0 ? squares(view, shown.slice(-1), "lab-current", 1) : "");
}

const polyline = (view: View, points: readonly (readonly [number, number])[], kind: string): string =>
  points.length > 1 ? `<path class="${kind}" d="M${points.map(([x, y]) => at(view, x, y)).join("L")}"/>` : "";

function pairs(flat: Float64Array): [number, number][] {
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i]!, flat[2 * i + 1]!]);
}

function path(view: View, state: GridState): string {
  const plan = state.plans[state.chosen];
  if (!plan || state.share < 1) return "";
  return polyline(view, pairs(plan.rawPath), `lab-path lab-path-${chosenOf(state).planner}`);
}

/** The cells' path, the pruned corners and the arcs, each over the one before. */
function stages(view: View, { plans, chosen, stage }: GridState): string {
  const plan = plans[chosen],
    steps = plan?.stages;
  if (!plan || !steps) return "";
  const raw = polyline(view, pairs(plan.rawPath), "lab-raw");
  const corners = steps.pruned.map(([x, y]) => dot(view, x, y, 4, "lab-corner"));
  const pruned = polyline(view, steps.pruned, "lab-pruned") + corners.join("");
  if (stage === "raw") return raw;
  if (stage === "pruned") return raw + pruned;
  const arcs = steps.arcs.map(({ from, to, center, radius }) => {
    const left = (from[0] - center[0]) * (to[1] - center[1]) - (from[1] - center[1]) * (to[0] - center[0]) > 0;
    const r = px(radius * view.side);
    return (
      `${dot(view, center[0], center[1], radius * view.side, "lab-circle")}<path class="lab-arc" ` +
      `d="M${at(view, ...from)}A${r} ${r} 0 0 ${left ? 0 : 1} ${at(view, ...to)}"/>`
    );
  });
  const sharp = steps.sharp.map(([x, y]) => dot(view, x, y, 6, "lab-sharp"));
  return raw + pruned + arcs.join("") + sharp.join("");
}

function dot(view: View, x: number, y: number, radius: number, kind: string): string {
  const [left, top] = at(view, x, y).split(" ");
  return `<circle class="${kind}" cx="${left}" cy="${top}" r="${px(radius)}"/>`;
}

/** The force at the picked cell, and the cells that it chooses. */
function force(view: View, { picked, explanation, map }: GridState): string {
  if (picked === null || !explanation) return "";
  const indexOf = ([x, y]: [number, number]): number => (map.height - 1 - y) * map.width + x;
  const by = (role: string, free: boolean): number[] =>
    explanation.candidates.filter((one) => one.role === role && one.free === free).map(({ cell }) => indexOf(cell));
  const { x, y } = middleOf(map, picked);
  const arrow = ([fx, fy]: readonly [number, number], kind: string): string => {
    const size = Math.hypot(fx, fy),
      reach = 2.6 * Math.tanh(size / 6);
    if (size < 1e-9) return "";
    const [ux, uy] = [fx / size, fy / size],
      tip: [number, number] = [x + ux * reach, y + uy * reach];
    const barb = (side: number): string =>
      at(view, tip[0] - 0.45 * ux + side * 0.28 * uy, tip[1] - 0.45 * uy - side * 0.28 * ux);
    const end = at(view, ...tip);
    return `<path class="${kind}" d="M${at(view, x, y)}L${end}M${barb(1)}L${end}L${barb(-1)}"/>`;
  };
  return [
    squares(view, by("held-back", true), "lab-held", 2),
    squares(view, by("extension", true), "lab-extension", 2),
    squares(view, by("primary", true), "lab-primary", 2),
    arrow(explanation.attraction, "lab-attraction"),
    arrow(explanation.repulsion, "lab-repulsion"),
    arrow(explanation.force, "lab-force"),
  ].join("");
}
