/** A step of a search for a car: the pose at hand, its arc and children, the connection tried and where it hits. */
import type { ArcWalk, FailedConnection, WalkArc } from "../../planning/arc-walk";
import type { SearchReplay } from "../../planning/search-replay";
import { drawCar, startStyle } from "../car";
import { inMetres, pixels, type Frame } from "../frame";
import { newPath } from "../surface";
import { plannerStyle } from "../tokens";
import type { PlannerId, PoseTrace } from "parkade";
import { drawHatchedPose } from "./collisions";

export function drawArcWalk(frame: Frame, walk: ArcWalk, step: number, planner: PlannerId): void {
  const { colour } = frame.tokens,
    { pose, arc, failed } = walk.at(step);
  const children = walk.childrenOf(step).map((child) => walk.at(child).arc!);
  frame.ctx.save();
  strokeArcs(frame, children, colour.accent, 1.5);
  if (arc) strokeArcs(frame, [arc], colour.t1, 2.5);
  drawFailure(frame, failed, planner);
  frame.ctx.restore();
  drawCar(frame, pose, frame.resolved.vehicle, 0, startStyle(frame));
}

function strokeArcs(frame: Frame, arcs: readonly WalkArc[], style: string, width: number, dash: number[] = []): void {
  if (arcs.length === 0) return;
  const { ctx, tokens } = frame,
    path = newPath();
  for (const one of arcs) addArc(path, one);
  inMetres(frame);
  for (const [ink, wide] of [
    [tokens.colour.floor, width + 2],
    [style, width],
  ] as const) {
    ctx.strokeStyle = ink;
    ctx.lineWidth = pixels(frame, wide);
    ctx.setLineDash(ink === style ? dash.map((one) => pixels(frame, one)) : []);
    ctx.stroke(path);
  }
  ctx.setLineDash([]);
}

function drawFailure(frame: Frame, failed: FailedConnection | null, planner: PlannerId): void {
  if (!failed) return;
  frame.ctx.lineCap = "round";
  strokeArcs(frame, failed.arcs, plannerStyle(frame.tokens, planner).colour, 2.5, [0.1, 5]);
  frame.ctx.lineCap = "butt";
  drawHatchedPose(frame, failed.hit);
}

/** The last step of a recorded search for a car. */
export function drawPoseStep(frame: Frame, replay: SearchReplay, walk: ArcWalk, planner: PlannerId): void {
  const { trace, step, move } = replay;
  if (trace.kind !== "poses" || step < 0) return;
  const {
      tokens: { colour },
    } = frame,
    of = (one: number): WalkArc => arcOfMove(trace, one);
  const kept: WalkArc[] = [],
    hit: WalkArc[] = [];
  for (let one = trace.first[step]!; one <= move; one++) {
    const fate = replay.fateOf(one);
    if (fate === "kept" || fate === "improved") kept.push(of(one));
    if (fate === "blocked") hit.push(of(one));
  }
  const node = trace.nodes[step]!,
    led = replay.moveTo(node),
    failed = walk.failedAt(step);
  // Arcs are hardly longer than the car: they lie on it.
  drawCar(frame, replay.poseOf(node)!, frame.resolved.vehicle, 0, startStyle(frame));
  frame.ctx.save();
  strokeArcs(frame, hit, colour.err, 1.5, [4, 3]);
  strokeArcs(frame, kept, colour.accent, 1.5);
  if (led >= 0) strokeArcs(frame, [of(led)], colour.t1, 2.5);
  drawFailure(frame, failed, planner);
  frame.ctx.restore();
}

/** A move's arc back from the pose that it leads to. */
function arcOfMove({ poses, arcs }: PoseTrace, move: number): WalkArc {
  return {
    x: poses[3 * move]!,
    y: poses[3 * move + 1]!,
    heading: poses[3 * move + 2]!,
    curvature: arcs[2 * move]!,
    length: -arcs[2 * move + 1]!,
  };
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
