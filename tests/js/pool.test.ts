import { expect, it, vi } from "vitest";
import type { WorkerLike } from "../../www/src/planning/pool";
import { KEPT_MS, WorkerPool, mostWorkers, type Holder } from "../../www/src/planning/pool";

class Fake implements WorkerLike {
  onmessage = null;
  onerror = null;
  terminated = false;
  postMessage(): void {}
  terminate(): void {
    this.terminated = true;
  }
}

class Asker implements Holder {
  busy = true;
  worker: WorkerLike | null = null;
  constructor(readonly of: object) {}
  readonly take = (worker: WorkerLike): void => {
    this.worker = worker;
  };
  revoked(): void {
    this.worker = null;
  }
}

function setup(most: number) {
  const made: Fake[] = [];
  const pool = new WorkerPool(() => {
    const worker = new Fake();
    made.push(worker);
    return worker;
  }, most);
  const page = {};
  const ask = (of: object = page): Asker => {
    const asker = new Asker(of);
    pool.lease(asker, asker.take);
    return asker;
  };
  return { pool, made, ask };
}

it("has as many workers as there are processors, within what a comparison needs and a page can bear", () => {
  expect([1, 2, 7, 64].map(mostWorkers)).toEqual([6, 6, 7, 8]);
});

it(
  "lends what rests at one playground to another before it makes more, and leaves a playground's own planners " +
    "theirs",
  () => {
    const { made, ask } = setup(8);
    const here = {},
      there = {};
    const one = ask(here),
      two = ask(here);
    one.busy = two.busy = false;
    const own = ask(here);
    expect([made.length, one.worker, own.worker]).toEqual([3, made[0], made[2]]);
    const lent = [ask(there), ask(there), ask(there)];
    expect([made.length, one.worker, two.worker]).toEqual([4, null, null]);
    expect(lent.map(({ worker }) => made.indexOf(worker as Fake))).toEqual([0, 1, 3]);
    expect(own.worker).toBe(made[2]);
  },
);

it("makes no more workers than it may, and takes one from whoever rests", () => {
  const { made, ask } = setup(2);
  const one = ask(),
    two = ask();
  one.busy = false;
  const three = ask();
  expect([made.length, one.worker, two.worker, three.worker]).toEqual([2, null, made[1], made[0]]);
});

it("serves those that wait in turn, as soon as a holder rests", () => {
  const { pool, made, ask } = setup(1);
  const one = ask(),
    two = ask(),
    three = ask();
  expect([two.worker, three.worker]).toEqual([null, null]);
  one.busy = false;
  pool.rested(one);
  expect([one.worker, two.worker, three.worker]).toEqual([null, made[0], null]);
  pool.release(two);
  expect(three.worker).toBe(made[0]);
});

it("replaces a dropped worker for those that wait, and forgets who gave up waiting", () => {
  const { pool, made, ask } = setup(1);
  const one = ask(),
    two = ask(),
    three = ask();
  pool.release(two);
  pool.drop(one);
  expect([made[0]!.terminated, two.worker, three.worker]).toEqual([true, null, made[1]]);
});

it("keeps workers at rest while somebody is at work, and a little longer for who comes next", () => {
  vi.useFakeTimers();
  const { pool, made, ask } = setup(4);
  const one = ask(),
    two = ask();
  pool.release(one);
  expect([pool.size, made[0]!.terminated]).toEqual([2, false]);
  pool.release(two);
  vi.advanceTimersByTime(KEPT_MS - 1);
  expect(pool.size).toBe(2);
  const three = ask();
  vi.advanceTimersByTime(KEPT_MS);
  expect([pool.size, made.includes(three.worker as Fake)]).toEqual([2, true]);
  pool.release(three);
  vi.advanceTimersByTime(KEPT_MS);
  expect([pool.size, made.every((worker) => worker.terminated)]).toEqual([0, true]);
  vi.useRealTimers();
});

it("keeps no worker of a module that nobody begins with any more", () => {
  const { pool, made, ask } = setup(4);
  const [one, two, three] = [ask(), ask(), ask()];
  pool.release(one!);
  pool.retire();
  expect(made.map(({ terminated }) => terminated)).toEqual([true, false, false]);
  pool.release(two!);
  expect([pool.size, made[1]!.terminated, three!.worker]).toEqual([1, true, made[2]]);
  pool.drop(three!);
  // A playground that has not heard of the other module yet still plans.
  expect(ask().worker).toBe(made[3]);
});
