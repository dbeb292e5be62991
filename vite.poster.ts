import { createHash } from "node:crypto";
import { pathToFileURL } from "node:url";
import type { Plugin, Rolldown } from "vite";
import type { Plan } from "parkade";
import { footprint, vehicleOf, type ResolvedVehicle } from "./www/src/scene/vehicle";
import { pickHits } from "./www/src/view/drive";

/** The page's first scene and planners, and how many pixels a metre has in the poster. */
const SCENE = "perpendicular",
  SCALE = 14;
const PLANNERS = [
  ["four", "4-neighbour", "#0072b2", ""],
  ["eight", "8-neighbour", "#d55e00", "9 5"],
  ["risk-field", "Risk field", "#009e73", "10 4 2 4"],
  ["hybrid", "Hybrid A*", "#cc79a7", "0.1 6.5"],
] as const;
/** Metres that a path's corners may be beside the plan's, and below the goal for its handle. */
const TOLERANCE = 0.03,
  HANDLE = 6.3;
/** Metres along a path from one outline of its swept area to the next. */
const SWEEP_STEP = 0.7;
const HATCH =
  '<pattern id="hatch" width="6" height="6" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path ' +
  'fill="none" stroke="#b3261e" stroke-width="1.2" stroke-opacity=".8" d="M0 3H6"/></pattern>';

type Api = typeof import("parkade");
type At = [number, number];

/** Puts the opening picture into the page: the same lot and plans in the same places as the live page's first ones. */
export function poster(modulePath: string): Plugin {
  let made = { html: "", css: "" };
  return {
    name: "poster",
    apply: "build",
    enforce: "pre",
    async buildStart() {
      const api = (await import(pathToFileURL(modulePath).href)) as Api;
      await api.init();
      made = draw(api);
    },
    transform: (code, id) => (id.endsWith("/styles/page.css") ? code + made.css : null),
    transformIndexHtml: {
      order: "post",
      handler(html, { bundle = {} }) {
        const script = /<script>([^]*?)<\/script>/.exec(html)?.[1];
        if (!script) return html;
        const hash = createHash("sha256").update(script).digest("base64");
        return html
          .replace("<!--poster-->", made.html)
          .replace("script-src 'self'", `script-src 'self' 'sha256-${hash}'`)
          .replace('<link rel="stylesheet"', `${early(bundle)}<link rel="stylesheet"`);
      },
    },
  };
}

/** The first planners are fetched beside the page's script, not after it. */
function early(bundle: Rolldown.OutputBundle): string {
  const files = Object.values(bundle),
    engine = files.find((file) => file.type === "chunk" && file.name === "engine-core");
  const modules = files
    .filter((file) => file.type === "asset" && file.fileName.endsWith(".wasm"))
    .map((file) => ({ file: file.fileName, size: (file as Rolldown.OutputAsset).source.length }));
  const core = modules.sort((a, b) => a.size - b.size)[0];
  if (engine?.type !== "chunk" || !core) throw new Error("the build has no first planners");
  const scripts = [engine.fileName, ...engine.imports].map(
    (file) => `<link rel="modulepreload" crossorigin href="./${file}">`,
  );
  return [
    ...scripts,
    `<link rel="preload" as="fetch" type="application/wasm" crossorigin href="./${core.file}">`,
    "",
  ].join("\n  ");
}

function draw(api: Api): { html: string; css: string } {
  const scene = api.scenario(SCENE),
    { goal } = api.sceneGeometry(scene);
  const xs = scene.map.boundary!.map(([x]) => x),
    ys = scene.map.boundary!.map(([, y]) => y);
  const handle: At = [goal.x + HANDLE * Math.cos(goal.heading), goal.y + HANDLE * Math.sin(goal.heading)];
  const left = Math.min(...xs, handle[0]),
    right = Math.max(...xs, handle[0]),
    low = Math.min(...ys, handle[1]),
    top = Math.max(...ys, handle[1]);
  const width = Math.round((right - left) * SCALE),
    height = Math.round((top - low) * SCALE);
  const svg = api.toSVG(scene, [], {
    width,
    height,
    theme: "auto",
    camera: { x: (left + right) / 2, y: (low + top) / 2, scale: SCALE },
  });
  const { rules, body } = shortened(svg);
  const pixel = ([x, y]: At, digits = 1): string =>
    [(x - left) * SCALE, (top - y) * SCALE].map((value) => Number(value.toFixed(digits))).join(" ");
  const outline = (corners: readonly (readonly [number, number])[]): string =>
    `M${corners.map(([x, y]) => pixel([x, y], 0)).join("L")}Z`;
  const panels = PLANNERS.map(([id, name, colour, dashes], i) => {
    const planner = new api.Planner(id, scene),
      plan = planner.plan();
    planner.free();
    const shape = (plan.check.drivable ? swept : hit)(plan, vehicleOf(scene.vehicle)).map(outline).join("");
    const area = plan.check.drivable
      ? `<path fill="${colour}" fill-opacity=".15" d="${shape}"/>`
      : `${HATCH}<path fill="url(#hatch)" stroke="#b3261e" stroke-linejoin="round" d="${shape}"/>`;
    const lines = legs(plan.path, plan.directions)
      .map(
        ({ points, gear }) =>
          `<path fill="none" stroke="${colour}" stroke-width="${id === "hybrid" ? 3 : 2}" stroke-linejoin="round"${
            id === "hybrid" && gear > 0
              ? ""
              : dashes && ` stroke-dasharray="${dashes}" stroke-linecap="${id === "hybrid" ? "round" : "butt"}"`
          } d="M${thinned(points)
            .map((at) => pixel(at))
            .join("L")}"/>`,
      )
      .join("");
    const lot = i === 0 ? `<g id="lot">${body}</g>` : `<use href="#lot"/>`;
    return (
      `<div><b>${name}</b><svg viewBox="0 ` +
      `0 ${width} ${height}" aria-hidden="true">${lot}${area}${lines}</svg></div>`
    );
  });
  return { html: panels.join(""), css: rules };
}

const bodyAt = ({ path }: Plan, i: number, vehicle: ResolvedVehicle): At[] =>
  footprint({ x: path[3 * i]!, y: path[3 * i + 1]!, heading: path[3 * i + 2]! }, vehicle);

/** The poses that the live page hatches. */
const hit = (plan: Plan, vehicle: ResolvedVehicle): At[][] =>
  pickHits(plan.check.hitPoses).map((i) => bodyAt(plan, i, vehicle));

/** Outlines that together cover what the car sweeps, as nearly as the poster shows. */
function swept(plan: Plan, vehicle: ResolvedVehicle): At[][] {
  const { path } = plan,
    kept: At[][] = [];
  let left = 0;
  for (let i = 0; 3 * i < path.length; i++) {
    if (i > 0) left -= Math.hypot(path[3 * i]! - path[3 * i - 3]!, path[3 * i + 1]! - path[3 * i - 2]!);
    if (left > 0 && 3 * i + 3 < path.length) continue;
    kept.push(bodyAt(plan, i, vehicle));
    left = SWEEP_STEP;
  }
  return kept;
}

/** One path for each gear. */
function legs(path: ArrayLike<number>, directions: ArrayLike<number>): { points: At[]; gear: number }[] {
  const found: { points: At[]; gear: number }[] = [];
  for (let i = 0; 3 * i < path.length; i++) {
    const at: At = [path[3 * i]!, path[3 * i + 1]!],
      last = found.at(-1),
      gear = directions[i] ?? last?.gear ?? 1;
    last?.points.push(at);
    if (last?.gear !== gear) found.push({ points: [at], gear });
  }
  return found.filter(({ points }) => points.length > 1);
}

/** Fewer corners, by Douglas and Peucker. */
function thinned(points: readonly At[]): At[] {
  const [a, b] = [points[0]!, points.at(-1)!],
    length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const beside = points.map(([x, y]) =>
    length > 0
      ? Math.abs((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / length
      : Math.hypot(x - a[0], y - a[1]),
  );
  const worst = beside.indexOf(Math.max(...beside));
  if (points.length < 3 || beside[worst]! <= TOLERANCE) return [a, b];
  return [...thinned(points.slice(0, worst + 1)).slice(0, -1), ...thinned(points.slice(worst))];
}

/** The drawing without what names and explains it, its colours by short names as rules for the page's stylesheet. */
function shortened(svg: string): { rules: string; body: string } {
  const names = new Map<string, string>();
  const short = svg.replace(/\bk[0-9a-z]{8,}\b/g, (name) => {
    if (!names.has(name)) names.set(name, `poster-${names.size.toString(36)}`);
    return names.get(name)!;
  });
  const rules = /<style>([^]*?)<\/style>/.exec(short)?.[1] ?? "";
  const body = short
    .replace(/^<svg[^>]*>|<\/svg>\s*$|<(title|metadata|style)>[^]*?<\/\1>| stroke-miterlimit="10"/g, "")
    .replace(/(\d\.\d)\d/g, "$1")
    .replace(/(\d)\.0\b/g, "$1");
  return { rules, body };
}
