// @ts-check
// A scene and its plans as an SVG picture; in the complete module only.
import { planners, sceneGeometry } from "./api.js";
import { unpackedScene } from "./cells.js";
import { draw } from "./drawing.js";
import { ParkadeError, numbers, object, text } from "./runtime.js";

/** @type {typeof import("./index.js").toSVG} */
export function toSVG(given, plans = [], options = {}) {
  const { width = 720, height = 420, theme = "auto", layout, controls, camera = null, colours = {}, layers = {} } = object(options, "options");
  for (const [name, value] of Object.entries({ width, height })) {
    if (typeof value !== "number" || !(value >= 16 && value <= 8192)) throw new ParkadeError(`${name}: must be 16 to 8192 pixels, got ${String(value)}`, "bad-input", name);
  }
  oneOf("theme", theme, ["auto", "light", "dark"]);
  if (layout !== undefined) oneOf("layout", layout, ["single", "overlay"]);
  if (controls !== undefined) oneOf("controls", controls, ["none", "minimal"]);
  if (camera !== null) checkCamera(camera);
  const geometry = sceneGeometry(given), data = JSON.stringify(given, (_, value) => (typeof value === "bigint" ? Number(value) : value));
  /** @type {import("./index.js").Scenario} */
  const scene = unpackedScene(JSON.parse(data));
  const title = text(options.title ?? scene.name ?? "", "title");
  const shown = (Array.isArray(plans) ? plans : [plans]).map((plan, i) => checkPlan(object(plan, `plans[${i}]`)));
  return draw({
    scene, geometry, data, title, width, height, theme, camera, element: layout || controls ? { layout: layout ?? "single", controls: controls ?? "none" } : null, planners: planners(), plans: shown,
    layers: object(layers, "layers"), colours: object(colours, "colours"),
  });
}

/** @param {string} name @param {unknown} value @param {string[]} known */
function oneOf(name, value, known) {
  if (!known.includes(/** @type {string} */ (value))) throw new ParkadeError(`${name}: must be ${known.slice(0, -1).join(", ")} or ${known.at(-1)}, got ${String(value)}`, "bad-input", name);
}

/** @param {import("./index.js").Camera} camera */
function checkCamera(camera) {
  const { x, y, scale } = object(camera, "camera");
  for (const [name, value] of Object.entries({ x, y, scale })) {
    if (!Number.isFinite(value) || (name === "scale" && value <= 0)) throw new ParkadeError(`camera.${name}: must be a ${name === "scale" ? "positive " : ""}number, got ${String(value)}`, "bad-input", `camera.${name}`);
  }
}

/** What a picture needs of a plan; from JSON its lists may be plain ones. @param {import("./index.js").Plan} plan */
function checkPlan(plan) {
  const { planner, outcome, path, check } = plan;
  text(planner, "plan.planner");
  object(check, "plan.check");
  const poses = numbers(Float64Array, path, "plan.path");
  if (outcome === "found" && poses.length < 3) throw new ParkadeError("plan.path: must have poses", "bad-input", "plan.path");
  return { ...plan, path: poses };
}
