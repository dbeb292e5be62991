/** Arrows along the risk force, longer where it changes faster. */
import type { Layer } from "parkade";
import { screenToWorld, type View } from "../camera";
import { inPixels, toScreen, type Frame, type Shown } from "../frame";
import { newPath } from "../surface";

const MOST = 1500;
const SPACING = 20;
const LENGTH = { short: 4, long: 15 };

interface Arrows {
  key: string;
  risk: Layer;
  body: Path2D;
}

export class RiskLayer {
  private cached: Arrows | null = null;
  private readonly peaks = new WeakMap<Layer, number>();

  draw(frame: Frame, { result }: Shown): void {
    const risk = result?.layers.risk;
    if (!risk) return;
    const {
      ctx,
      tokens: { colour },
    } = frame;
    const body = this.arrows(frame, risk, result.layers.occupancy ?? result.layers.safety);
    inPixels(frame);
    ctx.lineCap = "round";
    ctx.lineJoin = "round";
    ctx.strokeStyle = colour.floor;
    ctx.lineWidth = 3;
    ctx.stroke(body);
    ctx.strokeStyle = colour.arrow;
    ctx.lineWidth = 1.2;
    ctx.stroke(body);
    ctx.lineCap = "butt";
  }

  private arrows(frame: Frame, risk: Layer, blocked: Layer | undefined): Path2D {
    const {
      view,
      state: {
        scene: { map },
      },
    } = frame;
    const { camera } = view;
    const key = [camera.x, camera.y, camera.scale, view.width, view.height, map.origin, map.resolution].join();
    if (this.cached?.risk === risk && this.cached.key === key) return this.cached.body;
    const peak = this.peaks.get(risk) ?? peakOf(risk);
    this.peaks.set(risk, peak);
    const body = newPath(),
      { every } = risk,
      middle = Math.floor(every / 2);
    for (const [x, y] of sampled(view, map.resolution * every, risk, map.origin)) {
      const force = y * risk.width + x,
        east = risk.data[2 * force]!,
        north = risk.data[2 * force + 1]!,
        strength = Math.hypot(east, north);
      const column = x * every + middle,
        row = y * every + middle;
      if (strength < peak * 0.015 || blocked?.data[row * map.width + column] === 1) continue;
      const at = toScreen(frame, [
        map.origin[0] + (column + 0.5) * map.resolution,
        map.origin[1] + (row + 0.5) * map.resolution,
      ]);
      addArrow(
        body,
        at[0],
        at[1],
        east / strength,
        -north / strength,
        LENGTH.short + (LENGTH.long - LENGTH.short) * Math.sqrt(Math.min(1, strength / peak)),
      );
    }
    this.cached = { key, risk, body };
    return body;
  }
}

const SAMPLES = 4000;

/** The 95th percentile of the force, of a sample: single steep cells must not shorten all other arrows. */
function peakOf(risk: Layer): number {
  const forces = new Float32Array(2 * SAMPLES),
    cells = risk.width * risk.height;
  let count = 0;
  // An odd step does not fall in with the columns.
  const step = Math.floor(cells / SAMPLES) | 1;
  for (let i = 0; i < cells; i += step) {
    const force = Math.hypot(risk.data[2 * i]!, risk.data[2 * i + 1]!);
    if (force > 1e-9) forces[count++] = force;
  }
  return forces.subarray(0, count).sort()[Math.floor(count * 0.95)] ?? 1;
}

/** Places of forces on a lattice fixed to the map, so that arrows do not swim when the camera pans. */
function* sampled(
  view: View,
  resolution: number,
  layer: Layer,
  origin: readonly [number, number],
): Iterable<[number, number]> {
  const inView = (view.width * view.height) / (SPACING * SPACING);
  const spacing = SPACING * Math.max(1, Math.sqrt(inView / MOST));
  const step = Math.max(1, Math.ceil(spacing / (resolution * view.camera.scale)));
  const [left, top] = screenToWorld(view, 0, 0),
    [right, bottom] = screenToWorld(view, view.width, view.height);
  const first = (low: number): number =>
    Math.max(Math.floor(step / 2), Math.ceil(low / step) * step + Math.floor(step / 2) - step);
  const lastColumn = Math.min(layer.width - 1, Math.floor((right - origin[0]) / resolution));
  const lastRow = Math.min(layer.height - 1, Math.floor((top - origin[1]) / resolution));
  for (let row = first((bottom - origin[1]) / resolution); row <= lastRow; row += step) {
    for (let column = first((left - origin[0]) / resolution); column <= lastColumn; column += step) {
      if (row >= 0 && column >= 0) yield [column, row];
    }
  }
}

function addArrow(path: Path2D, x: number, y: number, dx: number, dy: number, length: number): void {
  const half = length / 2,
    head = Math.min(3.4, length * 0.45);
  const tipX = x + dx * half,
    tipY = y + dy * half;
  path.moveTo(x - dx * half, y - dy * half);
  path.lineTo(tipX, tipY);
  path.moveTo(tipX - head * (dx - dy * 0.75), tipY - head * (dy + dx * 0.75));
  path.lineTo(tipX, tipY);
  path.lineTo(tipX - head * (dx + dy * 0.75), tipY - head * (dy - dx * 0.75));
}
