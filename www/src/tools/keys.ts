/** Which keys are tools and ways. */
import type { Scene, ToolId } from "../store";

const TOOL_KEYS: Record<string, ToolId> = {
  v: "select",
  1: "select",
  b: "brush",
  2: "brush",
  l: "wall",
  3: "wall",
  r: "rectangle",
  4: "rectangle",
  g: "polygon",
  5: "polygon",
  c: "car",
  6: "car",
  p: "slot",
  7: "slot",
  m: "moving",
  k: "cost",
  8: "cost",
  d: "road",
  e: "eraser",
  9: "eraser",
  h: "hand",
};

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export const toolOfKey = (key: string): ToolId | undefined => TOOL_KEYS[key.toLowerCase()];

export const arrowOf = (key: string): [number, number] | undefined => ARROWS[key];
export const stepOf = (map: Scene["map"], far: boolean): number => (far ? 1 : map.resolution);
