/** Which layers are shown together. */
import type { LayerKey, State } from ".";

export type LayerPreset = "clean" | "search" | "risk" | "drive";
export const LAYER_PRESETS: readonly LayerPreset[] = ["clean", "search", "risk", "drive"];

const SHOWN: Record<LayerPreset, readonly LayerKey[]> = {
  clean: ["slots", "obstacles", "path", "car", "grid"],
  search: ["slots", "obstacles", "path", "heat", "tree", "grid"],
  risk: ["slots", "obstacles", "path", "car", "safety", "cost", "risk", "grid"],
  drive: ["slots", "obstacles", "path", "car", "sweep", "heat", "safety", "risk", "grid"],
};
export const ALL_LAYERS: readonly LayerKey[] = [
  "slots",
  "obstacles",
  "safety",
  "redundant",
  "cost",
  "heat",
  "risk",
  "tree",
  "sweep",
  "path",
  "car",
  "ghosts",
  "difference",
  "grid",
];

export function presetLayers(preset: LayerPreset): Record<LayerKey, boolean> {
  return Object.fromEntries(ALL_LAYERS.map((key) => [key, SHOWN[preset].includes(key)])) as Record<LayerKey, boolean>;
}

export function presetOf(layers: State["layers"]): LayerPreset | null {
  return LAYER_PRESETS.find((preset) => ALL_LAYERS.every((key) => layers[key] === SHOWN[preset].includes(key))) ?? null;
}
