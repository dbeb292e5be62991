// @ts-check
// A scene and its plans as an SVG picture; in the complete module only.
import { planners, sceneGeometry } from "./api.js";
import { unpackedScene } from "./cells.js";
import { draw } from "./drawing.js";
import { ParkadeError, measures, numbers, object, shown, text } from "./runtime.js";

/** @type {typeof import("./index.js").toSVG} */
export function toSVG(given, plans = [], options = {}) {
  const {
    width = 720,
    height = 420,
    theme = "auto",
    layout,
    controls,
    camera = null,
    colours = {},
    layers = {},
    planned = {},
  } = object(options, "options");
  for (const [name, value] of Object.entries({ width, height })) {
    if (typeof value !== "number" || !(value >= 16 && value <= 8192))
      throw new ParkadeError(`${name}: must be 16 to 8192 pixels, got ${shown(value)}`, "bad-input", name);
  }
  oneOf("theme", theme, ["auto", "light", "dark"]);
  if (layout !== undefined) oneOf("layout", layout, ["single", "overlay"]);
  if (controls !== undefined) oneOf("controls", controls, ["none", "minimal"]);
  if (camera !== null) checkCamera(camera);
  const geometry = sceneGeometry(given),
    data = JSON.stringify(given, (_, value) => (typeof value === "bigint" ? Number(value) : value));
  /** @type {import("./index.js").Scenario} */
  const scene = unpackedScene(JSON.parse(data));
  const title = text(options.title ?? scene.name ?? "", "title");
  const drawn = (Array.isArray(plans) ? plans : [plans]).map((plan, i) => checkPlan(object(plan, `plans[${i}]`)));
  // Pictures show one goal.
  if (geometry.goals) scene.goal = geometry.goal = drawn.find(({ goal }) => goal)?.goal?.pose ?? geometry.goal;
  const picture = {
    scene,
    geometry,
    data,
    title,
    width,
    height,
    theme,
    camera,
    element: layout || controls ? { layout: layout ?? "single", controls: controls ?? "none" } : null,
    planners: planners(),
    plans: drawn,
    planned: plannedPaths(object(planned, "planned")),
    layers: object(layers, "layers"),
    colours: object(colours, "colours"),
  };
  try {
    return draw(picture);
  } catch (error) {
    // The scene is sound; of plans from elsewhere only the lists are known to be.
    throw new ParkadeError(
      `plans: must be as planners answer them: ${error instanceof Error ? error.message : shown(error)}`,
      "bad-input",
      "plans",
      { cause: error },
    );
  }
}

/** @param {Record<string, unknown>} planned */
const plannedPaths = (planned) =>
  Object.fromEntries(
    Object.entries(planned).map(([planner, path]) => [planner, numbers(Float64Array, path, `planned.${planner}`)]),
  );

/** @param {string} name @param {unknown} value @param {string[]} known */
function oneOf(name, value, known) {
  if (!known.includes(/** @type {string} */ (value)))
    throw new ParkadeError(
      `${name}: must be ${known.slice(0, -1).join(", ")} or ${known.at(-1)}, got ${shown(value)}`,
      "bad-input",
      name,
    );
}

/** @param {import("./index.js").Camera} camera */
function checkCamera(camera) {
  const { x, y, scale } = object(camera, "camera");
  for (const [name, value] of Object.entries({ x, y, scale })) {
    if (!Number.isFinite(value) || (name === "scale" && value <= 0))
      throw new ParkadeError(
        `camera.${name}: must be a ${name === "scale" ? "positive " : ""}number, got ${shown(value)}`,
        "bad-input",
        `camera.${name}`,
      );
  }
}

/**
 * The parts of a plan that a picture needs; lists from JSON may be plain arrays.
 * @param {import("./index.js").Plan} plan
 */
function checkPlan(plan) {
  const { planner, outcome } = plan,
    check = object(plan.check, "plan.check");
  text(planner, "plan.planner");
  object(plan.metrics, "plan.metrics");
  const path = numbers(Float64Array, plan.path, "plan.path");
  const curvatures = measures(plan.curvatures, "plan.curvatures"),
    clearances = measures(plan.clearances, "plan.clearances");
  const hitPoses = numbers(Uint32Array, check.hitPoses, "plan.check.hitPoses");
  if (outcome === "found" && path.length < 3)
    throw new ParkadeError("plan.path: must have poses", "bad-input", "plan.path");
  return { ...plan, path, curvatures, clearances, check: { ...check, hitPoses } };
}
