import type { WorkerLike } from "./lane";

/** Who has a worker for as long as it wants, but gives it up at rest when others wait. */
export interface Holder {
  readonly busy: boolean;
  /** The worker is another's from now on. */
  revoked(): void;
}

/** Enough for every planner of a comparison at once, few enough for a page of many playgrounds. */
export const MOST_WORKERS = 8;

/** How long workers are kept when nobody has one. */
export const KEPT_MS = 5000;

interface Member { worker: WorkerLike; holder: Holder | null }

/** The workers of all playgrounds of a page that plan with one module. */
export class WorkerPool {
  private members: Member[] = [];
  private leaving: ReturnType<typeof setTimeout> | undefined;
  private waiting: { holder: Holder; give: (worker: WorkerLike) => void }[] = [];

  constructor(private readonly spawn: () => WorkerLike, private readonly most = MOST_WORKERS) {}

  get size(): number {
    return this.members.length;
  }

  /** Gives a worker now or as soon as one is free. */
  lease(holder: Holder, give: (worker: WorkerLike) => void): void {
    const member = this.members.find((one) => one.holder === null) ?? this.grow() ?? this.take();
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
    if (this.members.every((one) => one.holder === null)) this.empty();
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
      if (this.members.some((one) => one.holder !== null)) return;
      for (const { worker } of this.members) worker.terminate();
      this.members = [];
    }, KEPT_MS);
  }

  private forget(holder: Holder): void {
    this.waiting = this.waiting.filter((one) => one.holder !== holder);
  }

  private serve(): void {
    while (this.waiting.length > 0 && (this.members.length < this.most || this.members.some((one) => one.holder === null))) {
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

  private take(): Member | undefined {
    const member = this.members.find((one) => one.holder && !one.holder.busy);
    member?.holder?.revoked();
    return member;
  }
}
