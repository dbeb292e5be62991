import { FIRST_SCENE } from "./playground";

/** Values of absent attributes. */
export const DEFAULTS: Record<string, string> = {
  scene: FIRST_SCENE,
  planners: "",
  layout: "grid",
  theme: "auto",
  controls: "full",
  layers: "",
  wheel: "ctrl",
  speed: "1",
};
