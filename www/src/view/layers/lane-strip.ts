/** A long road laid straight over the map: its length fits the panel, its width is stretched, and says by how much. */
import type { Plan } from "parkade";
import messages from "../../i18n/messages/lane-strip.json";
import { translator } from "../../i18n/translator";
import { mapOutline, resolve } from "../../scene/model";
import { fromPose, intoPose, type Point } from "../../scene/geometry";
import { cornersOf } from "../../scene/shapes";
import type { Scene, State } from "../../store";
import { drivenAt } from "../playback-time";
import { distancesOf, poseAtDistance, poseAt } from "../drive";
import { STRIP } from "../camera";
import { inPixels, type Frame, type Shown } from "../frame";
import { drawPill, pillWidth } from "../text";
import { plannerStyle } from "../tokens";

const say = translator("laneStrip", messages);

const HEIGHT = STRIP.height,
  MARGIN = 8,
  STATIONS = 240;
/** How far to either side a road's edge is looked for: so many metres at least, and so many widths of the vehicle. */
const REACH = 15,
  WIDTHS = 3;
/** Of a path this many poses are drawn at most. */
const MOST_POSES = 400;

interface Station {
  x: number;
  y: number;
  heading: number;
  along: number;
  left: number;
  right: number;
}

/** Metres along the road, and to the left of its middle. */
interface Strip {
  stations: Station[];
  length: number;
  half: number;
}

const strips = new WeakMap<Plan, { scene: Scene; strip: Strip | null }>();
const lines = new WeakMap<Plan, { strip: Strip; points: Point[] }>();

/**
 * The same road under every planner: along the first path that a car can drive; null where that has no edges at both
 * sides.
 */
export function stripOf({ scene, planners, results }: State): Strip | null {
  const plans = planners.map((planner) => results[planner]?.plan).filter((plan) => plan?.outcome === "found");
  const plan = plans.find((one) => one!.check.drivable) ?? plans[0];
  if (!plan) return null;
  const known = strips.get(plan);
  if (known?.scene === scene) return known.strip;
  const length = distancesOf(plan).at(-1) ?? 0,
    outline = mapOutline(scene),
    reach = Math.max(REACH, WIDTHS * resolve(scene).vehicle.width);
  const stations = Array.from({ length: STATIONS + 1 }, (_, i): Station => {
    const along = (length * i) / STATIONS,
      pose = poseAtDistance(plan, along)!;
    return {
      x: pose.x,
      y: pose.y,
      heading: pose.heading,
      along,
      ...edges(
        outline.map((p) => intoPose(pose, p)),
        reach,
      ),
    };
  });
  const isRoad = stations.filter(({ left, right }) => left < reach && right > -reach).length > STATIONS / 2;
  const strip = isRoad
    ? { stations, length, half: Math.max(...stations.map(({ left, right }) => (left - right) / 2)) }
    : null;
  strips.set(plan, { scene, strip });
  return strip;
}

/** Crossings of an outline with the line to the sides of a pose, so many metres away at most. */
function edges(outline: readonly Point[], reach: number): { left: number; right: number } {
  let left = reach,
    right = -reach;
  outline.forEach(([bx, by], i) => {
    const [ax, ay] = outline.at(i - 1)!;
    if (ax > 0 === bx > 0) return;
    const side = ay + ((by - ay) * -ax) / (bx - ax);
    if (side >= 0) left = Math.min(left, side);
    else right = Math.max(right, side);
  });
  return { left, right };
}

/** A place as metres along the road and to the left of its middle. */
export function alongRoad({ stations }: Pick<Strip, "stations">, p: Point): Point {
  const near = stations.reduce((best, one) =>
    Math.hypot(one.x - p[0], one.y - p[1]) < Math.hypot(best.x - p[0], best.y - p[1]) ? one : best,
  );
  const [ahead, side] = intoPose(near, p);
  return [near.along + ahead, side - (near.left + near.right) / 2];
}

function lineOf(strip: Strip, plan: Plan): Point[] {
  const known = lines.get(plan);
  if (known?.strip === strip) return known.points;
  const count = plan.path.length / 3,
    step = Math.max(1, Math.ceil(count / MOST_POSES));
  const points = Array.from({ length: Math.ceil(count / step) }, (_, i): Point => {
    const { x, y } = poseAt(plan, i * step);
    return alongRoad(strip, [x, y]);
  });
  lines.set(plan, { strip, points });
  return points;
}

/** Over maps too long for their width to be seen. */
export function drawLaneStrip(frame: Frame): void {
  const {
      view,
      state,
      ctx,
      tokens: { colour },
    } = frame,
    strip = stripOf(state);
  if (!strip || view.width < 240 || strip.half === 0) return;
  const wide = view.width - 2 * MARGIN,
    across = (wide - 8) / strip.length,
    up = (HEIGHT - 12) / (2 * strip.half),
    top = STRIP.top;
  const at = ([s, d]: Point): Point => [MARGIN + 4 + s * across, top + HEIGHT / 2 - d * up];
  const trace = (points: readonly Point[]): void => {
    ctx.beginPath();
    points.forEach((p, i) => ctx[i === 0 ? "moveTo" : "lineTo"](...at(p)));
  };
  inPixels(frame);
  ctx.save();
  ctx.beginPath();
  ctx.roundRect(MARGIN + 0.5, top + 0.5, wide - 1, HEIGHT - 1, 5);
  ctx.fillStyle = colour.out;
  ctx.fill();
  ctx.lineWidth = 1;
  ctx.strokeStyle = colour.hair2;
  ctx.stroke();
  ctx.clip();
  const half = ({ left, right }: Station): number => (left - right) / 2;
  trace([
    ...strip.stations.map((one): Point => [one.along, half(one)]),
    ...[...strip.stations].reverse().map((one): Point => [one.along, -half(one)]),
  ]);
  ctx.fillStyle = colour.floor;
  ctx.fill();
  ctx.fillStyle = colour.obs;
  ctx.strokeStyle = colour["obs-edge"];
  for (const obstacle of state.scene.obstacles ?? []) {
    if (obstacle.type === "cells" || obstacle.type === "road" || obstacle.type === "wall") continue;
    trace(cornersOf(obstacle).map((p) => alongRoad(strip, p)));
    ctx.closePath();
    ctx.fill();
    ctx.stroke();
  }
  for (const shown of frame.shown) drawOnStrip(frame, strip, shown, at, trace);
  ctx.restore();
  const text = say(state.lang, "scale", { n: Math.round(up / across) });
  drawPill(frame, text, view.width - MARGIN - pillWidth(frame, text), top + HEIGHT + 4);
}

function drawOnStrip(
  { ctx, state, tokens, resolved }: Frame,
  strip: Strip,
  { planner, plan, result }: Shown,
  at: (p: Point) => Point,
  trace: (points: readonly Point[]) => void,
): void {
  if (!plan) return;
  const { colour, dash } = plannerStyle(tokens, planner);
  trace(lineOf(strip, plan));
  ctx.lineWidth = 2;
  ctx.strokeStyle = colour;
  ctx.setLineDash([...dash]);
  ctx.stroke();
  ctx.setLineDash([]);
  const driven = drivenAt(state, plan, result, resolved.vehicle.wheelbase);
  if (!driven) return;
  const { vehicle } = resolved,
    [x, y] = at(alongRoad(strip, fromPose(driven.pose, (vehicle.rearToFront - vehicle.rearToBack) / 2, 0)));
  ctx.beginPath();
  ctx.arc(x, y, 4.5, 0, 2 * Math.PI);
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.lineWidth = 1.5;
  ctx.strokeStyle = tokens.colour.floor;
  ctx.stroke();
}
