import type { WorkerLike } from "./planner-queue";

/** A holder keeps a worker as long as it wants, but gives it up at rest when others wait. */
export interface Holder {
  readonly busy: boolean;
  /** The playground whose planner it is. */
  readonly of: object;
  /** The worker is another's from now on. */
  revoked(): void;
}

/** The workers of a page at most: as many as there are processors, but enough for every planner of a comparison and few for any page. */
export const mostWorkers = (processors: number): number => Math.min(8, Math.max(6, processors));

/** How long workers are kept when nobody has one: a reader comes to the next figure in this time. */
export const KEPT_MS = 60_000;

interface Member {
  worker: WorkerLike;
  holder: Holder | null;
}

/** The workers of all playgrounds of a page that plan with one module. */
export class WorkerPool {
  private members: Member[] = [];
  private leaving: ReturnType<typeof setTimeout> | undefined;
  private retired = false;
  private waiting: { holder: Holder; give: (worker: WorkerLike) => void }[] = [];

  constructor(
    private readonly spawn: () => WorkerLike,
    private readonly most = mostWorkers(navigator.hardwareConcurrency || 1),
  ) {}

  get size(): number {
    return this.members.length;
  }

  /**
   * Gives a worker now or as soon as one is free: one that nobody has, or that another playground has at rest, sooner than a new
   * one, which takes longer to start than most plans take. A playground's own planners keep theirs, with the scene they hold.
   */
  lease(holder: Holder, give: (worker: WorkerLike) => void): void {
    this.forget(holder);
    const member =
      this.members.find((one) => one.holder === null) ??
      this.take((other) => other.of !== holder.of) ??
      this.grow() ??
      this.take(() => true);
    if (!member) {
      this.waiting.push({ holder, give });
      return;
    }
    // Whoever had it longest at rest is asked first.
    this.members = [...this.members.filter((one) => one !== member), member];
    member.holder = holder;
    give(member.worker);
  }

  /** The holder is at rest: others may have its worker. */
  rested(holder: Holder): void {
    if (this.waiting.length === 0) return;
    holder.revoked();
    this.release(holder);
  }

  /** Gives a worker back that can be used again. */
  release(holder: Holder): void {
    this.forget(holder);
    for (const member of this.members) if (member.holder === holder) member.holder = null;
    this.serve();
    if (this.retired) this.dismiss();
    else if (this.members.every((one) => one.holder === null)) this.empty();
  }

  /** Nobody will begin with this module any more: workers go as they are given back. */
  retire(): void {
    this.retired = true;
    this.dismiss();
  }

  /** Ends a holder's worker: a running plan stops in no other way, and after a trap it is of no use. */
  drop(holder: Holder): void {
    this.forget(holder);
    for (const { worker } of this.members.filter((one) => one.holder === holder)) worker.terminate();
    this.members = this.members.filter((one) => one.holder !== holder);
    this.serve();
  }

  /** Workers at rest are kept while some playground is at work, and a little longer: a reader scrolls on to the next. */
  private empty(): void {
    clearTimeout(this.leaving);
    this.leaving = setTimeout(() => {
      if (this.members.every((one) => one.holder === null)) this.dismiss();
    }, KEPT_MS);
  }

  private dismiss(): void {
    for (const { worker } of this.members.filter((one) => one.holder === null)) worker.terminate();
    this.members = this.members.filter((one) => one.holder !== null);
  }

  private forget(holder: Holder): void {
    this.waiting = this.waiting.filter((one) => one.holder !== holder);
  }

  private serve(): void {
    while (
      this.waiting.length > 0 &&
      (this.members.length < this.most || this.members.some((one) => one.holder === null))
    ) {
      const { holder, give } = this.waiting.shift()!;
      this.lease(holder, give);
    }
  }

  private grow(): Member | null {
    if (this.members.length >= this.most) return null;
    const member = { worker: this.spawn(), holder: null };
    this.members.push(member);
    return member;
  }

  private take(from: (holder: Holder) => boolean): Member | undefined {
    const member = this.members.find(({ holder }) => holder && !holder.busy && from(holder));
    member?.holder?.revoked();
    return member;
  }
}
