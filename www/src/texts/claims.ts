/** Sentences of the papers' claims, from their figures. The documentation makes them by the same function. */
import type { PaperClaim } from "parkade";

/** Decimals of a claim's figures. */
const DIGITS: Readonly<Record<string, number>> = { K1: 2, K2: 2, K5: 1, R3: 2, R5: 1 };
/** Of the papers on grids, which give ratios, and of the others. */
const RATIO = 3;
/** Figures that are counts, and one that is a ratio among counts. */
const OWN_DIGITS: Readonly<Record<string, number>> = { maps: 0, none: 0, longer: 0, rows: 0, shorter: 0, worst: 2 };

const digitsOf = (id: string, name: string): number => OWN_DIGITS[name] ?? DIGITS[id] ?? (/^[HY]/.test(id) ? RATIO : 0);

export interface Wording {
  /** With a place for each figure; what stands in brackets is left out where its figures are not there. */
  template: string;
  /** `{low} to {high}`. */
  range: string;
  missing: string;
  number(value: number, digits: number): string;
}

/** What is found, as a sentence. */
export function foundText({ id, figures }: PaperClaim, { template, range, missing, number }: Wording): string {
  const figure = (name: string): string => {
    const value = figures[name],
      show = (one: number): string => number(one, digitsOf(id, name));
    if (value == null) return missing;
    const [low, high] = typeof value === "number" ? [show(value), show(value)] : value.map(show);
    return low === high ? low! : range.replace("{low}", low!).replace("{high}", high!);
  };
  return template
    .replace(/\[([^\]]*)\]/g, (_, part: string) =>
      [...part.matchAll(/\{(\w+)\}/g)].every(([, name]) => figures[name!] != null) ? part : "",
    )
    .replace(/\{(\w+)\}/g, (_, name: string) => figure(name));
}
