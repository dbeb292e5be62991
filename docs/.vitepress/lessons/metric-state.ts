/** What a figure with cars knows: poses in metres, the settings that the reader turns, and the package's answers. */
import type {
  HybridPlan,
  Layer,
  PathCheck,
  Plan,
  PlannerId,
  Pose,
  ReedsSheppCurve,
  RoadPlan,
  Scenario,
  SceneGeometry,
} from "parkade";
import type { Slider } from "./grid-state";
import type { Text } from "./words";

export type Engine = Pick<
  typeof import("parkade"),
  "Planner" | "sceneGeometry" | "checkPath" | "reedsShepp" | "collisionRisk"
>;

export interface MetricChoice {
  key: string;
  planner: PlannerId;
  settings?: Record<string, number | boolean | string>;
  title: Text;
}

export interface MetricFigure {
  kind: "metric";
  scene: Scenario;
  /** Metres from one side of the picture to the other; its lower left corner is the map's. */
  across: number;
  /** One car that stands; one that drives an arc; all curves between two; plans; plans over a cost map. */
  shows: "body" | "arc" | "curves" | "plan" | "cost";
  choices?: readonly MetricChoice[];
  sliders?: readonly Slider[];
  /** Simulated drives along the path. */
  drives?: number;
  /** The ends that can be dragged; default both. */
  moves?: readonly ("start" | "goal")[];
  done(state: MetricState): boolean;
}

export interface MetricState {
  figure: MetricFigure;
  start: Pose;
  goal: Pose;
  chosen: string;
  values: Record<string, number>;
  geometry: SceneGeometry | null;
  check: PathCheck | null;
  /** The arc that the car drives: x, y, heading, … */
  driven: number[];
  curves: ReedsSheppCurve[];
  plans: Record<string, Plan>;
  /** Of the simulated drives, how many hit something; null where there are none. */
  hits: number | null;
  cost: Layer | null;
  clearance: Layer | null;
}

export function initialMetric(figure: MetricFigure): MetricState {
  return {
    figure,
    start: { ...figure.scene.start },
    goal: { ...(figure.scene.goal as Pose) },
    chosen: figure.choices?.[0]?.key ?? "",
    values: Object.fromEntries((figure.sliders ?? []).map(({ setting, value }) => [setting, value])),
    geometry: null,
    check: null,
    driven: [],
    curves: [],
    plans: {},
    hits: null,
    cost: null,
    clearance: null,
  };
}

export const sceneOf = ({ figure, start, goal }: MetricState): Scenario => ({ ...figure.scene, start, goal });

/** Where a pose comes to along an arc. */
export function advanced({ x, y, heading }: Pose, curvature: number, length: number): Pose {
  const turned = heading + curvature * length;
  if (Math.abs(curvature) < 1e-9)
    return { x: x + length * Math.cos(heading), y: y + length * Math.sin(heading), heading };
  return {
    x: x + (Math.sin(turned) - Math.sin(heading)) / curvature,
    y: y - (Math.cos(turned) - Math.cos(heading)) / curvature,
    heading: turned,
  };
}

/** The arc that the car drives with the wheel as it is turned: a quarter of a circle, or so many metres. */
export const curvatureOf = ({ values, geometry }: MetricState): number =>
  Math.tan(((values["steer"] ?? 0) * Math.PI) / 180) / geometry!.vehicle.wheelbase;

const STEP = 0.05;

function drive(state: MetricState): number[] {
  const curvature = curvatureOf(state),
    length = state.values["metres"] ?? 12;
  const count = Math.ceil(length / STEP);
  return Array.from({ length: count + 1 }, (_, i) => advanced(state.start, curvature, (length * i) / count)).flatMap(
    ({ x, y, heading }) => [x, y, heading],
  );
}

export function solveMetric(state: MetricState, engine: Engine): void {
  const { figure } = state,
    scene = sceneOf(state);
  state.geometry = engine.sceneGeometry(scene);
  if (figure.shows === "body")
    state.check = engine.checkPath(scene, [state.start.x, state.start.y, state.start.heading]);
  if (figure.shows === "arc") {
    state.driven = drive(state);
    state.check = engine.checkPath(scene, state.driven);
  }
  if (figure.shows === "curves")
    state.curves = engine.reedsShepp(state.start, state.goal, state.geometry.vehicle.minTurningRadius);
  for (const choice of figure.choices ?? []) answer(state, choice, scene, engine);
}

function answer(
  state: MetricState,
  { key, planner: id, settings }: MetricChoice,
  scene: Scenario,
  engine: Engine,
): void {
  const { Planner, collisionRisk } = engine;
  const planner = new Planner(id, scene, { ...settings, ...planned(state) } as never);
  const plan = planner.plan({ trace: state.figure.shows === "plan" }) as Plan;
  state.plans[key] = plan;
  if (key === state.chosen) {
    const { drives, shows } = state.figure;
    state.hits = drives && plan.outcome === "found" ? collisionRisk(scene, plan, { trials: drives }).hits : null;
    state.cost = shows === "cost" && id === "cost-map" ? planner.layer("cost") : null;
    state.clearance = shows === "cost" ? planner.layer("clearance") : null;
  }
  planner.free();
}

/** The sliders that are settings of the planner; others change the scene or the car. */
const planned = ({ values, figure }: MetricState): Record<string, number> => (figure.shows === "arc" ? {} : values);

export const hybridOf = ({ plans, chosen }: MetricState, key = chosen): HybridPlan => plans[key] as HybridPlan;
export const roadOf = ({ plans, chosen }: MetricState, key = chosen): RoadPlan => plans[key] as RoadPlan;

/** The curve that the slider of lesson 6 chooses. */
export const curveOf = ({ curves, values }: MetricState): ReedsSheppCurve | undefined =>
  curves[Math.min(curves.length, values["curve"] ?? 1) - 1];
