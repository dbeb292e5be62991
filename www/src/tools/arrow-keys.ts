/** Which keys are ways, and how far each goes. */
import type { Scene } from "../store";

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export const arrowOf = (key: string): [number, number] | undefined => ARROWS[key];
export const stepOf = (map: Scene["map"], far: boolean): number => (far ? 1 : map.resolution);
