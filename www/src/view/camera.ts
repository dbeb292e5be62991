/** The one map from metres to pixels, and what moves it. */
import type { Plan, Pose, SceneGeometry } from "parkade";
import type { GivenScenario, Scenario } from "../scene/scenario";
import type { Camera, State } from "../store";
import { played } from "../store/results";
import { resolve } from "../scene/model";
import { boxOf, fromPose, type Box, type Point } from "../scene/geometry";
import { footprint } from "../scene/vehicle";
import { drivenAt } from "./playback-time";
import { STALK } from "./pose-handle";

/** A camera on a canvas of a size in CSS pixels. */
export interface View {
  camera: Camera;
  width: number;
  height: number;
}

export const MIN_SCALE = 1;
/** Pixels that the longer side of the widest map keeps. */
const LEAST_MAP = 200;

/** The smallest scale at which a map is looked at. */
export const leastScale = ({ width, height, resolution }: Scenario["map"]): number =>
  Math.min(MIN_SCALE, LEAST_MAP / (Math.max(width, height) * resolution));

export const MAX_SCALE = 400;
/** Of a button or key. */
export const ZOOM_STEP = 1.4;
/** Share of a view's width and height that a fit leaves free on every side. */
const MARGIN = 0.06;
/** A lot is shown whole where its car is then at least this long, CSS pixels. */
const LEAST_CAR_PX = 32;
/** CSS pixels between the map and the middle of the view at most, at the smallest scale. */
const FARTHEST_PX = 4000;

type Range = readonly [least: number, most: number];

/** Bounds of a camera in whole metres, so that a link's rounding stays inside. */
export function cameraLimits(map: Scenario["map"]): Record<keyof Camera, Range> {
  const { origin, width, height, resolution } = map,
    least = leastScale(map),
    reach = FARTHEST_PX / least;
  const range = (from: number, length: number): Range => [Math.floor(from - reach), Math.ceil(from + length + reach)];
  return {
    x: range(origin[0], width * resolution),
    y: range(origin[1], height * resolution),
    scale: [least, MAX_SCALE],
  };
}

const clamp = (value: number, [least, most]: Range): number => Math.min(most, Math.max(least, value));

/** The camera within the map's limits; null where it is no place at all. */
export function limited(camera: Camera | null, map: Scenario["map"]): Camera | null {
  if (!camera) return null;
  const limits = cameraLimits(map),
    x = clamp(camera.x, limits.x),
    y = clamp(camera.y, limits.y),
    scale = clamp(camera.scale, limits.scale);
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

export const panBy = (camera: Camera, dx: number, dy: number): Camera => ({
  ...camera,
  x: camera.x - dx / camera.scale,
  y: camera.y + dy / camera.scale,
});

/** Shows the whole lot; of one too large for that, start, goal, paths and where the cars sweep. */
export function fit(
  scene: Scenario,
  geometry: SceneGeometry | null,
  width: number,
  height: number,
  plans: readonly Plan[] = [],
): Camera {
  const resolved = resolve(scene);
  const vehicle = geometry?.vehicle ?? resolved.vehicle;
  const start = geometry?.start ?? resolved.start,
    goal = geometry?.goal ?? resolved.goal;
  const least = leastScale(scene.map),
    cars = [...footprint(start, vehicle), ...footprint(goal, vehicle), gripEnd(goal, vehicle.rearToFront)];
  const lot = frameBox(boxOf([...resolved.boundary, ...cars]), width, height, least);
  if (lot.scale * (vehicle.rearToFront + vehicle.rearToBack) >= LEAST_CAR_PX) return lot;
  const points = [...footprint(start, vehicle, 0.6), ...footprint(goal, vehicle, 0.6)];
  for (const plan of plans) addPlan(points, plan, vehicle);
  if (plans.length === 0) {
    const swing = vehicle.minTurningRadius * 0.45;
    points.push(...footprint(goal, vehicle, swing), ...footprint(start, vehicle, swing / 2));
  }
  const box = clip(boxOf(points), boxOf(resolved.boundary));
  return frameBox(boxOf([[box.minX, box.minY], [box.maxX, box.maxY], ...cars]), width, height, least);
}

/** Shows the whole map. */
export function fitMap(scene: Scenario, width: number, height: number): Camera {
  return frameBox(boxOf(resolve(scene).boundary), width, height, leastScale(scene.map));
}

/** A little beyond the goal's grip, which may stand outside the floor. */
const gripEnd = (pose: Pose, front: number): Point => fromPose(pose, front + STALK + 0.6, 0);

/** The sweep of what the car can drive, the line of what it cannot. */
function addPlan(points: Point[], { path, check }: Plan, vehicle: SceneGeometry["vehicle"]): void {
  for (let i = 0; i + 2 < path.length; i += 12) {
    const [x = 0, y = 0, heading = 0] = path.subarray(i);
    if (check.drivable) points.push(...footprint({ x, y, heading }, vehicle));
    else points.push([x, y]);
  }
}

/** Walls are drawn outside the floor, so its edge stays in sight. */
function clip(box: Box, floor: Box): Box {
  const edge = 0.5;
  const clipped = {
    minX: Math.max(box.minX, floor.minX - edge),
    minY: Math.max(box.minY, floor.minY - edge),
    maxX: Math.min(box.maxX, floor.maxX + edge),
    maxY: Math.min(box.maxY, floor.maxY + edge),
  };
  return clipped.minX < clipped.maxX && clipped.minY < clipped.maxY ? clipped : box;
}

/** Height of the line over a map that says why its planner fails, CSS pixels; kept free whether it is there or not. */
export const LINE = 28;

/**
 * The strip over long maps, below the line: its top and height, and the room that both and its label take, CSS pixels.
 */
export const STRIP = { top: LINE + 18, height: 56, room: LINE + 18 + 56 + 30 };

/** Longer maps (metres) than this show a car as a dot. */
const LONG = 200;

export const isLong = ({ map: { width, height, resolution } }: GivenScenario): boolean =>
  Math.max(width, height) * resolution > LONG;

/**
 * The camera that shows at the middle of the canvas what `camera` shows at the middle of the part below `inset` pixels.
 */
export const below = (inset: number, camera: Camera): Camera => ({ ...camera, y: camera.y + inset / 2 / camera.scale });

/** The camera on a box. */
export function frameBox(box: Box, width: number, height: number, least: number): Camera {
  const across = Math.max(1, width * (1 - 2 * MARGIN)),
    up = Math.max(1, height * (1 - 2 * MARGIN));
  const scale = Math.min(across / Math.max(1, box.maxX - box.minX), up / Math.max(1, box.maxY - box.minY));
  return {
    x: (box.minX + box.maxX) / 2,
    y: (box.minY + box.maxY) / 2,
    scale: Math.min(MAX_SCALE, Math.max(least, scale)),
  };
}

/** A fit and what it was made from. */
interface Fitted {
  scene: Scenario;
  results: State["results"];
  camera: Camera;
}

const fits = new WeakMap<Scenario["map"], Map<string, Fitted>>();
const MOST_SIZES = 12;

/**
 * The camera in force on a canvas of this size. A fit takes in the plans as they arrive and then stays while the scene
 * is edited: edits keep the map, another scene brings its own.
 */
export function cameraFor(state: State, width: number, height: number): Camera {
  const { scene, results } = state,
    chosen = limited(state.camera, scene.map);
  if (chosen) return chosen;
  const followed = state.follow ? following(state, width) : null;
  if (followed) return followed;
  const sizes = fits.get(scene.map) ?? new Map<string, Fitted>();
  const size = `${state.mode}${width}x${height}`,
    known = sizes.get(size);
  if (known && (known.scene !== scene || known.results === results)) return known.camera;
  if (sizes.size >= MOST_SIZES) sizes.clear();
  const camera = fitClear(state, width, height);
  sizes.set(size, { scene, results, camera });
  fits.set(scene.map, sizes);
  return camera;
}

/** Visible stretch around a followed car, metres. */
const AROUND = 64;

/** On the focused planner's car; null where there is none to follow. */
function following(state: State, width: number): Camera | null {
  const result = state.results[state.focus],
    plan = result?.plan?.outcome === "found" ? played(result)!.plan : result?.lastGood;
  const driven = plan && drivenAt(state, plan, result, resolve(state.scene).vehicle.wheelbase);
  return driven ? below(STRIP.room, { x: driven.pose.x, y: driven.pose.y, scale: width / AROUND }) : null;
}

/** Maps lower than so many pixels have room for one line over them at most. */
export const LOW_MAP = 170;

/**
 * What stands on a map's lower edge, CSS pixels: the list of planners at the right of the overlay (so many rows at
 * once), and the view's buttons in the middle.
 */
export const LEGEND = { width: 350, row: 27, rows: 7, edge: 12, off: 14, from: 640 };
const BUTTONS = { width: 120, height: 48 };

/** No panel may lie over the start or goal car: where one would, the scene moves up. */
function fitClear(state: State, width: number, height: number): Camera {
  const { scene, geometry, mode, planners } = state,
    plans = foundPlans(state),
    inset = isLong(state.scene) ? STRIP.room : LINE;
  const listed = mode === "overlay" && width > LEGEND.from,
    alone = mode !== "grid" || planners.length === 1;
  const list = LEGEND.row * Math.min(LEGEND.rows, planners.length) + LEGEND.edge + LEGEND.off;
  const { start, goal, vehicle } = resolve(scene);
  const corners = [start, goal].flatMap((pose) => [...footprint(pose, vehicle), gripEnd(pose, vehicle.rearToFront)]);
  const fitAbove = (room: number): Camera => {
    const camera = below(inset, fit(scene, geometry, width, height - inset - room, plans));
    return { ...camera, y: camera.y - room / 2 / camera.scale };
  };
  let room = 0;
  for (const { width: across, height: up, from } of [
    ...(alone ? [{ ...BUTTONS, from: (width - BUTTONS.width) / 2 }] : []),
    ...(listed ? [{ width: LEGEND.width, height: list, from: width - LEGEND.width }] : []),
  ]) {
    const camera = fitAbove(room);
    const isCovered = corners.some(([x, y]) => {
      const [px, py] = worldToScreen({ camera, width, height }, x, y);
      return px > from && px < from + across && py > height - up;
    });
    if (isCovered) room = Math.max(room, up);
  }
  return fitAbove(room);
}

/** Makes the next fit start afresh from the scene as it is then. */
export const forgetFit = (scene: Scenario): void => void fits.delete(scene.map);

/** A map that is another's ground made larger or smaller is looked at as that was. */
export function keepFit(from: Scenario["map"], to: Scenario["map"]): void {
  const known = fits.get(from);
  if (known) fits.set(to, known);
}

function foundPlans({ planners, results }: State): Plan[] {
  return planners.flatMap((id) => {
    const { plan, lastGood } = results[id] ?? {};
    const found = plan?.outcome === "found" ? plan : lastGood;
    return found ? [found] : [];
  });
}

/** True if a path that is shown has a part beyond the view. */
export const pathLeaves = (state: State, view: View): boolean =>
  foundPlans({ ...state, planners: state.planners.filter((id) => !state.hidden.has(id)) }).some(({ path }) => {
    for (let i = 0; i + 2 < path.length; i += 3) {
      const [x, y] = worldToScreen(view, path[i]!, path[i + 1]!);
      if (x < 0 || y < 0 || x > view.width || y > view.height) return true;
    }
    return false;
  });
