/** Recorded searches as files: plain JSON, and the trace format of Posthoc (version 1.4.0). */
import type { PlannerId, PoseTrace, SearchTrace } from "parkade";
import { FATE, STEP } from "./search-replay";
import { nth } from "../scene/nth";

/** All columns as lists of numbers, by their names in the API. */
export function traceAsJson(planner: PlannerId, trace: SearchTrace | PoseTrace): string {
  return JSON.stringify({ format: "parkade-search", version: 1, planner, ...trace }, (_, value: unknown) =>
    ArrayBuffer.isView(value) ? [...(value as Uint8Array)] : value,
  );
}

interface PosthocEvent {
  type: string;
  id: number;
  pId?: number | null;
  x: number;
  y: number;
  g?: number;
  h?: number;
  f?: number;
}

/** Events of the types that Posthoc colours itself; y counts from the top. Blocked and refused moves are left out. */
export function traceForPosthoc(trace: SearchTrace): string {
  const { width, height, nodes, kinds, first, targets, fates, unit } = trace;
  const at = (node: number): { id: number; x: number; y: number } => ({
    id: node,
    x: node % width,
    y: height - 1 - Math.floor(node / width),
  });
  const events: PosthocEvent[] = [];
  const parents = new Map<number, number | null>();
  nodes.forEach((node, step) => {
    const kind = nth(kinds, step) & 15,
      side = nth(kinds, step) >> 4;
    const key = node * 2 + side;
    if (!parents.has(key)) {
      parents.set(key, null);
      events.push({ type: side === 1 ? "destination" : "source", ...at(node) });
    }
    const costs = { g: nth(trace.g, step) / unit, h: nth(trace.h, step) / unit, f: nth(trace.f, step) / unit };
    const type = kind === STEP.goal || kind === STEP.meet ? "end" : kind === STEP.rejected ? "closing" : "expanding";
    events.push({ type, ...at(node), pId: parents.get(key)!, ...costs });
    for (let move = nth(first, step); move < nth(first, step + 1); move++) {
      const fate = nth(fates, move) & 15;
      if (fate > FATE.improved) continue;
      const target = nth(targets, move),
        parent = nth(fates, move) >= 16 ? (parents.get(key) ?? node) : node;
      const g = nth(trace.targetG, move) / unit,
        h = nth(trace.targetH, move) / unit;
      parents.set(target * 2 + side, parent);
      events.push({
        type: kind === STEP.goal ? "end" : fate === FATE.kept ? "generating" : "updating",
        ...at(target),
        pId: parent,
        g,
        h,
        f: g + h,
      });
    }
    if (type === "expanding" && kind < STEP.drawn)
      events.push({ type: "closing", ...at(node), pId: parents.get(key)!, ...costs });
  });
  const cell = { $: "rect", fill: "${{ color[$.type] }}", width: 1, height: 1, x: "${{ $.x }}", y: "${{ $.y }}" };
  const pivot = { x: "${{ $.x + 0.5 }}", y: "${{ $.y + 0.5 }}", scale: 1 };
  return JSON.stringify({ version: "1.4.0", views: { main: [cell] }, pivot, events });
}
