/** How a shared scene was looked at: layout, planners, layers, step and camera, behind its link as `&v=…`. */
import type { PlannerId } from "parkade";
import { check, MODES, numeral, RULES, SEARCH_MODES, type Known } from "./schema";
import type { Camera, Playback, State } from "../store";
import { ALL_LAYERS, LAYERS, layerSet } from "../store/layer-sets";
import { limited } from "../view/camera";

const WAYS = ["drive-percent", "search-percent", "search-expansions"] as const;
/** Cameras are kept to a hundredth, steps to a ten-thousandth. */
/** Between a planner and what its path is chosen by. */
const CHOICE = "!";
const FINE = 100,
  STEPS = 10_000;
/**
 * Among the bits of the layers, which leave it free: paths are driven as planned. Views without it are older than
 * trajectories.
 */
const UNSMOOTHED = 14;

type Looks = Pick<State, "mode" | "focus" | "planners" | "layers" | "playback" | "camera" | "prefer" | "smooth">;

export function encodeView({ mode, focus, planners, layers, playback, camera, prefer, scene, smooth }: State): string {
  const bits = ALL_LAYERS.reduce(
    (sum, key) => sum + (layers[key] ? 2 ** LAYERS[key].bit : 0),
    smooth === false ? 2 ** UNSMOOTHED : 0,
  );
  const way = playback.base === "drive" ? 0 : playback.searchMode === "percent" ? 1 : 2,
    held = limited(camera, scene.map);
  // The smallest scale must not be rounded below itself.
  const place = held ? [Math.round(held.x * FINE), Math.round(held.y * FINE), Math.ceil(held.scale * FINE - 1e-6)] : [];
  const shown = planners.map((planner) => [planner, ...(prefer[planner] ? [prefer[planner]] : [])].join(CHOICE));
  return [
    MODES.indexOf(mode),
    focus,
    shown.join("."),
    bits.toString(36),
    way,
    Math.round(playback.fraction * STEPS),
    ...place,
  ].join("~");
}

/** The planners that a view names, which need not exist. */
export const plannersOf = (text: string): PlannerId[] => shownIn(text).map(([planner]) => planner as PlannerId);

const shownIn = (text: string): string[][] => (text.split("~")[2] ?? "").split(".").map((one) => one.split(CHOICE));

/** Throws a `ValueError` for the first field that makes no sense: half a view is none. */
export function decodeView(text: string, known: Known, playback: Playback): Looks {
  const [mode, focus, , bits, way, fraction, ...place] = text.split("~");
  const mask = /^[0-9a-z]+$/.test(bits ?? "") ? parseInt(bits!, 36) : NaN;
  const [base, searchMode] = (WAYS[Number(way)] ?? `${way}`).split("-");
  const planners = check<PlannerId[]>(plannersOf(text), RULES.planners(known), "planners");
  const isOn = (bit: number): boolean => Math.floor(mask / 2 ** bit) % 2 === 1;
  check(mask, RULES.layerBits(UNSMOOTHED + 1), "layers");
  return {
    mode: check(MODES[Number(mode)] ?? mode, RULES.mode(), "mode"),
    planners,
    prefer: Object.fromEntries(
      shownIn(text)
        .filter(([, by]) => by !== undefined)
        .map(([planner, by]) => [planner, check(by, RULES.prefer(), "prefer")]),
    ),
    focus: check(focus, RULES.focus(planners), "focus"),
    layers: layerSet((key) => isOn(LAYERS[key].bit)),
    smooth: !isOn(UNSMOOTHED),
    playback: {
      ...playback,
      playing: false,
      base: check(base, RULES.base(), "base"),
      searchMode: check(searchMode ?? SEARCH_MODES[0], RULES.searchMode(), "searchMode"),
      fraction: check(numeral(fraction) / STEPS, RULES.playhead(), "playhead"),
    },
    camera: check<Camera | null>(cameraIn(place), RULES.camera(known), "camera"),
  };
}

function cameraIn(place: readonly string[]): unknown {
  if (place.length === 0) return null;
  const [x, y, scale] = place.map((text) => numeral(text) / FINE);
  return place.length === 3 ? { x, y, scale } : place;
}
