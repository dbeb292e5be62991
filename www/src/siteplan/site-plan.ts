import type { SitePlan, SitePlanLine } from "parkade/siteplan";
import type { Point } from "../scene/geometry";
import { lastIn, nth } from "../scene/nth";
import { rule } from "../i18n/rule";
import type { Said } from "../i18n/said";

export type SitePlanKind = SitePlan["kind"];

/** Why a file is no site plan. */
export class SitePlanError extends Error {
  readonly code = "bad-import";
  readonly template: string;
  readonly values: readonly string[];
  /** `line`: of the file, from 1; absent where the reason has no place. */
  constructor(
    { message, template = message, values = [] }: Said,
    readonly line?: number,
  ) {
    super(message);
    this.name = "SitePlanError";
    this.template = template;
    this.values = values;
  }
}

/** What a page can hold while somebody chooses layers; a file beyond is refused before it fills the memory. */
export const MOST_BYTES = 64_000_000,
  MOST_PLAN_POINTS = 200_000,
  MOST_LAYERS = 200;

/** No point of a plan is further from the origin, units of the file: sums stay exact to a millimetre. */
const FURTHEST = 1e9;

/** Collects lines by layer within the limits. */
export class PlanBuilder {
  private readonly layers = new Map<string, SitePlanLine[]>();
  private readonly skipped = new Map<string, number>();
  private count = 0;

  /** Lines of fewer than two points are nothing. `line`: where in the file, for the reason of a refusal. */
  add(layer: string, points: readonly Point[], closed: boolean, line?: number): void {
    const kept = withoutRepeats(points, closed);
    if (kept.length < 2) return;
    for (const [x, y] of kept)
      if (!(Math.abs(x) <= FURTHEST && Math.abs(y) <= FURTHEST))
        throw new SitePlanError(rule`coordinates must be at most ${FURTHEST} units, got ${x}, ${y}`, line);
    this.count += kept.length;
    if (this.count > MOST_PLAN_POINTS)
      throw new SitePlanError(rule`a site plan must have at most ${MOST_PLAN_POINTS} points`, line);
    const lines = this.layers.get(layer) ?? [];
    if (lines.length === 0 && this.layers.size === MOST_LAYERS)
      throw new SitePlanError(rule`a site plan must have at most ${MOST_LAYERS} layers`, line);
    this.layers.set(layer, lines);
    lines.push({ points: kept, closed: closed && kept.length > 2 });
  }

  skip(what: string): void {
    this.skipped.set(what, (this.skipped.get(what) ?? 0) + 1);
  }

  build(kind: SitePlanKind, metresPerUnit: number | null): SitePlan {
    if (this.layers.size === 0) throw new SitePlanError(rule`the file holds no lines that can be read`);
    const layers = [...this.layers].map(([name, lines]) => ({ name, lines }));
    const left = [...this.skipped].map(([what, n]) => `${what} (${n})`);
    return { kind, layers, metresPerUnit, notes: left.length > 0 ? [`Left out: ${left.join(", ")}`] : [] };
  }
}

/** Closer ends are one point, as a part of the coordinates' size. */
const SAME = 1e-9;

function withoutRepeats(points: readonly Point[], closed: boolean): Point[] {
  const isSame = (a: Point, b: Point): boolean =>
    Math.abs(a[0] - b[0]) + Math.abs(a[1] - b[1]) <= SAME * (1 + Math.abs(a[0]) + Math.abs(a[1]));
  const kept = points.filter((point, i) => i === 0 || !isSame(point, nth(points, i - 1)));
  if (closed && kept.length > 1 && isSame(nth(kept, 0), lastIn(kept))) kept.pop();
  return kept;
}
