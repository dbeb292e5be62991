import type { Drive, Encounter, Limits, Plan, Planner, PlannerId, Scenario } from "parkade";
import { failureOf } from "./failure";
import type { Layers, Reply, Request, Waiting } from "./protocol";

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
let current: Planner | null = null;

/** Answers the page's requests; called in workers only. */
export function serve(loaded: Api): void {
  api = loaded;
  scope.onmessage = ({ data }) => {
    if (data.kind === "start") {
      current?.free();
      current = null;
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
    case "explain": return { kind: "explained", id, explanation: current?.explain(request) ?? null };
  }
}

function plan({ id, scene, layers: names, trace, waiting, limits }: Extract<Request, { kind: "plan" }>): Extract<Reply, { kind: "planned" }> {
  current?.free();
  current = null;
  const next = new api.Planner(planner, scene);
  current = next;
  const from = performance.now();
  const found = next.plan({ trace });
  const millis = performance.now() - from;
  const layers: Layers = {};
  for (const name of names) layers[name] = next.layer(name);
  return { kind: "planned", id, plan: found, layers, drive: waiting && driveOf(scene, found, waiting, limits), millis };
}

/** The plan in time, among moving obstacles where there are some; null where no car drives it, or without the complete module. */
function driveOf(scene: Scenario, plan: Plan, rule: Waiting, limits?: Limits): Drive | Encounter | null {
  if (plan.outcome !== "found" || !plan.check.drivable) return null;
  return (scene.moving?.length ? api.stopWaitGo?.(scene, plan, { rule }) : api.trajectory?.(scene, plan, limits)) ?? null;
}

function time(runs: number, budget: number): number[] {
  const samples: number[] = [];
  const end = performance.now() + budget;
  while (current && samples.length < runs && (samples.length === 0 || performance.now() < end)) {
    const from = performance.now();
    current.plan({ trace: false });
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
