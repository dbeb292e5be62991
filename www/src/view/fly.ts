/** Brings the camera to a place in steps that the eye can follow. */
import type { Camera, Store } from "../store";

const FLIGHT_MS = 240;

/** The camera `part` of the way; it zooms evenly. */
export function between(from: Camera, to: Camera, part: number): Camera {
  const scale = from.scale * (to.scale / from.scale) ** part;
  // The place under way moves evenly on the screen, not on the map.
  const moved = from.scale === to.scale ? part : (1 / from.scale - 1 / scale) / (1 / from.scale - 1 / to.scale);
  return { x: from.x + (to.x - from.x) * moved, y: from.y + (to.y - from.y) * moved, scale };
}

/** Ends early where something else moves the camera. */
export function flyTo(store: Store, from: Camera, to: Camera): void {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return store.set({ camera: to });
  let begun: number | null = null,
    last: Camera | null = store.state.camera;
  const step = (now: number): void => {
    if (store.state.camera !== last) return;
    begun ??= now;
    const part = Math.min(1, (now - begun) / FLIGHT_MS),
      eased = 1 - (1 - part) ** 3;
    store.set({ camera: (last = part < 1 ? between(from, to, eased) : to) });
    if (part < 1) requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}
