/**
 * Types of `<parkade-playground>`, whose script is the built page's `parkade-playground.js`. There is nothing to run
 * here: `import type`.
 */
import type { Camera, Plan, PlannerId, Scenario } from "./index.js";

export type PlaygroundLayer = "clean" | "search" | "risk" | "drive";

/** Attributes as a page writes them; for JSX and templates. */
export interface PlaygroundAttributes {
  src?: string;
  scene?: string;
  /** Ids, spaced. */
  planners?: string;
  layout?: "grid" | "overlay" | "focus" | "single";
  controls?: "full" | "minimal" | "none";
  editable?: "" | "true" | "false" | boolean;
  autoplay?: "" | boolean;
  speed?: number | string;
  /** A preset, or layers, spaced. */
  layers?: PlaygroundLayer | (string & {});
  smooth?: "true" | "false" | "" | boolean;
  theme?: "auto" | "light" | "dark";
  lang?: string;
  "budget-ms"?: number | string;
  wheel?: "ctrl" | "always" | "none";
  "worker-url"?: string;
  "wasm-url"?: string;
  poster?: string;
  alt?: string;
  loading?: "auto" | "lazy" | "eager";
  reveal?: "auto" | "interaction" | "manual";
}

type Results = Record<string, Plan | null>;

/** Details of the element's events. */
export interface PlaygroundEvents {
  ready: unknown;
  "scene-change": { scene: Scenario; reason: string; transient: boolean };
  "plan-start": { id: number };
  "plan-progress": { planner: PlannerId; expansions: number };
  "plan-result": { planner: PlannerId; plan: Plan | null };
  "plan-complete": { results: Results; id: number };
  seek: { playhead: number; base: "search" | "drive" };
  select: unknown;
  error: { code: string; message: string; field?: string; value?: unknown; rule?: string };
  progress: { totalProgress: number };
  visibility: unknown;
}

export interface ParkadePlayground extends HTMLElement {
  sceneData: Scenario | undefined;
  params: Scenario["planners"];
  playhead: number;
  camera: Camera | null;
  readonly results: Results;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  readonly loaded: boolean;
  /** Resolves when the first scene is planned, and rejects where it cannot be opened. */
  readonly ready: Promise<void>;
  plan(): Promise<void>;
  cancel(): Promise<void>;
  play(): Promise<void>;
  pause(): Promise<void>;
  /** 0 to 1. */
  seek(fraction: number, options?: { base?: "search" | "drive" }): Promise<void>;
  undo(): Promise<void>;
  redo(): Promise<void>;
  reset(): Promise<void>;
  fit(): Promise<void>;
  getScene(): Promise<Scenario>;
  setScene(scene: Scenario): Promise<void>;
  openLink(link: string): Promise<void>;
  toBlob(options?: { type?: string }): Promise<Blob | null>;
  toSVG(): Promise<string>;
  toCSV(): Promise<string>;
  shareURL(): Promise<string | null>;
  settled(): Promise<void>;
  dismissPoster(): Promise<void>;
  addEventListener<Name extends keyof PlaygroundEvents>(
    name: Name,
    listener: (this: ParkadePlayground, event: CustomEvent<PlaygroundEvents[Name]>) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    name: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "parkade-playground": ParkadePlayground;
  }
}
