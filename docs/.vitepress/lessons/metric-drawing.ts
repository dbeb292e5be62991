/** A figure with cars as SVG, drawn by the same code while the site is built and in the page. */
import type { Obstacle, Pose } from "parkade";
import { WIDTH } from "./grid-drawing";
import { costCurve } from "./cost-curve";
import { advanced, curveOf, curvatureOf, type MetricState } from "./metric-state";
import type { Lang } from "./words";

export const HEIGHT = 360;
/** Arcs of a search that are drawn. */
const ARCS = 400;

type Point = readonly [number, number];

export interface Scale {
  left: number;
  bottom: number;
  /** Pixels of a metre. */
  metre: number;
}

export function scaleOf({ figure }: MetricState): Scale {
  const [left, bottom] = figure.scene.map.origin;
  return { left, bottom, metre: WIDTH / figure.across };
}

const px = (value: number): string => String(Math.round(value * 10) / 10);
const at = ({ left, bottom, metre }: Scale, [x, y]: Point): string =>
  `${px((x - left) * metre)} ${px(HEIGHT - (y - bottom) * metre)}`;
const shape = (scale: Scale, points: readonly Point[], kind: string, closed = true): string =>
  points.length > 1
    ? `<path class="${kind}" d="M${points.map((p) => at(scale, p)).join("L")}${closed ? "z" : ""}"/>`
    : "";

function box({ x, y, heading }: Pose, back: number, front: number, half: number): Point[] {
  const [c, s] = [Math.cos(heading), Math.sin(heading)];
  return (
    [
      [-back, -half],
      [front, -half],
      [front, half],
      [-back, half],
    ] as const
  ).map(([u, v]) => [x + c * u - s * v, y + s * u + c * v]);
}

function outlineOf(obstacle: Obstacle): Point[] {
  if (obstacle.type === "polygon") return obstacle.points;
  if (obstacle.type !== "rectangle") return [];
  const [along, across] = obstacle.size,
    [x, y] = obstacle.center;
  return box({ x, y, heading: obstacle.heading ?? 0 }, along / 2, along / 2, across / 2);
}

/** The car's outline at a pose, in metres. */
export function bodyOf(state: MetricState, pose: Pose): Point[] {
  const { rearToBack, rearToFront, width } = state.geometry!.vehicle;
  return box(pose, rearToBack, rearToFront, width / 2);
}

function car(state: MetricState, scale: Scale, pose: Pose, kind: string): string {
  const { rearToFront, wheelbase } = state.geometry!.vehicle;
  const nose = advanced(pose, 0, rearToFront),
    axle = advanced(pose, 0, wheelbase);
  return `<g class="${kind}">${shape(scale, bodyOf(state, pose), "lab-body")}${shape(
    scale,
    [
      [pose.x, pose.y],
      [axle.x, axle.y],
    ],
    "lab-axis",
    false,
  )}<circle class="lab-nose" r="7" cx="${at(scale, [nose.x, nose.y]).replace(" ", '" cy="')}"/></g>`;
}

export function arcPoints(from: Pose, curvature: number, length: number): Point[] {
  const count = Math.max(1, Math.ceil(Math.abs(length) / 0.4));
  return Array.from({ length: count + 1 }, (_, i) => {
    const { x, y } = advanced(from, curvature, (length * i) / count);
    return [x, y] as const;
  });
}

/** What is inside the `<svg>`. */
export function metricDrawing(state: MetricState, lang: Lang): string {
  const scale = scaleOf(state),
    { figure, geometry } = state;
  if (!geometry) return "";
  return [
    `<rect class="lab-outside" width="${WIDTH}" height="${HEIGHT}"/>`,
    shape(scale, geometry.boundary, "lab-ground"),
    figure.shows === "cost" ? heat(state, scale) : "",
    ...geometry.slots.map((slot) => shape(scale, slot, "lab-slot")),
    ...(figure.scene.obstacles ?? []).map((one) => shape(scale, outlineOf(one), "lab-wall")),
    ...geometry.parkedCars.map(({ pose }) => shape(scale, bodyOf(state, pose), "lab-wall")),
    own(state, scale),
    ends(state, scale),
    figure.shows === "cost" && state.cost ? costCurve(state, lang) : "",
  ].join("");
}

function ends(state: MetricState, scale: Scale): string {
  const { shows } = state.figure,
    hit = state.check !== null && state.check.hits > 0;
  const goal = shows === "body" || shows === "arc" ? "" : car(state, scale, state.goal, "lab-goal");
  return goal + car(state, scale, state.start, hit ? "lab-start lab-hit" : "lab-start");
}

function own(state: MetricState, scale: Scale): string {
  switch (state.figure.shows) {
    case "body":
      return circle(state, scale);
    case "arc":
      return arc(state, scale);
    case "curves":
      return curves(state, scale);
    default:
      return planned(state, scale);
  }
}

/** The smallest disc around the body. */
function circle(state: MetricState, scale: Scale): string {
  const { rearToBack, rearToFront, width } = state.geometry!.vehicle;
  const middle = advanced(state.start, 0, (rearToFront - rearToBack) / 2),
    radius = Math.hypot(rearToFront + rearToBack, width) / 2;
  const [x, y] = at(scale, [middle.x, middle.y]).split(" ");
  return `<circle class="lab-disc" cx="${x}" cy="${y}" r="${px(radius * scale.metre)}"/>`;
}

function arc(state: MetricState, scale: Scale): string {
  const { driven } = state,
    poses: Pose[] = [];
  for (let i = 0; i + 2 < driven.length; i += 3)
    poses.push({ x: driven[i]!, y: driven[i + 1]!, heading: driven[i + 2]! });
  const curvature = curvatureOf(state),
    { x, y, heading } = state.start;
  const turning =
    Math.abs(curvature) < 1e-6
      ? ""
      : `<circle class="lab-turning" ` +
        `cx="${at(scale, [x - Math.sin(heading) / curvature, y + Math.cos(heading) / curvature]).replace(
          " ",
          '" cy="',
        )}" r="${px(scale.metre / Math.abs(curvature))}"/>`;
  const bodies = poses.filter((_, i) => i % 20 === 0).map((pose) => shape(scale, bodyOf(state, pose), "lab-swept"));
  return (
    turning +
    bodies.join("") +
    shape(
      scale,
      poses.map((p) => [p.x, p.y] as const),
      "lab-path",
      false,
    )
  );
}

function curves(state: MetricState, scale: Scale): string {
  const chosen = curveOf(state);
  const drawn = (one: typeof chosen, kind: string): string =>
    (one?.arcs ?? [])
      .map(([x, y, heading, curvature, length]) =>
        shape(scale, arcPoints({ x, y, heading }, curvature, length), length < 0 ? `${kind} lab-reverse` : kind, false),
      )
      .join("");
  return state.curves.map((one) => drawn(one, "lab-other")).join("") + drawn(chosen, "lab-path");
}

/** The search tree of hybrid A*, and the path: dashed in reverse. */
function planned({ plans, chosen }: MetricState, scale: Scale): string {
  const plan = plans[chosen];
  if (!plan) return "";
  const { path, directions, trace } = plan,
    parts: string[] = [];
  if (trace?.kind === "arcs") {
    const { arcs } = trace,
      count = Math.min(ARCS, arcs.length / 5);
    const tree = Array.from({ length: count }, (_, i) => {
      const [x, y, heading, curvature, length] = arcs.subarray(5 * i, 5 * i + 5) as unknown as [
        number,
        number,
        number,
        number,
        number,
      ];
      return `M${arcPoints({ x, y, heading }, curvature, length)
        .map((p) => at(scale, p))
        .join("L")}`;
    });
    if (count > 0) parts.push(`<path class="lab-tree" d="${tree.join("")}"/>`);
  }
  let from = 0;
  for (let i = 1; i <= directions.length; i++) {
    if (i < directions.length && directions[i] === directions[from]) continue;
    const points = Array.from(
      { length: Math.min(i + 1, directions.length) - from },
      (_, k): Point => [path[3 * (from + k)]!, path[3 * (from + k) + 1]!],
    );
    parts.push(shape(scale, points, directions[from]! < 0 ? "lab-path lab-reverse" : "lab-path", false));
    from = i;
  }
  return parts.join("");
}

const SHADES = 5;

/** The cost of a metre at each place, in shades: cells of one shade beside each other are one rectangle. */
function heat({ cost, figure }: MetricState, scale: Scale): string {
  if (!cost) return "";
  const { resolution, origin } = figure.scene.map,
    side = px(resolution * scale.metre),
    parts: string[][] = Array.from({ length: SHADES }, () => []);
  for (let y = 0; y < cost.height; y++)
    for (let x = 0, end = 0; x < cost.width; x = end) {
      const shade = shadeOf(cost.data[y * cost.width + x]!);
      for (end = x + 1; end < cost.width && shadeOf(cost.data[y * cost.width + end]!) === shade; end++);
      if (shade === 0) continue;
      const wide = px((end - x) * resolution * scale.metre);
      parts[shade]!.push(
        `M${at(scale, [origin[0] + x * resolution, origin[1] + (y + 1) * resolution])}h${wide}v${side}h-${wide}z`,
      );
    }
  return parts
    .map((one, i) => (one.length > 0 ? `<path class="lab-cost lab-cost-${i}" d="${one.join("")}"/>` : ""))
    .join("");
}

const shadeOf = (value: number): number =>
  Number.isFinite(value) ? Math.min(SHADES - 1, Math.floor(SHADES * (1 - Math.exp(-value)))) : SHADES - 1;
