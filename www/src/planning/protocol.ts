import type { Layer, LayerName, Plan, PlannerId, Scenario } from "parkade";

/** What a planner's worker is asked. */
export type Request =
  | { kind: "start"; module: WebAssembly.Module; planner: PlannerId }
  | { kind: "plan"; id: number; scene: Scenario; layers: LayerName[] }
  /** Plans the last scene again, silently, until `runs` are made or `budget` milliseconds are spent. */
  | { kind: "time"; id: number; runs: number; budget: number };

export interface Failure { code: string; path: string; message: string }
export type Layers = Partial<Record<LayerName, Layer>>;

export type Reply =
  | { kind: "planned"; id: number; plan: Plan; layers: Layers; millis: number }
  | { kind: "timed"; id: number; samples: number[] }
  | { kind: "failed"; id: number; error: Failure };
