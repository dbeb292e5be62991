import type { Layer, LayerName, Plan } from "../index.js";

/** The buffers of a plan and of rasters, for `postMessage`: they move to the other thread instead of being copied. */
export function transferables(plan: Plan, layers?: Partial<Record<LayerName, Layer>>): ArrayBuffer[];
