/** The arcs of the hybrid search, in order of expansion. */
import type { Plan } from "parkade";
import { inMetres, pixels, type Frame, type Shown } from "../frame";
import { RAMP_STOPS } from "../ramp";
import { expansionsShown } from "./heat";

const FIELDS = 5;

interface Built { trace: Plan["trace"]; count: number; bands: Path2D[] }

export class TreeLayer {
  private built: Built | null = null;

  draw(frame: Frame, { plan }: Shown): void {
    if (plan?.trace?.kind !== "arcs") return;
    const { ctx } = frame;
    const bands = this.bands(plan.trace, expansionsShown(frame.state, plan));
    ctx.save();
    inMetres(frame);
    ctx.lineWidth = pixels(frame, 1.1);
    ctx.globalAlpha = 0.6;
    bands.forEach((band, i) => {
      ctx.strokeStyle = RAMP_STOPS[i]!;
      ctx.stroke(band);
    });
    ctx.restore();
  }

  /** One path per stop of the ramp: thousands of arcs in ten strokes. */
  private bands(trace: { kind: "arcs"; arcs: Float64Array }, count: number): Path2D[] {
    const known = this.built;
    if (known?.trace === trace && known.count === count) return known.bands;
    const { arcs } = trace, total = Math.max(1, arcs.length / FIELDS);
    const bands = RAMP_STOPS.map(() => new Path2D());
    for (let i = 0; i < count; i++) addArc(bands[Math.floor((i * bands.length) / total)]!, arcs.subarray(i * FIELDS, i * FIELDS + FIELDS));
    this.built = { trace: trace as Plan["trace"], count, bands };
    return bands;
  }
}

/** x, y, heading at its beginning, curvature, signed length as driven. */
function addArc(path: Path2D, arc: Float64Array): void {
  const [x, y, heading, curvature, length] = arc as unknown as [number, number, number, number, number];
  path.moveTo(x, y);
  if (Math.abs(curvature) < 1e-6) {
    path.lineTo(x + length * Math.cos(heading), y + length * Math.sin(heading));
    return;
  }
  const radius = 1 / curvature, turn = length * curvature;
  const cx = x - radius * Math.sin(heading), cy = y + radius * Math.cos(heading);
  const from = Math.atan2(y - cy, x - cx);
  path.arc(cx, cy, Math.abs(radius), from, from + turn, turn < 0);
}
