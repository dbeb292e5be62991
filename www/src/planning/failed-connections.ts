import type { ArcTrace, Pose } from "parkade";
import { nth } from "../scene/nth";

const FIELDS = 5;

/** An arc as it is driven: a negative length is reverse. */
export interface DrivenArc {
  x: number;
  y: number;
  heading: number;
  curvature: number;
  length: number;
}

/** A connection that hits something. */
export interface FailedConnection {
  arcs: DrivenArc[];
  /** The car where it hits. */
  hit: Pose;
  /** Index of the obstacle; -1 for the border and parked cars. */
  obstacle: number;
  /** Metres driven before. */
  length: number;
}

export class FailedConnections {
  private readonly numbers: ReadonlyMap<number, number>;

  constructor(private readonly shots: ArcTrace["shots"]) {
    this.numbers = new Map([...shots.expansions].map((step, number) => [step, number]));
  }

  has = (step: number): boolean => this.numbers.has(step);

  at(step: number): FailedConnection | null {
    const number = this.numbers.get(step),
      { shots } = this;
    if (number === undefined) return null;
    const arcs: DrivenArc[] = [];
    for (let at = nth(shots.first, number); at < (shots.first[number + 1] ?? shots.arcs.length / FIELDS); at++)
      arcs.push(arcOf(shots.arcs, at));
    const [x, y, heading] = shots.hits.subarray(3 * number, 3 * number + 3) as unknown as [number, number, number];
    const length = arcs.reduce((sum, one) => sum + Math.abs(one.length), 0);
    return { arcs, hit: { x, y, heading }, obstacle: nth(shots.obstacles, number), length };
  }
}

function arcOf(columns: Float64Array, at: number): DrivenArc {
  const [x, y, heading, curvature, length] = columns.subarray(at * FIELDS, at * FIELDS + FIELDS) as unknown as number[];
  return { x: x!, y: y!, heading: heading!, curvature: curvature!, length: length! };
}
