/** The interface of a tool: a small state machine fed with pointer input in world coordinates. */
import type { Point } from "../scene/geometry";
import type { Scene, Store } from "../store";
import type { View } from "../view/camera";
import type { Draft } from "../store/draft";

export interface Input {
  /** World metres. */
  at: Point;
  /** CSS pixels on the canvas. */
  pixel: Point;
  /** Positions of the pointer since the last event, `at` included. */
  trail: readonly Point[];
  shift: boolean;
  alt: boolean;
  ctrl: boolean;
  touch: boolean;
  /** By arrow keys and Enter. */
  keyed?: boolean;
}

/** A tool's way to the page. */
export interface ToolContext {
  readonly store: Store;
  readonly view: View;
  /** The thing under the pointer. */
  readonly canvas: HTMLElement | null;
  show(draft: Draft | null): void;
  /** One step of a drag. */
  preview(scene: Scene): void;
  /** Ends a drag, or edits at once: one undo step. */
  commit(scene: Scene, label: string): void;
  /** Gives up a drag; the scene is as before it. */
  revert(): void;
  /** A shape is done: back to select unless the tool is locked. */
  done(): void;
}

export interface Tool {
  /** Draws from the press to the release, rather than press by press. */
  readonly drags?: boolean;
  cursor(context: ToolContext, input: Input | null): string;
  /** The pointer moves without a press; null when it leaves. */
  hover?(context: ToolContext, input: Input | null): void;
  down?(context: ToolContext, input: Input): void;
  move?(context: ToolContext, input: Input): void;
  up?(context: ToolContext, input: Input): void;
  doubleClick?(context: ToolContext, input: Input): void;
  /** Enter. */
  confirm?(context: ToolContext): boolean;
  /** Escape, or the gesture became another: true where there was something to give up. */
  cancel?(context: ToolContext): boolean;
  /** Turns of a wheel, positive away from the user: true where the tool takes it. */
  wheel?(context: ToolContext, input: Input, notches: number): boolean;
}

/** Reach of a pointer: half of the hit area's 24 px, or 44 px for fingers. */
export const reachOf = (input: Input): number => (input.touch ? 22 : 12);
export const metresOf = (context: ToolContext, px: number): number => px / context.view.camera.scale;
