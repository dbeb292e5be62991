/** The page's store: what is drawn with its history, and everything that views follow. */
import { thingsOf, type Selection } from "../scene/selection";
import { inNextFrame } from "./animation-frame";
import { initialState, type Scene, type State } from "./state";

export * from "./state";

/** The steps behind and ahead of the scene, the nearest last. */
export interface History {
  past: readonly Scene[];
  scene: Scene;
  future: readonly Scene[];
}

export interface EditOptions {
  transient?: boolean;
  label?: string;
}
/** `previous` is the state of the notification before: no change is told twice, and none is left out. */
export type Listener = (state: State, previous: State) => void;

export interface Store {
  readonly state: State;
  set(patch: Partial<State>): void;
  /** The same, but notifies in the next frame, or with the next notification if that is sooner. */
  gather(patch: Partial<State>): void;
  /** Notifies of what is gathered. */
  tell(): void;
  /** Makes one notification of all changes, at once or as `gather` does; what follows from them is derived at once. */
  batch(run: () => void, gathers?: boolean): void;
  subscribe(listener: Listener): () => void;
  /**
   * The same before all listeners: what it sets is part of the notification that it is told of, and is told to all
   * derivers first.
   */
  derive(listener: Listener): () => void;
  /** Applies an edit and pushes one undo step; the edits of one drag (`transient`, then one final) are one step. */
  edit(next: Scene, options?: EditOptions): void;
  /** Gives up the drag that is going on; false where there is none. */
  cancelEdit(): boolean;
  /** Gives up the drag that is going on, or takes back the last step. */
  undo(): void;
  redo(): void;
  readonly history: History;
  /** Takes over a history from before a reload. */
  restore(history: History): void;
}

export const UNDO_STEPS = 500;
/** Pages out of sight get no frames. */
export const WITHOUT_FRAME_MS = 100;

export function createStore(initial: Partial<State> = {}): Store {
  return new SceneStore({ ...initialState(), ...initial });
}

class SceneStore implements Store {
  state: State;
  private readonly listeners = new Set<Listener>();
  private readonly derivers = new Set<Listener>();
  /** The state that the listeners know. */
  private told: State;
  /** The state that the derivers know. */
  private known: State;
  /** True if a change must not wait for the next frame. */
  private isDue = false;
  /** What is gathered is told then where no frame comes. */
  private late: ReturnType<typeof setTimeout> | undefined;
  /** Above 0 while changes wait: in a batch, and while listeners are told of one. */
  private holds = 0;
  private past: Scene[] = [];
  private future: Scene[] = [];
  /** Scenes that came whole, by `edit` with the label "open". */
  private readonly whole = new WeakSet<Scene>();
  /** The scene before the drag that is going on. */
  private dragFrom: Scene | null = null;

  constructor(state: State) {
    this.state = this.told = this.known = state;
  }

  set(patch: Partial<State>): void {
    if (this.change(patch)) this.tell();
  }

  gather(patch: Partial<State>): void {
    if (this.change(patch)) this.tellInFrame();
  }

  readonly tell = (): void => {
    clearTimeout(this.late);
    this.late = undefined;
    this.isDue = this.told !== this.state;
    this.batch(() => {});
  };

  batch(run: () => void, gathers = false): void {
    this.holds++;
    try {
      run();
      if (gathers && this.holds === 1 && this.isDue) {
        this.derived();
        this.isDue = false;
        this.tellInFrame();
      }
      while (this.holds === 1 && this.isDue) {
        const previous = this.told,
          state = (this.told = this.derived());
        this.isDue = false;
        for (const listener of [...this.listeners]) listener(state, previous);
      }
    } finally {
      this.holds--;
    }
  }

  subscribe(listener: Listener): () => void {
    return heard(this.listeners, listener);
  }

  derive(listener: Listener): () => void {
    return heard(this.derivers, listener);
  }

  edit(next: Scene, options: EditOptions = {}): void {
    const before = this.dragFrom ?? this.state.scene;
    if (options.transient) {
      this.dragFrom = before;
      this.set({ scene: next, transient: true, reason: options.label ?? "edit" });
      return;
    }
    this.dragFrom = null;
    if (next !== before) {
      this.past.push(before);
      if (this.past.length > UNDO_STEPS) this.past.shift();
      this.future.length = 0;
    }
    if (options.label === "open") this.whole.add(next);
    this.apply(next, options.label ?? "edit", options.label === "open");
  }

  cancelEdit(): boolean {
    const from = this.dragFrom;
    this.dragFrom = null;
    if (from) this.apply(from, "undo");
    return from !== null;
  }

  undo(): void {
    if (!this.cancelEdit()) this.travel(this.past, this.future, "undo");
  }

  redo(): void {
    if (!this.dragFrom) this.travel(this.future, this.past, "redo");
  }

  get history(): History {
    return { past: this.past, scene: this.dragFrom ?? this.state.scene, future: this.future };
  }

  restore({ past, scene, future }: History): void {
    this.past = [...past];
    this.future = [...future];
    // Which of them were opened is not kept.
    for (const one of [...past, scene, ...future]) this.whole.add(one);
    this.apply(scene, "open", true);
  }

  private tellInFrame(): void {
    inNextFrame(this.tell, true);
    this.late ??= setTimeout(this.tell, WITHOUT_FRAME_MS);
  }

  /** The state with all that follows from it. */
  private derived(): State {
    while (this.known !== this.state) {
      const { known, state } = this;
      this.known = state;
      for (const deriver of [...this.derivers]) deriver(state, known);
    }
    return this.state;
  }

  /** False where nothing changes. */
  private change(patch: Partial<State>): boolean {
    const { state } = this,
      keys = Object.keys(patch) as (keyof State)[];
    if (keys.every((key) => Object.is(patch[key], state[key]))) return false;
    this.state = { ...state, ...patch };
    return true;
  }

  private travel(from: Scene[], to: Scene[], reason: string): void {
    const scene = from.pop();
    if (!scene) return;
    const left = this.state.scene;
    to.push(left);
    this.apply(scene, reason, this.whole.has(to === this.future ? left : scene));
  }

  private apply(scene: Scene, reason: string, opens = false): void {
    const { selection, opened, playback } = this.state;
    this.set({
      ...(opens ? { opened: opened + 1, playback: { ...playback, fraction: 1, playing: false } } : {}),
      scene,
      reason,
      transient: false,
      selection: stillThere(scene, selection),
      canUndo: this.past.length > 0,
      canRedo: this.future.length > 0,
    });
  }
}

/** The part of a selection that exists in another scene. */
function stillThere(scene: Scene, selection: Selection): Selection {
  if (selection === null || !("id" in selection || "ids" in selection)) return selection;
  const known = new Set(thingsOf(scene).map((one) => one.id));
  if ("id" in selection) return known.has(selection.id) ? selection : null;
  const ids = selection.ids.filter((id) => known.has(id));
  return ids.length === selection.ids.length ? selection : ids.length > 1 ? { kind: "group", ids } : null;
}

function heard(listeners: Set<Listener>, listener: Listener): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}
