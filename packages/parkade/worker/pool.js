// @ts-check
// Workers shared by many planners; `pool.d.ts` documents it.

/**
 * A holder that asked for a worker while none was free.
 * @typedef {{ holder: import("./pool.js").Holder, give: (worker: any) => void }} Waiting
 */
/** @typedef {{ worker: any, holder: import("./pool.js").Holder | null }} Member */

/** @type {typeof import("./pool.js").mostWorkers} */
export const mostWorkers = (processors) => Math.min(8, Math.max(6, processors));

/** @type {number} */
export const KEPT_MS = 60_000;

export class WorkerPool {
  /** @type {Member[]} */
  #members = [];
  /** @type {Waiting[]} */
  #waiting = [];
  /** @type {any} */
  #leaving;
  #retired = false;
  #spawn;
  #most;

  /** @param {() => any} spawn @param {number} most */
  constructor(spawn, most = mostWorkers(navigator.hardwareConcurrency || 1)) {
    this.#spawn = spawn;
    this.#most = most;
  }

  get size() {
    return this.#members.length;
  }

  /** @type {import("./pool.js").WorkerPool<any>["lease"]} */
  lease(holder, give) {
    this.#forget(holder);
    const member =
      this.#members.find((one) => one.holder === null) ??
      this.#take((other) => other.of !== holder.of) ??
      this.#grow() ??
      this.#take(() => true);
    if (!member) {
      this.#waiting.push({ holder, give });
      return;
    }
    // Whoever had it longest at rest is asked first.
    this.#members = [...this.#members.filter((one) => one !== member), member];
    member.holder = holder;
    give(member.worker);
  }

  /** @type {import("./pool.js").WorkerPool<any>["rested"]} */
  rested(holder) {
    if (this.#waiting.length === 0) return;
    holder.revoked();
    this.release(holder);
  }

  /** @type {import("./pool.js").WorkerPool<any>["release"]} */
  release(holder) {
    this.#forget(holder);
    for (const member of this.#members) if (member.holder === holder) member.holder = null;
    this.#serve();
    if (this.#retired) this.#dismiss();
    else if (this.#members.every((one) => one.holder === null)) this.#empty();
  }

  /** @type {import("./pool.js").WorkerPool<any>["retire"]} */
  retire() {
    this.#retired = true;
    this.#dismiss();
  }

  /** @type {import("./pool.js").WorkerPool<any>["drop"]} */
  drop(holder) {
    this.#forget(holder);
    for (const { worker } of this.#members.filter((one) => one.holder === holder)) worker.terminate();
    this.#members = this.#members.filter((one) => one.holder !== holder);
    this.#serve();
  }

  /**
   * Workers at rest are kept while some holder is at work, and a little longer: a reader scrolls on to the next figure.
   */
  #empty() {
    clearTimeout(this.#leaving);
    this.#leaving = setTimeout(() => {
      if (this.#members.every((one) => one.holder === null)) this.#dismiss();
    }, KEPT_MS);
    // Node.js would wait for it.
    this.#leaving.unref?.();
  }

  #dismiss() {
    for (const { worker } of this.#members.filter((one) => one.holder === null)) worker.terminate();
    this.#members = this.#members.filter((one) => one.holder !== null);
  }

  /** @param {import("./pool.js").Holder} holder */
  #forget(holder) {
    this.#waiting = this.#waiting.filter((one) => one.holder !== holder);
  }

  #serve() {
    while (this.#members.length < this.#most || this.#members.some((one) => one.holder === null)) {
      const next = this.#waiting.shift();
      if (!next) return;
      this.lease(next.holder, next.give);
    }
  }

  /** @returns {Member | undefined} */
  #grow() {
    if (this.#members.length >= this.#most) return undefined;
    const member = { worker: this.#spawn(), holder: null };
    this.#members.push(member);
    return member;
  }

  /** @param {(holder: import("./pool.js").Holder) => boolean} from */
  #take(from) {
    const member = this.#members.find(({ holder }) => holder && !holder.busy && from(holder));
    member?.holder?.revoked();
    return member;
  }
}
