import type { Timing } from "../store/results";
import type { Drive, Encounter, Explanation, Layer, LayerName, Limits, Plan, PlannerId, Pose, Prefer } from "parkade";
import type { Scenario } from "parkade";

/** Requests to a planner's worker. */
export type Request =
  | { kind: "start"; module: WebAssembly.Module; planner: PlannerId }
  | PlanRequest
  /**
   * Plans silently until `runs` are made or `budget` milliseconds are spent: the last scene, or another after a first
   * plan that does not count.
   */
  | { kind: "time"; id: number; runs: number; budget: number; scene: Scenario | null; ends: Ends }
  | Explain;

export interface PlanRequest {
  kind: "plan";
  id: number;
  /** null: the scene before, but for its ends. */
  scene: Scenario | null;
  ends: Ends;
  layers: LayerName[];
  /** Cells from one force of the layer `risk` to the next. */
  every: number;
  trace: boolean;
  waiting: Waiting | null;
  limits?: Limits;
  /** Of a drag: what the path that stays is chosen by, and, where that is not the worker's last, the path. */
  prefer?: Prefer | undefined;
  shown?: Plan | null | undefined;
}

/** Start and goal of a plan; without a goal, the scene's slot or set of goals. */
export interface Ends {
  start: Pose;
  goal?: Pose;
}

/** How moving obstacles are waited for. */
export type Waiting = "predictive" | "reactive";

/** Explains the risk field at a point of the last scene. */
export interface Explain {
  kind: "explain";
  id: number;
  x: number;
  y: number;
}

export interface Failure {
  code: string;
  path: string;
  message: string;
  /** What the message is made of: the rule with `{}` in the place of each value. */
  template?: string;
  values?: readonly string[];
  /** Of a file that was read, from 1. */
  line?: number;
}
export type Layers = Partial<Record<LayerName, Layer>>;

export type Reply =
  /** Expansions so far. */
  | { kind: "progress"; id: number; expansions: number }
  | {
      kind: "planned";
      id: number;
      plan: Plan;
      layers: Layers;
      drive: Drive | Encounter | null /** There should be a drive, and its computation failed. */;
      undriven: boolean;
      time: Timing /** True if the worker has planned before. */;
      warm: boolean;
    }
  | { kind: "timed"; id: number; samples: Timing[] }
  | { kind: "explained"; id: number; explanation: Explanation | null }
  | { kind: "failed"; id: number; error: Failure };
