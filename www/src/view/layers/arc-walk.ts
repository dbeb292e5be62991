/** A step of a search for a car: the pose at hand, its arc and children, the connection tried and where it hits. */
import type { ArcWalk, WalkArc } from "../../planning/arc-walk";
import { drawCar, startStyle } from "../car";
import { inMetres, pixels, type Frame } from "../frame";
import { newPath } from "../surface";
import { plannerStyle } from "../tokens";
import type { PlannerId } from "parkade";
import { drawHatchedPose } from "./collisions";

export function drawArcWalk(frame: Frame, walk: ArcWalk, step: number, planner: PlannerId): void {
  const {
      ctx,
      tokens: { colour },
    } = frame,
    { pose, arc, failed } = walk.at(step);
  const stroke = (arcs: readonly WalkArc[], style: string, width: number, dash: number[] = []): void => {
    const path = newPath();
    for (const one of arcs) addArc(path, one);
    inMetres(frame);
    for (const [ink, wide] of [
      [colour.floor, width + 2],
      [style, width],
    ] as const) {
      ctx.strokeStyle = ink;
      ctx.lineWidth = pixels(frame, wide);
      ctx.setLineDash(ink === style ? dash.map((one) => pixels(frame, one)) : []);
      ctx.stroke(path);
    }
    ctx.setLineDash([]);
  };
  const children = walk.childrenOf(step).map((child) => walk.at(child).arc!);
  ctx.save();
  if (children.length > 0) stroke(children, colour.accent, 1.5);
  if (arc) stroke([arc], colour.t1, 2.5);
  if (failed) {
    ctx.lineCap = "round";
    stroke(failed.arcs, plannerStyle(frame.tokens, planner).colour, 2.5, [0.1, 5]);
    ctx.lineCap = "butt";
    drawHatchedPose(frame, failed.hit);
  }
  ctx.restore();
  drawCar(frame, pose, frame.resolved.vehicle, 0, startStyle(frame));
}

function addArc(path: Path2D, { x, y, heading, curvature, length }: WalkArc): void {
  const parts = Math.max(1, Math.ceil(Math.abs(curvature * length) / 0.05));
  path.moveTo(x, y);
  for (let i = 1; i <= parts; i++) {
    const along = (length * i) / parts,
      turned = heading + curvature * along;
    if (Math.abs(curvature) < 1e-9) path.lineTo(x + along * Math.cos(heading), y + along * Math.sin(heading));
    else
      path.lineTo(
        x + (Math.sin(turned) - Math.sin(heading)) / curvature,
        y - (Math.cos(turned) - Math.cos(heading)) / curvature,
      );
  }
}
