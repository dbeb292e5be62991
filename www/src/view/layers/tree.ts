import type { Trace } from "parkade";
import { inMetres, inPixels, pixels, toScreen, type Frame, type Shown } from "../frame";
import { RAMP_STOPS } from "../ramp";
import { fade } from "../tokens";
import { expansionsShown } from "./heat";
import { drawPotential } from "./potential";
import { drawStages } from "./stages";
import { newPath } from "../surface";
import { nth } from "../../scene/nth";

const FIELDS = 5;
/** Connections drawn at once, evenly picked: thousands would be a carpet. */
const MOST_FAILED = 60;
const CROSS_PX = 3.5;

type Arcs = Extract<Trace, { kind: "arcs" }>;
interface Built {
  trace: Arcs;
  count: number;
  forward: Path2D[];
  reverse: Path2D[];
  failed: Path2D;
  hits: number[];
}

export class TreeLayer {
  private built: Built | null = null;

  draw(frame: Frame, { plan, result }: Shown): void {
    const { playback } = frame.state,
      potential = result?.layers.potential;
    if (potential) drawPotential(frame, potential);
    // A search that is still going on has no path yet.
    if (plan && "stages" in plan && plan.stages && !(playback.base === "search" && playback.fraction < 1))
      drawStages(frame, plan.rawPath, plan.stages);
    if (plan?.trace?.kind !== "arcs") return;
    const {
      ctx,
      tokens: { colour },
    } = frame;
    const { forward, reverse, failed, hits } = this.build(plan.trace, expansionsShown(frame.state, plan));
    ctx.save();
    inMetres(frame);
    ctx.lineWidth = pixels(frame, 1.1);
    ctx.globalAlpha = 0.6;
    strokeBands(frame, forward);
    ctx.lineCap = "round";
    ctx.lineWidth = pixels(frame, 1.5);
    ctx.setLineDash([0.01, pixels(frame, 3.2)]);
    strokeBands(frame, reverse);
    ctx.lineCap = "butt";
    ctx.globalAlpha = 1;
    ctx.setLineDash([pixels(frame, 5), pixels(frame, 3.5)]);
    ctx.lineWidth = pixels(frame, 1);
    ctx.strokeStyle = fade(colour.err, 0.55);
    ctx.stroke(failed);
    ctx.setLineDash([]);
    inPixels(frame);
    ctx.lineWidth = 1.5;
    ctx.strokeStyle = colour.err;
    ctx.beginPath();
    for (let i = 0; i < hits.length; i += 2) {
      const [x, y] = toScreen(frame, [nth(hits, i), nth(hits, i + 1)]);
      ctx.moveTo(x - CROSS_PX, y - CROSS_PX);
      ctx.lineTo(x + CROSS_PX, y + CROSS_PX);
      ctx.moveTo(x - CROSS_PX, y + CROSS_PX);
      ctx.lineTo(x + CROSS_PX, y - CROSS_PX);
    }
    ctx.stroke();
    ctx.restore();
  }

  /** One path per stop of the ramp and gear: thousands of arcs in twenty strokes. */
  private build(trace: Arcs, count: number): Built {
    const known = this.built;
    if (known?.trace === trace && known.count === count) return known;
    const { arcs } = trace,
      total = Math.max(1, arcs.length / FIELDS);
    const forward = RAMP_STOPS.map(() => newPath()),
      reverse = RAMP_STOPS.map(() => newPath());
    for (let i = 0; i < count; i++) {
      const arc = arcs.subarray(i * FIELDS, i * FIELDS + FIELDS);
      addArc(nth(nth(arc, 4) < 0 ? reverse : forward, Math.floor((i * RAMP_STOPS.length) / total)), arc);
    }
    this.built = { trace, count, forward, reverse, ...failedUpTo(trace, count) };
    return this.built;
  }
}

function strokeBands({ ctx }: Frame, bands: readonly Path2D[]): void {
  bands.forEach((band, i) => {
    ctx.strokeStyle = nth(RAMP_STOPS, i);
    ctx.stroke(band);
  });
}

/** The failed connections tried within the first `count` expansions, and where each hit. */
function failedUpTo({ failedExpansions: failed }: Arcs, count: number): Pick<Built, "failed" | "hits"> {
  const path = newPath(),
    hits: number[] = [];
  const tried = failed.expansions.filter((before) => before <= count).length,
    step = Math.max(1, tried / MOST_FAILED);
  for (let k = tried - 1; k >= 0; k -= step) {
    const i = Math.round(k),
      from = nth(failed.first, i),
      to = failed.first[i + 1] ?? failed.arcs.length / FIELDS;
    for (let at = from; at < to; at++) addArc(path, failed.arcs.subarray(at * FIELDS, at * FIELDS + FIELDS));
    hits.push(nth(failed.hits, 3 * i), nth(failed.hits, 3 * i + 1));
  }
  return { failed: path, hits };
}

/** x, y, heading at its beginning, curvature, signed length as driven. */
function addArc(path: Path2D, [x = 0, y = 0, heading = 0, curvature = 0, length = 0]: Float64Array): void {
  path.moveTo(x, y);
  if (Math.abs(curvature) < 1e-6) {
    path.lineTo(x + length * Math.cos(heading), y + length * Math.sin(heading));
    return;
  }
  const radius = 1 / curvature,
    turn = length * curvature;
  const cx = x - radius * Math.sin(heading),
    cy = y + radius * Math.cos(heading);
  const from = Math.atan2(y - cy, x - cx);
  path.arc(cx, cy, Math.abs(radius), from, from + turn, turn < 0);
}
