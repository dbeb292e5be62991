import type { Playback, State, Store } from "../store";
import { durationOf } from "../view/playback-time";

const FIRST_DRIVE_SECONDS = 6;
const STEP = 0.02;

/** The most expansions any planner made: the length of the search's timeline when it counts them. */
export function mostExpanded(state: State): number {
  return Math.max(1, ...state.planners.map((planner) => state.results[planner]?.plan?.stats.expanded ?? 0));
}

/** Moves the playback's fraction with the clock. */
export class Player {
  loop = false;
  private frame = 0;
  private before = 0;
  /** Shortens the first drive in; 1 otherwise. */
  private hurry = 1;

  constructor(private readonly store: Store) {}

  toggle(): void {
    if (this.store.state.playback.playing) this.pause();
    else this.play();
  }

  play(): void {
    this.hurry = 1;
    const { fraction } = this.store.state.playback;
    this.set({ playing: true, fraction: fraction >= 1 ? 0 : fraction });
    this.run();
  }

  pause(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    if (this.store.state.playback.playing) this.set({ playing: false });
  }

  seek(fraction: number): void {
    const to = Math.min(1, Math.max(0, fraction));
    if (Number.isNaN(to)) throw new RangeError(`playhead: must be a number from 0 to 1, got ${fraction}`);
    this.pause();
    this.set({ fraction: to });
  }

  /** One step, or a tenth of the whole. */
  step(sign: 1 | -1, far = false): void {
    const { state } = this.store;
    const { base, searchMode, fraction } = state.playback;
    const counted = base === "search" && searchMode === "expansions";
    this.seek(fraction + sign * (far ? 0.1 : counted ? 1 / mostExpanded(state) : STEP));
  }

  /** Parks the cars once, in at most six seconds; people who want no motion see them parked. */
  driveIn(): void {
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    this.set({ base: "drive", fraction: 0, playing: true });
    this.hurry = Math.max(1, durationOf(this.store.state) / FIRST_DRIVE_SECONDS);
    this.run();
  }

  private run(): void {
    cancelAnimationFrame(this.frame);
    this.before = performance.now();
    this.frame = requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    const { state } = this.store;
    if (!state.playback.playing) return;
    const seconds = Math.max(0, now - this.before) / 1000;
    this.before = now;
    const rate = (state.playback.speed * this.hurry) / durationOf(state);
    const fraction = state.playback.fraction + seconds * rate;
    if (fraction >= 1 && !this.loop) {
      this.set({ fraction: 1, playing: false });
      return;
    }
    this.set({ fraction: fraction >= 1 ? 0 : fraction });
    this.frame = requestAnimationFrame((later) => this.tick(later));
  }

  set(patch: Partial<Playback>): void {
    this.store.set({ playback: { ...this.store.state.playback, ...patch } });
  }
}
