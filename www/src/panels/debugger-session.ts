/** Walking through a recorded search: steps of several kinds, running, breakpoints. */
import type { PlannerId, PoseTrace, SearchTrace } from "parkade";
import { FATE, SearchReplay, STEP } from "../planning/search-replay";
import { nth } from "../scene/nth";

export const UNITS = ["step", "move", "improved", "tie", "refused", "held", "failure"] as const;
export type Unit = (typeof UNITS)[number];
export const SPEEDS = [2, 10, 60, 600, 6000] as const;

/** Radius around a point on the map in which an expanded pose stops the run, metres. */
export const POSE_RADIUS = 0.5;

export interface Breakpoints {
  cells: ReadonlySet<number>;
  /** Points on the map; a pose's middle of the rear axle comes near one. */
  points: readonly { x: number; y: number }[];
  /** In the units of the search. */
  f: number | null;
  improved: boolean;
  meet: boolean;
}

/** How long a run may work before it lets the page draw, milliseconds. */
const SLICE_MS = 8;

export class Session {
  readonly replay: SearchReplay;
  unit: Unit = "step";
  /** True if a step's connection to the other end failed. */
  fails: (step: number) => boolean = () => false;
  speed: number = SPEEDS[1];
  breaks: Breakpoints = { cells: new Set(), points: [], f: null, improved: false, meet: false };
  /** True if the last run ended at a breakpoint. */
  stopped = false;
  private frame = 0;
  private from = 0;
  private done = 0;

  constructor(
    readonly planner: PlannerId,
    trace: SearchTrace | PoseTrace,
    private readonly changed: () => void,
  ) {
    this.replay = new SearchReplay(trace);
  }

  get isRunning(): boolean {
    return this.frame !== 0;
  }

  seek(event: number): void {
    this.pause();
    this.stopped = false;
    this.replay.seek(event);
    this.changed();
  }

  /** One unit on, or back. */
  move(sign: 1 | -1): void {
    this.seek(sign > 0 ? this.nextEvent() : this.previousEvent());
  }

  toggle(): void {
    if (this.isRunning) {
      this.pause();
      this.changed();
      return;
    }
    if (this.replay.at === this.replay.events) this.replay.seek(0);
    this.stopped = false;
    this.from = performance.now();
    this.done = 0;
    this.frame = requestAnimationFrame(this.run);
  }

  pause(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  private readonly run = (): void => {
    const due = ((performance.now() - this.from) / 1000) * this.speed,
      until = performance.now() + SLICE_MS;
    this.frame = requestAnimationFrame(this.run);
    while (this.done < due && performance.now() < until) {
      this.done++;
      this.replay.seek(this.nextEvent());
      this.stopped = this.isBreak(this.replay.step);
      if (this.stopped || this.replay.at === this.replay.events) {
        this.pause();
        break;
      }
    }
    this.changed();
  };

  /** The event after which the next unit is done. */
  private nextEvent(): number {
    const { replay } = this;
    if (this.unit === "move") return replay.at + 1;
    const step = replay.step;
    const isDone = step < 0 || replay.at === replay.endOf(step);
    if (!isDone) return replay.endOf(step);
    if (this.unit === "step") return replay.endOf(step + 1 < replay.steps ? step + 1 : step);
    for (let next = step + 1; next < replay.steps; next++) if (this.is(next)) return replay.endOf(next);
    return replay.events;
  }

  private previousEvent(): number {
    const { replay } = this,
      { step } = replay;
    if (this.unit === "move") return replay.at - 1;
    for (let before = step - 1; before >= 0; before--)
      if (this.unit === "step" || this.is(before)) return replay.endOf(before);
    return 0;
  }

  /** True if a step is one that the unit looks for. */
  private is(step: number): boolean {
    const has = (...fates: number[]): boolean => {
      const { first, fates: all } = this.replay.trace;
      return all.subarray(first[step], first[step + 1]).some((fate) => fates.includes(fate & 15));
    };
    switch (this.unit) {
      case "improved":
        return has(FATE.improved);
      case "refused":
        return has(FATE.blocked, FATE.corner);
      case "held":
        return has(FATE.heldBack, FATE.requeued);
      case "failure":
        return this.fails(step);
      case "tie": {
        const { f } = this.replay.trace;
        return step > 0 && f[step] === f[step - 1];
      }
      default:
        return true;
    }
  }

  private isBreak(step: number): boolean {
    const { trace } = this.replay,
      { cells, points, f, improved, meet } = this.breaks;
    if (step < 0) return false;
    if (cells.has(nth(trace.nodes, step))) return true;
    const pose = points.length > 0 ? this.replay.poseOf(this.replay.sideOf(step), nth(trace.nodes, step)) : null;
    if (pose && points.some(({ x, y }) => Math.hypot(x - pose.x, y - pose.y) <= POSE_RADIUS)) return true;
    if (f !== null && nth(trace.f, step) > f && (step === 0 || nth(trace.f, step - 1) <= f)) return true;
    if (meet && this.replay.kindOf(step) === STEP.meet) return true;
    return (
      improved &&
      trace.fates.subarray(trace.first[step], trace.first[step + 1]).some((one) => (one & 15) === FATE.improved)
    );
  }
}
