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
export interface FailedExpansion {
  arcs: DrivenArc[];
  /** The car where it hits. */
  hit: Pose;
  /** Index of the obstacle; -1 for the border and parked cars. */
  obstacle: number;
  /** Metres driven before. */
  length: number;
}

export class FailedExpansionIndex {
  private readonly numbers: ReadonlyMap<number, number>;

  constructor(private readonly failed: ArcTrace["failedExpansions"]) {
    this.numbers = new Map([...failed.expansions].map((step, number) => [step, number]));
  }

  has = (step: number): boolean => this.numbers.has(step);

  at(step: number): FailedExpansion | null {
    const number = this.numbers.get(step),
      { failed } = this;
    if (number === undefined) return null;
    const arcs: DrivenArc[] = [];
    for (let at = nth(failed.first, number); at < (failed.first[number + 1] ?? failed.arcs.length / FIELDS); at++)
      arcs.push(arcOf(failed.arcs, at));
    const length = arcs.reduce((sum, one) => sum + Math.abs(one.length), 0);
    return { arcs, hit: poseAt(failed.hits, number), obstacle: nth(failed.obstacles, number), length };
  }
}

function arcOf(columns: Float64Array, at: number): DrivenArc {
  const field = (k: number): number => nth(columns, at * FIELDS + k);
  return { x: field(0), y: field(1), heading: field(2), curvature: field(3), length: field(4) };
}
