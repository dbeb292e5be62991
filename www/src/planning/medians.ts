/** The middle of measured times. */
import type { Timing } from "../store/results";

export const medians = (samples: readonly Timing[]): Timing => ({
  search: median(samples.map((one) => one.search)),
  total: median(samples.map((one) => one.total)),
});

export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
}
