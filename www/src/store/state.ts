/** The parts of the state, and how they begin. */
import type { Selection } from "../scene/selection";
import type { BayCheck } from "./bay-check";
import type { Draft } from "./draft";
import type { Choice, Guest, PanelResult } from "./results";
import type { Explanation, Narrowest, Plan, PlannerId, Prefer, Road, SceneGeometry } from "parkade";
import type { Scenario } from "../scene/scenario";
import { presetLayers, type LayerSet } from "./layer-sets";

export type { LayerKey } from "./layer-sets";
export type { PanelResult } from "./results";

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

/** What is drawn, saved, shared and undone. */
export interface DocumentState {
  scene: Scene;
  canUndo: boolean;
  canRedo: boolean;
  /** A drag is going on. */
  transient: boolean;
  /** Counts scenes as they are opened, also by undo and redo: what belongs to one never stands beside another. */
  opened: number;
  /** The last change of the scene: "edit", "undo", "redo", or an edit's label. */
  reason: string;
}

/** What one visit looks at and holds in its hand. */
export interface SessionState {
  selection: Selection;
  tool: ToolId;
  toolOptions: ToolOptions;
  penSeen: boolean;
  planners: PlannerId[];
  hidden: ReadonlySet<PlannerId>;
  mode: "grid" | "overlay" | "focus";
  focus: PlannerId;
  /** null: follow the car, or fit the scene. */
  camera: Camera | null;
  /** The camera stays on the focused planner's car. */
  follow: boolean;
  hover: { x: number; y: number } | null;
  /** The preview of the tool in force. */
  draft: Draft | null;
  /** Preferences by which planners' paths are chosen; absent for the default. */
  prefer: Partial<Record<PlannerId, Prefer>>;
  /** Another path of a planner, looked at for a moment, or a place of the one that is shown. */
  preview: { planner: PlannerId; plan: Plan; place?: Narrowest } | null;
  /** How moving obstacles are waited for. */
  waiting: "predictive" | "reactive";
  /** Somebody else's trajectory, driven beside ours. */
  guest: Guest | null;
  playback: Playback;
  layers: LayerSet;
  message: {
    tone: "err" | "warn" | "info";
    text: string;
    code?: string;
    action?: { name: string; run(): void };
  } | null;
}

/** What is remembered between visits. */
export interface PreferenceState {
  theme: "auto" | "light" | "dark";
  lang: "en" | "zh";
  /** True if trajectories take the place of paths; null until the last visit's choice is known. */
  smooth: boolean | null;
}

/** What follows from the others, and is computed anew. */
export interface DerivedState {
  geometry: SceneGeometry | null;
  /** Every planner and format is loaded, not only those of the first picture. */
  complete: boolean;
  /** Explanation of the risk field at the cell under the pointer. */
  explained: Explanation | null;
  /** The check of all bays, while it is open. */
  bays?: BayCheck | null;
  /** While a recorded search is walked through: its planner, and what draws it into a frame. */
  searchSteps?: { planner: PlannerId; draw(frame: unknown): void } | null;
  /** Paths of planners to choose from, for the present scene. */
  choices?: Partial<Record<PlannerId, readonly Choice[]>>;
  /** The planner whose paths might be bettered, and for which better ones are being looked for. */
  improving?: PlannerId | undefined;
  results: Record<string, PanelResult>;
  /** Expansions so far, of planners at work on the present scene that have told them. */
  progress: Record<string, number>;
  live: ReadonlyMap<string, string> | null;
}

/** Never mutated: every change makes new objects, so views compare by identity. */
export interface State extends DocumentState, SessionState, PreferenceState, DerivedState {}

/** True while bays are asked: what can wait leaves the processors to them. */
export const isCheckingBays = ({ bays }: Pick<State, "bays">): boolean => !!bays && bays.done < bays.of;

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
  return { ...emptyDocument(), ...newSession(), theme: "auto", lang: "en", smooth: null, ...nothingDerived() };
}

const emptyDocument = (): DocumentState => ({
  scene: emptyScene,
  canUndo: false,
  canRedo: false,
  transient: false,
  opened: 0,
  reason: "open",
});

function newSession(): SessionState {
  return {
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
    mode: "grid",
    focus: "hybrid",
    camera: null,
    follow: false,
    hover: null,
    draft: null,
    prefer: {},
    preview: null,
    waiting: "predictive",
    guest: null,
    playback: { base: "drive", searchMode: "percent", fraction: 1, playing: false, speed: 1 },
    layers: presetLayers("drive"),
    message: null,
  };
}

const nothingDerived = (): DerivedState => ({
  geometry: null,
  complete: false,
  explained: null,
  results: {},
  progress: {},
  live: null,
});
