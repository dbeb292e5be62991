/** A scene and its plans as the page first shows them, drawn by the page's own layers. */
import type { Layer, LayerName, Plan, PlannerInfo, SceneGeometry } from "parkade";
import type { Scenario } from "../scene/scenario";
import { emptyResult, initialState, type Camera, type State } from "../store";
import { cameraFor } from "../view/camera";
import { makeFrame, type Context } from "../view/frame";
import { introduce } from "../styles/planner-style";
import { SceneLayers } from "../view/scene-layers";
import { makeTokens, type Tokens } from "../view/tokens";
import { drawOn } from "../view/surface";
import "./layers";
import { Canvas, escaped, file } from "./canvas";
import { svgOf } from "./svg";

/** All of it checked. */
export interface Picture {
  scene: Scenario;
  geometry: SceneGeometry;
  planners: readonly PlannerInfo[];
  plans: readonly Plan[];
  /** Planned paths, by planner, of which the plans' paths were made. */
  planned: Readonly<Record<string, Float64Array>>;
  width: number;
  height: number;
  theme: "auto" | "light" | "dark";
  title: string;
  /** The playground whose map this is, each in its place; null where the map is the whole picture. */
  element: { layout: "single" | "overlay"; controls: "none" | "minimal" } | null;
  /** Contents of `metadata`. */
  data: string;
  camera: Camera | null;
  /** Rasters of the plan that leads. */
  layers: Partial<Record<LayerName, Layer>>;
  /** Values of the page's `--parkade-…` properties, by what follows. */
  colours: Readonly<Record<string, string>>;
}

export const draw = (picture: Picture): string => drawOn(file, () => drawn(picture));

function drawn(picture: Picture): string {
  const { width, height, theme, title, data } = picture;
  introduce(picture.planners);
  const state = stateOf(picture),
    room = roomOf(picture);
  const size = { width, height: height - room.above - room.below },
    view = { camera: cameraFor(state, size.width, size.height), ...size };
  const sides = (theme === "auto" ? [false, true] : [theme === "dark"]).map((dark) => {
    const canvas = new Canvas(),
      bars = new Canvas(),
      tokens = makeTokens(dark, (name) => picture.colours[name] ?? "");
    const shown = picture.plans.map((plan) => ({
      planner: plan.planner,
      plan,
      result: { ...state.results[plan.planner]!, plan },
      ghost: false,
      ...(picture.planned[plan.planner] && { planned: picture.planned[plan.planner]! }),
    }));
    new SceneLayers().draw(
      makeFrame({ ctx: canvas.getContext() as unknown as Context, view, ratio: 1, state, tokens, shown, draft: null }),
    );
    drawBars(bars.getContext(), picture, room, tokens);
    return { canvas, bars };
  });
  const map = svgOf(sides.map(({ canvas }) => canvas)),
    around = svgOf(sides.map(({ bars }) => bars));
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" ` +
    `width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img">` +
    `<title>${escaped(title)}</title><metadata>${escaped(data)}</metadata>` +
    (room.above + room.below > 0
      ? `${around}<svg y="${room.above}" width="${width}" height="${size.height}">${map}</svg></svg>\n`
      : `${map}</svg>\n`)
  );
}

/** Pixels that a playground keeps from its map. */
interface Room {
  above: number;
  below: number;
}

/** The page's measures: a panel's title, the timeline on a desk and on a phone. */
const TITLE = 32,
  TIMELINE = 44,
  PHONE_TIMELINE = 48,
  PHONE = 640;

function roomOf({ element, width }: Picture): Room {
  const phone = width <= PHONE;
  return {
    above: element?.layout === "single" && !phone ? TITLE : 0,
    below: element?.controls === "minimal" ? (phone ? PHONE_TIMELINE : TIMELINE) : 0,
  };
}

function drawBars(
  ctx: ReturnType<Canvas["getContext"]>,
  { width, height }: Picture,
  { above, below }: Room,
  { colour }: Tokens,
): void {
  for (const [top, tall, line] of [
    [0, above, above - 1],
    [height - below, below, height - below],
  ] as const) {
    if (tall === 0) continue;
    ctx.fillStyle = colour.panel;
    ctx.fillRect(0, top, width, tall);
    ctx.fillStyle = colour.hair;
    ctx.fillRect(0, line, width, 1);
  }
}

function stateOf({ scene, geometry, plans, planned, layers, camera }: Picture): State {
  const planners = [...new Set(plans.map((plan) => plan.planner))];
  const focus = planners.includes("hybrid") ? "hybrid" : (planners.at(-1) ?? "hybrid");
  const results = Object.fromEntries(
    plans.map((plan) => [
      plan.planner,
      {
        ...emptyResult,
        plan,
        status: "done" as const,
        layers: plan.planner === focus ? layers : {},
      },
    ]),
  );
  return {
    ...initialState(),
    scene,
    geometry,
    planners,
    focus,
    mode: plans.length > 1 ? "overlay" : "grid",
    results,
    camera,
    complete: true,
    smooth: Object.keys(planned).length > 0,
  };
}
