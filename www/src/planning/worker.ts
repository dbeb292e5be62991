import { init, Planner, type LayerName, type Plan, type PlannerId, type Scenario } from "parkade";
import { failureOf } from "./failure";
import type { Layers, Reply, Request } from "./protocol";

const scope = self as unknown as {
  onmessage: ((event: MessageEvent<Request>) => void) | null;
  postMessage(reply: Reply, transfer: Transferable[]): void;
};

let planner: PlannerId = "hybrid";
let ready: Promise<void> | null = null;
let current: Planner | null = null;

/** Answers the page's requests; called in workers only. */
export function serve(): void {
  scope.onmessage = ({ data }) => {
    if (data.kind === "start") {
      planner = data.planner;
      ready = init({ wasm: data.module });
    } else void answer(data);
  };
}

async function answer(request: Exclude<Request, { kind: "start" }>): Promise<void> {
  try {
    await ready;
    const reply = request.kind === "plan"
      ? plan(request.id, request.scene, request.layers)
      : { kind: "timed" as const, id: request.id, samples: time(request.runs, request.budget) };
    scope.postMessage(reply, reply.kind === "planned" ? buffers(reply.plan, reply.layers) : []);
  } catch (error) {
    scope.postMessage({ kind: "failed", id: request.id, error: failureOf(error) }, []);
  }
}

function plan(id: number, scene: Scenario, names: LayerName[]): Extract<Reply, { kind: "planned" }> {
  current?.free();
  current = null;
  const next = new Planner(planner, scene);
  current = next;
  const from = performance.now();
  const found = next.plan({ trace: true });
  const millis = performance.now() - from;
  const layers: Layers = {};
  for (const name of names) layers[name] = next.layer(name);
  return { kind: "planned", id, plan: found, layers, millis };
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
