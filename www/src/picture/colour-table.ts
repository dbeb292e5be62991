/// <reference path="./gifenc.d.ts" />
/** The colours of a GIF: at most 255 of them for all frames. */
import { quantize } from "gifenc";

/** Colours of a table; one more index is left for what stays. */
const COLOURS = 255;
/** So many of the commonest colours are kept to the bit: flat fills, whose tint shows most. */
const EXACT = 160;

/** Red, green and blue of an opaque pixel as one number. */
const key = (rgba: number): number => rgba & 0xffffff;

export class ColourTable {
  readonly colours: [red: number, green: number, blue: number][];
  private readonly known = new Map<number, number>();

  /** Of frames' pixels, 32 bits each: blue, green and red from the third byte down. */
  constructor(samples: readonly Uint32Array[]) {
    const counts = new Map<number, number>();
    for (const sample of samples) for (const pixel of sample) counts.set(key(pixel), (counts.get(key(pixel)) ?? 0) + 1);
    const common = [...counts].sort(([a, m], [b, n]) => n - m || a - b);
    const exact = (common.length > COLOURS ? common.slice(0, EXACT) : common).map(([one]) => one);
    const kept = new Set(exact),
      rest = common.length > COLOURS ? samples.map((sample) => sample.filter((pixel) => !kept.has(key(pixel)))) : [];
    this.colours = exact.map((one) => [one & 255, (one >> 8) & 255, (one >> 16) & 255]);
    exact.forEach((one, index) => this.known.set(one, index));
    const total = rest.reduce((sum, one) => sum + one.length, 0);
    if (total === 0) return;
    const all = new Uint32Array(total);
    rest.reduce((at, one) => {
      all.set(one, at);
      return at + one.length;
    }, 0);
    const others = quantize(new Uint8ClampedArray(all.buffer), COLOURS - EXACT, { format: "rgb565" });
    this.colours.push(...others.map(([red = 0, green = 0, blue = 0]): [number, number, number] => [red, green, blue]));
  }

  /** The index of the nearest colour. */
  indexOf(pixel: number): number {
    const known = this.known.get(key(pixel));
    if (known !== undefined) return known;
    const [red, green, blue] = [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255];
    let nearest = 0,
      least = Infinity;
    this.colours.forEach(([r, g, b], index) => {
      const distance = (r - red) ** 2 + (g - green) ** 2 + (b - blue) ** 2;
      if (distance < least) [nearest, least] = [index, distance];
    });
    this.known.set(key(pixel), nearest);
    return nearest;
  }
}
