import type { PlannerId, PoseTrace } from "parkade";
import type { DrivenArc, FailedExpansion } from "../../planning/failed-expansions";
import type { SearchReplay } from "../../planning/search-replay";
import { drawCar, startStyle } from "../car";
import { inMetres, inPixels, pixels, toScreen, type Frame } from "../frame";
import { newPath } from "../surface";
import { fade, plannerStyle } from "../tokens";
import { drawHatchedPose } from "./collisions";
import { nth } from "../../scene/nth";

/** Half the side of a pose's mark, CSS pixels. */
const MARK = 1.5;

/** The last step of a recorded search for a car, on what both sides have reached. */
export function drawPoseStep(
  frame: Frame,
  replay: SearchReplay,
  failed: FailedExpansion | null,
  planner: PlannerId,
): void {
  const { trace, step, move } = replay;
  if (trace.kind !== "poses" || step < 0) return;
  const {
      tokens: { colour },
    } = frame,
    of = (one: number): DrivenArc => arcOfMove(trace, one);
  drawReached(frame, replay, trace);
  const kept: DrivenArc[] = [],
    hit: DrivenArc[] = [];
  for (let one = nth(trace.first, step); one <= move; one++) {
    const fate = replay.fateOf(one);
    if (fate === "kept" || fate === "improved") kept.push(of(one));
    if (fate === "blocked") hit.push(of(one));
  }
  const side = replay.sideOf(step),
    node = nth(trace.nodes, step),
    led = replay.moveTo(side, node);
  // Arcs are hardly longer than the car: they lie on it.
  drawCar(frame, replay.poseOf(side, node)!, frame.resolved.vehicle, 0, startStyle(frame));
  frame.ctx.save();
  strokeArcs(frame, hit, colour.err, 1.5, [4, 3]);
  strokeArcs(frame, kept, colour.accent, 1.5);
  if (led >= 0) strokeArcs(frame, [of(led)], colour.t1, 2.5);
  drawFailure(frame, failed, planner);
  frame.ctx.restore();
}

/** A mark for each pose that is reached: filled where it has been expanded, by the colour of its side. */
function drawReached(frame: Frame, replay: SearchReplay, { roots, poses }: PoseTrace): void {
  const {
    ctx,
    tokens: { colour },
    view,
  } = frame;
  inPixels(frame);
  ctx.save();
  replay.sides.forEach(({ entry, closed }, side) => {
    const filled = newPath(),
      waiting = newPath();
    for (let node = 0; node < entry.length; node++) {
      const at = nth(entry, node);
      if (at === 0) continue;
      const [x, y] = toScreen(
        frame,
        at < 3 ? [nth(roots, side).x, nth(roots, side).y] : [nth(poses, 3 * (at - 3)), nth(poses, 3 * (at - 3) + 1)],
      );
      if (x < 0 || y < 0 || x > view.width || y > view.height) continue;
      (closed[node] ? filled : waiting).rect(x - MARK, y - MARK, 2 * MARK, 2 * MARK);
    }
    ctx.fillStyle = fade(side === 1 ? colour.warn : colour.t2, 0.75);
    ctx.fill(filled);
    ctx.strokeStyle = fade(side === 1 ? colour.warn : colour.accent, 0.6);
    ctx.lineWidth = 1;
    ctx.stroke(waiting);
  });
  ctx.restore();
}

function strokeArcs(frame: Frame, arcs: readonly DrivenArc[], style: string, width: number, dash: number[] = []): void {
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

function drawFailure(frame: Frame, failed: FailedExpansion | null, planner: PlannerId): void {
  if (!failed) return;
  frame.ctx.lineCap = "round";
  strokeArcs(frame, failed.arcs, plannerStyle(frame.tokens, planner).colour, 2.5, [0.1, 5]);
  frame.ctx.lineCap = "butt";
  drawHatchedPose(frame, failed.hit);
}

/** A move's arc back from the pose that it leads to. */
function arcOfMove({ poses, arcs }: PoseTrace, move: number): DrivenArc {
  return {
    x: nth(poses, 3 * move),
    y: nth(poses, 3 * move + 1),
    heading: nth(poses, 3 * move + 2),
    curvature: nth(arcs, 2 * move),
    length: -nth(arcs, 2 * move + 1),
  };
}

function addArc(path: Path2D, { x, y, heading, curvature, length }: DrivenArc): void {
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
