/** The layers of the maps, and which are shown together. */

export type LayerPreset = "clean" | "search" | "risk" | "drive";
export const LAYER_PRESETS: readonly LayerPreset[] = ["clean", "search", "risk", "drive"];

/** In the order of the menu: the sets that show each, and its bit in links, which it keeps for ever. */
export const LAYERS = {
  path: { bit: 9, sets: ["clean", "search", "risk", "drive"] },
  car: { bit: 10, sets: ["clean", "risk", "drive"] },
  sweep: { bit: 8, sets: ["drive"] },
  ghosts: { bit: 11, sets: [] },
  difference: { bit: 13, sets: [] },
  heat: { bit: 5, sets: ["search", "drive"] },
  tree: { bit: 7, sets: ["search"] },
  risk: { bit: 6, sets: ["risk", "drive"] },
  cost: { bit: 4, sets: ["risk"] },
  safety: { bit: 2, sets: ["risk", "drive"] },
  redundant: { bit: 3, sets: [] },
  obstacles: { bit: 1, sets: ["clean", "search", "risk", "drive"] },
  slots: { bit: 0, sets: ["clean", "search", "risk", "drive"] },
  grid: { bit: 12, sets: ["clean", "search", "risk", "drive"] },
} satisfies Record<string, { bit: number; sets: LayerPreset[] }>;

export type LayerKey = keyof typeof LAYERS;
export type LayerSet = Record<LayerKey, boolean>;
export const ALL_LAYERS = Object.keys(LAYERS) as LayerKey[];

export const isShown = (key: LayerKey, preset: LayerPreset): boolean =>
  (LAYERS[key].sets as LayerPreset[]).includes(preset);

export const presetLayers = (preset: LayerPreset): LayerSet => layerSet((key) => isShown(key, preset));

export const layerSet = (has: (key: LayerKey) => boolean): LayerSet =>
  Object.fromEntries(ALL_LAYERS.map((key) => [key, has(key)])) as LayerSet;

export function presetOf(layers: LayerSet): LayerPreset | null {
  return LAYER_PRESETS.find((preset) => ALL_LAYERS.every((key) => layers[key] === isShown(key, preset))) ?? null;
}
