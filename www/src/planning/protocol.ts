import type { Drive, Encounter, Explanation, Layer, LayerName, Limits, Plan, PlannerId, Scenario } from "parkade";

/** What a planner's worker is asked. */
export type Request =
  | { kind: "start"; module: WebAssembly.Module; planner: PlannerId }
  | { kind: "plan"; id: number; scene: Scenario; layers: LayerName[]; trace: boolean; waiting: Waiting | null; limits?: Limits }
  /** Plans the last scene again, silently, until `runs` are made or `budget` milliseconds are spent. */
  | { kind: "time"; id: number; runs: number; budget: number }
  | Explain;

/** How moving obstacles are waited for. */
export type Waiting = "predictive" | "reactive";

/** What the risk field does at a point of the last scene. */
export interface Explain { kind: "explain"; id: number; x: number; y: number }

export interface Failure { code: string; path: string; message: string }
export type Layers = Partial<Record<LayerName, Layer>>;

export type Reply =
  | { kind: "planned"; id: number; plan: Plan; layers: Layers; drive: Drive | Encounter | null; millis: number }
  | { kind: "timed"; id: number; samples: number[] }
  | { kind: "explained"; id: number; explanation: Explanation | null }
  | { kind: "failed"; id: number; error: Failure };
