/** What the papers' figures add to a scene's picture, as SVG. */
import type { Encounter, Plan, Scenario, Stages } from "parkade";
import { type Planner, sceneGeometry } from "../../../pkg/node.js";
import { contours } from "../../../www/src/view/contour";

export interface View {
  x: number;
  y: number;
  scale: number;
  width: number;
  height: number;
}
export type Point = readonly [number, number];
export type At = (point: Point) => [number, number];
type Arc = Stages["arcs"][number];
export type Staged = Plan & { stages?: Stages };

const BLUE = "#0072B2",
  GREEN = "#009E73",
  ORANGE = "#D55E00",
  RED = "#B3261E",
  INK = "#1B1D20";

const px = (value: number): string => value.toFixed(1);
const line = (points: readonly Point[], at: At, style: string): string =>
  `<polyline fill="none" ${style} points="${points.map((p) => at(p).map(px).join(",")).join(" ")}"/>`;
const dot = (point: Point, at: At, radius: number, style: string): string =>
  `<circle cx="${px(at(point)[0])}" cy="${px(at(point)[1])}" r="${px(radius)}" ${style}/>`;
const away = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

const cellsOf = ({ rawPath }: Plan): Point[] =>
  Array.from({ length: rawPath.length / 2 }, (_, i): Point => [rawPath[2 * i]!, rawPath[2 * i + 1]!]);

function bend({ from, to, center, radius }: Arc, scale: number, at: At): string {
  const left = (from[0] - center[0]) * (to[1] - center[1]) - (from[1] - center[1]) * (to[0] - center[0]) > 0;
  return (
    `<path fill="none" ` +
    `stroke="${GREEN}" stroke-width="3" ` +
    `d="M${at(from)
      .map(px)
      .join(" ")}A${px(radius * scale)} ${px(radius * scale)} 0 0 ${left ? 0 : 1} ${at(to).map(px).join(" ")}"/>`
  );
}
const circles = (points: readonly Point[], at: At): string[] =>
  points.map((p) => dot(p, at, 3.5, `fill="#fff" stroke="${INK}"`));

/** Cells, and what pruning leaves of them. */
export function pruned(plan: Staged, at: At): string {
  const cells = cellsOf(plan),
    kept = plan.stages!.pruned;
  return [
    line(cells, at, `stroke="${BLUE}" stroke-width="1.5"`),
    line(kept, at, `stroke="${INK}" stroke-width="1.5" stroke-dasharray="6 4"`),
    ...cells.map((p) => dot(p, at, 1.8, `fill="${BLUE}"`)),
    ...circles(kept, at),
  ].join("");
}

/** The pruned path, and the arcs that take the place of its corners. */
export function smoothed({ stages }: Staged, scale: number, at: At): string {
  const { pruned, arcs, sharp } = stages!;
  return [
    line(pruned, at, `stroke="${BLUE}" stroke-width="1.5"`),
    ...arcs.map((arc) => bend(arc, scale, at)),
    ...arcs.flatMap(({ from, to }) => [from, to]).map((p) => dot(p, at, 2.5, `fill="${GREEN}"`)),
    ...circles(pruned, at),
    ...sharp.map((p) => dot(p, at, 3.5, `fill="${RED}"`)),
  ].join("");
}

/** The corner whose construction is drawn: its circle is small enough for its neighbours to be seen. */
const MOST_RADIUS = 6;
export const drawnArc = ({ arcs }: Stages): Arc => arcs.find(({ radius }) => radius < MOST_RADIUS) ?? arcs[0]!;

/** A corner's tangent circle with the letters of the paper's steps. */
export function tangents({ stages }: Staged, scale: number, at: At): string {
  const { pruned } = stages!,
    arc = drawnArc(stages!),
    i = pruned.findIndex((p) => away(p, arc.corner) < 1e-9);
  const [before, corner, after] = [pruned[i - 1]!, pruned[i]!, pruned[i + 1]!];
  const isBefore = away(before, corner) <= away(corner, after),
    [s, q] = isBefore ? [arc.from, arc.to] : [arc.to, arc.from];
  const moved = away(s, isBefore ? before : after) > 0.01;
  const letter = (point: Point, text: string, [dx, dy]: Point = [10, -8]): string =>
    `<text x="${px(at(point)[0] + dx)}" y="${px(at(point)[1] + dy)}" font-family="system-ui, sans-serif" ` +
    `font-size="15" font-weight="600" stroke="#fff" stroke-width="4" paint-order="stroke">${text}</text>`;
  return [
    line(pruned, at, `stroke="${BLUE}" stroke-width="2"`),
    line([s, arc.center, q], at, `stroke="${INK}" stroke-dasharray="3 4"`),
    line([corner, arc.center], at, `stroke="${INK}" stroke-dasharray="1 4"`),
    dot(arc.center, at, arc.radius * scale, `fill="none" stroke="${GREEN}" stroke-dasharray="3 4"`),
    bend(arc, scale, at),
    ...circles(pruned, at),
    ...[s, q, arc.center].map((p) => dot(p, at, 3.5, `fill="${GREEN}"`)),
    letter(before, "B<tspan dy='4' font-size='10'>i−1</tspan>"),
    letter(corner, "B<tspan dy='4' font-size='10'>i</tspan>"),
    letter(after, "B<tspan dy='4' font-size='10'>i+1</tspan>"),
    letter(s, moved ? "S<tspan dy='4' font-size='10'>2</tspan>" : "S", [-6, 20]),
    letter(q, "Q", [-6, 20]),
    letter(arc.center, "P"),
  ].join("");
}

/** The necessary and the redundant safety space, as the planner itself takes it. */
export function spaces({ map: { origin, resolution } }: Scenario, planner: Planner, { scale }: View, at: At): string {
  const { width, data } = planner.layer("redundant"),
    side = resolution * scale + 0.3;
  const fills: Readonly<Record<number, string>> = { 2: "#F2C37B", 3: "#C9B3DE" };
  const parts: string[] = [];
  // Cells of one kind beside each other are one rectangle.
  for (let from = 0, to = 1; from < data.length; from = to, to++) {
    const fill = fills[data[from]!];
    while (to % width > 0 && data[to] === data[from]) to++;
    if (!fill) continue;
    const corner = at([
      origin[0] + (from % width) * resolution,
      origin[1] + (Math.floor(from / width) + 1) * resolution,
    ]);
    const long = (to - from - 1) * resolution * scale + side;
    parts.push(
      `<rect x="${px(corner[0])}" y="${px(corner[1])}" width="${px(long)}" height="${px(side)}" fill="${fill}"/>`,
    );
  }
  return parts.join("");
}

/** Four and eight neighbours cell by cell; the improved path with its kept points and arcs; both ends. */
export function compared(plans: readonly Staged[], scale: number, at: At): string {
  const [four, eight, improved] = plans,
    kept = improved!.stages!.pruned;
  return [
    line(cellsOf(four!), at, `stroke="${INK}" stroke-width="1.5" stroke-dasharray="2 3"`),
    line(cellsOf(eight!), at, `stroke="${ORANGE}" stroke-width="1.5" stroke-dasharray="7 4"`),
    line(kept, at, `stroke="${BLUE}" stroke-width="2"`),
    ...improved!.stages!.arcs.map((arc) => bend(arc, scale, at)),
    ...circles(kept.slice(1, -1), at),
    dot(kept[0]!, at, 5, `fill="none" stroke="${BLUE}" stroke-width="2.5"`),
    dot(kept.at(-1)!, at, 5, `fill="none" stroke="${RED}" stroke-width="2.5"`),
  ].join("");
}

const LEVELS = 20;

/** Lines of equal potential, of its square root, so that they stand evenly. */
export function potential({ map: { origin, resolution } }: Scenario, planner: Planner, at: At): string {
  const { width, height, data } = planner.layer("potential"),
    roots = Array.from(data, (value) => Math.sqrt(Math.max(0, value)));
  const low = Math.min(...roots),
    high = Math.max(...roots),
    parts: string[] = [];
  for (let i = 0; i < LEVELS; i++) {
    for (const loop of contours(
      width,
      height,
      (x, y) => roots[y * width + x]!,
      low + ((high - low) * (i + 0.5)) / LEVELS,
    )) {
      let run: Point[] = [];
      const close = (): void => {
        if (run.length > 1) parts.push(line(run, at, `stroke="hsl(${230 - (180 * i) / LEVELS} 55% 40%)"`));
        run = [];
      };
      for (let k = 0; k < loop.length; k += 2) {
        const [x, y] = [loop[k]!, loop[k + 1]!];
        if (x < 0 || y < 0 || x > width - 1 || y > height - 1) close();
        else run.push([origin[0] + (x + 0.5) * resolution, origin[1] + (y + 0.5) * resolution]);
      }
      close();
    }
  }
  return parts.join("");
}

/** A to D of the box, S, W, E of the car, and a strip of their times. */
export function marks(view: View, scene: Scenario, { waits, t, path }: Encounter, at: At): string {
  const box = scene.moving?.[0],
    wait = waits[0];
  if (!box || !wait) return "";
  const [a, d] = [box.points[0]!, box.points.at(-1)!],
    span = Math.hypot(d[0] - a[0], d[1] - a[1]) / box.speed,
    begin = box.start ?? 0;
  const along = (time: number): Point => {
    const share = Math.min(1, Math.max(0, (time - begin) / span));
    return [a[0] + (d[0] - a[0]) * share, a[1] + (d[1] - a[1]) * share];
  };
  const last = t.length - 1,
    { start } = sceneGeometry(scene),
    end = t[last]!;
  const boxes: [string, number, Point][] = [
    ["A", begin, a],
    ["B", wait.from, along(wait.from)],
    ["C", wait.to, along(wait.to)],
    ["D", begin + span, d],
  ];
  const cars: [string, number, Point][] = [
    ["S", 0, [start.x, start.y]],
    ["W", wait.from, [wait.pose.x, wait.pose.y]],
    ["E", end, [path[3 * last]!, path[3 * last + 1]!]],
  ];
  const badge =
    (up: number, fill: string) =>
    ([name, , point]: [string, number, Point]): string => {
      const [x, y] = at(point);
      return (
        `<circle cx="${px(x)}" cy="${px(y + up)}" r="9" fill="${fill}" stroke="#1B1D20"/><text ` +
        `x="${px(x)}" y="${px(y + up + 4)}" font-size="12" font-weight="600" text-anchor="middle">${name}</text>`
      );
    };
  const x = (time: number): number => 70 + ((view.width - 100) * time) / end;
  const row = (icon: string, y: number, of: [string, number, Point][], ink: string): string =>
    `${icon}<line x1="${px(x(of[0]![1]))}" x2="${px(x(of.at(-1)![1]))}" y1="${y}" y2="${y}" ` +
    `stroke="${ink}" stroke-width="3"/>` +
    of
      .map(
        ([letter, time]) =>
          `<text x="${px(x(time))}" y="${y - 5}" font-size="12" text-anchor="middle">${letter}</text>`,
      )
      .join("");
  const icon = (y: number, round: number, fill: string): string =>
    `<rect x="14" y="${y - 5}" width="28" height="10" rx="${round}" fill="${fill}" stroke="#1B1D20"/>`;
  const strip =
    `<rect x="4" y="4" width="${view.width - 8}" height="54" fill="#fff" ` +
    `fill-opacity="0.92"/>${row(
      icon(20, 0, "#FBF1E0"),
      20,
      boxes,
      "#8A5300",
    )}${row(icon(40, 4, "#fff"), 40, cars, "#1B1D20")}<line x1="${px(x(wait.from))}" x2="${px(x(wait.to))}" y1="40" ` +
    `y2="40" stroke="#8A5300" ` +
    `stroke-width="7"/>${Array.from(
      { length: Math.floor(end / 5) + 1 },
      (_, i) => `<text x="${px(x(5 * i))}" y="56" font-size="12" fill="#64696F">${5 * i} s</text>`,
    ).join("")}`;
  return (
    `<g font-family="system-ui, ` +
    `sans-serif">${boxes.map(badge(-16, "#FBF1E0")).join("")}${cars.map(badge(16, "#fff")).join("")}${strip}</g>`
  );
}
