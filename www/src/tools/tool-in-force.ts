/** Which tool a press goes to: the chosen one, but for a held space bar, an armed pose, pens and other buttons. */
import type { Store, ToolId } from "../store";
import { piece } from "../view/piece";
import { HandTool } from "./pan";
import { SelectTool } from "./select";
import type { Tool } from "./tool";
import type { Drawing } from "./tool-registry";

const registry = piece(() => import("./tool-registry"));

export class ToolInForce {
  readonly select = new SelectTool();
  /** All other tools; null until they are fetched. */
  drawing: Drawing | null = null;
  /** Set by S or T: the next press places that pose. */
  armed: "start" | "goal" | null = null;
  private spaceDown = false;
  private readonly hand = new HandTool();

  constructor(
    private readonly store: Store,
    private readonly changed: () => void,
  ) {}

  /** The first picture does without the tools that draw. */
  async fetch(): Promise<void> {
    if (this.drawing) return;
    const { makeDrawing, watchGoalSlot } = await registry.load();
    if (this.drawing) return;
    this.drawing = makeDrawing(this.select);
    watchGoalSlot(this.store);
    this.changed();
  }

  now(): Tool {
    if (this.spaceDown) return this.hand;
    if (this.armed && this.drawing) return this.drawing.place[this.armed];
    return this.called(this.store.state.tool);
  }

  forPress(event: PointerEvent): Tool {
    if (event.button === 1 || this.spaceDown) return this.hand;
    const { tool, penSeen, toolOptions } = this.store.state;
    if (event.pointerType === "touch" && penSeen && toolOptions.penDraws) return this.hand;
    if (event.button === 2)
      return tool === "select" || tool === "hand" ? this.hand : (this.drawing?.eraser ?? this.hand);
    return this.now();
  }

  called(tool: ToolId): Tool {
    if (tool === "hand") return this.hand;
    if (!this.drawing && tool !== "select") void this.fetch();
    return this.drawing?.tools[tool] ?? (tool === "select" ? this.select : this.hand);
  }

  /** Until it is released; the release may reach only the window. */
  holdSpace(): true {
    if (this.spaceDown) return true;
    this.spaceDown = true;
    const released = new AbortController();
    globalThis.addEventListener("keyup", ({ key }) => this.releaseSpace(key) && released.abort(), {
      signal: released.signal,
    });
    this.changed();
    return true;
  }

  /** True if this key ended it. */
  releaseSpace(key: string): boolean {
    if (key !== " " || !this.spaceDown) return false;
    this.spaceDown = false;
    this.changed();
    return true;
  }

  /** A press of this tool has ended. */
  ended(tool: Tool): void {
    if (this.drawing && (tool === this.drawing.place.start || tool === this.drawing.place.goal)) this.armed = null;
  }
}
