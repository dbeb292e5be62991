/** The tree of a search for a car, step by step: a pose is expanded, and where the cheapest connection from it fails. */
import type { ArcTrace, Pose } from "parkade";

const FIELDS = 5;

/** An arc as it is driven: a negative length is reverse. */
export interface WalkArc {
  x: number;
  y: number;
  heading: number;
  curvature: number;
  length: number;
}

/** A connection that hits something. */
export interface FailedConnection {
  arcs: WalkArc[];
  /** The car where it hits. */
  hit: Pose;
  /** Index of the obstacle; -1 for the border and parked cars. */
  obstacle: number;
  /** Metres driven before. */
  length: number;
}

export interface WalkStep {
  /** The expanded pose. */
  pose: Pose;
  /** The arc that led there; null at the root. */
  arc: WalkArc | null;
  failed: FailedConnection | null;
}

export class ArcWalk {
  /** Expansions: the root and one per arc. */
  readonly steps: number;
  /** Per expansion the number of its failed connection, or -1. */
  private readonly failures: Int32Array;
  private readonly children = new Map<string, number[]>();

  /** `fromGoal`: the tree grows against the direction of driving. */
  constructor(
    readonly trace: ArcTrace,
    readonly root: Pose,
    readonly fromGoal: boolean,
  ) {
    const { arcs, shots } = trace;
    this.steps = arcs.length / FIELDS + 1;
    this.failures = new Int32Array(this.steps).fill(-1);
    shots.expansions.forEach((step, i) => {
      if (step < this.steps) this.failures[step] = i;
    });
    for (let step = 1; step < this.steps; step++) {
      const key = keyOf(this.ends(this.arcAt(step))[0]);
      this.children.set(key, [...(this.children.get(key) ?? []), step]);
    }
  }

  private arcAt(step: number): WalkArc {
    return arcOf(this.trace.arcs, step - 1);
  }

  /** Where an arc of the tree begins and ends, as the tree grows. */
  private ends(arc: WalkArc): [Pose, Pose] {
    const begin = { x: arc.x, y: arc.y, heading: arc.heading },
      end = endOf(arc);
    return this.fromGoal ? [end, begin] : [begin, end];
  }

  at(step: number): WalkStep {
    const arc = step > 0 ? this.arcAt(step) : null;
    return { pose: arc ? this.ends(arc)[1] : this.root, arc, failed: this.failedAt(step) };
  }

  failedAt(step: number): FailedConnection | null {
    const number = this.failures[step] ?? -1,
      { shots } = this.trace;
    if (number < 0) return null;
    const arcs: WalkArc[] = [];
    for (let at = shots.first[number]!; at < (shots.first[number + 1] ?? shots.arcs.length / FIELDS); at++)
      arcs.push(arcOf(shots.arcs, at));
    const [x, y, heading] = shots.hits.subarray(3 * number, 3 * number + 3) as unknown as [number, number, number];
    const length = arcs.reduce((sum, one) => sum + Math.abs(one.length), 0);
    return { arcs, hit: { x, y, heading }, obstacle: shots.obstacles[number]!, length };
  }

  /** Later expansions that were reached from the pose of a step. */
  childrenOf(step: number): number[] {
    return this.children.get(keyOf(this.at(step).pose)) ?? [];
  }

  /** The next step from there on, or before it, whose connection fails; the last or the first where there is none. */
  nextFailure(from: number, sign: 1 | -1): number {
    for (let step = from + sign; step >= 0 && step < this.steps; step += sign)
      if (this.failures[step]! >= 0) return step;
    return sign > 0 ? this.steps - 1 : 0;
  }
}

function arcOf(columns: Float64Array, at: number): WalkArc {
  const [x, y, heading, curvature, length] = columns.subarray(at * FIELDS, at * FIELDS + FIELDS) as unknown as number[];
  return { x: x!, y: y!, heading: heading!, curvature: curvature!, length: length! };
}

/** The pose at an arc's end. */
export function endOf({ x, y, heading, curvature, length }: WalkArc): Pose {
  const turned = heading + curvature * length;
  if (Math.abs(curvature) < 1e-9)
    return { x: x + length * Math.cos(heading), y: y + length * Math.sin(heading), heading };
  return {
    x: x + (Math.sin(turned) - Math.sin(heading)) / curvature,
    y: y - (Math.cos(turned) - Math.cos(heading)) / curvature,
    heading: turned,
  };
}

/** Poses a tenth of a millimetre apart are one. */
const keyOf = ({ x, y, heading }: Pose): string => {
  const turn = 2 * Math.PI,
    angle = ((heading % turn) + turn) % turn;
  return `${Math.round(x * 1e4)} ${Math.round(y * 1e4)} ${Math.round(Math.sin(angle) * 1e4)} ${Math.round(Math.cos(angle) * 1e4)}`;
};
