// @ts-check
// `parkade bench`.
import { Planner } from "../node.js";
import { choice, count, of, plannerIds, scenesAt } from "./input.js";
import { table, toJSON, write } from "./output.js";

/** @type {import("./commands.js").Run} */
export async function bench(places, values) {
  const format = choice("format", values.format, ["markdown", "csv", "json"]);
  const repeats = count("repeats", values.repeats, 25, 100_000);
  const scenes = await scenesAt(places),
    ids = plannerIds(values.planner, "four,eight,risk-field,hybrid");
  const racers = scenes.flatMap(({ place, scene }) =>
    ids.map((planner) => ({
      place,
      scene,
      planner,
      samples: /** @type {number[]} */ ([]),
      plan: planned(planner, { place, scene }).plan,
    })),
  );
  // The map is read and prepared anew for each plan, as on the page; rivals take turns, so that a busy moment hits all.
  for (let i = 0; i < repeats; i++)
    for (const { planner, samples, ...asked } of racers) samples.push(planned(planner, asked).millis);
  const results = racers.map(({ place, planner, samples, plan }) => ({
    ...(scenes.length > 1 && { scene: place }),
    planner,
    outcome: plan.outcome,
    verdict: plan.check.verdict,
    length: plan.metrics.length,
    directionChanges: plan.metrics.directionChanges,
    maxCurvature: plan.metrics.maxCurvature,
    minClearance: plan.metrics.minClearance,
    expanded: plan.stats.expanded,
    openPeak: plan.stats.openPeak,
    medianMs: quantile(samples, 0.5),
    q1Ms: quantile(samples, 0.25),
    q3Ms: quantile(samples, 0.75),
    n: samples.length,
    hash: plan.hash,
  }));
  await write(format === "json" ? toJSON(results, 2) : report(results, format));
  return results.some(({ outcome }) => outcome !== "found") ? 1 : 0;
}

/**
 * @param {import("../index.js").PlannerId} planner
 * @param {{ place: string, scene: import("../index.js").Scenario }} asked
 */
function planned(planner, { place, scene }) {
  const prepared = of(place, () => new Planner(planner, scene));
  const from = performance.now();
  const plan = prepared.plan();
  const millis = performance.now() - from;
  prepared.free();
  return { plan, millis };
}

/** @param {number[]} values @param {number} part */
function quantile(values, part) {
  const sorted = [...values].sort((a, b) => a - b),
    at = (sorted.length - 1) * part,
    low = Math.floor(at);
  const a = sorted[low] ?? 0,
    b = sorted[Math.min(low + 1, sorted.length - 1)] ?? a;
  return a + (b - a) * (at - low);
}

/** @param {Record<string, any>[]} results @param {"markdown" | "csv"} format */
function report(results, format) {
  const isNamed = results.some(({ scene }) => scene !== undefined);
  const head = [
    ...(isNamed ? ["scene"] : []),
    "planner",
    "outcome",
    "verdict",
    "length m",
    "gear changes",
    "max curvature 1/m",
    "min clearance m",
    "expanded",
    "open peak",
    "median ms",
    "q1 ms",
    "q3 ms",
    "n",
    "hash",
  ];
  const fixed = (/** @type {number | null} */ value, /** @type {number} */ digits) =>
    value === null ? "" : value.toFixed(digits);
  return table(
    head,
    results.map((one) => [
      ...(isNamed ? [one.scene] : []),
      one.planner,
      one.outcome,
      one.verdict,
      fixed(one.length, 2),
      one.directionChanges,
      fixed(one.maxCurvature, 4),
      fixed(one.minClearance, 3),
      one.expanded,
      one.openPeak,
      fixed(one.medianMs, 3),
      fixed(one.q1Ms, 3),
      fixed(one.q3Ms, 3),
      one.n,
      one.hash,
    ]),
    format,
  );
}
