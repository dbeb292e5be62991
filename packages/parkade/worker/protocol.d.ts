import type {
  DrivenPath, Expansions, HybridPlan, LayerName, OptimiseOptions, ParkadeError, Plan, PlannerId, Scenario,
} from "../index.js";

/** To a worker. */
export type Message = { kind: "start"; module: WebAssembly.Module } | Job;

interface Base {
  id: number;
  /**
   * A planner that the worker does not have yet; it takes the place of the one before. `before`: the path that its
   * planner goes on from.
   */
  prepare: { planner: PlannerId; scene: Scenario; settings: object; before: HybridPlan | undefined } | undefined;
}

export type Job = Base &
  (
    | { kind: "prepare" }
    | {
        kind: "plan";
        options: object;
        layers: LayerName[];
        tells: { progress: boolean; improved: boolean; expanded: boolean };
        /** One 32-bit number: the search ends where it is not 0. Absent where threads cannot share memory. */
        stop: SharedArrayBuffer | undefined;
      }
    | { kind: "optimise"; path: DrivenPath; options: OptimiseOptions }
  );

/** From a worker. */
export type Reply =
  | { kind: "progress"; id: number; expansions: number }
  | { kind: "improved"; id: number; plan: Plan }
  | { kind: "expanded"; id: number; events: Expansions }
  | { kind: "done"; id: number; result: unknown }
  | { kind: "stopped"; id: number }
  | { kind: "failed"; id: number; error: Pick<ParkadeError, "code" | "path" | "message" | "template" | "values"> };
