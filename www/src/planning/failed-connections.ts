import type { ArcTrace, Pose } from "parkade";
import { nth, poseAt } from "../scene/nth";

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
    const length = arcs.reduce((sum, one) => sum + Math.abs(one.length), 0);
    return { arcs, hit: poseAt(shots.hits, number), obstacle: nth(shots.obstacles, number), length };
  }
}

function arcOf(columns: Float64Array, at: number): DrivenArc {
  const field = (k: number): number => nth(columns, at * FIELDS + k);
  return { x: field(0), y: field(1), heading: field(2), curvature: field(3), length: field(4) };
}
