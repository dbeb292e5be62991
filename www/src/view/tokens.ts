/** The colours and the font of the drawing, read from the element's `--parkade-*` custom properties. */
import type { PlannerId } from "parkade";
import { drivesCar, identityOf } from "../styles/planner-style";

export const COLOUR_NAMES = [
  "app",
  "panel",
  "floor",
  "out",
  "raise",
  "hover",
  "press",
  "hair",
  "hair2",
  "gridl",
  "t1",
  "t2",
  "t3",
  "accent",
  "accent-soft",
  "obs",
  "obs-edge",
  "parked",
  "slot",
  "arrow",
  "err",
  "err-soft",
  "warn",
  "warn-soft",
] as const;
export type ColourName = (typeof COLOUR_NAMES)[number];

export interface Tokens {
  dark: boolean;
  colour: Record<ColourName, string>;
  planner: readonly string[];
  font: string;
  /** Caches compare tokens by it. */
  key: string;
}

const LIGHT =
  "#F4F4F2 #FFFFFF #FFFFFF #ECECE9 #FFFFFF #F0F0ED #E6E6E2 #E3E3DF #CFCFCA #F1F1EE #1B1D20 #565B62 #64696F #4B45D6 " +
  "#ECEBFC " +
  "#B4B8BE #3F444B #D5D8DC #7D838B #5F666F #B3261E #FBECEA #8A5300 #FBF1E0";
const DARK =
  "#0E1013 #15181C #15181C #0B0D0F #1F2329 #20252B #2A3037 #272C33 #3A414A #1B1F24 #ECEEF0 #A9B0B8 #8B929B #9A97FF " +
  "#26264A " +
  "#4C535C #A3AAB3 #343A42 #858C95 #A2A9B2 #FF8A80 #3A1F1E #E8B45A #332915";
const PLANNERS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#6A6A6A", "#8C6D00"];
const FONT =
  'system-ui, -apple-system, "Segoe UI", Roboto, "PingFang SC", "Microsoft YaHei", "Noto Sans SC", sans-serif';
/** Names pages may set instead of ours. */
const ALIASES: Partial<Record<ColourName, string>> = { floor: "bg", t1: "fg", obs: "obstacle" };

/** Colours as CSS writes them; `dark` picks the defaults for what is not set. */
export function makeTokens(dark: boolean, read: (name: string) => string = () => ""): Tokens {
  const defaults = (dark ? DARK : LIGHT).split(" ");
  const colour = {} as Record<ColourName, string>;
  COLOUR_NAMES.forEach((name, i) => {
    const alias = ALIASES[name];
    colour[name] = read(name) || (alias ? read(alias) : "") || defaults[i]!;
  });
  const planner = PLANNERS.map((value, i) => read(`planner-${i + 1}`) || value);
  const font = read("font") || FONT;
  return { dark, colour, planner, font, key: [...Object.values(colour), ...planner, font].join() };
}

/** Tokens in force at `element`. */
export function readTokens(element: Element): Tokens {
  const style = getComputedStyle(element);
  const read = (name: string): string => style.getPropertyValue(`--parkade-${name}`).trim();
  const floor = parseColour(read("floor") || read("bg"));
  const dark = floor ? luminance(floor) < 0.3 : style.colorScheme === "dark";
  return makeTokens(dark, read);
}

export type Rgb = [number, number, number];

/** `#rgb`, `#rrggbb` and `rgb(…)`; null for anything else. */
export function parseColour(text: string): Rgb | null {
  const hex = /^#([0-9a-f]{3}|[0-9a-f]{6})$/i.exec(text.trim())?.[1];
  if (hex) {
    const full = hex.length === 3 ? [...hex].map((c) => c + c).join("") : hex;
    return [0, 2, 4].map((i) => parseInt(full.slice(i, i + 2), 16)) as Rgb;
  }
  const parts = /^rgba?\(([^)]+)\)$/i
    .exec(text.trim())?.[1]
    ?.split(/[\s,/]+/)
    .map(Number);
  return parts && parts.length >= 3 && parts.slice(0, 3).every(Number.isFinite) ? (parts.slice(0, 3) as Rgb) : null;
}

const luminance = ([r, g, b]: Rgb): number => (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;

const made = new Map<string, string>();

/** Colours are made once: every frame asks for the same few. */
function memoised(key: string, make: () => string): string {
  const known = made.get(key);
  if (known !== undefined) return known;
  if (made.size > 500) made.clear();
  const colour = make();
  made.set(key, colour);
  return colour;
}

/** `share` of `colour` laid on `ground`. */
export function mix(colour: string, ground: string, share: number): string {
  return memoised(`${colour}|${ground}|${share}`, () => {
    const a = parseColour(colour),
      b = parseColour(ground);
    if (!a || !b) return colour;
    return `rgb(${a.map((v, i) => Math.round(v * share + b[i]! * (1 - share))).join(" ")})`;
  });
}

export function fade(colour: string, alpha: number): string {
  return memoised(`${colour}|${alpha}`, () => {
    const rgb = parseColour(colour);
    return rgb ? `rgb(${rgb.join(" ")} / ${alpha})` : colour;
  });
}

/** Colour, dash and width by which a planner is known, the same everywhere. */
export interface PlannerStyle {
  colour: string;
  dash: readonly number[];
  width: number;
  hybrid: boolean;
}

export function plannerStyle(tokens: Tokens, planner: PlannerId): PlannerStyle {
  const { colour, dash } = identityOf(planner),
    drives = drivesCar(planner);
  return { colour: tokens.planner[colour - 1] ?? tokens.colour.t1, dash, width: drives ? 3 : 2, hybrid: drives };
}
