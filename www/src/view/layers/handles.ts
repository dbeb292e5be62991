/** The grip and the label of a pose. */
import { isPose } from "../../scene/selection";
import type { Pose } from "parkade";
import { boxOf, type Box, type Point } from "../../scene/geometry";
import { footprint } from "../../scene/vehicle";
import { inPixels, leading, toScreen, type Frame } from "../frame";
import { gripOf, noseOf } from "../pose-handle";
import { drawPill, PILL_HEIGHT, pillWidth, placePill, poseText } from "../text";
import { keepPoseLabel } from "../pose-label";

const GRIP_PX = 6,
  GRIP_TOUCH_PX = 11;

const pointer = globalThis.matchMedia?.("(pointer: coarse)");
const coarse = (): boolean => pointer?.matches ?? false;

/** The pose whose grip is drawn: the selected or grabbed one; the goal's while nothing else is chosen. */
function posesWithGrip({ state, draft }: Frame): ("start" | "goal")[] {
  if (state.tool !== "select" && !draft?.grabbed) return [];
  const chosen =
    draft?.grabbed?.which ?? (isPose(state.selection) ? state.selection.kind : state.selection ? null : "goal");
  const hot = isPose(draft?.hot ?? null) ? draft?.hot?.kind : null;
  return (["start", "goal"] as const).filter((which) => which === chosen || which === hot);
}

export function drawHandles(frame: Frame): void {
  for (const which of posesWithGrip(frame)) drawGrip(frame, frame.resolved[which]);
  const {
    draft,
    state: { selection },
  } = frame;
  const labelled = draft?.grabbed?.which ?? (isPose(selection) ? selection.kind : null);
  if (labelled) drawPoseLabel(frame, labelled, draft?.grabbed !== undefined);
  else keepPoseLabel(frame.ctx.canvas, null);
}

/** The round grip ahead of the nose, on its stalk. */
function drawGrip(frame: Frame, pose: Pose): void {
  const {
    resolved: { vehicle },
  } = frame;
  drawStalk(frame, noseOf(pose, vehicle), gripOf(pose, vehicle));
}

export function drawStalk(frame: Frame, from: Point, to: Point): void {
  const {
    ctx,
    tokens: { colour },
  } = frame;
  const a = toScreen(frame, from),
    b = toScreen(frame, to);
  inPixels(frame);
  ctx.strokeStyle = colour.accent;
  ctx.lineWidth = 1.25;
  ctx.beginPath();
  ctx.moveTo(...a);
  ctx.lineTo(...b);
  ctx.stroke();
  drawKnob(frame, b, coarse() ? GRIP_TOUCH_PX : GRIP_PX);
}

export function drawKnob({ ctx, tokens: { colour } }: Frame, [x, y]: Point, radius: number): void {
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
  ctx.fillStyle = colour.floor;
  ctx.fill();
  ctx.lineWidth = 1.75;
  ctx.strokeStyle = colour.accent;
  ctx.stroke();
}

function drawPoseLabel(frame: Frame, which: "start" | "goal", editing: boolean): void {
  const { resolved } = frame;
  const pose = resolved[which];
  const boxes = (["start", "goal"] as const).map((one) => screenBox(frame, footprint(resolved[one], resolved.vehicle)));
  const grip = screenBox(frame, [gripOf(pose, resolved.vehicle)], 14);
  const own = boxes[which === "start" ? 0 : 1]!;
  const text = poseText(pose);
  const keep: Box = {
    minX: Math.min(own.minX, grip.minX),
    minY: Math.min(own.minY, grip.minY),
    maxX: Math.max(own.maxX, grip.maxX),
    maxY: Math.max(own.maxY, grip.maxY),
  };
  const parked = resolved.parked.map((car) => screenBox(frame, footprint(car.pose, car.vehicle)));
  const place = placePill(frame, text, keep, grip, [...boxes, ...parked, ...pathBoxes(frame)]);
  drawPill(frame, text, ...place, editing ? "editing" : "plain");
  keepPoseLabel(frame.ctx.canvas, which, {
    minX: place[0],
    minY: place[1],
    maxX: place[0] + pillWidth(frame, text),
    maxY: place[1] + PILL_HEIGHT,
  });
}

/** Small boxes along the shown path, which labels keep off. */
function pathBoxes(frame: Frame): Box[] {
  const path = leading(frame)?.plan?.path ?? new Float64Array();
  const boxes: Box[] = [];
  for (let i = 0; i + 2 < path.length; i += 15) boxes.push(screenBox(frame, [[path[i]!, path[i + 1]!]], 6));
  return boxes;
}

function screenBox(frame: Frame, points: readonly Point[], margin = 0): Box {
  const box = boxOf(points.map((p) => toScreen(frame, p)));
  return { minX: box.minX - margin, minY: box.minY - margin, maxX: box.maxX + margin, maxY: box.maxY + margin };
}
