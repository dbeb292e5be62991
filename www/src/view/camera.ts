/** The one map from metres to pixels, and what moves it. */
import type { Plan, Pose, Scenario, SceneGeometry } from "parkade";
import type { Camera, State } from "../store";
import { resolve } from "../scene/model";
import { boxOf, fromPose, type Box, type Point } from "../scene/plane";
import { footprint } from "../scene/vehicle";
import { STALK } from "./pose-handle";

/** A camera on a canvas of a size in CSS pixels. */
export interface View { camera: Camera; width: number; height: number }

export const MIN_SCALE = 1;
/** Pixels that the longer side of the widest map keeps. */
const LEAST_MAP = 200;

/** The smallest scale at which a map is looked at. */
export const leastScale = ({ width, height, resolution }: Scenario["map"]): number =>
  Math.min(MIN_SCALE, LEAST_MAP / (Math.max(width, height) * resolution));

export const MAX_SCALE = 400;
const SPARE_PX = 6;
/** CSS pixels between the map and the middle of the view at most, at the smallest scale. */
const FARTHEST_PX = 4000;

type Range = readonly [least: number, most: number];

/** Where a camera makes sense: whole metres, so that a link's rounding stays inside. */
export function cameraLimits(map: Scenario["map"]): Record<keyof Camera, Range> {
  const { origin, width, height, resolution } = map, least = leastScale(map), reach = FARTHEST_PX / least;
  const range = (from: number, length: number): Range => [Math.floor(from - reach), Math.ceil(from + length + reach)];
  return { x: range(origin[0], width * resolution), y: range(origin[1], height * resolution), scale: [least, MAX_SCALE] };
}

const clamp = (value: number, [least, most]: Range): number => Math.min(most, Math.max(least, value));

/** The camera within the map's limits; null where it is no place at all. */
export function limited(camera: Camera | null, map: Scenario["map"]): Camera | null {
  if (!camera) return null;
  const limits = cameraLimits(map), x = clamp(camera.x, limits.x), y = clamp(camera.y, limits.y), scale = clamp(camera.scale, limits.scale);
  if (x === camera.x && y === camera.y && scale === camera.scale) return camera;
  return Number.isNaN(x + y + scale) ? null : { x, y, scale };
}

export function worldToScreen({ camera, width, height }: View, x: number, y: number): Point {
  return [width / 2 + (x - camera.x) * camera.scale, height / 2 - (y - camera.y) * camera.scale];
}

export function screenToWorld({ camera, width, height }: View, x: number, y: number): Point {
  return [camera.x + (x - width / 2) / camera.scale, camera.y - (y - height / 2) / camera.scale];
}

/** The camera zoomed by `factor` with the world point under the pixel held in place. */
export function zoomAt(view: View, pixelX: number, pixelY: number, factor: number, least = MIN_SCALE): Camera {
  const [x, y] = screenToWorld(view, pixelX, pixelY);
  const scale = Math.min(MAX_SCALE, Math.max(least, view.camera.scale * factor));
  const kept = view.camera.scale / scale;
  return { x: x + (view.camera.x - x) * kept, y: y + (view.camera.y - y) * kept, scale };
}

export const panBy = (camera: Camera, dx: number, dy: number): Camera =>
  ({ ...camera, x: camera.x - dx / camera.scale, y: camera.y + dy / camera.scale });

/** Shows start, goal, their slots and where the cars sweep, with a few pixels to spare. */
export function fit(scene: Scenario, geometry: SceneGeometry | null, width: number, height: number, plans: readonly Plan[] = []): Camera {
  const resolved = resolve(scene);
  const vehicle = geometry?.vehicle ?? resolved.vehicle;
  const start = geometry?.start ?? resolved.start, goal = geometry?.goal ?? resolved.goal;
  const points = [...footprint(start, vehicle, 0.6), ...footprint(goal, vehicle, 0.6)];
  for (const plan of plans) addSweep(points, plan, vehicle);
  if (plans.length === 0) {
    const swing = vehicle.minTurningRadius * 0.45;
    points.push(...footprint(goal, vehicle, swing), ...footprint(start, vehicle, swing / 2));
  }
  const box = clip(boxOf(points), boxOf(resolved.boundary));
  return frameBox(boxOf([[box.minX, box.minY], [box.maxX, box.maxY], gripEnd(goal, vehicle.rearToFront)]), width, height, leastScale(scene.map));
}

/** Shows the whole map. */
export function fitMap(scene: Scenario, width: number, height: number): Camera {
  return frameBox(boxOf(resolve(scene).boundary), width, height, leastScale(scene.map));
}

/** A little beyond the goal's grip, which may stand outside the floor. */
const gripEnd = (pose: Pose, front: number): Point => fromPose(pose, front + STALK + 0.6, 0);

function addSweep(points: Point[], plan: Plan, vehicle: SceneGeometry["vehicle"]): void {
  for (let i = 0; i + 2 < plan.path.length; i += 12) {
    points.push(...footprint({ x: plan.path[i]!, y: plan.path[i + 1]!, heading: plan.path[i + 2]! }, vehicle));
  }
}

/** Walls are drawn outside the floor, so its edge stays in sight. */
function clip(box: Box, floor: Box): Box {
  const edge = 0.5;
  const clipped = {
    minX: Math.max(box.minX, floor.minX - edge), minY: Math.max(box.minY, floor.minY - edge),
    maxX: Math.min(box.maxX, floor.maxX + edge), maxY: Math.min(box.maxY, floor.maxY + edge),
  };
  return clipped.minX < clipped.maxX && clipped.minY < clipped.maxY ? clipped : box;
}

/** Height of the line over a map that says why its planner fails, CSS pixels; kept free whether it is there or not. */
export const LINE = 28;

/** The camera that shows at the middle of the canvas what `camera` shows at the middle of the part below the line. */
export const belowLine = (camera: Camera): Camera => ({ ...camera, y: camera.y + LINE / 2 / camera.scale });

/** The camera on a box. */
export function frameBox(box: Box, width: number, height: number, least: number): Camera {
  const across = Math.max(1, width - 2 * SPARE_PX), up = Math.max(1, height - 2 * SPARE_PX);
  const scale = Math.min(across / Math.max(1, box.maxX - box.minX), up / Math.max(1, box.maxY - box.minY));
  return { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2, scale: Math.min(MAX_SCALE, Math.max(least, scale)) };
}

/** A fit and what it was made from. */
interface Fitted { scene: Scenario; results: State["results"]; camera: Camera }

const fits = new WeakMap<Scenario["map"], Map<string, Fitted>>();
const MOST_SIZES = 12;

/**
 * The camera in force on a canvas of this size. A fit takes in the plans as they arrive and then stays while the scene
 * is edited: edits keep the map, another scene brings its own.
 */
export function cameraFor(state: State, width: number, height: number): Camera {
  const { scene, results } = state, chosen = limited(state.camera, scene.map);
  if (chosen) return chosen;
  const sizes = fits.get(scene.map) ?? new Map<string, Fitted>();
  const size = `${state.mode}${width}x${height}`, known = sizes.get(size);
  if (known && (known.scene !== scene || known.results === results)) return known.camera;
  if (sizes.size >= MOST_SIZES) sizes.clear();
  const camera = fitBesideLegend(state, width, height);
  sizes.set(size, { scene, results, camera });
  fits.set(scene.map, sizes);
  return camera;
}

/** The corner at the lower right that the list of planners takes in overlay mode, CSS pixels. */
const LEGEND = { width: 350, height: 134, from: 640 };

/** No panel may lie over the start or goal car: where the list would, the scene moves up. */
function fitBesideLegend(state: State, width: number, height: number): Camera {
  const plans = drivablePlans(state);
  const camera = belowLine(fit(state.scene, state.geometry, width, height - LINE, plans));
  if (state.mode !== "overlay" || width <= LEGEND.from) return camera;
  const { start, goal, vehicle } = resolve(state.scene);
  const covered = [start, goal].flatMap((pose) => [...footprint(pose, vehicle), gripEnd(pose, vehicle.rearToFront)]).some(([x, y]) => {
    const [px, py] = worldToScreen({ camera, width, height }, x, y);
    return px > width - LEGEND.width && py > height - LEGEND.height;
  });
  if (!covered) return camera;
  const above = belowLine(fit(state.scene, state.geometry, width, height - LINE - LEGEND.height, plans));
  return { ...above, y: above.y - LEGEND.height / 2 / above.scale };
}

/** Makes the next fit start afresh from the scene as it is then. */
export const forgetFit = (scene: Scenario): void => void fits.delete(scene.map);

function drivablePlans(state: State): Plan[] {
  return state.planners.flatMap((id) => {
    const result = state.results[id];
    const plan = result?.plan?.outcome === "found" ? result.plan : result?.lastGood;
    return plan?.check.drivable ? [plan] : [];
  });
}
