export interface Progress {
  done: number;
  of: number;
}

/** How many workers measure: at least two, for the bar to move; at most four, for the page to stay quick. */
export const workersHere = (): number => Math.min(4, Math.max(2, navigator.hardwareConcurrency || 2));
