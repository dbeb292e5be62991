import type { Timing } from "../store/results";
import type { HybridPlan, Plan, Planner, PlannerId } from "parkade";
import { transferables } from "parkade/worker/transfer";
import type { Scenario } from "parkade";
import type { driveOf } from "./drive-of";
import { failureOf } from "./failure";
import type { Ends, Layers, PlanRequest, Reply, Request } from "./protocol";

/** The worker's own scope; the page's libraries know a window. */
declare const self: {
  onmessage: ((event: MessageEvent<Request>) => void) | null;
  postMessage(reply: Reply, transfer: Transferable[]): void;
};

/** The part of the package that the worker needs. */
type Package = typeof import("parkade");
type Api = Pick<Package, "Planner" | "init" | "planners"> & { driveOf?: typeof driveOf };

/** Plans after which times are those of compiled code. */
const WARM_PLANS = 3;
const SAMPLE_MS = 3;

let api: Api;
let planner: PlannerId = "hybrid";
let ready: Promise<void> | null = null;
/** The planner of the last scene that came, that scene as far as drives need it, and where the last plan was. */
let held: { planner: Planner; scene: Scenario; ends: Ends } | null = null;
/** Of two ways about as good the one that is shown stays while something is dragged. */
const DRAG = { stickiness: 0.03 };
let plans = 0;

/** Answers the page's requests; called in workers only. */
export function serve(loaded: Api): void {
  api = loaded;
  self.onmessage = ({ data }) => {
    if (data.kind === "start") {
      letGo();
      plans = 0;
      planner = data.planner;
      ready = api.init({ wasm: data.module });
    } else void answer(data);
  };
}

async function answer(request: Exclude<Request, { kind: "start" }>): Promise<void> {
  try {
    await ready;
    const reply = answerTo(request);
    self.postMessage(reply, reply.kind === "planned" ? transferables(reply.plan, reply.layers) : []);
  } catch (error) {
    self.postMessage({ kind: "failed", id: request.id, error: failureOf(error) }, []);
  }
}

function answerTo(request: Exclude<Request, { kind: "start" }>): Reply {
  const { id } = request;
  switch (request.kind) {
    case "plan":
      return plan(request);
    case "time":
      return { kind: "timed", id, samples: time(request) };
    case "explain":
      return { kind: "explained", id, explanation: held?.planner.explain(request) ?? null };
  }
}

/** While something is dragged the planner of the scene as it is now goes on from that of the step before. */
function hold(scene: Scenario | null, ends: Ends, drags = false): NonNullable<typeof held> {
  if (scene) {
    const before = drags ? held?.planner : letGo();
    held = null;
    try {
      held = { planner: new api.Planner(planner, scene), scene: withoutCells(scene), ends };
      if (before) held.planner.continueFrom(before);
    } finally {
      before?.free();
    }
  }
  if (!held) throw new Error("This worker has no scene.");
  held.ends = ends;
  return held;
}

function letGo(): undefined {
  held?.planner.free();
  held = null;
}

function plan({
  id,
  scene,
  ends,
  layers: names,
  every,
  trace,
  waiting,
  limits,
  prefer,
  shown,
}: PlanRequest): Extract<Reply, { kind: "planned" }> {
  const warm = plans >= WARM_PLANS;
  const drags = !waiting && !!api.driveOf && drivesCar(),
    current = hold(scene, ends, drags);
  if (drags && shown) current.planner.continueFrom(shown as HybridPlan);
  const [found, time] = timed(
    current.planner,
    { trace, ...ends, ...(drags && { ...DRAG, prefer: prefer! }) },
    (expansions) => self.postMessage({ kind: "progress", id, expansions }, []),
  );
  const layers: Layers = {};
  for (const name of names) layers[name] = current.planner.layer(name, name === "risk" ? { every } : {});
  const reply = { kind: "planned", id, plan: found, layers, drive: null, undriven: false, time, warm } as const;
  try {
    return {
      ...reply,
      drive: (waiting && api.driveOf?.({ ...current.scene, ...ends }, found, waiting, limits)) ?? null,
    };
  } catch (error) {
    // A trap leaves the module's memory in an unknown state.
    if (failureOf(error).code === "internal") throw error;
    return { ...reply, undriven: true };
  }
}

const drivesCar = (): boolean => api.planners().find(({ id }) => id === planner)?.family === "hybrid";

/** Times depend on the path alone, and reading a huge map takes longer than planning. */
const withoutCells = (scene: Scenario): Scenario => ({
  ...scene,
  obstacles: (scene.obstacles ?? []).filter(({ type }) => type !== "cells"),
});

/** A plan and how long it took. */
function timed(
  planner: Planner,
  options: Parameters<Planner["plan"]>[0],
  tell: (expansions: number) => void = () => {},
): [Plan, Timing] {
  const from = performance.now();
  let search = 0;
  const found = planner.plan({
    ...options,
    onProgress: (expansions) => {
      search = performance.now() - from;
      tell(expansions);
    },
  });
  plans++;
  return [found, { search, total: performance.now() - from }];
}

function time({ runs, budget, scene, ends }: Extract<Request, { kind: "time" }>): Timing[] {
  const samples: Timing[] = [];
  const current = hold(scene, ends).planner,
    silent = { trace: false, ...ends };
  if (scene) timed(current, silent);
  const end = performance.now() + budget;
  while (samples.length < runs && (samples.length === 0 || performance.now() < end))
    samples.push(sample(current, silent));
  return samples;
}

/** The mean of as many plans as clocks need that tell a tenth of a millisecond, or only a whole one. */
function sample(planner: Planner, options: Parameters<Planner["plan"]>[0]): Timing {
  const from = performance.now();
  let search = 0,
    runs = 0,
    total = 0;
  while (runs === 0 || total < SAMPLE_MS) {
    search += timed(planner, options)[1].search;
    total = performance.now() - from;
    runs++;
  }
  return { search: search / runs, total: total / runs };
}
