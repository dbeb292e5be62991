import { piece } from "./piece";

export type LaterLayers = typeof import("./layers/later");
/** Layers for drawing, roads, moving obstacles and search traces. */
export const laterLayers = piece<LaterLayers>();
