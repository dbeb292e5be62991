import { thingsOf, type Selection } from "../scene/selection";
import type { Choice, Timing } from "./results";
import type {
  Drive,
  Encounter,
  Explanation,
  Layer,
  LayerName,
  Narrowest,
  Plan,
  PlannerId,
  Prefer,
  Road,
  SceneGeometry,
} from "parkade";
import type { Scenario } from "../scene/scenario";
import { presetLayers } from "./layer-sets";

export type Scene = Scenario;
export type ToolId =
  | "select"
  | "brush"
  | "wall"
  | "rectangle"
  | "polygon"
  | "car"
  | "slot"
  | "moving"
  | "road"
  | "cost"
  | "eraser"
  | "hand";

/** World centre in metres, CSS pixels per metre; shared by all panels. */
export interface Camera {
  x: number;
  y: number;
  scale: number;
}

export type LayerKey =
  | "slots"
  | "obstacles"
  | "safety"
  | "redundant"
  | "cost"
  | "heat"
  | "risk"
  | "tree"
  | "sweep"
  | "path"
  | "car"
  | "ghosts"
  | "difference"
  | "grid";

export interface PanelResult {
  plan: Plan | null;
  lastGood: Plan | null;
  /** `plan`, where that is another than the planner's first answer. */
  chosen?: Plan | null;
  /** The planner's first answer, where `chosen` stands in its place. */
  ordinary?: Plan | null;
  /** `plan` in time, among moving obstacles where there are some; null where no car drives it, and during drags. */
  drive: Drive | Encounter | null;
  layers: Partial<Record<LayerName, Layer>>;
  status: "idle" | "planning" | "done" | "error";
  error: { code: string; path: string; message: string } | null;
  /** Medians of `samples`; null until the planner has warmed up on the scene. */
  time: Timing | null;
  samples: Timing[];
}

export interface Playback {
  base: "search" | "drive";
  searchMode: "percent" | "expansions";
  fraction: number;
  playing: boolean;
  speed: number;
}

export interface ToolOptions {
  brushRadius: number;
  /** Weight that the cost brush paints, 1 to 10. */
  costWeight: number;
  wallThickness: number;
  carProfile: "paper" | "sedan" | "cone";
  slot: {
    kind: "perpendicular" | "parallel" | "angled";
    angle: number;
    lean: "left" | "right";
    /** Metres; null follows the car. */
    width: number | null;
    length: number | null;
    /** Drawn beside the row, not part of it. */
    aisle: number;
  };
  road: Required<Pick<Road, "lanes" | "laneWidth" | "radius" | "kerbs">>;
  locked: boolean;
  snap: boolean;
  /** True once a pen is used: fingers then move the view. */
  penDraws: boolean;
}

export const FIRST_PLANNERS: PlannerId[] = ["four", "eight", "risk-field", "hybrid"];

/** Never mutated: every change makes new objects, so views compare by identity. */
export interface State {
  scene: Scene;
  geometry: SceneGeometry | null;
  selection: Selection;
  tool: ToolId;
  toolOptions: ToolOptions;
  penSeen: boolean;
  planners: PlannerId[];
  hidden: ReadonlySet<PlannerId>;
  /** Every planner and format is loaded, not only those of the first picture. */
  complete: boolean;
  mode: "grid" | "overlay" | "focus";
  focus: PlannerId;
  /** null: follow the car, or fit the scene. */
  camera: Camera | null;
  /** The camera stays on the focused planner's car. */
  follow: boolean;
  hover: { x: number; y: number } | null;
  /** Explanation of the risk field at the cell under the pointer. */
  explained: Explanation | null;
  /** Preferences by which planners' paths are chosen; absent for the default. */
  prefer: Partial<Record<PlannerId, Prefer>>;
  /** Paths of planners to choose from, for the present scene. */
  choices?: Partial<Record<PlannerId, readonly Choice[]>>;
  /** The planner whose paths might be bettered, and for which better ones are being looked for. */
  improving?: PlannerId | undefined;
  /** Another path of a planner, looked at for a moment, or a place of the one that is shown. */
  preview: { planner: PlannerId; plan: Plan; place?: Narrowest } | null;
  /** How moving obstacles are waited for. */
  waiting: "predictive" | "reactive";
  playback: Playback;
  layers: Record<LayerKey, boolean>;
  results: Record<string, PanelResult>;
  /** Expansions so far, of planners at work on the present scene that have told them. */
  progress: Record<string, number>;
  theme: "auto" | "light" | "dark";
  lang: "en" | "zh";
  canUndo: boolean;
  canRedo: boolean;
  /** A drag is going on. */
  transient: boolean;
  /** Counts scenes as they are opened, also by undo and redo: what belongs to one never stands beside another. */
  opened: number;
  /** The last change of the scene: "edit", "undo", "redo", or an edit's label. */
  reason: string;
  message: {
    tone: "err" | "warn" | "info";
    text: string;
    code?: string;
    action?: { name: string; run(): void };
  } | null;
  live: ReadonlyMap<string, string> | null;
}

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
export type Listener = (state: State, previous: State) => void;

export interface Store {
  readonly state: State;
  set(patch: Partial<State>): void;
  subscribe(listener: Listener): () => void;
  /** Applies an edit and pushes one undo step; the edits of one drag (`transient`, then one final) are one step. */
  edit(next: Scene, options?: EditOptions): void;
  undo(): void;
  redo(): void;
  readonly history: History;
  /** Takes over a history from before a reload. */
  restore(history: History): void;
}

export const UNDO_STEPS = 500;

export const emptyResult: PanelResult = {
  plan: null,
  lastGood: null,
  drive: null,
  layers: {},
  status: "idle",
  error: null,
  time: null,
  samples: [],
};

const emptyScene: Scene = {
  version: 1,
  map: { origin: [0, 0], width: 40, height: 30, resolution: 0.5 },
  obstacles: [],
  slots: [],
  vehicle: "paper",
  start: { x: 4, y: 15, heading: 0 },
  goal: { x: 16, y: 7.5, heading: 0 },
};

export function initialState(): State {
  return {
    scene: emptyScene,
    geometry: null,
    selection: null,
    tool: "select",
    toolOptions: {
      brushRadius: 0.5,
      costWeight: 5,
      wallThickness: 0.2,
      carProfile: "sedan",
      road: { lanes: [1, 1], laneWidth: 3.5, radius: 20, kerbs: true },
      slot: { kind: "perpendicular", angle: Math.PI / 4, lean: "right", width: null, length: null, aisle: 6 },
      locked: false,
      snap: true,
      penDraws: true,
    },
    penSeen: false,
    planners: FIRST_PLANNERS,
    hidden: new Set(),
    complete: false,
    mode: "grid",
    focus: "hybrid",
    camera: null,
    follow: false,
    hover: null,
    explained: null,
    prefer: {},
    preview: null,
    waiting: "predictive",
    playback: { base: "drive", searchMode: "percent", fraction: 1, playing: false, speed: 1 },
    layers: presetLayers("drive"),
    results: {},
    progress: {},
    theme: "auto",
    lang: "en",
    canUndo: false,
    canRedo: false,
    transient: false,
    opened: 0,
    reason: "open",
    message: null,
    live: null,
  };
}

export function createStore(initial: Partial<State> = {}): Store {
  return new SceneStore({ ...initialState(), ...initial });
}

class SceneStore implements Store {
  state: State;
  private readonly listeners = new Set<Listener>();
  private past: Scene[] = [];
  private future: Scene[] = [];
  /** Scenes that came whole, by `edit` with the label "open". */
  private readonly whole = new WeakSet<Scene>();
  /** The scene before the drag that is going on. */
  private dragFrom: Scene | null = null;

  constructor(state: State) {
    this.state = state;
  }

  set(patch: Partial<State>): void {
    const previous = this.state;
    const keys = Object.keys(patch) as (keyof State)[];
    if (keys.every((key) => Object.is(patch[key], previous[key]))) return;
    this.state = { ...previous, ...patch };
    for (const listener of [...this.listeners]) listener(this.state, previous);
  }

  subscribe(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
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

  undo(): void {
    if (this.dragFrom) {
      const from = this.dragFrom;
      this.dragFrom = null;
      this.apply(from, "undo");
      return;
    }
    this.travel(this.past, this.future, "undo");
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
