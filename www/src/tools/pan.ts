/** Pans the camera. */
import type { Point } from "../scene/geometry";
import { panBy } from "../view/camera";
import type { ToolContext, Input, Tool } from "./tool";

export class HandTool implements Tool {
  private last: Point | null = null;

  cursor(): string {
    return this.last ? "grabbing" : "grab";
  }

  down(_bench: ToolContext, input: Input): void {
    this.last = input.pixel;
  }

  move(context: ToolContext, input: Input): void {
    if (!this.last) return;
    const [x, y] = this.last;
    this.last = input.pixel;
    context.store.set({ camera: panBy(context.view.camera, input.pixel[0] - x, input.pixel[1] - y) });
  }

  up(): void {
    this.last = null;
  }

  cancel(): boolean {
    const panning = this.last !== null;
    this.last = null;
    return panning;
  }
}
