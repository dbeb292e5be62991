import type { AuditRow } from "parkade";
import { changesBetween, grown, isNear, sweepsNear, type SceneChanges } from "../scene/scene-changes";
import type { Scenario } from "../scene/scenario";
import { vehicleOf } from "../scene/vehicle";
import type { Store } from "../store";
import type { AskedVehicle, BayCheck } from "../store/bay-check";
import type { Engine } from "./engine-loader";
import { Helper } from "./job-client";
import { workersHere } from "./worker-count";
import { nth } from "../scene/nth";

/** From a path to something changed: within it, another path may be better. Metres. */
const REACH = 0.5;
/** From the place that blocks a way to something changed, metres. */
const BLOCKING = 4;
/** Answers are told together: the table and the maps draw once for many. */
const TELL_MS = 80;
const MOST_AT_ONCE = 6;

/** What a worker of a test needs: one part of an audit. */
export interface BayWorker {
  ask(scene: Scenario, vehicle: AskedVehicle, bays: readonly number[]): Promise<AuditRow[]>;
  stop(): void;
}

export function bayWorker(engine: Engine): BayWorker {
  const helper = new Helper(engine);
  return {
    ask: (scene, vehicle, bays) =>
      helper.call("audit", { scene, options: { vehicles: [vehicle], bays: [...bays], whatIf: "each-free" } }),
    stop: () => helper.stop(),
  };
}

export class BayChecker {
  private readonly workers: { worker: BayWorker; busy: boolean }[];
  private rows = new Map<number, readonly AuditRow[]>();
  private stale = new Set<number>();
  private queue: number[] = [];
  /** Bays asked and not yet answered. */
  private asked = new Set<number>();
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
    this.begin(this.all(), new Set());
  }

  /** Asks again what an edit may have changed: first the bays that it touches, then the others. */
  follow(scene: Scenario): void {
    const changes = changesBetween(this.scene, scene);
    if (!changes.everywhere && changes.boxes.length === 0) return;
    const before = this.scene;
    this.scene = scene;
    const all = this.all();
    if ((before.slots ?? []).some((slot, i) => slot.id !== scene.slots?.[i]?.id)) this.rows = new Map();
    for (const index of this.rows.keys()) if (index >= all.length) this.rows.delete(index);
    const touched = new Set(all.filter((index) => this.isTouched(index, changes)));
    this.begin(
      [...touched, ...all.filter((index) => !touched.has(index))],
      new Set([...touched, ...[...this.stale].filter((index) => index < all.length)]),
    );
  }

  stop(): void {
    this.turn++;
    clearTimeout(this.timer);
    for (const { worker } of this.workers) worker.stop();
    this.workers.length = 0;
  }

  private all(): number[] {
    return (this.scene.slots ?? []).map((_, index) => index);
  }

  private isTouched(index: number, { everywhere, boxes, slots }: SceneChanges): boolean {
    const rows = this.rows.get(index);
    if (everywhere || !rows || slots.has(nth(this.scene.slots!, index).id ?? "")) return true;
    const vehicle = vehicleOf(this.vehicle.vehicle);
    return rows.some((row) =>
      [row, row.out].some(
        (way) =>
          way &&
          (sweepsNear(way.swept, vehicle, boxes, REACH) ||
            (!way.reachable && (!way.place || boxes.some((box) => isNear(way.place!, grown(box, 0), BLOCKING))))),
      ),
    );
  }

  private begin(queue: number[], stale: Set<number>): void {
    this.turn++;
    this.queue = queue;
    this.stale = stale;
    this.of = queue.length;
    this.asked = new Set();
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
        isFirst = this.stale.has(nth(this.queue, 0)) || this.rows.size === 0;
      const bays = this.queue.splice(0, isFirst ? 1 : Math.min(MOST_AT_ONCE, share));
      for (const bay of bays) this.asked.add(bay);
      try {
        const rows = await member.worker.ask(this.scene, this.vehicle, bays);
        if (turn !== this.turn) return;
        for (const bay of bays) {
          this.rows.set(
            bay,
            rows.filter(({ index }) => index === bay),
          );
          this.stale.delete(bay);
          this.asked.delete(bay);
        }
      } catch (error) {
        if (turn !== this.turn) return;
        this.queue = [];
        this.failed(error);
      }
      this.timer ??= setTimeout(() => this.tell(), TELL_MS);
    }
    if (turn !== this.turn) return;
    member.busy = false;
    if (this.workers.every(({ busy }) => !busy)) this.tell();
  }

  private tell(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const now = this.store.state.bays,
      done = this.of - this.queue.length - this.asked.size;
    if (!now) return;
    const bays: BayCheck = {
      ...now,
      vehicle: this.vehicle,
      rows: new Map(this.rows),
      stale: new Set(this.stale),
      done,
      of: this.of,
    };
    this.store.gather({ bays });
  }
}
