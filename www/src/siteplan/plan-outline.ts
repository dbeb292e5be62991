/**
 * A site plan as the page draws it: numbers in rows, which cross from a worker without a copy. A plan of 60,000 lines
 * as objects would hold the page up for a fifth of a second.
 */
import type { SitePlan, SitePlanLayer } from "parkade/siteplan";
import { boxOf, type Box } from "../scene/geometry";
import { suggestedUnit } from "./site-plan-scene";

export interface LayerOutline {
  name: string;
  /** Of all lines, one after the other: x, y, … in the file's units, y up. */
  points: Float64Array<ArrayBuffer>;
  /** Of each line: the index behind its last point. */
  ends: Uint32Array<ArrayBuffer>;
  /** Of each line: 1 where it is closed. */
  closed: Uint8Array<ArrayBuffer>;
  box: Box;
}

export interface PlanOutline extends Pick<SitePlan, "kind" | "metresPerUnit" | "notes"> {
  layers: LayerOutline[];
  box: Box;
  /** Metres per unit that give the plan the size of a parking lot. */
  suggestedUnit: number;
}

export function outlineOf(plan: SitePlan): PlanOutline {
  const { kind, metresPerUnit, notes } = plan,
    layers = plan.layers.map(layerOutline);
  const box = joined(layers.map((layer) => layer.box));
  return { kind, metresPerUnit, notes, layers, box, suggestedUnit: suggestedUnit(plan) };
}

/** What need not be copied. */
export const buffersOf = ({ layers }: PlanOutline): ArrayBuffer[] =>
  layers.flatMap(({ points, ends, closed }) => [points.buffer, ends.buffer, closed.buffer]);

function layerOutline({ name, lines }: SitePlanLayer): LayerOutline {
  const count = lines.reduce((sum, { points }) => sum + points.length, 0),
    points = new Float64Array(2 * count),
    ends = new Uint32Array(lines.length),
    closed = new Uint8Array(lines.length);
  let at = 0;
  lines.forEach((line, i) => {
    for (const [x, y] of line.points) {
      points[2 * at] = x;
      points[2 * at + 1] = y;
      at++;
    }
    ends[i] = at;
    closed[i] = Number(line.closed);
  });
  return { name, points, ends, closed, box: joined(lines.map((line) => boxOf(line.points))) };
}

/** The box around some boxes. */
export const joined = (boxes: readonly Box[]): Box =>
  boxOf(
    boxes.flatMap(({ minX, minY, maxX, maxY }) => [
      [minX, minY],
      [maxX, maxY],
    ]),
  );
