import type { AuditRow } from "parkade";
import { changesBetween, distanceTo, isNear, sweepsNear, type SceneChanges } from "../scene/scene-changes";
import type { Scenario } from "../scene/scenario";
import { vehicleOf } from "../scene/vehicle";
import type { Store } from "../store";
import type { AskedVehicle, BayCheck } from "../store/bay-check";
import type { Engine } from "./engine-loader";
import { Helper } from "./job-client";
import { workersHere } from "./worker-count";
import { nth } from "../scene/nth";

/**
 * From a swept pose to something changed, metres. The body is a quarter of a metre from such a pose at most, and its
 * corners move one and a half times as far as its axle on the tightest arcs.
 */
const REACH = 0.45;
/** From the place that blocks a way to something changed, metres. */
const BLOCKING = 4;
/** Answers are told together: the table and the maps draw once for many. */
const TELL_MS = 80;
const MOST_AT_ONCE = 6;

/** What a worker of a test needs: one part of an audit. */
export interface BayWorker {
  ask(scene: Scenario, vehicle: AskedVehicle, bays: readonly number[], entries: readonly Entry[]): Promise<AuditRow[]>;
  stop(): void;
}

export function bayWorker(engine: Engine): BayWorker {
  const helper = new Helper(engine);
  return {
    ask: (scene, vehicle, bays, entries) =>
      helper.call("audit", {
        scene,
        options: { vehicles: [vehicle], bays: [...bays], entries: [...entries], whatIf: "each-free" },
      }),
    stop: () => helper.stop(),
  };
}

type Entry = AuditRow["entry"];
const ENTRIES: readonly Entry[] = ["head-in", "reverse-in"];

/** A question for a worker. */
interface Question {
  bay: number;
  entries: readonly Entry[];
}

export class BayChecker {
  private readonly workers: { worker: BayWorker; busy: boolean }[];
  private rows = new Map<number, readonly AuditRow[]>();
  /** Entries whose answers are those of an earlier scene. */
  private stale = new Map<number, readonly Entry[]>();
  private queue: Question[] = [];
  /** Unanswered questions of each bay that has some. */
  private pending = new Map<number, number>();
  private of = 0;
  /** Counts questions: answers to earlier ones are dropped. */
  private turn = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private scene: Scenario;

  constructor(
    private readonly store: Store,
    private readonly spawn: () => BayWorker,
    private readonly failed: (error: unknown) => void,
    private vehicle: AskedVehicle,
    count = workersHere(),
  ) {
    this.scene = store.state.scene;
    this.workers = Array.from({ length: count }, () => ({ worker: spawn(), busy: false }));
  }

  /** Asks all bays anew. */
  askAll(vehicle = this.vehicle): void {
    this.vehicle = vehicle;
    this.scene = this.store.state.scene;
    this.rows = new Map();
    this.begin(
      this.all().map((bay) => ({ bay, entries: ENTRIES })),
      new Map(),
    );
  }

  /** Asks again what an edit may have changed: first the ways that it touches, then the others. */
  follow(scene: Scenario): void {
    const changes = changesBetween(this.scene, scene);
    if (!changes.everywhere && changes.boxes.length === 0) return;
    const before = this.scene;
    this.scene = scene;
    const all = this.all();
    if ((before.slots ?? []).some((slot, i) => slot.id !== scene.slots?.[i]?.id)) this.rows = new Map();
    for (const index of this.rows.keys()) if (index >= all.length) this.rows.delete(index);
    const first: Question[] = [],
      then: Question[] = [];
    for (const bay of all) {
      const touched = [...this.touched(bay, changes), ...(this.stale.get(bay) ?? [])],
        entries = ENTRIES.filter((entry) => touched.includes(entry)),
        others = ENTRIES.filter((entry) => !entries.includes(entry));
      if (entries.length > 0) first.push({ bay, entries });
      if (others.length > 0) then.push({ bay, entries: others });
    }
    const stale = new Map(first.map(({ bay, entries }) => [bay, entries]));
    this.begin([...this.nearestFirst(first, changes), ...then], stale);
  }

  stop(): void {
    this.turn++;
    clearTimeout(this.timer);
    for (const { worker } of this.workers) worker.stop();
    this.workers.length = 0;
  }

  /** Those next to what changed, where people look, before those that are only passed by on the way. */
  private nearestFirst(questions: readonly Question[], { boxes }: SceneChanges): Question[] {
    const farOf = ({ bay }: Question): number => {
      const { x, y } = nth(this.scene.slots!, bay);
      return Math.min(...boxes.map((box) => distanceTo([x, y], box)));
    };
    const far = new Map(questions.map((question) => [question, farOf(question)]));
    return [...questions].sort((a, b) => far.get(a)! - far.get(b)! || a.bay - b.bay);
  }

  private all(): number[] {
    return (this.scene.slots ?? []).map((_, index) => index);
  }

  /** The entries of a bay whose ways an edit touches. */
  private touched(index: number, { everywhere, boxes, slots }: SceneChanges): readonly Entry[] {
    const rows = this.rows.get(index);
    if (everywhere || !rows || slots.has(nth(this.scene.slots!, index).id ?? "")) return ENTRIES;
    const vehicle = vehicleOf(this.vehicle.vehicle);
    const isTouched = (way: AuditRow | NonNullable<AuditRow["out"]>): boolean =>
      sweepsNear(way.swept, vehicle, boxes, REACH) ||
      (!way.reachable && (!way.place || boxes.some((box) => isNear(way.place!, box, BLOCKING))));
    return rows.filter((row) => isTouched(row) || (row.out && isTouched(row.out))).map(({ entry }) => entry);
  }

  private begin(queue: Question[], stale: Map<number, readonly Entry[]>): void {
    this.turn++;
    this.queue = queue;
    this.stale = stale;
    this.pending = new Map();
    for (const { bay } of queue) this.pending.set(bay, (this.pending.get(bay) ?? 0) + 1);
    this.of = this.pending.size;
    this.tell();
    // A worker that still reckons the scene before would hold up the first answers.
    for (const member of this.workers.filter(({ busy }) => busy)) {
      member.worker.stop();
      member.worker = this.spawn();
      member.busy = false;
    }
    for (const member of this.workers) void this.work(member);
  }

  private async work(member: { worker: BayWorker; busy: boolean }): Promise<void> {
    const { turn } = this;
    member.busy = true;
    while (turn === this.turn && this.queue.length > 0) {
      // Single bays first and last: so that something is seen soon, and no worker ends long after the others.
      const share = Math.ceil(this.queue.length / (3 * this.workers.length)),
        { bay, entries } = nth(this.queue, 0),
        isFirst = this.stale.has(bay) || this.rows.size === 0,
        most = isFirst ? 1 : Math.min(MOST_AT_ONCE, share),
        other = this.queue.findIndex(
          (question) => question.entries.length !== entries.length || question.entries[0] !== entries[0],
        ),
        bays = this.queue.splice(0, other < 0 ? most : Math.min(most, other)).map((question) => question.bay);
      try {
        const rows = await member.worker.ask(this.scene, this.vehicle, bays, entries);
        if (turn !== this.turn) return;
        for (const index of bays) {
          this.take(
            index,
            rows.filter((row) => row.index === index),
          );
          const old = (this.stale.get(index) ?? []).filter((entry) => !entries.includes(entry));
          if (old.length > 0) this.stale.set(index, old);
          else this.stale.delete(index);
          const left = (this.pending.get(index) ?? 0) - 1;
          if (left > 0) this.pending.set(index, left);
          else this.pending.delete(index);
        }
      } catch (error) {
        if (turn !== this.turn) return;
        // Nobody waits for what is not asked any more.
        this.queue = [];
        this.of -= this.pending.size;
        this.pending.clear();
        this.failed(error);
      }
      this.timer ??= setTimeout(() => this.tell(), TELL_MS);
    }
    if (turn !== this.turn) return;
    member.busy = false;
    if (this.workers.every(({ busy }) => !busy)) this.tell();
  }

  /** Puts answers in place of those that the bay has to the same entries. */
  private take(bay: number, rows: readonly AuditRow[]): void {
    const known = [...rows, ...(this.rows.get(bay) ?? [])],
      of = (entry: Entry): AuditRow | undefined => known.find((row) => row.entry === entry);
    this.rows.set(
      bay,
      ENTRIES.map(of).filter((row) => row !== undefined),
    );
  }

  private tell(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const now = this.store.state.bays,
      done = this.of - this.pending.size;
    if (!now) return;
    const bays: BayCheck = {
      ...now,
      vehicle: this.vehicle,
      rows: new Map(this.rows),
      stale: new Set(this.stale.keys()),
      done,
      of: this.of,
    };
    this.store.gather({ bays });
  }
}
