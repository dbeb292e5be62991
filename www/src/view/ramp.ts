/** The heat ramp: cividis in ten stops, early or cheap at the dark end. */
import { parseColour, type Rgb } from "./tokens";

export const RAMP_STOPS = [
  "#00224E",
  "#123570",
  "#3B496C",
  "#575D6D",
  "#707173",
  "#8A8678",
  "#A59C74",
  "#C3B369",
  "#E1CC55",
  "#FDE838",
];
export const RAMP_SIZE = 256;

const stops = RAMP_STOPS.map((stop) => parseColour(stop) as Rgb);

function sample(t: number): Rgb {
  const at = t * (stops.length - 1),
    i = Math.min(stops.length - 2, Math.floor(at)),
    part = at - i;
  return stops[i]!.map((v, k) => Math.round(v + (stops[i + 1]![k]! - v) * part)) as Rgb;
}

/** The ramp as 256 colours. */
export const RAMP: readonly Rgb[] = Array.from({ length: RAMP_SIZE }, (_, i) => sample(i / (RAMP_SIZE - 1)));

/** The ramp as little-endian RGBA words for an ImageData's buffer. */
export const RAMP_WORDS = Uint32Array.from(RAMP, ([r, g, b]) => (255 << 24) | (b << 16) | (g << 8) | r);
