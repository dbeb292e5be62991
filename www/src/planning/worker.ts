import type { Drive, Encounter, Limits, Plan, Planner, PlannerId, Scenario } from "parkade";
import { failureOf } from "./failure";
import type { Ends, Layers, PlanRequest, Reply, Request, Waiting } from "./protocol";

const scope = self as unknown as {
  onmessage: ((event: MessageEvent<Request>) => void) | null;
  postMessage(reply: Reply, transfer: Transferable[]): void;
};

/** What the worker needs of the package. */
type Package = typeof import("parkade");
type Api = Pick<Package, "Planner" | "init"> & Partial<Pick<Package, "stopWaitGo" | "trajectory">>;

let api: Api;
let planner: PlannerId = "hybrid";
let ready: Promise<void> | null = null;
/** The planner of the last scene that came, that scene as far as drives need it, and where the last plan was. */
let held: { planner: Planner; scene: Scenario; ends: Ends } | null = null;

/** Answers the page's requests; called in workers only. */
export function serve(loaded: Api): void {
  api = loaded;
  scope.onmessage = ({ data }) => {
    if (data.kind === "start") {
      letGo();
      planner = data.planner;
      ready = api.init({ wasm: data.module });
    } else void answer(data);
  };
}

async function answer(request: Exclude<Request, { kind: "start" }>): Promise<void> {
  try {
    await ready;
    const reply = answerTo(request);
    scope.postMessage(reply, reply.kind === "planned" ? buffers(reply.plan, reply.layers) : []);
  } catch (error) {
    scope.postMessage({ kind: "failed", id: request.id, error: failureOf(error) }, []);
  }
}

function answerTo(request: Exclude<Request, { kind: "start" }>): Reply {
  const { id } = request;
  switch (request.kind) {
    case "plan": return plan(request);
    case "time": return { kind: "timed", id, samples: time(request.runs, request.budget) };
    case "explain": return { kind: "explained", id, explanation: held?.planner.explain(request) ?? null };
  }
}

function letGo(): void {
  held?.planner.free();
  held = null;
}

function plan({ id, scene, ends, layers: names, every, trace, waiting, limits }: PlanRequest): Extract<Reply, { kind: "planned" }> {
  if (scene) {
    letGo();
    held = { planner: new api.Planner(planner, scene), scene: withoutCells(scene), ends };
  }
  if (!held) throw new Error("This worker has no scene.");
  held.ends = ends;
  const from = performance.now();
  const found = held.planner.plan({ trace, ...ends, onProgress: (expansions) => scope.postMessage({ kind: "progress", id, expansions }, []) });
  const millis = performance.now() - from;
  const layers: Layers = {};
  for (const name of names) layers[name] = held.planner.layer(name, name === "risk" ? { every } : {});
  const reply = { kind: "planned", id, plan: found, layers, drive: null, undriven: false, millis } as const;
  try {
    return { ...reply, drive: waiting && driveOf({ ...held.scene, ...ends }, found, waiting, limits) };
  } catch (error) {
    // A trap leaves the module's memory in an unknown state.
    if (failureOf(error).code === "internal") throw error;
    return { ...reply, undriven: true };
  }
}

/** Times depend on the path alone, and reading a huge map takes longer than planning. */
const withoutCells = (scene: Scenario): Scenario => ({ ...scene, obstacles: (scene.obstacles ?? []).filter(({ type }) => type !== "cells") });

/** The plan in time, among moving obstacles where there are some; null where no car drives it, or without the complete module. */
function driveOf(scene: Scenario, plan: Plan, rule: Waiting, limits?: Limits): Drive | Encounter | null {
  if (plan.outcome !== "found" || !plan.check.drivable) return null;
  return (scene.moving?.length ? api.stopWaitGo?.(scene, plan, { rule }) : api.trajectory?.(scene, plan, limits)) ?? null;
}

function time(runs: number, budget: number): number[] {
  const samples: number[] = [];
  const end = performance.now() + budget;
  while (held && samples.length < runs && (samples.length === 0 || performance.now() < end)) {
    const from = performance.now();
    held.planner.plan({ trace: false, ...held.ends });
    samples.push(performance.now() - from);
  }
  return samples;
}

function buffers(plan: Plan, layers: Layers): Transferable[] {
  const arrays: (ArrayBufferView | undefined)[] = [
    plan.path, plan.directions, plan.curvatures, plan.clearances, plan.rawPath, plan.check.hitPoses,
    plan.trace?.kind === "cells" ? plan.trace.cells : plan.trace?.arcs,
    ...Object.values(layers).map((layer) => layer.data),
  ];
  return [...new Set(arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : [])))];
}
