/** How a shared scene was looked at: arrangement, planners, layers, step and camera, behind its link as `&v=…`. */
import type { PlannerId } from "parkade";
import type { Camera, LayerKey, Playback, State } from "../store";

const MODES = ["grid", "overlay", "focus"] as const;
/** In the order of their bits; new ones only at the end, for links open for ever. */
const BITS: readonly LayerKey[] = [
  "slots", "obstacles", "safety", "redundant", "cost", "heat", "risk", "tree", "sweep", "path", "car", "ghosts", "grid", "difference",
];
const WAYS = ["drive-percent", "search-percent", "search-expansions"] as const;

type Looks = Pick<State, "mode" | "focus" | "planners" | "layers" | "playback" | "camera">;

export function encodeView({ mode, focus, planners, layers, playback, camera }: Looks): string {
  const bits = BITS.reduce((sum, key, i) => sum + (layers[key] ? 2 ** i : 0), 0);
  const way = playback.base === "drive" ? 0 : playback.searchMode === "percent" ? 1 : 2;
  const place = camera ? [camera.x * 100, camera.y * 100, camera.scale * 100].map(Math.round) : [];
  return [MODES.indexOf(mode), focus, planners.join("."), bits.toString(36), way, Math.round(playback.fraction * 10000), ...place].join("~");
}

/** What of it makes sense; a damaged rest leaves the page as it is, for the scene is what matters. */
export function decodeView(text: string, playback: Playback): Partial<Looks> {
  const [mode, focus, planners, bits, way, fraction, ...place] = text.split("~");
  const ids = (planners ?? "").split(".").filter((id) => /^[a-z-]+$/.test(id)) as PlannerId[];
  const shown = parseInt(bits ?? "", 36), [base, searchMode] = (WAYS[Number(way)] ?? "drive-percent").split("-");
  const at = Number(fraction) / 10000, camera = cameraOf(place.map(Number));
  return {
    ...(MODES[Number(mode)] ? { mode: MODES[Number(mode)]! } : {}),
    ...(ids.length > 0 ? { planners: ids, focus: ids.find((id) => id === focus) ?? ids.at(-1)! } : {}),
    ...(Number.isInteger(shown) ? { layers: Object.fromEntries(BITS.map((key, i) => [key, Math.floor(shown / 2 ** i) % 2 === 1])) as Record<LayerKey, boolean> } : {}),
    ...(at >= 0 && at <= 1 ? { playback: { ...playback, base: base as Playback["base"], searchMode: searchMode as Playback["searchMode"], fraction: at, playing: false } } : {}),
    ...(camera ? { camera } : {}),
  };
}

function cameraOf(numbers: readonly number[]): Camera | null {
  const [x, y, scale] = numbers.map((value) => value / 100);
  return numbers.length === 3 && [x, y, scale].every(Number.isFinite) && scale! > 0 ? { x: x!, y: y!, scale: scale! } : null;
}
