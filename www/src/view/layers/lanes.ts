/** Roads: each lane's floor, its edges and its middle; areas with a speed limit. */
import type { Lane } from "parkade";
import type { Road } from "../../scene/scenario";
import type { Point } from "../../scene/geometry";
import { beside, placesOf } from "../../scene/road";
import { halfOf, laneWidthOf, lanesOf } from "../../scene/road-width";
import { inMetres, linePath, pixels, polygonPath, type Frame } from "../frame";
import { fade } from "../tokens";
import { newPath, perSurface } from "../surface";

/** A chord of this length strays from the tightest roads' arcs by millimetres. */
const STEP = 1;

interface Drawn {
  middle: Path2D;
  edges: Path2D;
  floor: Path2D;
}

const drawn = perSurface(() => new WeakMap<Lane, Drawn>());

export function drawLanes(frame: Frame): void {
  const {
    ctx,
    tokens: { colour },
    state: { scene },
  } = frame;
  inMetres(frame);
  for (const { points } of scene.speedLimits ?? []) {
    ctx.fillStyle = fade(colour.accent, 0.06);
    ctx.fill(polygonPath(points));
  }
  drawRoads(frame);
  for (const lane of scene.lanes ?? []) {
    const { middle, edges, floor } = pathsOf(lane);
    ctx.fillStyle = fade(colour.t3, 0.1);
    ctx.fill(floor);
    ctx.strokeStyle = colour.slot;
    ctx.lineWidth = pixels(frame, 1);
    ctx.stroke(edges);
    ctx.strokeStyle = fade(colour.slot, 0.7);
    ctx.setLineDash([pixels(frame, 10), pixels(frame, 8)]);
    ctx.stroke(middle);
    ctx.setLineDash([]);
  }
}

interface Surface {
  floor: Path2D;
  sides: Path2D;
  between: Path2D;
  middle: Path2D;
}

const surfaces = perSurface(() => new WeakMap<Road, Surface>());

/**
 * Kerbs first, so that surfaces open them where roads meet; then the lines between lanes, the one between the
 * directions whole.
 */
function drawRoads(frame: Frame): void {
  const {
    ctx,
    tokens: { colour },
    state: { scene },
  } = frame;
  const roads = (scene.obstacles ?? []).filter((one): one is Road => one.type === "road" && one.points.length > 1);
  ctx.lineJoin = "round";
  for (const road of roads) {
    ctx.strokeStyle = (road.kerbs ?? true) ? colour["obs-edge"] : colour.slot;
    ctx.lineWidth = pixels(frame, (road.kerbs ?? true) ? 3.5 : 2);
    ctx.stroke(surfaceOf(road).sides);
  }
  for (const road of roads) {
    ctx.fillStyle = colour.floor;
    ctx.fill(surfaceOf(road).floor);
  }
  for (const road of roads) {
    const { floor, between, middle } = surfaceOf(road);
    ctx.fillStyle = fade(colour.t3, 0.1);
    ctx.fill(floor);
    ctx.strokeStyle = colour.slot;
    ctx.lineWidth = pixels(frame, 1.25);
    ctx.stroke(middle);
    ctx.setLineDash([3, 3]);
    ctx.stroke(between);
    ctx.setLineDash([]);
  }
}

function surfaceOf(road: Road): Surface {
  const known = surfaces().get(road);
  if (known) return known;
  const places = placesOf(road),
    half = halfOf(road),
    width = laneWidthOf(road),
    [along, against] = lanesOf(road);
  const right = beside(places, -half),
    left = beside(places, half),
    between = newPath();
  for (let k = 1; k < along + against; k++) if (k !== along) linePath(beside(places, k * width - half), between);
  const middle = newPath();
  if (along > 0 && against > 0) linePath(beside(places, along * width - half), middle);
  const made = {
    sides: linePath(right, linePath(left)),
    floor: polygonPath([...left, ...right.reverse()]),
    between,
    middle,
  };
  surfaces().set(road, made);
  return made;
}

function pathsOf(lane: Lane): Drawn {
  const known = drawn().get(lane);
  if (known) return known;
  const middle: Point[] = [],
    left: Point[] = [],
    right: Point[] = [];
  let { x, y, heading } = lane.start;
  const add = (): void => {
    const side = lane.width / 2,
      dx = -Math.sin(heading) * side,
      dy = Math.cos(heading) * side;
    middle.push([x, y]);
    left.push([x + dx, y + dy]);
    right.push([x - dx, y - dy]);
  };
  add();
  for (const { length, curvature = 0 } of lane.pieces) {
    const parts = curvature === 0 ? 1 : Math.max(1, Math.ceil(length / STEP)),
      step = length / parts;
    for (let i = 0; i < parts; i++) {
      const turn = curvature * step,
        chord = turn === 0 ? step : (2 * Math.sin(turn / 2)) / curvature;
      x += chord * Math.cos(heading + turn / 2);
      y += chord * Math.sin(heading + turn / 2);
      heading += turn;
      add();
    }
  }
  const made = {
    middle: linePath(middle),
    edges: linePath(right, linePath(left)),
    floor: polygonPath([...left, ...right.reverse()]),
  };
  drawn().set(lane, made);
  return made;
}
