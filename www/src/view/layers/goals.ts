/** A set of goals: every place that would do, and the one that each answer leads to. */
import type { Pose } from "parkade";
import { slotsOfGoal } from "../../scene/goals";
import { slotOutline } from "../../scene/slots";
import { drawCar, goalStyle } from "../car";
import { inMetres, inPixels, pixels, polygonPath, toScreen, type Frame, type Shown } from "../frame";
import { hatchPattern } from "../hatch";
import { fade, plannerStyle } from "../tokens";

/** Dashes on anything are a goal. */
const DASH = [5, 3.5];
const GHOST = 0.4;

export function drawGoals(frame: Frame): void {
  const { goal } = frame.state.scene;
  if (Array.isArray(goal)) drawPoses(frame, goal);
  else if ("slots" in goal) drawSlots(frame);
  else if ("region" in goal) drawRegion(frame, goal.region);
}

function drawSlots(frame: Frame): void {
  const {
    ctx,
    tokens,
    shown,
    state: { scene },
  } = frame;
  for (const one of shown) fillTaken(frame, one);
  inMetres(frame);
  ctx.lineWidth = pixels(frame, 1.5);
  ctx.strokeStyle = tokens.colour.t1;
  dashed(frame, () => {
    for (const slot of slotsOfGoal(scene)) ctx.stroke(polygonPath(slotOutline(slot)));
  });
}

/** The slot that a planner's answer leads to, in its colour. */
function fillTaken(frame: Frame, { planner, plan, ghost }: Shown): void {
  const slot = frame.state.scene.slots?.[plan?.goal?.index ?? -1];
  if (!slot || !plan?.goal?.slot) return;
  const { ctx, tokens } = frame,
    { colour } = plannerStyle(tokens, planner);
  inMetres(frame);
  ctx.fillStyle = fade(colour, ghost ? 0.08 : 0.22);
  ctx.fill(polygonPath(slotOutline(slot)));
}

/** The poses that are not led to, as ghosts of the goal car. */
function drawPoses(frame: Frame, poses: readonly Pose[]): void {
  const {
    ctx,
    resolved: { vehicle, goal: taken },
  } = frame;
  ctx.save();
  ctx.globalAlpha = GHOST;
  for (const pose of poses)
    if (pose.x !== taken.x || pose.y !== taken.y || pose.heading !== taken.heading)
      drawCar(frame, pose, vehicle, 0, goalStyle(frame));
  ctx.restore();
}

function drawRegion(frame: Frame, region: readonly [number, number][]): void {
  const {
      ctx,
      tokens: { colour },
    } = frame,
    path = polygonPath(region.map((p) => toScreen(frame, p)));
  inPixels(frame);
  ctx.fillStyle = hatchPattern(frame, fade(colour.t1, 0.22), 9, 1);
  ctx.fill(path);
  ctx.strokeStyle = colour.t1;
  ctx.lineWidth = 1.5;
  ctx.setLineDash(DASH);
  ctx.stroke(path);
  ctx.setLineDash([]);
}

function dashed(frame: Frame, draw: () => void): void {
  frame.ctx.setLineDash(DASH.map((px) => pixels(frame, px)));
  draw();
  frame.ctx.setLineDash([]);
}
