/** Figures as SVG: the page's own picture of a scene and its paths, with what a paper's figure adds to it. */
import type { Plan, PlannerId, Scenario } from "parkade";
import { below, isLong, STRIP } from "../../../www/src/view/camera";
import { Planner, scenario, stopWaitGo, toSVG } from "../../../pkg/node.js";
import type { Figure } from "./blocks";
import {
  compared,
  drawnArc,
  marks,
  potential,
  pruned,
  smoothed,
  spaces,
  tangents,
  type Point,
  type Staged,
  type View,
} from "./overlays";

const WIDTH = 640,
  SIDE = 440,
  FIT = 0.92,
  /** A row of times above the scene, pixels. */
  TIMES = 60;

/** Figures that draw the paths themselves, by their stages. */
const OWN_PATHS: readonly Figure["draws"][] = ["pruned", "tangents", "smoothed", "spaces"];

/** The figure's picture; the longer side of its map fills the width, or the height of a square. */
export function picture({ scene: id, planners, draws, svg }: Figure): string {
  if (svg !== undefined) return svg;
  const scene = scenario(id),
    own = OWN_PATHS.includes(draws);
  const made = planners.map((planner) => new Planner(planner as PlannerId, scene));
  try {
    const plans = made.map((planner) => planner.plan({ trace: own }) as Staged);
    const view = viewOf(scene, draws, plans[0]!);
    const whole = toSVG(scene, own ? [] : plans.map((plan) => ({ ...plan, trace: null }) as Plan), {
      width: view.width,
      height: view.height,
      theme: "light",
      camera: { x: view.x, y: view.y, scale: view.scale },
    });
    return whole
      .replace(/<metadata>[^]*?<\/metadata>/, "")
      .replace(/<\/svg>\s*$/, `${over(view, scene, made.at(-1)!, plans, draws)}</svg>`);
  } finally {
    for (const planner of made) planner.free();
  }
}

/** Above a long road its strip is drawn, and above moving things their times. */
function viewOf(scene: Scenario, draws: Figure["draws"], { stages }: Staged): View {
  if (draws === "tangents") {
    const { corner, center, radius } = drawnArc(stages!);
    const [x, y] = [(corner[0] + center[0]) / 2, (corner[1] + center[1]) / 2];
    return { x, y, scale: SIDE / (3.4 * radius), width: SIDE, height: SIDE };
  }
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
  const strip = isLong(scene) ? STRIP.room : draws === "marks" ? TIMES : 0;
  const middle = { x: left + size[0] / 2, y: bottom + size[1] / 2, scale };
  return { ...below(strip, middle), width: across, height: Math.round(high) + strip };
}

function over(view: View, scene: Scenario, planner: Planner, plans: readonly Staged[], draws: Figure["draws"]): string {
  const at = ([x, y]: Point): [number, number] => [
    view.width / 2 + (x - view.x) * view.scale,
    view.height / 2 - (y - view.y) * view.scale,
  ];
  const plan = plans[0]!;
  switch (draws) {
    case "potential":
      return potential(scene, planner, at);
    case "pruned":
      return pruned(plan, at);
    case "tangents":
      return tangents(plan, view.scale, at);
    case "smoothed":
      return smoothed(plan, view.scale, at);
    case "spaces":
      return spaces(scene, planner, view, at) + (plans.length > 1 ? compared(plans, view.scale, at) : "");
    case "marks":
      return marks(view, scene, stopWaitGo(scene, plan), at);
    case undefined:
      return "";
  }
}
