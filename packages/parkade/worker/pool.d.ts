/** A holder keeps a worker as long as it wants, but gives it up at rest when others wait. */
export interface Holder {
  readonly busy: boolean;
  /**
   * The group it belongs to: workers at rest go to another group before a new one is started, within a group only at
   * the limit.
   */
  readonly of: object;
  /** The worker is another's from now on. */
  revoked(): void;
}

/**
 * The workers of a page at most: as many as there are processors, but enough for every planner of a comparison and few
 * for any page.
 */
export function mostWorkers(processors: number): number;

/** Milliseconds for which workers are kept when nobody has one: a reader comes to the next figure in this time. */
export const KEPT_MS: number;

/** Workers that are started when they are asked for, kept, and shared. */
export class WorkerPool<W extends { terminate(): void } = Worker> {
  /** `most`: workers at the same time; in pages `mostWorkers(navigator.hardwareConcurrency)` by default. */
  constructor(spawn: () => W, most?: number);
  /** Workers that run now. */
  readonly size: number;
  /**
   * Gives a worker now or as soon as one is free: one that nobody has, or that another group has at rest, sooner than a
   * new one, which takes longer to start than most plans take. Holders of one group keep theirs, with the scene they
   * hold.
   */
  lease(holder: Holder, give: (worker: W) => void): void;
  /** The holder is at rest: others may have its worker. */
  rested(holder: Holder): void;
  /** Gives a worker back that can be used again. */
  release(holder: Holder): void;
  /**
   * Ends a holder's worker: a running plan that cannot be asked stops in no other way, and after a trap it is of no
   * use.
   */
  drop(holder: Holder): void;
  /** Nobody will begin with this pool any more: workers go as they are given back. */
  retire(): void;
}
