import type { Pose, PoseTrace, SearchTrace } from "parkade";
import { nth, poseAt } from "../scene/nth";
import { keysOf } from "../scene/records";

export const STEP = {
  expand: 0,
  deferred: 1,
  rejected: 2,
  goal: 3,
  meet: 4,
  joined: 5,
  drawn: 6,
  candidate: 7,
} as const;
export const FATE = {
  kept: 0,
  improved: 1,
  dearer: 2,
  closed: 3,
  blocked: 4,
  corner: 5,
  heldBack: 6,
  requeued: 7,
  leftOut: 8,
  drawn: 9,
} as const;
export type FateName = keyof typeof FATE;
export const FATE_NAMES = keysOf(FATE);

/** Set in `fates` where the move leads from the node's parent, in `kinds` where the side from the goal is at work. */
const PAST = 16,
  BACKWARD = 16;
const NONE = 0;

/** An entry of the open list; `age` counts insertions of the whole search. */
export interface OpenEntry {
  node: number;
  f: number;
  g: number;
  h: number;
  age: number;
  deferred: boolean;
}

/** What one side knows. */
class Side {
  /** Per node the number of the entry that tells its cost, above 0 once it is reached. */
  readonly entry: Int32Array;
  readonly closed: Uint8Array;
  /** Entries that wait, in no order. */
  readonly open: number[] = [];

  constructor(nodes: number) {
    this.entry = new Int32Array(nodes);
    this.closed = new Uint8Array(nodes);
  }
}

export class SearchReplay {
  readonly steps: number;
  readonly events: number;
  /** Events done so far. */
  at = 0;
  private near = 0;
  readonly sides: readonly Side[];
  /** Per entry its place in its side's open list, or -1. Entries 1 and 2 are the roots, then one per move. */
  private readonly places: Int32Array;
  /** Per move the entry of its target before it. */
  private readonly before: Int32Array;
  /** Per step 1 where it closed the node for the other side as well, 2 where an open entry there ended with it. */
  private readonly closing: Uint8Array;
  /** Per node the entry of its deferred moves. */
  private readonly waiting: Int32Array | null;
  private readonly isNba: boolean;
  /** Names an obstacle of the scene by its index. */
  nameOf: (obstacle: number) => string = String;

  constructor(readonly trace: SearchTrace | PoseTrace) {
    const { nodes, targets, kinds, fates } = trace;
    this.steps = nodes.length;
    this.events = nodes.length + targets.length;
    let most = 0;
    for (const node of nodes) most = Math.max(most, node);
    for (const node of targets) most = Math.max(most, node);
    const count = most + 1;
    const both = kinds.some((kind) => kind >= BACKWARD);
    this.sides = both ? [new Side(count), new Side(count)] : [new Side(count)];
    this.places = new Int32Array(targets.length + 3).fill(-1);
    this.before = new Int32Array(targets.length);
    this.closing = new Uint8Array(nodes.length);
    this.waiting = fates.includes(FATE.requeued) ? new Int32Array(count) : null;
    this.isNba = kinds.some((kind) => (kind & 15) === STEP.rejected);
    this.sides.forEach((side, at) => {
      const first = this.kindsOf(at);
      if (first < 0) return;
      side.entry[nth(nodes, first)] = 1 + at;
      this.insert(side, 1 + at);
    });
  }

  private kindsOf(side: number): number {
    return this.trace.kinds.findIndex((kind) => kind >> 4 === side);
  }

  /** The step that the last event belongs to; -1 before the first. */
  get step(): number {
    return this.at === 0 ? -1 : this.stepOf(this.at - 1);
  }

  /** The step of an event. */
  stepOf(event: number): number {
    const { first } = this.trace;
    let low = 0,
      high = this.steps - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (nth(first, middle) + middle <= event) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** The number of events after which a step is done. */
  endOf(step: number): number {
    return step < 0 ? 0 : nth(this.trace.first, step + 1) + step + 1;
  }

  /** The move of the last event; -1 where it took an entry. */
  get move(): number {
    const { step } = this;
    if (step < 0) return -1;
    const move = this.at - 1 - step - 1;
    return move >= nth(this.trace.first, step) ? move : -1;
  }

  kindOf = (step: number): number => nth(this.trace.kinds, step) & 15;
  sideOf = (step: number): number => nth(this.trace.kinds, step) >> 4;
  fateOf = (move: number): FateName => nth(FATE_NAMES, nth(this.trace.fates, move) & 15);
  isPast = (move: number): boolean => (nth(this.trace.fates, move) & PAST) > 0;

  /** Goes to where so many events are done. */
  seek(event: number): void {
    const to = Math.min(this.events, Math.max(0, event));
    while (this.at < to) this.forward();
    while (this.at > to) this.backward();
  }

  private forward(): void {
    const event = this.at++;
    const step = this.stepAt(event),
      move = event - step - 1;
    if (move < nth(this.trace.first, step)) this.take(step);
    else this.offer(step, move);
  }

  private backward(): void {
    const event = --this.at;
    const step = this.stepAt(event),
      move = event - step - 1;
    if (move < nth(this.trace.first, step)) this.untake(step);
    else this.unoffer(step, move);
  }

  /** The step of an event near the last one asked for. */
  private stepAt(event: number): number {
    const { first } = this.trace;
    let step = this.near;
    while (step + 1 < this.steps && nth(first, step + 1) + step + 1 <= event) step++;
    while (nth(first, step) + step > event) step--;
    this.near = step;
    return step;
  }
  /** True if a step takes nothing from the open list: RRT's tree keeps its cells, a candidate is a whole path. */
  private takesNothing(step: number): boolean {
    return this.kindOf(step) >= STEP.drawn;
  }

  private take(step: number): void {
    if (this.takesNothing(step)) return;
    const node = nth(this.trace.nodes, step),
      turn = this.sideOf(step),
      side = nth(this.sides, turn);
    if (this.kindOf(step) === STEP.deferred) return this.remove(side, nth(this.waiting!, node));
    this.remove(side, nth(side.entry, node));
    side.closed[node] = 1;
    const other = this.isNba && this.sides[1 - turn];
    if (!other || other.closed[node]) return;
    const isOpen = other.entry[node] !== NONE;
    if (isOpen) this.remove(other, nth(other.entry, node));
    other.closed[node] = 1;
    this.closing[step] = isOpen ? 2 : 1;
  }

  private untake(step: number): void {
    if (this.takesNothing(step)) return;
    const node = nth(this.trace.nodes, step),
      turn = this.sideOf(step),
      side = nth(this.sides, turn);
    if (this.kindOf(step) === STEP.deferred) return this.insert(side, nth(this.waiting!, node));
    side.closed[node] = 0;
    this.insert(side, nth(side.entry, node));
    if (this.closing[step] === 0) return;
    const other = nth(this.sides, 1 - turn);
    other.closed[node] = 0;
    if (this.closing[step] === 2) this.insert(other, nth(other.entry, node));
    this.closing[step] = 0;
  }

  private offer(step: number, move: number): void {
    const fate = nth(this.trace.fates, move) & 15,
      target = nth(this.trace.targets, move),
      side = nth(this.sides, this.sideOf(step));
    if (fate === FATE.requeued) {
      this.waiting![target] = move + 3;
      return this.insert(side, move + 3);
    }
    if (fate > FATE.improved || this.kindOf(step) === STEP.goal) return;
    this.before[move] = nth(side.entry, target);
    if (side.entry[target] !== NONE) this.remove(side, nth(side.entry, target));
    side.entry[target] = move + 3;
    this.insert(side, move + 3);
  }

  private unoffer(step: number, move: number): void {
    const fate = nth(this.trace.fates, move) & 15,
      target = nth(this.trace.targets, move),
      side = nth(this.sides, this.sideOf(step));
    if (fate === FATE.requeued) return this.remove(side, move + 3);
    if (fate > FATE.improved || this.kindOf(step) === STEP.goal) return;
    this.remove(side, move + 3);
    side.entry[target] = nth(this.before, move);
    if (side.entry[target] !== NONE) this.insert(side, nth(side.entry, target));
  }

  private insert(side: Side, entry: number): void {
    this.places[entry] = side.open.length;
    side.open.push(entry);
  }

  private remove(side: Side, entry: number): void {
    const place = nth(this.places, entry),
      last = side.open.pop()!;
    if (last !== entry) {
      side.open[place] = last;
      this.places[last] = place;
    }
    this.places[entry] = -1;
  }

  /** An entry's place, costs and age. */
  entryOf(entry: number): OpenEntry {
    const { trace } = this;
    if (entry < 3) {
      const step = this.kindsOf(entry - 1);
      return {
        node: nth(trace.nodes, step),
        g: 0,
        h: nth(trace.h, step),
        f: nth(trace.f, step),
        age: 0,
        deferred: false,
      };
    }
    const move = entry - 3,
      deferred = (nth(trace.fates, move) & 15) === FATE.requeued;
    const g = nth(trace.targetG, move),
      h = nth(trace.targetH, move);
    return { node: nth(trace.targets, move), g, h, f: g + h + (deferred ? trace.penalty : 0), age: entry, deferred };
  }

  /**
   * The first entries of a side's open list in their order: least f, then the oldest, or least h and then the newest.
   */
  openList(side: number, count: number): OpenEntry[] {
    const first: OpenEntry[] = [];
    for (const number of this.sides[side]?.open ?? []) {
      const last = first.at(-1);
      if (first.length === count && last && this.priority(number) > last.f) continue;
      const entry = this.entryOf(number);
      let place = first.length;
      while (place > 0 && this.precedes(entry, nth(first, place - 1))) place--;
      if (place < count) first.splice(place, 0, entry);
      if (first.length > count) first.pop();
    }
    return first;
  }

  private priority(entry: number): number {
    if (entry < 3) return -Infinity;
    const { targetG, targetH, fates, penalty } = this.trace;
    return (
      nth(targetG, entry - 3) + nth(targetH, entry - 3) + ((nth(fates, entry - 3) & 15) === FATE.requeued ? penalty : 0)
    );
  }

  /** How many other entries had the f of the entry that a step took, and how many of these its h as well. */
  ties(step: number): { byF: number; byH: number } {
    const { f, h } = this.trace,
      side = this.sideOf(step);
    const after = this.at;
    // As it was when the entry was taken.
    this.seek(this.endOf(step - 1));
    let byF = -1,
      byH = -1;
    for (const number of nth(this.sides, side).open) {
      if (number > 2 && this.priority(number) !== f[step]) continue;
      const entry = this.entryOf(number);
      if (entry.f !== f[step]) continue;
      byF++;
      if (entry.h === h[step]) byH++;
    }
    this.seek(after);
    return { byF, byH };
  }

  /** What is known of a node: its costs, the node that it was reached from, whether it has been expanded. */
  known(side: number, node: number): (OpenEntry & { parent: number; closed: boolean }) | null {
    const one = this.sides[side],
      entry = one?.entry[node] ?? NONE;
    if (!one || entry === NONE) return null;
    return { ...this.entryOf(entry), parent: this.parentOf(side, entry), closed: one.closed[node] === 1 };
  }

  /** Where a node lies that has been reached; null over cells. */
  poseOf(side: number, node: number): Pose | null {
    const { trace } = this;
    if (trace.kind !== "poses") return null;
    const entry = this.sides[side]?.entry[node] ?? NONE;
    return entry < 3 ? nth(trace.roots, side) : this.poseAfter(entry - 3);
  }

  /** Where a move leads; null over cells. */
  poseAfter(move: number): Pose | null {
    return this.trace.kind === "poses" ? poseAt(this.trace.poses, move) : null;
  }

  /** The move that reached a node; -1 of the root and over nodes not reached. */
  moveTo(side: number, node: number): number {
    return Math.max(-1, (this.sides[side]?.entry[node] ?? NONE) - 3);
  }

  private precedes(a: OpenEntry, b: OpenEntry): boolean {
    if (a.f !== b.f) return a.f < b.f;
    if (this.trace.oldestFirst) return a.age < b.age;
    return a.h !== b.h ? a.h < b.h : a.age > b.age;
  }

  /** The cost of a move's target before the move improved it. */
  costBefore(move: number): number | null {
    const entry = this.before[move] ?? NONE;
    return entry === NONE ? null : this.entryOf(entry).g;
  }

  private parentOf(side: number, entry: number): number {
    if (entry < 3) return -1;
    const move = entry - 3;
    const step = this.stepOfMove(move),
      from = nth(this.trace.nodes, step);
    return this.isPast(move) ? this.parentOf(side, nth(nth(this.sides, side).entry, from)) : from;
  }

  /** The step in which a move was considered. */
  stepOfMove(move: number): number {
    const { first } = this.trace;
    let low = 0,
      high = this.steps - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (nth(first, middle) <= move) low = middle;
      else high = middle - 1;
    }
    return low;
  }
}
