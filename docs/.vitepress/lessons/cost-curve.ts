/** What a metre costs against the distance from obstacles, read from the planner's own layers. */
import type { MetricState } from "./metric-state";
import { word, type Lang } from "./words";

/** The plot: its place and size in pixels, and what its axes show. */
const LEFT = 520,
  TOP = 12,
  WIDE = 148,
  HIGH = 84,
  METRES = 6,
  COST = 6;

/** Samples a metre: nearer ones would be empty between the middles of cells. */
const FINE = 4;

/** The mean cost at each quarter of a metre of clearance. */
export function curveSamples({
  cost,
  clearance,
}: Pick<MetricState, "cost" | "clearance">): [metres: number, cost: number][] {
  if (!cost || !clearance) return [];
  const sums = Array.from({ length: FINE * METRES }, () => [0, 0] as [number, number]);
  cost.data.forEach((value, i) => {
    const bin = sums[Math.floor(FINE * clearance.data[i]!)];
    if (!bin || !Number.isFinite(value)) return;
    bin[0] += value;
    bin[1] += 1;
  });
  return sums.flatMap(([sum, count], i) => (count > 0 ? [[(i + 0.5) / FINE, sum / count] as [number, number]] : []));
}

export function costCurve(state: MetricState, lang: Lang): string {
  const px = (value: number): string => value.toFixed(1);
  const points = curveSamples(state).map(
    ([metres, cost]) => `${px(LEFT + (WIDE * metres) / METRES)} ${px(TOP + HIGH * (1 - Math.min(1, cost / COST)))}`,
  );
  const axis = `M${LEFT} ${TOP}v${HIGH}h${WIDE}`;
  const curve = points.length > 1 ? `<path class="lab-curve" d="M${points.join("L")}"/>` : "";
  return (
    `<g class="lab-plot"><rect ` +
    `x="${LEFT - 38}" y="${TOP - 8}" width="${WIDE + 46}" height="${HIGH + 32}"/><path d="${axis}"/>${curve}` +
    `<text x="${LEFT + WIDE / 2}" y="${TOP + HIGH + 17}">${word("distance", lang)}</text>` +
    `<text x="${LEFT - 19}" y="${TOP + 10}">${word("cost", lang)}</text></g>`
  );
}
