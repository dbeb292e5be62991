/** Soft safety space: hatched up to a contour of the distance to the nearest obstacle. */
import type { Layer, MapFrame } from "parkade";
import { contours } from "../contour";
import { vast } from "../lazy-large-maps";
import { inMetres, inPixels, pixels, polygonPath, type Frame, type Shown } from "../frame";
import { hatchPattern } from "../hatch";
import { fade } from "../tokens";
import { newPath } from "../surface";

const NECESSARY = 2;
/** Cells whose contour would take long to follow. */
const TOO_MANY = 200_000;

interface Zone {
  safety: Layer;
  clearance: Layer | undefined;
  map: MapFrame;
  area: Path2D;
}

export class SafetyLayer {
  private zone: Zone | null = null;

  draw(frame: Frame, { result }: Shown): void {
    const safety = result?.layers.safety;
    if (!safety) return;
    const {
      ctx,
      tokens: { colour },
    } = frame;
    if (safety.data.length > TOO_MANY && vast()?.drawKinds(frame, safety, [1, NECESSARY], fade(colour.t1, 0.28)))
      return;
    const area = this.areaOf(safety, result.layers.clearance, frame.state.scene.map);
    ctx.save();
    inMetres(frame);
    ctx.clip(polygonPath(frame.resolved.boundary));
    ctx.lineWidth = pixels(frame, 0.8);
    ctx.strokeStyle = fade(colour.t1, 0.22);
    ctx.stroke(area);
    ctx.clip(area);
    inPixels(frame);
    ctx.fillStyle = hatchPattern(frame, fade(colour.t1, 0.28), 5, 1);
    ctx.fillRect(0, 0, frame.view.width, frame.view.height);
    ctx.restore();
  }

  private areaOf(safety: Layer, clearance: Layer | undefined, map: MapFrame): Path2D {
    const known = this.zone;
    const same = known?.map === map && isSame(known.safety, safety) && isSame(known.clearance, clearance);
    const area = same ? known.area : clearance ? byDistance(safety, clearance, map) : byCells(safety, map);
    this.zone = { safety, clearance, map, area };
    return area;
  }
}

/** Every plan brings its own layers, though a moved start or goal leaves them as they were. */
const isSame = (a: Layer | undefined, b: Layer | undefined): boolean =>
  a === b ||
  (a !== undefined &&
    b !== undefined &&
    a.width === b.width &&
    a.data.length === b.data.length &&
    a.data.every((value, i) => value === b.data[i]));

/** The farthest hatched cell says at which distance the space ends. */
function byDistance(safety: Layer, clearance: Layer, map: MapFrame): Path2D {
  let inner = 0,
    outer = Infinity;
  for (let i = 0; i < safety.data.length; i++) {
    const metres = clearance.data[i]!;
    if (safety.data[i] === NECESSARY) inner = Math.max(inner, metres);
    else if (safety.data[i] !== 1) outer = Math.min(outer, metres);
  }
  if (outer <= inner) return byCells(safety, map);
  const edge = Number.isFinite(outer) ? (inner + outer) / 2 : inner;
  const near = (x: number, y: number): number => -clearance.data[y * safety.width + x]!;
  return toPath(contours(safety.width, safety.height, near, -edge), map);
}

function byCells(safety: Layer, map: MapFrame): Path2D {
  const taken = (x: number, y: number): number => {
    const kind = safety.data[y * safety.width + x];
    return kind === NECESSARY || kind === 1 ? 1 : 0;
  };
  return toPath(contours(safety.width, safety.height, taken, 0.5, 0), map);
}

function toPath(loops: readonly number[][], { origin, resolution }: MapFrame): Path2D {
  const path = newPath();
  for (const loop of loops) {
    for (let i = 0; i < loop.length; i += 2) {
      const x = origin[0] + (loop[i]! + 0.5) * resolution,
        y = origin[1] + (loop[i + 1]! + 0.5) * resolution;
      if (i === 0) path.moveTo(x, y);
      else path.lineTo(x, y);
    }
    path.closePath();
  }
  return path;
}
