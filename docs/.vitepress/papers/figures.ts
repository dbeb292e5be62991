/** Figures as SVG: the page's own picture of a scene and its paths, with what a paper's figure adds to it. */
import type { Encounter, Plan, PlannerId, Scenario, Stages } from "parkade";
import { below, isLong, STRIP } from "../../../www/src/view/camera";
import { Planner, scenario, sceneGeometry, stopWaitGo, toSVG } from "../../../pkg/node.js";
import { contours } from "../../../www/src/view/contour";
import type { Figure } from "./blocks";

const WIDTH = 640,
  SIDE = 440,
  FIT = 0.92;

interface View {
  x: number;
  y: number;
  scale: number;
  width: number;
  height: number;
}
type Point = readonly [number, number];

/** The figure's picture; the longer side of its map fills the width, or the height of a square. */
export function picture({ scene: id, planners, draws, svg }: Figure): string {
  if (svg !== undefined) return svg;
  const scene = scenario(id),
    view = viewOf(scene);
  const made = planners.map((planner) => new Planner(planner as PlannerId, scene));
  try {
    const plans = made.map((planner) => planner.plan({ trace: draws === "stages" }) as Plan & { stages?: Stages });
    const whole = toSVG(scene, draws === "stages" ? [] : plans.map((plan) => ({ ...plan, trace: null }) as Plan), {
      width: view.width,
      height: view.height,
      theme: "light",
      camera: { x: view.x, y: view.y, scale: view.scale },
    });
    return whole
      .replace(/<metadata>[^]*?<\/metadata>/, "")
      .replace(/<\/svg>\s*$/, `${over(view, scene, made[0]!, plans[0]!, draws)}</svg>`);
  } finally {
    for (const planner of made) planner.free();
  }
}

/** Above a long road its strip is drawn. */
function viewOf(scene: Scenario): View {
  const {
    origin: [left, bottom],
    width,
    height,
    resolution,
  } = scene.map;
  const size = [width * resolution, height * resolution] as const,
    square = size[0] < 1.3 * size[1];
  const across = square ? SIDE : WIDTH,
    high = Math.max(120, Math.min(SIDE, square ? SIDE : (WIDTH * size[1]) / size[0] + 40));
  const scale = FIT * Math.min(across / size[0], high / size[1]);
  const strip = isLong(scene) ? STRIP.room : 0;
  const middle = { x: left + size[0] / 2, y: bottom + size[1] / 2, scale };
  return { ...below(strip, middle), width: across, height: Math.round(high) + strip };
}

function over(
  view: View,
  scene: Scenario,
  planner: Planner,
  plan: Plan & { stages?: Stages },
  draws: Figure["draws"],
): string {
  const at = ([x, y]: Point): [number, number] => [
    view.width / 2 + (x - view.x) * view.scale,
    view.height / 2 - (y - view.y) * view.scale,
  ];
  if (draws === "potential") return potential(scene, planner, at);
  if (draws === "stages" && plan.stages) return stages(plan, plan.stages, view.scale, at);
  return draws === "marks" ? marks(view, scene, stopWaitGo(scene, plan), at) : "";
}

type At = (point: Point) => [number, number];
const px = (value: number): string => value.toFixed(1);
const line = (points: readonly Point[], at: At, style: string): string =>
  `<polyline fill="none" ${style} points="${points.map((p) => at(p).map(px).join(",")).join(" ")}"/>`;
const dot = (point: Point, at: At, radius: number, style: string): string =>
  `<circle cx="${px(at(point)[0])}" cy="${px(at(point)[1])}" r="${radius}" ${style}/>`;

function stages({ rawPath }: Plan, { pruned, arcs, sharp }: Stages, scale: number, at: At): string {
  const cells = Array.from({ length: rawPath.length / 2 }, (_, i): Point => [rawPath[2 * i]!, rawPath[2 * i + 1]!]);
  const circle = (arc: Stages["arcs"][number]): string =>
    dot(arc.center, at, arc.radius * scale, 'fill="none" stroke="#009E73" stroke-dasharray="2 3"');
  const bend = ({ from, to, center, radius }: Stages["arcs"][number]): string => {
    const left = (from[0] - center[0]) * (to[1] - center[1]) - (from[1] - center[1]) * (to[0] - center[0]) > 0;
    return `<path fill="none" stroke="#009E73" stroke-width="3" d="M${at(from).map(px).join(" ")}A${px(radius * scale)} ${px(radius * scale)} 0 0 ${left ? 0 : 1} ${at(to).map(px).join(" ")}"/>`;
  };
  return [
    line(cells, at, 'stroke="#64696F"'),
    line(pruned, at, 'stroke="#1B1D20" stroke-width="1.5" stroke-dasharray="6 4"'),
    ...arcs.map(circle),
    ...arcs.map(bend),
    ...cells.map((p) => dot(p, at, 1.5, 'fill="#64696F"')),
    ...arcs.flatMap(({ from, to }) => [from, to]).map((p) => dot(p, at, 2.5, 'fill="#009E73"')),
    ...pruned.map((p) => dot(p, at, 3.5, 'fill="#fff" stroke="#1B1D20"')),
    ...sharp.map((p) => dot(p, at, 3.5, 'fill="#B3261E"')),
  ].join("");
}

const LEVELS = 20;

function potential({ map: { origin, resolution } }: Scenario, planner: Planner, at: At): string {
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
function marks(view: View, scene: Scenario, { waits, t, path }: Encounter, at: At): string {
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
      return `<circle cx="${px(x)}" cy="${px(y + up)}" r="9" fill="${fill}" stroke="#1B1D20"/><text x="${px(x)}" y="${px(y + up + 4)}" font-size="12" font-weight="600" text-anchor="middle">${name}</text>`;
    };
  const x = (time: number): number => 70 + ((view.width - 100) * time) / end;
  const row = (name: string, y: number, of: [string, number, Point][], ink: string): string =>
    `<text x="12" y="${y + 4}" font-size="12">${name}</text><line x1="${px(x(of[0]![1]))}" x2="${px(x(of.at(-1)![1]))}" y1="${y}" y2="${y}" stroke="${ink}" stroke-width="3"/>${of.map(([letter, time]) => `<text x="${px(x(time))}" y="${y - 5}" font-size="12" text-anchor="middle">${letter}</text>`).join("")}`;
  const strip = `<rect x="4" y="4" width="${view.width - 8}" height="54" fill="#fff" fill-opacity="0.92"/>${row("box", 20, boxes, "#8A5300")}${row("car", 40, cars, "#1B1D20")}<line x1="${px(x(wait.from))}" x2="${px(x(wait.to))}" y1="40" y2="40" stroke="#8A5300" stroke-width="7"/>${Array.from({ length: Math.floor(end / 5) + 1 }, (_, i) => `<text x="${px(x(5 * i))}" y="56" font-size="12" fill="#64696F">${5 * i} s</text>`).join("")}`;
  return `<g font-family="system-ui, sans-serif">${boxes.map(badge(-16, "#FBF1E0")).join("")}${cars.map(badge(16, "#fff")).join("")}${strip}</g>`;
}

/** Figure 4: the volumes around a car that stands at 25°. */
export function volumesPicture(): string {
  const turn = (25 * Math.PI) / 180,
    [a, b] = [2.75, 1.3];
  const x = a * Math.cos(turn) + b * Math.sin(turn),
    y = a * Math.sin(turn) + b * Math.cos(turn);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="320" height="320" viewBox="-3.4 -3.4 6.8 6.8" role="img"><circle r="${Math.hypot(a, b)}" fill="none" stroke="#CC79A7" stroke-width="0.05" stroke-dasharray="0.05 0.12" stroke-linecap="round"/><rect x="${-x}" y="${-y}" width="${2 * x}" height="${2 * y}" fill="none" stroke="#D55E00" stroke-width="0.05" stroke-dasharray="0.25 0.12"/><rect transform="rotate(-25)" x="${-a}" y="${-b}" width="${2 * a}" height="${2 * b}" fill="#1B1D20" fill-opacity="0.12" stroke="#0072B2" stroke-width="0.07"/></svg>`;
}

/** Layers below each other, each a name over a row of boxes, joined by arrows. */
export function layersPicture(layers: readonly (readonly [name: string, ...boxes: string[]])[]): string {
  const width = 640,
    tall = 74,
    gap = 26,
    height = layers.length * (tall + gap) - gap + 16;
  const escaped = (words: string): string => words.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
  const layer = ([name, ...boxes]: readonly [string, ...string[]], i: number): string => {
    const y = 8 + i * (tall + gap),
      wide = (width - 32) / boxes.length;
    const box = (words: string, at: number): string =>
      `<rect x="${(16 + at * wide + 4).toFixed(1)}" y="${y + 28}" width="${(wide - 8).toFixed(1)}" height="36" rx="4" fill="#fff" stroke="#8A8F96"/><text x="${(16 + (at + 0.5) * wide).toFixed(1)}" y="${y + 50}" text-anchor="middle">${escaped(words)}</text>`;
    return `<rect x="8" y="${y}" width="${width - 16}" height="${tall}" rx="6" fill="#F4F5F3" stroke="#3F444B"/><text x="${width / 2}" y="${y + 19}" text-anchor="middle" font-weight="600">${escaped(name)}</text>${boxes.map(box).join("")}${i > 0 ? `<path d="M${width / 2} ${y - gap}V${y - 3}m-4 -5l4 5l4 -5" fill="none" stroke="#3F444B"/>` : ""}`;
  };
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" font-family="system-ui, sans-serif" font-size="12">${layers.map(layer).join("")}</svg>`;
}

/** Boxes below each other, joined by arrows. */
export function flowPicture(steps: readonly string[]): string {
  const width = 560,
    tall = 44,
    gap = 22,
    height = steps.length * (tall + gap) + 8;
  const box = (step: string, i: number): string => {
    const y = 8 + i * (tall + gap);
    return `<rect x="20" y="${y}" width="${width - 40}" height="${tall}" rx="6" fill="#fff" stroke="#3F444B"/><text x="${width / 2}" y="${y + 27}" text-anchor="middle" font-size="13">${step.replaceAll("&", "&amp;").replaceAll("<", "&lt;")}</text>${i > 0 ? `<path d="M${width / 2} ${y - gap}V${y - 3}m-4 -5l4 5l4 -5" fill="none" stroke="#3F444B"/>` : ""}`;
  };
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" font-family="system-ui, sans-serif">${steps.map(box).join("")}</svg>`;
}
